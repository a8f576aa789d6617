//! `cargo xtask test`: what every change must pass, and with `--thorough` what takes too long for
//! that.

use std::process::Stdio;
use std::time::{Duration, Instant};

use anyhow::Result;

use crate::shell::{EVERYTHING, cargo, start};
use crate::tier::Tier;
use crate::{layout, package, python, soak, vulkan};

/// Runs the quick steps first, stops at the first that fails, and ends with
/// the time that each took.
pub fn run(arguments: &[String]) -> Result<()> {
    let tier = Tier::of(arguments)?;
    python::fetch();
    let mut times = Vec::new();
    let result = STEPS.iter().try_for_each(|(name, step)| {
        let started = Instant::now();
        let result = step(tier);
        times.push((*name, started.elapsed()));
        result
    });
    println!("--- time");
    for (name, time) in &times {
        println!("    {name:14}{:>5}", clock(*time));
    }
    let whole = times.iter().map(|(_, time)| *time).sum();
    println!("    {:14}{:>5} minutes", "in all", clock(whole));
    result
}

type Step = fn(Tier) -> Result<()>;

const STEPS: [(&str, Step); 8] = [
    ("layout", |_| layout::run(&[])),
    ("format", |_| format()),
    ("lints", |_| lints()),
    ("packages", |_| package::run(false)),
    ("documentation", |_| documentation()),
    ("tests", |_| tests()),
    ("python", python::test),
    ("soak", |tier| match tier {
        Tier::Change => Ok(()),
        Tier::Thorough => soak::run(&["600".into()]),
    }),
];

fn format() -> Result<()> {
    component("rustfmt", &["fmt", "--all", "--check"])
}

/// All code, then what is published as it is by default, but for its tests.
fn lints() -> Result<()> {
    const STRICT: [&str; 3] = ["--", "-D", "warnings"];
    let all = [&["clippy", "--all-targets"], &EVERYTHING[..], &STRICT];
    component("clippy", &all.concat())?;
    // Beside the crate that wants the baselines, every crate would have them.
    let without = ["clippy", "--workspace", "--exclude", "capwalk-paper"];
    component("clippy", &[&without[..], &STRICT].concat())
}

fn documentation() -> Result<()> {
    let mut doc = cargo(&["doc", "--no-deps", "--document-private-items"]);
    doc.args(EVERYTHING).env("RUSTDOCFLAGS", "-D warnings");
    start("documentation", doc)
}

/// All tests, then those of the command line as it is by default.
fn tests() -> Result<()> {
    let mut all = cargo(&["test", "--no-fail-fast"]);
    all.args(EVERYTHING).envs(vulkan::for_tests());
    start("tests", all)?;
    let default = ["test", "--workspace", "--test", "cli", "default_build"];
    start("tests of the default build", cargo(&default))
}

/// A step that needs a component of the toolchain; says so and goes on where
/// that is not installed.
fn component(component: &str, arguments: &[&str]) -> Result<()> {
    let installed = cargo(&[arguments[0], "--version"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success());
    if !installed {
        println!("--- {component}");
        println!("    SKIPPED: {component} is not installed (`rustup component add {component}`)");
        return Ok(());
    }
    start(component, cargo(arguments))
}

/// Minutes and seconds.
fn clock(time: Duration) -> String {
    let seconds = time.as_secs_f64().round() as u64;
    format!("{}:{:02}", seconds / 60, seconds % 60)
}
