//! Small arithmetic in the shading frame.

use std::f64::consts::{FRAC_1_PI, PI};

use capwalk_math::elementary::sin_cos;
use capwalk_math::{Real, Rgb, Vec3};

/// The direction on the side of `+z`: mirrored at the surface if below it.
#[inline]
pub fn raised<R: Real>(w: Vec3<R>) -> Vec3<R> {
    Vec3::new(w.x, w.y, w.z.abs())
}

/// The direction mirrored at the surface.
#[inline]
pub fn mirrored<R: Real>(w: Vec3<R>) -> Vec3<R> {
    Vec3::new(w.x, w.y, -w.z)
}

/// Where a mirror with the normal `+z` sends `wi`.
#[inline]
pub fn reflected<R: Real>(wi: Vec3<R>) -> Vec3<R> {
    Vec3::new(-wi.x, -wi.y, wi.z)
}

/// Where a mirror with the normal `m` sends `wi`.
#[inline]
pub fn reflected_about(wi: Vec3, m: Vec3) -> Vec3 {
    m * (2.0 * wi.dot(m)) - wi
}

/// The vector from `wi.z > 0` for a surface seen from inside: the same
/// surface turned over. `eta` becomes its reciprocal.
#[inline]
pub fn turned_outside<R: Real>(wi: Vec3<R>, wo: Vec3<R>, eta: R) -> (Vec3<R>, Vec3<R>, R) {
    if wi.z.value() < 0.0 {
        (mirrored(wi), mirrored(wo), R::constant(1.0) / eta)
    } else {
        (wi, wo, eta)
    }
}

/// Draws a direction with density `cos / π`: a uniform point of the unit disk
/// lifted to the hemisphere (Malley).
#[inline(always)]
pub fn sample_cosine(u: [f64; 2]) -> Vec3 {
    let (sin_phi, cos_phi) = sin_cos(2.0 * PI * u[1]);
    let radius = u[0].sqrt();
    Vec3::new(radius * cos_phi, radius * sin_phi, (1.0 - u[0]).sqrt())
}

/// Density of [`sample_cosine`] per solid angle.
#[inline]
pub fn cosine_pdf(wo: Vec3) -> f64 {
    wo.z.max(0.0) * FRAC_1_PI
}

/// `a` at 0, `b` at 1.
#[inline]
pub fn lerp<R: Real>(a: R, b: R, t: R) -> R {
    a + (b - a) * t
}

/// Mean of the channels.
#[inline]
pub fn mean(c: Rgb) -> f64 {
    (c.r + c.g + c.b) * (1.0 / 3.0)
}
