//! How many samples are on the device at a time.

use std::cell::Cell;
use std::time::Duration;

/// Samples of the first part, when it is not known yet how long they take.
const FIRST: usize = 1 << 14;

/// Kernels should take about this long for a part: progress is seen after each, and what of one is
/// done when the work is stopped is lost.
const PART: Duration = Duration::from_millis(500);

/// If so many paths do not fit, the work fails.
const FEWEST: usize = 64;

/// How many samples a part has, which follows the time that parts take and the memory that there is.
#[derive(Debug)]
pub struct PartSize {
    most: Cell<usize>,
    size: Cell<usize>,
}

impl PartSize {
    /// So many at most.
    pub fn new(most: usize) -> Self {
        let most = most.max(1);
        Self {
            most: Cell::new(most),
            size: Cell::new(most.min(FIRST)),
        }
    }

    /// How many the next one has.
    pub fn get(&self) -> usize {
        self.size.get()
    }

    /// From now on, no part has more than half; false if that is too few.
    pub fn halve(&self) -> bool {
        let can = self.size.get() > FEWEST;
        if can {
            self.most.set(self.size.get() / 2);
            self.size.set(self.most.get());
        }
        can
    }

    /// Kernels took so long for a part of so many samples.
    pub fn follow(&self, took: Duration, samples: usize) {
        let (size, most) = (self.size.get(), self.most.get());
        if took > PART {
            self.size.set((size / 2).max(FEWEST.min(most)));
        } else if 3 * took < PART && samples == size {
            self.size.set((2 * size).min(most));
        }
    }
}
