//! Walks against finite differences, and what is demanded of them.
//!
//! The verdict must be right: an error of a tenth would have been seen. Besides, the mean of z²
//! must lie in [0.8, 1.25], over at least so many pixels, which are independent of each other, and
//! their signs must cancel. Seeds are fixed, so a check that passes goes on passing.

use std::ops::RangeInclusive;

use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{
    Estimate, GradientOptions, Method, PreparedScene, Unwatched, WalkSettings, gradient,
};

use crate::folder::{Differences, Folder, WIDE};
use crate::methods::SIGN;
use crate::reference::tangent;

const MEAN_Z_SQUARED: RangeInclusive<f64> = 0.8..=1.25;

/// Demands that a derivative agrees with the reference.
pub fn agree(folder: &Folder, parameter: &str, asked: &Differences, reference: &Estimate) {
    let name = format!("{}, {parameter}", folder.name);
    let scene = folder.scene();
    let tangent = tangent(folder, &scene, parameter);
    let options = GradientOptions {
        adaptive: true,
        method: Method::Walk,
        walk: WalkSettings {
            max_radius: WIDE.parse::<f64>().expect("degrees").to_radians(),
            ..WalkSettings::default()
        },
        spp: asked.derivative_spp.unwrap_or(scene.settings.spp),
        ..GradientOptions::of(&scene)
    };
    let [width, height] = scene.film.crop_size;
    let found = gradient(&PreparedScene::new(scene), &tangent, &options, &Unwatched);
    let found = found.expect("covered");
    assert_eq!(found.statistics.non_finite, 0, "{name}");
    let result = compare(&found.gradient, reference);
    println!("{name}: {result}, worst {:?}", result.worst.first());
    assert_eq!(result.verdict, Verdict::Right, "{name}");
    let z2 = result.mean_z_squared;
    assert!(MEAN_Z_SQUARED.contains(&z2), "{name}: mean z² {z2}");
    let sign = result.sign;
    assert!(sign.abs() < SIGN, "{name}: systematic sign {sign}");
    let least = asked.pixels.unwrap_or((width * height) as usize / 2);
    let pixels = result.pixels;
    assert!(pixels >= least, "{name}: only {pixels} pixels have noise");
}
