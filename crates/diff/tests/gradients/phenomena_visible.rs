//! Gradients against finite differences: what the camera sees of things that
//! move, and cameras that move, in built-in scenes and in corners of the code;
//! the phenomena themselves are in `tests/scenes`. What is demanded of each
//! case, and how often it raises a false alarm, is said in
//! `phenomena_shadows.rs`.

use crate::common::agree::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{
    Gathers, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, gradient,
};
use capwalk_math::{Affine, Vec3};
use capwalk_scene::primitive::icosphere;
use capwalk_scene::*;

fn primary_case(name: &str, scene: Scene, expression: &str) {
    let tangent = tangent(&scene, expression);
    agree(name, scene, &tangent, primary());
}

#[test]
fn turning_camera() {
    let case = Case {
        step: 2.5e-4,
        reference_spp: 1000,
        ..primary()
    };
    let scene = visible_cube();
    let tangent = tangent(&scene, "sensor.rotate.z");
    agree("camera turns", scene, &tangent, case);
}

/// The built-in scenes as users get them, but small.
#[test]
fn built_in_ball() {
    let scene = builtin::scene("ball").expect("a built-in scene");
    let tangent = tangent(&scene, "ball.translate.x");
    // Gathered edges leave no noise where nothing moves.
    let case = Case {
        min_pixels: 400,
        ..primary()
    };
    // Also with many points on the edges in a pixel.
    let many = Method::Edges(Gathers {
        camera_points: 16,
        ..Gathers::ALL
    });
    let methods = [(case.method, case.gradient_spp), (many, 24)];
    agree_by(&methods, "built-in ball", scene, &tangent, case);
}

/// At the silhouette of a smooth ball points on the surface move fast against the camera's rays. Film points that are drawn
/// beside it leave much less noise there, with many points on the silhouette itself.
#[test]
fn smooth_silhouettes_leave_little_noise() {
    let mut scene = builtin::scene("ball").expect("a built-in scene");
    (scene.film.size, scene.film.crop_size) = ([64, 48], [64, 48]);
    let tangent = tangent(&scene, "ball.translate.x");
    let prepared = PreparedScene::new(scene);
    let variance = |beside_silhouettes: bool| {
        let method = Method::Edges(Gathers {
            camera_points: 16,
            beside_silhouettes,
            ..Gathers::ALL
        });
        let options = GradientOptions {
            method,
            ..GradientOptions::new(RenderOptions::new(32, 5))
        };
        let result = gradient(&prepared, &tangent, &options, &Unwatched).expect("covered");
        let errors = result.gradient.standard_error.pixels;
        errors.iter().map(|error| error.dot(*error)).sum::<f64>()
    };
    let (with, without) = (variance(true), variance(false));
    assert!(with < 0.5 * without, "{with} {without}");
}

#[test]
fn built_in_leaf() {
    let scene = builtin::scene("leaf").expect("a built-in scene");
    let tangent = tangent(&scene, "leaf.translate.x");
    agree("built-in leaf", scene, &tangent, Case::default());
}

#[test]
fn box_room() {
    let scene = builtin::scene("box-room").expect("a built-in scene");
    primary_case("box-room", scene, "box.translate.x");
}

/// Smooth normals on faces that are wound the wrong way round: their horizon
/// bounds the light they reflect all the same.
#[test]
fn coarse_smooth_ball_inside_out() {
    let mut scene = visible_stage(v(1.2, -4.0, 1.9));
    let place = Affine::translate(v(0.0, 0.0, 0.55)) * Affine::scale(Vec3::splat(0.5));
    let mut ball = placed(icosphere(1), place);
    ball.faces.iter_mut().for_each(|face| face.swap(1, 2));
    let normals = ShadingNormals::computed(&ball);
    add(&mut scene, "ball", ball, normals, 0.6);
    let tangent = tangent(&scene, "ball.rotate.y");
    let case = Case {
        gradient_spp: 180,
        reference_spp: 1000,
        ..primary()
    };
    agree("coarse smooth ball, inside out", scene, &tangent, case);
}

/// The numbers of Russian roulette are nobody else's.
#[test]
fn early_roulette() {
    let mut scene = empty(v(0.3, -2.0, 1.0), v(0.0, 1.0, 0.0), 60.0, 36);
    add_floor(&mut scene, 8.0);
    add_emitter(&mut scene, v(0.0, 0.0, 4.0), 10.0, 0.3, 3.0);
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(2),
        rr_depth: 1,
        hide_emitters: false,
    };
    let tangent = tangent(&scene, "sensor.rotate.x");
    agree("early roulette", scene, &tangent, primary());
}
