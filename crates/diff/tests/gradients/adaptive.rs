//! Samples that follow the noise of pixels: the same means with less noise, for the same work.

use crate::common::agree::tangent;
use crate::common::stages::visible_cube;
use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{
    GradientImage, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched,
    finite_difference, gradient,
};
use capwalk_scene::{SamplerKind, Scene};

/// A cube whose silhouette moves over few of the pixels.
fn scene() -> Scene {
    let mut scene = visible_cube();
    (scene.film.size, scene.film.crop_size) = ([32, 32], [32, 32]);
    scene
}

/// Mean variance of the derivative, times the effort that it took.
fn cost(image: &GradientImage) -> f64 {
    let errors = image.gradient.standard_error.pixels.iter();
    let squares = errors.flat_map(|error| error.to_array()).map(|e| e * e);
    squares.sum::<f64>() * image.statistics.effort as f64
}

/// Two images of one derivative agree; the adaptive one takes about as much work, and a part of
/// variance × work of the other.
fn is_better(adaptive: &GradientImage, even: &GradientImage, part: f64, spp: u32) {
    let result = compare(&adaptive.gradient, &even.gradient);
    println!("{result}, cost {}", cost(adaptive) / cost(even));
    match result.verdict {
        Verdict::Inconclusive { samples_factor, .. } if samples_factor <= 3.0 => {}
        verdict => assert_eq!(verdict, Verdict::Right),
    }
    assert!(cost(adaptive) < part * cost(even));
    let work = adaptive.statistics.effort as f64 / even.statistics.effort as f64;
    assert!((0.8..1.25).contains(&work), "{work} times the work");
    let counts = &adaptive.statistics.samples_per_pixel;
    let (fewest, most) = (counts.iter().min(), counts.iter().max());
    assert!(
        fewest < Some(&(spp / 2)) && most > Some(&(2 * spp)),
        "{fewest:?} to {most:?}"
    );
    assert!(adaptive.statistics.complete);
    let sum: u64 = counts.iter().map(|&n| u64::from(n)).sum();
    assert_eq!(sum, adaptive.statistics.samples);
}

#[test]
fn gradients() {
    let scene = scene();
    let tangent = tangent(&scene, "thing.translate.x");
    let prepared = PreparedScene::new(scene);
    let of = |adaptive, seed| {
        let options = GradientOptions {
            method: Method::EDGES,
            adaptive,
            ..RenderOptions::new(256, seed).into()
        };
        gradient(&prepared, &tangent, &options, &Unwatched).expect("covered")
    };
    is_better(&of(true, 1), &of(false, 2), 0.6, 256);
}

/// Also where samples of a pixel belong together.
#[test]
fn differences() {
    for sampler in [SamplerKind::Independent, SamplerKind::Sobol] {
        let mut scene = scene();
        scene.settings.sampler = sampler;
        let tangent = tangent(&scene, "thing.translate.x");
        let prepared = PreparedScene::new(scene);
        let of = |adaptive, seed| {
            let options = RenderOptions {
                adaptive,
                ..RenderOptions::new(1024, seed)
            };
            let image = finite_difference(&prepared, &tangent, 4e-3, &options, &Unwatched);
            image.expect("valid on both sides")
        };
        is_better(&of(true, 1), &of(false, 2), 0.5, 1024);
    }
}
