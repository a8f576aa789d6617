//! Rooms and skies in which radiance can be written down, wherever things are.

use crate::common::agree::tangent;
use crate::common::exact::{equals, means, settings};
use crate::common::stages::placed;
use crate::common::*;
use capwalk_diff::{PreparedScene, Unwatched, Wanted, backward, gradient};
use capwalk_math::{Affine, Rgb};
use capwalk_scene::primitive::cube;
use capwalk_scene::*;

/// A closed box of edge 2 that shines inwards, with a turned block in it, seen
/// from inside: albedo and emission of both.
fn furnace(of_box: [f64; 2], of_block: [f64; 2]) -> Scene {
    let mut scene = empty(v(-0.7, -0.8, 0.6), v(0.2, 0.1, -0.1), 60.0, 12);
    scene.settings.integrator = Integrator::Path {
        max_depth: None,
        rr_depth: 4,
        hide_emitters: false,
    };
    let (mut mesh, _) = cube(Affine::IDENTITY);
    mesh.faces.iter_mut().for_each(|face| face.swap(1, 2));
    add(&mut scene, "box", mesh, ShadingNormals::Face, of_box[0]);
    light_up(&mut scene, of_box[1]);
    let (mesh, normals) = cube(Affine::scale(v(0.3, 0.25, 0.4)));
    let turn = Affine::translate(v(0.2, 0.1, -0.2)) * Affine::rotate(v(0.3, 0.8, 0.5), 0.7);
    add(
        &mut scene,
        "block",
        placed(mesh, turn),
        normals,
        of_block[0],
    );
    if of_block[1] > 0.0 {
        light_up(&mut scene, of_block[1]);
    }
    scene.check().expect("a valid scene");
    scene
}

/// Demands an image of 1 and a derivative of 0 along a motion of the block. `dark`
/// is the same with a block that is no part of the furnace: it shows how large
/// the parts are that must cancel.
fn nothing_moves(name: &str, scene: &Scene, dark: &Scene, expression: &str, spp: u32) {
    let run = |scene: &Scene, spp: u32| {
        scene.check().expect("a valid scene");
        let tangent = tangent(scene, expression);
        gradient(
            &PreparedScene::new(scene.clone()),
            &tangent,
            &settings(spp),
            &Unwatched,
        )
        .expect("covered")
    };
    let seen = run(dark, 64).gradient.mean.pixels;
    let size = seen.iter().map(|p| p.r.abs()).sum::<f64>() / seen.len() as f64;
    let still = run(scene, spp);
    for (mean, error) in means(&still.value) {
        equals(name, mean, error, 1.0, 0.01);
    }
    for (mean, error) in means(&still.gradient) {
        equals(&format!("{name}, moved"), mean, error, 0.0, 0.1 * size);
    }
}

/// Where every surface reflects the share `a` of light and emits `1 - a`,
/// radiance is 1 everywhere, wherever things are: what boundaries bring and what
/// shading brings cancel.
#[test]
fn nothing_moves_in_a_furnace() {
    let scene = furnace([0.4, 0.6], [0.3, 0.7]);
    let dark = furnace([0.4, 0.6], [0.3, 0.0]);
    let expression = "block.translate.x + 0.5*block.rotate.z";
    nothing_moves("furnace", &scene, &dark, expression, 400);
}

/// The same without walls: white blocks under a white sky.
#[test]
fn nothing_moves_under_a_white_sky() {
    let white_sky = |albedo: f64| {
        let mut scene = furnace([1.0, 0.0], [albedo, 0.0]);
        let low = scene.shape_mut(ShapeId(0));
        let (mesh, normals) = cube(Affine::scale(v(0.6, 0.5, 0.1)));
        low.mesh = placed(mesh, Affine::translate(v(0.2, 0.1, -0.8)));
        (low.normals, low.emitter) = (normals, None);
        let white = Texture::colour("sky.radiance", Rgb::splat(1.0));
        let radiance = scene.add_texture(white);
        let id = "sky".into();
        scene.emitters = vec![Emitter::Constant { id, radiance }];
        scene
    };
    let expression = "block.translate.z + 0.5*block.rotate.x";
    nothing_moves(
        "white sky",
        &white_sky(1.0),
        &white_sky(0.0),
        expression,
        800,
    );
}

/// With the same albedo `a` and emission `e` everywhere, `n` segments of a path see
/// `e (1 + a + ... + aⁿ⁻¹)`.
#[test]
fn albedo_in_a_furnace() {
    let (a, e) = (0.55_f64, 0.8);
    for depth in [Some(3), Some(6), None] {
        let mut scene = furnace([a, e], [a, e]);
        scene.settings.integrator = Integrator::Path {
            max_depth: depth,
            rr_depth: 4,
            hide_emitters: false,
        };
        let (light, derivative) = match depth {
            None => (e / (1.0 - a), e / (1.0 - a).powi(2)),
            Some(depth) => (0..depth as i32).fold((0.0, 0.0), |(light, derivative), k| {
                let term = f64::from(k) * a.powi(k - 1);
                (light + e * a.powi(k), derivative + e * term)
            }),
        };
        let tangent = tangent(
            &scene,
            "box.bsdf.reflectance.value + block.bsdf.reflectance.value",
        );
        let result = gradient(
            &PreparedScene::new(scene.clone()),
            &tangent,
            &settings(256),
            &Unwatched,
        )
        .expect("covered");
        for (mean, error) in means(&result.value) {
            equals(
                &format!("albedo, {depth:?}"),
                mean,
                error,
                light,
                0.01 * light,
            );
        }
        for (mean, error) in means(&result.gradient) {
            equals(
                &format!("albedo changed, {depth:?}"),
                mean,
                error,
                derivative,
                0.02 * derivative,
            );
        }
        // The mean of the red channel, in reverse mode.
        let adjoint = Image {
            width: 12,
            height: 12,
            pixels: vec![Rgb::new(1.0 / 144.0, 0.0, 0.0); 144],
        };
        let wanted = Wanted::by(&tangent);
        let reverse = backward(
            &PreparedScene::new(scene.clone()),
            &adjoint,
            &wanted,
            &settings(256),
            &Unwatched,
        );
        let (mean, error) = reverse.expect("covered").along(&tangent);
        equals(
            &format!("reverse, {depth:?}"),
            mean,
            error,
            derivative,
            0.02 * derivative,
        );
    }
}
