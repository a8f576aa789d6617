//! Why parts do not make a whole.

use capwalk_boundary::Refusal;
use capwalk_scene::BytesError;

/// Why parts do not make a whole.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PartError {
    /// There is no such part.
    #[error("there is no {what}: the work has {batches} batches and {bands} bands, counted from 0")]
    NotInGrid {
        /// What was asked for.
        what: String,
        /// Batches that there are.
        batches: u32,
        /// Bands that there are.
        bands: u32,
    },
    /// Parts of different scenes, parameters, options or versions.
    #[error(
        "these parts belong to different works: the scene, what it is differentiated with respect \
         to, the options and the version must be the same"
    )]
    DifferentWork,
    /// A cell is in two parts.
    #[error("batch {batch} of band {band} is in two parts: it would count twice")]
    Twice {
        /// Which batch.
        batch: u32,
        /// Which band.
        band: u32,
    },
    /// Some cells were not computed.
    #[error("{cells} of {of} cells are missing: merge all parts first")]
    Missing {
        /// The number of missing cells.
        cells: u64,
        /// The number of all cells.
        of: u64,
    },
    /// Bytes that are no part.
    #[error("these bytes are no part of a work, or were damaged: {reason}")]
    Bytes {
        /// What was found.
        reason: String,
    },
    /// All parts together show that the derivative would be wrong.
    #[error(transparent)]
    Refused(#[from] Refusal),
}

impl From<BytesError> for PartError {
    fn from(BytesError { reason }: BytesError) -> Self {
        Self::Bytes { reason }
    }
}
