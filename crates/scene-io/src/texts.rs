//! The texts that a scene is read from, and places in them.

use std::path::{Path, PathBuf};

use crate::location::{Location, Position};

/// Index into [`Texts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FileId(usize);

/// A range of bytes in one of the texts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Span {
    pub file: FileId,
    pub start: usize,
    pub end: usize,
}

/// One text.
#[derive(Debug)]
pub(crate) struct Text {
    /// How messages call it.
    pub name: String,
    /// Its file; `None` if it is in memory only.
    pub path: Option<PathBuf>,
    /// Names of files in it are relative to this.
    pub directory: PathBuf,
    pub content: String,
    /// What messages call each line, where they mean something else than the text.
    pub lines: Vec<String>,
    /// The `<include>` that asked for it.
    pub included_at: Option<Span>,
}

impl Text {
    /// The text of a file.
    pub fn of_file(path: &Path, content: String) -> Self {
        Self {
            name: path.display().to_string(),
            path: Some(path.to_owned()),
            directory: path.parent().unwrap_or(Path::new("")).to_owned(),
            content,
            lines: Vec::new(),
            included_at: None,
        }
    }

    /// A text in memory.
    pub fn in_memory(name: &str, directory: PathBuf, content: String) -> Self {
        Self {
            name: name.into(),
            path: None,
            directory,
            content,
            lines: Vec::new(),
            included_at: None,
        }
    }
}

/// All texts of a scene; the first is the main one.
#[derive(Debug, Default)]
pub(crate) struct Texts {
    texts: Vec<Text>,
}

impl Texts {
    pub fn add(&mut self, text: Text) -> FileId {
        self.texts.push(text);
        FileId(self.texts.len() - 1)
    }

    pub fn get(&self, file: FileId) -> &Text {
        &self.texts[file.0]
    }

    pub fn main(&self) -> &Text {
        &self.texts[0]
    }

    pub fn count(&self) -> usize {
        self.texts.len()
    }

    /// The files among the texts.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.texts.iter().filter_map(|text| text.path.as_deref())
    }

    /// The bytes of all texts.
    pub fn bytes(&self) -> usize {
        self.texts.iter().map(|text| text.content.len()).sum()
    }

    /// The bytes of a span.
    pub fn slice(&self, span: Span) -> &str {
        &self.get(span.file).content[span.start..span.end]
    }

    /// A text as a whole.
    pub fn file(&self, file: FileId) -> Location {
        let text = self.get(file);
        Location {
            name: text.name.clone(),
            path: text.path.clone(),
            position: None,
        }
    }

    /// Where a span begins.
    pub fn location(&self, span: Span) -> Location {
        let Text { content, lines, .. } = self.get(span.file);
        let before = &content[..content.floor_char_boundary(span.start)];
        let line = before.matches('\n').count();
        if let Some(name) = lines.get(line) {
            return Location {
                name: name.clone(),
                ..self.file(span.file)
            };
        }
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let position = Position {
            line: line as u32 + 1,
            column: before[line_start..].chars().count() as u32 + 1,
            span: span.start..span.end,
        };
        Location {
            position: Some(position),
            ..self.file(span.file)
        }
    }
}
