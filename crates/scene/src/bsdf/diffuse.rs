//! The ideally diffuse material. Directions are in the shading frame, normal
//! `+z`, and point away from the surface.

use std::f64::consts::{FRAC_1_PI, PI};

use capwalk_math::{Real, Rgb, Vec3};

/// Reflects the same radiance to all directions in front of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diffuse;

/// A direction drawn by a material.
#[derive(Clone, Copy, Debug)]
pub struct BsdfSample {
    /// The direction to continue in.
    pub wo: Vec3,
    /// Its density per solid angle.
    pub pdf: f64,
}

impl Diffuse {
    /// Reflected radiance per incident radiance and solid angle, the cosine
    /// with the normal included: `reflectance / π · cos⁺`.
    #[inline]
    pub fn eval<R: Real>(reflectance: Rgb<R>, cos_o: R) -> Rgb<R> {
        if cos_o.value() <= 0.0 {
            return Rgb::zero();
        }
        reflectance * (cos_o * R::constant(FRAC_1_PI))
    }

    /// Draws a direction with density `cos / π`: a uniform point of the unit
    /// disk lifted to the hemisphere (Malley).
    #[inline]
    pub fn sample<R: Real>(u: [R; 2]) -> Vec3<R> {
        let (sin_phi, cos_phi) = (R::constant(2.0 * PI) * u[1]).sin_cos();
        let radius = u[0].sqrt();
        let height = (R::constant(1.0) - u[0]).sqrt();
        Vec3::new(radius * cos_phi, radius * sin_phi, height)
    }

    /// Density of [`Diffuse::sample`] per solid angle.
    #[inline]
    pub fn pdf(cos_o: f64) -> f64 {
        cos_o.max(0.0) * FRAC_1_PI
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_math::Dual;

    #[test]
    fn area_element_of_sample_is_one_over_pdf() {
        for u in [[0.3, 0.7], [0.01, 0.2], [0.98, 0.9]] {
            let wo = Diffuse::sample([Dual::<2>::variable(u[0], 0), Dual::variable(u[1], 1)]);
            let area_element = wo.tangent(0).cross(wo.tangent(1)).length();
            let error = (area_element * Diffuse::pdf(wo.z.value) - 1.0).abs();
            assert!(error < 1e-9, "u = {u:?}: {error:e}");
        }
    }
}
