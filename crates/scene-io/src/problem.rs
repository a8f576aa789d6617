//! Something that is wrong at a place in a text, before the place has a line
//! and a column.

use capwalk_scene::SceneError;

use crate::error::{Diagnostic, LoadError};
use crate::mesh::{MeshFault, MeshFileError};
use crate::texts::{FileId, Span, Texts};

/// An error without a line and a column yet; [`Problem::locate`] adds them.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    place: Place,
    kind: Kind,
    message: String,
    help: Option<String>,
    near: Vec<String>,
}

#[derive(Clone, Debug)]
enum Place {
    File(FileId),
    Span(Span),
}

/// Which [`LoadError`] it becomes.
#[derive(Clone, Debug)]
enum Kind {
    /// One that has nothing besides its message.
    Plain(fn(Box<Diagnostic>) -> LoadError),
    Mesh(MeshFileError),
    Scene(Box<SceneError>),
}

impl Problem {
    fn new(place: Place, kind: Kind, message: String) -> Self {
        Self {
            place,
            kind,
            message,
            help: None,
            near: Vec::new(),
        }
    }

    fn plain(
        kind: fn(Box<Diagnostic>) -> LoadError,
        span: Span,
        message: impl Into<String>,
    ) -> Self {
        Self::new(Place::Span(span), Kind::Plain(kind), message.into())
    }

    pub fn unreadable(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Unreadable, span, message)
    }

    pub fn syntax(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Syntax, span, message)
    }

    pub fn definition(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Definition, span, message)
    }

    /// About a definition from outside of the file.
    pub fn definition_for(file: FileId, message: impl Into<String>) -> Self {
        let kind = Kind::Plain(LoadError::Definition);
        Self::new(Place::File(file), kind, message.into())
    }

    pub fn unknown(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Unknown, span, message)
    }

    pub fn missing(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Missing, span, message)
    }

    pub fn unsupported(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Unsupported, span, message)
    }

    pub fn invalid(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Invalid, span, message)
    }

    pub fn image(span: Span, message: impl Into<String>) -> Self {
        Self::plain(LoadError::Image, span, message)
    }

    /// An error in a mesh file that messages call `name`.
    pub fn mesh(span: Span, name: &str, error: MeshFileError) -> Self {
        let fault = error.fault();
        let place = match fault.place.to_string() {
            whole if whole.is_empty() => whole,
            place => format!(", {place}"),
        };
        let message = format!("\"{name}\"{place}: {}", fault.message);
        let help = fault.help.clone();
        Self::new(Place::Span(span), Kind::Mesh(error), message).help(help)
    }

    /// An error in a glTF file that is the scene.
    pub fn gltf(file: FileId, error: MeshFileError) -> Self {
        let MeshFault {
            place,
            message,
            help,
        } = error.fault().clone();
        let message = match place.to_string() {
            whole if whole.is_empty() => message,
            place => format!("{place}: {message}"),
        };
        Self::new(Place::File(file), Kind::Mesh(error), message).help(help)
    }

    pub fn scene(span: Span, error: SceneError) -> Self {
        let message = error.to_string();
        Self::new(Place::Span(span), Kind::Scene(Box::new(error)), message)
    }

    /// What was expected, or what to do.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Names that exist and resemble the one that does not.
    pub fn near(mut self, near: Vec<String>) -> Self {
        self.near = near;
        self
    }

    /// The error that a user sees, with the chain of includes that led there.
    pub fn locate(self, texts: &Texts) -> LoadError {
        let (file, location) = match self.place {
            Place::File(file) => (file, texts.file(file)),
            Place::Span(span) => (span.file, texts.location(span)),
        };
        let mut notes = Vec::new();
        let mut include = texts.get(file).included_at;
        while let Some(span) = include {
            notes.push(format!("included at {}", texts.location(span)));
            include = texts.get(span.file).included_at;
        }
        let diagnostic = Box::new(Diagnostic {
            location,
            message: shortened(self.message),
            help: self.help.map(shortened),
            near: self.near,
            notes,
        });
        match self.kind {
            Kind::Plain(kind) => kind(diagnostic),
            Kind::Mesh(error) => LoadError::Mesh { diagnostic, error },
            Kind::Scene(error) => LoadError::Scene {
                diagnostic,
                error: *error,
            },
        }
    }
}

/// Longer messages are cut, characters: they quote values that may have any length.
const LONGEST_MESSAGE: usize = 1000;

/// The beginning and the end of a text that is too long.
fn shortened(text: String) -> String {
    if text.len() <= LONGEST_MESSAGE {
        return text;
    }
    let start = &text[..text.floor_char_boundary(LONGEST_MESSAGE / 2)];
    let end = &text[text.ceil_char_boundary(text.len() - LONGEST_MESSAGE / 4)..];
    let left_out = text.len() - start.len() - end.len();
    format!("{start} ... [{left_out} bytes more] ... {end}")
}
