//! The finite differences that the derivatives of a folder are compared with.

use capwalk_diff::check::without_rounding;
use capwalk_diff::{Estimate, PreparedScene, RenderOptions, Unwatched, finite_difference};
use capwalk_scene::{Scene, Tangent, params};

use crate::folder::{Differences, Folder};
use crate::store::{Reference, plain};

/// Not that of a gradient.
const SEED: u64 = 0x9e37_79b9_7f4a_7c15;

/// The motion of a folder's scene that a parameter stands for.
pub fn tangent(folder: &Folder, scene: &Scene, parameter: &str) -> Tangent {
    let tangent = params::Registry::new(scene).tangent(scene, parameter);
    tangent.unwrap_or_else(|error| panic!("{}, {parameter}: {error}", folder.name))
}

/// The differences that are kept: with more samples where there is more noise.
pub fn reference(folder: &Folder, parameter: &str, asked: &Differences) -> Estimate {
    let name = format!("{}, {parameter}", folder.name);
    let kept = Reference {
        name: format!("phenomena_{}", plain(&name)),
        of: &name,
        step: asked.step,
        spp: asked.spp,
    };
    kept.get(|spp| {
        let scene = folder.scene();
        let tangent = tangent(folder, &scene, parameter);
        let options = RenderOptions {
            adaptive: true,
            ..RenderOptions::new(spp, SEED)
        };
        let prepared = PreparedScene::new(scene);
        let made = finite_difference(&prepared, &tangent, asked.step, &options, &Unwatched);
        let made = made.expect("covered");
        assert_eq!(made.statistics.non_finite, 0, "{name}");
        without_rounding(&made, asked.step)
    })
}
