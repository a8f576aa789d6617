//! How to render: plain data, read by the integrators.

use serde::{Deserialize, Serialize};

use crate::scene_error::SceneError;

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

/// The most samples of emitters, or of the material, that are taken at a shading point: between
/// two samples of a pixel it is seen that somebody wants to stop, and a derivative keeps all of one
/// in memory. More samples per pixel do the same as more of these.
pub const MOST_SAMPLES: u32 = 1 << 12;

/// The most segments of a path before roulette may end it, for the same reasons. From then on one
/// path in twenty ends at each vertex.
pub const MOST_SEGMENTS: u32 = 1 << 17;

impl Settings {
    /// Checks that a sample of a pixel comes to an end.
    pub(crate) fn check(&self) -> Result<(), SceneError> {
        let bad = |name: &str, value: u32, expected| {
            Err(SceneError::BadNumber {
                name: format!("integrator.{name}"),
                value: value.to_string(),
                expected,
            })
        };
        match self.integrator {
            Integrator::Direct {
                emitter_samples,
                bsdf_samples,
                ..
            } => {
                let both = [
                    ("emitter_samples", emitter_samples),
                    ("bsdf_samples", bsdf_samples),
                ];
                match both.into_iter().find(|(_, count)| *count > MOST_SAMPLES) {
                    Some((name, count)) => bad(
                        name,
                        count,
                        "at most 4096; more samples per pixel do the same",
                    ),
                    None => Ok(()),
                }
            }
            Integrator::Path {
                max_depth,
                rr_depth,
                ..
            } if max_depth.unwrap_or(u32::MAX).min(rr_depth) > MOST_SEGMENTS => bad(
                "rr_depth",
                rr_depth,
                "at most 131072, or a max_depth of at most that",
            ),
            Integrator::Path { .. } | Integrator::Aov(_) => Ok(()),
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers for which one sample would not end.
    #[test]
    fn samples_come_to_an_end() {
        let check = |integrator| {
            let settings = Settings {
                integrator,
                spp: 1,
                sampler: SamplerKind::Independent,
                seed: 0,
            };
            settings.check().map_err(|error| error.to_string())
        };
        let direct = |emitter_samples, bsdf_samples| Integrator::Direct {
            emitter_samples,
            bsdf_samples,
            hide_emitters: false,
        };
        let path = |max_depth, rr_depth| Integrator::Path {
            max_depth,
            rr_depth,
            hide_emitters: false,
        };
        assert_eq!(check(direct(MOST_SAMPLES, MOST_SAMPLES)), Ok(()));
        let most = MOST_SAMPLES.to_string();
        for (integrator, name) in [
            (direct(2_000_000_000, 1), "integrator.emitter_samples"),
            (direct(1, MOST_SAMPLES + 1), "integrator.bsdf_samples"),
        ] {
            let error = check(integrator).expect_err(name);
            assert!(error.contains(name) && error.contains(&most), "{error}");
        }
        // Either of them ends a path.
        assert_eq!(check(path(None, 5)), Ok(()));
        assert_eq!(check(path(Some(u32::MAX), MOST_SEGMENTS)), Ok(()));
        assert_eq!(check(path(Some(9), u32::MAX)), Ok(()));
        for depth in [None, Some(2_000_000_000)] {
            let error = check(path(depth, 1_000_000)).expect_err("endless");
            let most = MOST_SEGMENTS.to_string();
            assert!(error.contains("integrator.rr_depth is 1000000"), "{error}");
            assert!(error.contains(&most), "{error}");
        }
    }
}
