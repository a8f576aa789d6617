//! `cargo xtask parity`: the same scenes in capwalk and in Mitsuba 3; with
//! `--golden`, Mitsuba's images for tests that do without it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use crate::deviation::{Deviation, Finding};
use crate::mitsuba::{MITSUBA, environment};
use crate::shell::{capwalk, root, step};

/// Samples per pixel of capwalk's image.
const SPP: u32 = 1024;
/// Samples per pixel of each of Mitsuba's images, and how many there are:
/// enough for an error of its own to a fifth.
const MITSUBA_SPP: u32 = 64;
const MITSUBA_SEEDS: u32 = 16;
/// Samples per pixel of each of the renderings behind a golden image: with as many
/// seeds eight times as many as the tests take, so that their own noise rules.
const GOLDEN_SPP: u32 = 128;
/// Renders every scene of `tests/parity`, or those named, with both programs and
/// compares; after `--golden`, with Mitsuba alone, into golden images.
pub fn run(arguments: &[String]) -> Result<()> {
    let (golden, names) = match arguments.split_first() {
        Some((first, names)) if first == "--golden" => (true, names),
        _ => (false, arguments),
    };
    let scenes = scenes(names)?;
    let work = root().join("target/parity");
    fs::create_dir_all(&work)?;
    let python = environment()?;
    match golden {
        true => make_golden(&python, &scenes),
        false => compare_all(&python, &scenes, &work),
    }
}

/// Renders the scenes with Mitsuba into the images that tests compare with.
fn make_golden(python: &Path, scenes: &[PathBuf]) -> Result<()> {
    println!("--- golden images by {MITSUBA}, scalar_rgb");
    for scene in scenes {
        let name = stem(scene);
        let file = root().join(format!("tests/parity/golden/{name}.npz"));
        let mut command = Command::new(python);
        command
            .arg(root().join("xtask/golden.py"))
            .arg(scene)
            .arg(file)
            .args([GOLDEN_SPP.to_string(), MITSUBA_SEEDS.to_string()]);
        step(&name, command)?;
    }
    Ok(())
}

fn compare_all(python: &Path, scenes: &[PathBuf], work: &Path) -> Result<()> {
    let capwalk = capwalk()?;

    println!("--- parity with {MITSUBA}, scalar_rgb");
    let width = scenes.iter().map(|s| stem(s).len()).max().unwrap_or(0);
    println!(
        "{:width$}   pixels   passing   mean z²           sign   brightness",
        "scene"
    );
    let mut differing = Vec::new();
    for scene in scenes {
        let name = stem(scene);
        let result = compare(python, &capwalk, scene, work)
            .with_context(|| format!("scene {}", scene.display()))?;
        let number = |key: &str| result[key].as_f64().unwrap_or(f64::NAN);
        let right = result["right"].as_bool().unwrap_or(false);
        println!(
            "{name:width$}   {:6}   {:6.2}%   {:.3} ± {:.3}   {:+5.1}   {:+9.2}%   {}",
            number("pixels"),
            100.0 * number("passing"),
            number("mean_z_squared"),
            number("mean_z_squared_error"),
            number("sign"),
            100.0 * number("relative_mean_difference"),
            if right { "equal" } else { "DIFFERENT" }
        );
        let Some(known) = Deviation::of(&name)? else {
            if !right {
                differing.push(name);
            }
            continue;
        };
        match known.judge(&result)? {
            Finding::AsKnown => println!("{:width$}   on purpose: {}", "", known.reason),
            Finding::Stale => println!(
                "{:width$}   NOTE: no longer differs; is its entry in deviation.rs out of date?",
                ""
            ),
            Finding::Drifted(how) => {
                println!("{:width$}   on purpose, but by too much: {how}", "");
                differing.push(name);
            }
        }
    }
    ensure!(
        differing.is_empty(),
        "{} differ; see the images in {}",
        differing.join(", "),
        work.display()
    );
    Ok(())
}

fn stem(scene: &Path) -> String {
    let stem = scene.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

fn scenes(names: &[String]) -> Result<Vec<PathBuf>> {
    let folder = root().join("tests/parity");
    let entries =
        fs::read_dir(&folder).with_context(|| format!("cannot list {}", folder.display()))?;
    let mut scenes = Vec::new();
    for entry in entries {
        let path = entry?.path();
        let wanted = names.is_empty() || names.contains(&stem(&path));
        if path.extension().is_some_and(|e| e == "xml") && wanted {
            scenes.push(path);
        }
    }
    ensure!(
        !scenes.is_empty(),
        "no scene to compare in {}",
        folder.display()
    );
    scenes.sort();
    Ok(scenes)
}

/// Renders a scene with both and compares.
fn compare(python: &Path, capwalk: &Path, scene: &Path, work: &Path) -> Result<Value> {
    let image = work.join(format!("{}.npz", stem(scene)));
    let output = Command::new(capwalk)
        .arg("render")
        .arg(scene)
        .args(["--spp", &SPP.to_string()])
        .arg("-o")
        .arg(&image)
        .output()?;
    if !output.status.success() {
        bail!("capwalk: {}", String::from_utf8_lossy(&output.stderr));
    }
    let output = Command::new(python)
        .arg(root().join("xtask/parity.py"))
        .arg(scene)
        .arg(&image)
        .args([MITSUBA_SPP.to_string(), MITSUBA_SEEDS.to_string()])
        .arg(work.join(format!("{}-differs", stem(scene))))
        .output()?;
    if !output.status.success() {
        bail!("Mitsuba: {}", String::from_utf8_lossy(&output.stderr));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let last = text.lines().last().unwrap_or_default();
    serde_json::from_str(last).with_context(|| format!("Mitsuba's script said \"{last}\""))
}
