//! How differences are taken.

use capwalk_diff::RenderOptions;

use crate::method::OptionError;

/// How central differences are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceOptions {
    /// Samples per pixel on each side, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// Whether pixels get more or fewer samples by how noisy they are, in the time of `spp` of each.
    pub adaptive: bool,
    /// Seed of all random numbers, the same on both sides.
    pub seed: u64,
    /// How far the parameter moves on each side, above 0, in its own units; `None`
    /// chooses [`Prepared::fine_difference_step`](crate::Prepared::fine_difference_step).
    pub step: Option<f64>,
}

impl Default for DifferenceOptions {
    /// 64 samples per pixel, the seed 0, and the step that fits the scene.
    fn default() -> Self {
        let sampling = RenderOptions::default();
        Self {
            spp: sampling.spp,
            adaptive: sampling.adaptive,
            seed: sampling.seed,
            step: None,
        }
    }
}

impl DifferenceOptions {
    /// How the images are sampled.
    pub(crate) fn sampling(&self) -> RenderOptions {
        RenderOptions {
            adaptive: self.adaptive,
            ..RenderOptions::new(self.spp, self.seed)
        }
    }
}

/// An error if this number of samples per pixel is none.
pub(crate) fn check_spp(option: &'static str, spp: u32) -> Result<(), OptionError> {
    match spp {
        0 => Err(OptionError::NoSamples { option }),
        _ => Ok(()),
    }
}

/// An error if differences cannot be divided by this step.
pub(crate) fn check_step(step: f64) -> Result<(), OptionError> {
    match step.is_finite() && step > 0.0 {
        true => Ok(()),
        false => Err(OptionError::NoStep { step }),
    }
}
