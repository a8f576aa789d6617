//! How noisy an image is around each of its pixels.

use capwalk_math::Rgb;
use capwalk_scene::Image;

/// Squares over which variances are averaged, as radius in pixels and share in
/// the average. The nearest 24 neighbours say most; the wider ones and the
/// whole image only keep weights finite where all of them are without noise.
const NEIGHBOURHOODS: [(usize, f64); 3] = [(2, 0.9), (8, 0.09), (usize::MAX, 0.01)];

/// The variances of an image's pixels, to be averaged over the surroundings of each.
pub struct Surroundings {
    width: usize,
    height: usize,
    variances: Vec<Rgb>,
    /// Sum over all pixels above and to the left, one column and row more than
    /// the image (Crow 1984).
    sums: Vec<Rgb>,
}

impl Surroundings {
    /// The squares of standard errors; zero where there is none.
    pub fn new(standard_error: &Image) -> Self {
        let (width, height) = (standard_error.width, standard_error.height);
        let variances: Vec<Rgb> = standard_error
            .pixels
            .iter()
            .map(|e| match e.is_finite() {
                true => *e * *e,
                false => Rgb::zero(), // left out
            })
            .collect();
        let stride = width + 1;
        let mut sums = vec![Rgb::zero(); stride * (height + 1)];
        for y in 0..height {
            let mut row = Rgb::zero();
            for x in 0..width {
                row += variances[y * width + x];
                sums[(y + 1) * stride + x + 1] = sums[y * stride + x + 1] + row;
            }
        }
        Self {
            width,
            height,
            variances,
            sums,
        }
    }

    /// The variance of a channel of a pixel itself.
    pub fn own(&self, x: usize, y: usize, c: usize) -> f64 {
        self.variances[y * self.width + x][c]
    }

    /// Mean variance of a channel around a pixel, without the pixel itself.
    pub fn variance(&self, x: usize, y: usize, c: usize) -> f64 {
        let own = self.own(x, y, c);
        let mean_within = |radius: usize| {
            let from = [x, y].map(|at| at.saturating_sub(radius));
            let to = [
                x.saturating_add(radius).saturating_add(1).min(self.width),
                y.saturating_add(radius).saturating_add(1).min(self.height),
            ];
            let others = (to[0] - from[0]) * (to[1] - from[1]) - 1;
            // Differences of running sums leave rounding noise where all is zero.
            (self.sum(from, to, c) - own).max(0.0) / others.max(1) as f64
        };
        let shares = NEIGHBOURHOODS.iter();
        shares
            .map(|&(radius, share)| share * mean_within(radius))
            .sum()
    }

    fn sum(&self, from: [usize; 2], to: [usize; 2], c: usize) -> f64 {
        let at = |x: usize, y: usize| self.sums[y * (self.width + 1) + x][c];
        at(to[0], to[1]) - at(from[0], to[1]) - at(to[0], from[1]) + at(from[0], from[1])
    }
}
