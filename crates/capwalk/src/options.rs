//! How differences are taken.

use capwalk_diff::RenderOptions;

/// How central differences are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceOptions {
    /// Samples per pixel on each side, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// Seed of all random numbers, the same on both sides.
    pub seed: u64,
    /// How far the parameter moves on each side, above 0, in its own units; `None`
    /// chooses [`difference_step`](crate::difference_step).
    pub step: Option<f64>,
}

impl Default for DifferenceOptions {
    /// 64 samples per pixel, the seed 0, and the step that fits the scene.
    fn default() -> Self {
        let RenderOptions { spp, seed, .. } = RenderOptions::default();
        Self {
            spp,
            seed,
            step: None,
        }
    }
}
