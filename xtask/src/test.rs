//! `cargo xtask test`: what every change must pass.

use std::process::{Command, Stdio};

use anyhow::Result;

use crate::{cargo, last_step, step};

/// Runs the quick steps first, stops at the first that fails, and ends with
/// the tests' own summary lines.
pub fn run() -> Result<()> {
    component("fmt", "rustfmt", &["fmt", "--all", "--check"], &[])?;
    component(
        "lints",
        "clippy",
        &["clippy", "--workspace", "--all-targets"],
        &["--", "-D", "warnings"],
    )?;
    let mut doc = cargo(&[
        "doc",
        "--workspace",
        "--no-deps",
        "--document-private-items",
    ]);
    doc.env("RUSTDOCFLAGS", "-D warnings");
    step("documentation", doc)?;
    last_step("tests", cargo(&["test", "--workspace", "--no-fail-fast"]))
}

/// A step that needs a component of the toolchain; says so and goes on where
/// that is not installed.
fn component(name: &str, component: &str, arguments: &[&str], rest: &[&str]) -> Result<()> {
    let installed = cargo(&[arguments[0], "--version"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success());
    if !installed {
        println!("--- {name}");
        println!("    SKIPPED: {component} is not installed (`rustup component add {component}`)");
        return Ok(());
    }
    let mut command: Command = cargo(arguments);
    command.args(rest);
    step(name, command)
}
