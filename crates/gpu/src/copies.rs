//! What the CPU has of the queries that are on the device.

use rayon::prelude::*;

use crate::layout::view::VIEW;

/// Words of a query for the bounds.
pub const VIEW_WORDS: usize = 4 * VIEW;

/// Queries that are prepared by one thread.
const CHUNK: usize = 256;

/// The CPU's copies of a part. They are kept from one to the next: new memory costs
/// as much as all that is written to it.
#[derive(Debug, Default)]
pub struct Copies {
    pub views: Vec<u32>,
    pub numbers: Vec<f64>,
    pub answers: Vec<u32>,
    pub values: Vec<f64>,
    /// Numbers, and then values, in single precision.
    pub single: Vec<f32>,
}

impl Copies {
    /// Words of the queries and `numbers` numbers of each, on all threads.
    pub fn prepare<Q: Sync>(
        &mut self,
        numbers: usize,
        queries: &[Q],
        prepare: &(impl Fn(&Q, &mut [u32], &mut [f64]) + Sync),
    ) {
        self.views.resize(VIEW_WORDS * queries.len(), 0);
        self.numbers.resize(numbers * queries.len(), 0.0);
        (
            queries,
            self.views.par_chunks_exact_mut(VIEW_WORDS),
            self.numbers.par_chunks_exact_mut(numbers),
        )
            .into_par_iter()
            .with_min_len(CHUNK)
            .for_each(|(query, views, numbers)| prepare(query, views, numbers));
    }
}
