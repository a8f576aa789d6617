//! `capwalk check` with walks: what it says about a derivative, and what is demanded of it.
//!
//! Its verdict must be right: an error of a tenth would have been seen. Besides,
//! the mean of z² must lie in [0.8, 1.25], over at least so many pixels, which
//! are independent of each other, and their signs must cancel. These tests
//! together raise a false alarm in about one check of 4000; seeds are fixed, so
//! a check that passes goes on passing. A part of the samples is enough to see an
//! error of a fifth.

use std::path::Path;

use serde_json::Value;

use crate::capwalk;
use crate::folder::{Differences, Folder, WIDE};

/// A factor that is wrong by this is excluded at two standard errors, where a part of the samples is
/// drawn.
pub const SEEN_BY_PART: f64 = 0.2;
const MEAN_Z_SQUARED: std::ops::RangeInclusive<f64> = 0.8..=1.25;
/// Standard errors of the sum of all differences.
pub const SIGN: f64 = 4.0;

/// Checks a derivative as a user does, with this part of its samples, and says where it does not
/// agree. What is written goes to a file, to be used again.
pub fn agree(
    folder: &Folder,
    parameter: &str,
    differences: &Differences,
    part: u32,
    file: &Path,
) -> Result<(), String> {
    let name = format!("{}, {parameter}", folder.name);
    let samples = |all: u32| (all / part).to_string();
    let (step, reference_spp) = (differences.step.to_string(), samples(differences.spp));
    let spp = samples(folder.scene().settings.spp);
    let (file, preview) = (file.display(), file.with_extension("png"));
    let files = format!("{file},{}", preview.display());
    let done = capwalk(&[
        "check",
        &folder.scene_file(),
        "-p",
        parameter,
        "--max-angle",
        WIDE,
        "--step",
        &step,
        "--spp",
        &spp,
        "--reference-spp",
        &reference_spp,
        "--json",
        "-o",
        &files,
    ]);
    let said: Value = serde_json::from_str(&done.output)
        .unwrap_or_else(|_| panic!("{name}: {}{}", done.output, done.errors));
    let number = |path: &str| {
        let number = said.pointer(path).and_then(Value::as_f64);
        number.unwrap_or_else(|| panic!("{name}: no number {path} in {said}"))
    };
    let comparison = |key: &str| number(&format!("/comparison/{key}"));
    let (pixels, z2, sign) = (
        comparison("pixels"),
        comparison("mean_z_squared"),
        comparison("sign"),
    );
    let off = (comparison("scale_factor") - 1.0).abs();
    // An infinite one is no number.
    let error = said["comparison"]["scale_factor_error"].as_f64();
    let error = error.unwrap_or(f64::INFINITY);
    println!(
        "{name}: {pixels} pixels, mean z² {z2:.3} ± {:.3}, sign {sign:+.2}, scale factor {:.3} ± {:.3}, \
         {:.1} s for the gradient, {:.1} s for the differences",
        comparison("mean_z_squared_error"),
        comparison("scale_factor"),
        error,
        number("/gradient/seconds"),
        number("/reference/seconds"),
    );
    for layer in ["gradient", "reference"] {
        let bad = number(&format!("/{layer}/non_finite"));
        assert_eq!(bad, 0.0, "{name}: samples of the {layer}");
    }
    let all = number("/size/0") * number("/size/1");
    let least = differences.pixels.map_or(0.5 * all, |n| n as f64);
    // Enough of a part of the samples.
    let tells = part > 1 && off + 2.0 * error <= SEEN_BY_PART;
    let verdict = &said["comparison"]["verdict"];
    let is_agreement = match verdict.as_str() {
        Some("right") => true,
        Some("inconclusive") => tells && said["comparison"]["reason"].is_null(),
        _ => false,
    };
    let wrong = if !is_agreement {
        said["comparison"].to_string()
    } else if !MEAN_Z_SQUARED.contains(&z2) {
        format!("mean z² {z2}")
    } else if sign.abs() >= SIGN {
        format!("systematic sign {sign}")
    } else if pixels < least {
        format!("only {pixels} pixels have noise")
    } else {
        return Ok(());
    };
    Err(format!("{name}: {wrong}"))
}
