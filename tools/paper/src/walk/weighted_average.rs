//! The field of earlier work in one dimension, Eqs. (7) and (8), for the toy of
//! Section 3.3: a weighted average of the velocities of all points.

use capwalk_math::quadrature::gauss_legendre;
use capwalk_math::{Dual, Real};

/// The weighted average over the line whose part from 0 to 1 does not move and
/// whose part from 1 to 2 moves to the right with velocity 1.
///
/// Its velocity is discontinuous at 1, as that of surfaces is at a silhouette. The
/// weights are `1/(D + B)^γ` with Bangaru et al.'s `D = exp(d²/2σ²) - 1` of the
/// distance `d` to the point, and with the boundary test `B` of a point: its
/// distance to the end of its own part, 0 or 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedAverage {
    /// `σ`, the width of the weights.
    pub width: f64,
    /// `γ`, the power of the weights: 1 in Eq. (8), 3 in the programs of
    /// earlier work. With 1 the field reaches the boundary's velocity only as a
    /// logarithm does.
    pub power: f64,
}

impl Default for WeightedAverage {
    fn default() -> Self {
        Self {
            width: 0.1,
            power: 3.0,
        }
    }
}

impl WeightedAverage {
    /// The field and its derivative at `x`, inside `(0, 1)`, by quadrature; to
    /// about 1e-6.
    pub fn value_and_derivative(&self, x: f64) -> (f64, f64) {
        let x = Dual::<1>::variable(x, 0);
        let stationary = self.weight(x, [0.0, x.value], 0.0) + self.weight(x, [x.value, 1.0], 0.0);
        let moving = self.weight(x, [1.0, 2.0], 1.0);
        let field = moving / (stationary + moving);
        (field.value, field.tangent[0])
    }

    /// The ratio estimate of the field and its derivative at `x` from some points
    /// of `[0, 2]`, uniformly distributed: what programs use. Biased, because the
    /// mean of a ratio is not the ratio of the means (Section 3.2).
    pub fn estimate(&self, x: f64, points: impl IntoIterator<Item = f64>) -> (f64, f64) {
        let x = Dual::<1>::variable(x, 0);
        let mut all = Dual::constant(0.0);
        let mut moving = Dual::constant(0.0);
        for q in points {
            let end = if q < 1.0 { 0.0 } else { 1.0 };
            let weight = self.weight_of(x, q, q - end);
            all = all + weight;
            if q >= 1.0 {
                moving = moving + weight;
            }
        }
        let field = moving / all;
        (field.value, field.tangent[0])
    }

    /// The integral of the weights of the points of an interval, which belong
    /// to the part that begins at `end`.
    fn weight(&self, x: Dual<1>, [from, to]: [f64; 2], end: f64) -> Dual<1> {
        // Weights are steep at x and at the ends, which are ends of intervals:
        // nodes crowd there like t⁸.
        const NODES: usize = 160;
        let half = 0.5 * (to - from);
        let mut sum = Dual::constant(0.0);
        for (t, w) in gauss_legendre(NODES) {
            let (offset, jacobian) = (half * t.powi(8), half * 8.0 * t.powi(7));
            for q in [from + offset, to - offset] {
                sum = sum + self.weight_of(x, q, q - end) * Dual::constant(w * jacobian);
            }
        }
        sum
    }

    /// `1/(D + B)^γ`, Eq. (8).
    fn weight_of(&self, x: Dual<1>, q: f64, boundary_test: f64) -> Dual<1> {
        let d = x - Dual::constant(q);
        let exponent = d.squared() * Dual::constant(0.5 / self.width.powi(2));
        let distance = Dual::chain(exponent.value.exp_m1(), [(exponent, exponent.value.exp())]);
        let sum = distance + Dual::constant(boundary_test);
        (sum.ln() * Dual::constant(-self.power)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From many points it is the field, from eight it is not.
    #[test]
    fn the_ratio_is_consistent_but_biased() {
        let field = WeightedAverage::default();
        let exact = field.value_and_derivative(0.9).0;
        let evenly = |n: u32| (0..n).map(move |i| 2.0 * (f64::from(i) + 0.5) / f64::from(n));
        let many = field.estimate(0.9, evenly(2_000_000)).0;
        assert!((many - exact).abs() < 1e-4, "{many} {exact}");
        // The mean over all shifts of eight even points.
        let shifts = 1000;
        let shifted = (0..shifts).map(|k| {
            let shift = (f64::from(k) + 0.5) / f64::from(shifts) * 0.25;
            let points = (0..8).map(move |i| 0.25 * f64::from(i) + shift);
            field.estimate(0.9, points).0 / f64::from(shifts)
        });
        let few = shifted.sum::<f64>();
        assert!((few - exact).abs() > 0.05, "{few} {exact}");
    }

    #[test]
    fn derivative_is_that_of_the_value() {
        for power in [1.0, 3.0] {
            let field = WeightedAverage { width: 0.1, power };
            for x in [0.03, 0.4, 0.8, 0.93, 0.99] {
                let h = 1e-4 * (1.0 - x);
                let [ahead, behind] = [x + h, x - h].map(|x| field.value_and_derivative(x).0);
                let expected = (ahead - behind) / (2.0 * h);
                let derivative = field.value_and_derivative(x).1;
                let error = (derivative - expected).abs();
                assert!(
                    error < 1e-3 * (1.0 + expected.abs()),
                    "{derivative}, {expected} at {x}"
                );
            }
        }
    }
}
