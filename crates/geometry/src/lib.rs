//! Triangle meshes, their silhouettes, and the queries on them.
//!
//! Two trees answer everything: [`RayTree`] over triangles (first hit,
//! occluded) and [`SilhouetteTree`] over edges (the boundary point seen under
//! the smallest angle to an axis, Algorithm 5). Every accelerated query has a
//! brute-force twin in [`oracle`].
//!
//! Nothing here knows about light or walks.

mod aabb;
mod bvh;
mod cone;
pub mod edge;
pub mod mesh;
pub mod oracle;
pub mod query;
pub mod ray;
mod simd;
pub mod topology;

pub use bvh::validate::TreeError;
pub use edge::{Edge, Sides};
pub use mesh::{Mesh, MeshError};
pub use query::{ConeQuery, EdgeSelection, Plane, RayTree, SilhouettePoint, SilhouetteTree};
pub use ray::{Hit, Ray};
