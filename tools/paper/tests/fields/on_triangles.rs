//! Gradients against finite differences: fields on triangles instead of on the
//! sphere (`domain = triangle`, METHOD 1), for every kind of segment.
//!
//! Where a silhouette runs over the border of a triangle the field is singular
//! and noisy. So most of these scenes have few triangles, and shadows that stay
//! inside one: errors of a fourth are seen.

use crate::common::agree::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{
    GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, WalkSettings, gradient,
};
use capwalk_geometry::Mesh;
use capwalk_math::Rgb;
use capwalk_paper::fields::{AMONG_EXPLICIT_BOUNDARIES, ON_TRIANGLES};
use capwalk_scene::*;

/// A floor below an emitter of one large triangle, before which silhouettes pass.
fn under_a_triangle(thing: Mesh) -> Scene {
    let mut scene = empty(v(0.3, -0.4, 6.0), v(0.0, 0.0, 0.0), 12.0, 40);
    scene.sensor.near_clip = 5.6;
    add_floor(&mut scene, 3.0);
    let emitter = Mesh {
        positions: vec![v(2.2, -1.2, 1.9), v(-2.2, -1.3, 2.0), v(0.1, 2.4, 1.85)],
        faces: vec![[0, 1, 2]],
    };
    add(&mut scene, "lamp", emitter, ShadingNormals::Face, 0.0);
    light_up(&mut scene, 3.0);
    add(&mut scene, "thing", thing, ShadingNormals::Face, 0.5);
    scene
}

fn on_triangles(name: &str, scene: Scene, expression: &str, case: Case) {
    with_method(ON_TRIANGLES, name, scene, expression, case);
}

fn with_method(method: Method, name: &str, scene: Scene, expression: &str, case: Case) {
    let tangent = tangent(&scene, expression);
    agree(name, scene, &tangent, Case { method, ..case });
}

fn few_pixels() -> Case {
    Case {
        size: 14,
        gradient_spp: 2500,
        reference_spp: 2500,
        min_pixels: 120,
        patience: 10.0,
        ..Case::default()
    }
}

/// A shadow alone, by one step and by two.
#[test]
fn silhouettes_inside_one_triangle() {
    for steps in [1, 2] {
        let walk = WalkSettings {
            steps,
            ..WalkSettings::default()
        };
        let case = Case {
            walk,
            ..few_pixels()
        };
        let scene = under_a_triangle(triangle());
        on_triangles(&format!("M = {steps}"), scene, "thing.translate.x", case);
    }
}

/// Occluder, receiver and emitter move at once.
#[test]
fn everything_moves_under_one_triangle() {
    let scene = under_a_triangle(triangle());
    let expression = "2*thing.translate.x + 0.2*floor.rotate.y + 0.2*lamp.rotate.z";
    on_triangles("everything", scene, expression, few_pixels());
}

/// The shadow's border crosses the emitter's border and its diagonal.
#[test]
fn silhouettes_cross_borders() {
    let case = Case {
        gradient_spp: 10_000,
        reference_spp: 5000,
        patience: 20.0,
        ..few_pixels()
    };
    let scene = with(small_ball());
    on_triangles("crossing", scene, "thing.translate.x", case);
}

/// Silhouettes in the image, and their interiors.
#[test]
fn image_of_a_moving_thing() {
    let case = Case {
        step: 2e-3,
        gradient_spp: 5000,
        ..few_pixels()
    };
    let scene = visible_cube();
    let expression = "thing.translate.x + 0.5*thing.rotate.z";
    on_triangles("image", scene, expression, case);
}

/// Light from everywhere, past the borders of all triangles, and from other surfaces.
#[test]
fn indirect_light_of_an_environment() {
    let mut scene = visible_cube();
    scene.shapes.retain(|shape| shape.emitter.is_none());
    let radiance = scene.add_texture(Texture::colour("sky.radiance", Rgb::new(0.5, 0.7, 1.0)));
    scene.emitters = vec![Emitter::Constant {
        id: "sky".into(),
        radiance,
    }];
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 5,
        hide_emitters: false,
    };
    let case = Case {
        step: 2e-3,
        ..few_pixels()
    };
    on_triangles("environment", scene, "thing.translate.x", case);
}

/// Another field, on disks among all projected silhouettes, has the same derivative.
#[test]
fn walks_among_explicit_boundaries() {
    let (scene, case) = (under_a_triangle(triangle()), few_pixels());
    with_method(
        AMONG_EXPLICIT_BOUNDARIES,
        "explicit",
        scene,
        "thing.translate.x",
        case,
    );
}

/// Both agree with each other and with differences: light and silhouettes together, from
/// the camera and from surfaces.
#[test]
fn explicit_and_practical_walks_agree() {
    let mut scene = visible_cube();
    scene.film.size = [10; 2];
    scene.film.crop_size = [10; 2];
    let tangent = tangent(&scene, "thing.rotate.z + 0.3*sensor.translate.x");
    let [practical, explicit] =
        [(ON_TRIANGLES, 1), (AMONG_EXPLICIT_BOUNDARIES, 2)].map(|(method, seed)| {
            let options = RenderOptions::new(1500, seed);
            let options = GradientOptions {
                method,
                ..GradientOptions::new(options)
            };
            gradient(
                &PreparedScene::new(scene.clone()),
                &tangent,
                &options,
                &Unwatched,
            )
            .expect("covered")
            .gradient
        });
    let result = compare(&practical, &explicit);
    println!(
        "scale factor {} ± {}",
        result.scale_factor, result.scale_factor_error
    );
    assert!(result.pixels > 60, "{result:?}");
    // Rare samples are large, and the error of the mean knows it.
    let beyond = (result.mean_z_squared - 1.0).abs() - 0.4;
    assert!(beyond < 2.0 * result.mean_z_squared_error, "{result:?}");
    assert!(result.sign.abs() < 4.0, "{result:?}");
    assert!(
        !matches!(result.verdict, Verdict::Wrong { .. }),
        "{result:?}"
    );
}
