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

/// The boundary point that limits the ball around a point of the domain: in most domains the closest.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<S, V> {
    /// The boundary point, as the domain names it.
    pub site: S,
    /// Its place in the domain.
    pub point: V,
    /// The radius of the largest ball that it allows: in most domains its distance.
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

    /// The boundary point that allows the smallest ball, of a radius below `limit`, Eqs. (15) and (29). The radius
    /// is any function of `x` that is continuous, positive off the boundary, and zero on it.
    fn closest(&self, x: Self::Vector, limit: f64) -> Option<Nearest<Self::Site, Self::Vector>>;

    /// The radius that a boundary point allows at another point, if that is known without a search; the smallest
    /// there is at most that.
    fn radius_at(&self, x: Self::Vector, known: &Nearest<Self::Site, Self::Vector>) -> Option<f64>;

    /// True if the radius differs between two points by no more than their distance: then it is known far from all
    /// boundaries that a walk ends at none.
    fn is_distance(&self) -> bool {
        true
    }

    /// How the radius grows at `x`, where it is that of a boundary point; for a distance, the unit tangent away from
    /// that point.
    fn growth(&self, x: Self::Vector, nearest: &Nearest<Self::Site, Self::Vector>) -> Self::Vector;

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
