//! `capwalk check` with walks: what it says about a derivative, and what is demanded of it.
//!
//! Its verdict must be right: an error of a tenth would have been seen. Besides,
//! the mean of z² must lie in [0.8, 1.25], over at least so many pixels, which
//! are independent of each other, and their signs must cancel. These tests
//! together raise a false alarm in about one check of 4000; seeds are fixed, so
//! a check that passes goes on passing.

use std::path::Path;

use serde_json::Value;

use crate::capwalk;
use crate::folder::{Differences, Folder, WIDE};
use crate::methods::SIGN;

const MEAN_Z_SQUARED: std::ops::RangeInclusive<f64> = 0.8..=1.25;

/// Checks a derivative as a user does, and demands agreement. What is written goes to
/// a file, to be used again.
pub fn agree(folder: &Folder, parameter: &str, differences: &Differences, file: &Path) {
    let name = format!("{}, {parameter}", folder.name);
    let (step, spp) = (differences.step.to_string(), differences.spp.to_string());
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
        "--reference-spp",
        &spp,
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
    println!(
        "{name}: {pixels} pixels, mean z² {z2:.3} ± {:.3}, sign {sign:+.2}, scale factor {:.3} ± {:.3}, \
         {:.1} s for the gradient, {:.1} s for the differences",
        comparison("mean_z_squared_error"),
        comparison("scale_factor"),
        comparison("scale_factor_error"),
        number("/gradient/seconds"),
        number("/reference/seconds"),
    );
    assert_eq!(done.status, 0, "{name}: {}", said["comparison"]);
    for layer in ["gradient", "reference"] {
        let bad = number(&format!("/{layer}/non_finite"));
        assert_eq!(bad, 0.0, "{name}: samples of the {layer}");
    }
    assert!(MEAN_Z_SQUARED.contains(&z2), "{name}: mean z² {z2}");
    assert!(sign.abs() < SIGN, "{name}: systematic sign {sign}");
    let all = number("/size/0") * number("/size/1");
    let least = differences.pixels.map_or(0.5 * all, |n| n as f64);
    assert!(pixels >= least, "{name}: only {pixels} pixels have noise");
}
