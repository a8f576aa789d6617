//! How to render: plain data, read by the integrators.

/// Settings of a scene file that a command line may override.
#[derive(Clone, Debug, PartialEq)]
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
#[derive(Clone, Copy, Debug, PartialEq)]
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
}

/// Sources of random numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SamplerKind {
    /// Independent uniform numbers.
    Independent,
    /// Owen-scrambled Sobol points, in independently scrambled batches so that
    /// an error can be estimated.
    Sobol,
}
