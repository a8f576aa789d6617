//! `cargo xtask verdicts`: what `check` says of many gradients that are right, and of some made wrong.

use anyhow::Result;

use crate::shell::{cargo, number, step};

/// So many checks from some number on, each (or every so many) made from its number.
pub fn run(rest: &[String]) -> Result<()> {
    let mut command = cargo(&["test", "--package", "capwalk", "--lib"]);
    command
        .args(["--", "--nocapture", "right_gradients_are_not_called_wrong"])
        .env("CAPWALK_VERDICTS", number(rest, 0, 3000)?.to_string())
        .env("CAPWALK_VERDICTS_FROM", number(rest, 1, 0)?.to_string())
        .env(
            "CAPWALK_VERDICTS_EVERY",
            number(rest, 2, 1)?.max(1).to_string(),
        );
    step("verdicts", command)
}
