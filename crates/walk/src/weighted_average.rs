//! The field of earlier work in one dimension, Eqs. (7) and (8), for the toy of
//! Section 3.3: a weighted average of the velocities of all points.

use capwalk_math::quadrature::gauss_legendre;
use capwalk_math::{Dual, Real};

/// The weighted average over the line whose part from 0 to 1 is at rest and
/// whose part from 1 to 2 moves to the right with velocity 1.
///
/// Its velocity jumps at 1, as that of surfaces does at a silhouette. The
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
    pub fn value_and_slope(&self, x: f64) -> (f64, f64) {
        let x = Dual::<1>::variable(x, 0);
        let at_rest = self.weight(x, [0.0, x.value], 0.0) + self.weight(x, [x.value, 1.0], 0.0);
        let moving = self.weight(x, [1.0, 2.0], 1.0);
        let field = moving / (at_rest + moving);
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
            let (offset, stretch) = (half * t.powi(8), half * 8.0 * t.powi(7));
            for q in [from + offset, to - offset] {
                sum = sum + self.weight_of(x, q, q - end) * Dual::constant(w * stretch);
            }
        }
        sum
    }

    /// `1/(D + B)^γ`, Eq. (8).
    fn weight_of(&self, x: Dual<1>, q: f64, boundary_test: f64) -> Dual<1> {
        let d = x - Dual::constant(q);
        let exponent = d.squared() * Dual::constant(0.5 / self.width.powi(2));
        let distance = exponent.chain(exponent.value.exp_m1(), exponent.value.exp());
        let sum = distance + Dual::constant(boundary_test);
        (sum.ln() * Dual::constant(-self.power)).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slope_is_that_of_the_value() {
        for power in [1.0, 3.0] {
            let field = WeightedAverage { width: 0.1, power };
            for x in [0.03, 0.4, 0.8, 0.93, 0.99] {
                let h = 1e-4 * (1.0 - x);
                let [ahead, behind] = [x + h, x - h].map(|x| field.value_and_slope(x).0);
                let expected = (ahead - behind) / (2.0 * h);
                let slope = field.value_and_slope(x).1;
                let error = (slope - expected).abs();
                assert!(
                    error < 1e-3 * (1.0 + expected.abs()),
                    "{slope}, {expected} at {x}"
                );
            }
        }
    }
}
