//! `cargo xtask verdicts`: what `check` says of many gradients that are right, and of some made wrong.

use anyhow::{Context, Result};

use crate::shell::{cargo, step};

/// So many checks from some number on, each (or every so many) made from its number.
pub fn run(rest: &[String]) -> Result<()> {
    let number = |i: usize, default: u64| match rest.get(i) {
        None => Ok(default),
        Some(text) => text
            .parse::<u64>()
            .with_context(|| format!("expected a whole number instead of \"{text}\"")),
    };
    let mut command = cargo(&["test", "--package", "capwalk", "--lib"]);
    command
        .args(["--", "--nocapture", "right_gradients_are_not_called_wrong"])
        .env("CAPWALK_VERDICTS", number(0, 3000)?.to_string())
        .env("CAPWALK_VERDICTS_FROM", number(1, 0)?.to_string())
        .env("CAPWALK_VERDICTS_EVERY", number(2, 1)?.max(1).to_string());
    step("verdicts", command)
}
