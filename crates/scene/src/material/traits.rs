//! What follows from a material for all who trace paths and look for boundaries.

use super::bsdf::{Bsdf, NormalLimits};
use super::lobe::event::Event;
use super::plain::Anisotropy;
use crate::ids::BsdfId;

/// The answers that every material must give, whatever its numbers are.
///
/// They are for the material alone, not for those that it is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialTraits {
    /// Reflects some light in one direction alone, as mirrors do. What refracts light in
    /// one direction alone reflects so, too.
    pub is_specular: bool,
    /// Refracts some light in one direction alone: what is seen through it is bent.
    pub refracts: bool,
    /// Lets some light pass straight on.
    pub passes_light: bool,
    /// Looks different from different sides.
    pub is_glossy: bool,
    /// Whether it matters how it is turned about the normal.
    pub anisotropy: Anisotropy,
    /// Other materials that it is made of.
    pub composition: Composition,
}

/// How a material is made of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Composition {
    /// It is not.
    Plain,
    /// One on each side.
    Sides {
        /// Of the side that the normal points to.
        front: BsdfId,
        /// Of the other side.
        back: BsdfId,
    },
    /// Two, mixed.
    Mixture([BsdfId; 2]),
    /// One, of which less is seen.
    Partial(BsdfId),
    /// One, about other normals.
    Perturbed {
        /// The material.
        nested: BsdfId,
        /// What is done about normals that go too far.
        limits: NormalLimits,
    },
}

impl Bsdf {
    /// What must be known of every material.
    pub fn traits(&self) -> MaterialTraits {
        let made_of = |composition| MaterialTraits {
            is_specular: false,
            refracts: false,
            passes_light: false,
            is_glossy: false,
            anisotropy: Anisotropy::Isotropic,
            composition,
        };
        match *self {
            Self::Plain(ref lobe) => {
                let has = |event| lobe.events().contains(&event);
                MaterialTraits {
                    is_specular: has(Event::Reflect),
                    refracts: has(Event::Transmit),
                    passes_light: has(Event::Pass),
                    is_glossy: lobe.is_glossy(),
                    anisotropy: lobe.anisotropy(),
                    composition: Composition::Plain,
                }
            }
            Self::TwoSided { front, back } => made_of(Composition::Sides { front, back }),
            Self::Mask { nested, .. } => MaterialTraits {
                passes_light: true,
                ..made_of(Composition::Partial(nested))
            },
            Self::Blend { nested, .. } => made_of(Composition::Mixture(nested)),
            Self::NormalMap { nested, limits, .. } | Self::BumpMap { nested, limits, .. } => {
                made_of(Composition::Perturbed { nested, limits })
            }
        }
    }

    /// What is done about normals that go too far, if it is a map of normals or
    /// heights.
    pub fn normal_limits(&self) -> Option<NormalLimits> {
        match self.traits().composition {
            Composition::Perturbed { limits, .. } => Some(limits),
            Composition::Plain
            | Composition::Sides { .. }
            | Composition::Mixture(_)
            | Composition::Partial(_) => None,
        }
    }

    /// The materials that it is made of.
    pub fn parts(&self) -> Vec<BsdfId> {
        let parts = self.named_parts().into_iter();
        parts.map(|(_, part)| part).collect()
    }

    /// The materials that it is made of, and their names in it.
    pub fn named_parts(&self) -> Vec<(&'static str, BsdfId)> {
        match self.traits().composition {
            Composition::Plain => Vec::new(),
            Composition::Sides { front, back } => vec![("brdf_0", front), ("brdf_1", back)],
            Composition::Mixture([first, second]) => vec![("bsdf_0", first), ("bsdf_1", second)],
            Composition::Partial(nested) | Composition::Perturbed { nested, .. } => {
                vec![("nested_bsdf", nested)]
            }
        }
    }

    /// The one material that shades all of its visible sides, if it is made of
    /// one.
    pub fn shown_part(&self) -> Option<BsdfId> {
        match self.traits().composition {
            Composition::Sides { front, back } => (front == back).then_some(front),
            Composition::Partial(nested) | Composition::Perturbed { nested, .. } => Some(nested),
            Composition::Plain | Composition::Mixture(_) => None,
        }
    }
}
