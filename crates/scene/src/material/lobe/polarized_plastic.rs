//! Mitsuba's plastic for polarized light, to unpolarized light: clear facets added to a
//! diffuse base. After Baek et al., "Simultaneous Acquisition of Polarimetric SVBRDF and
//! Normals" (2018).

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::coat::choice_weights;
use super::event::Drawn;
use super::fresnel::fresnel_dielectric;
use super::local;
use super::microfacets::Microfacets;
use crate::ids::TextureId;
use crate::material::fields::{WithoutEffect, fields};
use crate::material::number::Number;
use crate::material::plain::{Anisotropy, InScene, Plain, Samples, Scatters, TextureOf};

/// Clear facets, and a diffuse base below a smooth interface: light that the interface
/// throws back from inside is lost.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PolarizedPlastic<N: Number = f64> {
    /// The facets.
    pub microfacets: Microfacets<N>,
    /// Refractive index of the inside relative to the outside, `int_ior / ext_ior`.
    pub eta: N::Ratio,
    /// Fraction of light reflected by the base, per channel.
    pub diffuse_reflectance: N::Colour,
    /// Factor on what the facets reflect.
    pub specular_reflectance: N::Colour,
}

fields! {
    PolarizedPlastic {
        microfacets: facets(0.1),
        eta: indices(RefractiveIndex { bends: false }, "polypropylene", "air"),
        diffuse_reflectance: colour(Reflectance, 0.5),
        specular_reflectance: colour(Reflectance, 1.0),
    }
}

impl<N: Number> Plain for PolarizedPlastic<N> {
    const PLUGIN: &'static str = "pplastic";
    const HAS_FACETS: bool = true;
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect::SAMPLE_VISIBLE;
}

impl InScene for PolarizedPlastic<TextureId> {
    fn anisotropy(&self) -> Anisotropy {
        Anisotropy::of(&self.microfacets)
    }

    fn warning(&self, _: TextureOf) -> Option<&'static str> {
        Some("polarization is not computed: as in Mitsuba's unpolarized variants")
    }
}

impl<R: Real> Scatters<R> for PolarizedPlastic<R> {
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let wi = local::raised(wi);
        let one = R::constant(1.0);
        let enters = one - fresnel_dielectric(wo.z, self.eta);
        let leaves = one - fresnel_dielectric(wi.z, self.eta);
        let base = enters * leaves * wo.z * R::constant(FRAC_1_PI);
        self.coat(wi, wo) + self.diffuse_reflectance * base
    }

    #[inline]
    fn mirrored(&self, wi: Vec3<R>, wo: Vec3<R>, visit: &mut impl FnMut(Rgb<R>, R)) {
        if wo.z.value() > 0.0 {
            visit(self.coat(local::raised(wi), wo), self.microfacets.alpha2());
        }
    }
}

impl<R: Real> PolarizedPlastic<R> {
    /// What the facets reflect between two directions in front.
    #[inline]
    fn coat(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        let h = (wi + wo).normalized();
        let reflectance = fresnel_dielectric(wi.dot(h), self.eta);
        self.specular_reflectance * (reflectance * self.microfacets.reflection(wi, wo, h))
    }
}

impl PolarizedPlastic {
    /// Probability of choosing the base; what is black may have a derivative, and is
    /// sampled a little.
    #[inline]
    fn base_probability(&self) -> f64 {
        let [base, facets] = choice_weights(self.diffuse_reflectance, self.specular_reflectance);
        base / (base + facets)
    }
}

impl Samples for PolarizedPlastic {
    /// A direction by the cosine, or a reflection at a visible normal.
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        if choice < self.base_probability() {
            return Some(Drawn::Smooth(local::sample_cosine(u)));
        }
        let wi = local::raised(wi);
        let wo = local::reflected_about(wi, self.microfacets.sample(wi, u));
        (wo.z > 0.0).then_some(Drawn::Smooth(wo))
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if wo.z <= 0.0 {
            return 0.0;
        }
        let base = self.base_probability();
        let wi = local::raised(wi);
        let facets = self.microfacets.reflection_pdf(wi, (wi + wo).normalized());
        base * local::cosine_pdf(wo) + (1.0 - base) * facets
    }
}
