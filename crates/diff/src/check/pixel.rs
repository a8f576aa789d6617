//! One number per pixel, its errors, and a weight that does not depend on it.

use capwalk_math::Rgb;

use capwalk_render::{Estimate, Surroundings};

/// What one pixel contributes to the comparison.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pixel {
    /// Index into the images.
    pub index: usize,
    /// The gradient's number.
    pub gradient: f64,
    /// The reference's number.
    pub reference: f64,
    /// Variance of the gradient's number, as stated.
    pub gradient_variance: f64,
    /// Variance of the reference's number, as stated.
    pub reference_variance: f64,
    /// Variance of the difference around this pixel, without the pixel's own.
    pub local_variance: f64,
    /// `difference / its standard error`, see [`guarded_variance`].
    pub z: f64,
}

impl Pixel {
    /// Gradient minus reference.
    pub fn difference(&self) -> f64 {
        self.gradient - self.reference
    }

    /// Stated variance of the difference of two independent images.
    pub fn variance(&self) -> f64 {
        self.gradient_variance + self.reference_variance
    }

    /// Square of the weight in sums over pixels. It comes from the neighbours:
    /// a weight from the pixel's own variance estimate would favour the pixels
    /// whose skewed noise happened to turn out small, and bias every sum.
    pub fn weight_squared(&self) -> f64 {
        1.0 / self.local_variance
    }
}

/// Relative differences below this are not held against a gradient: central
/// differences have a bias of order `step²` themselves.
pub(super) const REFERENCE_BIAS: f64 = 0.02;

/// A pixel whose standard error is below this fraction of its value counts as free of noise:
/// the reference's own bias, of order `step²`, is larger.
///
/// Its own error does not tell where it differs from the reference amid noise: beside a
/// gradient without noise, the pixels in which the reference met no event would be left out
/// and the others kept, in which it is too large.
const NOISE_FREE: f64 = 1e-3;

/// A pixel that claims to have no noise.
pub(super) struct NoiseFree {
    /// Its index in the image.
    pub index: usize,
    /// The gradient.
    pub gradient: Rgb,
    /// The reference.
    pub reference: Rgb,
    /// Standard error of their difference in the pixels around it: with very
    /// few samples a pixel can look free of noise by accident.
    pub error_around: Rgb,
}

/// The pixels with noise, and those without.
pub(super) struct Pixels {
    /// Pixels where an image has noise, or that differ amid noise.
    pub noisy: Vec<Pixel>,
    /// The others.
    pub noise_free: Vec<NoiseFree>,
    /// How many have no finite value or standard error in one of the images,
    /// and are in neither list: fewer than two samples reached them.
    pub left_out: usize,
}

/// Splits the images into pixels with and without noise.
///
/// The channels of a pixel come from the same samples, so only one of them
/// enters: channel `(x + y) mod 3`, or the next one with noise. A fixed mosaic
/// takes every channel, and prefers none because its noise is large.
pub(super) fn split(gradient: &Estimate, reference: &Estimate) -> Pixels {
    let (width, height) = (gradient.mean.width, gradient.mean.height);
    let gradient_around = Surroundings::new(&gradient.standard_error);
    let reference_around = Surroundings::new(&reference.standard_error);
    let mut pixels = Pixels {
        noisy: Vec::new(),
        noise_free: Vec::new(),
        left_out: 0,
    };
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        let index = y * width + x;
        let (g, r) = (gradient.mean.pixels[index], reference.mean.pixels[index]);
        let (g_error, r_error) = (
            gradient.standard_error.pixels[index],
            reference.standard_error.pixels[index],
        );
        if ![g, r, g_error, r_error].iter().all(|x| x.is_finite()) {
            pixels.left_out += 1;
            continue;
        }
        let around = |c: usize| {
            [
                gradient_around.variance(x, y, c),
                reference_around.variance(x, y, c),
            ]
        };
        let error_around = |c: usize| around(c).iter().sum::<f64>().sqrt();
        let noisy = |c: &usize| {
            let size = channel(g, *c).abs().max(channel(r, *c).abs());
            let own = channel(g_error, *c).hypot(channel(r_error, *c));
            let differs = (channel(g, *c) - channel(r, *c)).abs() > REFERENCE_BIAS * size;
            own > NOISE_FREE * size || (differs && error_around(*c) > NOISE_FREE * size)
        };
        let Some(c) = (0..3).map(|c| (x + y + c) % 3).find(noisy) else {
            pixels.noise_free.push(NoiseFree {
                index,
                gradient: g,
                reference: r,
                error_around: [0, 1, 2].map(error_around).into(),
            });
            continue;
        };
        let around = around(c);
        let own = [channel(g_error, c).powi(2), channel(r_error, c).powi(2)];
        let mut pixel = Pixel {
            index,
            gradient: channel(g, c),
            reference: channel(r, c),
            gradient_variance: own[0],
            reference_variance: own[1],
            local_variance: around[0] + around[1],
            z: 0.0,
        };
        if pixel.local_variance == 0.0 {
            pixel.local_variance = pixel.variance(); // the only noisy pixel
        }
        // The reference's bias is not held against a pixel with hardly any noise.
        let bias = NOISE_FREE * pixel.gradient.abs().max(pixel.reference.abs());
        pixel.z = pixel.difference() / guarded_variance(own, around).sqrt().max(bias);
        pixels.noisy.push(pixel);
    }
    pixels
}

/// Variance of a difference, where an image that states an error of exactly
/// zero is given the variance around the pixel. Beside noisy neighbours, zero
/// means that no sample met the rare event that makes the noise, not that
/// there is none.
fn guarded_variance(own: [f64; 2], around: [f64; 2]) -> f64 {
    let guarded = |i: usize| if own[i] > 0.0 { own[i] } else { around[i] };
    guarded(0) + guarded(1)
}

/// One channel of a colour.
pub(super) fn channel(colour: Rgb, c: usize) -> f64 {
    colour[c]
}
