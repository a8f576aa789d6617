//! `cargo xtask test`: what every change must pass; with `--quick` what is asked between two edits,
//! with `--thorough` also what takes too long for every change.

use std::process::Stdio;
use std::thread;
use std::time::{Duration, Instant};

use anyhow::Result;

use crate::shell::{EVERYTHING, build_once, cargo, start};
use crate::tier::Tier;
use crate::{layout, package, python, soak, vulkan};

/// Runs the steps of a tier, those that are done soonest first, stops at the first that fails, and
/// ends with the time that each took.
pub fn run(arguments: &[String]) -> Result<()> {
    let tier = Tier::of(arguments)?;
    if tier >= Tier::Change {
        build_once();
        python::fetch();
    }
    let mut times = Vec::new();
    let mut steps = STEPS.iter().filter(|(_, least, _)| tier >= *least);
    let result = steps.try_for_each(|(name, _, step)| {
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

/// Each with the first tier that has it.
const STEPS: [(&str, Tier, Step); 8] = [
    ("layout", Tier::Quick, |_| layout::run(&[])),
    ("format", Tier::Quick, |_| format()),
    ("lints", Tier::Quick, |_| lints()),
    ("packages", Tier::Change, |_| package::run(false)),
    ("documentation", Tier::Change, |_| documentation()),
    ("build", Tier::Change, |_| build()),
    ("tests", Tier::Quick, tests),
    ("soak", Tier::Thorough, |_| soak::run(&["600".into()])),
];

/// Phenomena of the quick tier: a silhouette before the camera, shadows of emitters and points, a
/// mirror, a sky, a glossy material, a colour and a refusal.
const FEW_PHENOMENA: [&str; 8] = [
    "albedo",
    "discontinuous_texture",
    "hard_shadow_of_a_point_light",
    "object_moves_in_a_planar_mirror",
    "shadow_in_a_rough_mirror",
    "shadow_of_a_moving_occluder",
    "silhouette_with_a_box_filter",
    "sun_turns",
];

fn format() -> Result<()> {
    component("rustfmt", &["fmt", "--all", "--check"])
}

fn lints() -> Result<()> {
    let arguments = [
        &["clippy", "--all-targets"],
        &EVERYTHING[..],
        &["--", "-D", "warnings"],
    ];
    component("clippy", &arguments.concat())
}

fn documentation() -> Result<()> {
    let mut doc = cargo(&["doc", "--no-deps", "--document-private-items"]);
    doc.args(EVERYTHING).env("RUSTDOCFLAGS", "-D warnings");
    start("documentation", doc)
}

/// Builds what all tests need, those of Python too, without what examples and benchmarks are built for.
fn build() -> Result<()> {
    let mut build = cargo(&["build", "--lib", "--bins", "--tests"]);
    build.args(EVERYTHING);
    start("build", build)
}

/// All tests, Python's beside those of Rust, which leave a fifth of two cores idle; of the quick tier unit
/// tests, without a GPU, and a few phenomena.
fn tests(tier: Tier) -> Result<()> {
    if tier >= Tier::Change {
        return thread::scope(|scope| {
            let python = scope.spawn(|| python::test(tier));
            let rust = rust_tests();
            let python = python
                .join()
                .expect("the thread of Python's tests panicked");
            rust.and(python)
        });
    }
    let mut units = cargo(&["test", "--lib", "--bins"]);
    units.args(EVERYTHING).envs(vulkan::none());
    start("unit tests", units)?;
    let mut phenomena = cargo(&["test", "--test", "phenomena"]);
    phenomena.args(EVERYTHING).arg("--").args(FEW_PHENOMENA);
    start("phenomena", phenomena)
}

fn rust_tests() -> Result<()> {
    let test = |what: &[&str]| {
        let mut test = cargo(&["test", "--no-fail-fast"]);
        test.args(what).args(EVERYTHING);
        test.envs(vulkan::for_tests());
        test
    };
    start("tests", test(&["--lib", "--bins", "--tests"]))?;
    start("examples in documentation", test(&["--doc"]))
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
