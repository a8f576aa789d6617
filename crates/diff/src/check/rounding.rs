//! Differences that are rounding, and nothing else.

use capwalk_math::Rgb;
use capwalk_render::Estimate;

use crate::gradient_image::GradientImage;

/// What rounding can leave of a difference of two images, in units of their
/// largest value: some thousand operations in double precision, each off by
/// one part in 10^16.
const ROUNDING: f64 = 1e-12;

/// The derivative of an image of central differences over `±step`, in which
/// values and standard errors at the level of rounding are exactly zero.
///
/// Where the two sides of a difference go through the same numbers in another
/// order, something like 1e-16 is left of them, with as small an error: a
/// number that says nothing, and that any other number is many errors away
/// from.
pub fn without_rounding(reference: &GradientImage, step: f64) -> Estimate {
    let values = reference.value.mean.pixels.iter();
    let values = values.flat_map(|p| [p.r, p.g, p.b]);
    let finite = values.filter(|x| x.is_finite());
    let largest = finite.fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let level = ROUNDING * largest / step.abs();
    let mut cleaned = reference.gradient.clone();
    let (means, errors) = (&mut cleaned.mean, &mut cleaned.standard_error);
    for pixel in means.pixels.iter_mut().chain(&mut errors.pixels) {
        *pixel = above(*pixel, level);
    }
    cleaned
}

/// A colour whose channels below a level are zero.
fn above(colour: Rgb, level: f64) -> Rgb {
    let channel = |x: f64| if x.abs() < level { 0.0 } else { x };
    Rgb::new(channel(colour.r), channel(colour.g), channel(colour.b))
}
