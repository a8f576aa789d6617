//! `--method edges` against the finite differences of `check`, wherever something
//! moves. The verdict must be right, and signs must cancel. The mean of z² is left
//! to the verdict: with so little noise in the gradient, it is that of the
//! differences again.

use std::path::Path;

use capwalk_render::check::{Verdict, compare};
use capwalk_render::{Estimate, GradientOptions, Method, Options, Unwatched, gradient};
use capwalk_scene::{Motion, Scene, SensorMotion, params};
use capwalk_scene_io::image;

use crate::differences::SIGN;
use crate::folder::{Edges, Folder};

/// Enough samples to see that two methods are not the same.
const FEW: u32 = 4;

fn by(method: Method, scene: &Scene, motion: &Motion, spp: u32) -> Estimate {
    let settings = GradientOptions {
        method,
        ..GradientOptions::new(Options {
            spp,
            seed: scene.settings.seed,
            threads: None,
        })
    };
    let result = gradient(scene, motion, &settings, &Unwatched).expect("covered");
    assert_eq!(result.statistics.non_finite, 0);
    result.gradient
}

/// Demands that gathered edges agree with the differences in a file, or are walks
/// again.
pub fn agree(folder: &Folder, parameter: &str, edges: Edges, check: &Path) {
    let name = format!("{}, {parameter}, edges", folder.name);
    let scene = folder.scene();
    let motion = params::motion(&scene, parameter).unwrap_or_else(|e| panic!("{name}: {e}"));
    let is_at_rest = motion.shapes.iter().all(Option::is_none);
    if is_at_rest && motion.sensor == SensorMotion::default() {
        return;
    }
    let [few, walked] =
        [Method::Edges, Method::Walk].map(|method| by(method, &scene, &motion, FEW));
    assert_eq!(
        few.mean == walked.mean,
        edges == Edges::Walked,
        "{name}: are they the same as walks, as check.json says?"
    );
    if edges != Edges::Gathered {
        return;
    }
    let differences = image::read(check).expect("readable");
    let layer = |name: &str| differences.layer(name).expect("written").clone();
    let differences = Estimate {
        mean: layer("reference"),
        standard_error: layer("reference_stderr"),
    };
    let ours = by(Method::Edges, &scene, &motion, scene.settings.spp);
    let result = compare(&ours, &differences);
    println!(
        "{name}: {} pixels, mean z² {:.3} ± {:.3}, sign {:+.2}, slope {:.3} ± {:.3}",
        result.pixels,
        result.mean_z_squared,
        result.mean_z_squared_error,
        result.sign,
        result.slope,
        result.slope_error,
    );
    assert_eq!(result.verdict, Verdict::Right, "{name}");
    assert!(
        result.sign.abs() < SIGN,
        "{name}: systematic sign {}",
        result.sign
    );
}
