//! Rough plastic: a rough clear coat over a diffuse base.

use std::f64::consts::FRAC_1_PI;
use std::sync::Arc;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::coat::{base, base_probability, choice_weights};
use super::event::Drawn;
use super::fresnel::fresnel_dielectric;
use super::local;
use super::microfacets::{Distribution, Microfacets};
use super::rough_surface::RoughSurface;
use super::rough_transmittance::RoughTransmittance;
use crate::ids::TextureId;
use crate::material::fields::{WithoutEffect, fields};
use crate::material::number::{Circumstances, Derived, Number};
use crate::material::plain::{InScene, Plain, RoughCoat, Samples, Scatters, TextureOf};

/// A rough dielectric over a diffuse base. The coat's facets are isotropic.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RoughPlastic<N: Number = f64> {
    /// Distribution of the coat's facets.
    pub distribution: Distribution,
    /// Roughness of the coat; a constant.
    pub alpha: N,
    /// Refractive index of the coat relative to the outside, `int_ior / ext_ior`; not 1.
    pub eta: N::Ratio,
    /// Fraction of light reflected by the base, per channel.
    pub diffuse_reflectance: N::Colour,
    /// Factor on what the coat reflects.
    pub specular_reflectance: N::Colour,
    /// True if light that is thrown back by the coat from inside takes the
    /// colour of the base again, each time.
    pub nonlinear: bool,
    /// What passes the coat; made for the distribution and the values of `alpha` and `eta`.
    pub transmittance: N::Derived<Arc<RoughTransmittance>>,
}

fields! {
    RoughPlastic {
        distribution: distribution(),
        alpha: number(Roughness, 0.1),
        eta: indices(RefractiveIndex { bends: false }, "polypropylene", "air"),
        diffuse_reflectance: colour(Reflectance, 0.5),
        specular_reflectance: colour(Reflectance, 1.0),
        nonlinear: flag(false),
        ; transmittance: Arc<RoughTransmittance>
    }
}

impl<N: Number> Plain for RoughPlastic<N> {
    const PLUGIN: &'static str = "roughplastic";
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect::SAMPLE_VISIBLE;
    const HAS_FACETS: bool = true;
}

impl InScene for RoughPlastic<TextureId> {
    fn check(&self, texture: TextureOf) -> Result<(), &'static str> {
        let constants = [self.alpha, self.eta.int_ior, self.eta.ext_ior];
        let constants = constants.map(texture);
        if !constants.iter().all(|texture| texture.is_constant()) {
            return Err("a rough coat must have one roughness everywhere");
        }
        let [alpha, inside, outside] = constants.map(|texture| texture.texel_as_number(0));
        if inside == outside {
            return Err("a rough coat must not have the index of its outside");
        }
        if alpha == 0.0 {
            return Err("a rough coat must not be smooth; write plastic");
        }
        Ok(())
    }

    fn rough_coat(&self, texture: TextureOf) -> Option<RoughCoat> {
        let number = |id: TextureId| texture(id).texel_as_number(0);
        Some(RoughCoat {
            distribution: self.distribution,
            alpha: number(self.alpha),
            eta: number(self.eta.int_ior) / number(self.eta.ext_ior),
        })
    }
}

impl Derived for Arc<RoughTransmittance> {
    type Of<N: Number> = RoughPlastic<N>;

    #[inline]
    fn find(_: &RoughPlastic<TextureId>, at: &impl Circumstances) -> Self {
        Self::clone(at.coat().expect("the resolver is that of the scene"))
    }
}

impl<R: Real> RoughPlastic<R> {
    #[inline]
    fn facets(&self) -> Microfacets<R> {
        Microfacets::isotropic(self.distribution, self.alpha)
    }

    #[inline]
    fn transmittance(&self, cos: R) -> R {
        self.transmittance.transmittance(cos, self.alpha, self.eta)
    }

    /// Fraction of the base's light that the coat throws back.
    #[inline]
    fn internal_reflectance(&self) -> R {
        let table = &self.transmittance;
        table.internal_reflectance(self.alpha, self.eta)
    }

    /// What the coat scatters if facets that are perfect mirrors scatter `mirrored`, seen under the cosine `cos`.
    #[inline]
    fn coat(&self, mirrored: R, cos: R) -> Rgb<R> {
        self.specular_reflectance * (fresnel_dielectric(cos, self.eta) * mirrored)
    }

    /// What coat and base scatter if facets that are perfect mirrors scatter `mirrored`, seen under
    /// the cosine `cos`, and the fraction `enters` passes the coat.
    #[inline]
    fn scattered(&self, mirrored: R, cos: R, enters: R, wo: Vec3<R>) -> Rgb<R> {
        let coat = self.coat(mirrored, cos);
        let internal = self.internal_reflectance();
        let passes = enters * self.transmittance(wo.z);
        // Radiance shrinks by `1 / eta²` on the way out.
        let scale = passes * wo.z * R::constant(FRAC_1_PI) / self.eta.squared();
        coat + base(self.diffuse_reflectance, internal, self.nonlinear) * scale
    }
}

impl<R: Real> Scatters<R> for RoughPlastic<R> {
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let wi = local::raised(wi);
        let h = (wi + wo).normalized();
        let mirrored = self.facets().reflection(wi, wo, h);
        self.scattered(mirrored, wi.dot(h), self.transmittance(wi.z), wo)
    }

    #[inline]
    fn mirrored(&self, wi: Vec3<R>, wo: Vec3<R>, visit: &mut impl FnMut(Rgb<R>, R)) {
        if wo.z.value() > 0.0 {
            let (wi, facets) = (local::raised(wi), self.facets());
            let h = (wi + wo).normalized();
            let coat = self.coat(facets.reflection(wi, wo, h), wi.dot(h));
            visit(coat, facets.alpha2());
        }
    }
}

impl RoughPlastic {
    /// Probability of choosing the base, if the fraction `enters` passes the coat.
    #[inline]
    fn base_probability(&self, enters: f64) -> f64 {
        let weights = choice_weights(self.diffuse_reflectance, self.specular_reflectance);
        base_probability(enters, weights)
    }

    /// The density, if the fraction `enters` passes the coat, which has the density `coat`.
    #[inline]
    fn mixed_pdf(&self, enters: f64, coat: f64, wo: Vec3) -> f64 {
        let base = self.base_probability(enters);
        base * local::cosine_pdf(wo) + (1.0 - base) * coat
    }
}

impl Samples for RoughPlastic {
    /// A direction by the cosine, or a reflection at a visible normal.
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let wi = local::raised(wi);
        if choice < self.base_probability(self.transmittance(wi.z)) {
            return Some(Drawn::Smooth(local::sample_cosine(u)));
        }
        let wo = local::reflected_about(wi, self.facets().sample(wi, u));
        (wo.z > 0.0).then_some(Drawn::Smooth(wo))
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if wo.z <= 0.0 {
            return 0.0;
        }
        let wi = local::raised(wi);
        let coat = self.facets().reflection_pdf(wi, (wi + wo).normalized());
        self.mixed_pdf(self.transmittance(wi.z), coat, wo)
    }

    #[inline]
    fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
        if wo.z <= 0.0 {
            return (Rgb::zero(), 0.0);
        }
        let wi = local::raised(wi);
        let mirrored = self.facets().mirrored(wi, wo);
        let enters = self.transmittance(wi.z);
        let scattered = self.scattered(mirrored.scattered, mirrored.cos, enters, wo);
        (scattered, self.mixed_pdf(enters, mirrored.pdf, wo))
    }

    fn rough_surface(&self, weight: f64) -> Option<RoughSurface> {
        let base = base(
            self.diffuse_reflectance,
            self.internal_reflectance(),
            self.nonlinear,
        );
        let eta2 = self.eta * self.eta;
        Some(RoughSurface::coat_of(
            self.facets(),
            self.specular_reflectance * weight,
            eta2,
            // Radiance shrinks by `1 / eta²` on the way out.
            base * (weight * FRAC_1_PI / eta2),
            choice_weights(self.diffuse_reflectance, self.specular_reflectance),
            Arc::clone(&self.transmittance),
        ))
    }
}
