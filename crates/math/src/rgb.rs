//! Colours over any [`Real`].

use std::ops::{Add, AddAssign, Div, Index, Mul, Sub};

use serde::{Deserialize, Serialize};

use crate::dual::Dual;
use crate::real::Real;

/// Linear red, green and blue: a radiance, a reflectance, or a derivative of one.
///
/// The product of two colours is taken channel by channel, as light is filtered:
///
/// ```
/// use capwalk_math::Rgb;
/// let light = Rgb::new(4.0, 2.0, 1.0) * Rgb::new(0.5, 0.5, 0.0);
/// assert_eq!(light.to_array(), [2.0, 1.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[repr(C)]
pub struct Rgb<R = f64> {
    /// Red.
    pub r: R,
    /// Green.
    pub g: R,
    /// Blue.
    pub b: R,
}

impl<R> Rgb<R> {
    /// A colour from its channels.
    #[inline]
    pub const fn new(r: R, g: R, b: R) -> Self {
        Self { r, g, b }
    }

    /// Red, green and blue.
    #[inline]
    pub fn to_array(self) -> [R; 3] {
        [self.r, self.g, self.b]
    }

    /// Applies a function to red, then to green, then to blue.
    #[inline]
    pub fn map<S>(self, mut f: impl FnMut(R) -> S) -> Rgb<S> {
        Rgb::new(f(self.r), f(self.g), f(self.b))
    }
}

/// Share of each channel in the luminance of linear sRGB, as Mitsuba and pbrt round it.
pub const LUMINANCE: Rgb = Rgb::new(0.212671, 0.715160, 0.072169);

impl<R: Real> Rgb<R> {
    /// Grey: one number in all channels.
    #[inline]
    pub fn splat(v: R) -> Self {
        Self::new(v, v, v)
    }

    /// Black.
    #[inline]
    pub fn zero() -> Self {
        Self::splat(R::constant(0.0))
    }

    /// A colour whose derivative is zero.
    #[inline]
    pub fn constant(c: Rgb) -> Self {
        c.map(R::constant)
    }

    /// The colour without its derivative.
    #[inline]
    pub fn value(self) -> Rgb {
        self.map(R::value)
    }

    /// The sum of the products of the channels.
    #[inline]
    pub fn dot(self, b: Self) -> R {
        let (u, v) = (self.value(), b.value());
        let (a, value) = (self, u.r * v.r + u.g * v.g + u.b * v.b);
        let [r, g, blue] = [(a.r, v.r), (a.g, v.g), (a.b, v.b)];
        R::chain(value, [r, g, blue, (b.r, u.r), (b.g, u.g), (b.b, u.b)])
    }

    /// Luminance of linear sRGB; 1 for white.
    #[inline]
    pub fn luminance(self) -> R {
        let value = self.value().dot(LUMINANCE);
        let [r, g, b] = [LUMINANCE.r, LUMINANCE.g, LUMINANCE.b];
        R::chain(value, [(self.r, r), (self.g, g), (self.b, b)])
    }
}

impl Rgb {
    /// The mean of the channels.
    #[inline]
    pub fn mean(self) -> f64 {
        (self.r + self.g + self.b) / 3.0
    }

    /// True if no channel is infinite or NaN.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.to_array().into_iter().all(f64::is_finite)
    }

    /// Euclidean length of the three channels, to tell how far apart two colours are.
    #[inline]
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The largest channel.
    #[inline]
    pub fn max_component(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }

    /// A colour that changes by `tangent` per unit of one parameter.
    #[inline]
    pub fn with_tangent(self, tangent: Rgb) -> Rgb<Dual<1>> {
        Rgb::new(
            Dual::new(self.r, [tangent.r]),
            Dual::new(self.g, [tangent.g]),
            Dual::new(self.b, [tangent.b]),
        )
    }
}

impl<const N: usize> Rgb<Dual<N>> {
    /// The derivative in the `i`-th direction.
    #[inline]
    pub fn tangent(self, i: usize) -> Rgb {
        self.map(|channel| channel.tangent[i])
    }
}

impl<R> From<[R; 3]> for Rgb<R> {
    fn from([r, g, b]: [R; 3]) -> Self {
        Self::new(r, g, b)
    }
}

/// Channel 0 is red, 1 green, 2 blue.
impl<R> Index<usize> for Rgb<R> {
    type Output = R;
    #[inline]
    fn index(&self, channel: usize) -> &R {
        match channel {
            0 => &self.r,
            1 => &self.g,
            2 => &self.b,
            _ => panic!("channel {channel} of a colour"),
        }
    }
}

impl<R: Real> Add for Rgb<R> {
    type Output = Self;
    #[inline]
    fn add(self, c: Self) -> Self {
        Self::new(self.r + c.r, self.g + c.g, self.b + c.b)
    }
}

impl<R: Real> AddAssign for Rgb<R> {
    #[inline]
    fn add_assign(&mut self, c: Self) {
        *self = *self + c;
    }
}

impl<R: Real> Sub for Rgb<R> {
    type Output = Self;
    #[inline]
    fn sub(self, c: Self) -> Self {
        Self::new(self.r - c.r, self.g - c.g, self.b - c.b)
    }
}

/// The product channel by channel.
impl<R: Real> Mul for Rgb<R> {
    type Output = Self;
    #[inline]
    fn mul(self, c: Self) -> Self {
        Self::new(self.r * c.r, self.g * c.g, self.b * c.b)
    }
}

impl<R: Real> Mul<R> for Rgb<R> {
    type Output = Self;
    #[inline]
    fn mul(self, s: R) -> Self {
        Self::new(self.r * s, self.g * s, self.b * s)
    }
}

impl<R: Real> Div<R> for Rgb<R> {
    type Output = Self;
    #[inline]
    fn div(self, s: R) -> Self {
        Self::new(self.r / s, self.g / s, self.b / s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tape::Tape;

    /// Products and luminance have the derivatives of their formulas, channel by
    /// channel, forward and on a tape.
    #[test]
    fn methods_have_the_derivatives_of_their_formulas() {
        fn methods<R: Real>(a: Rgb<R>, b: Rgb<R>) -> R {
            (a * b).luminance() + a.dot(b)
        }
        let (a, b) = (Rgb::new(0.3, 1.2, 0.7), Rgb::new(0.4, -0.9, 2.1));
        let expected = LUMINANCE.map(|share| share + 1.0) * b;
        let tape = Tape::default();
        let recorded = a.map(|channel| tape.variable(channel));
        let result = methods(recorded, Rgb::constant(b));
        let mut adjoints = tape.adjoints();
        adjoints.add(result, 1.0);
        tape.sweep(&mut adjoints, 0..tape.len());
        let reverse = recorded.map(|channel| adjoints.of(channel));
        assert!((reverse - expected).length() < 1e-15);
        for channel in 0..3 {
            let along = Rgb::from([0, 1, 2].map(|i| f64::from(i == channel)));
            let forward = methods(a.with_tangent(along), Rgb::constant(b));
            assert_eq!(forward.value, methods(a, b));
            assert!((forward.tangent[0] - expected[channel]).abs() < 1e-15);
        }
    }
}
