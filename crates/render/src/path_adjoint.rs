//! The derivative of a path's light with respect to one of the numbers that it is made of.

use capwalk_math::{Rgb, Vec3};
use capwalk_scene::{EmitterId, TextureId};

/// A number that the light of a path depends on, with the covector on it.
#[derive(Clone, Copy, Debug)]
pub enum PathAdjoint {
    /// A texel. Each channel of light depends on the same channel of the texel, or all of them on its
    /// only one: the covector has what belongs to each channel of light.
    Texel {
        /// The texture that has it.
        texture: TextureId,
        /// Which texel.
        index: usize,
        /// For each channel of light.
        covector: Rgb,
    },
    /// A texel each of whose channels changes all of the light.
    MixedTexel {
        /// The texture that has it.
        texture: TextureId,
        /// Which texel.
        index: usize,
        /// For each channel of the texel what belongs to each channel of light.
        covectors: [Rgb; 3],
    },
    /// What a point receives from an emitter without extent.
    Irradiance {
        /// The emitter.
        emitter: EmitterId,
        /// The point.
        position: Vec3,
        /// On the irradiance.
        covector: Rgb,
    },
}
