//! How much is tested.

use anyhow::{Result, bail};

/// How much `cargo xtask test` tests; each tier has what those before it have.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tier {
    /// Between two edits: layout, format, lints, unit tests and a handful of phenomena.
    Quick,
    /// What every change must pass.
    Change,
    /// The stored outputs of the tutorials as well, and randomised tests for ten minutes each.
    Thorough,
}

impl Tier {
    /// The tier that the arguments behind `test` ask for.
    pub fn of(arguments: &[String]) -> Result<Self> {
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        match arguments[..] {
            ["--quick"] => Ok(Self::Quick),
            [] => Ok(Self::Change),
            ["--thorough"] => Ok(Self::Thorough),
            _ => bail!("expected nothing, `--quick` or `--thorough` behind `test`"),
        }
    }
}
