//! The tree that both queries share: eight children per node, and which
//! primitives lie in which leaf. Bounds are the business of its users.
//!
//! A tree is built once from the boxes of its primitives ([`build()`]). When
//! vertices move, only the bounds are computed again ([`child_bounds`]), so a
//! refitted tree answers as exactly as a new one and is merely slower; how much,
//! [`SurfaceCost`] tells.

mod binary;
mod buckets;
mod build;
mod cost;
mod hierarchy;
mod refit;
mod stack;
#[cfg(test)]
pub mod validate;
mod widen;

pub use buckets::Buckets;
pub use build::{Leaves, Splits, build};
pub use cost::SurfaceCost;
pub use hierarchy::{Child, ChildKind, Hierarchy, MAX_DEPTH, WIDTH};
pub use refit::{any_below, child_bounds, child_leaves};
pub use stack::{Stack, VisitOfRays, for_each_sorted};
