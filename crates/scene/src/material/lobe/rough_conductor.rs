//! The rough metal.

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::Drawn;
use super::fresnel::fresnel_conductor;
use super::local;
use super::microfacets::Microfacets;
use super::rough_surface::RoughSurface;
use crate::ids::TextureId;
use crate::material::fields::{WithoutEffect, fields};
use crate::material::number::Number;
use crate::material::plain::{Anisotropy, InScene, Plain, Samples, Scatters};

/// Metal mirrors as microfacets.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RoughConductor<N: Number = f64> {
    /// The roughness.
    pub microfacets: Microfacets<N>,
    /// Real part of the refractive index, per channel; 0 with `k` = 1 reflects all.
    pub eta: N::Colour,
    /// Imaginary part of the refractive index, per channel.
    pub k: N::Colour,
    /// Factor on what is reflected.
    pub specular_reflectance: N::Colour,
}

fields! {
    RoughConductor {
        microfacets: facets(0.1),
        eta: colour(MetalIndex, 0.0),
        k: colour(Extinction, 1.0),
        specular_reflectance: colour(Reflectance, 1.0),
    }
}

impl<N: Number> Plain for RoughConductor<N> {
    const PLUGIN: &'static str = "roughconductor";
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect::SAMPLE_VISIBLE;
    const HAS_FACETS: bool = true;
}

impl InScene for RoughConductor<TextureId> {
    fn anisotropy(&self) -> Anisotropy {
        Anisotropy::of(&self.microfacets)
    }
}

impl<R: Real> Scatters<R> for RoughConductor<R> {
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let wi = local::raised(wi);
        let h = (wi + wo).normalized();
        let reflectance = fresnel_conductor(wi.dot(h), self.eta, self.k);
        reflectance * self.specular_reflectance * self.microfacets.reflection(wi, wo, h)
    }

    #[inline]
    fn mirrored(&self, wi: Vec3<R>, wo: Vec3<R>, visit: &mut impl FnMut(Rgb<R>, R)) {
        visit(self.eval(wi, wo), self.microfacets.alpha2());
    }
}

impl Samples for RoughConductor {
    /// Reflects at a visible normal; `None` if that leads below the surface,
    /// to another facet that the model does not follow.
    #[inline]
    fn sample(&self, wi: Vec3, _: f64, u: [f64; 2]) -> Option<Drawn> {
        let wi = local::raised(wi);
        let wo = local::reflected_about(wi, self.microfacets.sample(wi, u));
        (wo.z > 0.0).then_some(Drawn::Smooth(wo))
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if wo.z <= 0.0 {
            return 0.0;
        }
        let wi = local::raised(wi);
        self.microfacets.reflection_pdf(wi, (wi + wo).normalized())
    }

    #[inline]
    fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
        if wo.z <= 0.0 {
            return (Rgb::zero(), 0.0);
        }
        let mirrored = self.microfacets.mirrored(local::raised(wi), wo);
        let reflectance = fresnel_conductor(mirrored.cos, self.eta, self.k);
        let colour = reflectance * self.specular_reflectance;
        (colour * mirrored.scattered, mirrored.pdf)
    }

    fn rough_surface(&self, weight: f64) -> Option<RoughSurface> {
        let colour = self.specular_reflectance * weight;
        Some(RoughSurface::metal_of(
            self.microfacets,
            colour,
            self.eta,
            self.k,
        ))
    }
}
