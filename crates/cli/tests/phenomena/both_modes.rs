//! Forward and reverse mode with the same random numbers: the derivative of
//! `Σ w · image` for a fixed image `w`, along a parameter.

use std::path::Path;

use capwalk_diff::{
    GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, Wanted, backward, gradient,
};
use capwalk_math::Rgb;
use capwalk_scene::Image;
use capwalk_scene_io::arrays;
use capwalk_scene_io::image::{self, LayeredImage, Preview};

use crate::capwalk;
use crate::folder::{Folder, WIDE};
use crate::reference::tangent;

/// Few samples, all of them drawn from the same numbers.
const SPP: u32 = 4;
const SEED: u64 = 5;
/// Sums in another order; of the sum without signs.
const DOUBLE: f64 = 1e-10;
/// Images in files have single precision.
const SINGLE: f64 = 1e-4;

/// Numbers between -1 and 1 that look random and are exact in single precision.
fn weights(width: usize, height: usize) -> Image {
    let number = |i: usize| f64::from(((12.9898 * i as f64).sin() * 437.585).sin() as f32);
    let pixel = |i: usize| Rgb::new(number(3 * i), number(3 * i + 1), number(3 * i + 2));
    Image {
        width,
        height,
        pixels: (0..width * height).map(pixel).collect(),
    }
}

fn dot(a: &Image, b: &Image) -> f64 {
    let pairs = a.pixels.iter().zip(&b.pixels);
    pairs.map(|(a, &b)| a.dot(b)).sum()
}

/// Demands that both modes agree, in memory and as written to files in `out`.
pub fn agree(folder: &Folder, parameter: &str, out: &Path) {
    let name = format!("{}, {parameter}", folder.name);
    let scene = folder.scene();
    let tangent = tangent(folder, &scene, parameter);
    let settings = GradientOptions {
        blind: true,
        method: Method::Walk,
        ..GradientOptions::new(RenderOptions::new(SPP, SEED))
    };
    let forward = gradient(
        &PreparedScene::new(scene.clone()),
        &tangent,
        &settings,
        &Unwatched,
    )
    .expect("covered");
    let [width, height] = scene.film.crop_size.map(|n| n as usize);
    let weights = weights(width, height);
    let unsigned = |image: &Image| Image {
        pixels: image
            .pixels
            .iter()
            .map(|pixel| pixel.map(f64::abs))
            .collect(),
        ..*image
    };
    let size = dot(&unsigned(&weights), &unsigned(&forward.gradient.mean));
    let forward = dot(&weights, &forward.gradient.mean);
    let reverse = backward(
        &PreparedScene::new(scene.clone()),
        &weights,
        &Wanted::by(&tangent),
        &settings,
        &Unwatched,
    );
    let (reverse, _) = reverse.expect("covered").along(&tangent);
    assert!(forward.abs() > 1e-9, "{name}: nothing to compare");
    let relative = (forward - reverse).abs() / size;
    assert!(
        relative <= DOUBLE,
        "{name}: {forward} forward, {reverse} in reverse"
    );

    let (written, gradient) = (out.join("weights.exr"), out.join("gradient.exr"));
    let (npz, reversed) = (out.join("gradient.npz"), out.join("backward.npz"));
    let mut layered = LayeredImage::default();
    layered.push("adjoint", weights.clone());
    image::write(&written, &layered, &Preview::default()).expect("writable");
    let (spp, seed) = (SPP.to_string(), SEED.to_string());
    let file = folder.scene_file();
    let path = |path: &Path| path.to_str().expect("plain letters").to_owned();
    let sampling = ["--spp", &spp, "--seed", &seed, "--max-angle", WIDE];
    let both = format!("{},{}", path(&gradient), path(&npz));
    let done = capwalk(
        &[
            &["gradient", &file, "-p", parameter, "-o", &both],
            &sampling[..],
        ]
        .concat(),
    );
    assert_eq!(done.status, 0, "{name}: {}", done.errors);
    let (weights_file, reversed_file) = (path(&written), path(&reversed));
    let reverse = [
        "backward",
        &file,
        "--adjoint",
        &weights_file,
        "-o",
        &reversed_file,
    ];
    let done = capwalk(&[&reverse[..], &["-p", parameter], &sampling[..]].concat());
    assert_eq!(done.status, 0, "{name}: {}", done.errors);

    // An array has a number for each channel or texel, which here change together.
    let arrays = arrays::read(&reversed).expect("readable");
    let reverse: f64 = arrays
        .get(parameter)
        .expect("asked for")
        .numbers
        .iter()
        .sum();
    for file in [&gradient, &npz] {
        let layered = image::read(file).expect("readable");
        let forward = dot(&weights, layered.layer("gradient").expect("written"));
        let relative = (forward - reverse).abs() / reverse.abs();
        assert!(
            relative <= SINGLE,
            "{name}, {}: {forward} forward, {reverse} in reverse",
            file.display()
        );
    }
}
