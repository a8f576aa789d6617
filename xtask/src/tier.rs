//! How much is tested.

use anyhow::{Result, bail};

/// How much `cargo xtask test` tests.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Tier {
    /// What every change must pass.
    Change,
    /// That, the stored outputs of the tutorials, and randomised tests for ten minutes each.
    Thorough,
}

impl Tier {
    /// The tier that the arguments behind `test` ask for.
    pub fn of(arguments: &[String]) -> Result<Self> {
        match arguments {
            [] => Ok(Self::Change),
            [flag] if flag == "--thorough" => Ok(Self::Thorough),
            _ => bail!("expected nothing or `--thorough` behind `test`"),
        }
    }
}
