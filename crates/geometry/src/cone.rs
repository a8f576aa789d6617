//! Cones of face normals: which views see no silhouette in a group of edges.

use capwalk_math::Vec3;

/// A cone that contains normals of faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalCone {
    /// Unit vector.
    pub axis: Vec3,
    /// Sine of the largest angle between the axis and a normal, at most a
    /// right angle; infinite if there is no such cone.
    pub sin: f64,
}

impl NormalCone {
    /// The cone of nothing in particular: all views may see silhouettes.
    pub const ALL: Self = Self {
        axis: Vec3::new(0.0, 0.0, 1.0),
        sin: f64::INFINITY,
    };

    /// A cone of the unit normals, around their mean; [`ALL`](Self::ALL) if
    /// some of them are a right angle or more from it. `None` among the
    /// normals stands for an edge that always is a silhouette.
    pub fn around<I: Iterator<Item = Option<Vec3>>>(normals: impl Fn() -> I) -> Self {
        let Some(sum) = normals().try_fold(Vec3::zero(), |sum, n| Some(sum + n?)) else {
            return Self::ALL;
        };
        if sum == Vec3::zero() {
            return Self::ALL;
        }
        let axis = sum.normalized();
        let mut sin = 0.0_f64;
        for normal in normals().flatten() {
            let is_within_right_angle = axis.dot(normal) > 0.0; // false for NaN
            if !is_within_right_angle {
                return Self::ALL;
            }
            sin = sin.max(axis.cross(normal).length());
        }
        Self { axis, sin }
    }

    /// For edges within `radius` of a centre, and in planes that pass the centre
    /// within `height`: the number `k` such that none of the edges, if their
    /// normals are in the cone, is a silhouette if the vector `v` from the viewpoint
    /// to the centre has
    ///
    ///   |axis · v| > sin |v| + k.
    ///
    /// The viewpoint lies on the same side of all planes if `n · v > height` for all
    /// normals `n`. The least `n · v` is `x cos - √(v² - x²) sin` with
    /// `x = axis · v`; it vanishes at `x = sin |v|` and grows from there at
    /// least like `x cos`, hence `k = height / cos`. By the angle that the
    /// sphere around the centre subtends, `k = radius cos` also does.
    pub fn view_margin(&self, radius: f64, height: f64) -> f64 {
        if !self.sin.is_finite() {
            return f64::INFINITY;
        }
        let cos = (1.0 - self.sin * self.sin).max(0.0).sqrt();
        (height / cos).min(radius * cos)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cone(normals: &[Option<Vec3>]) -> NormalCone {
        NormalCone::around(|| normals.iter().copied())
    }

    const X: Vec3 = Vec3::new(1.0, 0.0, 0.0);
    const Y: Vec3 = Vec3::new(0.0, 1.0, 0.0);

    /// Two orthogonal normals: half a right angle around their middle.
    #[test]
    fn cone_of_two_normals() {
        let cone = cone(&[Some(X), Some(Y)]);
        assert!((cone.axis - (X + Y).normalized()).length() < 1e-15);
        assert!((cone.sin - 0.5_f64.sqrt()).abs() < 1e-15);
    }

    /// Opposite normals, or an edge that always counts: no cone, no margin.
    #[test]
    fn no_cone() {
        assert_eq!(cone(&[Some(X), Some(-X)]), NormalCone::ALL);
        assert_eq!(cone(&[Some(X), None]), NormalCone::ALL);
        assert_eq!(cone(&[]), NormalCone::ALL);
        assert_eq!(NormalCone::ALL.view_margin(0.0, 0.0), f64::INFINITY);
    }

    /// A flat patch seen at any angle off its plane shows no silhouette.
    #[test]
    fn flat_patch_has_no_margin() {
        let cone = cone(&[Some(X), Some(X)]);
        assert_eq!((cone.sin, cone.view_margin(1.0, 0.0)), (0.0, 0.0));
    }
}
