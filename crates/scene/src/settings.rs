//! How to render: plain data, read by the integrators.

use serde::{Deserialize, Serialize};

/// Settings of a scene file that a command line may override.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Settings {
    /// How light is transported.
    pub integrator: Integrator,
    /// Samples per pixel.
    pub spp: u32,
    /// Where random numbers come from.
    pub sampler: SamplerKind,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// Light transport algorithms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Integrator {
    /// Emitters seen directly and light that was reflected once.
    Direct {
        /// Emitter samples per shading point.
        emitter_samples: u32,
        /// Material samples per shading point.
        bsdf_samples: u32,
        /// True if emitters are invisible to the camera.
        hide_emitters: bool,
    },
    /// Paths of any length, one emitter and one material sample per vertex.
    Path {
        /// The most segments of a path; `None` is no limit. 1 shows only the
        /// emitters themselves, 2 adds direct light.
        max_depth: Option<u32>,
        /// Paths longer than this may end at random (Russian roulette).
        rr_depth: u32,
        /// True if emitters are invisible to the camera.
        hide_emitters: bool,
    },
    /// What the camera sees first, without light.
    Aov(Aov),
}

/// What can be said of the surface that the camera sees; zero where it sees
/// none. Names as in Mitsuba's `aov` integrator, and `mask`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Aov {
    /// Distance from the camera along the ray, world units.
    Depth,
    /// World position.
    Position,
    /// Texture coordinates, and 0.
    Uv,
    /// Unit normal of the face, world space, on its outside.
    GeometricNormal,
    /// Unit shading normal, world space, on the outside.
    ShadingNormal,
    /// Fraction of light reflected.
    Albedo,
    /// One where there is a surface.
    Mask,
}

impl Aov {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Depth,
        Self::Position,
        Self::Uv,
        Self::GeometricNormal,
        Self::ShadingNormal,
        Self::Albedo,
        Self::Mask,
    ];

    /// Its name in files and on command lines.
    pub fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Position => "position",
            Self::Uv => "uv",
            Self::GeometricNormal => "geo_normal",
            Self::ShadingNormal => "sh_normal",
            Self::Albedo => "albedo",
            Self::Mask => "mask",
        }
    }
}

/// Sources of random numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SamplerKind {
    /// Independent uniform numbers.
    Independent,
    /// Owen-scrambled Sobol points, in independently scrambled batches so that
    /// an error can be estimated.
    Sobol,
}
