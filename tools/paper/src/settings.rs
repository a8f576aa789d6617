//! What a caller chooses, and how drawing can fail.

use std::fmt;

use capwalk_diff::{Refusal, RenderOptions, Statistics, Unwatched, Watch};
use capwalk_geometry::Mesh;
use clap::ValueEnum;

/// How much work a figure is worth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Quality {
    /// Seconds: everything runs, little is decided
    Smoke,
    /// Minutes: most claims are decided
    #[default]
    Draft,
    /// Hours: images 256 pixels wide or more, and about the paper's samples
    Full,
}

impl Quality {
    /// The number for this quality.
    pub fn choose<T>(self, smoke: T, draft: T, full: T) -> T {
        match self {
            Self::Smoke => smoke,
            Self::Draft => draft,
            Self::Full => full,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.choose("smoke", "draft", "full")
    }
}

/// Begins a stage of the work by name, and returns who watches it.
pub type Stages<'a> = dyn Fn(&'static str) -> Box<dyn Watch> + Sync + 'a;

/// What a figure is drawn with.
pub struct Settings<'a> {
    /// How much work.
    pub quality: Quality,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Takes the place of the Voronoi bunny, if given.
    pub mesh: Option<Mesh>,
    /// Who watches.
    pub stages: &'a Stages<'a>,
}

impl Settings<'_> {
    /// Nobody watches.
    pub fn new(quality: Quality) -> Self {
        Self {
            quality,
            seed: 1,
            mesh: None,
            stages: &|_| Box::new(Unwatched),
        }
    }

    /// Sampling with the `set`-th independent set of random numbers.
    pub(crate) fn options(&self, spp: u32, set: u64) -> RenderOptions {
        RenderOptions::new(spp, self.seed.wrapping_mul(1009).wrapping_add(set))
    }
}

/// Work that was stopped is no measurement.
pub(crate) fn complete(statistics: &Statistics) -> Result<(), Failure> {
    if !statistics.complete {
        return Err(Failure::Stopped);
    }
    match statistics.too_many_non_finite() {
        true => Err(Failure::NonFinite {
            count: statistics.non_finite,
        }),
        false => Ok(()),
    }
}

/// Why a figure was not drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// It was stopped before it was done.
    Stopped,
    /// The renderer refused a derivative.
    Refused(Refusal),
    /// More samples than a few were infinite or NaN.
    NonFinite {
        /// How many.
        count: u64,
    },
    /// Something that a figure needs is missing or wrong.
    Unusable(String),
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Stopped => Self::Stopped,
            refusal => Self::Refused(refusal),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stopped => write!(f, "stopped before it was done"),
            Self::Refused(refusal) => refusal.fmt(f),
            Self::NonFinite { count } => {
                write!(
                    f,
                    "{count} samples were infinite or NaN: the images cannot be trusted"
                )
            }
            Self::Unusable(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for Failure {}
