//! Velocity fields to compare with the renderer's: the paper's on triangles and among explicit
//! boundaries, and the biased weighted means of earlier work. Each is a method of the renderer
//! ([`CustomField`](capwalk_boundary::CustomField)), in forward and in reverse mode.

mod explicit;
mod on_triangles;
mod psdr_was;
mod receiver;
mod warped_area;
mod was;
mod was_settings;
mod weighted_mean;

pub use explicit::AMONG_EXPLICIT_BOUNDARIES;
pub use on_triangles::ON_TRIANGLES;
pub use warped_area::{psdr_was, was};
pub use was_settings::{WasBoundary, WasSettings};
