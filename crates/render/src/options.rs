//! What a caller can choose, and how it can follow and stop the work.

use capwalk_walk::WalkSettings;

/// How much to sample, and with which random numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Samples per pixel, at least 1 (at least 2 for a standard error).
    pub spp: u32,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Worker threads; `None` takes all cores. Changes no bit of the result.
    pub threads: Option<usize>,
}

/// How to estimate a gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GradientOptions {
    /// How much to sample.
    pub options: Options,
    /// What makes up for the jumps of the integrand.
    pub method: Method,
    /// The walk that builds the velocity field, for methods that walk.
    pub walk: WalkSettings,
}

impl GradientOptions {
    /// The default method and walk.
    pub fn new(options: Options) -> Self {
        Self {
            options,
            method: Method::default(),
            walk: WalkSettings::default(),
        }
    }
}

/// How the derivative of an integrand that jumps is estimated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Method {
    /// A velocity field by walks on spherical caps, around every point that
    /// light arrives at. Unbiased.
    #[default]
    Walk,
    /// Directions towards lamps, and those of a camera that sees through no flat
    /// mirror or pane, stay at rest, and points are drawn on all edges that move
    /// across them; elsewhere like [`Method::Walk`]. Unbiased.
    Edges,
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

/// Why a derivative is refused, and what to do instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// A full sentence or two for the user.
    pub reason: String,
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.reason)
    }
}

impl std::error::Error for Refusal {}
