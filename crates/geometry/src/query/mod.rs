//! The trees and their queries.

mod best_first;
mod cone_kernel;
mod cone_node;
mod ray_kernel;
mod ray_tree;
mod silhouette_tree;

pub use ray_tree::RayTree;
pub use silhouette_tree::{ConeQuery, EdgeSelection, Plane, SilhouettePoint, SilhouetteTree};
