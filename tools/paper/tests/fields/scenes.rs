//! Fields on triangles in folders of `tests/scenes` that are quiet enough for them, against the finite
//! differences that these ask for.

use capwalk_diff::{PreparedScene, RenderOptions, Unwatched, finite_difference};
use capwalk_paper::fields::ON_TRIANGLES;

use crate::common::agree::tangent;
use crate::folder::{Demand, Folder};
use crate::methods::{chosen, meets};

/// Every derivative of a folder.
fn agree(name: &str) {
    let folder = Folder::new(name);
    let scene = folder.scene();
    for check in folder.checks() {
        let Demand::Agree(asked) = check.demand else {
            panic!("{name} is refused");
        };
        let moves = tangent(&scene, &check.parameter);
        let differences = finite_difference(
            &PreparedScene::new(scene.clone()),
            &moves,
            asked.step,
            &RenderOptions::new(asked.spp, 2),
            &Unwatched,
        );
        let differences = differences.expect("covered").gradient;
        let options = chosen(ON_TRIANGLES, &scene, &moves);
        let title = format!("{name}, {}, triangles", check.parameter);
        meets(&title, options, &scene, &moves, &differences);
    }
}

#[test]
fn camera_moves_with_shadows() {
    agree("camera_moves_with_shadows");
}

#[test]
fn environment_light_moving_occluder() {
    agree("environment_light_moving_occluder");
}

#[test]
fn mask_silhouette() {
    agree("mask_silhouette");
}

#[test]
fn textured_plane_moves() {
    agree("textured_plane_moves");
}
