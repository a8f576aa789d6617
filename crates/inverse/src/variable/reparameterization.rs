//! What is between unknowns and values: nothing, bounds, a curve, or smoothing.

use crate::smooth::Smoother;

/// What is between unknowns and values.
#[derive(Clone, Debug)]
pub enum Reparameterization {
    /// They are the same.
    None,
    /// They are the same, and each step ends between these bounds (projected
    /// Adam).
    Clamp([f64; 2]),
    /// `low + (high - low) / (1 + e⁻ᵘ)`: always between these bounds.
    Sigmoid([f64; 2]),
    /// The unknown is the logarithm of the value: always above 0.
    Log,
    /// Large steps: the unknowns are `(I + λL)` times the values, in rows of so
    /// many numbers.
    Smooth {
        /// The matrix.
        smoother: Smoother,
        /// Numbers in a row.
        dims: usize,
    },
}

impl Reparameterization {
    /// The values of these unknowns.
    pub fn values(&self, unknowns: &[f64]) -> Vec<f64> {
        let each = |f: &dyn Fn(f64) -> f64| unknowns.iter().map(|&u| f(u)).collect();
        match self {
            Self::None | Self::Clamp(_) => unknowns.to_vec(),
            Self::Sigmoid([low, high]) => each(&|u| low + (high - low) * logistic(u)),
            Self::Log => each(&f64::exp),
            Self::Smooth { smoother, dims } => smoother.solve(unknowns, *dims),
        }
    }

    /// The unknowns of these values. Values at or beyond a bound of the sigmoid
    /// give infinities: refuse them before.
    pub fn unknowns(&self, values: &[f64]) -> Vec<f64> {
        let each = |f: &dyn Fn(f64) -> f64| values.iter().map(|&x| f(x)).collect();
        match self {
            Self::None | Self::Clamp(_) => values.to_vec(),
            Self::Sigmoid([low, high]) => each(&|x| ((x - low) / (high - x)).ln()),
            Self::Log => each(&f64::ln),
            Self::Smooth { smoother, dims } => smoother.multiply(values, *dims),
        }
    }

    /// The derivative with respect to each unknown from that with respect to each value.
    pub fn pull(&self, unknowns: &[f64], by_values: &[f64]) -> Vec<f64> {
        let times = |f: &dyn Fn(f64) -> f64| {
            let pairs = unknowns.iter().zip(by_values);
            pairs.map(|(&u, g)| f(u) * g).collect()
        };
        match self {
            Self::None | Self::Clamp(_) => by_values.to_vec(),
            Self::Sigmoid([low, high]) => times(&|u| (high - low) * logistic(u) * logistic(-u)),
            Self::Log => times(&f64::exp),
            // The matrix is symmetric.
            Self::Smooth { smoother, dims } => smoother.solve(by_values, *dims),
        }
    }

    /// Puts unknowns back between their bounds.
    pub fn clamp(&self, unknowns: &mut [f64]) {
        if let Self::Clamp([low, high]) = self {
            unknowns.iter_mut().for_each(|u| *u = u.clamp(*low, *high));
        }
    }

    /// Which values it can start from, and the first that is none of them.
    pub fn refused(&self, values: &[f64]) -> Option<(f64, String)> {
        let first = |allowed: &dyn Fn(f64) -> bool, text: String| {
            let bad = values.iter().find(|&&x| !allowed(x));
            bad.map(|&x| (x, text))
        };
        match self {
            Self::None | Self::Smooth { .. } => first(&f64::is_finite, "finite numbers".into()),
            Self::Clamp([low, high]) => first(
                &|x| (*low..=*high).contains(&x),
                format!("numbers from {low} to {high}"),
            ),
            Self::Sigmoid([low, high]) => first(
                &|x| *low < x && x < *high,
                format!("numbers between {low} and {high}, without the ends"),
            ),
            Self::Log => first(&|x| x > 0.0 && x.is_finite(), "numbers above 0".into()),
        }
    }
}

fn logistic(u: f64) -> f64 {
    1.0 / (1.0 + (-u).exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<Reparameterization> {
        let edges = [[0, 1], [1, 2]];
        let smoother = Smoother::new(3, &edges, 4.0).expect("positive definite");
        vec![
            Reparameterization::None,
            Reparameterization::Clamp([-1.0, 2.0]),
            Reparameterization::Sigmoid([-1.0, 3.0]),
            Reparameterization::Log,
            Reparameterization::Smooth { smoother, dims: 1 },
        ]
    }

    /// There and back, and the pull is the transpose of the derivative:
    /// `<J v, y> = <v, Jᵀ y>`, with `J v` by central differences.
    #[test]
    fn pulls_are_transposes() {
        let (values, v, y) = ([0.3, 1.7, 0.9], [0.4, -1.0, 0.2], [1.1, 0.6, -0.7]);
        for map in all() {
            let unknowns = map.unknowns(&values);
            for (a, b) in map.values(&unknowns).iter().zip(values) {
                assert!((a - b).abs() < 1e-14, "{map:?}");
            }
            let at = |h: f64| {
                let moved: Vec<f64> = unknowns.iter().zip(v).map(|(u, v)| u + h * v).collect();
                map.values(&moved)
            };
            let differences = at(1e-6).into_iter().zip(at(-1e-6));
            let left: f64 = differences
                .zip(y)
                .map(|((a, b), y)| y * (a - b) / 2e-6)
                .sum();
            let pulled = map.pull(&unknowns, &y);
            let right: f64 = pulled.iter().zip(v).map(|(g, v)| g * v).sum();
            assert!((left - right).abs() < 1e-8, "{map:?}: {left} {right}");
        }
    }

    #[test]
    fn steps_end_between_bounds() {
        let mut unknowns = [-3.0, 0.5, 9.0];
        Reparameterization::Clamp([-1.0, 2.0]).clamp(&mut unknowns);
        assert_eq!(unknowns, [-1.0, 0.5, 2.0]);
    }

    #[test]
    fn impossible_starts_are_refused() {
        for (map, good, bad) in [
            (Reparameterization::Clamp([0.0, 1.0]), 1.0, 1.1),
            (Reparameterization::Sigmoid([0.0, 1.0]), 0.99, 1.0),
            (Reparameterization::Log, 1e-9, 0.0),
            (Reparameterization::None, -1e9, f64::NAN),
        ] {
            assert_eq!(map.refused(&[good]), None, "{map:?}");
            let (value, _) = map.refused(&[good, bad]).expect("refused");
            assert_eq!(value.to_bits(), bad.to_bits(), "{map:?}");
        }
    }
}
