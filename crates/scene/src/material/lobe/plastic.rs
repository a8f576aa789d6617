//! Plastic: a clear coat over a diffuse base.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::coat::{base, base_probability, choice_weights};
use super::event::{Drawn, Event};
use super::fresnel::{fresnel_dielectric, fresnel_diffuse};
use super::local;
use crate::ids::TextureId;
use crate::material::fields::{WithoutEffect, fields};
use crate::material::number::Number;
use crate::material::plain::{InScene, Plain, Samples, Scatters};

/// A smooth dielectric over a diffuse base: a mirror image, and light that
/// enters, is scattered below any number of times, and leaves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plastic<N: Number = f64> {
    /// Refractive index of the coat relative to the outside, `int_ior / ext_ior`.
    pub eta: N::Ratio,
    /// Fraction of light reflected by the base, per channel.
    pub diffuse_reflectance: N::Colour,
    /// Factor on the mirror image.
    pub specular_reflectance: N::Colour,
    /// True if light that is thrown back by the coat from inside takes the
    /// colour of the base again, each time: colours get more saturated.
    pub nonlinear: bool,
}

fields! {
    Plastic {
        eta: indices(RefractiveIndex { bends: false }, "polypropylene", "air"),
        diffuse_reflectance: colour(Reflectance, 0.5),
        specular_reflectance: colour(Reflectance, 1.0),
        nonlinear: flag(false),
    }
}

impl<N: Number> Plain for Plastic<N> {
    const PLUGIN: &'static str = "plastic";
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect::SAMPLE_VISIBLE;
    const EVENTS: &'static [Event] = &[Event::Reflect];
    const HAS_SMOOTH: bool = true;
}

impl InScene for Plastic<TextureId> {}

impl<R: Real> Scatters<R> for Plastic<R> {
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let one = R::constant(1.0);
        let enters = one - fresnel_dielectric(local::raised(wi).z, self.eta);
        let leaves = one - fresnel_dielectric(wo.z, self.eta);
        let internal = fresnel_diffuse(one / self.eta);
        // Radiance shrinks by `1 / eta²` on the way out.
        let scale = enters * leaves * wo.z * R::constant(FRAC_1_PI) / self.eta.squared();
        base(self.diffuse_reflectance, internal, self.nonlinear) * scale
    }

    #[inline]
    fn specular(&self, _: Event, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let wi = local::raised(wi);
        let reflectance = fresnel_dielectric(wi.z, self.eta);
        (
            local::reflected(wi),
            self.specular_reflectance * reflectance,
        )
    }
}

impl Plastic {
    #[inline]
    fn base_probability(&self, wi: Vec3) -> f64 {
        let transmittance = 1.0 - fresnel_dielectric(wi.z.abs(), self.eta);
        let weights = choice_weights(self.diffuse_reflectance, self.specular_reflectance);
        base_probability(transmittance, weights)
    }
}

impl Samples for Plastic {
    /// The mirror image or a direction by the cosine.
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let base = self.base_probability(wi);
        Some(if choice < base {
            Drawn::Smooth(local::sample_cosine(u))
        } else {
            Drawn::Specular(Event::Reflect, 1.0 - base)
        })
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        self.base_probability(wi) * local::cosine_pdf(wo)
    }
}
