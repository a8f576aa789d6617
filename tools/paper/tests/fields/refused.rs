//! What these fields refuse because they have no boundaries there, and what they cannot be made of.

use crate::common::agree::tangent;
use crate::common::refused::{checkered_floor, mirror_floor, refusals_with};
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{GradientOptions, PreparedScene, RenderOptions, Unwatched, gradient};
use capwalk_paper::fields::{AMONG_EXPLICIT_BOUNDARIES, ON_TRIANGLES, WasSettings, was};
use capwalk_scene::primitive::icosphere;
use capwalk_scene::*;

/// Fields on triangles have no images, flat or not; who is told so is told what has.
#[test]
fn an_emitter_that_moves_in_a_flat_mirror() {
    let mut scene = mirror_floor();
    scene.shape_mut(ShapeId(0)).normals = ShadingNormals::Face;
    for name in ["lamp.translate.x", "sensor.translate.x", "floor.rotate.x"] {
        let tangent = tangent(&scene, name);
        for reason in refusals_with(&scene, &tangent, ON_TRIANGLES) {
            let reason = reason.expect("refused");
            assert!(reason.contains("on the sphere"), "{name}: {reason}");
        }
    }
}

/// Explicit walks are for small scenes.
#[test]
fn too_many_edges_for_explicit_walks() {
    let mut scene = visible_cube();
    let method = AMONG_EXPLICIT_BOUNDARIES;
    let translation = tangent(&scene, "thing.translate.x");
    scene.film.crop_size = [2, 2];
    let reasons = refusals_with(&scene, &translation, method);
    assert_eq!(reasons, [None, None]);
    add(&mut scene, "ball", icosphere(12), ShadingNormals::Face, 0.5);
    let translation = tangent(&scene, "thing.translate.x");
    for reason in refusals_with(&scene, &translation, method) {
        let reason = reason.expect("refused");
        assert!(
            reason.contains("edges, and walks among explicit"),
            "{reason}"
        );
        assert!(reason.contains("on triangles"), "{reason}");
    }
}

/// Warped-area sampling has no rays around a point where all of them are parallel.
#[test]
fn warped_areas_under_parallel_rays() {
    let mut scene = visible_cube();
    scene.sensor.model = SensorModel::Orthographic;
    let settings = GradientOptions {
        method: was(WasSettings::default()),
        ..exact::settings(2)
    };
    let moves = tangent(&scene, "thing.translate.x");
    let refusal = gradient(
        &PreparedScene::new(scene.clone()),
        &moves,
        &settings,
        &Unwatched,
    )
    .expect_err("refused");
    assert!(refusal.to_string().contains("orthographic"), "{refusal}");
}

/// None of these fields knows the lines where textures are discontinuous.
#[test]
fn motion_beside_discontinuous_textures() {
    let scene = checkered_floor(4.0);
    let moves = tangent(&scene, "lamp.translate.x");
    for (method, why) in [
        (was(WasSettings::default()), "`was`"),
        (ON_TRIANGLES, "the default method"),
    ] {
        for reason in refusals_with(&scene, &moves, method) {
            let reason = reason.expect("refused");
            assert!(reason.contains(why), "{method:?}: {reason}");
        }
    }
}

/// No auxiliary rays make a field, nor do those that are spread by no number.
#[test]
fn warps_without_rays() {
    let scene = mirror_floor();
    let moves = tangent(&scene, "lamp.translate.x");
    let prepared = PreparedScene::new(scene);
    for (rays, kappa) in [(0, 1e5), (8, 0.0), (8, f64::NAN)] {
        let method = was(WasSettings {
            rays,
            kappa,
            ..WasSettings::default()
        });
        let options = GradientOptions {
            method,
            ..GradientOptions::new(RenderOptions::new(2, 1))
        };
        let refusal = gradient(&prepared, &moves, &options, &Unwatched).expect_err("refused");
        let expected = format!("warped-area sampling with {rays} auxiliary rays");
        assert!(refusal.to_string().starts_with(&expected), "{refusal}");
    }
}
