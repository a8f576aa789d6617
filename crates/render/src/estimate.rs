//! What comes back: images with standard errors, and counts.

use capwalk_math::Rgb;
use capwalk_scene::Image;

use crate::device::UsedDevice;

/// An estimated image and its error.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Estimated value of each pixel and channel.
    pub mean: Image,
    /// Standard error of each; NaN where there were fewer than two
    /// independent samples.
    pub standard_error: Image,
}

/// A rendered image.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// The image.
    pub value: Estimate,
    /// What was done.
    pub statistics: Statistics,
}

/// What was done.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Samples taken in each pixel, row by row: all equal to the samples asked
    /// for unless the work was stopped, or adaptive.
    pub samples_per_pixel: Vec<u32>,
    /// False if the work was stopped before all samples were taken.
    pub complete: bool,
    /// Samples in all.
    pub samples: u64,
    /// Samples that were infinite or NaN. They count as zero in the image,
    /// so more than a few of them make it wrong.
    pub non_finite: u64,
    /// Queries about silhouettes answered: the closest one, those in a cone, or a subtree.
    pub cone_queries: u64,
    /// Specular reflections and refractions in which something moves, or which
    /// move themselves: the silhouettes and hard shadows seen there are missing in the
    /// derivative.
    pub uncovered: u64,
    /// What the samples of an image took, in about twenty nanoseconds: counted by what queries
    /// were asked and found, and so the same in every run. 0 in reverse mode.
    pub effort: u64,
    /// What these concern, if there are any in a derivative.
    pub missing: Option<Missing>,
    /// Where it was computed.
    pub device: UsedDevice,
}

/// What a derivative leaves out: how silhouettes and hard shadows move that are seen by specular
/// reflection or refraction. Paths with such events carry this share of the image's radiance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Missing {
    /// From 0 to 1; 0 of a black image.
    pub share: f64,
    /// Its standard error, or more; NaN if there were too few samples to know it.
    pub standard_error: f64,
}

impl Missing {
    /// The share of a black image.
    pub const NOTHING: Self = Self {
        share: 0.0,
        standard_error: 0.0,
    };

    /// The share of these paths, given what arrives by them in each pixel.
    pub fn of(missing: &Estimate, value: &Estimate) -> Self {
        let sum = |image: &Image| {
            let pixels = image.pixels.iter();
            pixels.fold(Rgb::zero(), |sum, &pixel| sum + pixel)
        };
        let squares = |image: &Image| {
            let pixels = image.pixels.iter();
            pixels.fold(Rgb::zero(), |sum, &pixel| sum + pixel * pixel)
        };
        let error = |estimate: &Estimate| {
            let squares = squares(&estimate.standard_error);
            Rgb::new(squares.r.sqrt(), squares.g.sqrt(), squares.b.sqrt()).mean()
        };
        let (part, all) = (sum(&missing.mean).mean(), sum(&value.mean).mean());
        // A share of nothing is nothing.
        if all == 0.0 {
            return Self::NOTHING;
        }
        let share = part / all;
        Self {
            share,
            // As if the errors of both, and those of the channels, always added up.
            standard_error: (error(missing) + share * error(value)) / all,
        }
    }
}

impl Statistics {
    /// The largest tolerated fraction of non-finite samples.
    pub const NON_FINITE_LIMIT: f64 = 1e-6;

    /// True if there were too many non-finite samples to trust the image.
    pub fn too_many_non_finite(&self) -> bool {
        self.non_finite as f64 > Self::NON_FINITE_LIMIT * self.samples as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is missing of a black image is nothing, and not NaN.
    #[test]
    fn nothing_is_missing_of_a_black_image() {
        let grey = |value: f64| Estimate {
            mean: Image {
                pixels: vec![Rgb::splat(value); 2],
                width: 2,
                height: 1,
            },
            standard_error: Image {
                pixels: vec![Rgb::splat(0.1 * value); 2],
                width: 2,
                height: 1,
            },
        };
        assert_eq!(Missing::of(&grey(0.0), &grey(0.0)), Missing::NOTHING);
        let half = Missing::of(&grey(1.0), &grey(2.0));
        assert!((half.share - 0.5).abs() < 1e-15 && half.standard_error > 0.0);
    }
}
