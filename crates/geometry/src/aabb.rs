//! Axis-aligned boxes in single precision, rounded outward.

use capwalk_math::Vec3;

/// An axis-aligned box. Empty while `low > high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Smallest coordinates.
    pub low: [f32; 3],
    /// Largest coordinates.
    pub high: [f32; 3],
}

impl Aabb {
    /// The box that contains nothing.
    pub const EMPTY: Self = Self {
        low: [f32::INFINITY; 3],
        high: [f32::NEG_INFINITY; 3],
    };

    /// A box that contains the points, at most one rounding larger than needed.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        let start = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        let (low, high) = points
            .into_iter()
            .fold(start, |(low, high), p| (low.min(p), high.max(p)));
        Self {
            low: low.to_array().map(round_down),
            high: high.to_array().map(round_up),
        }
    }

    /// The smallest box that contains both.
    #[inline]
    pub fn union(&self, other: &Self) -> Self {
        let smaller = |a: f32, b: f32| if b < a { b } else { a };
        let larger = |a: f32, b: f32| if b > a { b } else { a };
        Self {
            low: std::array::from_fn(|i| smaller(self.low[i], other.low[i])),
            high: std::array::from_fn(|i| larger(self.high[i], other.high[i])),
        }
    }

    /// True if it contains nothing, not even a point.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.low[0] > self.high[0]
    }

    /// Half the surface area; not finite or negative if empty.
    #[inline]
    pub fn half_area(&self) -> f32 {
        let [x, y, z] = self.extent();
        x * y + y * z + z * x
    }

    #[inline]
    pub fn extent(&self) -> [f32; 3] {
        std::array::from_fn(|i| self.high[i] - self.low[i])
    }

    /// Twice the centre.
    #[inline]
    pub fn centre2(&self) -> [f32; 3] {
        std::array::from_fn(|i| self.low[i] + self.high[i])
    }

    /// True if the point lies inside, borders included.
    #[cfg(test)]
    pub fn contains_point(&self, p: Vec3) -> bool {
        (0..3).all(|i| f64::from(self.low[i]) <= p[i] && p[i] <= f64::from(self.high[i]))
    }
}

/// The nearest single-precision number not above `v`.
#[inline]
pub fn round_down(v: f64) -> f32 {
    let nearest = v as f32;
    if f64::from(nearest) > v {
        nearest.next_down()
    } else {
        nearest
    }
}

/// The nearest single-precision number not below `v`.
#[inline]
pub fn round_up(v: f64) -> f32 {
    let nearest = v as f32;
    if f64::from(nearest) < v {
        nearest.next_up()
    } else {
        nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding goes the promised way and no further than one step.
    #[test]
    fn rounding_outward() {
        for v in [0.1, -0.1, 1.0, 1e-30, -1e-50, 0.0, 16777217.0] {
            assert!(f64::from(round_down(v)) <= v && v <= f64::from(round_up(v)));
            assert!(round_down(v).next_up() >= round_up(v));
        }
    }
}
