//! Samples that wait until there are lanes for them.

use std::ops::Range;

use crate::tiles::SampleRun;

/// Samples that are not taken yet.
pub struct RestOfRuns<'a> {
    runs: &'a [SampleRun],
    /// How many of the first run have been taken.
    taken: u32,
}

impl<'a> RestOfRuns<'a> {
    /// All of them.
    pub fn new(runs: &'a [SampleRun]) -> Self {
        Self { runs, taken: 0 }
    }

    /// True if there are none.
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// Takes the next ones of a run, at most so many.
    pub fn next(&mut self, most: usize) -> Option<(&'a SampleRun, Range<u32>)> {
        let (run, others) = self.runs.split_first()?;
        let Range { start, end } = run.numbers;
        let first = start + self.taken;
        let numbers = first..end.min(first.saturating_add(most as u32));
        self.taken += numbers.len() as u32;
        if numbers.end == end {
            (self.runs, self.taken) = (others, 0);
        }
        Some((run, numbers))
    }
}
