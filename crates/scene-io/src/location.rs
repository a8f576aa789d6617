//! Places in files, as messages name them.

use std::fmt;
use std::ops::Range;
use std::path::PathBuf;

/// A file, or a place in it. Its `Display` is `file:line:column`, as editors
/// understand it, or the name alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// The name of the file or the text.
    pub name: String,
    /// The path of the file; `None` for a text in memory.
    pub path: Option<PathBuf>,
    /// Where in the file; `None` for the file as a whole.
    pub position: Option<Position>,
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

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.name)?;
        match &self.position {
            None => Ok(()),
            Some(Position { line, column, .. }) => write!(f, ":{line}:{column}"),
        }
    }
}
