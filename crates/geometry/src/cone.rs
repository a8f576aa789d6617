//! Cones of face normals: which views see no silhouette in a group of edges.

use capwalk_math::Vec3;

/// A cone that contains normals of faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalCone {
    /// Its unit axis.
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

    /// For a box with these half sides: the number `k` such that no edge in it
    /// whose normals are in the cone is a silhouette if the vector `v` from
    /// the eye to the centre of the box has
    ///
    ///   |axis · v| > sin |v| + k.
    ///
    /// A point of the box is seen along `q = v + h`. All its normals face the
    /// same way if the angle between `axis` and ±`q` is less than a right
    /// angle minus the cone's, `|axis · q| > sin |q|`. With `r` the box's half
    /// diagonal this follows from `k = Σ|axisᵢ|hᵢ + sin r`. By the angle that
    /// the box's sphere subtends, it also follows from `k = cos r`.
    pub fn view_margin(&self, half: Vec3) -> f64 {
        if !self.sin.is_finite() {
            return f64::INFINITY;
        }
        let radius = half.length();
        let by_box = self.axis.map(f64::abs).dot(half) + self.sin * radius;
        let by_sphere = (1.0 - self.sin * self.sin).max(0.0).sqrt() * radius;
        by_box.min(by_sphere)
    }
}
