//! Reverse mode against forward mode: the same linear map, METHOD 5.
//!
//! With the same random numbers, `⟨δ, J θ̇⟩ = ⟨Jᵀ δ, θ̇⟩` up to rounding, for a
//! motion of everything at once. Forward mode agrees with finite differences in the
//! other tests.

use crate::common::agree::tangent;
use crate::common::both_modes::*;
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{
    Backward, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, Wanted, backward,
    gradient, with_threads,
};
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::lobe::Distribution;
use capwalk_scene::primitive::{cube, rectangle};
use capwalk_scene::*;

fn reverse(scene: &Scene, wanted: &Wanted, spp: u32) -> Backward {
    let adjoint = adjoint(scene, 3);
    let result = backward(
        &PreparedScene::new(scene.clone()),
        &adjoint,
        wanted,
        &settings(spp),
        &Unwatched,
    );
    result.expect("covered")
}

/// `⟨δ, J θ̇⟩` in forward mode.
fn forward(scene: &Scene, tangent: &Tangent, spp: u32) -> f64 {
    forward_by(&PreparedScene::new(scene.clone()), tangent, &settings(spp)).0
}

fn agree_in_both_modes(name: &str, mut scene: Scene, depth: u32) {
    small(&mut scene, depth);
    let tangent = everything(&scene, 11);
    agree_along(name, &PreparedScene::new(scene), &tangent);
}

fn agree_along(name: &str, prepared: &PreparedScene, tangent: &Tangent) {
    for method in [Method::Walk, Method::EDGES] {
        let settings = GradientOptions {
            method,
            ..settings(6)
        };
        agree_by(&format!("{name}, {method:?}"), prepared, tangent, &settings);
    }
}

/// Smooth computed normals, a Gaussian filter, shadows.
#[test]
fn smooth_ball() {
    let scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    agree_in_both_modes("ball, direct", scene.clone(), 2);
    agree_in_both_modes("ball, indirect", scene, 4);
}

/// Normals given with the mesh, a box filter with its pixel-border term.
#[test]
fn given_normals() {
    let mut scene = visible_ball(Filter::Box);
    for shape in scene.shapes_mut() {
        if let ShadingNormals::Computed(normals) = shape.normals.clone() {
            shape.normals = ShadingNormals::Given(normals);
        }
    }
    agree_in_both_modes("given normals", scene, 3);
}

/// The motion of a parameter.
fn named(prepared: &PreparedScene, name: &str) -> Tangent {
    let scene = prepared.scene();
    params::Registry::new(scene)
        .tangent(scene, name)
        .expect(name)
}

/// Rays that start on a lens, filters that end abruptly or not.
#[test]
fn thin_lens() {
    for filter in [Filter::Box, Filter::Tent { radius: 1.0 }] {
        let mut scene = through_lens(visible_ball(filter), 0.2, 3.0);
        agree_in_both_modes("thin lens", scene.clone(), 3);
        small(&mut scene, 2);
        let prepared = PreparedScene::new(scene);
        // What is not wanted is constant in both modes.
        for name in [
            "sensor.translate.x",
            "sensor.x_fov",
            "sensor.aperture_radius",
            "sensor.focus_distance",
        ] {
            agree_along(name, &prepared, &named(&prepared, name));
        }
    }
}

/// Parallel rays: everything moves, and single numbers of the sensor.
#[test]
fn parallel_rays() {
    for filter in [Filter::Box, Filter::Tent { radius: 1.0 }] {
        let mut scene = with_parallel_rays(visible_ball(filter), 0.85);
        agree_in_both_modes("parallel rays", scene.clone(), 3);
        small(&mut scene, 2);
        let prepared = PreparedScene::new(scene);
        let gathered = GradientOptions {
            method: Method::EDGES,
            ..settings(6)
        };
        let tangent = everything(prepared.scene(), 11);
        agree_by("parallel rays, edges", &prepared, &tangent, &gathered);
        for name in [
            "ball.translate.x",
            "sensor.translate.y - sensor.translate.x",
            "sensor.rotate.x",
            "sensor.to_world[0,2] - 0.4*sensor.to_world[1,1]",
        ] {
            agree_along(name, &prepared, &named(&prepared, name));
        }
    }
}

/// Two cubes that pass through each other.
#[test]
fn crossing_surfaces() {
    let mut scene = visible_cube();
    let (mesh, normals) = cube(capwalk_math::Affine::scale(v(0.8, 0.2, 0.7)));
    add(&mut scene, "blade", mesh, normals, 0.4);
    agree_in_both_modes("crossing", scene, 3);
}

/// An environment, and no emitter.
#[test]
fn constant_light() {
    let mut scene = visible_cube();
    scene.shapes.pop_if(|shape| shape.emitter.is_some());
    let colour = Texture::colour("sky.radiance", Rgb::new(0.5, 0.7, 1.0));
    let radiance = scene.add_texture(colour);
    scene.emitters.push(Emitter::Constant {
        id: "sky".into(),
        radiance,
    });
    agree_in_both_modes("constant light", scene, 4);
}

/// Materials of microfacets, blended and coated; glass where there was none.
#[test]
fn rough_materials() {
    let mut scene = visible_cube();
    make(&mut scene, "floor", |n| {
        let metal = rough_metal(n.copper(), n.facets(Distribution::Ggx, 0.3));
        let metal = n.part("metal", metal);
        Bsdf::Blend {
            weight: n.number("weight", 0.0),
            nested: [n.diffuse("paint", [0.8, 0.2, 0.1]), metal],
        }
    });
    make(&mut scene, "thing", |n| n.principled(0.0));
    add_balls(&mut scene, ["glass", "plastic"]);
    make(&mut scene, "glass", |n| {
        rough_glass(n.glass(), n.facets(Distribution::Beckmann, 0.2))
    });
    make(&mut scene, "plastic", |n| {
        rough_plastic(n.coat(true), Distribution::Ggx, n.number("alpha", 0.2))
    });
    agree_in_both_modes("rough materials", scene, 4);
}

/// A sheet that is lit from behind, and the plastic of polarized light.
#[test]
fn sheets() {
    let mut scene = visible_cube();
    add_balls(&mut scene, ["plastic", "sheet"]);
    make(&mut scene, "plastic", |n| {
        polarized_plastic(n.coat(false), n.facets(Distribution::Ggx, 0.2))
    });
    make(&mut scene, "sheet", |n| n.principled_thin());
    agree_in_both_modes("sheets", scene, 4);
}

/// Maps of normals and bumps, one of them blended.
#[test]
fn maps_of_normals() {
    let mut scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    unit_square(&mut scene, "floor");
    make(&mut scene, "floor", |n| {
        let nested = n.glossy();
        let bumps = n.bump_map(0.3, nested);
        Bsdf::Blend {
            weight: n.number("part", 0.3),
            nested: [n.part("bumps", bumps), n.diffuse("dust", [0.5; 3])],
        }
    });
    make(&mut scene, "ball", |n| {
        let nested = n.glossy();
        n.normal_map(nested)
    });
    let ball = scene.shapes_mut().find(|shape| shape.id == "ball");
    ball.expect("a ball").uvs = Some(primitive::sphere_uvs());
    agree_in_both_modes("maps of normals", scene, 4);
}

/// Adds a ball on either side of the thing.
fn add_balls(scene: &mut Scene, names: [&str; 2]) {
    for (name, x) in names.into_iter().zip([-0.8, 0.9]) {
        let ball = placed(small_ball(), Affine::translate(v(x, -0.4, -0.5)));
        add(scene, name, ball, ShadingNormals::Face, 0.5);
    }
}

/// Mirrors, panes and masks: their numbers change, nothing moves.
#[test]
fn numbers_of_specular_materials() {
    let mut scene = visible_cube();
    make(&mut scene, "floor", |n| n.coat(false));
    make(&mut scene, "thing", |n| n.pane());
    add_balls(&mut scene, ["metal", "leaf"]);
    make(&mut scene, "metal", |n| n.copper());
    make(&mut scene, "leaf", |n| Bsdf::Mask {
        opacity: n.number("opacity", 1.0),
        nested: n.diffuse("green", [0.2, 0.7, 0.1]),
    });
    small(&mut scene, 5);
    let mut tangent = Tangent::zero(&scene);
    tangent.textures = everything(&scene, 11).textures;
    agree_along("specular materials", &PreparedScene::new(scene), &tangent);
}

/// Flat mirrors across each other and a pane, everything moving.
#[test]
fn mirrors() {
    let mut scene = visible_cube();
    for (id, turn) in [("left", 1.3), ("right", -1.4), ("pane", 1.1)] {
        let turn = Affine::rotate(v(0.1, 1.0, 0.2), turn);
        let (mesh, normals) =
            rectangle(Affine::translate(v(0.5 * turn.rows[0].z, 0.6, 0.5)) * turn);
        add(&mut scene, id, mesh, normals, 0.5);
    }
    for id in ["left", "right"] {
        make(&mut scene, id, |n| n.copper());
    }
    make(&mut scene, "pane", |n| n.pane());
    make(&mut scene, "floor", |n| n.coat(true));
    agree_in_both_modes("mirrors", scene, 5);
}

/// Gradients of single parameters are entries of the gradient of all, and
/// what is not wanted is not there.
#[test]
fn single_parameters() {
    let mut scene = visible_cube();
    scene.film.size = [12; 2];
    scene.film.crop_size = [12; 2];
    for name in ["thing.translate.x", "lamp.rotate.y", "sensor.translate.z"] {
        let tangent = tangent(&scene, name);
        let wanted = Wanted::by(&tangent);
        let forward = forward(&scene, &tangent, 16);
        let result = reverse(&scene, &wanted, 16);
        let (reverse, error) = result.along(&tangent);
        assert!(
            (forward - reverse).abs() <= 1e-10 * forward.abs(),
            "{name}: {forward} {reverse}"
        );
        assert!(
            error > 0.0 && forward.abs() > 1e-6,
            "{name}: {forward} ± {error}"
        );
        let present = result
            .gradient()
            .shapes
            .iter()
            .map(Option::is_some)
            .collect::<Vec<_>>();
        assert_eq!(present, wanted.shapes, "{name}");
    }
}

/// The number of threads changes no bit, also where there are more of them than batches.
#[test]
fn threads_change_nothing() {
    let mut scene = visible_cube();
    scene.film.size = [8; 2];
    scene.film.crop_size = [8; 2];
    let wanted = Wanted::all(&scene);
    for spp in [1, 2, 20] {
        let gradient = || reverse(&scene, &wanted, spp).gradient().clone();
        let [one, three] = [1, 3].map(|threads| with_threads(threads, gradient));
        assert_eq!(one, three, "{spp}");
    }
}

/// Standard errors are those of independent repetitions (a ratio of variances
/// of 40 and 40 · 15 degrees of freedom leaves the band once in 10⁴).
#[test]
fn standard_errors_are_right() {
    let mut scene = visible_cube();
    scene.film.size = [8; 2];
    scene.film.crop_size = [8; 2];
    let tangent = tangent(&scene, "thing.translate.x + 0.3*lamp.translate.y");
    let (wanted, adjoint) = (Wanted::by(&tangent), adjoint(&scene, 3));
    let (mut spread, mut stated) = (capwalk_math::Moments::default(), 0.0);
    for seed in 0..40 {
        let mut settings = settings(32);
        settings.seed = seed;
        let result = backward(
            &PreparedScene::new(scene.clone()),
            &adjoint,
            &wanted,
            &settings,
            &Unwatched,
        )
        .expect("covered");
        let (value, error) = result.along(&tangent);
        spread.add(value);
        stated += error * error / 40.0;
        // The errors of all numbers, in the form of the gradient.
        assert!(result.standard_error() != result.gradient().scaled(0.0));
    }
    let ratio = stated / spread.variance();
    assert!((0.45..2.6).contains(&ratio), "{ratio}");
}

/// Normals given with a mesh can be asked for without its vertices: the same
/// numbers as in the gradient of all, and no curve moves for them.
#[test]
fn normals_alone() {
    let mut scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    scene.film.size = [12; 2];
    scene.film.crop_size = [12; 2];
    for shape in scene.shapes_mut() {
        if let ShadingNormals::Computed(normals) = shape.normals.clone() {
            shape.normals = ShadingNormals::Given(normals);
        }
    }
    let ball = scene.shapes.iter().position(|s| s.id == "ball");
    let ball = ball.expect("a ball");
    let mut turning = everything(&scene, 11);
    turning.textures.fill(None);
    turning.sensor = SensorVectors::default();
    for (i, shape) in turning.shapes.iter_mut().enumerate() {
        match shape {
            Some(shape) if i == ball => shape.vertices.fill(Vec3::zero()),
            _ => *shape = None,
        }
    }
    let wanted = Wanted::by(&turning);
    assert!(!wanted.geometry() && wanted.normals[ball]);
    let alone = reverse(&scene, &wanted, 16);
    let forward = forward(&scene, &turning, 16);
    let (along, _) = alone.along(&turning);
    assert!((along - forward).abs() <= 1e-10 * forward.abs() && forward.abs() > 1e-6);
    assert_eq!(alone.statistics.cone_queries, 0);
    let shape = alone.gradient().shapes[ball].clone().expect("wanted");
    assert!(shape.vertices.iter().all(|&v| v == Vec3::zero()));
}

/// Numbers and errors of a linear map are those of the gradient itself.
#[test]
fn numbers_of_the_gradient() {
    let mut scene = visible_cube();
    scene.film.size = [8; 2];
    scene.film.crop_size = [8; 2];
    let result = reverse(&scene, &Wanted::all(&scene), 32);
    let flat = |gradient: &Gradient| {
        let shapes = gradient.shapes.iter().flatten();
        shapes
            .flat_map(|shape| shape.vertices.iter().flat_map(|v| v.to_array()))
            .collect::<Vec<f64>>()
    };
    let (numbers, errors) = result.numbers(flat);
    assert_eq!(numbers, flat(result.gradient()));
    let expected = flat(&result.standard_error());
    assert!(errors.iter().any(|&e| e > 0.0));
    for (a, b) in errors.iter().zip(&expected) {
        assert!((a - b).abs() <= 1e-9 * b, "{a} {b}");
    }
}

/// An adjoint that is not a number somewhere is refused with the place.
#[test]
fn adjoint_with_nan() {
    let scene = visible_cube();
    let mut bad = adjoint(&scene, 3);
    bad.pixels[2 * 36 + 7].g = f64::NAN;
    let wanted = Wanted::all(&scene);
    let refusal = backward(
        &PreparedScene::new(scene.clone()),
        &bad,
        &wanted,
        &settings(2),
        &Unwatched,
    );
    let reason = refusal.expect_err("refused").to_string();
    assert!(
        reason.contains("NaN") && reason.contains("column 7, row 2"),
        "{reason}"
    );
}

/// An adjoint of the wrong size is refused with both sizes.
#[test]
fn adjoint_of_another_size() {
    let scene = visible_cube();
    let small = Image {
        width: 2,
        height: 1,
        pixels: vec![Rgb::zero(); 2],
    };
    let wanted = Wanted::all(&scene);
    let refusal = backward(
        &PreparedScene::new(scene.clone()),
        &small,
        &wanted,
        &settings(2),
        &Unwatched,
    );
    let reason = refusal.expect_err("refused").to_string();
    assert!(
        reason.contains("2 x 1") && reason.contains("36 x 36"),
        "{reason}"
    );
}

/// A box whose edge lies on the seam of two tiles slides over them. The tiles' edges rest:
/// they have no share of the discontinuity there, in either mode.
#[test]
fn edges_that_rest_have_no_share() {
    let mut scene = visible_stage(v(2.2, -3.5, 1.9));
    let tile =
        |x: f64| rectangle(Affine::translate(v(x, 0.0, 0.0)) * Affine::scale(v(2.0, 2.0, 1.0)));
    for shape in scene.shapes_mut().filter(|shape| shape.id == "floor") {
        shape.mesh = tile(-2.0).0;
    }
    add(&mut scene, "tile", tile(2.0).0, ShadingNormals::Face, 0.6);
    let (mesh, normals) =
        cube(Affine::translate(v(-0.4, 0.0, 0.4)) * Affine::scale(Vec3::splat(0.4)));
    add(&mut scene, "thing", mesh, normals, 0.1);
    scene.check().expect("a valid scene");
    let tangent = tangent(&scene, "thing.translate.x");
    let prepared = PreparedScene::new(scene);
    let options = GradientOptions {
        method: Method::EDGES,
        ..GradientOptions::new(RenderOptions::new(256, 5))
    };
    let forward = gradient(&prepared, &tangent, &options, &Unwatched).expect("covered");
    let mut ones = adjoint(prepared.scene(), 3);
    ones.pixels.fill(Rgb::splat(1.0));
    let wanted = Wanted::by(&tangent);
    let reverse = backward(&prepared, &ones, &wanted, &options, &Unwatched).expect("covered");
    let (value, error) = reverse.along(&tangent);
    let sum = |image: &Image, f: fn(f64) -> f64| -> f64 {
        let numbers = image.pixels.iter().flat_map(|pixel| pixel.to_array());
        numbers.map(f).sum()
    };
    let expected = sum(&forward.gradient.mean, |x| x);
    // Channels of a pixel share their noise.
    let noise = (3.0 * sum(&forward.gradient.standard_error, |x| x * x)).sqrt();
    println!("forward {expected} ± {noise}, reverse {value} ± {error}");
    assert!((value - expected).abs() < 4.0 * error.hypot(noise));
    assert!(expected.abs() > 10.0 * error.hypot(noise), "nothing to see");
}
