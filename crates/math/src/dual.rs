//! Forward-mode derivatives.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::Real;

/// A value and its derivatives in `N` directions.
#[derive(Clone, Copy, Debug)]
pub struct Dual<const N: usize> {
    /// The value itself.
    pub value: f64,
    /// The derivative in each direction.
    pub tangent: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// A value with the given derivatives.
    #[inline]
    pub fn new(value: f64, tangent: [f64; N]) -> Self {
        Self { value, tangent }
    }

    /// The `i`-th independent variable: derivative one in direction `i`.
    #[inline]
    pub fn variable(value: f64, i: usize) -> Self {
        let mut tangent = [0.0; N];
        tangent[i] = 1.0;
        Self { value, tangent }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self::chain(self.value + b.value, [(self, 1.0), (b, 1.0)])
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self::chain(self.value - b.value, [(self, 1.0), (b, -1.0)])
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        Self::chain(self.value * b.value, [(self, b.value), (b, self.value)])
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let ratio = self.value / b.value;
        let inverse = b.value.recip();
        Self::chain(ratio, [(self, inverse), (b, -ratio * inverse)])
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::chain(-self.value, [(self, -1.0)])
    }
}

/// Duals compare by value: a derivative never steers a branch.
impl<const N: usize> PartialEq for Dual<N> {
    fn eq(&self, b: &Self) -> bool {
        self.value == b.value
    }
}

impl<const N: usize> PartialOrd for Dual<N> {
    #[inline]
    fn partial_cmp(&self, b: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&b.value)
    }
}

impl<const N: usize> Real for Dual<N> {
    #[inline]
    fn constant(value: f64) -> Self {
        Self {
            value,
            tangent: [0.0; N],
        }
    }
    #[inline]
    fn value(self) -> f64 {
        self.value
    }
    #[inline]
    fn is_constant(self) -> bool {
        self.tangent == [0.0; N]
    }
    #[inline]
    fn chain<const M: usize>(value: f64, terms: [(Self, f64); M]) -> Self {
        let along = |i: usize| {
            let parts = terms.iter().map(|(x, dx)| dx * x.tangent[i]);
            parts.reduce(|sum, part| sum + part).unwrap_or(0.0)
        };
        Self::new(value, std::array::from_fn(along))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every rule against a central difference of the same expression.
    #[test]
    fn rules_match_central_differences() {
        fn expression<R: Real>(x: R) -> R {
            let (sin, cos) = (x * x).sin_cos();
            (sin / (x + R::constant(2.0)) - cos * x.sqrt()) * (-x).exp()
        }
        for x in [0.3, 1.0, 2.7] {
            let h = 1e-6;
            let difference = (expression(x + h) - expression(x - h)) / (2.0 * h);
            let dual = expression(Dual::<1>::variable(x, 0));
            assert_eq!(dual.value, expression(x));
            assert!((dual.tangent[0] - difference).abs() < 1e-8, "at {x}");
        }
    }
}
