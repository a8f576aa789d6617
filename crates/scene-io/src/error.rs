//! Why a scene file or a job file cannot be read.

use std::fmt;
use std::path::Path;

use capwalk_scene::SceneError;

use crate::location::{Location, Position};
use crate::mesh::MeshFileError;

/// Why a file cannot be read.
///
/// The variant says what kind of mistake it is; what to tell the user stands in
/// a [`Diagnostic`], which all of them have. `Display` is one message of one or
/// more lines that starts with `file:line:column:`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LoadError {
    /// A file is missing, cannot be opened, is too large, or is not text.
    Unreadable(Box<Diagnostic>),
    /// The text is not XML or TOML.
    Syntax(Box<Diagnostic>),
    /// A parameter `$name` is not defined, or a definition is not used.
    Definition(Box<Diagnostic>),
    /// A tag, a plugin, a property, an id or a word that does not exist.
    Unknown(Box<Diagnostic>),
    /// Something that is needed is not there.
    Missing(Box<Diagnostic>),
    /// Something that Mitsuba reads and this library does not.
    Unsupported(Box<Diagnostic>),
    /// A value of the wrong type or out of range, or one that contradicts another.
    Invalid(Box<Diagnostic>),
    /// The contents of a mesh file.
    Mesh {
        /// The message, with the place in the scene file that names the mesh.
        diagnostic: Box<Diagnostic>,
        /// The error, with its place in the mesh file.
        error: MeshFileError,
    },
    /// The contents of an image file.
    Image(Box<Diagnostic>),
    /// The file could be read, but the scene in it cannot be rendered.
    Scene {
        /// The message, with the place of the part that is wrong.
        diagnostic: Box<Diagnostic>,
        /// The error of the scene.
        error: SceneError,
    },
}

/// What a message says, part by part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The file and the place in it.
    pub location: Location,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What was expected, or what to do.
    pub help: Option<String>,
    /// Names that exist and resemble the one that does not.
    pub near: Vec<String>,
    /// Further lines, such as the chain of includes.
    pub notes: Vec<String>,
}

impl LoadError {
    /// A file that cannot be read at all.
    pub(crate) fn unreadable(path: &Path, message: String, help: &str) -> Self {
        Self::Unreadable(Box::new(Diagnostic {
            location: Location {
                name: path.display().to_string(),
                path: Some(path.to_owned()),
                position: None,
            },
            message,
            help: Some(help.into()),
            near: Vec::new(),
            notes: Vec::new(),
        }))
    }

    /// What the message says, whatever kind of error it is.
    pub fn diagnostic(&self) -> &Diagnostic {
        match self {
            Self::Unreadable(diagnostic)
            | Self::Syntax(diagnostic)
            | Self::Definition(diagnostic)
            | Self::Unknown(diagnostic)
            | Self::Missing(diagnostic)
            | Self::Unsupported(diagnostic)
            | Self::Invalid(diagnostic)
            | Self::Mesh { diagnostic, .. }
            | Self::Image(diagnostic)
            | Self::Scene { diagnostic, .. } => diagnostic,
        }
    }

    /// The scene file or job file; `None` for a text in memory.
    pub fn file(&self) -> Option<&Path> {
        self.diagnostic().location.path.as_deref()
    }

    /// Line in the file, counted from 1; `None` for the file as a whole.
    pub fn line(&self) -> Option<u32> {
        self.position().map(|position| position.line)
    }

    /// Character in the line, counted from 1; `None` for the file as a whole.
    pub fn column(&self) -> Option<u32> {
        self.position().map(|position| position.column)
    }

    /// Line, column and bytes; `None` for the file as a whole.
    pub fn position(&self) -> Option<&Position> {
        self.diagnostic().location.position.as_ref()
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.location, self.message)?;
        if let Some(help) = &self.help {
            write!(f, "\n  {help}")?;
        }
        if !self.near.is_empty() {
            let names: Vec<String> = self.near.iter().map(|n| format!("\"{n}\"")).collect();
            write!(f, "\n  did you mean {}?", names.join(" or "))?;
        }
        for note in &self.notes {
            write!(f, "\n  {note}")?;
        }
        Ok(())
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.diagnostic().fmt(f)
    }
}

impl std::error::Error for LoadError {}
