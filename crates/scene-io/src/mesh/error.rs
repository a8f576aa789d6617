//! Why a mesh file cannot be read, and where in it.

use std::fmt;

/// Why a mesh file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshFileError {
    /// The file is cut off or damaged, or has another format.
    Damaged(Box<MeshFault>),
    /// The file uses a part of its format that is not read.
    Unsupported(Box<MeshFault>),
    /// A number or an index is outside of its range.
    Invalid(Box<MeshFault>),
    /// The file does not hold the mesh that was asked for, or it holds several.
    Choice(Box<MeshFault>),
}

/// What is wrong in a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshFault {
    /// Where in the file.
    pub place: MeshPlace,
    /// What is wrong there.
    pub message: String,
    /// What was expected, or what to do.
    pub help: String,
}

/// A place in a mesh file. Its `Display` is empty for the file as a whole.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshPlace {
    /// The file as a whole.
    File,
    /// A line of a text, counted from 1.
    Line(usize),
    /// A byte, counted from 0.
    Byte(usize),
    /// The table behind the last mesh of a `.serialized` file.
    End,
    /// A mesh of a `.serialized` file, counted from 0.
    Mesh(u32),
    /// A face of a PLY file, counted from 0.
    Face(u64),
    /// A value in the JSON of a glTF file: `meshes[0].primitives[2].mode`.
    Json(String),
}

impl MeshFileError {
    pub(super) fn damaged(
        place: MeshPlace,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Self::Damaged(MeshFault::boxed(place, message, help))
    }

    pub(super) fn unsupported(
        place: MeshPlace,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Self::Unsupported(MeshFault::boxed(place, message, help))
    }

    pub(super) fn invalid(
        place: MeshPlace,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Self::Invalid(MeshFault::boxed(place, message, help))
    }

    pub(super) fn choice(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Choice(MeshFault::boxed(MeshPlace::File, message, help))
    }

    /// What is wrong and where, whatever kind of error it is.
    pub fn fault(&self) -> &MeshFault {
        match self {
            Self::Damaged(fault)
            | Self::Unsupported(fault)
            | Self::Invalid(fault)
            | Self::Choice(fault) => fault,
        }
    }
}

impl MeshFault {
    fn boxed(place: MeshPlace, message: impl Into<String>, help: impl Into<String>) -> Box<Self> {
        Box::new(Self {
            place,
            message: message.into(),
            help: help.into(),
        })
    }
}

impl fmt::Display for MeshPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::End => write!(f, "end of the file"),
            Self::Mesh(mesh) => write!(f, "mesh {mesh}"),
            Self::Face(face) => write!(f, "face {face}"),
            Self::Json(path) => write!(f, "{path}"),
        }
    }
}

impl fmt::Display for MeshFileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let MeshFault {
            place,
            message,
            help,
        } = self.fault();
        match place {
            MeshPlace::File => write!(f, "{message}; {help}"),
            _ => write!(f, "{place}: {message}; {help}"),
        }
    }
}

impl std::error::Error for MeshFileError {}
