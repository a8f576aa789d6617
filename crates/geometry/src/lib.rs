//! Triangle meshes, their edges, and two trees that answer geometric queries: [`RayTree`] for first
//! hits and occlusion, [`SilhouetteTree`] for the silhouette closest to a direction (Algorithm 5)
//! and for all boundary edges in a cone.
//!
//! The trees own their data, can be shared between threads, and follow moving vertices by `refit`.
//! Every accelerated query has a brute-force twin in [`oracle`]. The crate does not depend on light
//! or walks.

mod aabb;
mod bvh;
mod cone;
pub mod edge;
mod effort;
mod halt;
mod icosphere;
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
pub use icosphere::icosphere;
pub use local_frame::LocalFrame;
pub use mesh::{Mesh, MeshError};
pub use query::buffers;
pub use query::{
    BUNDLE, Bundle, ConeQuery, EdgeSelection, EdgeSubset, HalfSpace, MeshSphere, PacketTree,
    RayTree, Shadow, Sight, SilhouettePoint, SilhouetteTree,
};
pub use ray::{Hit, Ray};
pub use shown::shown;
pub use wedge::{Apex, Wedge, WedgePoint};
