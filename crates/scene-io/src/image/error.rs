//! Why an image file or a file of arrays cannot be written or read.

use std::fmt;
use std::path::{Path, PathBuf};

/// Why a file of images or arrays could not be written or read.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ImageError {
    /// The file's name does not say which format it has.
    UnknownEnding {
        /// The name that was given.
        path: PathBuf,
        /// The endings that would be accepted.
        known: &'static str,
    },
    /// The file could not be written.
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The file could not be read or understood.
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
}

impl ImageError {
    pub(crate) fn write(path: &Path, reason: impl ToString) -> Self {
        Self::Write {
            path: path.to_owned(),
            reason: reason.to_string(),
        }
    }

    pub(crate) fn read(path: &Path, reason: impl ToString) -> Self {
        Self::Read {
            path: path.to_owned(),
            reason: reason.to_string(),
        }
    }
}

impl fmt::Display for ImageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownEnding { path, known } => write!(
                f,
                "the name {} does not tell the format; known endings: {known}",
                path.display()
            ),
            Self::Write { path, reason } => write!(f, "cannot write {}: {reason}", path.display()),
            Self::Read { path, reason } => write!(f, "cannot read {}: {reason}", path.display()),
        }
    }
}

impl std::error::Error for ImageError {}
