//! Mitsuba's projective sampling (Zhang et al. 2023), run as it is if Python has
//! the package `mitsuba`.

use std::fs;
use std::path::Path;
use std::process::Command;

use capwalk_diff::Estimate;
use capwalk_math::{Moments, Rgb};
use capwalk_scene::{Image, Integrator};
use capwalk_scene_io::export::write_scene;

use crate::gradients::Subject;
use crate::settings::{Failure, Quality, Settings};

/// Independent images: their spread is the error.
pub const SEEDS: usize = 8;

const SCRIPT: &str = include_str!("projective.py");

/// What became of it.
pub enum Projective {
    /// The derivative, with errors.
    Done {
        /// Mean and standard error over seeds.
        gradient: Estimate,
        /// The image itself.
        image: Estimate,
        /// Of the CPU, for all seeds, with loading.
        seconds: f64,
    },
    /// Why it was not run.
    NotThere(String),
}

/// Samples per pixel and seed.
pub fn spp(settings: &Settings) -> u32 {
    settings.quality.choose(1, 64, 512)
}

/// The derivative of the subject's image by a translation of a shape along an
/// axis. The interpreter is `python3`, or `CAPWALK_PYTHON`.
pub fn run(
    subject: &Subject,
    (shape, axis): (&str, usize),
    settings: &Settings,
) -> Result<Projective, Failure> {
    if settings.quality == Quality::Smoke {
        return Ok(Projective::NotThere("not run for quality smoke".into()));
    }
    let python = std::env::var("CAPWALK_PYTHON").unwrap_or_else(|_| "python3".into());
    let found = Command::new(&python)
        .args(["-c", "import mitsuba"])
        .output();
    if !found.is_ok_and(|output| output.status.success()) {
        return Ok(Projective::NotThere(format!(
            "{python} has no package mitsuba (`pip install mitsuba`; CAPWALK_PYTHON names another \
             interpreter)"
        )));
    }
    let watch = (settings.stages)("mitsuba");
    let folder = std::env::temp_dir().join(format!("capwalk-projective-{}", std::process::id()));
    let result = in_folder(&folder, &python, subject, (shape, axis), settings);
    // Whatever became of it, nothing is left behind.
    let _ = fs::remove_dir_all(&folder);
    match watch.should_stop() {
        true => Err(Failure::Stopped),
        false => result,
    }
}

fn in_folder(
    folder: &Path,
    python: &str,
    subject: &Subject,
    (shape, axis): (&str, usize),
    settings: &Settings,
) -> Result<Projective, Failure> {
    let unusable = |reason: String| Failure::Unusable(format!("projective sampling: {reason}"));
    fs::create_dir_all(folder).map_err(|error| unusable(error.to_string()))?;
    let scene = folder.join("scene.xml");
    write_scene(&subject.scene, &scene).map_err(|error| unusable(error.to_string()))?;
    let (integrator, depth) = match subject.scene.settings.integrator {
        Integrator::Path { max_depth, .. } => ("prb_projective", max_depth.unwrap_or(8)),
        _ => ("direct_projective", 2),
    };
    let numbers = folder.join("gradient.f32");
    let output = Command::new(python)
        .args(["-c", SCRIPT])
        .arg(&scene)
        .args([shape, &axis.to_string(), integrator, &depth.to_string()])
        .args([spp(settings).to_string(), SEEDS.to_string()])
        .arg(&numbers)
        .output()
        .map_err(|error| unusable(error.to_string()))?;
    if !output.status.success() {
        // Its failure is a result about it, not about us.
        let text = String::from_utf8_lossy(&output.stderr);
        let last = text.lines().rev().find(|line| !line.trim().is_empty());
        return Ok(Projective::NotThere(format!(
            "it failed: {}",
            last.unwrap_or("")
        )));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    // Behind what Mitsuba has to say.
    let seconds = text.lines().last().unwrap_or("").trim().parse();
    let seconds = seconds.map_err(|_| unusable(format!("expected its seconds, found {text:?}")))?;
    let [width, height] = subject.scene.film.crop_size.map(|n| n as usize);
    let read = |file: &Path| {
        let bytes = fs::read(file).map_err(|error| unusable(error.to_string()))?;
        estimate(&bytes, width, height).ok_or_else(|| {
            unusable(format!(
                "{} bytes for {width} × {height} pixels",
                bytes.len()
            ))
        })
    };
    Ok(Projective::Done {
        gradient: read(&numbers)?,
        image: read(&folder.join("gradient.f32.image"))?,
        seconds,
    })
}

/// Mean and standard error over the images in a file.
fn estimate(bytes: &[u8], width: usize, height: usize) -> Option<Estimate> {
    let count = width * height * 3;
    if bytes.len() != 4 * count * SEEDS {
        return None;
    }
    let number = |i: usize| {
        let four = bytes[4 * i..4 * i + 4].try_into().expect("four bytes");
        f64::from(f32::from_le_bytes(four))
    };
    let moments = |i: usize| {
        let mut moments = Moments::default();
        (0..SEEDS).for_each(|seed| moments.add(number(seed * count + i)));
        moments
    };
    let image = |of: fn(&Moments) -> f64| Image {
        width,
        height,
        pixels: (0..width * height)
            .map(|pixel| Rgb::from([0, 1, 2].map(|c| of(&moments(3 * pixel + c)))))
            .collect(),
    };
    Some(Estimate {
        mean: image(|m| m.mean),
        standard_error: image(Moments::standard_error),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_of_all_seeds_become_means() {
        let image = |seed: usize| (0..6).map(move |i| (i + 10 * seed) as f32);
        let numbers = (0..SEEDS).flat_map(image);
        let bytes: Vec<u8> = numbers.flat_map(f32::to_le_bytes).collect();
        let found = estimate(&bytes, 2, 1).expect("it is complete");
        assert_eq!(found.mean.at(1, 0), Rgb::new(38.0, 39.0, 40.0));
        // Of 0, 10, ..., 70: the standard deviation is 10 √6.
        let expected = 10.0 * 6.0_f64.sqrt() / 8.0_f64.sqrt();
        assert!((found.standard_error.at(0, 0).r - expected).abs() < 1e-9);
        assert!(estimate(&bytes, 2, 2).is_none());
    }
}
