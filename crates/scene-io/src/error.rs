//! What is wrong in a scene file, where, and what was expected there.

use std::fmt;
use std::ops::Range;

/// Why a scene file cannot be loaded.
///
/// Its `Display` is one message of one or more lines that starts with
/// `file:line:column:`; the parts are there for a front end that draws its own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadError(Box<Parts>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Parts {
    file: String,
    position: Option<Position>,
    message: String,
    help: Option<String>,
    near: Vec<String>,
    notes: Vec<String>,
}

/// A place in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Position {
    /// Line, counted from 1.
    pub line: u32,
    /// Character in the line, counted from 1.
    pub column: u32,
    /// The bytes of the text that the message is about.
    pub span: Range<usize>,
}

impl LoadError {
    /// An error about a file as a whole.
    pub(crate) fn whole_file(file: impl Into<String>, message: impl Into<String>) -> Self {
        Self(Box::new(Parts {
            file: file.into(),
            position: None,
            message: message.into(),
            help: None,
            near: Vec::new(),
            notes: Vec::new(),
        }))
    }

    pub(crate) fn at(mut self, position: Position) -> Self {
        self.0.position = Some(position);
        self
    }

    pub(crate) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.0.help = Some(help.into());
        self
    }

    pub(crate) fn with_near(mut self, near: Vec<String>) -> Self {
        self.0.near = near;
        self
    }

    pub(crate) fn with_note(mut self, note: String) -> Self {
        self.0.notes.push(note);
        self
    }

    /// The scene file, as it was named.
    pub fn file(&self) -> &str {
        &self.0.file
    }

    /// Where in the file, unless it is the file as a whole.
    pub fn position(&self) -> Option<&Position> {
        self.0.position.as_ref()
    }

    /// What is wrong, in one sentence.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// What was expected, and what to do.
    pub fn help(&self) -> Option<&str> {
        self.0.help.as_deref()
    }

    /// Names that exist and resemble the one that does not.
    pub fn near(&self) -> &[String] {
        &self.0.near
    }

    /// Further lines, such as the chain of includes.
    pub fn notes(&self) -> &[String] {
        &self.0.notes
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = &*self.0;
        write!(f, "{}:", parts.file)?;
        if let Some(position) = &parts.position {
            write!(f, "{}:{}:", position.line, position.column)?;
        }
        write!(f, " {}", parts.message)?;
        if let Some(help) = &parts.help {
            write!(f, "\n  {help}")?;
        }
        if !parts.near.is_empty() {
            let names: Vec<String> = parts.near.iter().map(|n| format!("\"{n}\"")).collect();
            write!(f, "\n  did you mean {}?", names.join(" or "))?;
        }
        for note in &parts.notes {
            write!(f, "\n  {note}")?;
        }
        Ok(())
    }
}

impl std::error::Error for LoadError {}
