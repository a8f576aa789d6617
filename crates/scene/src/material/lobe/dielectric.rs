//! The smooth surface of a clear body.

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::{Drawn, Event};
use super::fresnel::cos_refracted;
use super::fresnel::fresnel_dielectric;
use super::local;
use crate::ids::TextureId;
use crate::material::fields::fields;
use crate::material::number::Number;
use crate::material::plain::{InScene, Plain, Samples, Scatters};

/// Reflects and refracts at one surface; `+z` points out of the body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dielectric<N: Number = f64> {
    /// Refractive index of the inside relative to the outside, `int_ior / ext_ior`.
    pub eta: N::Ratio,
    /// Factor on what is reflected.
    pub specular_reflectance: N::Colour,
    /// Factor on what is transmitted.
    pub specular_transmittance: N::Colour,
}

fields! {
    Dielectric {
        eta: indices(RefractiveIndex { bends: true }, "bk7", "air"),
        specular_reflectance: colour(Reflectance, 1.0),
        specular_transmittance: colour(Transmittance, 1.0),
    }
}

impl<N: Number> Plain for Dielectric<N> {
    const PLUGIN: &'static str = "dielectric";
    const EVENTS: &'static [Event] = &[Event::Reflect, Event::Transmit];
    const IS_TWO_SIDED: bool = true;
}

impl InScene for Dielectric<TextureId> {}

impl<R: Real> Dielectric<R> {
    /// The refractive index of the far side relative to the near one.
    #[inline]
    fn far_over_near(&self, wi: Vec3<R>) -> R {
        if wi.z.value() < 0.0 {
            R::constant(1.0) / self.eta
        } else {
            self.eta
        }
    }

    #[inline]
    fn reflect(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let reflectance = fresnel_dielectric(wi.z.abs(), self.far_over_near(wi));
        (
            local::reflected(wi),
            self.specular_reflectance * reflectance,
        )
    }

    /// Radiance shrinks by `1 / eta²` when it leaves the denser side, because
    /// its cone widens. Black where everything is reflected.
    #[inline]
    fn transmit(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let eta = self.far_over_near(wi);
        let Some(cos_t) = cos_refracted(wi.z.abs(), eta) else {
            return (-wi, Rgb::zero());
        };
        let cos_t = if wi.z.value() < 0.0 { cos_t } else { -cos_t };
        let transmittance = R::constant(1.0) - fresnel_dielectric(wi.z.abs(), eta);
        (
            Vec3::new(-wi.x / eta, -wi.y / eta, cos_t),
            self.specular_transmittance * (transmittance / eta.squared()),
        )
    }
}

impl<R: Real> Scatters<R> for Dielectric<R> {
    #[inline]
    fn specular(&self, event: Event, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        match event {
            Event::Reflect => self.reflect(wi),
            Event::Transmit | Event::Pass => self.transmit(wi),
        }
    }
}

impl Samples for Dielectric {
    /// Reflects with the probability that Fresnel's equations give.
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, _: [f64; 2]) -> Option<Drawn> {
        let reflected = fresnel_dielectric(wi.z.abs(), self.far_over_near(wi));
        Some(if choice < reflected {
            Drawn::Specular(Event::Reflect, reflected)
        } else {
            Drawn::Specular(Event::Transmit, 1.0 - reflected)
        })
    }
}
