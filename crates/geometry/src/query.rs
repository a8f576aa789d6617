//! The trees and their queries.

mod across;
mod beam;
mod best_first;
pub mod buffers;
mod bundle;
mod bundle_search;
mod closest;
mod cone_kernel;
mod cone_node;
mod cone_query;
mod edge_block;
mod edge_kernel;
mod edge_subset;
mod fine_tree;
mod gather;
mod lanes;
mod local_bundle;
mod local_cone;
mod local_packet;
mod oriented_box;
mod packet_face;
mod packet_precision;
pub mod packet_tree;
mod passage;
mod pieces;
mod pseudo_angle;
mod ray_kernel;
mod ray_search;
mod ray_tree;
mod shadow;
mod silhouette_tree;
mod sphere;
mod sphere_bundle;
mod sphere_grid;
mod tree_edge;
mod triangle_tree;
#[cfg(test)]
mod validate;

pub use bundle::{BUNDLE, Bundle};
pub use cone_query::{ConeQuery, EdgeSelection, HalfSpace, SilhouettePoint};
pub use edge_subset::EdgeSubset;
pub use packet_tree::PacketTree;
pub use ray_tree::RayTree;
pub use shadow::{Shadow, Sight};
pub use silhouette_tree::SilhouetteTree;
pub use sphere::MeshSphere;
