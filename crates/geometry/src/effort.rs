//! How much work the queries of a thread have been, roughly: what estimators are compared
//! by in the place of seconds. It follows from what is asked and found alone, not from how a
//! tree came about or which instructions search it, so that a comparison comes out the same
//! in every run.

use std::cell::Cell;

/// The effort of a ray, for each level of a tree.
pub(crate) const RAY: u64 = 2;
/// The effort of a closest silhouette, or of a gather that finds none.
pub(crate) const CLOSEST: u64 = 5;
/// The effort of each edge that is gathered.
pub(crate) const FOUND: u64 = 8;

thread_local! {
    static EFFORT: Cell<u64> = const { Cell::new(0) };
}

/// The effort of all queries of this thread since it started, in about twenty nanoseconds.
pub fn effort() -> u64 {
    EFFORT.get()
}

/// Adds to the effort of this thread, for work between queries that grows with the scene.
#[inline]
pub fn add_effort(more: u64) {
    EFFORT.set(EFFORT.get().wrapping_add(more));
}

/// The result of work that is done once for many samples: it does not count as effort of the
/// sample that happens to be the first to need it.
pub fn uncounted<T>(work: impl FnOnce() -> T) -> T {
    let before = effort();
    let result = work();
    EFFORT.set(before);
    result
}

/// Adds that of a query among so many faces or edges.
#[inline]
pub(crate) fn add_effort_of(level: u64, count: usize) {
    add_effort(level * u64::from(count.max(1).ilog2() + 2));
}
