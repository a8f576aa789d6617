//! The interior term of what moves beside the CPU's, sample by sample.

use std::sync::Arc;

use capwalk_boundary::{Boundaries, Counts, Draw, Field, Gathers, Method, Sampler};
use capwalk_diff::{Backward, Forward, GradientOptions, Wanted};
use capwalk_gpu::Precision;
use capwalk_gpu_render::{DeviceError, DeviceScene, unsupported, unsupported_derivative};
use capwalk_math::{Rgb, Vec3};
use capwalk_render::{Estimate, MotionFacts, PreparedScene, RenderOptions, Tracer, Unwatched};
use capwalk_scene::lobe::Lobe;
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
pub fn everything(scene: &Scene) -> Tangent {
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
pub fn with_sensor(mut tangent: Tangent) -> Tangent {
    tangent.sensor.translation = Vec3::new(0.03, -0.02, 0.04);
    tangent.sensor.rotation = Vec3::new(-0.02, 0.04, 0.03);
    tangent
}

/// The CPU's samples of the interior term, one of each pixel.
pub fn on_cpu(prepared: &PreparedScene, tangent: &Tangent, options: &GradientOptions) -> Image {
    let boundaries = Boundaries::none(prepared.accel());
    let method = Method::Edges(Gathers {
        half_vector: false,
        ..Gathers::ALL
    });
    let options = GradientOptions { method, ..*options };
    samples_among(&boundaries, prepared, tangent, &options)
}

/// The same of the derivative, where these are the boundaries.
pub fn samples_among(
    boundaries: &Boundaries,
    prepared: &PreparedScene,
    tangent: &Tangent,
    options: &GradientOptions,
) -> Image {
    let scene = prepared.scene();
    let field = Field::new(prepared.accel(), boundaries, options.method);
    let eval = Forward::new(field, tangent);
    let facts = Arc::new(MotionFacts::of(scene, true));
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

/// In all scenes that the device can render but those with mirrors, where the CPU walks.
#[test]
fn interior_terms_are_those_of_the_cpu() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut compared = 0;
    for (name, mut scene) in scenes::all() {
        let is_mirror =
            |bsdf: &Bsdf| matches!(bsdf, Bsdf::Plain(Lobe::Conductor(_) | Lobe::Plastic(_)));
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
        let theirs = on_cpu(&prepared, &tangent, &options);
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

/// Pixels of the images whose whole derivative is looked at; samples of each, and how many times as many the
/// CPU takes.
const SMALL: [u32; 2] = [8, 6];
const SAMPLES: u32 = 2;
const MORE_SAMPLES: u32 = 16;

/// The largest standard score of the mean of an image: one in 15,000 is larger by chance.
const MOST_OFF: f64 = 4.0;

/// Scenes whose whole derivative can be compared.
const FEWEST_WHOLE: usize = 69;

/// Scenes of `tests/parity` beside all of `tests/scenes`: discontinuous textures, emitters of many edges,
/// maps, glossy surfaces, cameras with a lens and filters that overlap.
const MORE_SCENES: [&str; 14] = [
    "parity/anisotropic.xml",
    "parity/bitmap_ball.xml",
    "parity/checkerboard.xml",
    "parity/coarse_normals.xml",
    "parity/colour_bleeding.xml",
    "parity/cube_sky.xml",
    "parity/cylinder.xml",
    "parity/environment_map.xml",
    "parity/emitters_seen.xml",
    "parity/metal_smooth.xml",
    "parity/mitchell.xml",
    "parity/roughplastic.xml",
    "parity/textured_emitter.xml",
    "parity/thinlens.xml",
];

/// In every folder that the device can render and whose derivative neither it nor the CPU refuses:
/// everything moves, with all boundary terms. In forward mode by z-test of the mean of all pixels, and in
/// reverse mode from the same samples, but for rounding.
#[test]
fn derivatives_are_those_of_the_cpu_in_both_modes() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let (mut compared, mut wrong) = (0, Vec::new());
    for (name, mut scene) in scenes::all() {
        if !name.starts_with("scenes/") && !MORE_SCENES.contains(&&*name) {
            continue;
        }
        scene.film.resize(SMALL);
        let prepared = PreparedScene::new(scene);
        let scene = prepared.scene();
        let (tangent, adjoint) = (with_sensor(everything(scene)), adjoint(scene));
        let wanted = Wanted::by(&tangent);
        let options = |spp| GradientOptions {
            blind: true,
            method: Method::EDGES,
            ..GradientOptions::new(RenderOptions::new(spp, 7))
        };
        let ours = options(SAMPLES);
        if unsupported(&prepared).is_some()
            || unsupported_derivative(&prepared, &wanted, &ours).is_some()
        {
            continue;
        }
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let forward = match on_device.gradient(&tangent, &ours, &Unwatched) {
            Ok(image) => image.gradient,
            Err(DeviceError::Refused(_) | DeviceError::Unsupported(_)) => continue,
            Err(error) => panic!("{name}: {error}"),
        };
        let reverse = on_device.backward(&adjoint, &wanted, &ours, &Unwatched);
        let reverse = reverse.expect("as in forward mode");
        let theirs = GradientOptions {
            seed: 8,
            blind: false,
            ..options(MORE_SAMPLES * SAMPLES)
        };
        let theirs = capwalk_diff::gradient(&prepared, &tangent, &theirs, &Unwatched);
        let theirs = theirs.expect("not refused on the device").gradient;
        let score = score_of_mean(&forward, &theirs);
        if score.abs() >= MOST_OFF || score.is_nan() {
            wrong.push(format!("{name}: {score:.1} standard errors off"));
        }
        assert_same(&name, &adjoint, &forward.mean, &reverse, &tangent);
        compared += 1;
    }
    assert_eq!(wrong, [""; 0]);
    assert!(compared >= FEWEST_WHOLE, "{compared} scenes");
}

/// How far the means of two images are apart, in standard errors of their difference.
fn score_of_mean(ours: &Estimate, theirs: &Estimate) -> f64 {
    let sum = |image: &Image| image.pixels.iter().map(|pixel| pixel.mean()).sum::<f64>();
    // Channels go up and down together.
    let squares = |image: &Image| image.pixels.iter().map(|x| x.mean().powi(2)).sum::<f64>();
    let variance = squares(&ours.standard_error) + squares(&theirs.standard_error);
    let difference = sum(&ours.mean) - sum(&theirs.mean);
    match difference == 0.0 {
        true => 0.0,
        false => difference / variance.sqrt(),
    }
}

/// A derivative of pixels and a gradient lead to the same derivative of the loss.
pub fn assert_same(
    name: &str,
    adjoint: &Image,
    forward: &Image,
    reverse: &Backward,
    along: &Tangent,
) {
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
