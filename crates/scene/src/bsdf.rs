//! Materials: what a file says of a surface. What it does to light at a point is
//! in [`crate::lobe`]. To add one: add a variant here, and follow the compiler.

use crate::quantity::Quantity;
use crate::scene::{BsdfId, Scene};
use crate::texture::TextureId;

/// A material and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name; parameters are `<id>.reflectance.value` and so on.
    pub id: String,
    /// What it does to light.
    pub bsdf: Bsdf,
}

/// What a surface does to light.
#[derive(Clone, Debug, PartialEq)]
pub enum Bsdf {
    /// Reflects equally to all directions, from its front side only.
    Diffuse {
        /// Fraction of light reflected.
        reflectance: TextureId,
    },
    /// Has a front and a back.
    TwoSided {
        /// Material of the side that the normal points to.
        front: BsdfId,
        /// Material of the other side.
        back: BsdfId,
    },
}

/// A place for a texture in a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    /// Its name.
    pub name: &'static str,
    /// What stands there.
    pub texture: TextureId,
    /// What its numbers are.
    pub quantity: Quantity,
}

impl Bsdf {
    /// The textures that stand in it.
    pub fn slots(&self) -> Vec<Slot> {
        match *self {
            Self::Diffuse { reflectance } => vec![Slot {
                name: "reflectance",
                texture: reflectance,
                quantity: Quantity::Reflectance,
            }],
            Self::TwoSided { .. } => Vec::new(),
        }
    }

    /// The materials that it is made of.
    pub fn parts(&self) -> Vec<BsdfId> {
        match *self {
            Self::Diffuse { .. } => Vec::new(),
            Self::TwoSided { front, back } => vec![front, back],
        }
    }
}

/// The one-sided material that a surface shows, and on which side.
#[derive(Clone, Copy, Debug)]
pub struct Facing {
    /// The material; never two-sided.
    pub id: BsdfId,
    /// True if it is seen from the back: flip the normal.
    pub flipped: bool,
}

impl Scene {
    /// The material shown to a viewer on the side `cos_i` (positive: the side
    /// the shading normal points to), or `None` if that side is black.
    pub fn facing_bsdf(&self, id: BsdfId, cos_i: f64) -> Option<Facing> {
        let one_sided = |id: BsdfId, flipped: bool| match &self.material(id).bsdf {
            Bsdf::Diffuse { .. } => Some(Facing { id, flipped }),
            Bsdf::TwoSided { .. } => None,
        };
        match &self.material(id).bsdf {
            Bsdf::TwoSided { front, .. } if cos_i > 0.0 => one_sided(*front, false),
            Bsdf::TwoSided { back, .. } if cos_i < 0.0 => one_sided(*back, true),
            Bsdf::Diffuse { .. } if cos_i > 0.0 => one_sided(id, false),
            _ => None,
        }
    }
}
