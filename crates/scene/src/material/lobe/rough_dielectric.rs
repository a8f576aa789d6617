//! The rough surface of a clear body.

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::Drawn;
use super::fresnel::fresnel_dielectric;
use super::local;
use super::local::{mirrored, turned_outside};
use super::microfacets::Microfacets;
use super::refraction::{refracted_about, refracting_normal, transmission, transmission_pdf};
use crate::ids::TextureId;
use crate::material::fields::{WithoutEffect, fields};
use crate::material::number::Number;
use crate::material::plain::{Anisotropy, InScene, Plain, Samples, Scatters};

/// Clear facets that reflect and refract; `+z` points out of the body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RoughDielectric<N: Number = f64> {
    /// The roughness.
    pub microfacets: Microfacets<N>,
    /// Refractive index of the inside relative to the outside, `int_ior / ext_ior`; not 1.
    pub eta: N::Ratio,
    /// Factor on what is reflected.
    pub specular_reflectance: N::Colour,
    /// Factor on what is transmitted.
    pub specular_transmittance: N::Colour,
}

fields! {
    RoughDielectric {
        microfacets: facets(0.1),
        eta: indices(RefractiveIndex { bends: false }, "bk7", "air"),
        specular_reflectance: colour(Reflectance, 1.0),
        specular_transmittance: colour(Transmittance, 1.0),
    }
}

impl<N: Number> Plain for RoughDielectric<N> {
    const PLUGIN: &'static str = "roughdielectric";
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect::SAMPLE_VISIBLE;
    const IS_TWO_SIDED: bool = true;
}

impl InScene for RoughDielectric<TextureId> {
    fn anisotropy(&self) -> Anisotropy {
        Anisotropy::of(&self.microfacets)
    }
}

impl<R: Real> Scatters<R> for RoughDielectric<R> {
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        let (wi, wo, eta) = turned_outside(wi, wo, self.eta);
        if wo.z.value() > 0.0 {
            let h = (wi + wo).normalized();
            let reflectance = fresnel_dielectric(wi.dot(h), eta);
            return self.specular_reflectance
                * (reflectance * self.microfacets.reflection(wi, wo, h));
        }
        let Some(h) = refracting_normal(wi, wo, eta) else {
            return Rgb::zero();
        };
        self.specular_transmittance * transmission(&self.microfacets, wi, wo, h, eta)
    }
}

impl Samples for RoughDielectric {
    /// Reflects or refracts at a visible normal, as Fresnel's equations say;
    /// `None` if that leads to the wrong side of the surface.
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let inside = wi.z < 0.0;
        let (wi, _, eta) = turned_outside(wi, wi, self.eta);
        let m = self.microfacets.sample(wi, u);
        let wo = if choice < fresnel_dielectric(wi.dot(m), eta) {
            Some(local::reflected_about(wi, m)).filter(|wo| wo.z > 0.0)
        } else {
            refracted_about(wi, m, eta).filter(|wo| wo.z < 0.0)
        }?;
        Some(Drawn::Smooth(if inside { mirrored(wo) } else { wo }))
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        let (wi, wo, eta) = turned_outside(wi, wo, self.eta);
        if wo.z > 0.0 {
            let h = (wi + wo).normalized();
            return fresnel_dielectric(wi.dot(h), eta) * self.microfacets.reflection_pdf(wi, h);
        }
        let Some(h) = refracting_normal(wi, wo, eta) else {
            return 0.0;
        };
        let transmittance = 1.0 - fresnel_dielectric(wi.dot(h), eta);
        transmittance * transmission_pdf(&self.microfacets, wi, wo, h, eta)
    }
}
