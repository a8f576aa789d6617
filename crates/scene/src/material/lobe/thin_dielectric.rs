//! The clear pane.

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::{Drawn, Event};
use super::fresnel::fresnel_dielectric;
use super::local;
use crate::ids::TextureId;
use crate::material::fields::fields;
use crate::material::number::Number;
use crate::material::plain::{InScene, Plain, Samples, Scatters};

/// A pane of glass without thickness: light that is not reflected, after any
/// number of reflections inside, goes straight on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ThinDielectric<N: Number = f64> {
    /// Refractive index of the glass relative to what is around it.
    pub eta: N::Ratio,
    /// Factor on what is reflected.
    pub specular_reflectance: N::Colour,
    /// Factor on what passes.
    pub specular_transmittance: N::Colour,
}

fields! {
    ThinDielectric {
        eta: indices(RefractiveIndex { bends: false }, "bk7", "air"),
        specular_reflectance: colour(Reflectance, 1.0),
        specular_transmittance: colour(Transmittance, 1.0),
    }
}

impl<N: Number> Plain for ThinDielectric<N> {
    const PLUGIN: &'static str = "thindielectric";
    const EVENTS: &'static [Event] = &[Event::Reflect, Event::Pass];
    const IS_TWO_SIDED: bool = true;
}

impl InScene for ThinDielectric<TextureId> {}

impl<R: Real> ThinDielectric<R> {
    /// All that comes back, `r + t r t + t r³ t + ... = 2 r / (1 + r)`.
    #[inline]
    fn reflectance(&self, wi: Vec3<R>) -> R {
        let once = fresnel_dielectric(wi.z.abs(), self.eta);
        once * R::constant(2.0) / (R::constant(1.0) + once)
    }

    #[inline]
    fn reflect(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        (
            local::reflected(wi),
            self.specular_reflectance * self.reflectance(wi),
        )
    }

    #[inline]
    fn pass(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let transmittance = R::constant(1.0) - self.reflectance(wi);
        (-wi, self.specular_transmittance * transmittance)
    }
}

impl<R: Real> Scatters<R> for ThinDielectric<R> {
    #[inline]
    fn specular(&self, event: Event, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        match event {
            Event::Reflect => self.reflect(wi),
            Event::Transmit | Event::Pass => self.pass(wi),
        }
    }
}

impl Samples for ThinDielectric {
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, _: [f64; 2]) -> Option<Drawn> {
        let reflected = self.reflectance(wi);
        Some(if choice < reflected {
            Drawn::Specular(Event::Reflect, reflected)
        } else {
            Drawn::Specular(Event::Pass, 1.0 - reflected)
        })
    }
}
