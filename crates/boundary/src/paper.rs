//! Fields to compare with: the paper's on triangles and among explicit boundaries, and
//! the biased weighted means of earlier work.

mod explicit;
mod psdr_was;
mod receiver;
pub mod settings;
mod triangle;
mod was;
mod weighted_mean;

pub use explicit::MOST_EDGES;
pub(crate) use was::flow as was_flow;
