//! The rough metal.

use capwalk_math::{Real, Rgb, Vec3};

use super::event::Drawn;
use super::fresnel::fresnel_conductor;
use super::local;
use super::microfacets::Microfacets;

/// Metal mirrors as microfacets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughConductor<R = f64> {
    /// The roughness.
    pub microfacets: Microfacets<R>,
    /// Real part of the refractive index, per channel; 0 with `k` = 1 reflects all.
    pub eta: Rgb<R>,
    /// Imaginary part of the refractive index, per channel.
    pub k: Rgb<R>,
    /// Factor on what is reflected.
    pub specular_reflectance: Rgb<R>,
}

impl<R: Real> RoughConductor<R> {
    #[inline]
    pub(super) fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let wi = local::raised(wi);
        let h = (wi + wo).normalized();
        let reflectance = fresnel_conductor(wi.dot(h), self.eta, self.k);
        reflectance * self.specular_reflectance * self.microfacets.reflection(wi, wo, h)
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> RoughConductor<S> {
        RoughConductor {
            microfacets: self.microfacets.map(f),
            eta: self.eta.map(&mut *f),
            k: self.k.map(&mut *f),
            specular_reflectance: self.specular_reflectance.map(&mut *f),
        }
    }
}

impl RoughConductor {
    /// Reflects at a visible normal; `None` if that leads below the surface,
    /// to another facet that the model does not follow.
    #[inline]
    pub(super) fn sample(&self, wi: Vec3, _choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let wi = local::raised(wi);
        let wo = local::reflected_about(wi, self.microfacets.sample(wi, u));
        (wo.z > 0.0).then_some(Drawn::Smooth(wo))
    }

    #[inline]
    pub(super) fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if wo.z <= 0.0 {
            return 0.0;
        }
        let wi = local::raised(wi);
        self.microfacets.reflection_pdf(wi, (wi + wo).normalized())
    }

    /// [`RoughConductor::eval`] and [`RoughConductor::pdf`].
    #[inline]
    pub(super) fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
        if wo.z <= 0.0 {
            return (Rgb::zero(), 0.0);
        }
        let mirrored = self.microfacets.mirrored(local::raised(wi), wo);
        let reflectance = fresnel_conductor(mirrored.cos, self.eta, self.k);
        let colour = reflectance * self.specular_reflectance;
        (colour * mirrored.scattered, mirrored.pdf)
    }
}
