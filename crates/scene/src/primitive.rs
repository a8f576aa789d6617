//! The shapes that scene files name without a mesh, as triangles: Mitsuba's
//! `rectangle`, `cube`, `disk` and `sphere`.
//!
//! Everything that can be seen or cast a shadow is a mesh here, so that one
//! set of silhouette queries serves all. Curved silhouettes are tessellated until
//! they deviate by less than [`OUTLINE_ERROR`].

mod icosphere;
mod tessellated;
mod uv;

pub use icosphere::icosphere;
pub use tessellated::{OUTLINE_ERROR, cube, disk, rectangle, sphere};
pub use uv::{FaceUvs, cube_uvs, disk_uvs, rectangle_uvs, sphere_uvs};
