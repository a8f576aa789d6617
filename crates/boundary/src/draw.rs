//! The random numbers of one sample, and its counters.

use std::cell::Cell;

use crate::random::Stream;

/// The random numbers of one sample, and its counters.
#[derive(Clone, Copy)]
pub struct Draw<'a> {
    /// The random numbers.
    pub stream: &'a Stream,
    /// The counters.
    pub counts: &'a Counts,
}

/// What is counted in one sample.
#[derive(Debug, Default)]
pub struct Counts {
    /// Closest-silhouette queries.
    pub queries: Cell<u64>,
}

impl Draw<'_> {
    /// Adds to the closest-silhouette queries.
    pub fn count_queries(&self, count: u64) {
        self.counts.queries.set(self.counts.queries.get() + count);
    }
}

/// The random numbers of one walk.
#[derive(Clone, Copy)]
pub struct Numbers<'a> {
    /// The sample.
    pub draw: Draw<'a>,
    /// The first of the walk's dimensions.
    pub dimension: u32,
}

impl Numbers<'_> {
    /// A stream of its own, for estimators that need any number of them.
    pub fn branch(&self) -> Stream {
        self.draw.stream.branch(self.dimension)
    }

    /// The number of the walk's dimension `i`, uniform in [0, 1).
    pub fn number(&self, i: u32) -> f64 {
        self.draw.stream.number(self.dimension + i)
    }
}
