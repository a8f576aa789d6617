//! A gradient against finite differences: the verdict.
//!
//! Both images are estimates with stated standard errors, independent of each
//! other. Three sums over the pixels are tested, each of which is zero or one
//! on average for a right gradient however skewed the noise is:
//!
//! * squared differences over stated variances (`mean_z_squared`): local
//!   errors, and standard errors that are wrong;
//! * differences (`sign`): a common offset;
//! * the regression of the reference on the gradient (`scale_factor`): a wrong factor;
//!
//! and the largest difference by itself. Each test raises a false alarm with a
//! probability near [`FALSE_ALARM`], if noise is close to Gaussian. Squared
//! differences that are too large, but not by that many of their own errors,
//! are no proof of a wrong gradient, and none of a right one.

mod events;
mod pixel;
mod rounding;
mod scale_factor;
#[cfg(test)]
mod tests;

use std::fmt;

use capwalk_math::Rgb;
use capwalk_math::stats::normal_upper_tail;

use capwalk_render::Estimate;
pub use events::compare_with_differences;
pub use rounding::without_rounding;

use pixel::{NoiseFree, Pixel, Pixels, REFERENCE_BIAS, channel};
use scale_factor::ScaleFactor;

/// Standard errors beyond which a statistic is not an accident.
const SIGNIFICANT: f64 = 4.0;
/// Probability of that, both sides: one check in 16,000.
pub const FALSE_ALARM: f64 = 6.3e-5;
/// The band of `mean_z_squared` that is never held against a gradient: wide
/// enough for standard errors that are wrong by ten per cent.
const Z_SQUARED_BAND: std::ops::RangeInclusive<f64> = 0.8..=1.25;
/// Standard errors of `mean_z_squared` beyond which a gradient is not called right.
const DOUBTFUL: f64 = 2.0;
/// How many times the `relative_l1` of noise alone is not called right either, where
/// `mean_z_squared` is outside its band: its error comes from the same differences, and
/// differences that are large in few pixels widen it as they grow.
const DOUBTFUL_L1: f64 = 1.5;
/// Samples that settle a doubt, as a multiple of those taken: a difference twice as many
/// standard errors away as now is one that no noise explains.
const SETTLES_DOUBT: f64 = 4.0;
/// The error of the scale factor that a verdict of "right" excludes.
const EXCLUDED_ERROR: f64 = 0.1;
/// How many standard errors away it is excluded.
const EXCLUDED_AT: f64 = 2.0;
/// Allowance in the threshold of the single worst pixel for tails heavier than
/// a Gaussian's.
const HEAVY_TAILS: f64 = 1.5;
/// How many of the worst pixels are listed.
const WORST_PIXELS: usize = 10;

/// How a gradient compares with its reference. Shown as a line of its statistics.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Mean absolute difference over mean absolute reference; 0 if both
    /// images are zero, infinite if only the reference is.
    pub relative_l1: f64,
    /// What `relative_l1` would be from Gaussian noise of the stated size
    /// alone.
    pub relative_l1_of_noise: f64,
    /// Correlation of the two images; NaN if one is constant.
    pub correlation: f64,
    /// Mean of `z² = (gradient - reference)² / (their variances)`: 1 for a
    /// right gradient with right errors. Both sides of the fraction are
    /// averaged before they are divided, weighted by the noise around each
    /// pixel: the plain mean of `z²` is off 1 where few samples met the event
    /// that makes the noise. NaN if no pixel has noise.
    pub mean_z_squared: f64,
    /// Standard error of `mean_z_squared` if the gradient is right.
    pub mean_z_squared_error: f64,
    /// Mean of `z²` over the pixels with noise, all with the same weight. Near
    /// 1 for a right gradient if noise is close to Gaussian; off it either way
    /// where samples are few for how rare the noise is, and so no part of the
    /// verdict. NaN if no pixel has noise.
    pub mean_z_squared_plain: f64,
    /// Sum of the differences over its standard error, weighted as above: a
    /// standard normal variable for a right gradient, large for a systematic
    /// sign.
    pub sign: f64,
    /// How many pixels entered `z`: those where either image has noise, and those without
    /// that differ amid noise.
    pub pixels: usize,
    /// How many pixels have no finite value or standard error in one of the
    /// images (fewer than two samples reached them), and entered nothing.
    pub left_out: usize,
    /// Best factor from gradient to reference, 1 for a right gradient,
    /// corrected for the noise of the gradient.
    pub scale_factor: f64,
    /// Standard error of the scale factor: what size of error could be seen. Infinite
    /// if the gradient shows nothing above its noise.
    pub scale_factor_error: f64,
    /// The pixels with the largest `|z|`, worst first: column, row, z.
    pub worst: Vec<(usize, usize, f64)>,
    /// `z` of each pixel, row by row; 0 for those that did not enter it.
    pub z: Vec<f64>,
    /// True if the reference saw so few events that it says nothing, see
    /// [`compare_with_differences`].
    pub few_events: bool,
    /// What follows from it.
    pub verdict: Verdict,
}

impl Comparison {
    /// True if the scale factor says something: its error is below 1 or below itself. Where it
    /// is not, the gradient is too noisy to say by which factor it is off.
    pub fn knows_scale_factor(&self) -> bool {
        self.scale_factor_error < self.scale_factor.abs().max(1.0)
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} pixels, mean z² {:.3} ± {:.3}, sign {:+.2}, scale factor ",
            self.pixels, self.mean_z_squared, self.mean_z_squared_error, self.sign,
        )?;
        match self.knows_scale_factor() {
            true => write!(
                f,
                "{:.3} ± {:.3}",
                self.scale_factor, self.scale_factor_error
            ),
            false => f.write_str("hidden by noise"),
        }
    }
}

/// What a check says.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// They agree within their errors, pixel by pixel, and a common factor that is wrong by
    /// ten per cent is excluded (at two standard errors).
    Right,
    /// They differ by more than their errors allow.
    Wrong {
        /// In which respects.
        reason: String,
    },
    /// The noise hides what is asked for, or explains the differences only in part.
    Inconclusive {
        /// Samples per pixel, as a multiple of those taken, that would be
        /// enough; infinite if there is nothing to see, or if samples are not what it takes.
        samples_factor: f64,
        /// Why the gradient may be wrong, where the differences are larger than noise
        /// explains, or why that is no evidence; `None` where noise hides them.
        doubt: Option<String>,
    },
}

/// Compares a gradient with an independent reference of the same size. Pixels
/// without a finite value and standard error in both are left out.
pub fn compare(gradient: &Estimate, reference: &Estimate) -> Comparison {
    compared(gradient, reference).0
}

/// Which of its differences speak against a gradient.
#[derive(Default)]
struct Contradiction {
    /// They are smaller than the stated errors.
    too_small: Option<String>,
    /// They are larger than these allow, in these respects.
    too_large: Vec<String>,
}

/// The comparison, and what speaks against the gradient.
fn compared(gradient: &Estimate, reference: &Estimate) -> (Comparison, Contradiction) {
    assert_eq!(
        (gradient.mean.width, gradient.mean.height),
        (reference.mean.width, reference.mean.height),
        "the images have different sizes"
    );
    let mut comparison = without_errors(gradient, reference);
    let pixels = pixel::split(gradient, reference);
    comparison.left_out = pixels.left_out;
    let total = gradient.mean.pixels.len();
    if 2 * pixels.left_out > total {
        return (comparison, Contradiction::default());
    }
    let fitted = scale_factor::fit(&pixels);
    let noisy = &pixels.noisy;
    let weighted =
        |f: fn(&Pixel) -> f64| -> f64 { noisy.iter().map(|p| f(p) * p.weight_squared()).sum() };

    // Squared differences less their expectation, pixel by pixel: their spread
    // over the image gives the error of the mean, heavy tails included.
    let variances = weighted(Pixel::variance);
    let excess = |p: &Pixel| (p.difference().powi(2) - p.variance()) * p.weight_squared();
    let spread: f64 = noisy.iter().map(|p| excess(p).powi(2)).sum();
    let gaussian: f64 = noisy
        .iter()
        .map(|p| 2.0 * (p.variance() * p.weight_squared()).powi(2))
        .sum();
    let squares = weighted(|p| p.difference().powi(2));
    comparison.mean_z_squared = squares / variances;
    comparison.mean_z_squared_error = spread.max(gaussian).sqrt() / variances;
    let plain: f64 = noisy.iter().map(|p| p.z.powi(2)).sum();
    comparison.mean_z_squared_plain = plain / noisy.len() as f64;

    // Differences in units of the noise around them, over the larger of their
    // stated and their observed spread.
    let offset: f64 = noisy
        .iter()
        .map(|p| p.difference() * p.weight_squared().sqrt())
        .sum();
    comparison.sign = if noisy.is_empty() {
        0.0
    } else {
        offset / variances.max(squares).sqrt()
    };

    comparison.pixels = noisy.len();
    comparison.scale_factor = fitted.factor;
    comparison.scale_factor_error = fitted.error;
    for pixel in noisy {
        comparison.z[pixel.index] = pixel.z;
    }
    comparison.worst = worst(noisy, gradient.mean.width);

    let relative_offset = offset.abs() / (fitted.signal.max(0.0) * noisy.len() as f64).sqrt();
    let contradiction = Contradiction {
        too_small: too_small(&comparison),
        too_large: too_large(&comparison, &pixels, relative_offset, gradient.mean.width),
    };
    let Contradiction {
        too_small: small,
        too_large: large,
    } = &contradiction;
    let reasons: Vec<&str> = small.iter().chain(large).map(String::as_str).collect();
    comparison.verdict = if !reasons.is_empty() {
        Verdict::Wrong {
            reason: reasons.join("; "),
        }
    } else {
        match doubt(&comparison) {
            Some(doubt) => doubtful(visible(&pixels, &fitted), doubt),
            None => visible(&pixels, &fitted),
        }
    };
    (comparison, contradiction)
}

/// Column, row and z of the pixels with the largest `|z|`.
fn worst(noisy: &[Pixel], width: usize) -> Vec<(usize, usize, f64)> {
    let mut order: Vec<&Pixel> = noisy.iter().collect();
    order.sort_by(|a, b| b.z.abs().total_cmp(&a.z.abs()));
    let worst = order.iter().take(WORST_PIXELS);
    worst
        .map(|p| (p.index % width, p.index / width, p.z))
        .collect()
}

/// The numbers that need no standard errors, and the verdict of images that
/// have them in less than half of their pixels.
fn without_errors(gradient: &Estimate, reference: &Estimate) -> Comparison {
    let both = || {
        let channels = gradient.mean.pixels.iter().zip(&reference.mean.pixels);
        channels
            .filter(|(g, r)| g.is_finite() && r.is_finite())
            .flat_map(|(&g, &r)| (0..3).map(move |c| (channel(g, c), channel(r, c))))
    };
    let count = both().count() as f64;
    let difference: f64 = both().map(|(g, r)| (g - r).abs()).sum();
    let size: f64 = both().map(|(_, r)| r.abs()).sum();
    let ratio = |x: f64| if x == 0.0 { 0.0 } else { x / size };
    let errors = gradient.standard_error.pixels.iter();
    let errors = errors.zip(&reference.standard_error.pixels);
    let noise: f64 = errors
        .flat_map(|(&g, &r)| (0..3).map(move |c| channel(g, c).hypot(channel(r, c))))
        .filter(|error| error.is_finite())
        .sum();
    let (mean_g, mean_r) = (
        both().map(|(g, _)| g).sum::<f64>() / count,
        both().map(|(_, r)| r).sum::<f64>() / count,
    );
    let moment =
        |f: fn(f64, f64) -> f64| -> f64 { both().map(|(g, r)| f(g - mean_g, r - mean_r)).sum() };
    Comparison {
        relative_l1: ratio(difference),
        // Mean absolute value of a standard normal variable: sqrt(2/pi).
        relative_l1_of_noise: ratio(noise * (2.0 / std::f64::consts::PI).sqrt()),
        correlation: moment(|g, r| g * r) / (moment(|g, _| g * g) * moment(|_, r| r * r)).sqrt(),
        mean_z_squared: f64::NAN,
        mean_z_squared_error: f64::NAN,
        mean_z_squared_plain: f64::NAN,
        sign: f64::NAN,
        pixels: 0,
        left_out: 0,
        scale_factor: f64::NAN,
        scale_factor_error: f64::INFINITY,
        worst: Vec::new(),
        z: vec![0.0; gradient.mean.pixels.len()],
        few_events: false,
        // Two samples are the fewest that have a standard error.
        verdict: Verdict::Inconclusive {
            samples_factor: 2.0,
            doubt: None,
        },
    }
}

/// True if the mean of z² is that far from 1 that noise does not explain it.
fn is_significant(c: &Comparison) -> bool {
    (c.mean_z_squared - 1.0).abs() > SIGNIFICANT * c.mean_z_squared_error
}

/// What is said of images that differ by less than their errors.
fn too_small(c: &Comparison) -> Option<String> {
    let is_small = c.mean_z_squared < *Z_SQUARED_BAND.start();
    (is_small && is_significant(c)).then(|| {
        format!(
            "the differences are smaller than the stated errors (mean z² is {:.3} ± {:.3} \
             instead of 1): the errors are overstated, or the images share random numbers",
            c.mean_z_squared, c.mean_z_squared_error
        )
    })
}

/// Everything in which the images differ by more than their errors allow.
fn too_large(c: &Comparison, pixels: &Pixels, relative_offset: f64, width: usize) -> Vec<String> {
    let mut reasons = Vec::new();
    if c.mean_z_squared > *Z_SQUARED_BAND.end() && is_significant(c) {
        reasons.push(format!(
            "the differences are larger than the stated errors allow (mean z² is {:.3} ± {:.3} \
             instead of 1)",
            c.mean_z_squared, c.mean_z_squared_error
        ));
    }
    if c.sign.abs() > SIGNIFICANT && relative_offset > REFERENCE_BIAS {
        reasons.push(format!(
            "it is systematically too {} ({:.1} standard errors over the image)",
            if c.sign > 0.0 { "large" } else { "small" },
            c.sign.abs()
        ));
    }
    let factor_off = (c.scale_factor - 1.0).abs();
    if factor_off > SIGNIFICANT * c.scale_factor_error && factor_off > REFERENCE_BIAS {
        reasons.push(format!(
            "the reference is {:.3} ± {:.3} times as large",
            c.scale_factor, c.scale_factor_error
        ));
    }
    if let Some(outlier) = worst_outlier(&pixels.noisy) {
        reasons.push(format!(
            "pixel ({}, {}) differs by {:.1} standard errors",
            outlier.index % width,
            outlier.index / width,
            outlier.z.abs()
        ));
    }
    let wrong: Vec<_> = pixels.noise_free.iter().filter(|p| differs(p)).collect();
    if let Some(first) = wrong.first() {
        let (g, r) = (first.gradient, first.reference);
        reasons.push(format!(
            "{} pixels without noise differ, the first is ({}, {}) with ({}, {}, {}) instead of \
             ({}, {}, {})",
            wrong.len(),
            first.index % width,
            first.index / width,
            g.r,
            g.g,
            g.b,
            r.r,
            r.g,
            r.b
        ));
    }
    reasons
}

/// True if a pixel without noise differs by more than the reference's bias, and
/// by more than the noise of the pixels around it explains.
fn differs(pixel: &NoiseFree) -> bool {
    (0..3).any(|i| {
        let (g, r) = (channel(pixel.gradient, i), channel(pixel.reference, i));
        let around = SIGNIFICANT * HEAVY_TAILS * channel(pixel.error_around, i);
        (g - r).abs() > (REFERENCE_BIAS * g.abs().max(r.abs())).max(around)
    })
}

/// The pixel with the largest difference in units of the larger of its own
/// error and that around it, if it is larger than among so many pixels happens
/// by accident.
fn worst_outlier(noisy: &[Pixel]) -> Option<&Pixel> {
    let size = |p: &Pixel| p.difference().abs() / p.variance().max(p.local_variance).sqrt();
    let worst = noisy.iter().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    // Šidák's correction, to first order: the tail of one pixel is the
    // tolerated probability shared by all.
    let tail = 0.5 * FALSE_ALARM / noisy.len() as f64;
    let relative = worst.difference().abs() / worst.gradient.abs().max(worst.reference.abs());
    let unlikely = normal_upper_tail(size(worst) / HEAVY_TAILS) < tail;
    (unlikely && relative > REFERENCE_BIAS).then_some(worst)
}

/// Right, or how many more samples would tell.
fn visible(pixels: &Pixels, fitted: &ScaleFactor) -> Verdict {
    let zero = |p: &NoiseFree| p.gradient == Rgb::zero() && p.reference == Rgb::zero();
    let nothing_visible = pixels.noisy.is_empty() && pixels.noise_free.iter().all(zero);
    let largest_error = (fitted.factor - 1.0).abs() + EXCLUDED_AT * fitted.error;
    if nothing_visible || largest_error <= EXCLUDED_ERROR {
        return Verdict::Right;
    }
    // A right gradient comes out within two standard errors of 1, and two more
    // must fit between that and the error to be excluded.
    let samples_factor = fitted.samples_factor(EXCLUDED_ERROR / (2.0 * EXCLUDED_AT));
    Verdict::Inconclusive {
        samples_factor,
        doubt: None,
    }
}

/// Why differences that are no proof of a wrong gradient are not those of a right one: they
/// are clearly larger, in some of the pixels, than noise explains.
fn doubt(c: &Comparison) -> Option<String> {
    let beyond_errors = c.mean_z_squared - 1.0 > DOUBTFUL * c.mean_z_squared_error;
    let beyond_noise = c.relative_l1 > DOUBTFUL_L1 * c.relative_l1_of_noise;
    let is_doubtful = c.mean_z_squared > *Z_SQUARED_BAND.end() && (beyond_errors || beyond_noise);
    is_doubtful.then(|| {
        format!(
            "the differences are larger than noise explains, though not by enough to call them \
             wrong (mean z² is {:.3} ± {:.3} instead of 1, relative L1 {:.3} where noise alone \
             gives {:.3})",
            c.mean_z_squared, c.mean_z_squared_error, c.relative_l1, c.relative_l1_of_noise
        )
    })
}

/// The verdict where there is a doubt, instead of "right" or of noise that hides something.
fn doubtful(verdict: Verdict, doubt: String) -> Verdict {
    let samples_factor = match verdict {
        Verdict::Inconclusive { samples_factor, .. } => samples_factor.max(SETTLES_DOUBT),
        _ => SETTLES_DOUBT,
    };
    Verdict::Inconclusive {
        samples_factor,
        doubt: Some(doubt),
    }
}
