//! Hard shadows that move in curved mirrors are found and refused, also on faces that do not move; in
//! flat mirrors they are not.

use crate::common::agree::tangent;
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{
    GradientOptions, PreparedScene, RenderOptions, Unwatched, Wanted, backward, gradient,
};
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::icosphere;
use capwalk_scene::*;

/// True if both modes refuse, by name.
fn is_refused(scene: &Scene, name: &str) -> bool {
    let prepared = PreparedScene::new(scene.clone());
    let tangent = tangent(scene, name);
    let options = GradientOptions::new(RenderOptions::new(16, 1));
    let forward = gradient(&prepared, &tangent, &options, &Unwatched);
    let [width, height] = scene.film.crop_size.map(|n| n as usize);
    let mut adjoint = Image::new(width, height);
    adjoint.pixels.fill(Rgb::splat(1.0));
    let wanted = Wanted::by(&tangent);
    let reverse = backward(&prepared, &adjoint, &wanted, &options, &Unwatched);
    let reasons = [forward.err(), reverse.err()].map(|reason| {
        reason.is_some_and(|reason| reason.to_string().contains("edges of hard shadows"))
    });
    assert_eq!(reasons[0], reasons[1], "{name}: only one mode refuses");
    reasons[0]
}

/// A light moves, and its hard shadow on a floor that does not move, which a smooth ball reflects.
fn shadow_before_a_ball() -> Scene {
    let mut scene = empty(v(0.5, -4.0, 1.5), v(0.0, 0.5, 0.5), 20.0, 12);
    add_floor(&mut scene, 3.0);
    let blade = placed(triangle(), Affine::translate(v(0.0, -0.4, 0.5)));
    add(&mut scene, "thing", blade, ShadingNormals::Face, 0.5);
    let place = Affine::translate(v(0.0, 0.7, 0.5)) * Affine::scale(Vec3::splat(0.4));
    let ball = placed(icosphere(3), place);
    let normals = ShadingNormals::computed(&ball);
    add(&mut scene, "ball", ball, normals, 0.5);
    make(&mut scene, "ball", |n| n.mirror());
    let intensity = scene.add_texture(Texture::colour("bulb.intensity", Rgb::splat(5.0)));
    scene.emitters.push(Emitter::Point {
        id: "bulb".into(),
        position: v(-0.3, -0.6, 3.0),
        intensity,
    });
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 5,
        hide_emitters: false,
    };
    scene
}

/// The floor that the ball reflects does not move, and nothing moves that is seen there but shadows.
#[test]
fn a_hard_shadow_that_moves_in_a_curved_mirror() {
    let mut scene = shadow_before_a_ball();
    assert!(is_refused(&scene, "bulb.translate.x"));
    assert!(!is_refused(&scene, "bulb.intensity.value"));
    assert!(!is_refused(&scene, "thing.bsdf.reflectance.value"));
    // Flat mirrors show how shadows move.
    let ball = scene.shapes.iter().position(|shape| shape.id == "ball");
    scene
        .shape_mut(ShapeId(ball.expect("a ball") as u32))
        .normals = ShadingNormals::Face;
    assert!(!is_refused(&scene, "bulb.translate.x"));
}

/// Which shadows move follows a scene that changes.
#[test]
fn a_hard_shadow_that_comes_to_move_in_a_curved_mirror() {
    let scene = shadow_before_a_ball();
    // Below the floor the light throws no shadow that is seen.
    let mut before = scene.clone();
    let Some(Emitter::Point { position, .. }) = before.emitters.first_mut() else {
        panic!("a point light");
    };
    *position = v(0.0, 0.0, -3.0);
    let mut prepared = PreparedScene::new(before);
    let motion = tangent(&scene, "bulb.translate.x");
    let settings = GradientOptions::new(RenderOptions::new(4, 1));
    let is_refused = |prepared: &PreparedScene| {
        let result = gradient(prepared, &motion, &settings, &Unwatched);
        result.is_err()
    };
    assert!(!is_refused(&prepared));
    prepared.update(scene);
    assert!(is_refused(&prepared));
}
