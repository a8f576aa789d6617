//! How differences are taken.

use capwalk_diff::{Device, RenderOptions};

use crate::method::OptionError;

/// How central differences are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceOptions {
    /// Samples per pixel on each side, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// True if pixels get more or fewer samples by how noisy they are, in the time of `spp` of each.
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

/// An error if a GPU is asked for something that the CPU alone does.
pub(crate) fn refuse_gpu(what: &'static str, device: Device) -> Result<(), OptionError> {
    match device {
        Device::Gpu => Err(OptionError::NoGpu { what }),
        Device::Auto | Device::Cpu => Ok(()),
    }
}

/// The step that was asked for, or else the one that fits the scene: an error if differences cannot
/// be divided by it.
pub(crate) fn step(asked: Option<f64>, fits: impl FnOnce() -> f64) -> Result<f64, OptionError> {
    let step = asked.unwrap_or_else(fits);
    match (step.is_finite() && step > 0.0, asked) {
        (true, _) => Ok(step),
        (false, Some(_)) => Err(OptionError::NoStep { step }),
        (false, None) => Err(OptionError::NoFittingStep { step }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Only a step that was given is called by the name of the option.
    #[test]
    fn steps_that_fit_are_not_those_asked_for() {
        let text = |asked, fits| step(asked, || fits).map_err(|error| error.to_string());
        assert_eq!(text(None, 0.5), Ok(0.5));
        assert_eq!(text(Some(0.1), f64::NAN), Ok(0.1));
        let given = text(Some(-1.0), 0.5).expect_err("negative");
        assert!(given.starts_with("`step` is -1"), "{given}");
        for none in [0.0, f64::INFINITY, f64::NAN] {
            let fits = text(None, none).expect_err("no step");
            assert!(fits.starts_with("no step"), "{fits}");
        }
    }
}
