//! Starting programs from the root of the workspace, each under a heading.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use anyhow::{Context, Result, bail};
use serde_json::Value;

/// The root of the workspace.
pub fn root() -> PathBuf {
    // Cargo says at run time in which checkout it runs.
    let package = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let package = package.unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
    package.parent().unwrap_or(Path::new(".")).to_owned()
}

/// Cargo's words for all crates with all that they can do, also what they have only if it is asked
/// for: the GPU.
pub const EVERYTHING: [&str; 3] = [
    "--workspace",
    "--features",
    "capwalk-cli/gpu,capwalk-python/gpu",
];

/// What builds for tests have no use for if they are built once: parts of crates to build anew, several
/// of them at a time, and lines in backtraces. Without the last two, a build takes a fifth less CPU time.
const ONCE: [(&str, &str); 3] = [
    ("CARGO_INCREMENTAL", "0"),
    ("CARGO_PROFILE_DEV_CODEGEN_UNITS", "1"),
    ("CARGO_PROFILE_DEV_DEBUG", "0"),
];

/// True if cargo builds without that.
static IS_BUILT_ONCE: AtomicBool = AtomicBool::new(false);

/// From here on cargo builds in less time, but a crate that changes is built as a whole. Both kinds of
/// builds stay beside each other, but for the Python module, which is built anew.
pub fn build_once() {
    IS_BUILT_ONCE.store(true, Ordering::Relaxed);
}

/// A call of the cargo that runs this task, in the root of the workspace.
pub fn cargo(arguments: &[&str]) -> Command {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(arguments).current_dir(root());
    if IS_BUILT_ONCE.load(Ordering::Relaxed) {
        command.envs(ONCE);
    }
    command
}

/// The packages of the workspace, as `cargo metadata` describes them.
pub fn packages() -> Result<Vec<Value>> {
    let output = cargo(&["metadata", "--no-deps", "--format-version", "1"]).output()?;
    let metadata: Value =
        serde_json::from_slice(&output.stdout).context("cargo metadata gave no JSON")?;
    let packages = metadata["packages"].as_array().cloned();
    packages.context("cargo metadata named no packages")
}

/// Runs a command under a heading; fails if it fails.
pub fn start(name: &str, mut command: Command) -> Result<()> {
    println!("--- {name}");
    let status = command
        .status()
        .with_context(|| format!("cannot start {:?}", command.get_program()))?;
    if !status.success() {
        bail!("{name} failed ({status})");
    }
    Ok(())
}

/// Runs a command as a step of this name, and says how long it took.
pub fn step(name: &str, command: Command) -> Result<()> {
    let started = Instant::now();
    start(name, command)?;
    println!("    {name}: {:.0} s", started.elapsed().as_secs_f64());
    Ok(())
}

/// The folder that cargo builds in.
pub fn target() -> PathBuf {
    let folder = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    root().join(folder.unwrap_or_else(|| "target".into()))
}

/// Builds the command line in release mode, and says where the program is.
pub fn capwalk() -> Result<PathBuf> {
    let build = cargo(&["build", "--release", "--package", "capwalk-cli"]);
    step("build", build)?;
    Ok(target().join("release/capwalk"))
}

/// The whole number at a place among arguments; a default where there is none.
pub fn number(arguments: &[String], i: usize, default: u64) -> Result<u64> {
    match arguments.get(i) {
        None => Ok(default),
        Some(text) => text
            .parse()
            .with_context(|| format!("expected a whole number instead of \"{text}\"")),
    }
}
