//! How commands end: the exit status, and the one place where errors are shown.

use std::process::ExitCode;

use capwalk::scene::params::ParameterError;
use capwalk::scene_io::read_text_file;
use capwalk::{Diagnostic, Error, FolderError, LoadError, Refusal, UnusableImage};
use clap::error::{ContextKind, ContextValue};

/// How a command that wrote its results ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Done; a checked gradient is right.
    Done,
    /// The gradient is wrong.
    Wrong,
    /// A guard stopped an optimisation.
    Stopped,
    /// The noise hides whether the gradient is right.
    Inconclusive,
    /// Too many samples were infinite or NaN.
    NonFinite,
    /// Stopped by Ctrl-C or SIGTERM.
    Interrupted,
}

/// Exit status of bad input, refused derivatives, and results that cannot be
/// written.
pub const BAD_INPUT: u8 = 3;

/// Exit status of a command that was stopped by Ctrl-C or SIGTERM.
pub const INTERRUPTED: u8 = 5;

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(match outcome {
            Outcome::Done => 0,
            Outcome::Wrong | Outcome::Stopped => 1,
            Outcome::Inconclusive => 2,
            Outcome::NonFinite => 4,
            Outcome::Interrupted => INTERRUPTED,
        })
    }
}

/// The text of an error: what failed, then each cause on a line of its own, or
/// the place in the scene file.
pub fn describe(error: &anyhow::Error) -> String {
    let ours = error.downcast_ref::<Error>();
    let load = match ours {
        Some(Error::Load(load)) => Some(load),
        _ => error.downcast_ref::<LoadError>(),
    };
    if let Some(error) = load {
        let source = error.file().and_then(|file| read_text_file(file).ok());
        return describe_load(error, &source.unwrap_or_default());
    }
    let mut text = format!("error: {error}");
    let mut last = error.to_string();
    for cause in error.chain().skip(1) {
        let cause = cause.to_string();
        // Some errors name their cause in their own text.
        if !last.contains(&cause) {
            text += &format!("\n  because {}", cause.replace('\n', "\n  "));
        }
        last = cause;
    }
    let of_parameter = match ours {
        Some(Error::Parameter(error)) => Some(error),
        _ => error.chain().find_map(|cause| cause.downcast_ref()),
    };
    if let Some(hint) = of_parameter.and_then(parameter_hint) {
        text += &format!("\n  help: {hint}");
    }
    text + ours.and_then(hint).unwrap_or_default()
}

/// The longest word in a message, characters: paths are shorter, and longer ones are cut.
const LONGEST_WORD: usize = 1000;

/// How much of a word is left that is cut, characters.
const KEPT: usize = 200;

/// The longest message, bytes.
const LONGEST_MESSAGE: usize = 16_000;

/// A message with names that can be read, if it has others.
pub fn shortened(text: &str) -> Option<String> {
    let is_long = |word: &str| word.chars().nth(LONGEST_WORD).is_some();
    if text.len() <= LONGEST_MESSAGE && !text.split_whitespace().any(is_long) {
        return None;
    }
    let mut short = String::new();
    for word in text.split_inclusive(char::is_whitespace) {
        match is_long(word) {
            false => short += word,
            true => {
                short.extend(word.chars().take(KEPT));
                short += "…";
                short.extend(word.chars().next_back().filter(|end| end.is_whitespace()));
            }
        }
    }
    if short.len() > LONGEST_MESSAGE {
        short.truncate(short.floor_char_boundary(LONGEST_MESSAGE));
        short += "…\n";
    }
    Some(short)
}

/// Says how a value is given that begins with a minus, where the parser would have it behind
/// `--`, which is for what belongs to no option.
pub fn advise_on_values(error: &mut clap::Error) {
    let Some(ContextValue::String(argument)) = error.get(ContextKind::InvalidArg) else {
        return;
    };
    let is_wrong = matches!(error.get(ContextKind::Suggested), Some(ContextValue::StyledStrs(tips))
        if tips.iter().any(|tip| tip.to_string().contains("use '-- ")));
    if !is_wrong {
        return;
    }
    // The parser names the first letter only.
    let typed = std::env::args().find(|typed| typed.starts_with(argument.as_str()));
    let typed = typed.unwrap_or_else(|| argument.clone());
    let tip = format!("to pass '{typed}' as a value, join it to its option: '--param={typed}'");
    let tips = ContextValue::StyledStrs(vec![tip.into()]);
    error.insert(ContextKind::Suggested, tips);
}

/// What the command line offers against an error of the library.
fn hint(error: &Error) -> Option<&'static str> {
    match error {
        Error::Folder(FolderError::Taken { .. }) => {
            Some("; go on with it (--resume), or choose another folder (-o)")
        }
        Error::InputInTheWay(_) => Some(" (-o)"),
        Error::Folder(
            FolderError::InputInTheWay(_)
            | FolderError::ResultInTheWay { .. }
            | FolderError::LinkInTheWay { .. }
            | FolderError::DamagedCheckpoint(_)
            | FolderError::OtherJob { .. },
        ) => Some("; -o chooses another folder"),
        Error::UnusableImage {
            error: UnusableImage::NoLayer { .. },
            ..
        } => Some("; --layer chooses one"),
        Error::Refused(Refusal::SpecularMotion { .. }) => {
            Some("\n  help: `capwalk gradient --method fd` takes finite differences")
        }
        _ => None,
    }
}

/// The command that lists what a parameter could have been called.
fn parameter_hint(error: &ParameterError) -> Option<&'static str> {
    match error {
        ParameterError::Unknown { .. }
        | ParameterError::Missing
        | ParameterError::TwoSides { .. } => Some("`capwalk info SCENE` lists all parameters"),
        ParameterError::UnknownShape { .. } => Some("`capwalk info SCENE` lists all shapes"),
        ParameterError::Array { .. } => Some("`capwalk backward` gives gradients of arrays"),
        _ => None,
    }
}

/// The longest part of a source line that is shown, characters.
const SHOWN: usize = 100;

/// An error in a scene file with the line it is in, as compilers show it.
fn describe_load(error: &LoadError, source: &str) -> String {
    let Diagnostic {
        location, message, ..
    } = error.diagnostic();
    let mut text = format!("error: {message}");
    let Some(position) = error.position() else {
        text += &format!("\n  in {location}");
        return text + &advice(error, "  ");
    };
    let number = position.line.to_string();
    let margin = " ".repeat(number.len());
    text += &format!("\n{margin}--> {location}");
    if let Some(line) = source.lines().nth(position.line as usize - 1) {
        let column = position.column as usize - 1;
        // A long line is shown around the place.
        let start = column.saturating_sub(SHOWN / 2);
        let shown: String = line
            .chars()
            .skip(start)
            .take(SHOWN)
            .map(|c| if c == '\t' { ' ' } else { c })
            .collect();
        let marked = source.get(position.span.clone()).unwrap_or("");
        let marked = marked.lines().next().unwrap_or("").chars().count();
        let left = shown.chars().count().saturating_sub(column - start);
        let carets = "^".repeat(marked.clamp(1, left.max(1)));
        let indent = " ".repeat(column - start);
        text += &format!("\n{margin} |\n{number} | {shown}\n{margin} | {indent}{carets}");
    }
    text + &advice(error, &format!("{margin} = "))
}

/// What was expected, names that were perhaps meant, and notes.
fn advice(error: &LoadError, before: &str) -> String {
    let diagnostic = error.diagnostic();
    let mut text = String::new();
    if let Some(help) = &diagnostic.help {
        text += &format!("\n{before}{}", help.replace('\n', "\n    "));
    }
    if let LoadError::Definition(_) = error {
        text += &format!("\n{before}-D NAME=VALUE defines a parameter, in a job [defines] does");
    }
    if !diagnostic.near.is_empty() {
        let names: Vec<String> = diagnostic.near.iter().map(|n| format!("\"{n}\"")).collect();
        text += &format!("\n{before}did you mean {}?", names.join(" or "));
    }
    for note in &diagnostic.notes {
        text += &format!("\n{before}{note}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn causes_follow_in_order() {
        let error = anyhow::anyhow!("no space left").context("cannot write a.exr");
        assert_eq!(
            describe(&error),
            "error: cannot write a.exr\n  because no space left"
        );
        let error = anyhow::anyhow!("no space left").context("a.exr: no space left");
        assert_eq!(describe(&error), "error: a.exr: no space left");
    }
}
