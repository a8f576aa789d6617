//! The unit sphere: angles, tangents, and caps.
//!
//! A cap is the part of the sphere within an angle `A`, its half-angle, of an
//! axis. Caps become tiny near silhouettes, so nothing here forms `1 - cos A`
//! directly: it is written `2 sin²(A/2)`, which keeps full relative precision.

use std::f64::consts::PI;

use crate::frame::Frame;
use crate::real::Real;
use crate::vec3::Vec3;

/// The angle between two unit vectors, in radians, to full relative precision
/// from 0 to π (`acos` of the inner product loses half the digits near both).
#[inline]
pub fn angle_between(a: Vec3, b: Vec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// Unit tangent at `q` along the great circle towards `z`; not finite if `z`
/// is `q` or its antipode.
#[inline]
pub fn tangent_towards(q: Vec3, z: Vec3) -> Vec3 {
    // z - (z·q) q loses digits for close points; the double cross product
    // works on the small difference instead.
    q.cross((z - q).cross(q)).normalized()
}

/// The point at `angle` radians from `q` along the unit tangent `e`.
#[inline]
pub fn walk_along(q: Vec3, e: Vec3, angle: f64) -> Vec3 {
    let (sin, cos) = angle.sin_cos();
    q * cos + e * sin
}

/// Area of the cap with the given half-angle, Eq. (33).
pub fn cap_area<R: Real>(half_angle: R) -> R {
    let (sin_half, _) = (half_angle * R::constant(0.5)).sin_cos();
    R::constant(4.0 * PI) * sin_half * sin_half
}

/// Maps the unit square uniformly onto the cap around `+z`.
pub fn sample_cap<R: Real>(half_angle: R, u: [R; 2]) -> Vec3<R> {
    let (sin_half, _) = (half_angle * R::constant(0.5)).sin_cos();
    let two = R::constant(2.0);
    let height = two * sin_half * sin_half * u[0]; // 1 - cos(theta)
    let cos_theta = R::constant(1.0) - height;
    let sin_theta = (height * (two - height)).sqrt();
    let (sin_phi, cos_phi) = (R::constant(2.0 * PI) * u[1]).sin_cos();
    Vec3::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
}

/// Density of [`sample_cap`] with respect to solid angle.
pub fn cap_pdf<R: Real>(half_angle: R) -> R {
    R::constant(1.0) / cap_area(half_angle)
}

/// Unit tangent at the frame's axis with the azimuth `2π u`.
#[inline]
pub fn sample_tangent(frame: &Frame, u: f64) -> Vec3 {
    let (sin_phi, cos_phi) = (2.0 * PI * u).sin_cos();
    frame.s * cos_phi + frame.t * sin_phi
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dual::Dual;

    /// A sampling map is right if and only if its area element is 1/pdf.
    #[test]
    fn area_element_of_sample_is_one_over_pdf() {
        for half_angle in [1e-5, 0.01, 0.3, 1.2, 3.0] {
            for u in [[0.3, 0.7], [0.01, 0.2], [0.99, 0.9]] {
                let point = sample_cap(
                    Dual::<2>::constant(half_angle),
                    [Dual::variable(u[0], 0), Dual::variable(u[1], 1)],
                );
                let area_element = point.tangent(0).cross(point.tangent(1)).length();
                let error = (area_element * cap_pdf(half_angle) - 1.0).abs();
                assert!(error < 1e-9, "A = {half_angle}, u = {u:?}: {error:e}");
            }
        }
    }

    /// The hemisphere and the full sphere have known areas.
    #[test]
    fn area_of_hemisphere_and_sphere() {
        assert!((cap_area(PI / 2.0) - 2.0 * PI).abs() < 1e-14);
        assert!((cap_area(PI) - 4.0 * PI).abs() < 1e-14);
    }

    /// Tiny caps keep their area in single precision, where `1 - cos A` is zero.
    #[test]
    fn tiny_cap_has_area_in_f32() {
        let half_angle = 1e-4_f32;
        assert_eq!(1.0 - half_angle.cos(), 0.0);
        let flat = std::f32::consts::PI * half_angle * half_angle;
        assert!((cap_area(half_angle) / flat - 1.0).abs() < 1e-5);
    }

    /// Going a given way by a given angle and looking back finds both again,
    /// down to angles where `acos` would answer 0.
    #[test]
    fn walking_and_looking_back() {
        let q = Vec3::new(0.48, -0.6, 0.64);
        let e = Frame::from_normal(q).s;
        for angle in [1e-12, 1e-6, 0.3, 3.0] {
            let z = walk_along(q, e, angle);
            assert!((angle_between(q, z) / angle - 1.0).abs() < 1e-3);
            if angle > 1e-8 {
                assert!((tangent_towards(q, z) - e).length() < 1e-6);
            }
        }
    }
}
