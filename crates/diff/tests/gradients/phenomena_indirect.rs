//! Gradients against finite differences: light that comes from other surfaces
//! (Algorithm 1 on every segment of a path), in built-in scenes and where paths
//! carry nothing; the phenomena themselves are in `tests/scenes`.

use crate::common::agree::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::Method;
use capwalk_math::{Affine, Rgb};
use capwalk_scene::primitive::{cube, rectangle};
use capwalk_scene::*;

/// Paths of at most this many segments.
fn deep(mut scene: Scene, max_depth: Option<u32>) -> Scene {
    scene.settings.integrator = Integrator::Path {
        max_depth,
        rr_depth: 3,
        hide_emitters: false,
    };
    scene
}

/// A floor that the camera looks at, lit by nothing but a ceiling, which an emitter
/// below it shines at.
fn bounced_light() -> Scene {
    let mut scene = empty(v(0.3, -0.4, 6.0), v(0.0, 0.0, 0.0), 22.0, 36);
    scene.sensor.near_clip = 5.6;
    add_floor(&mut scene, 3.0);
    let ceiling = Affine::translate(v(0.0, 0.0, 2.0))
        * Affine::rotate(v(1.0, 0.0, 0.0), std::f64::consts::PI)
        * Affine::scale(v(0.6, 0.6, 1.0));
    let (mesh, normals) = rectangle(ceiling);
    add(&mut scene, "ceiling", mesh, normals, 0.8);
    // It emits upwards only.
    let up = Affine::translate(v(1.6, 0.0, 1.2)) * Affine::scale(v(0.5, 0.5, 1.0));
    let (mesh, normals) = rectangle(up);
    add(&mut scene, "lamp", mesh, normals, 0.0);
    light_up(&mut scene, 40.0);
    let low = placed(triangle(), Affine::translate(v(0.0, 0.0, -0.5)));
    add(&mut scene, "thing", low, ShadingNormals::Face, 0.5);
    deep(scene, Some(3))
}

/// Silhouettes in the image may only move by a small part of a pixel, or the
/// differences smear them over pixel borders.
fn visible_case(spp: u32) -> Case {
    Case {
        step: 2e-3,
        gradient_spp: spp,
        reference_spp: 4 * spp,
        ..Case::default()
    }
}

/// A smooth ball, any number of reflections, roulette.
#[test]
fn unlimited_depth() {
    let scene = deep(visible_ball(Filter::Gaussian { stddev: 0.5 }), None);
    let tangent = tangent(&scene, "ball.translate.x");
    agree("unlimited depth", scene, &tangent, visible_case(100));
}

/// The room of the paper's figure 9 with light that is reflected several times.
#[test]
fn box_in_a_room() {
    let scene = deep(builtin::scene("box-room").expect("built in"), Some(4));
    let parameter = builtin::default_parameter("box-room").expect("built in");
    let tangent = tangent(&scene, parameter);
    let case = Case {
        patience: 5.0,
        gradient_spp: 60,
        ..visible_case(180)
    };
    agree("box room, indirect", scene, &tangent, case);
}

/// What reflects light ends, turns edges to the floor that are no silhouettes, and cuts through
/// something else: edges before surfaces are sampled.
#[test]
fn edges_of_reflectors() {
    let mut scene = bounced_light();
    let place = Affine::translate(v(0.25, -0.1, 1.95))
        * Affine::rotate(v(0.3, 0.2, 1.0), 0.5)
        * Affine::scale(v(0.25, 0.2, 0.15));
    let (mesh, normals) = cube(place);
    add(&mut scene, "block", mesh, normals, 0.3);
    let expression = "block.translate.x + block.rotate.y + ceiling.translate.z + thing.translate.y";
    let tangent = tangent(&scene, expression);
    let case = Case {
        method: Method::EDGES,
        step: 1e-2,
        gradient_spp: 400,
        reference_spp: 4000,
        min_pixels: 400,
        patience: 2.0,
        ..Case::default()
    };
    agree("edges of reflectors", scene, &tangent, case);
}

/// A box that hangs from a ceiling of two tiles moves, and an edge of it lies on their joint,
/// which does not move: all of the discontinuity there is the box's.
#[test]
fn box_on_a_joint() {
    let mut scene = bounced_light();
    let tile = |x: f64| {
        let place = Affine::translate(v(x, 0.0, 2.0))
            * Affine::rotate(v(1.0, 0.0, 0.0), std::f64::consts::PI)
            * Affine::scale(v(0.3, 0.6, 1.0));
        rectangle(place).0
    };
    for shape in scene.shapes_mut().filter(|shape| shape.id == "ceiling") {
        shape.mesh = tile(-0.3);
    }
    add(&mut scene, "tile", tile(0.3), ShadingNormals::Face, 0.8);
    let place = Affine::translate(v(-0.15, 0.0, 1.85)) * Affine::scale(v(0.15, 0.4, 0.15));
    let (mesh, normals) = cube(place);
    add(&mut scene, "box", mesh, normals, 0.1);
    let tangent = tangent(&scene, "box.translate.x");
    let case = Case {
        method: Method::EDGES,
        step: 1e-2,
        gradient_spp: 200,
        reference_spp: 2000,
        min_pixels: 400,
        ..Case::default()
    };
    agree("box on a joint", scene, &tangent, case);
}

/// The camera moves past things that light each other.
#[test]
fn moving_camera() {
    let scene = deep(visible_cube(), Some(3));
    let tangent = tangent(&scene, "sensor.translate.x + 0.3*sensor.rotate.z");
    let case = Case {
        patience: 4.0,
        gradient_spp: 80,
        ..visible_case(380)
    };
    agree("moving camera, indirect", scene, &tangent, case);
}

/// A black surface: paths that carry no light carry derivatives.
#[test]
fn black_reflector() {
    let mut scene = bounced_light();
    for id in 0..scene.textures.len() {
        if scene.textures[id].id.starts_with("ceiling") {
            scene.texture_mut(TextureId(id as u32)).data.fill(0.0);
        }
    }
    let change = tangent(&scene, "ceiling.bsdf.reflectance.value");
    let settings = capwalk_diff::GradientOptions::new(capwalk_diff::RenderOptions::new(256, 1));
    let nobody = &capwalk_diff::Unwatched;
    let ours = capwalk_diff::gradient(
        &capwalk_diff::PreparedScene::new(scene.clone()),
        &change,
        &settings,
        nobody,
    )
    .expect("covered");
    // Linear in the reflectance of a surface that is met once.
    let lit = capwalk_diff::render(
        &capwalk_diff::PreparedScene::new(scene.moved(&change, 1.0)),
        &settings.sampling(),
        nobody,
    );
    let sum = |estimate: &capwalk_diff::Estimate| -> Rgb {
        let pixels = estimate.mean.pixels.iter();
        pixels.fold(Rgb::zero(), |sum, &p| sum + p)
    };
    let (ours, expected) = (sum(&ours.gradient).r, sum(&lit.value).r);
    assert!(expected > 1.0);
    assert!((ours / expected - 1.0).abs() < 0.05, "{ours} {expected}");
}
