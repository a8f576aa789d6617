//! Gradients against finite differences, one scene per phenomenon: what the
//! camera sees of things and lamps that move, and cameras that move.
//!
//! In every case `check::compare` must say right: an error of a tenth would
//! have been seen. Besides, the mean of z² must lie in [0.8, 1.25] over at
//! least 1000 pixels, which are independent of each other, and their signs must
//! cancel. The comparison's tests together raise a false alarm in about one
//! case of 4000; the seeds are fixed, so a case that passes goes on passing.

mod common;

use capwalk_math::{Affine, Vec3};
use capwalk_render::{GradientOptions, Options, Unwatched, WalkSettings, gradient};
use capwalk_scene::primitive::icosphere;
use capwalk_scene::*;
use common::agree::*;
use common::stages::*;
use common::*;

/// The silhouette of a visible thing crosses pixels: short steps, so that the
/// difference does not run over whole pixels.
fn primary() -> Case {
    Case {
        size: 46,
        step: 4e-3,
        gradient_spp: 320,
        reference_spp: 960,
        ..Case::default()
    }
}

fn primary_case(name: &str, scene: Scene, expression: &str) {
    let motion = motion(&scene, expression);
    agree(name, scene, &motion, primary());
}

#[test]
fn ball_with_box_filter() {
    primary_case("ball, box", visible_ball(Filter::Box), "ball.translate.x");
}

#[test]
fn ball_with_tent_filter() {
    let scene = visible_ball(Filter::Tent { radius: 1.0 });
    primary_case("ball, tent", scene, "ball.translate.x");
}

#[test]
fn ball_with_gaussian_filter() {
    let scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    primary_case("ball, gaussian", scene, "ball.translate.x");
}

/// The film samples beyond its border: no filter is cut off.
#[test]
fn ball_with_sampled_border() {
    let mut scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    scene.film.sample_border = true;
    primary_case("ball, border sampled", scene, "ball.translate.z");
}

#[test]
fn moving_camera() {
    let scene = visible_cube();
    let motion = motion(&scene, "sensor.translate.x");
    let case = Case {
        step: 1e-3,
        reference_spp: 2000,
        ..primary()
    };
    agree("camera moves", scene, &motion, case);
}

#[test]
fn turning_camera() {
    let case = Case {
        step: 2.5e-4,
        reference_spp: 2000,
        ..primary()
    };
    let scene = visible_cube();
    let motion = motion(&scene, "sensor.rotate.z");
    agree("camera turns", scene, &motion, case);
}

#[test]
fn turning_camera_with_tent_filter() {
    let case = Case {
        step: 2.5e-4,
        reference_spp: 2000,
        ..primary()
    };
    let mut scene = visible_cube();
    scene.film.filter = Filter::Tent { radius: 1.0 };
    let motion = motion(&scene, "sensor.rotate.y+sensor.translate.z");
    agree("camera turns, tent", scene, &motion, case);
}

/// A lamp in the picture moves, and with it the light it casts.
#[test]
fn visible_lamp_moves() {
    let mut scene = visible_cube();
    *fov_x(&mut scene) = 50.0_f64.to_radians();
    let turned = Affine::translate(v(-0.2, 0.4, 1.3)) * Affine::rotate(v(1.0, 0.2, 0.0), 1.9);
    let (mesh, normals) =
        capwalk_scene::primitive::rectangle(turned * Affine::scale(v(0.4, 0.3, 1.0)));
    add(&mut scene, "screen", mesh, normals, 0.3);
    light_up(&mut scene, 3.0);
    let motion = motion(&scene, "screen.translate.x");
    // The faint light of the screen changes in rare samples only; a smooth
    // filter allows a step that finds them.
    scene.film.filter = Filter::Tent { radius: 1.0 };
    let case = Case {
        step: 6e-3,
        reference_spp: 2400,
        ..primary()
    };
    agree("visible lamp", scene, &motion, case);
}

/// Nothing moves but colours.
#[test]
fn radiance_and_reflectance() {
    let scene = visible_cube();
    let lamp = motion(&scene, "lamp.emitter.radiance.value");
    agree("radiance", scene.clone(), &lamp, primary());
    let floor = motion(&scene, "floor.bsdf.reflectance.value");
    // Only the floor's pixels have noise.
    agree("reflectance", scene, &floor, primary());
}

/// The built-in scenes as users get them, but small.
#[test]
fn built_in_ball() {
    let scene = builtin::scene("ball").expect("a built-in scene");
    primary_case("built-in ball", scene, "ball.translate.x");
}

#[test]
fn built_in_leaf() {
    let scene = builtin::scene("leaf").expect("a built-in scene");
    let motion = motion(&scene, "leaf.translate.x");
    agree("built-in leaf", scene, &motion, Case::default());
}

#[test]
fn box_room() {
    let scene = builtin::scene("box-room").expect("a built-in scene");
    primary_case("box-room", scene, "box.translate.x");
}

/// Surfaces that pass through each other: the camera sees a jump where no mesh
/// has an edge, and both sides of it move.
#[test]
fn interpenetrating_shapes() {
    let mut scene = visible_cube();
    scene.shapes[2].mesh = placed(
        scene.shapes[2].mesh.clone(),
        Affine::translate(v(0.0, 0.0, -0.35)),
    );
    let ball = placed(
        icosphere(3),
        Affine::translate(v(0.3, -0.25, 0.25)) * Affine::scale(Vec3::splat(0.3)),
    );
    add(&mut scene, "ball", ball, ShadingNormals::Face, 0.9);
    primary_case(
        "interpenetrating",
        scene,
        "thing.translate.z+ball.translate.x",
    );
}

/// What lies before the near plane is not seen, and hides nothing.
#[test]
fn screen_before_the_near_plane() {
    let mut scene = visible_cube();
    let towards = v(1.2, -4.0, 1.9) - v(0.0, 0.05, 0.4);
    let facing = Affine::look_at(v(0.9, -3.0, 1.525), v(1.2, -4.0, 1.9), v(0.0, 0.0, 1.0));
    let (mesh, normals) = capwalk_scene::primitive::rectangle(facing.expect("not up"));
    add(&mut scene, "screen", mesh, normals, 0.5);
    scene.sensor.near_clip = 0.4 * towards.length();
    primary_case("near plane", scene, "thing.translate.x");
}

/// Smooth normals: the horizon of each face bounds the light it reflects, on
/// whichever side of its winding the eye is.
#[test]
fn rotating_coarse_smooth_ball() {
    for inside_out in [false, true] {
        let mut scene = visible_stage(v(1.2, -4.0, 1.9));
        let place = Affine::translate(v(0.0, 0.0, 0.55)) * Affine::scale(Vec3::splat(0.5));
        let mut ball = placed(icosphere(1), place);
        if inside_out {
            ball.faces.iter_mut().for_each(|face| face.swap(1, 2));
        }
        let normals = ShadingNormals::computed(&ball);
        add(&mut scene, "ball", ball, normals, 0.6);
        let name = format!("coarse smooth ball, inside out: {inside_out}");
        let motion = motion(&scene, "ball.rotate.y");
        let case = Case {
            gradient_spp: 600,
            reference_spp: 1600,
            ..primary()
        };
        agree(&name, scene, &motion, case);
    }
}

/// The numbers of Russian roulette are nobody else's.
#[test]
fn early_roulette() {
    let mut scene = empty(v(0.3, -2.0, 1.0), v(0.0, 1.0, 0.0), 60.0, 36);
    add_floor(&mut scene, 8.0);
    add_lamp(&mut scene, v(0.0, 0.0, 4.0), 10.0, 0.3, 3.0);
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(2),
        rr_depth: 1,
        hide_emitters: false,
    };
    let motion = motion(&scene, "sensor.rotate.x");
    agree("early roulette", scene, &motion, primary());
}

/// A surface cut by a clip plane in view is refused, by name.
#[test]
fn clipped_surfaces_are_refused() {
    let mut scene = visible_cube();
    scene.sensor.near_clip = 4.2;
    let motion = motion(&scene, "thing.translate.x");
    let settings = GradientOptions {
        options: Options {
            spp: 2,
            seed: 1,
            threads: None,
        },
        walk: WalkSettings::default(),
    };
    let refusal = gradient(&scene, &motion, &settings, &Unwatched).expect_err("clipped");
    assert!(refusal.reason.contains("near_clip of 4.2"), "{refusal}");
}
