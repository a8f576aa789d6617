//! Strict reading of TOML: every key is asked for, keys that were not asked for are
//! errors, and every error has a place, says what was expected, and which key was
//! perhaps meant.

use std::cell::RefCell;
use std::ops::{Range, RangeInclusive};
use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::LoadError;
use crate::files::read_text_file;
use crate::problem::Problem;
use crate::suggest::nearest;
use crate::texts::{FileId, Span, Text, Texts};

/// A file that was read.
#[derive(Debug)]
pub struct Document {
    texts: Texts,
    file: FileId,
    root: Vec<Entry>,
}

/// Some bytes of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place(Span);

/// A key and its value.
#[derive(Debug)]
struct Entry {
    key: String,
    place: Place,
    value: Node,
}

/// A value and where it stands.
#[derive(Debug)]
struct Node {
    place: Place,
    content: Content,
}

#[derive(Debug)]
enum Content {
    Text(String),
    Integer(i64),
    Number(f64),
    Truth(bool),
    List(Vec<Node>),
    Table(Vec<Entry>),
    /// Something else, in words.
    Other(String),
}

/// A table of a document, and which of its keys were asked for.
#[derive(Debug)]
pub struct Table<'d> {
    document: &'d Document,
    entries: &'d [Entry],
    place: Place,
    /// How messages call it: `[optimizer]`.
    name: String,
    asked: RefCell<Vec<&'static str>>,
}

/// A value of a document.
#[derive(Clone, Copy, Debug)]
pub struct Value<'d> {
    document: &'d Document,
    /// How messages call it.
    name: &'d str,
    node: &'d Node,
}

impl Document {
    /// Reads a file.
    pub fn read(path: &Path) -> Result<Self, LoadError> {
        let content = read_text_file(path).map_err(|error| {
            let message = format!("cannot read the file: {error}");
            LoadError::unreadable(path, message, "expected a text in TOML")
        })?;
        Self::of(Text::of_file(path, content))
    }

    /// A text in memory that messages call `name`; files in it are relative to
    /// `directory`.
    pub fn parse(name: &str, directory: PathBuf, content: String) -> Result<Self, LoadError> {
        Self::of(Text::in_memory(name, directory, content))
    }

    fn of(text: Text) -> Result<Self, LoadError> {
        let mut texts = Texts::default();
        let file = texts.add(text);
        let at = |span: Range<usize>| {
            Place(Span {
                file,
                start: span.start,
                end: span.end,
            })
        };
        let parsed = match DeTable::parse(&texts.get(file).content) {
            Ok(table) => entries(table.into_inner(), &at),
            Err(error) => {
                let place = at(error.span().unwrap_or(0..0));
                Err((place, error.message().to_owned()))
            }
        };
        match parsed {
            Ok(root) => Ok(Self { texts, file, root }),
            Err((place, message)) => {
                let problem = Problem::syntax(place.0, message).help("expected a text in TOML 1.1");
                Err(problem.locate(&texts))
            }
        }
    }

    /// The whole file as a table.
    pub fn root(&self) -> Table<'_> {
        let start = Span {
            file: self.file,
            start: 0,
            end: 0,
        };
        Table {
            document: self,
            entries: &self.root,
            place: Place(start),
            name: "the file".into(),
            asked: RefCell::default(),
        }
    }

    /// A path in the file, relative to where the file is.
    pub fn path(&self, text: &str) -> PathBuf {
        self.texts.main().directory.join(text)
    }

    /// An error at a place.
    pub fn error(&self, place: Place, message: impl Into<String>) -> LoadError {
        Problem::invalid(place.0, message).locate(&self.texts)
    }

    /// An error at a place, with what was expected or what to do.
    pub fn error_with_help(
        &self,
        place: Place,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> LoadError {
        let problem = Problem::invalid(place.0, message).help(help);
        problem.locate(&self.texts)
    }
}

type Located<T> = Result<T, (Place, String)>;

/// The entries of a table, in the order of the file.
fn entries(table: DeTable<'_>, at: &dyn Fn(Range<usize>) -> Place) -> Located<Vec<Entry>> {
    let mut entries = Vec::new();
    for (key, value) in table {
        entries.push(Entry {
            place: at(key.span()),
            key: key.into_inner().into_owned(),
            value: node(value, at)?,
        });
    }
    entries.sort_by_key(|entry| entry.place.0.start);
    Ok(entries)
}

fn node(value: Spanned<DeValue<'_>>, at: &dyn Fn(Range<usize>) -> Place) -> Located<Node> {
    let place = at(value.span());
    let content = match value.into_inner() {
        DeValue::String(text) => Content::Text(text.into_owned()),
        DeValue::Integer(number) => {
            let digits = number.as_str().replace('_', "");
            let parsed = i64::from_str_radix(&digits, number.radix());
            let too_large = |_| (place, format!("{digits} is no number of 64 bits"));
            Content::Integer(parsed.map_err(too_large)?)
        }
        DeValue::Float(number) => {
            let digits = number.as_str().replace('_', "");
            let parsed = digits.parse();
            Content::Number(parsed.map_err(|_| (place, format!("{digits} is no number")))?)
        }
        DeValue::Boolean(truth) => Content::Truth(truth),
        DeValue::Datetime(time) => Content::Other(format!("the time {time}")),
        DeValue::Array(items) => {
            let items = items.into_iter().map(|item| node(item, at));
            Content::List(items.collect::<Located<_>>()?)
        }
        DeValue::Table(table) => Content::Table(entries(table, at)?),
    };
    Ok(Node { place, content })
}

impl<'d> Table<'d> {
    /// Where it stands.
    pub fn place(&self) -> Place {
        self.place
    }

    /// The value of a key, if it is there.
    pub fn get(&self, key: &'static str) -> Option<Value<'d>> {
        self.asked.borrow_mut().push(key);
        let entry = self.entries.iter().find(|entry| entry.key == key)?;
        Some(self.value(entry))
    }

    /// The value of a key, or an error that it is missing.
    pub fn require(&self, key: &'static str, what: &str) -> Result<Value<'d>, LoadError> {
        self.get(key).ok_or_else(|| {
            let message = format!("`{key}` is missing in {}", self.name);
            Problem::missing(self.place.0, message)
                .help(format!("expected {what}"))
                .locate(&self.document.texts)
        })
    }

    /// The table behind a key, if it is there.
    pub fn table(&self, key: &'static str) -> Result<Option<Table<'d>>, LoadError> {
        self.get(key)
            .map(|value| value.table(&format!("[{key}]")))
            .transpose()
    }

    /// The tables behind a key: `[[key]]` several times; none if it is not there.
    pub fn tables(&self, key: &'static str) -> Result<Vec<Table<'d>>, LoadError> {
        let Some(value) = self.get(key) else {
            return Ok(Vec::new());
        };
        let Content::List(items) = &value.node.content else {
            return Err(value.wrong(&format!("one or more tables `[[{key}]]`")));
        };
        let item = |node: &'d Node| Value { node, ..value }.table(&format!("[[{key}]]"));
        items.iter().map(item).collect()
    }

    /// All keys, which may be anything, with their values.
    pub fn entries(&self) -> impl Iterator<Item = (&'d str, Place, Value<'d>)> {
        self.entries
            .iter()
            .map(|entry| (entry.key.as_str(), entry.place, self.value(entry)))
    }

    fn value(&self, entry: &'d Entry) -> Value<'d> {
        Value {
            document: self.document,
            name: &entry.key,
            node: &entry.value,
        }
    }

    /// An error if there is a key that was not asked for.
    pub fn finish(&self) -> Result<(), LoadError> {
        let asked = self.asked.borrow();
        let unknown = |entry: &&Entry| !asked.iter().any(|&key| key == entry.key);
        let Some(entry) = self.entries.iter().find(unknown) else {
            return Ok(());
        };
        let mut known = asked.to_vec();
        known.sort_unstable();
        known.dedup();
        let problem = Problem::unknown(
            entry.place.0,
            format!("unknown key `{}` in {}", entry.key, self.name),
        );
        let problem = problem
            .near(nearest(&entry.key, known.iter().copied()))
            .help(format!("expected one of: {}", known.join(", ")));
        Err(problem.locate(&self.document.texts))
    }
}

impl<'d> Value<'d> {
    /// Where it stands.
    pub fn place(&self) -> Place {
        self.node.place
    }

    /// An error about it.
    pub fn error(&self, message: impl Into<String>) -> LoadError {
        self.document.error(self.node.place, message)
    }

    /// An error that it should be something else.
    pub fn wrong(&self, expected: &str) -> LoadError {
        let found = match &self.node.content {
            Content::Text(text) => format!("\"{text}\""),
            Content::Integer(number) => number.to_string(),
            Content::Number(number) => number.to_string(),
            Content::Truth(truth) => truth.to_string(),
            Content::List(_) => "a list".into(),
            Content::Table(_) => "a table".into(),
            Content::Other(words) => words.clone(),
        };
        self.document.error_with_help(
            self.node.place,
            format!("`{}` is {found}", self.name),
            format!("expected {expected}"),
        )
    }

    /// A text.
    pub fn text(&self) -> Result<&'d str, LoadError> {
        match &self.node.content {
            Content::Text(text) => Ok(text),
            _ => Err(self.wrong("a text in quotes")),
        }
    }

    /// One of these words.
    pub fn choice<T: Copy>(&self, choices: &[(&str, T)]) -> Result<T, LoadError> {
        let names: Vec<String> = choices.iter().map(|(n, _)| format!("\"{n}\"")).collect();
        let expected = format!("one of {}", names.join(", "));
        let Content::Text(text) = &self.node.content else {
            return Err(self.wrong(&expected));
        };
        match choices.iter().find(|(name, _)| name == text) {
            Some(&(_, choice)) => Ok(choice),
            None => {
                let near = nearest(text, choices.iter().map(|(name, _)| *name));
                let message = format!("`{}` is \"{text}\"", self.name);
                let problem = Problem::unknown(self.node.place.0, message);
                let problem = problem.near(near).help(format!("expected {expected}"));
                Err(problem.locate(&self.document.texts))
            }
        }
    }

    /// True or false.
    pub fn truth(&self) -> Result<bool, LoadError> {
        match self.node.content {
            Content::Truth(truth) => Ok(truth),
            _ => Err(self.wrong("true or false")),
        }
    }

    /// A whole number.
    pub fn integer(&self, allowed: RangeInclusive<i64>) -> Result<i64, LoadError> {
        match self.node.content {
            Content::Integer(number) if allowed.contains(&number) => Ok(number),
            _ => Err(self.wrong(&match *allowed.end() {
                i64::MAX => format!("a whole number of at least {}", allowed.start()),
                end => format!("a whole number from {} to {end}", allowed.start()),
            })),
        }
    }

    /// A finite number that is allowed, in words `expected`.
    pub fn number(&self, expected: &str, allowed: impl Fn(f64) -> bool) -> Result<f64, LoadError> {
        match self.as_number() {
            Some(number) if number.is_finite() && allowed(number) => Ok(number),
            _ => Err(self.wrong(expected)),
        }
    }

    fn as_number(&self) -> Option<f64> {
        match self.node.content {
            Content::Integer(number) => Some(number as f64),
            Content::Number(number) => Some(number),
            _ => None,
        }
    }

    /// A number, or a list of numbers or of such lists, row by row.
    pub fn numbers(&self) -> Result<Vec<f64>, LoadError> {
        match (&self.node.content, self.as_number()) {
            (_, Some(number)) if number.is_finite() => Ok(vec![number]),
            (Content::List(items), _) => {
                let rows = items.iter().map(|node| Self { node, ..*self }.numbers());
                Ok(rows.collect::<Result<Vec<_>, _>>()?.concat())
            }
            _ => Err(self.wrong("finite numbers")),
        }
    }

    /// So many numbers.
    pub fn array<const N: usize>(&self, expected: &str) -> Result<[f64; N], LoadError> {
        let numbers = self.numbers()?;
        numbers.try_into().map_err(|_| self.wrong(expected))
    }

    /// The items of a list; the value itself if it is none.
    pub fn items(&self) -> Vec<Self> {
        match &self.node.content {
            Content::List(items) => items.iter().map(|node| Self { node, ..*self }).collect(),
            _ => vec![*self],
        }
    }

    /// The value as a text that gives it again, for `$name` in scene files.
    pub fn written(&self) -> Result<String, LoadError> {
        match &self.node.content {
            Content::Text(text) => Ok(text.clone()),
            Content::Integer(number) => Ok(number.to_string()),
            Content::Number(number) => Ok(number.to_string()),
            Content::Truth(truth) => Ok(truth.to_string()),
            _ => Err(self.wrong("a text, a number, true or false")),
        }
    }

    /// A table that messages call `name`.
    pub fn table(&self, name: &str) -> Result<Table<'d>, LoadError> {
        match &self.node.content {
            Content::Table(entries) => Ok(Table {
                document: self.document,
                entries,
                place: self.node.place,
                name: name.into(),
                asked: RefCell::default(),
            }),
            _ => Err(self.wrong(&format!("a table {name}"))),
        }
    }
}

#[cfg(test)]
mod tests;
