//! Gradients against finite differences: shadows, with what scene files cannot
//! say (walks of other kinds) and in built-in scenes; the phenomena themselves
//! are in `tests/scenes`.
//!
//! In every case `check::compare` must say right: an error of a tenth would
//! have been seen. Besides, the mean of z² must lie in [0.8, 1.25] over at
//! least 1000 pixels, which are independent of each other, and their signs must
//! cancel. The comparison's tests together raise a false alarm in about one
//! case of 4000; the seeds are fixed, so a case that passes goes on passing.

use crate::common::agree::*;
use crate::common::stages::*;
use capwalk_diff::WalkSettings;
use capwalk_scene::*;

fn shadow_case(name: &str, scene: Scene, expression: &str) {
    let tangent = tangent(&scene, expression);
    agree(name, scene, &tangent, Case::default());
}

/// Paths of two segments are what direct light is.
#[test]
fn path_of_depth_two() {
    let mut scene = with(triangle());
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(2),
        rr_depth: 5,
        hide_emitters: false,
    };
    shadow_case("path, depth 2", scene, "thing.translate.y");
}

/// Several steps, antithetic, over a wide angle: another field, the same
/// derivative.
#[test]
fn other_walks() {
    let scene = with(triangle());
    let tangent = tangent(&scene, "thing.translate.x");
    for (steps, max_radius, antithetic) in [(2, 0.6, false), (1, 0.05, true), (3, 3.0, true)] {
        let walk = WalkSettings {
            steps,
            max_radius,
            antithetic,
            ..Default::default()
        };
        let name = format!("M = {steps}, A_max = {max_radius}");
        agree(
            &name,
            scene.clone(),
            &tangent,
            Case {
                size: 32,
                gradient_spp: 150,
                reference_spp: 200,
                min_pixels: 500,
                patience: 2.0,
                walk,
                ..Case::default()
            },
        );
    }
}

fn builtin_case(scene: &str, expression: &str, case: Case) {
    let name = format!("{scene}, {expression}");
    let mut scene = builtin::scene(scene).expect("a built-in scene");
    scene.film.crop_offset = [0, 0];
    let tangent = tangent(&scene, expression);
    agree(&name, scene, &tangent, case);
}

#[test]
fn lattice_shadow() {
    // Its tubes are thin: a step of their size would blur their shadows.
    let case = Case {
        step: 1e-2,
        gradient_spp: 470,
        reference_spp: 1536,
        ..Case::default()
    };
    let expression = "lattice.translate.x + 0.7*lattice.translate.z";
    builtin_case("lattice-shadow", expression, case);
}

/// Correlated samples: their errors come from batches.
#[test]
fn sobol_points() {
    let mut scene = with(triangle());
    scene.settings.sampler = SamplerKind::Sobol;
    let case = Case {
        gradient_spp: 144,
        reference_spp: 160,
        ..Case::default()
    };
    let tangent = tangent(&scene, "thing.translate.x");
    agree("sobol", scene, &tangent, case);
}
