//! The ideally diffuse surface.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::Drawn;
use super::local;
use crate::ids::TextureId;
use crate::material::fields::fields;
use crate::material::number::Number;
use crate::material::plain::{InScene, Plain, Samples, Scatters};

/// Reflects the same radiance to all directions in front of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Diffuse<N: Number = f64> {
    /// Fraction of light reflected, per channel.
    pub reflectance: N::Colour,
}

fields! {
    Diffuse {
        reflectance: colour(Reflectance, 0.5),
    }
}

impl<N: Number> Plain for Diffuse<N> {
    const PLUGIN: &'static str = "diffuse";
    const IS_GLOSSY: bool = false;
}

impl InScene for Diffuse<TextureId> {}

impl<R: Real> Scatters<R> for Diffuse<R> {
    /// `reflectance / π · cos⁺`.
    #[inline]
    fn eval(&self, _: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        self.reflectance * (wo.z * R::constant(FRAC_1_PI))
    }
}

impl Samples for Diffuse {
    #[inline]
    fn sample(&self, _: Vec3, _: f64, u: [f64; 2]) -> Option<Drawn> {
        Some(Drawn::Smooth(local::sample_cosine(u)))
    }

    #[inline]
    fn pdf(&self, _: Vec3, wo: Vec3) -> f64 {
        local::cosine_pdf(wo)
    }
}
