//! Why a scene cannot be written.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Why a scene cannot be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum ExportError {
    /// A file or a directory cannot be made or written.
    Write {
        /// The file or directory.
        path: PathBuf,
        /// The error of the operating system.
        error: io::Error,
    },
    /// Another file is there, which was not to be replaced.
    InTheWay {
        /// The file.
        path: PathBuf,
    },
    /// A bitmap cannot be encoded.
    Encode {
        /// The file that it was meant for.
        path: PathBuf,
        /// What the encoder refused.
        reason: String,
    },
}

impl ExportError {
    /// The file or directory that could not be written.
    pub fn file(&self) -> &Path {
        match self {
            Self::Write { path, .. } | Self::InTheWay { path } | Self::Encode { path, .. } => path,
        }
    }
}

impl fmt::Display for ExportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write {}: ", self.file().display())?;
        match self {
            Self::Write { error, .. } => write!(f, "{error}"),
            Self::InTheWay { .. } => write!(
                f,
                "it already exists with other contents; delete it, or choose another folder"
            ),
            Self::Encode { reason, .. } => write!(f, "{reason}"),
        }
    }
}

impl std::error::Error for ExportError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Write { error, .. } => Some(error),
            Self::InTheWay { .. } | Self::Encode { .. } => None,
        }
    }
}
