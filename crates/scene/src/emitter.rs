//! Light sources.

use crate::scene::{Scene, ShapeId};
use crate::texture::TextureId;

/// A light source.
#[derive(Clone, Debug, PartialEq)]
pub enum Emitter {
    /// A shape that emits the same radiance in every direction from its front.
    Area {
        /// The shape.
        shape: ShapeId,
        /// What it emits.
        radiance: TextureId,
    },
    /// The same radiance from every direction that meets no shape.
    Constant {
        /// Name of the emitter, for parameters.
        id: String,
        /// What it emits.
        radiance: TextureId,
    },
}

impl Emitter {
    /// What it emits.
    #[inline]
    pub fn radiance(&self) -> TextureId {
        match self {
            Self::Area { radiance, .. } | Self::Constant { radiance, .. } => *radiance,
        }
    }

    /// True if it surrounds the scene.
    pub fn is_environment(&self) -> bool {
        matches!(self, Self::Constant { .. })
    }

    /// What users call it: `<shape>.emitter`, or its own id.
    pub fn name(&self, scene: &Scene) -> String {
        match self {
            Self::Area { shape, .. } => format!("{}.emitter", scene.shape(*shape).id),
            Self::Constant { id, .. } => id.clone(),
        }
    }
}
