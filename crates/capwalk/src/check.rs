//! A gradient against central differences.

use capwalk_diff::GradientImage;
use capwalk_diff::check::{Comparison, compare, without_rounding};

use crate::options::DifferenceOptions;
use capwalk_diff::GradientOptions;

/// Samples of the reference for each one of the gradient, if nothing is said:
/// differences are cheaper, and noisier.
const REFERENCE_FACTOR: u32 = 4;

/// Makes the reference's random numbers independent of the gradient's.
const REFERENCE_SEED: u64 = 0x9e37_79b9_7f4a_7c15;

/// How a gradient is checked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckOptions {
    /// How the gradient is estimated.
    pub gradient: GradientOptions,
    /// Samples per pixel of the reference on each side of the difference; `None` takes
    /// four times those of the gradient.
    pub reference_spp: Option<u32>,
    /// How far the parameter moves on each side, in its own units; `None` chooses
    /// [`difference_step`](crate::difference_step).
    pub step: Option<f64>,
}

impl CheckOptions {
    /// How the reference is made, with this step unless another one was asked for. Its
    /// random numbers are independent of the gradient's.
    pub fn reference(&self, default_step: impl FnOnce() -> f64) -> Reference {
        let GradientOptions { spp, seed, .. } = self.gradient;
        Reference {
            spp: self
                .reference_spp
                .unwrap_or(spp.saturating_mul(REFERENCE_FACTOR)),
            seed: seed ^ REFERENCE_SEED,
            step: self.step.unwrap_or_else(default_step),
        }
    }
}

/// How the reference of a check is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Samples per pixel on each side.
    pub spp: u32,
    /// Seed of its random numbers.
    pub seed: u64,
    /// How far the parameter moves on each side, in its own units.
    pub step: f64,
}

impl Reference {
    /// As options of central differences.
    pub fn options(&self) -> DifferenceOptions {
        DifferenceOptions {
            spp: self.spp,
            seed: self.seed,
            step: Some(self.step),
        }
    }
}

/// A gradient, its reference, and how they compare.
#[derive(Clone, Debug)]
pub struct Check {
    /// The gradient in question.
    pub gradient: GradientImage,
    /// Central differences, without what only rounding makes of them.
    pub reference: GradientImage,
    /// The statistics and the verdict.
    pub comparison: Comparison,
    /// How the reference was made.
    pub made: Reference,
}

impl Check {
    /// Compares a gradient with differences that were made like this. Both have the same
    /// size.
    pub fn new(gradient: GradientImage, differences: GradientImage, made: Reference) -> Self {
        let mut reference = differences;
        reference.gradient = without_rounding(&reference, made.step);
        Self {
            comparison: compare(&gradient.gradient, &reference.gradient),
            gradient,
            reference,
            made,
        }
    }
}
