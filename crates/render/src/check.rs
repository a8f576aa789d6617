//! A gradient against finite differences: the verdict.

use crate::estimate::Estimate;

/// How a gradient compares with its reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Mean absolute difference over mean absolute reference.
    pub relative_l1: f64,
    /// Correlation of the two pictures; NaN if one is constant.
    pub correlation: f64,
    /// Mean over pixels of `z² = (gradient - reference)² / (their variances)`:
    /// 1 for a right gradient with right errors.
    pub mean_z_squared: f64,
    /// Mean of `z` times the square root of its number: a standard normal
    /// variable for a right gradient, large for a systematic sign.
    pub sign: f64,
    /// How many pixels entered `z`: those where either picture has noise.
    pub pixels: usize,
    /// Best factor from gradient to reference, 1 for a right gradient.
    pub slope: f64,
    /// Standard error of the slope: what size of error could be seen.
    pub slope_error: f64,
    /// The pixels with the largest `|z|`, worst first: column, row, z.
    pub worst: Vec<(usize, usize, f64)>,
    /// `z` of each pixel, row by row; 0 where neither picture has noise.
    pub z: Vec<f64>,
    /// What follows from it.
    pub verdict: Verdict,
}

/// What a check says.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// They agree within their errors, and an error of ten per cent would
    /// have been seen.
    Right,
    /// They differ by more than their errors allow.
    Wrong {
        /// In which respect.
        reason: String,
    },
    /// The noise hides what is asked for.
    CouldNotTell {
        /// Samples per pixel, as a multiple of those taken, that would be
        /// enough; infinite if there is nothing to see.
        samples_factor: f64,
    },
}

/// Compares a gradient with an independent reference.
pub fn compare(_gradient: &Estimate, _reference: &Estimate) -> Comparison {
    todo!()
}
