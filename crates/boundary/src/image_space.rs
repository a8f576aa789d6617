//! The field around a camera whose rays are parallel and have no common origin.
//!
//! It is the field around the origin of image space, in which the camera-space
//! point `(X, Y, Z)` lies at `(X, Y, 1)`: there, all rays start. Straight edges stay
//! straight and their points divide them as before, so that the tree of silhouettes
//! serves as it is. What the map loses is depth, which is looked up where an edge was
//! found. A point that moves with `ẋ` moves with the first two components of
//!
//! ```text
//! A⁻¹ (ẋ - ȯ - X ȧ - Y ḃ - Z ċ)
//! ```
//!
//! in image space: `A` has the camera's axes `a`, `b`, `c` as columns, and `o` is
//! where it stands.

use capwalk_geometry::{Edge, Mesh, SilhouetteTree};
use capwalk_math::Vec3;
use capwalk_scene::sensor::view::View;

/// The edges in image space, if the rays of a view are parallel.
pub fn image_tree(
    view: &View<f64>,
    positions: &[Vec3],
    faces: &[[u32; 3]],
    edges: &[Edge],
) -> Option<SilhouetteTree> {
    view.is_parallel().then(|| {
        let positions = positions.iter().map(|&p| view.towards(p)).collect();
        let faces = faces.to_vec();
        SilhouetteTree::build(&Mesh { positions, faces }, edges)
    })
}
