//! How commands end: the exit status, and the one place where errors are shown.

use std::fmt::Write as _;
use std::process::ExitCode;

/// How a command that wrote its results ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Done; a checked gradient is right.
    Done,
    /// The gradient is wrong.
    Wrong,
    /// The noise hides whether the gradient is right.
    CouldNotTell,
    /// Too many samples were infinite or NaN.
    NonFinite,
    /// Stopped by Ctrl-C.
    Interrupted,
}

/// Exit status of bad input and refused derivatives.
pub const BAD_INPUT: u8 = 3;

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(match outcome {
            Outcome::Done => 0,
            Outcome::Wrong => 1,
            Outcome::CouldNotTell => 2,
            Outcome::NonFinite => 4,
            Outcome::Interrupted => 5,
        })
    }
}

/// The text of an error: what failed, then each cause on a line of its own.
pub fn describe(error: &anyhow::Error) -> String {
    let mut text = format!("error: {error}");
    for cause in error.chain().skip(1) {
        let cause = cause.to_string();
        let (first, rest) = cause.split_once('\n').unwrap_or((&cause, ""));
        // Writing to a string cannot fail.
        let _ = write!(text, "\n  because {first}");
        for line in rest.lines() {
            let _ = write!(text, "\n  {line}");
        }
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
    }
}
