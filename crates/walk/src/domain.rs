//! What a walk needs to know of the space it walks in.

use std::ops::{Add, Mul, Neg, Sub};

use capwalk_math::{Vec2, Vec3};

/// Ambient vectors of a domain: numbers, or vectors of the space around it.
pub trait Vector:
    Copy
    + std::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<f64, Output = Self>
{
    /// All components 0.
    const ZERO: Self;
    /// Inner product.
    fn dot(self, other: Self) -> f64;
}

impl Vector for f64 {
    const ZERO: Self = 0.0;
    fn dot(self, other: Self) -> f64 {
        self * other
    }
}

impl Vector for Vec2 {
    const ZERO: Self = Vec2::new(0.0, 0.0);
    #[inline]
    fn dot(self, other: Self) -> f64 {
        Vec2::dot(self, other)
    }
}

impl Vector for Vec3 {
    const ZERO: Self = Vec3::new(0.0, 0.0, 0.0);
    #[inline]
    fn dot(self, other: Self) -> f64 {
        Vec3::dot(self, other)
    }
}

/// The boundary point closest to a point of the domain.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<S, V> {
    /// The boundary point, as the domain names it.
    pub site: S,
    /// Its place in the domain.
    pub point: V,
    /// Its distance along the domain.
    pub distance: f64,
}

/// A space with balls: an interval, the plane, the sphere of directions.
///
/// Points and tangents are ambient vectors. With `κ = |rim| / |ball|`, the
/// derivative of the mean over the largest empty ball (Eqs. 27 and 34) is the
/// same expression in all of them, see [`crate::fixed_step`].
pub trait Domain {
    /// Points and tangents.
    type Vector: Vector;
    /// How a boundary point is named: enough for a caller to know its velocity.
    type Site: Copy;

    /// The closest boundary point nearer than `limit`, Eqs. (15) and (29).
    fn closest(&self, x: Self::Vector, limit: f64) -> Option<Nearest<Self::Site, Self::Vector>>;

    /// Distance of two points along the domain: radians on the sphere.
    fn distance(&self, x: Self::Vector, y: Self::Vector) -> f64;

    /// The unit tangent at `x` towards `y`.
    fn towards(&self, x: Self::Vector, y: Self::Vector) -> Self::Vector;

    /// A uniformly distributed unit tangent at `x`; `azimuth + 0.5` (modulo 1)
    /// gives the opposite one.
    fn tangent(&self, x: Self::Vector, azimuth: f64) -> Self::Vector;

    /// The point at `distance` from `x` along the unit tangent `e`.
    fn walk(&self, x: Self::Vector, e: Self::Vector, distance: f64) -> Self::Vector;

    /// Distance from the centre of a uniform point inside a ball.
    fn radius_inside(&self, radius: f64, u: f64) -> f64;

    /// `κ`: size of a ball's rim over size of the ball.
    fn rim_over_ball(&self, radius: f64) -> f64;

    /// The covector `b` such that `div(P v) = (sum of d·∂_d v) + b·v`, where
    /// `P` projects on the tangent space at `x`; zero in flat domains.
    fn curvature(&self, x: Self::Vector) -> Self::Vector;
}
