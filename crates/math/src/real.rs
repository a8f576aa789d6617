//! The scalar that all smooth code is generic over.

use std::ops::{Add, Div, Mul, Neg, Sub};

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
    /// Square root.
    fn sqrt(self) -> Self;
    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);
    /// The exponential function.
    fn exp(self) -> Self;
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
            fn sqrt(self) -> Self {
                self.sqrt()
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                self.sin_cos()
            }
            #[inline]
            fn exp(self) -> Self {
                self.exp()
            }
        }
    };
}
impl_real_for_float!(f32);
impl_real_for_float!(f64);
