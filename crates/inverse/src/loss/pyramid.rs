//! Images of half the size: means of two by two pixels, and what they do to
//! variances, weights and derivatives.

use capwalk_diff::Estimate;
use capwalk_math::Rgb;
use capwalk_scene::Image;

/// What a loss compares at one size.
pub(super) struct Level {
    width: usize,
    height: usize,
    /// Pixels of the image.
    pub values: Vec<Rgb>,
    /// Their variances.
    pub variances: Vec<Rgb>,
    /// Pixels of the target.
    pub targets: Vec<Rgb>,
    /// How much each counts; the sum is the same at every size.
    pub weights: Vec<Rgb>,
}

impl Level {
    /// The images as they are.
    pub fn new(image: &Estimate, target: &Image, weights: Option<&Image>) -> Self {
        let size = |image: &Image| [image.width, image.height];
        let mean = &image.mean;
        assert_eq!(size(mean), size(target), "the target has another size");
        let ones = || vec![Rgb::splat(1.0); target.pixels.len()];
        Self {
            width: mean.width,
            height: mean.height,
            values: mean.pixels.clone(),
            variances: image
                .standard_error
                .pixels
                .iter()
                .map(|s| s.map(|s| s * s))
                .collect(),
            targets: target.pixels.clone(),
            weights: weights.map_or_else(ones, |weights| {
                assert_eq!(size(weights), size(target), "the mask has another size");
                weights.pixels.clone()
            }),
        }
    }

    /// True if there is nothing to halve.
    pub fn is_one_pixel(&self) -> bool {
        self.width == 1 && self.height == 1
    }

    /// Where a pixel goes in the image of half the size.
    fn parent(&self, pixel: usize) -> usize {
        let (x, y) = (pixel % self.width, pixel / self.width);
        y / 2 * self.width.div_ceil(2) + x / 2
    }

    /// Weighted means of two by two pixels; at odd borders of fewer.
    pub fn halved(&self) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        let mut half = Self {
            width,
            height,
            values: vec![Rgb::zero(); width * height],
            variances: vec![Rgb::zero(); width * height],
            targets: vec![Rgb::zero(); width * height],
            weights: vec![Rgb::zero(); width * height],
        };
        for (pixel, &w) in self.weights.iter().enumerate() {
            half.weights[self.parent(pixel)] += w;
        }
        for pixel in 0..self.values.len() {
            let (parent, share) = (self.parent(pixel), self.share(&half, pixel));
            // What counts nothing has no part, whatever it is.
            let part = |a: Rgb, factor: Rgb| {
                let products = (a * factor).to_array();
                let kept = [0, 1, 2].map(|c| if factor[c] == 0.0 { 0.0 } else { products[c] });
                Rgb::from(kept)
            };
            half.values[parent] += part(self.values[pixel], share);
            half.targets[parent] += part(self.targets[pixel], share);
            half.variances[parent] += part(self.variances[pixel], share * share);
        }
        half
    }

    /// The share of a pixel in the mean that it goes into.
    fn share(&self, half: &Self, pixel: usize) -> Rgb {
        let (own, sum) = (self.weights[pixel], half.weights[self.parent(pixel)]);
        let shares = [0, 1, 2].map(|c| match own[c] {
            0.0 => 0.0,
            weight => weight / sum[c],
        });
        shares.into()
    }

    /// Derivatives with respect to the pixels of half the size as derivatives with respect to
    /// these.
    pub fn pulled_back(&self, half: &Self, adjoint: &[Rgb]) -> Vec<Rgb> {
        let of = |pixel: usize| {
            let (share, derivative) = (self.share(half, pixel), adjoint[self.parent(pixel)]);
            Rgb::from([0, 1, 2].map(|c| share[c] * derivative[c]))
        };
        (0..self.values.len()).map(of).collect()
    }
}
