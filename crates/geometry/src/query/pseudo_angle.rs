//! A number that stands for an angle in comparisons, cheaper than the angle and
//! as precise near zero: for a point at height `z` along the axis and at
//! distance `ρ` from it,
//!
//!   ρ / (ρ + z) in front of the viewpoint, 1 + |z| / (ρ + |z|) behind it,
//!
//! which grows with the angle, from 0 over 1 at a right angle to 2 at π.

use crate::aabb::round_up;
use crate::simd::ESTIMATE_ERROR;

/// The pseudo-angle of an angle with this sine and cosine, rounded up by more
/// than the rounding of both.
#[inline]
pub fn pseudo_angle(sin: f64, cos: f64) -> f32 {
    let total = sin + cos.abs();
    let pseudo = if cos >= 0.0 {
        sin / total
    } else {
        1.0 - cos / total
    };
    // Bounds are compared with `>` after rounding down by as much.
    round_up(pseudo)
}

/// Margins of positions aside, a bound of an angle is off by at most the errors
/// of two estimates, and a few roundings that are much smaller.
pub const BOUND_SHRINK: f32 = 1.0 - 2.5 * ESTIMATE_ERROR;

/// The largest pseudo-angle that is still of interest.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// That pseudo-angle.
    pub pseudo: f32,
    /// A tangent no smaller than that of the angle, if there is one up to
    /// [`STEEPEST`], or else that.
    pub tangent: f32,
    /// Every bit is set if the tangent is that of the angle.
    pub has_tangent: u32,
}

/// Tangents are of use in bounds up to this one (83 degrees).
const STEEPEST: f32 = 8.0;

/// The tangent is used times an estimate of a distance: more than its error.
const TANGENT_MARGIN: f32 = 1.0 + 2.0 * ESTIMATE_ERROR;

impl Limit {
    /// The limit at a pseudo-angle.
    #[inline(always)]
    pub fn new(pseudo: f32) -> Self {
        let tangent = pseudo / (1.0 - pseudo);
        let has_tangent = pseudo < 1.0 && tangent <= STEEPEST;
        Self {
            pseudo,
            tangent: TANGENT_MARGIN * if has_tangent { tangent } else { STEEPEST },
            has_tangent: if has_tangent { u32::MAX } else { 0 },
        }
    }

    /// The limit of a cone with this half-angle.
    #[inline]
    pub fn of_angle(angle: f64) -> Self {
        let (sin, cos) = angle.min(std::f64::consts::PI).sin_cos();
        Self::new(pseudo_angle(sin.abs(), cos))
    }

    /// Lowers the limit, if this is lower.
    #[inline(always)]
    pub fn lower_to(&mut self, pseudo: f32) {
        if pseudo < self.pseudo {
            *self = Self::new(pseudo);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stand-in for angles grows with them, from 0 to 2.
    #[test]
    fn pseudo_angle_grows() {
        let pseudo = |angle: f64| pseudo_angle(angle.sin(), angle.cos());
        let angles = (0..=100).map(|i| 0.01 * f64::from(i) * std::f64::consts::PI);
        let values: Vec<f32> = angles.map(pseudo).collect();
        assert!(values.is_sorted());
        assert_eq!((values[0], values[50], values[100]), (0.0, 1.0, 2.0));
        assert!((pseudo(1e-9) / 1e-9 - 1.0).abs() < 1e-6);
    }

    /// The tangent of a limit is its angle's, a little rounded up.
    #[test]
    fn limit_has_the_tangent() {
        for angle in [0.0, 1e-9, 0.05, 1.0] {
            let limit = Limit::of_angle(angle);
            let ratio = f64::from(limit.tangent) / angle.tan();
            assert!(limit.has_tangent != 0);
            assert!(
                angle == 0.0 || (1.0..1.002).contains(&ratio),
                "{angle} {ratio}"
            );
        }
        assert_eq!(Limit::of_angle(1.5).has_tangent, 0);
        assert_eq!(Limit::of_angle(4.0).has_tangent, 0);
    }
}
