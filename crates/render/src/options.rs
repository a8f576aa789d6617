//! What a caller can choose, and how it can follow and stop the work.

use serde::Serialize;

use capwalk_scene::Scene;

use crate::device::Device;
use crate::grid::Grid;
use crate::seed::Seed;

/// How an image is rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct RenderOptions {
    /// Samples per pixel, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// True if pixels get more or fewer samples by how noisy they are, in the time of `spp` of
    /// each, see [`adaptive`](crate::adaptive).
    pub adaptive: bool,
    /// Seed of all random numbers: the same scene and seed give the same bits.
    pub seed: u64,
    /// The cells that the samples are cut into, for work in parts. Another grid rounds
    /// differently, in the last bits.
    pub grid: Grid,
    /// Where `Prepared` in the crate `capwalk` computes; the functions of this crate and of
    /// `capwalk-diff` compute on the CPU. Not in fingerprints.
    #[serde(skip)]
    pub device: Device,
}

impl Default for RenderOptions {
    /// 64 samples per pixel and the seed 0, on the CPU.
    fn default() -> Self {
        Self::new(64, 0)
    }
}

impl RenderOptions {
    /// So many samples per pixel, from this seed, on the CPU.
    pub const fn new(spp: u32, seed: u64) -> Self {
        Self {
            spp,
            adaptive: false,
            seed,
            grid: Grid::DEFAULT,
            device: Device::Cpu,
        }
    }

    /// What the scene says of itself.
    pub fn of(scene: &Scene) -> Self {
        Self::new(scene.settings.spp, scene.settings.seed)
    }

    /// These options with [another seed](Seed::independent), for an image whose noise must be
    /// independent of one with this seed: an adjoint must be independent of the random
    /// numbers of its gradient.
    #[must_use]
    pub fn with_independent_seed(self) -> Self {
        let Seed(seed) = Seed(self.seed).independent();
        Self { seed, ..self }
    }
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

/// Stops when another watch does, and says nothing.
pub struct Silent<'a>(pub &'a dyn Watch);

impl Watch for Silent<'_> {
    fn progress(&self, _done: u64, _total: u64) {}
    fn should_stop(&self) -> bool {
        self.0.should_stop()
    }
}
