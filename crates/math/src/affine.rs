//! Affine transforms, named by their spaces: `world_from_object`.

use std::fmt;
use std::ops::Mul;

use serde::{Deserialize, Serialize};

use crate::vec3::Vec3;

/// An affine map `p -> linear * p + translation`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Affine {
    /// Rows of the linear part.
    pub rows: [Vec3; 3],
    /// Image of the origin.
    pub translation: Vec3,
}

/// The upper three rows of the matrix.
impl fmt::Display for Affine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Vec3 { x, y, z } = self.translation;
        let row = |row: Vec3, end: f64| format!("[{:?}, {:?}, {:?}, {end:?}]", row.x, row.y, row.z);
        let [a, b, c] = self.rows;
        write!(f, "[{}, {}, {}]", row(a, x), row(b, y), row(c, z))
    }
}

impl Affine {
    /// The identity.
    pub const IDENTITY: Self = Self {
        rows: [
            Vec3::new(1.0, 0.0, 0.0),
            Vec3::new(0.0, 1.0, 0.0),
            Vec3::new(0.0, 0.0, 1.0),
        ],
        translation: Vec3::new(0.0, 0.0, 0.0),
    };

    /// Moves by `t`.
    pub fn translate(t: Vec3) -> Self {
        Self {
            translation: t,
            ..Self::IDENTITY
        }
    }

    /// Scales along the axes.
    pub fn scale(s: Vec3) -> Self {
        Self {
            rows: [
                Vec3::new(s.x, 0.0, 0.0),
                Vec3::new(0.0, s.y, 0.0),
                Vec3::new(0.0, 0.0, s.z),
            ],
            ..Self::IDENTITY
        }
    }

    /// True if the linear part is a rotation or reflection: the inner products of
    /// its rows differ from those of an orthonormal frame by less than
    /// `tolerance`. False if it is not finite.
    pub fn is_rigid(&self, tolerance: f64) -> bool {
        let [a, b, c] = self.rows;
        let products = [
            a.dot(a) - 1.0,
            b.dot(b) - 1.0,
            c.dot(c) - 1.0,
            a.dot(b),
            b.dot(c),
            c.dot(a),
        ];
        products.iter().all(|x| x.abs() < tolerance) // not for NaN
    }

    /// The largest angle of a turn, radians, whose sine means something: rounding turns it by
    /// 1e-10 then, and at 1e16 by more than a turn.
    pub const LARGEST_ANGLE: f64 = 1e6;

    /// Rotates by `angle` radians about `axis` (any length but zero),
    /// counter-clockwise when the axis points at the viewer.
    pub fn rotate(axis: Vec3, angle: f64) -> Self {
        Self::rodrigues(axis.normalized(), angle)
    }

    /// Rodrigues' formula with an axis of any length, in radians: a rotation for length 1,
    /// and what Mitsuba makes of other axes, which distorts.
    pub fn rodrigues(a: Vec3, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        // Rodrigues: R v = cos v + sin a×v + (1 - cos)(a·v) a
        let image = |v: Vec3| v * cos + a.cross(v) * sin + a * (a.dot(v) * (1.0 - cos));
        let (x, y, z) = (
            image(Vec3::new(1.0, 0.0, 0.0)),
            image(Vec3::new(0.0, 1.0, 0.0)),
            image(Vec3::new(0.0, 0.0, 1.0)),
        );
        Self {
            rows: [
                Vec3::new(x.x, y.x, z.x),
                Vec3::new(x.y, y.y, z.y),
                Vec3::new(x.z, y.z, z.z),
            ],
            translation: Vec3::new(0.0, 0.0, 0.0),
        }
    }

    /// Mitsuba's camera-to-world: `+z` looks at `target`, `+x` is
    /// `up × forward` (to the left of the image), `+y` is up.
    /// `None` if `up` is parallel to the view or the two points coincide.
    pub fn look_at(origin: Vec3, target: Vec3, up: Vec3) -> Option<Self> {
        let forward = (target - origin).normalized();
        let left = up.cross(forward).normalized();
        let up = forward.cross(left);
        (forward.is_finite() && left.is_finite()).then_some(Self {
            rows: [
                Vec3::new(left.x, up.x, forward.x),
                Vec3::new(left.y, up.y, forward.y),
                Vec3::new(left.z, up.z, forward.z),
            ],
            translation: origin,
        })
    }

    /// The image of a point.
    #[inline]
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.vector(p) + self.translation
    }

    /// The image of a vector (no translation).
    #[inline]
    pub fn vector(&self, v: Vec3) -> Vec3 {
        Vec3::new(
            self.rows[0].dot(v),
            self.rows[1].dot(v),
            self.rows[2].dot(v),
        )
    }

    /// The image of a surface normal, not normalised: cofactors times `n`,
    /// which keeps its side under reflections.
    pub fn normal(&self, n: Vec3) -> Vec3 {
        let [a, b, c] = self.rows;
        let cofactors = [b.cross(c), c.cross(a), a.cross(b)];
        let image = Vec3::new(
            cofactors[0].dot(n),
            cofactors[1].dot(n),
            cofactors[2].dot(n),
        );
        image * self.determinant().signum()
    }

    /// Determinant of the linear part; negative if the map mirrors.
    pub fn determinant(&self) -> f64 {
        self.rows[0].dot(self.rows[1].cross(self.rows[2]))
    }

    /// The inverse map, or `None` if the linear part is singular.
    pub fn inverse(&self) -> Option<Self> {
        let [a, b, c] = self.rows;
        let determinant = self.determinant();
        if determinant == 0.0 || !determinant.is_finite() {
            return None;
        }
        let scale = determinant.recip();
        let columns = [b.cross(c) * scale, c.cross(a) * scale, a.cross(b) * scale];
        let linear = Self {
            rows: [0, 1, 2].map(|i| Vec3::new(columns[0][i], columns[1][i], columns[2][i])),
            translation: Vec3::new(0.0, 0.0, 0.0),
        };
        Some(Self {
            translation: -linear.vector(self.translation),
            ..linear
        })
    }
}

/// `world_from_b * b_from_c`: the right one acts first.
impl Mul for Affine {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let column = |i: usize| self.vector(Vec3::new(b.rows[0][i], b.rows[1][i], b.rows[2][i]));
        let columns = [column(0), column(1), column(2)];
        Self {
            rows: [0, 1, 2].map(|i| Vec3::new(columns[0][i], columns[1][i], columns[2][i])),
            translation: self.point(b.translation),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_are_rigid() {
        let turn = Affine::rotate(Vec3::new(0.3, -1.0, 0.5), 0.7);
        assert!(turn.is_rigid(1e-14));
        let mut sheared = turn;
        sheared.rows[0] += sheared.rows[1] * 0.01;
        assert!(!sheared.is_rigid(1e-3) && sheared.is_rigid(0.02));
        assert!(!(turn * Affine::scale(Vec3::new(1.0, 1.5, 1.0))).is_rigid(1e-3));
        for row in 0..3 {
            let mut broken = turn;
            broken.rows[row].x = f64::NAN;
            assert!(!broken.is_rigid(1e9));
        }
    }

    fn example() -> Affine {
        Affine::translate(Vec3::new(1.0, -2.0, 0.5))
            * Affine::rotate(Vec3::new(0.3, 1.0, -0.4), 0.8)
            * Affine::scale(Vec3::new(2.0, -0.5, 3.0))
    }

    #[test]
    fn inverse_undoes() {
        let a = example();
        let p = Vec3::new(0.2, 0.7, -1.1);
        let back = a.inverse().expect("not singular").point(a.point(p));
        assert!((back - p).length() < 1e-14);
        assert!(Affine::scale(Vec3::new(1.0, 0.0, 1.0)).inverse().is_none());
    }

    /// A normal stays orthogonal to the tangents it was orthogonal to, and on
    /// their outer side even when the map mirrors.
    #[test]
    fn normals_stay_normal() {
        let a = example();
        let (s, t, out) = (
            Vec3::new(1.0, 0.2, 0.0),
            Vec3::new(0.0, 1.0, -0.3),
            Vec3::new(0.1, 0.2, 1.0),
        );
        let n = s.cross(t);
        assert!(n.dot(out) > 0.0);
        let image = a.normal(n);
        assert!(image.dot(a.vector(s)).abs() < 1e-14);
        assert!(image.dot(a.vector(t)).abs() < 1e-14);
        assert!(image.dot(a.vector(out)) > 0.0);
    }

    #[test]
    fn rotation_is_counter_clockwise() {
        let quarter = Affine::rotate(Vec3::new(0.0, 0.0, 2.0), std::f64::consts::FRAC_PI_2);
        let image = quarter.vector(Vec3::new(1.0, 0.0, 0.0));
        assert!((image - Vec3::new(0.0, 1.0, 0.0)).length() < 1e-15);
    }
}
