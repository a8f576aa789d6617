//! Emitters.

pub mod delta;
mod environment;
mod guides;

pub use environment::{EnvironmentMap, EnvironmentTable, MapPlace};

use capwalk_geometry::Apex;
use capwalk_math::{Affine, Vec3};
use serde::{Deserialize, Serialize};

use crate::ids::{ShapeId, TextureId};
use crate::quantity::Quantity;
use crate::slot::Slot;

/// What sends out light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Emitter {
    /// A shape that emits the same radiance in every direction from its front.
    Area {
        /// The shape.
        shape: ShapeId,
        /// What it emits.
        radiance: TextureId,
    },
    /// The same radiance from every direction in which no shape is hit.
    Constant {
        /// Name of the emitter, for parameters.
        id: String,
        /// What it emits.
        radiance: TextureId,
    },
    /// Radiance from an image of all directions.
    EnvironmentMap {
        /// Name of the emitter, for parameters.
        id: String,
        /// The image's size and rotation.
        map: EnvironmentMap,
        /// Its texels.
        data: TextureId,
        /// Factor on them.
        scale: TextureId,
    },
    /// A point that emits equally in all directions.
    Point {
        /// Name of the emitter, for parameters.
        id: String,
        /// Where it is.
        position: Vec3,
        /// Power per solid angle.
        intensity: TextureId,
    },
    /// A point that emits into a cone.
    Spot {
        /// Name of the emitter, for parameters.
        id: String,
        /// The emitter is at the origin of its own space and shines along `+z`.
        world_from_emitter: Affine,
        /// Power per solid angle in the middle.
        intensity: TextureId,
        /// Angle to the axis beyond which it is dark, degrees.
        cutoff_angle: TextureId,
        /// Angle to the axis up to which it is as bright as in the middle,
        /// degrees; in between it falls linearly.
        beam_width: TextureId,
        /// An image that it projects, as a factor: it covers the square around the cone.
        texture: Option<TextureId>,
    },
    /// A point that projects an image, as a perspective camera would see it.
    Projector {
        /// Name of the emitter, for parameters.
        id: String,
        /// The emitter is at the origin of its own space and shines along `+z`, with `+y`
        /// up and `+x` to the left of the image.
        world_from_emitter: Affine,
        /// Half the width and half the height of the image at distance 1.
        half_size: [f64; 2],
        /// The image: power per area across the axis at distance 1, over π.
        irradiance: TextureId,
        /// Factor on it.
        scale: TextureId,
    },
    /// Parallel light.
    Directional {
        /// Name of the emitter, for parameters.
        id: String,
        /// Where the light goes, a unit vector.
        direction: Vec3,
        /// Power per area across it.
        irradiance: TextureId,
    },
}

/// The answers that every emitter must give, whatever its numbers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EmitterTraits {
    /// What Mitsuba calls it.
    pub plugin: &'static str,
    /// Where it is.
    pub extent: EmitterExtent,
}

/// Where an emitter is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EmitterExtent {
    /// On the front of a shape, with edges that can be seen.
    Shape(ShapeId),
    /// In all directions around the scene.
    Surroundings,
    /// At a point or in one direction: no ray meets it, and its shadows are hard.
    Delta,
}

impl Emitter {
    /// What must be known of every emitter.
    pub fn traits(&self) -> EmitterTraits {
        let (plugin, extent) = match self {
            Self::Area { shape, .. } => ("area", EmitterExtent::Shape(*shape)),
            Self::Constant { .. } => ("constant", EmitterExtent::Surroundings),
            Self::EnvironmentMap { .. } => ("envmap", EmitterExtent::Surroundings),
            Self::Point { .. } => ("point", EmitterExtent::Delta),
            Self::Spot { .. } => ("spot", EmitterExtent::Delta),
            Self::Projector { .. } => ("projector", EmitterExtent::Delta),
            Self::Directional { .. } => ("directional", EmitterExtent::Delta),
        };
        EmitterTraits { plugin, extent }
    }

    /// What it emits: radiance, intensity or irradiance.
    #[inline]
    pub fn radiance(&self) -> TextureId {
        match self {
            Self::Area { radiance, .. } | Self::Constant { radiance, .. } => *radiance,
            Self::EnvironmentMap { data, .. } => *data,
            Self::Point { intensity, .. } | Self::Spot { intensity, .. } => *intensity,
            Self::Projector { irradiance, .. } | Self::Directional { irradiance, .. } => {
                *irradiance
            }
        }
    }

    /// The plugin's name.
    pub fn plugin(&self) -> &'static str {
        self.traits().plugin
    }

    /// The textures that stand in it. The texels of an environment map are its
    /// own: their slot has no name.
    pub fn slots(&self) -> Vec<Slot> {
        let slot = |name, texture, quantity| Slot {
            name,
            texture,
            quantity,
        };
        match self {
            Self::Area { radiance, .. } | Self::Constant { radiance, .. } => {
                vec![slot("radiance", *radiance, Quantity::Radiance)]
            }
            Self::EnvironmentMap { data, scale, .. } => vec![
                slot("", *data, Quantity::Radiance),
                slot("scale", *scale, Quantity::Factor),
            ],
            Self::Point { intensity, .. } => {
                vec![slot("intensity", *intensity, Quantity::Intensity)]
            }
            Self::Spot {
                intensity,
                cutoff_angle,
                beam_width,
                texture,
                ..
            } => {
                let mut slots = vec![
                    slot("intensity", *intensity, Quantity::Intensity),
                    slot("cutoff_angle", *cutoff_angle, Quantity::Angle),
                    slot("beam_width", *beam_width, Quantity::Angle),
                ];
                slots.extend(texture.map(|texture| slot("texture", texture, Quantity::Factor)));
                slots
            }
            Self::Projector {
                irradiance, scale, ..
            } => vec![
                slot("irradiance", *irradiance, Quantity::Irradiance),
                slot("scale", *scale, Quantity::Factor),
            ],
            Self::Directional { irradiance, .. } => {
                vec![slot("irradiance", *irradiance, Quantity::Irradiance)]
            }
        }
    }

    /// The texture by which its radiance is multiplied, if it has one.
    #[inline]
    pub fn factor(&self) -> Option<TextureId> {
        match self {
            Self::EnvironmentMap { scale, .. } | Self::Projector { scale, .. } => Some(*scale),
            Self::Spot { texture, .. } => *texture,
            Self::Area { .. }
            | Self::Constant { .. }
            | Self::Point { .. }
            | Self::Directional { .. } => None,
        }
    }

    /// The image that it projects and the name of its slot, if it has one.
    pub fn projected_image(&self) -> Option<(&'static str, TextureId)> {
        match self {
            Self::Projector { irradiance, .. } => Some(("irradiance", *irradiance)),
            Self::Spot { texture, .. } => texture.map(|texture| ("texture", texture)),
            Self::Area { .. }
            | Self::Constant { .. }
            | Self::EnvironmentMap { .. }
            | Self::Point { .. }
            | Self::Directional { .. } => None,
        }
    }

    /// True if it surrounds the scene.
    pub fn is_environment(&self) -> bool {
        match self.traits().extent {
            EmitterExtent::Surroundings => true,
            EmitterExtent::Shape(_) | EmitterExtent::Delta => false,
        }
    }

    /// True if it has no extent: no ray meets it, and its shadows are hard.
    pub fn is_delta(&self) -> bool {
        match self.traits().extent {
            EmitterExtent::Delta => true,
            EmitterExtent::Shape(_) | EmitterExtent::Surroundings => false,
        }
    }

    /// Where its light comes from, if it has no extent.
    pub fn apex(&self) -> Option<Apex> {
        match self {
            Self::Area { .. } | Self::Constant { .. } | Self::EnvironmentMap { .. } => None,
            Self::Point { position, .. } => Some(Apex::Point(*position)),
            Self::Spot {
                world_from_emitter, ..
            }
            | Self::Projector {
                world_from_emitter, ..
            } => Some(Apex::Point(world_from_emitter.translation)),
            Self::Directional { direction, .. } => Some(Apex::Direction(*direction)),
        }
    }

    /// The shape that emits, if one does.
    pub fn shape(&self) -> Option<ShapeId> {
        match self.traits().extent {
            EmitterExtent::Shape(shape) => Some(shape),
            EmitterExtent::Surroundings | EmitterExtent::Delta => None,
        }
    }
}
