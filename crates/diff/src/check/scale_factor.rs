//! The best factor from the gradient to the reference.
//!
//! Both images are noisy, and noise in the gradient makes an ordinary
//! regression too flat. With stated variances the bias can be taken out
//! (Fuller 1987, *Measurement Error Models*, section 1.2):
//!
//! ```text
//! factor = Σ w² g r / Σ w² (g² - var g)
//! ```
//!
//! Its error has a part from signal times noise, which falls with the number of
//! samples, and one from noise times noise, which falls with its square.

use super::pixel::{Pixel, Pixels, channel};

/// A fitted factor.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScaleFactor {
    /// The factor; NaN if there is nothing to fit.
    pub factor: f64,
    /// Its standard error; infinite if the gradient shows nothing above its
    /// noise.
    pub error: f64,
    /// `Σ w² μ²` of the gradient's true values `μ`, as estimated.
    pub signal: f64,
    /// Standard error of `signal`.
    signal_error: f64,
    /// `Σ w⁴ μ² (var g + var r)`: signal times noise.
    mixed: f64,
    /// `Σ w⁴ (var g var r + 2 var² g)`: noise times noise.
    noise: f64,
}

/// Standard errors above zero at which a signal counts as seen.
const SEEN: f64 = 3.0;

/// Fits the factor over the pixels with noise, or over those without where
/// there are no others.
pub(super) fn fit(pixels: &Pixels) -> ScaleFactor {
    if pixels.noisy.is_empty() {
        let both = || {
            let channels = pixels.noise_free.iter();
            channels.flat_map(|p| (0..3).map(|c| (channel(p.gradient, c), channel(p.reference, c))))
        };
        let signal: f64 = both().map(|(g, _)| g * g).sum();
        return ScaleFactor {
            factor: both().map(|(g, r)| g * r).sum::<f64>() / signal,
            error: 0.0,
            signal,
            signal_error: 0.0,
            mixed: 0.0,
            noise: 0.0,
        };
    }
    let (mut product, mut signal, mut spread, mut mixed, mut noise) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for p in &pixels.noisy {
        let (w2, g, r) = (p.weight_squared(), p.gradient, p.reference);
        let (var_g, var_r) = (p.gradient_variance, p.reference_variance);
        let square = g * g - var_g; // μ² on average
        product += w2 * g * r;
        signal += w2 * square;
        spread += w2 * w2 * (4.0 * square.max(0.0) * var_g + 2.0 * var_g * var_g);
        mixed += w2 * w2 * square.max(0.0) * (var_g + var_r);
        noise += w2 * w2 * (var_g * var_r + 2.0 * var_g * var_g);
    }
    let signal_error = spread.sqrt();
    let seen = signal > SEEN * signal_error;
    let factor = product / signal;
    // The same error from the residuals of the fit: larger than the stated one
    // where rare events leave most pixels without noise and without signal.
    let residual = |p: &Pixel| {
        let square = p.gradient * p.gradient - p.gradient_variance;
        p.weight_squared() * (p.gradient * p.reference - factor * square)
    };
    let residuals: f64 = pixels.noisy.iter().map(|p| residual(p).powi(2)).sum();
    ScaleFactor {
        factor,
        error: if seen {
            (mixed + noise).max(residuals).sqrt() / signal
        } else {
            f64::INFINITY
        },
        signal,
        signal_error,
        mixed,
        noise,
    }
}

/// The smallest factor worth trying: fewer more samples would not tell apart
/// what these could not.
const FEWEST: f64 = 2.0;

impl ScaleFactor {
    /// How many times the samples bring the error down to `target`: the `f` at
    /// which `mixed / f + noise / f² = (target · signal)²`. Where no signal is
    /// seen yet, one of the size of its error is assumed.
    pub fn samples_factor(&self, target: f64) -> f64 {
        let signal = self.signal.max(self.signal_error);
        let allowed = (target * signal).powi(2);
        if allowed == 0.0 {
            return f64::INFINITY;
        }
        let root = (self.mixed * self.mixed + 4.0 * allowed * self.noise).sqrt();
        ((self.mixed + root) / (2.0 * allowed)).max(FEWEST)
    }
}
