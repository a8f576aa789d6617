//! The shapes that scene files name without a mesh, as triangles: Mitsuba's
//! `rectangle`, `cube`, `disk`, `cylinder`, `sphere` and curves.
//!
//! Everything that can be seen or cast a shadow is a mesh here, so that one
//! set of silhouette queries serves all. Curved silhouettes are tessellated until
//! they deviate by less than [`SILHOUETTE_ERROR`].

mod rings;
mod tessellated;
mod tube;
mod uv;

pub use capwalk_geometry::icosphere;
pub use rings::{ControlPoint, CurveKind};
pub use tessellated::{
    CYLINDER_TRIANGLES, DISK_TRIANGLES, SILHOUETTE_ERROR, SPHERE_DIVISION, cube, cylinder, disk,
    divided_sphere, rectangle, sphere, sphere_error, sphere_triangles,
};
pub use tube::{TubeError, tubes};
pub use uv::{
    FaceUvs, cube_uvs, cylinder_uvs, disk_uvs, divided_sphere_uvs, rectangle_uvs, sphere_uvs,
};
