//! `cargo xtask gpu`: queries, images and gradients on the adapter that is found, as tables, and
//! Mitsuba's images and gradients where it runs on the GPU, too.

use std::process::Command;

use anyhow::Result;

use crate::mitsuba;
use crate::peers::{SUBJECTS, Subject};
use crate::shell::{capwalk, cargo, root, start};
use crate::vulkan;

/// Of the scenes that Mitsuba is compared in, those that are measured here: the device has all
/// that they need.
const SCENES: [&str; 7] = [
    "leaf",
    "ball",
    "box-room",
    "lattice-shadow",
    "cornell-box",
    "painted-box",
    "glossy-box",
];

/// Cargo's words for the programs that measure.
const QUERIES: [&str; 4] = ["--package", "capwalk-gpu", "--example", "gpu_table"];
const IMAGES: [&str; 4] = [
    "--package",
    "capwalk-gpu-render",
    "--example",
    "image_table",
];

/// How Mitsuba runs on a GPU.
const VARIANT: &str = "cuda_ad_rgb";

/// Measures and compares; further arguments choose the adapter.
pub fn run(rest: &[String]) -> Result<()> {
    let mut build = cargo(&["build", "--release"]);
    build.args(QUERIES).args(IMAGES);
    start("build", build)?;
    let mut queries = example(&QUERIES);
    queries.args(rest);
    let queries = start("queries", queries);
    let mut images = example(&IMAGES);
    for adapter in rest {
        images.args(["--adapter", adapter]);
    }
    for subject in subjects() {
        images.arg(subject.scene()).args(subject.parameter());
    }
    let images = start("images and gradients", images);
    peer()?;
    queries.and(images)
}

fn example(example: &[&str]) -> Command {
    let mut command = cargo(&["run", "--release", "--quiet"]);
    command.args(example).envs(vulkan::quiet()).arg("--");
    command
}

fn subjects() -> impl Iterator<Item = &'static Subject> {
    let subjects = SUBJECTS.iter();
    subjects.filter(|subject| SCENES.contains(&subject.name))
}

/// Has Mitsuba do the same, or says why it cannot.
fn peer() -> Result<()> {
    let python = mitsuba::python();
    let peer = || {
        let mut command = Command::new(&python);
        command.arg(root().join("xtask/gpu_peer.py")).arg(VARIANT);
        command
    };
    if let Some(reason) = why_not(peer()) {
        println!("--- Mitsuba\n    left out: {reason}");
        return Ok(());
    }
    let capwalk = capwalk()?;
    let mut measure = peer();
    for subject in subjects() {
        let folder = root().join("target/gpu").join(subject.name);
        let file = subject.copy_to(&folder, &capwalk, None)?;
        measure.arg(file).args(subject.parameter());
    }
    start("Mitsuba", measure)
}

/// Why a program fails; `None` if it does not.
fn why_not(mut command: Command) -> Option<String> {
    match command.output() {
        Ok(output) if output.status.success() => None,
        Ok(output) => {
            let text = String::from_utf8_lossy(&output.stderr);
            let last = text.trim().lines().last().map(str::to_owned);
            Some(last.unwrap_or_else(|| format!("it ended with {}", output.status)))
        }
        Err(error) => {
            let program = command.get_program().display();
            Some(format!("cannot start {program}: {error}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_scenes_are_known() {
        assert_eq!(subjects().count(), SCENES.len());
    }
}
