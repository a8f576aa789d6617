//! The smooth metal.

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::{Drawn, Event};
use super::fresnel::fresnel_conductor;
use super::local;
use crate::ids::TextureId;
use crate::material::fields::fields;
use crate::material::number::Number;
use crate::material::plain::{InScene, Plain, Samples, Scatters};

/// A mirror that reflects as much as a metal does.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Conductor<N: Number = f64> {
    /// Real part of the refractive index, per channel; 0 with `k` = 1 reflects all.
    pub eta: N::Colour,
    /// Imaginary part of the refractive index, per channel.
    pub k: N::Colour,
    /// Factor on what is reflected.
    pub specular_reflectance: N::Colour,
}

fields! {
    Conductor {
        eta: colour(MetalIndex, 0.0),
        k: colour(Extinction, 1.0),
        specular_reflectance: colour(Reflectance, 1.0),
    }
}

impl<N: Number> Plain for Conductor<N> {
    const PLUGIN: &'static str = "conductor";
    const EVENTS: &'static [Event] = &[Event::Reflect];
}

impl InScene for Conductor<TextureId> {}

impl<R: Real> Scatters<R> for Conductor<R> {
    #[inline]
    fn specular(&self, _: Event, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let wi = local::raised(wi);
        let reflectance = fresnel_conductor(wi.z, self.eta, self.k);
        (
            local::reflected(wi),
            reflectance * self.specular_reflectance,
        )
    }
}

impl Samples for Conductor {
    #[inline]
    fn sample(&self, _: Vec3, _: f64, _: [f64; 2]) -> Option<Drawn> {
        Some(Drawn::Specular(Event::Reflect, 1.0))
    }
}
