//! Derivatives of the picture.

pub mod boundary;
pub mod finite;
mod flux;
pub mod forward;
pub mod probe;
