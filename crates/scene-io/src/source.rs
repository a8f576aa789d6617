//! The texts that a scene was read from, and places in them.

use std::path::PathBuf;

use crate::error::{LoadError, Position};

/// Index into [`Sources`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FileId(usize);

/// Some bytes of one of the texts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Span {
    pub file: FileId,
    pub start: usize,
    pub end: usize,
}

/// Something that is wrong at a place; [`Sources::error`] makes it presentable.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    pub span: Span,
    pub message: String,
    pub help: Option<String>,
    pub near: Vec<String>,
}

impl Problem {
    pub fn new(span: Span, message: impl Into<String>) -> Self {
        Self {
            span,
            message: message.into(),
            help: None,
            near: Vec::new(),
        }
    }

    /// What was expected, and what to do.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Names that exist and resemble the one that does not.
    pub fn near(mut self, near: Vec<String>) -> Self {
        self.near = near;
        self
    }
}

/// One text.
#[derive(Debug)]
pub(crate) struct Source {
    /// How messages call it.
    pub name: String,
    /// Where it lies; names of files in it are relative to this.
    pub directory: PathBuf,
    pub text: String,
    /// The `<include>` that asked for it.
    pub included_at: Option<Span>,
}

/// All texts of a scene; the first is the main one.
#[derive(Debug, Default)]
pub(crate) struct Sources {
    files: Vec<Source>,
}

impl Sources {
    pub fn add(&mut self, source: Source) -> FileId {
        self.files.push(source);
        FileId(self.files.len() - 1)
    }

    pub fn get(&self, file: FileId) -> &Source {
        &self.files[file.0]
    }

    pub fn main(&self) -> &Source {
        &self.files[0]
    }

    pub fn count(&self) -> usize {
        self.files.len()
    }

    /// `file:line:column`, as editors understand it.
    pub fn place(&self, span: Span) -> String {
        let position = self.position(span);
        let name = &self.get(span.file).name;
        format!("{name}:{}:{}", position.line, position.column)
    }

    /// What stands there.
    pub fn text(&self, span: Span) -> &str {
        &self.get(span.file).text[span.start..span.end]
    }

    fn position(&self, span: Span) -> Position {
        let text = &self.get(span.file).text;
        let before = &text[..text.floor_char_boundary(span.start)];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Position {
            line: before.matches('\n').count() as u32 + 1,
            column: before[line_start..].chars().count() as u32 + 1,
            span: span.start..span.end,
        }
    }

    /// The error that a user sees, with the chain of includes that led there.
    pub fn error(&self, problem: Problem) -> LoadError {
        let source = self.get(problem.span.file);
        let mut error = LoadError::whole_file(&source.name, problem.message)
            .at(self.position(problem.span))
            .with_near(problem.near);
        if let Some(help) = problem.help {
            error = error.with_help(help);
        }
        let mut include = source.included_at;
        while let Some(span) = include {
            error = error.with_note(format!("included at {}", self.place(span)));
            include = self.get(span.file).included_at;
        }
        error
    }
}
