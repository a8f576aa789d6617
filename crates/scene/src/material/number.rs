//! What a number of a material is: in a scene a texture, at a point a value that may carry derivatives.

use std::fmt::Debug;
use std::sync::Arc;

use capwalk_math::{Real, Rgb};
use serde::{Deserialize, Serialize};

use super::lobe::rough_transmittance::RoughTransmittance;
use crate::ids::TextureId;

/// A number of a material, and what goes with it.
pub trait Number: Copy + Debug + PartialEq {
    /// A number for each channel.
    type Colour: Copy + Debug + PartialEq;
    /// A refractive index relative to the outside, which a scene has as a quotient.
    type Ratio: Copy + Debug + PartialEq;
    /// The refractive index of the principled material, which a scene has in one of two forms.
    type Index: Copy + Debug + PartialEq;
    /// What follows from the rest and takes time to find out: a scene does not have it.
    type Derived<T: Derived>: Clone + Debug + PartialEq;
}

impl<R: Real> Number for R {
    type Colour = Rgb<R>;
    type Ratio = R;
    type Index = R;
    type Derived<T: Derived> = T;
}

impl Number for TextureId {
    type Colour = TextureId;
    type Ratio = Indices;
    type Index = PrincipledIndex;
    type Derived<T: Derived> = ();
}

/// Two refractive indices, of which the quotient counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Indices {
    /// Refractive index on the side that the normal points away from, or of a coat.
    pub int_ior: TextureId,
    /// Refractive index on the side that the normal points to.
    pub ext_ior: TextureId,
}

/// How much a principled material refracts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum PrincipledIndex {
    /// Refractive index relative to the outside.
    Eta(TextureId),
    /// 0 to 1: 8 % of it is reflected at normal incidence.
    Specular(TextureId),
}

/// What follows from a material of a scene where it is resolved.
pub trait Derived: Clone + Debug + PartialEq {
    /// The material.
    type Of<N: Number>;

    /// What follows.
    fn find(material: &Self::Of<TextureId>, at: &impl Circumstances) -> Self;
}

/// What is known where a material is resolved, besides its textures.
pub trait Circumstances {
    /// True if derivatives by the texels of a texture may be asked for: also where there is none of
    /// something, its amount is a number that can change.
    fn may_change(&self, id: TextureId) -> bool;

    /// True if nothing may transmit, whatever changes.
    fn is_opaque(&self) -> bool;

    /// What passes the material's rough coat, if it has one.
    fn coat(&self) -> Option<&Arc<RoughTransmittance>>;
}
