//! Materials: what a file says of a surface. What it does to light at a point is
//! in [`crate::lobe`].

use serde::{Deserialize, Serialize};

use super::fields::{FieldChoice, FieldList};
use super::lobe::list::{Lobe, Stored};
use crate::ids::{BsdfId, TextureId};
use crate::quantity::Quantity;
use crate::slot::Slot;

/// A material and its name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Its name; parameters are `<id>.reflectance.value` and so on.
    pub id: String,
    /// What it does to light.
    pub bsdf: Bsdf,
}

/// What a surface does to light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Bsdf {
    /// One that is not made of others.
    Plain(#[serde(with = "Stored")] Lobe<TextureId>),
    /// Has a front and a back.
    TwoSided {
        /// Material of the side that the normal points to.
        front: BsdfId,
        /// Material of the other side.
        back: BsdfId,
    },
    /// Partly there.
    Mask {
        /// Fraction of light that interacts with the material; the rest passes.
        opacity: TextureId,
        /// The material.
        nested: BsdfId,
    },
    /// Two materials mixed.
    Blend {
        /// Fraction of the second.
        weight: TextureId,
        /// The materials.
        nested: [BsdfId; 2],
    },
    /// Normals from a texture, relative to the shading frame.
    NormalMap {
        /// `(n + 1) / 2`.
        normals: TextureId,
        /// The material.
        nested: BsdfId,
        /// What is done about normals that go too far.
        limits: NormalLimits,
    },
    /// Normals from the derivatives of a texture.
    BumpMap {
        /// Heights, in world units.
        heights: TextureId,
        /// Factor on the heights; a constant.
        scale: TextureId,
        /// The material.
        nested: BsdfId,
        /// What is done about normals that go too far.
        limits: NormalLimits,
    },
}

/// What is done about perturbed normals that go too far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct NormalLimits {
    /// True if normals that turn away from the viewer are turned back.
    pub flip_invalid: bool,
    /// True if light fades where the surface would hide itself.
    pub shadowing: bool,
}

impl<T> From<T> for Bsdf
where
    Lobe<TextureId>: From<T>,
{
    fn from(it: T) -> Self {
        Self::Plain(it.into())
    }
}

impl Bsdf {
    /// The plugin's name.
    pub fn plugin(&self) -> &'static str {
        match self {
            Self::Plain(lobe) => lobe.plugin(),
            Self::TwoSided { .. } => "twosided",
            Self::Mask { .. } => "mask",
            Self::Blend { .. } => "blendbsdf",
            Self::NormalMap { .. } => "normalmap",
            Self::BumpMap { .. } => "bumpmap",
        }
    }

    /// What stands in it, besides other materials.
    pub fn list(&self) -> FieldList {
        use Quantity::{Fraction, Height, Normal, SignedFactor};
        let mut list = FieldList::default();
        let limited = |list: &mut FieldList, limits: &NormalLimits| {
            list.choice(
                "flip_invalid_normals",
                FieldChoice::Flag(limits.flip_invalid),
            );
            list.choice(
                "use_shadowing_function",
                FieldChoice::Flag(limits.shadowing),
            );
        };
        match self {
            Self::Plain(lobe) => return lobe.list(),
            Self::TwoSided { .. } => {}
            Self::Mask { opacity, .. } => list.slot("opacity", Fraction, *opacity),
            Self::Blend { weight, .. } => list.slot("weight", Fraction, *weight),
            Self::NormalMap {
                normals, limits, ..
            } => {
                list.slot("normalmap", Normal, *normals);
                limited(&mut list, limits);
            }
            Self::BumpMap {
                heights,
                scale,
                limits,
                ..
            } => {
                list.slot("nested_texture", Height, *heights);
                list.slot("scale", SignedFactor, *scale);
                limited(&mut list, limits);
            }
        }
        list
    }

    /// The textures that stand in it.
    pub fn slots(&self) -> Vec<Slot> {
        self.list().slots
    }
}
