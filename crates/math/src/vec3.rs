//! Three-component vectors over any [`Real`].

use std::ops::{Add, AddAssign, Div, Index, Mul, Neg, Sub};

use crate::dual::Dual;
use crate::real::Real;

/// A vector, point or direction in space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Vec3<R = f64> {
    /// First component.
    pub x: R,
    /// Second component.
    pub y: R,
    /// Third component.
    pub z: R,
}

/// Linear radiance, reflectance or their derivatives: red, green, blue.
pub type Rgb<R = f64> = Vec3<R>;

impl<R> Vec3<R> {
    /// A vector from its components.
    #[inline]
    pub const fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }
}

impl<R: Real> Vec3<R> {
    /// The same number three times.
    #[inline]
    pub fn splat(v: R) -> Self {
        Self::new(v, v, v)
    }

    /// The zero vector.
    #[inline]
    pub fn zero() -> Self {
        Self::splat(R::constant(0.0))
    }

    /// A vector whose derivative is zero.
    #[inline]
    pub fn constant(v: Vec3) -> Self {
        v.map(R::constant)
    }

    /// The vector without its derivative.
    #[inline]
    pub fn value(self) -> Vec3 {
        self.map(R::value)
    }

    /// True if its derivatives are known to be zero.
    #[inline]
    pub fn is_constant(self) -> bool {
        self.x.is_constant() && self.y.is_constant() && self.z.is_constant()
    }

    /// Applies a function to each component.
    #[inline]
    pub fn map<S>(self, f: impl Fn(R) -> S) -> Vec3<S> {
        Vec3::new(f(self.x), f(self.y), f(self.z))
    }

    /// Inner product.
    #[inline]
    pub fn dot(self, b: Self) -> R {
        self.x * b.x + self.y * b.y + self.z * b.z
    }

    /// Cross product, right-handed.
    #[inline]
    pub fn cross(self, b: Self) -> Self {
        Self::new(
            self.y * b.z - self.z * b.y,
            self.z * b.x - self.x * b.z,
            self.x * b.y - self.y * b.x,
        )
    }

    /// Component-wise product, for colours.
    #[inline]
    pub fn hadamard(self, b: Self) -> Self {
        Self::new(self.x * b.x, self.y * b.y, self.z * b.z)
    }

    /// Squared Euclidean length.
    #[inline]
    pub fn length_squared(self) -> R {
        self.dot(self)
    }

    /// Euclidean length.
    #[inline]
    pub fn length(self) -> R {
        self.dot(self).sqrt()
    }

    /// The unit vector in this direction; not finite for the zero vector.
    #[inline]
    pub fn normalized(self) -> Self {
        self * (R::constant(1.0) / self.length())
    }

    /// The part orthogonal to the unit vector `q`: `(I - q qᵀ) self`.
    #[inline]
    pub fn reject_from(self, q: Self) -> Self {
        self - q * self.dot(q)
    }
}

impl Vec3 {
    /// True if no component is infinite or NaN.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }

    /// Component-wise minimum.
    #[inline]
    pub fn min(self, b: Self) -> Self {
        Self::new(self.x.min(b.x), self.y.min(b.y), self.z.min(b.z))
    }

    /// Component-wise maximum.
    #[inline]
    pub fn max(self, b: Self) -> Self {
        Self::new(self.x.max(b.x), self.y.max(b.y), self.z.max(b.z))
    }

    /// The largest component.
    #[inline]
    pub fn max_component(self) -> f64 {
        self.x.max(self.y).max(self.z)
    }

    /// The components as an array.
    #[inline]
    pub fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// A vector that carries the velocity `tangent`.
    #[inline]
    pub fn with_tangent(self, tangent: Vec3) -> Vec3<Dual<1>> {
        Vec3::new(
            Dual::new(self.x, [tangent.x]),
            Dual::new(self.y, [tangent.y]),
            Dual::new(self.z, [tangent.z]),
        )
    }
}

impl<const N: usize> Vec3<Dual<N>> {
    /// The derivative in the `i`-th direction.
    #[inline]
    pub fn tangent(self, i: usize) -> Vec3 {
        Vec3::new(self.x.tangent[i], self.y.tangent[i], self.z.tangent[i])
    }
}

impl From<[f64; 3]> for Vec3 {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<R> Index<usize> for Vec3<R> {
    type Output = R;
    #[inline]
    fn index(&self, axis: usize) -> &R {
        match axis {
            0 => &self.x,
            1 => &self.y,
            2 => &self.z,
            _ => panic!("axis {axis} of a three-component vector"),
        }
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self::new(self.x + b.x, self.y + b.y, self.z + b.z)
    }
}

impl<R: Real> AddAssign for Vec3<R> {
    #[inline]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self::new(self.x - b.x, self.y - b.y, self.z - b.z)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;
    #[inline]
    fn mul(self, s: R) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
}

impl<R: Real> Div<R> for Vec3<R> {
    type Output = Self;
    #[inline]
    fn div(self, s: R) -> Self {
        Self::new(self.x / s, self.y / s, self.z / s)
    }
}
