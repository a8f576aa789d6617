//! Rough plastic: a rough clear coat over a diffuse base.

use std::f64::consts::FRAC_1_PI;
use std::sync::Arc;

use capwalk_math::{Real, Rgb, Vec3};

use super::event::Drawn;
use super::fresnel::fresnel_dielectric;
use super::local;
use super::microfacets::Microfacets;
use super::plastic::{base, base_chances, base_probability};
use super::rough_transmittance::RoughTransmittance;

/// A rough dielectric over a diffuse base. The coat's facets are isotropic.
#[derive(Clone, Debug, PartialEq)]
pub struct RoughPlastic<R = f64> {
    /// Refractive index of the coat relative to the outside, `int_ior / ext_ior`; not 1.
    pub eta: R,
    /// Roughness of the coat.
    pub alpha: R,
    /// Fraction of light reflected by the base, per channel.
    pub diffuse_reflectance: Rgb<R>,
    /// Factor on what the coat reflects.
    pub specular_reflectance: Rgb<R>,
    /// True if light that is thrown back by the coat from inside takes the
    /// colour of the base again, each time.
    pub nonlinear: bool,
    /// What passes the coat; made for the values of `alpha` and `eta`.
    pub transmittance: Arc<RoughTransmittance>,
}

impl<R: Real> RoughPlastic<R> {
    #[inline]
    pub(super) fn facets(&self) -> Microfacets<R> {
        Microfacets::isotropic(self.transmittance.distribution(), self.alpha)
    }

    #[inline]
    fn transmittance(&self, cos: R) -> R {
        self.transmittance.transmittance(cos, self.alpha, self.eta)
    }

    /// Fraction of the base's light that the coat throws back.
    #[inline]
    pub(super) fn internal_reflectance(&self) -> R {
        let table = &self.transmittance;
        table.internal_reflectance(self.alpha, self.eta)
    }

    #[inline]
    pub(super) fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let wi = local::raised(wi);
        let h = (wi + wo).normalized();
        let mirrored = self.facets().reflection(wi, wo, h);
        self.scattered(mirrored, wi.dot(h), self.transmittance(wi.z), wo)
    }

    /// What coat and base scatter if facets that are perfect mirrors scatter `mirrored`, seen under
    /// the cosine `cos`, and the fraction `enters` passes the coat.
    #[inline]
    fn scattered(&self, mirrored: R, cos: R, enters: R, wo: Vec3<R>) -> Rgb<R> {
        let coat = self.specular_reflectance * (fresnel_dielectric(cos, self.eta) * mirrored);
        let internal = self.internal_reflectance();
        let passes = enters * self.transmittance(wo.z);
        // Radiance shrinks by `1 / eta²` on the way out.
        let scale = passes * wo.z * R::constant(FRAC_1_PI) / self.eta.squared();
        coat + base(self.diffuse_reflectance, internal, self.nonlinear) * scale
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> RoughPlastic<S> {
        RoughPlastic {
            eta: f(self.eta),
            alpha: f(self.alpha),
            diffuse_reflectance: self.diffuse_reflectance.map(&mut *f),
            specular_reflectance: self.specular_reflectance.map(&mut *f),
            nonlinear: self.nonlinear,
            transmittance: Arc::clone(&self.transmittance),
        }
    }
}

impl RoughPlastic {
    /// Probability of choosing the base, if the fraction `enters` passes the coat.
    #[inline]
    fn base_probability(&self, enters: f64) -> f64 {
        let chances = base_chances(self.diffuse_reflectance, self.specular_reflectance);
        base_probability(enters, chances)
    }

    /// A direction by the cosine, or a reflection at a visible normal.
    #[inline]
    pub(super) fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let wi = local::raised(wi);
        if choice < self.base_probability(self.transmittance(wi.z)) {
            return Some(Drawn::Smooth(local::sample_cosine(u)));
        }
        let wo = local::reflected_about(wi, self.facets().sample(wi, u));
        (wo.z > 0.0).then_some(Drawn::Smooth(wo))
    }

    #[inline]
    pub(super) fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if wo.z <= 0.0 {
            return 0.0;
        }
        let wi = local::raised(wi);
        let coat = self.facets().reflection_pdf(wi, (wi + wo).normalized());
        self.mixed_pdf(self.transmittance(wi.z), coat, wo)
    }

    /// The density, if the fraction `enters` passes the coat, which has the density `coat`.
    #[inline]
    fn mixed_pdf(&self, enters: f64, coat: f64, wo: Vec3) -> f64 {
        let base = self.base_probability(enters);
        base * local::cosine_pdf(wo) + (1.0 - base) * coat
    }

    /// [`RoughPlastic::eval`] and [`RoughPlastic::pdf`].
    #[inline]
    pub(super) fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
        if wo.z <= 0.0 {
            return (Rgb::zero(), 0.0);
        }
        let wi = local::raised(wi);
        let mirrored = self.facets().mirrored(wi, wo);
        let enters = self.transmittance(wi.z);
        let scattered = self.scattered(mirrored.scattered, mirrored.cos, enters, wo);
        (scattered, self.mixed_pdf(enters, mirrored.pdf, wo))
    }
}
