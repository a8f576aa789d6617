//! Orthonormal frames.

use crate::real::Real;
use crate::vec3::Vec3;

/// Normals whose `z` is less than this have the frames of those that point down. Not zero: there rounding
/// would decide at upright walls, on each device in another way.
pub const POINTS_DOWN: f64 = -1e-5;

/// Three orthonormal directions, right-handed: `s × t = n`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<R = f64> {
    /// First tangent.
    pub s: Vec3<R>,
    /// Second tangent.
    pub t: Vec3<R>,
    /// The direction the frame was built around.
    pub n: Vec3<R>,
}

impl<R: Real> Frame<R> {
    /// A frame whose third axis is the unit vector `n`; continuous except
    /// across `n.z = -1e-5`. Duff et al. 2017, "Building an Orthonormal Basis,
    /// Revisited", where it is zero.
    #[inline]
    pub fn from_normal(n: Vec3<R>) -> Self {
        let one = R::constant(1.0);
        let sign = R::constant(if n.z.value() < POINTS_DOWN { -1.0 } else { 1.0 });
        let a = -one / (sign + n.z);
        let b = n.x * n.y * a;
        Self {
            s: Vec3::new(one + sign * n.x * n.x * a, sign * b, -(sign * n.x)),
            t: Vec3::new(b, sign + n.y * n.y * a, -n.y),
            n,
        }
    }

    /// A frame whose third axis is the unit vector `n`, and whose first one is
    /// the part of `tangent` orthogonal to it; [`Frame::from_normal`] if there is
    /// none.
    pub fn from_normal_and_tangent(n: Vec3<R>, tangent: Vec3<R>) -> Self {
        let s = tangent.reject_from(n);
        let is_usable = s.value().length_squared() > 0.0; // not for NaN
        if !is_usable {
            return Self::from_normal(n);
        }
        let s = s.normalized();
        Self {
            s,
            t: n.cross(s),
            n,
        }
    }

    /// A vector given in the frame's coordinates, in world coordinates.
    #[inline]
    pub fn to_world(&self, v: Vec3<R>) -> Vec3<R> {
        self.s * v.x + self.t * v.y + self.n * v.z
    }

    /// A world vector in the frame's coordinates.
    #[inline]
    pub fn to_local(&self, v: Vec3<R>) -> Vec3<R> {
        Vec3::new(self.s.dot(v), self.t.dot(v), self.n.dot(v))
    }

    /// The frame without its derivative.
    #[inline]
    pub fn value(&self) -> Frame {
        Frame {
            s: self.s.value(),
            t: self.t.value(),
            n: self.n.value(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_orthonormal_and_right_handed() {
        for n in [
            Vec3::new(0.0, 0.0, 1.0),
            Vec3::new(0.0, 0.0, -1.0),
            Vec3::new(0.6, -0.48, 0.64),
            Vec3::new(1.0, 0.0, -0.0),
            Vec3::new(0.6, 0.8, -1e-6).normalized(),
            Vec3::new(0.8, -0.6, -2e-5).normalized(),
        ] {
            let frame = Frame::from_normal(n);
            assert!((frame.s.cross(frame.t) - n).length() < 1e-15);
            assert!((frame.s.length() - 1.0).abs() < 1e-15);
            assert!(frame.s.dot(frame.t).abs() < 1e-15);
            let v = Vec3::new(0.3, 2.0, -0.7);
            assert!((frame.to_world(frame.to_local(v)) - v).length() < 1e-14);
        }
    }

    /// Rounding moves the normal of an upright wall, and its frame by no more.
    #[test]
    fn is_continuous_at_upright_walls() {
        for [x, y] in [[1.0, 0.0], [0.0, 1.0], [0.6, -0.8], [-0.8, -0.6]] {
            let frame = |z: f64| Frame::from_normal(Vec3::new(x, y, z).normalized());
            let upright = frame(0.0);
            for z in [-0.0, 1e-6, -1e-6] {
                let turned = frame(z);
                assert!((turned.s - upright.s).length() <= 2.0 * z.abs());
                assert!((turned.t - upright.t).length() <= 2.0 * z.abs());
            }
        }
    }
}
