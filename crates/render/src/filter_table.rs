//! Points drawn by a filter along one axis of the film: by a piecewise constant density that is close to its
//! magnitude. All distances are from the pixel's centre.

use capwalk_math::Real;
use capwalk_scene::Filter;

/// Bins of the density.
pub const BINS: usize = 32;

/// A filter between two ends, and what points there are drawn by.
#[derive(Clone, Debug)]
pub struct FilterTable {
    /// The filter.
    pub filter: Filter,
    /// Where the support starts and ends.
    pub ends: [f64; 2],
    /// Integral of the filter between the ends.
    integral: f64,
    /// The probabilities of equal bins.
    masses: [f64; BINS],
    /// The sums of those before each.
    pub below: [f64; BINS],
    /// One over each.
    pub inverse: [f64; BINS],
}

/// Gauss-Legendre nodes and weights on [-1, 1], 8 points (Abramowitz and
/// Stegun 25.4.30); over a pixel of any filter they are exact to 1e-9.
const GAUSS: [(f64, f64); 4] = [
    (0.1834346424956498, 0.3626837833783620),
    (0.5255324099163290, 0.3137066458778873),
    (0.7966664774136267, 0.2223810344533745),
    (0.9602898564975363, 0.1012285362903763),
];

/// `∫ f` from `a` to `b`.
fn integrate(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let pairs = GAUSS.iter();
    pairs
        .map(|&(x, w)| w * half * (f(middle + half * x) + f(middle - half * x)))
        .sum()
}

/// [`integrate`] over an interval, cut at each pixel from the centre: cubic filters have their knots
/// there, and Lanczos's its zeros.
fn integrate_pieces(f: impl Fn(f64) -> f64, [start, end]: [f64; 2]) -> f64 {
    let (mut sum, mut from) = (0.0, start);
    while from < end {
        let to = (from.floor() + 1.0).min(end);
        sum += integrate(&f, from, to);
        from = to;
    }
    sum
}

impl FilterTable {
    /// The table of a filter between two ends.
    pub fn new(filter: Filter, ends: [f64; 2]) -> Self {
        let f = |x: f64| filter.eval(x);
        let width = (ends[1] - ends[0]) / BINS as f64;
        let start = |i: usize| ends[0] + i as f64 * width;
        // In the middle of a bin a filter that changes sign may be zero by accident.
        let masses: [f64; BINS] = std::array::from_fn(|i| match filter.changes_sign() {
            true => integrate(|x| f(x).abs(), start(i), start(i) + width),
            false => f(start(i) + 0.5 * width),
        });
        let total: f64 = masses.iter().sum();
        let masses = masses.map(|mass| mass / total);
        let mut sum = 0.0;
        let below = masses.map(|mass| {
            let below = sum;
            sum += mass;
            below
        });
        Self {
            filter,
            ends,
            integral: integrate_pieces(f, ends),
            masses,
            below,
            inverse: masses.map(f64::recip),
        }
    }

    /// Where it starts, the width of a bin, and that over the filter's integral; the probabilities of
    /// all bins below each; and its own.
    pub fn numbers(&self) -> [f64; 3 + 2 * BINS] {
        let numbers = [self.ends[0], self.bin(), self.bin_over_integral()];
        let mut numbers = numbers.iter().chain(&self.below).chain(&self.masses);
        std::array::from_fn(|_| *numbers.next().expect("as many"))
    }

    /// The width of a bin.
    #[inline]
    pub fn bin(&self) -> f64 {
        (self.ends[1] - self.ends[0]) / BINS as f64
    }

    /// That over the integral of the filter.
    #[inline]
    pub fn bin_over_integral(&self) -> f64 {
        self.bin() / self.integral
    }

    /// The normalised filter.
    #[inline]
    pub fn weight<R: Real>(&self, x: R) -> R {
        self.filter.eval(x) * R::constant(1.0 / self.integral)
    }

    /// Draws a point.
    #[inline]
    pub fn sample(&self, u: f64) -> f64 {
        if self.filter == Filter::Box {
            return self.ends[0] + u * (self.ends[1] - self.ends[0]);
        }
        self.draw(u)[0]
    }

    /// [`Self::sample`], and what the filter at the point is to be multiplied by for its weight over the
    /// density.
    #[inline]
    pub fn draw(&self, u: f64) -> [f64; 2] {
        let bin = self.find(u);
        self.draw_in(bin as f64, u, [self.below[bin], self.inverse[bin]])
    }

    /// The bin in which a number draws a point: the last that starts there or before.
    #[inline]
    fn find(&self, u: f64) -> usize {
        // The number of bins is a power of two: halve what is left until it is one.
        let (mut bin, mut half) = (0, BINS / 2);
        while half > 0 {
            bin += half * usize::from(u >= self.below[bin + half]);
            half /= 2;
        }
        bin
    }

    /// [`Self::draw`] in a bin, of which the sum of those below and its inverse are given.
    #[inline(always)]
    pub fn draw_in(&self, bin: f64, u: f64, [below, inverse]: [f64; 2]) -> [f64; 2] {
        let inside = (u - below) * inverse;
        let inside = if inside < 1.0 { inside } else { 1.0 };
        let place = self.ends[0] + (bin + inside) * self.bin();
        [place, self.bin_over_integral() * inverse]
    }

    /// Density of [`Self::sample`].
    pub fn pdf(&self, x: f64) -> f64 {
        let bin = (x - self.ends[0]) / self.bin();
        self.masses[(bin as usize).min(BINS - 1)] / self.bin()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number at which bins begin draws a point of the last of them, which has mass.
    #[test]
    fn bins_have_their_first_number() {
        let filters = [
            Filter::Tent { radius: 1.0 },
            Filter::Gaussian { stddev: 0.5 },
            // Nothing in the outer half.
            Filter::Mitchell { b: 0.0, c: 0.0 },
            Filter::Lanczos { lobes: 3 },
        ];
        for filter in filters {
            let radius = filter.radius();
            for ends in [[-radius, radius], [-0.5, radius], [-0.3, 0.5]] {
                let table = FilterTable::new(filter, ends);
                for u in table.below.into_iter().filter(|&u| u < 1.0) {
                    let last = table.below.iter().rposition(|&below| below == u);
                    let expected = ends[0] + last.expect("one") as f64 * table.bin();
                    let [place, factor] = table.draw(u);
                    let what = format!("{filter:?} {ends:?}: {u} to {place}, {factor}");
                    assert!((place - expected).abs() < 1e-12, "{what}");
                    let weight = table.filter.eval(place) * factor;
                    assert!(weight.is_finite(), "{what}");
                }
            }
        }
    }
}
