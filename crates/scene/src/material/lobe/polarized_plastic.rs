//! Mitsuba's plastic for polarized light, to unpolarized light: clear facets added to a
//! diffuse base. After Baek et al., "Simultaneous Acquisition of Polarimetric SVBRDF and
//! Normals" (2018).

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};

use super::event::Drawn;
use super::fresnel::fresnel_dielectric;
use super::local;
use super::microfacets::Microfacets;
use super::plastic::base_chances;

/// Clear facets, and a diffuse base below a smooth interface: light that the interface
/// throws back from inside is lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolarizedPlastic<R = f64> {
    /// The facets.
    pub microfacets: Microfacets<R>,
    /// Refractive index of the inside relative to the outside, `int_ior / ext_ior`.
    pub eta: R,
    /// Fraction of light reflected by the base, per channel.
    pub diffuse_reflectance: Rgb<R>,
    /// Factor on what the facets reflect.
    pub specular_reflectance: Rgb<R>,
}

impl<R: Real> PolarizedPlastic<R> {
    #[inline]
    pub(super) fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let wi = local::raised(wi);
        let h = (wi + wo).normalized();
        let reflectance = fresnel_dielectric(wi.dot(h), self.eta);
        let facets = reflectance * self.microfacets.reflection(wi, wo, h);
        let one = R::constant(1.0);
        let enters = one - fresnel_dielectric(wo.z, self.eta);
        let leaves = one - fresnel_dielectric(wi.z, self.eta);
        let base = enters * leaves * wo.z * R::constant(FRAC_1_PI);
        self.specular_reflectance * facets + self.diffuse_reflectance * base
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> PolarizedPlastic<S> {
        PolarizedPlastic {
            microfacets: self.microfacets.map(f),
            eta: f(self.eta),
            diffuse_reflectance: self.diffuse_reflectance.map(&mut *f),
            specular_reflectance: self.specular_reflectance.map(&mut *f),
        }
    }
}

impl PolarizedPlastic {
    /// Probability of choosing the base; what is black may have a derivative, and is
    /// sampled a little.
    #[inline]
    fn base_probability(&self) -> f64 {
        let [base, facets] = base_chances(self.diffuse_reflectance, self.specular_reflectance);
        base / (base + facets)
    }

    /// A direction by the cosine, or a reflection at a visible normal.
    #[inline]
    pub(super) fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        if choice < self.base_probability() {
            return Some(Drawn::Smooth(local::sample_cosine(u)));
        }
        let wi = local::raised(wi);
        let wo = local::reflected_about(wi, self.microfacets.sample(wi, u));
        (wo.z > 0.0).then_some(Drawn::Smooth(wo))
    }

    #[inline]
    pub(super) fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if wo.z <= 0.0 {
            return 0.0;
        }
        let base = self.base_probability();
        let wi = local::raised(wi);
        let facets = self.microfacets.reflection_pdf(wi, (wi + wo).normalized());
        base * local::cosine_pdf(wo) + (1.0 - base) * facets
    }
}
