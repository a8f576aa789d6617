//! Gradients against finite differences: edges as surfaces see them in flat mirrors and through
//! panes. What is demanded of each case is said in `phenomena_shadows.rs`.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::common::agree::*;
use crate::common::materials::*;
use crate::common::*;
use capwalk_diff::Method;
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::primitive::{cube, rectangle};
use capwalk_scene::*;

/// A floor that the camera looks at, lit by nothing but what a ceiling sends back of an emitter that
/// shines at it; a block is over the emitter. Paths of at most this many segments.
fn lit_by_a_ceiling(segments: u32) -> Scene {
    let mut scene = empty(v(0.3, -0.4, 6.0), v(0.0, 0.0, 0.0), 22.0, 24);
    scene.sensor.near_clip = 5.6;
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(segments),
        rr_depth: 100,
        hide_emitters: false,
    };
    add_floor(&mut scene, 3.0);
    let turned = Affine::rotate(v(1.0, 0.0, 0.0), PI);
    let ceiling = Affine::translate(v(0.3, 0.0, 2.0)) * turned * Affine::scale(v(2.0, 1.5, 1.0));
    add(
        &mut scene,
        "ceiling",
        rectangle(ceiling).0,
        ShadingNormals::Face,
        0.8,
    );
    // It emits upwards only.
    let up = Affine::translate(v(1.5, 0.0, 1.2)) * Affine::scale(v(0.9, 0.9, 1.0));
    add(
        &mut scene,
        "lamp",
        rectangle(up).0,
        ShadingNormals::Face,
        0.0,
    );
    light_up(&mut scene, 10.0);
    add(
        &mut scene,
        "block",
        block(v(1.45, 0.1, 1.6)),
        ShadingNormals::Face,
        0.3,
    );
    scene
}

fn block(place: Vec3) -> Mesh {
    let turned = Affine::rotate(v(0.3, 0.2, 1.0), 0.5);
    cube(Affine::translate(place) * turned * Affine::scale(v(0.4, 0.35, 0.1))).0
}

/// With these samples of the derivative and of the differences.
fn agrees(name: &str, scene: Scene, expression: &str, spp: [u32; 2]) {
    agrees_over(4e-2, name, scene, expression, spp);
}

/// The same with differences over another step.
fn agrees_over(
    step: f64,
    name: &str,
    scene: Scene,
    expression: &str,
    [spp, reference_spp]: [u32; 2],
) {
    let tangent = tangent(&scene, expression);
    let case = Case {
        step,
        size: 14,
        reference_spp,
        min_pixels: 150,
        patience: 8.0,
        ..Case::default()
    };
    agree_by(&[(Method::EDGES, spp)], name, scene, &tangent, case);
}

/// The ceiling is a mirror that turns, and shows the floor the block and the emitter, which move.
#[test]
fn block_and_emitter_in_a_mirror() {
    let mut scene = lit_by_a_ceiling(3);
    make(&mut scene, "ceiling", |n| n.mirror());
    let expression =
        "block.translate.x + 0.5*lamp.translate.y - 0.4*ceiling.rotate.y + 0.3*floor.rotate.x";
    agrees("in a mirror", scene, expression, [480, 6000]);
}

/// Of two mirrors in one plane, that one turns that does not stand for the plane.
#[test]
fn one_of_two_mirrors_in_a_plane() {
    let mut scene = lit_by_a_ceiling(3);
    let turned = Affine::rotate(v(1.0, 0.0, 0.0), PI);
    let half = |x| {
        let place = Affine::translate(v(x, 0.0, 2.0)) * turned * Affine::scale(v(0.97, 1.5, 1.0));
        rectangle(place).0
    };
    let mut shapes = scene.shapes_mut();
    shapes
        .find(|shape| shape.id == "ceiling")
        .expect("it is there")
        .mesh = half(-0.7);
    drop(shapes);
    add(&mut scene, "second", half(1.3), ShadingNormals::Face, 0.8);
    for id in ["ceiling", "second"] {
        make(&mut scene, id, |n| n.mirror());
    }
    agrees_over(
        1e-2,
        "one of two mirrors",
        scene,
        "second.rotate.y",
        [300, 6000],
    );
}

/// Two emitters lie where a pane shows each the other, so that their edges are seen in the same
/// directions.
#[test]
fn emitters_on_either_side_of_a_pane() {
    let mut scene = lit_by_a_ceiling(3);
    scene.shapes.retain(|shape| shape.id == "floor");
    scene.emitters.clear();
    scene.sensor.near_clip = 0.01;
    let camera = Affine::look_at(v(0.3, -3.0, 4.0), Vec3::zero(), v(0.0, 0.0, 1.0));
    scene.sensor.world_from_camera = camera.expect("upright");
    let upright =
        |x, turn| Affine::translate(v(x, 0.0, 1.5)) * Affine::rotate(v(0.0, 1.0, 0.0), turn);
    let pane = upright(0.0, FRAC_PI_2) * Affine::scale(v(1.3, 1.5, 1.0));
    add(
        &mut scene,
        "pane",
        rectangle(pane).0,
        ShadingNormals::Face,
        0.8,
    );
    make(&mut scene, "pane", |n| {
        let int_ior = n.number("ior", 2.5);
        let mut pane = n.pane();
        pane.eta.int_ior = int_ior;
        pane
    });
    for (id, x, radiance) in [("first", 2.0, 10.0), ("second", -2.0, 3.0)] {
        let place = upright(x, -FRAC_PI_2 * x.signum()) * Affine::scale(v(0.5, 0.5, 1.0));
        add(
            &mut scene,
            id,
            rectangle(place).0,
            ShadingNormals::Face,
            0.0,
        );
        light_up(&mut scene, radiance);
    }
    agrees(
        "emitters beside a pane",
        scene,
        "floor.rotate.y",
        [1000, 4000],
    );
}

/// The same by way of two mirrors, one after the other.
#[test]
fn block_in_two_mirrors() {
    let mut scene = lit_by_a_ceiling(4);
    make(&mut scene, "ceiling", |n| n.mirror());
    let upright = Affine::rotate(v(0.0, 1.0, 0.0), FRAC_PI_2);
    let wall = Affine::translate(v(-1.5, 0.0, 0.9)) * upright * Affine::scale(v(0.8, 1.5, 1.0));
    add(
        &mut scene,
        "wall",
        rectangle(wall).0,
        ShadingNormals::Face,
        0.8,
    );
    make(&mut scene, "wall", |n| n.mirror());
    let expression = "block.translate.x + 0.5*wall.rotate.y";
    agrees("in two mirrors", scene, expression, [2000, 12000]);
}

/// The ceiling is white, and the floor sees it and the block before it through a pane.
#[test]
fn block_behind_a_pane() {
    let mut scene = lit_by_a_ceiling(4);
    scene
        .shapes_mut()
        .filter(|shape| shape.id == "block")
        .for_each(|shape| {
            shape.mesh = block(v(-0.3, 0.1, 1.0));
        });
    let pane = Affine::translate(v(0.1, 0.0, 0.8)) * Affine::scale(v(1.3, 1.3, 1.0));
    add(
        &mut scene,
        "pane",
        rectangle(pane).0,
        ShadingNormals::Face,
        0.8,
    );
    make(&mut scene, "pane", |n| n.pane());
    let expression = "block.translate.x + 0.5*block.rotate.z + 0.3*pane.translate.x";
    agrees("behind a pane", scene, expression, [160, 3200]);
}
