//! How much work the queries of a thread have been: what estimators are compared by in the
//! place of seconds, so that a comparison comes out the same in every run and on every
//! machine.

use std::cell::Cell;

/// A node or leaf of edges, whose cones of normals are tested, too.
pub(crate) const NODE: u64 = 3;
/// The exact test of an edge.
pub(crate) const EDGE: u64 = 4;

thread_local! {
    static EFFORT: Cell<u64> = const { Cell::new(0) };
}

/// The effort of all queries of this thread since it started, in nodes and leaves of a ray
/// tree: about ten nanoseconds each.
pub fn effort() -> u64 {
    EFFORT.get()
}

/// Adds to the effort of this thread, for work between queries that grows with the scene.
#[inline]
pub fn add_effort(nodes: u64) {
    EFFORT.set(EFFORT.get().wrapping_add(nodes));
}
