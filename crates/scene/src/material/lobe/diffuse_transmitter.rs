//! The diffuse transmitter: leaves, paper, lampshades.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::coat::choice_weights;
use super::event::Drawn;
use super::local::{self, mirrored};
use crate::ids::TextureId;
use crate::material::fields::fields;
use crate::material::number::Number;
use crate::material::plain::{InScene, Plain, Samples, Scatters, TextureOf};

/// A sheet that scatters light equally to all directions on both sides, alike from both: that of
/// Mitsuba 0.6 if `reflectance` is zero, and pbrt's `diffusetransmission`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct DiffuseTransmitter<N: Number = f64> {
    /// Fraction of light scattered back to the side from which it comes, per channel.
    pub reflectance: N::Colour,
    /// Fraction of light scattered to the other side, per channel.
    pub transmittance: N::Colour,
}

fields! {
    DiffuseTransmitter {
        reflectance: colour(Reflectance, 0.0),
        transmittance: colour(Transmittance, 0.5),
    }
}

impl<N: Number> Plain for DiffuseTransmitter<N> {
    const PLUGIN: &'static str = "difftrans";
    const IS_TWO_SIDED: bool = true;
    const IS_GLOSSY: bool = false;
}

impl InScene for DiffuseTransmitter<TextureId> {
    fn warning(&self, texture: TextureOf) -> Option<&'static str> {
        let parts = [self.reflectance, self.transmittance].map(texture);
        let are_known = parts.iter().all(|part| part.is_constant());
        let scatters_more = || (parts[0].texel(0) + parts[1].texel(0)).max_component() > 1.0;
        (are_known && scatters_more()).then_some(
            "\"reflectance\" and \"transmittance\" are above 1 together: the surface scatters more \
             than it receives",
        )
    }
}

/// True if light between two directions stays on its side.
#[inline]
fn is_reflected<R: Real>(wi: Vec3<R>, wo: Vec3<R>) -> bool {
    (wi.z.value() >= 0.0) == (wo.z.value() >= 0.0)
}

impl<R: Real> Scatters<R> for DiffuseTransmitter<R> {
    /// `reflectance / π · |cos|`, or `transmittance / π · |cos|` on the other side.
    #[inline]
    fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        let scattered = match is_reflected(wi, wo) {
            true => self.reflectance,
            false => self.transmittance,
        };
        scattered * (wo.z.abs() * R::constant(FRAC_1_PI))
    }
}

impl DiffuseTransmitter {
    /// Probability of choosing the side from which the light comes; what is black may have a
    /// derivative, and is sampled a little.
    #[inline]
    fn reflection(&self) -> f64 {
        let [stays, passes] = choice_weights(self.reflectance, self.transmittance);
        stays / (stays + passes)
    }
}

impl Samples for DiffuseTransmitter {
    /// A direction by the cosine, on either side.
    #[inline]
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let wo = local::sample_cosine(u);
        let is_above = (choice < self.reflection()) == (wi.z >= 0.0);
        Some(Drawn::Smooth(if is_above { wo } else { mirrored(wo) }))
    }

    #[inline]
    fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        let chance = match is_reflected(wi, wo) {
            true => self.reflection(),
            false => 1.0 - self.reflection(),
        };
        chance * local::cosine_pdf(local::raised(wo))
    }
}
