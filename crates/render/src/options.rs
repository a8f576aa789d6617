//! What a caller can choose, and how it can follow and stop the work.

/// How much to sample, and with which random numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Samples per pixel, at least 1 (at least 2 for a standard error).
    pub spp: u32,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// Follows the work and may stop it. Called from worker threads.
pub trait Watch: Sync {
    /// `done` of `total` units of work are finished.
    fn progress(&self, done: u64, total: u64);
    /// True if the work should stop soon; what is done is returned, with its
    /// real sample counts.
    fn should_stop(&self) -> bool;
}

/// Nobody watches.
pub struct Unwatched;

impl Watch for Unwatched {
    fn progress(&self, _done: u64, _total: u64) {}
    fn should_stop(&self) -> bool {
        false
    }
}
