//! Derivatives of the picture.

pub mod boundary;
mod clip;
mod crossing;
pub mod finite;
mod flux;
pub mod forward;
pub mod probe;
