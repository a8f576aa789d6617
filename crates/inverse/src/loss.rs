//! Distances of an image to a target, with the derivative with respect to every pixel, the
//! standard error, and what the noise of the image adds.

mod pyramid;

use capwalk_diff::Estimate;
use capwalk_math::Rgb;
use capwalk_scene::Image;

use pyramid::Level;

/// A loss: the weighted mean of a distance over pixels and channels, averaged
/// over the levels of a pyramid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loss {
    /// How two numbers differ.
    pub distance: Distance,
    /// How often the image is compared: as it is, with half of its sides, with
    /// a quarter, ... At least 1.
    pub levels: u32,
}

/// How a number `x` of an image differs from one of the target, `t`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distance {
    /// `|x - t|`.
    L1,
    /// `(x - t)²`.
    L2,
    /// `(x - t)² / (t² + epsilon)`: a square whose gradient is unbiased, since
    /// nothing is divided by what is noisy.
    Relative {
        /// Above 0, in squares of what pixels are.
        epsilon: f64,
    },
    /// `(log(x + epsilon) - log(t + epsilon))²`.
    Log {
        /// Above 0, in units of pixels.
        epsilon: f64,
    },
}

/// A loss that was computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// What it is. For distances that are squares in the image, without what
    /// noise adds on average, so that its mean is the loss of the mean image
    /// and it may be below zero; for the others, of the image with its noise.
    pub value: f64,
    /// Its standard error, to first order, from the standard errors of the
    /// image; channels of a pixel count as if their errors were the same, which
    /// is not too small from 4 samples per pixel on. NaN where those are unknown.
    pub standard_error: f64,
    /// What noise added and was subtracted; `None` where that is not known.
    pub noise: Option<f64>,
    /// Derivative with respect to each pixel and channel.
    pub adjoint: Image,
}

impl Distance {
    /// The distance of one number from its target.
    pub fn value(self, x: f64, t: f64) -> f64 {
        let d = x - t;
        match self {
            Self::L1 => d.abs(),
            Self::L2 => d * d,
            Self::Relative { epsilon } => d * d / (t * t + epsilon),
            Self::Log { epsilon } => ((x + epsilon).ln() - (t + epsilon).ln()).powi(2),
        }
    }

    /// Its derivative with respect to `x`; 0 where it has none.
    pub fn derivative(self, x: f64, t: f64) -> f64 {
        let d = x - t;
        match self {
            Self::L1 if d == 0.0 => 0.0,
            Self::L1 => d.signum(),
            Self::L2 => 2.0 * d,
            Self::Relative { epsilon } => 2.0 * d / (t * t + epsilon),
            Self::Log { epsilon } => {
                2.0 * ((x + epsilon).ln() - (t + epsilon).ln()) / (x + epsilon)
            }
        }
    }

    /// True if noise of the image changes the mean of the derivative.
    pub fn is_biased_by_noise(self) -> bool {
        self.of_variance(0.0).is_none()
    }

    /// What a unit of variance in `x` adds on average, if that does not depend on
    /// `x`: half the second derivative of a square.
    fn of_variance(self, t: f64) -> Option<f64> {
        match self {
            Self::L2 => Some(1.0),
            Self::Relative { epsilon } => Some(1.0 / (t * t + epsilon)),
            Self::L1 | Self::Log { .. } => None,
        }
    }
}

impl Loss {
    /// The loss of an image. `weights` are at least 0, by pixel and channel (a
    /// mask); all 1 without. All images have the same size.
    ///
    /// # Panics
    /// If they have not.
    pub fn measure(&self, image: &Estimate, target: &Image, weights: Option<&Image>) -> Measured {
        let mut levels = vec![Level::new(image, target, weights)];
        while levels.len() < self.levels as usize && !levels[levels.len() - 1].is_one_pixel() {
            levels.push(levels[levels.len() - 1].halved());
        }
        let whole: f64 = levels[0].weights.iter().map(|w| w.r + w.g + w.b).sum();
        let share = 1.0 / (whole * levels.len() as f64);
        let (mut value, mut noise) = (0.0, Some(0.0));
        // From the coarsest level to the image itself.
        let mut adjoint: Option<Vec<Rgb>> = None;
        for (i, level) in levels.iter().enumerate().rev() {
            let mut derivatives = match &adjoint {
                None => vec![Rgb::zero(); level.values.len()],
                Some(coarse) => level.pulled_back(&levels[i + 1], coarse),
            };
            for (p, derivatives) in derivatives.iter_mut().enumerate() {
                let mut sums = derivatives.to_array();
                for (c, sum) in sums.iter_mut().enumerate() {
                    let (x, t) = (level.values[p][c], level.targets[p][c]);
                    let weight = share * level.weights[p][c];
                    if weight == 0.0 {
                        continue;
                    }
                    value += weight * self.distance.value(x, t);
                    *sum += weight * self.distance.derivative(x, t);
                    let rate = self.distance.of_variance(t);
                    let added = rate.map(|rate| weight * rate * level.variances[p][c]);
                    noise = noise.zip(added).map(|(sum, more)| sum + more);
                }
                *derivatives = sums.into();
            }
            adjoint = Some(derivatives);
        }
        let adjoint = Image {
            width: target.width,
            height: target.height,
            pixels: adjoint.expect("there is a level"),
        };
        let noise = noise.filter(|noise| noise.is_finite());
        Measured {
            value: value - noise.unwrap_or(0.0),
            standard_error: standard_error(&adjoint, &image.standard_error),
            noise,
            adjoint,
        }
    }
}

/// To first order: pixels are independent, their channels are not.
fn standard_error(adjoint: &Image, errors: &Image) -> f64 {
    let pixels = adjoint.pixels.iter().zip(&errors.pixels);
    let of_pixels = pixels.map(|(a, &s)| {
        let products = [0, 1, 2].map(|c| match a[c] {
            0.0 => 0.0, // also where the error is unknown
            derivative => derivative.abs() * s[c],
        });
        products.iter().sum::<f64>().powi(2)
    });
    of_pixels.sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests;
