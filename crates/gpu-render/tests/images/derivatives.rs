//! Derivatives with respect to texels: forward mode beside the CPU's sample by sample, reverse mode beside the
//! CPU's and beside forward mode.

use std::sync::Arc;

use capwalk_diff::{GradientOptions, Wanted};
use capwalk_gpu::Precision;
use capwalk_gpu_render::{DeviceError, DeviceScene, unsupported};
use capwalk_math::Rgb;
use capwalk_render::{Estimate, Grid, PreparedScene, RenderOptions, Unwatched};
use capwalk_scene::lobe::Lobe;
use capwalk_scene::{Bsdf, Gradient, Image, Quantity, Scene, Shape, Slot, Tangent, TextureId};

use crate::agreement::SMALL_EMITTERS;
use crate::beside::different;
use crate::{device, scenes};

/// Samples differ if their derivatives do by more than this, relatively: single precision of what a
/// path multiplies.
const DIFFERENT: f64 = 5e-4;

/// The share of samples that may, as in images.
const MOST_DIFFERENT: f64 = 0.01;

/// By how much the derivatives with respect to the texels of a texture may differ in all,
/// relatively: samples that differ.
const TEXELS_DIFFERENT: f64 = 0.02;

/// What forward and reverse mode may differ by, relatively: single precision.
const ROUNDING: f64 = 2e-5;

/// Scenes that the device can render, and whose derivatives are not refused.
const FEWEST_SCENES: usize = 90;

/// A number between zero and one for each number, always the same.
pub fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1 << 24) as f64
    }
}

/// All texels become larger, which has no derivative that cancels another one, but for those of
/// which the device has no derivative.
pub fn all_texels(scene: &Scene) -> Tangent {
    let is_other = |slot: &Slot| slot.quantity != Quantity::Reflectance;
    let of_shape = |shape: &Arc<Shape>| {
        let materials = scene.materials_below(shape.bsdf).into_iter();
        let materials = materials.map(|id| &scene.material(id).bsdf);
        let coats = materials.filter(|bsdf| matches!(bsdf, Bsdf::Plain(Lobe::RoughPlastic(_))));
        let others = coats.flat_map(Bsdf::slots).filter(is_other);
        let ids = others.map(|slot| scene.numbers_of(slot.texture, shape));
        ids.collect::<Vec<_>>()
    };
    let others: Vec<TextureId> = scene.shapes.iter().flat_map(of_shape).collect();
    let mut next = numbers(1);
    let mut tangent = Tangent::zero(scene);
    for (id, (change, texture)) in (0..).zip(tangent.textures.iter_mut().zip(&scene.textures)) {
        let texels = texture.data.iter().map(|_| next()).collect();
        *change = (!others.contains(&TextureId(id))).then_some(texels);
    }
    tangent
}

/// The derivative of a loss by every channel of every pixel: of both signs.
pub fn adjoint(scene: &Scene) -> Image {
    let [width, height] = scene.film.crop_size.map(|n| n as usize);
    let mut next = numbers(2);
    let pixels = (0..width * height).map(|_| Rgb::new(next(), next(), next()) - Rgb::splat(0.25));
    Image {
        width,
        height,
        pixels: pixels.collect(),
    }
}

fn options(spp: u32, grid: Grid) -> GradientOptions {
    GradientOptions {
        grid,
        ..GradientOptions::new(RenderOptions::new(spp, 7))
    }
}

/// An error, in words, if too many samples differ.
fn compare(ours: &Estimate, theirs: &Estimate) -> Result<(), String> {
    let (count, all) = different(&ours.mean, &theirs.mean, DIFFERENT);
    match count as f64 <= MOST_DIFFERENT * all as f64 {
        true => Ok(()),
        false => Err(format!("{count} of {all} samples differ")),
    }
}

/// An error, in words, if the derivatives with respect to a texture's texels differ.
fn compare_texels(ours: &Gradient, theirs: &Gradient) -> Result<(), String> {
    for (number, (a, b)) in ours.textures.iter().zip(&theirs.textures).enumerate() {
        let (Some(a), Some(b)) = (a, b) else {
            continue;
        };
        let off: f64 = a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum();
        let all: f64 = b.iter().map(|b| b.abs()).sum();
        if off.is_nan() || off > TEXELS_DIFFERENT * all {
            return Err(format!("texture {number}: {off} of {all} is off"));
        }
    }
    Ok(())
}

/// In every scene that the device can render, for all texels of all textures.
#[test]
fn derivatives_by_texels_are_those_of_the_cpu() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut compared = 0;
    for (name, scene) in scenes::all() {
        if SMALL_EMITTERS.contains(&&*name) {
            continue;
        }
        let prepared = PreparedScene::new(scene);
        if unsupported(&prepared).is_some() {
            continue;
        }
        let (scene, one) = (
            prepared.scene(),
            Grid {
                batches: 1,
                bands: 4,
            },
        );
        let (tangent, adjoint) = (all_texels(scene), adjoint(scene));
        let (wanted, options) = (Wanted::by(&tangent), options(1, one));
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");

        let forward = on_device.gradient(&tangent, &options, &Unwatched);
        let theirs = capwalk_diff::gradient(&prepared, &tangent, &options, &Unwatched);
        let (forward, theirs) = match (forward, theirs) {
            (Ok(ours), Ok(theirs)) => (ours, theirs),
            (Err(DeviceError::Refused(ours)), Err(theirs)) if ours == theirs => continue,
            (ours, theirs) => panic!("{name}: {:?} and {:?}", ours.err(), theirs.err()),
        };
        for (ours, theirs) in [
            (&forward.value, &theirs.value),
            (&forward.gradient, &theirs.gradient),
        ] {
            compare(ours, theirs).unwrap_or_else(|problem| panic!("{name}: {problem}"));
        }

        let reverse = on_device.backward(&adjoint, &wanted, &options, &Unwatched);
        let theirs = capwalk_diff::backward(&prepared, &adjoint, &wanted, &options, &Unwatched);
        let (reverse, theirs) = (reverse.expect("supported"), theirs.expect("not refused"));
        compare_texels(reverse.gradient(), theirs.gradient())
            .unwrap_or_else(|problem| panic!("{name}: {problem}"));

        let by_pixels = adjoint.pixels.iter().zip(&forward.gradient.mean.pixels);
        let by_pixels: Vec<f64> = by_pixels.map(|(&a, &b)| 3.0 * (a * b).mean()).collect();
        let size: f64 = by_pixels.iter().map(|x| x.abs()).sum();
        let by_pixels: f64 = by_pixels.iter().sum();
        let by_texels = reverse.gradient().dot(&tangent);
        assert!(
            (by_pixels - by_texels).abs() <= ROUNDING * size,
            "{name}: {by_pixels} and {by_texels}"
        );
        compared += 1;
    }
    assert!(compared >= FEWEST_SCENES, "{compared} scenes");
}

/// Neither image, nor derivatives, nor their errors: and they are those of many samples.
#[test]
fn parts_of_any_size_give_the_same_bits() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/bitmap_box.xml");
    scene.film.resize([12, 9]);
    let prepared = PreparedScene::new(scene);
    let scene = prepared.scene();
    let (tangent, adjoint) = (all_texels(scene), adjoint(scene));
    let (wanted, options) = (Wanted::by(&tangent), options(24, Grid::default()));
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let forward = |most| {
        let image = on_device.gradient_in_parts(&tangent, &options, most, &Unwatched);
        let image = image.expect("supported");
        (image.value, image.gradient, image.statistics)
    };
    let reverse = |most| {
        let found = on_device.backward_in_parts(&adjoint, &wanted, &options, most, &Unwatched);
        let found = found.expect("supported");
        (
            found.gradient().clone(),
            found.standard_error(),
            found.statistics,
        )
    };
    let (whole, by_texels) = (forward(1 << 18), reverse(1 << 16));
    assert!(whole.2.complete && by_texels.2.complete);
    assert_eq!(by_texels.2.samples, 12 * 9 * 24);
    // Less than a sample of the image, and some that are no whole number of them.
    for most in [71, 250] {
        assert!(forward(most) == whole, "{most}");
        assert!(reverse(most) == by_texels, "{most}");
    }
    // Errors are the CPU's, whose samples are nearly the same: those of each texture in all.
    let theirs = capwalk_diff::backward(&prepared, &adjoint, &wanted, &options, &Unwatched);
    let theirs = theirs.expect("not refused").standard_error();
    for (a, b) in by_texels.1.textures.iter().zip(&theirs.textures) {
        let norm = |x: &Option<Vec<f64>>| {
            let squares = x.iter().flatten().map(|x| x * x);
            squares.sum::<f64>().sqrt()
        };
        assert!(
            (norm(a) / norm(b) - 1.0).abs() < 0.02,
            "{} {}",
            norm(a),
            norm(b)
        );
    }
}

/// Derivatives that are far larger than can be expected get larger units; nothing is cut off.
#[test]
fn large_derivatives_have_room() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/colour_bleeding.xml");
    scene.film.resize([16, 12]);
    // Every reflection makes light four thousand times brighter.
    let emitting = scene.emitters[0].radiance();
    for (number, texture) in scene.textures.iter_mut().enumerate() {
        if number != emitting.0 as usize {
            let data = &mut Arc::make_mut(texture).data;
            data.iter_mut().for_each(|x| *x = 4096.0);
        }
    }
    let prepared = PreparedScene::new(scene);
    let scene = prepared.scene();
    let (tangent, adjoint) = (all_texels(scene), adjoint(scene));
    let (wanted, options) = (Wanted::by(&tangent), options(4, Grid::default()));
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let ours = on_device.backward(&adjoint, &wanted, &options, &Unwatched);
    let theirs = capwalk_diff::backward(&prepared, &adjoint, &wanted, &options, &Unwatched);
    let (ours, theirs) = (ours.expect("supported"), theirs.expect("not refused"));
    compare_texels(ours.gradient(), theirs.gradient()).expect("the same");
    assert_eq!(ours.statistics.non_finite, 0);
}

/// Derivatives of very different sizes in one image, and losses of any size.
#[test]
fn derivatives_may_be_large_and_small() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/colour_bleeding.xml");
    scene.film.resize([16, 12]);
    // An emitter that is bright in one channel.
    let emitting = scene.emitters[0].radiance();
    let emitter = Arc::make_mut(&mut scene.textures[emitting.0 as usize]);
    emitter.data = vec![1e7, 1e-3, 1.0];
    emitter.channels = 3;
    let prepared = PreparedScene::new(scene);
    let scene = prepared.scene();
    let wanted = Wanted::by(&all_texels(scene));
    let options = options(4, Grid::default());
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let adjoint = adjoint(scene);
    let mut one_bright = adjoint.clone();
    one_bright.pixels[16 * 5 + 3] = Rgb::splat(1e10);
    let scaled = |factor: f64| {
        let mut image = adjoint.clone();
        image
            .pixels
            .iter_mut()
            .for_each(|pixel| *pixel = *pixel * factor);
        image
    };
    for (name, adjoint) in [
        ("one bright pixel", one_bright),
        ("tiny", scaled(1e-30)),
        ("huge", scaled(1e39)),
        ("none", scaled(0.0)),
    ] {
        let ours = on_device.backward(&adjoint, &wanted, &options, &Unwatched);
        let theirs = capwalk_diff::backward(&prepared, &adjoint, &wanted, &options, &Unwatched);
        let (ours, theirs) = (ours.expect("supported"), theirs.expect("not refused"));
        assert_eq!(ours.statistics.non_finite, 0, "{name}");
        let textures = ours
            .gradient()
            .textures
            .iter()
            .zip(&theirs.gradient().textures);
        for (a, b) in textures.flat_map(|(a, b)| a.iter().flatten().zip(b.iter().flatten())) {
            assert!((a - b).abs() <= 1e-2 * b.abs(), "{name}: {a} {b}");
        }
    }
}

/// Paths of more vertices than fit at first give the same bits in parts of any size.
#[test]
fn long_paths_have_room() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let mut scene = scenes::scene("parity/roulette.xml");
    scene.film.resize([8, 6]);
    let emitting = scene.emitters[0].radiance();
    for (number, texture) in scene.textures.iter_mut().enumerate() {
        if number != emitting.0 as usize {
            let data = &mut Arc::make_mut(texture).data;
            data.iter_mut().for_each(|x| *x = 0.99);
        }
    }
    let prepared = PreparedScene::new(scene);
    let scene = prepared.scene();
    let wanted = Wanted::by(&all_texels(scene));
    let (adjoint, options) = (adjoint(scene), options(16, Grid::default()));
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    let reverse = |most| {
        let found = on_device.backward_in_parts(&adjoint, &wanted, &options, most, &Unwatched);
        found.expect("supported").gradient().clone()
    };
    let whole = reverse(1 << 16);
    assert!(reverse(71) == whole);
    let theirs = capwalk_diff::backward(&prepared, &adjoint, &wanted, &options, &Unwatched);
    compare_texels(&whole, theirs.expect("not refused").gradient()).expect("the same");
}
