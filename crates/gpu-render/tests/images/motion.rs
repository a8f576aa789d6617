//! The interior term of what moves beside the processor's, sample by sample.

use std::sync::Arc;

use capwalk_boundary::{Boundaries, Counts, Draw, Field, Method, Sampler};
use capwalk_diff::{Backward, Forward, GradientOptions, Wanted};
use capwalk_gpu::Precision;
use capwalk_gpu_render::{DeviceScene, unsupported};
use capwalk_math::{Rgb, Vec3};
use capwalk_render::{MotionFacts, PreparedScene, RenderOptions, Tracer, Unwatched};
use capwalk_scene::{Bsdf, Image, Scene, ShadingNormals, ShapeVectors, Tangent};

use crate::agreement::SMALL_EMITTERS;
use crate::beside::different;
use crate::derivatives::{adjoint, all_texels, numbers};
use crate::{device, scenes};

/// Samples differ if their derivatives do by more than this, relatively.
const DIFFERENT: f64 = 5e-4;

/// The share of samples that may.
const MOST_DIFFERENT: f64 = 0.01;

/// What forward and reverse mode may differ by, relatively: single precision.
const ROUNDING: f64 = 1e-5;

/// Scenes that can be compared.
const FEWEST_SCENES: usize = 80;

/// Every vertex moves on its own, given normals turn, and texels change.
fn everything(scene: &Scene) -> Tangent {
    let mut next = numbers(3);
    let mut vector = move || Vec3::new(next(), next(), next()) - Vec3::splat(0.5);
    let mut tangent = all_texels(scene);
    for (shape, vectors) in scene.shapes.iter().zip(&mut tangent.shapes) {
        let size = shape.mesh.bounds();
        let size = (size.1 - size.0).length();
        let vertices = shape.mesh.positions.iter().map(|_| vector() * (0.1 * size));
        let mut of_shape = ShapeVectors {
            vertices: vertices.collect(),
            normals: None,
        };
        if let ShadingNormals::Given(normals) = &shape.normals {
            let turned = normals.iter().map(|&n| vector().reject_from(n));
            of_shape.normals = Some(turned.collect());
        }
        *vectors = Some(of_shape);
    }
    tangent
}

/// The sensor moves and turns as well.
fn with_sensor(mut tangent: Tangent) -> Tangent {
    tangent.sensor.translation = Vec3::new(0.03, -0.02, 0.04);
    tangent.sensor.rotation = Vec3::new(-0.02, 0.04, 0.03);
    tangent
}

/// The processor's samples of the interior term, one of each pixel.
pub fn on_processor(
    prepared: &PreparedScene,
    tangent: &Tangent,
    options: &GradientOptions,
) -> Image {
    let scene = prepared.scene();
    let boundaries = Boundaries::none(prepared.accel());
    let field = Field::new(prepared.accel(), &boundaries, Method::EDGES);
    let eval = Forward::new(field, tangent);
    let facts = Arc::new(MotionFacts::of(scene));
    let tracer = Tracer::moving(prepared, field, options.walk, &facts);
    let sampler = Sampler::new(&scene.settings, options.seed, 1);
    let [width, height] = scene.film.crop_size;
    let sample = |pixel: u32| {
        let (stream, counts) = (sampler.stream(u64::from(pixel), 0), Counts::default());
        let draw = Draw {
            stream: &stream,
            counts: &counts,
        };
        let light: Rgb<_> = tracer.pixel(&eval, [pixel % width, pixel / width], draw);
        light.tangent(0)
    };
    Image {
        width: width as usize,
        height: height as usize,
        pixels: (0..width * height).map(sample).collect(),
    }
}

/// In all scenes that the device can render but those with mirrors, where the processor walks.
#[test]
fn interior_terms_are_the_processors() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut compared = 0;
    for (name, mut scene) in scenes::all() {
        let is_mirror = |bsdf: &Bsdf| matches!(bsdf, Bsdf::Conductor(_) | Bsdf::Plastic(_));
        let has_mirrors = scene
            .materials
            .iter()
            .any(|material| is_mirror(&material.bsdf));
        if SMALL_EMITTERS.contains(&&*name) || has_mirrors {
            continue;
        }
        if scene.film.crop_size[0] > 40 {
            scene.film.resize([40, 30]);
        }
        let prepared = PreparedScene::new(scene);
        if unsupported(&prepared).is_some() || prepared.accel().view.is_parallel() {
            continue;
        }
        let tangent = with_sensor(everything(prepared.scene()));
        let options = GradientOptions::new(RenderOptions::new(1, 7));
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let ours = on_device.interior_term(&tangent, &options, &Unwatched);
        let ours = ours.expect("supported").gradient.mean;
        let theirs = on_processor(&prepared, &tangent, &options);
        let (count, all) = different(&ours, &theirs, DIFFERENT);
        assert!(
            count as f64 <= MOST_DIFFERENT * all as f64,
            "{name}: {count} of {all} samples differ"
        );
        compared += 1;
    }
    assert!(compared >= FEWEST_SCENES, "{compared} scenes");
}

/// In all scenes that the device can render, also by way of mirrors.
#[test]
fn interior_terms_are_the_same_in_both_modes() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut compared = 0;
    for (name, mut scene) in scenes::all() {
        if scene.film.crop_size[0] > 20 {
            scene.film.resize([20, 15]);
        }
        let prepared = PreparedScene::new(scene);
        if unsupported(&prepared).is_some() {
            continue;
        }
        let scene = prepared.scene();
        let (tangent, adjoint) = (with_sensor(everything(scene)), adjoint(scene));
        let options = GradientOptions::new(RenderOptions::new(1, 7));
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let forward = on_device.interior_term(&tangent, &options, &Unwatched);
        let forward = forward.expect("supported").gradient.mean;
        let wanted = Wanted::by(&tangent);
        let reverse = on_device.interior_term_back(&adjoint, &wanted, &options, &Unwatched);
        let reverse = reverse.expect("supported");
        assert_same(&name, &adjoint, &forward, &reverse, &tangent);
        compared += 1;
    }
    assert!(compared >= FEWEST_SCENES, "{compared} scenes");
}

/// Scenes whose whole derivative is looked at: what moves against what, between which surfaces and
/// lights.
const WHOLE: [&str; 5] = [
    "parity/anisotropic.xml",
    "parity/cube_sky.xml",
    "parity/lamps_seen.xml",
    "parity/textured_lamp.xml",
    "scenes/self_shadowing_right_angle/scene.xml",
];

/// In forward mode with all boundary terms, by z-test of the mean of all pixels and of each; and in
/// reverse mode from the same samples, but for rounding.
#[test]
fn derivatives_are_the_processors_in_both_modes() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    for name in WHOLE {
        let mut scene = scenes::scene(name);
        scene.film.resize([8, 6]);
        let prepared = PreparedScene::new(scene);
        let scene = prepared.scene();
        let (tangent, adjoint) = (with_sensor(everything(scene)), adjoint(scene));
        let options = |spp| GradientOptions {
            blind: true,
            method: Method::EDGES,
            ..GradientOptions::new(RenderOptions::new(spp, 7))
        };
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let ours = on_device.gradient(&tangent, &options(32), &Unwatched);
        let ours = ours.expect("supported").gradient;
        let theirs = GradientOptions {
            seed: 8,
            blind: false,
            ..options(128)
        };
        let theirs = capwalk_diff::gradient(&prepared, &tangent, &theirs, &Unwatched);
        let theirs = theirs.expect("not refused").gradient;
        let (mut difference, mut variance, mut worst) = (0.0, 0.0, 0.0_f64);
        for i in 0..ours.mean.pixels.len() {
            let [a, b] = [&ours, &theirs].map(|e| {
                let pixels = [&e.mean, &e.standard_error].map(|image| image.pixels[i]);
                pixels.map(Rgb::mean)
            });
            difference += a[0] - b[0];
            variance += a[1] * a[1] + b[1] * b[1];
            if a[1].hypot(b[1]) > 0.0 {
                worst = worst.max(((a[0] - b[0]) / a[1].hypot(b[1])).abs());
            }
        }
        let z = difference / variance.sqrt();
        assert!(z.abs() < 4.0 && worst < 7.0, "{name}: {z}, {worst}");

        let reverse = on_device.backward(&adjoint, &Wanted::by(&tangent), &options(32), &Unwatched);
        let reverse = reverse.expect("supported");
        assert_same(name, &adjoint, &ours.mean, &reverse, &tangent);
    }
}

/// More scenes for both modes: discontinuous textures, emitters of many edges, maps, cuts, glossy surfaces,
/// cameras with a lens and filters that overlap.
const IN_BOTH_MODES: [&str; 14] = [
    "parity/bitmap_ball.xml",
    "parity/checkerboard.xml",
    "parity/coarse_normals.xml",
    "parity/colour_bleeding.xml",
    "parity/cylinder.xml",
    "parity/environment_map.xml",
    "parity/mitchell.xml",
    "parity/roughplastic.xml",
    "parity/thinlens.xml",
    "scenes/glossy_floor_reflects_a_moving_ball/scene.xml",
    "scenes/interpenetrating_meshes/scene.xml",
    "scenes/lamp_cut_by_a_blade/scene.xml",
    "scenes/seam_of_tangents/scene.xml",
    "scenes/textured_emitter_moves/scene.xml",
];

/// With all boundary terms, from the same samples, but for rounding.
#[test]
fn derivatives_are_the_same_in_both_modes() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    for name in IN_BOTH_MODES {
        let mut scene = scenes::scene(name);
        scene.film.resize([20, 15]);
        let prepared = PreparedScene::new(scene);
        let scene = prepared.scene();
        let (tangent, adjoint) = (with_sensor(everything(scene)), adjoint(scene));
        let options = GradientOptions {
            blind: true,
            method: Method::EDGES,
            ..GradientOptions::new(RenderOptions::new(1, 7))
        };
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let forward = on_device.gradient(&tangent, &options, &Unwatched);
        let forward = forward.expect("supported").gradient.mean;
        let reverse = on_device.backward(&adjoint, &Wanted::by(&tangent), &options, &Unwatched);
        let reverse = reverse.expect("supported");
        assert_same(name, &adjoint, &forward, &reverse, &tangent);
    }
}

/// A derivative of pixels and a gradient lead to the same derivative of the loss.
fn assert_same(name: &str, adjoint: &Image, forward: &Image, reverse: &Backward, along: &Tangent) {
    let by_pixels = adjoint.pixels.iter().zip(&forward.pixels);
    let by_pixels: Vec<f64> = by_pixels.map(|(&a, &b)| 3.0 * (a * b).mean()).collect();
    let size: f64 = by_pixels.iter().map(|x| x.abs()).sum();
    let by_pixels: f64 = by_pixels.iter().sum();
    let by_numbers = reverse.gradient().dot(along);
    assert!(
        (by_pixels - by_numbers).abs() <= ROUNDING * size,
        "{name}: {by_pixels} and {by_numbers}"
    );
    assert_eq!(reverse.statistics.non_finite, 0, "{name}");
}

/// As long as the work goes on, and in parts of any size.
#[test]
fn gradients_in_parts_of_any_size_have_the_same_bits() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/cube_sky.xml");
    scene.film.resize([8, 6]);
    let prepared = PreparedScene::new(scene);
    let scene = prepared.scene();
    let adjoint = adjoint(scene);
    let wanted = Wanted::by(&with_sensor(everything(scene)));
    let options = GradientOptions::new(RenderOptions::new(6, 7));
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let gradient = |most| {
        let found = on_device.backward_in_parts(&adjoint, &wanted, &options, most, &Unwatched);
        let found = found.expect("supported");
        (found.gradient().clone(), found.standard_error())
    };
    let whole = gradient(1 << 16);
    for most in [13, 71, 100] {
        assert!(gradient(most) == whole, "{most}");
    }
}
