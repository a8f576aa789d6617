//! `cargo xtask references`: finite differences that tests compare gradients with, made again by
//! long runs and kept in `tests/references`.

use anyhow::Result;

use crate::shell::{cargo, step};

/// The test programs that compare with them.
const PROGRAMS: [[&str; 2]; 3] = [
    ["capwalk-diff", "gradients"],
    ["capwalk-cli", "phenomena"],
    ["capwalk-paper", "fields"],
];

/// The variable in which the programs are asked for references instead of tests.
const VARIABLE: &str = "CAPWALK_REFERENCES";

/// Makes those of all tests, or of those whose names contain one of the arguments.
pub fn run(filters: &[String]) -> Result<()> {
    for [package, program] in PROGRAMS {
        let mut tests = cargo(&["test", "-p", package, "--test", program, "--no-fail-fast"]);
        tests.arg("--").args(filters).env(VARIABLE, "make");
        step(program, tests)?;
    }
    Ok(())
}
