//! Fields on triangles in folders of `tests/scenes` that are quiet enough for them, against their finite
//! differences.

use capwalk_paper::fields::ON_TRIANGLES;

use crate::folder::{Demand, Folder};
use crate::methods::{agrees, chosen};
use crate::reference::{reference, tangent};

/// Every derivative of a folder.
fn agree(name: &str) {
    let folder = Folder::new(name);
    let scene = folder.scene();
    for check in folder.checks() {
        let Demand::Agree(asked) = check.demand else {
            panic!("{name} is refused");
        };
        let moves = tangent(&folder, &scene, &check.parameter);
        let differences = reference(&folder, &check.parameter, &asked);
        let options = chosen(ON_TRIANGLES, &scene, &moves);
        let title = format!("{name}, {}, triangles", check.parameter);
        agrees(&title, options, &scene, &moves, &differences);
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
