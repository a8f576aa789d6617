//! The scalar that all smooth code is generic over.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::special;

/// A real number that may carry derivatives.
///
/// Implemented for `f32`, `f64`, [`Dual`](crate::dual::Dual) and
/// [`Var`](crate::tape::Var). Only the
/// functions the renderer uses are listed: the trait is a menu, not a
/// numeric tower. Comparison is by value: a derivative never steers a branch.
pub trait Real:
    Copy
    + std::fmt::Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A constant: its derivative is zero.
    fn constant(value: f64) -> Self;
    /// The value without its derivative. Use it for every branch and every
    /// sampling decision, so that both stay detached.
    fn value(self) -> f64;
    /// True if its derivatives are known to be zero.
    fn is_constant(self) -> bool;
    /// A function of some numbers by the chain rule: its value here, and the numbers
    /// with its partial derivative in each.
    fn chain<const N: usize>(value: f64, terms: [(Self, f64); N]) -> Self;

    /// Square root.
    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value().sqrt();
        Self::chain(root, [(self, 0.5 / root)])
    }
    /// Sine and cosine.
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value().sin_cos();
        (
            Self::chain(sin, [(self, cos)]),
            Self::chain(cos, [(self, -sin)]),
        )
    }
    /// The exponential function.
    #[inline]
    fn exp(self) -> Self {
        let exp = self.value().exp();
        Self::chain(exp, [(self, exp)])
    }
    /// Natural logarithm.
    #[inline]
    fn ln(self) -> Self {
        let x = self.value();
        Self::chain(x.ln(), [(self, x.recip())])
    }
    /// The error function and its derivative, `2 / √π exp(-x²)`.
    #[inline]
    fn erf_and_derivative(self) -> [Self; 2] {
        let x = self.value();
        let [value, derivative] = special::erf_and_derivative(x);
        [
            Self::chain(value, [(self, derivative)]),
            Self::chain(derivative, [(self, -2.0 * x * derivative)]),
        ]
    }
    /// Absolute value; at zero it has the derivative from above.
    #[inline]
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
    /// The square.
    #[inline]
    fn squared(self) -> Self {
        self * self
    }
}

macro_rules! impl_real_for_float {
    ($float:ty) => {
        impl Real for $float {
            #[inline]
            fn constant(value: f64) -> Self {
                value as $float
            }
            #[inline]
            fn value(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn is_constant(self) -> bool {
                true
            }
            #[inline]
            fn chain<const N: usize>(value: f64, _: [(Self, f64); N]) -> Self {
                value as $float
            }
        }
    };
}
impl_real_for_float!(f32);
impl_real_for_float!(f64);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dual::Dual;
    use crate::tape::Tape;

    fn expression<R: Real>(x: R) -> R {
        let [erf, derivative] = x.erf_and_derivative();
        (x.ln() * erf + derivative + (x - R::constant(1.0)).abs()).squared()
    }

    /// The functions of one argument: duals and tapes against central
    /// differences, and single precision against double.
    #[test]
    fn functions_match_central_differences() {
        for x in [0.2, 0.9, 1.4, 3.0] {
            let h = 1e-6;
            let difference = (expression(x + h) - expression(x - h)) / (2.0 * h);
            let dual = expression(Dual::<1>::variable(x, 0));
            assert_eq!(dual.value, expression(x));
            assert!((dual.tangent[0] - difference).abs() < 1e-8, "at {x}");
            assert!((f64::from(expression(x as f32)) - expression(x)).abs() < 1e-5);

            let tape = Tape::default();
            let var = tape.variable(x);
            let result = expression(var);
            let mut adjoints = tape.adjoints();
            adjoints.add(result, 1.0);
            tape.sweep(&mut adjoints, 0..tape.len());
            assert!((adjoints.of(var) - dual.tangent[0]).abs() < 1e-12);
        }
    }
}
