//! Triangle meshes, their silhouettes, and the queries on them.
//!
//! Two trees answer everything: [`RayTree`] over triangles (first hit,
//! occluded, what crosses a wedge of light) and [`SilhouetteTree`] over edges (the boundary point seen under
//! the smallest angle to an axis, Algorithm 5, and all boundary edges in a cone).
//! They own what they need, can be shared between threads, and follow moving
//! vertices by `refit`. Every accelerated query has a brute-force twin in
//! [`oracle`].
//!
//! Nothing here knows about light or walks.

mod aabb;
mod bvh;
mod cone;
pub mod edge;
mod effort;
mod halt;
mod local_frame;
pub mod mesh;
pub mod oracle;
mod query;
pub mod ray;
pub mod sampler_buffers;
mod shown;
pub mod simd;
#[cfg(test)]
mod tests;
pub mod topology;
mod wedge;

pub use cone::NormalCone;
pub use edge::{Edge, Sides, is_edge_on};
pub use effort::{add_effort, effort, uncounted};
pub use halt::{Halt, Halted};
pub use local_frame::LocalFrame;
pub use mesh::{Mesh, MeshError};
pub use query::buffers;
pub use query::{
    ConeQuery, EdgeSelection, EdgeSubset, HalfSpace, Packet, PacketTree, RAYS, RayTree,
    SilhouettePoint, SilhouetteTree,
};
pub use ray::{Hit, Ray};
pub use shown::shown;
pub use wedge::{Apex, Wedge, WedgePoint};
