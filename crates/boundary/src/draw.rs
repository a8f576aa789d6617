//! One sample: its random numbers, and what it cost.

use std::cell::Cell;

use crate::random::Stream;

/// One sample: its random numbers, and what it cost.
#[derive(Clone, Copy)]
pub struct Draw<'a> {
    /// The numbers.
    pub stream: &'a Stream,
    /// What it costs, and what it could not do.
    pub counts: &'a Counts,
}

/// Counts of one sample.
#[derive(Debug, Default)]
pub struct Counts {
    /// Closest-silhouette queries.
    pub queries: Cell<u64>,
    /// Specular events behind which silhouettes can move: these bound no field.
    pub uncovered: Cell<u64>,
}

impl Draw<'_> {
    /// Counts queries for silhouettes.
    pub fn count_queries(&self, count: u64) {
        self.counts.queries.set(self.counts.queries.get() + count);
    }
}

/// The random numbers of one walk.
#[derive(Clone, Copy)]
pub struct Numbers<'a> {
    /// Of this sample.
    pub draw: Draw<'a>,
    /// The first of the walk's dimensions.
    pub dimension: u32,
}

impl Numbers<'_> {
    /// Any number of them, for what does not walk.
    #[cfg(feature = "paper")]
    pub(crate) fn branch(&self) -> Stream {
        self.draw.stream.branch(self.dimension)
    }

    /// The number of the walk's dimension `i`, uniform in [0, 1).
    pub fn number(&self, i: u32) -> f64 {
        self.draw.stream.number(self.dimension + i)
    }
}
