//! The numbers that the name of a scalar parameter refers to.

use crate::ids::{EmitterId, ShapeId, TextureId};
use crate::quantity::Quantity;
use crate::sensor::Optic;
use crate::texture::NamedTexels;

/// What a name refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Target {
    Translate(ShapeId, usize),
    Rotate(ShapeId, usize),
    Scale(ShapeId),
    /// Some texels of a texture together.
    Texels(TextureId, NamedTexels, Quantity, Channel),
    /// A light without extent.
    TranslateLight(EmitterId, usize),
    RotateLight(EmitterId, usize),
    TranslateSensor(usize),
    RotateSensor(usize),
    SensorOptic(Optic),
}

/// Which channels of a colour change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channel {
    All,
    One(usize),
}

impl Channel {
    pub(super) const EACH: [Self; 4] = [Self::All, Self::One(0), Self::One(1), Self::One(2)];

    /// The ones that a texture has.
    pub(super) fn of_texture(channels: usize) -> &'static [Self] {
        match channels {
            1 => &Self::EACH[..1],
            _ => &Self::EACH,
        }
    }

    /// True if this channel is among them.
    pub(super) fn contains(self, channel: usize) -> bool {
        matches!(self, Self::All) || self == Self::One(channel)
    }

    pub(super) fn suffix(self) -> &'static str {
        match self {
            Self::All => "",
            Self::One(channel) => [".r", ".g", ".b"][channel],
        }
    }

    pub(super) fn values(self, texel: &[f64]) -> Vec<f64> {
        match self {
            Self::All => texel.to_vec(),
            Self::One(channel) => vec![texel[channel]],
        }
    }

    pub(super) fn of(self, what: &str, channels: usize) -> String {
        match self {
            Self::All if channels == 1 => what.to_owned(),
            Self::All => format!("{what}, all channels together"),
            Self::One(channel) => format!("{what}, {} channel", ["red", "green", "blue"][channel]),
        }
    }
}

/// The world's axes, in names.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];
