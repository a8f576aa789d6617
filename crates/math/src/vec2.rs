//! Two-component vectors: points and tangents of the plane.

use std::f64::consts::PI;
use std::ops::{Add, Mul, Neg, Sub};

/// A vector or point in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec2 {
    /// First component.
    pub x: f64,
    /// Second component.
    pub y: f64,
}

impl Vec2 {
    /// A vector from its components.
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at `2π u` from the first axis, counter-clockwise.
    #[inline]
    pub fn unit(u: f64) -> Self {
        let (sin, cos) = (2.0 * PI * u).sin_cos();
        Self::new(cos, sin)
    }

    /// Inner product.
    #[inline]
    pub fn dot(self, b: Self) -> f64 {
        self.x * b.x + self.y * b.y
    }

    /// Euclidean length.
    #[inline]
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The unit vector in this direction; not finite for the zero vector.
    #[inline]
    pub fn normalized(self) -> Self {
        self * self.length().recip()
    }
}

impl Add for Vec2 {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        Self::new(self.x + b.x, self.y + b.y)
    }
}

impl Sub for Vec2 {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        Self::new(self.x - b.x, self.y - b.y)
    }
}

impl Neg for Vec2 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Self;
    #[inline]
    fn mul(self, s: f64) -> Self {
        Self::new(self.x * s, self.y * s)
    }
}
