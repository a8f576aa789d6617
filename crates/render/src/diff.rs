//! Derivatives of the picture.

pub(crate) mod adjoint;
pub(crate) mod boundary;
mod clip;
mod crossing;
pub(crate) mod edge_flux;
mod eye;
pub mod finite;
pub(crate) mod flow;
pub(crate) mod flux;
pub mod forward;
mod lamp_edge;
mod look;
mod motion;
pub(crate) mod outline;
mod parallel;
pub mod probe;
mod receiver;
mod recording;
pub mod refuse;
pub mod reverse;
mod slope;
mod triangle;
pub(crate) mod unfold;
mod was;
pub(crate) mod window;
