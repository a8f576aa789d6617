//! Variance and time of derivative images by gathered edges and by walks, side by
//! side, as `cargo bench -p capwalk-diff --bench gathered_edges` prints them.
//! Words behind `--` choose the scenes whose names have them.
//!
//! Variance is that of a sample, averaged over pixels and channels; time is that
//! of one thread for a sample, without what is done once. Both methods run in
//! turn in each of several rounds, each with other random numbers; variances are
//! means over the rounds, times the smallest of them.

#[path = "../tests/gradients/common/mod.rs"]
mod common;

use std::time::Instant;

use capwalk_diff::{
    GradientImage, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, gradient,
};
use capwalk_math::Affine;
use capwalk_scene::primitive::{cube, icosphere};
use capwalk_scene::*;
use common::stages::*;
use common::*;

/// Samples per pixel to begin with, and for what is done once.
const FEW: u32 = 4;
/// Seconds that must lie between few and many samples.
const LONG: f64 = 0.4;
const ROUNDS: u64 = 3;
/// Pixels on a side.
const SIZE: u32 = 48;

/// Names, scenes, and what moves.
fn scenes() -> Vec<(&'static str, Scene, &'static str)> {
    let built_in = |name| builtin::scene(name).expect("a built-in scene");
    let gaussian = Filter::Gaussian { stddev: 0.5 };
    let mut crossing = with(triangle());
    let (mesh, normals) = cube(
        Affine::translate(v(0.1, 0.0, 1.6))
            * Affine::rotate(v(0.3, 0.8, 0.5), 0.7)
            * Affine::scale(v(0.3, 0.1, 0.25)),
    );
    add(&mut crossing, "other", mesh, normals, 0.5);
    vec![
        (
            "shadow of a triangle",
            with(triangle()),
            "thing.translate.x",
        ),
        (
            "shadow of a ball of 320 faces",
            with(small_ball()),
            "thing.translate.x",
        ),
        (
            "two occluders cross",
            crossing,
            "thing.translate.x + other.translate.y",
        ),
        (
            "lattice-shadow, built in",
            built_in("lattice-shadow"),
            "lattice.translate.x",
        ),
        (
            "ball with outline, box filter",
            visible_ball(Filter::Box),
            "ball.translate.x",
        ),
        (
            "ball with outline, gaussian",
            visible_ball(gaussian),
            "ball.translate.x",
        ),
        (
            "cube with creases, gaussian",
            with_filter(visible_cube(), gaussian),
            "thing.rotate.z",
        ),
        (
            "camera before the cube",
            with_filter(visible_cube(), gaussian),
            "sensor.translate.x",
        ),
        (
            "smooth ball of 60,500 faces under the sky",
            sky_ball(55),
            "ball.translate.x",
        ),
        ("ball, built in", built_in("ball"), "ball.translate.x"),
        ("leaf, built in", built_in("leaf"), "leaf.translate.x"),
        (
            "box-room, built in",
            built_in("box-room"),
            "box.translate.x",
        ),
    ]
}

fn with_filter(mut scene: Scene, filter: Filter) -> Scene {
    scene.film.filter = filter;
    scene
}

/// A smooth ball over a floor under constant light: its shadow is walked to.
fn sky_ball(n: u32) -> Scene {
    let mut scene = visible_stage(v(1.2, -4.0, 1.9));
    scene.shapes.retain(|shape| shape.emitter.is_none());
    scene.emitters.clear();
    let radiance = Texture::colour("sky.radiance", capwalk_math::Rgb::splat(1.0));
    let radiance = scene.add_texture(radiance);
    let id = "sky".into();
    scene.emitters.push(Emitter::Constant { id, radiance });
    let place = Affine::translate(v(0.0, 0.0, 0.55)) * Affine::scale(v(0.5, 0.5, 0.5));
    let ball = icosphere(n);
    let normals = ShadingNormals::Given(ball.positions.clone());
    add(&mut scene, "ball", placed(ball, place), normals, 0.6);
    with_filter(scene, Filter::Gaussian { stddev: 0.5 })
}

fn main() {
    capwalk_diff::with_threads(1, measure_all);
}

fn measure_all() {
    // `cargo test` runs benches once, without measuring.
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if !arguments.iter().any(|argument| argument == "--bench") {
        return;
    }
    let words: Vec<&String> = arguments.iter().filter(|a| !a.starts_with("--")).collect();
    println!("| scene | moves | walk, variance | µs | edges, variance | µs | gain |");
    println!("|---|---|---|---|---|---|---|");
    for (name, mut scene, parameter) in scenes() {
        if !words.is_empty() && !words.iter().any(|word| name.contains(word.as_str())) {
            continue;
        }
        scene.film.crop_offset = [0; 2];
        scene.film.size = [SIZE; 2];
        scene.film.crop_size = [SIZE; 2];
        scene.check().expect("a valid scene");
        let tangent = params::Registry::new(&scene)
            .tangent(&scene, parameter)
            .expect("a parameter of the scene");
        let [walk, edges] = measure(&scene, &tangent);
        println!(
            "| {name} | `{parameter}` | {} | {} | {} | {} | {} |",
            digits(walk[0]),
            digits(walk[1]),
            digits(edges[0]),
            digits(edges[1]),
            digits(walk[0] * walk[1] / (edges[0] * edges[1])),
        );
    }
}

/// Variance and microseconds of a sample, of both methods.
fn measure(scene: &Scene, tangent: &Tangent) -> [[f64; 2]; 2] {
    let methods = [Method::Walk, Method::EDGES];
    let many = methods.map(|method| {
        let mut many = 8 * FEW;
        while run(method, scene, tangent, many, 0).0 < LONG {
            many *= 2;
        }
        many
    });
    let mut found = [[0.0, f64::INFINITY]; 2];
    for round in 1..=ROUNDS {
        for (i, method) in methods.into_iter().enumerate() {
            let (few, _) = run(method, scene, tangent, FEW, round);
            let (all, image) = run(method, scene, tangent, many[i], round);
            let pixels = image.gradient.mean.pixels.len() as f64;
            let samples = f64::from(many[i] - FEW) * pixels;
            found[i][0] += variance(&image) / ROUNDS as f64;
            found[i][1] = found[i][1].min((all - few) / samples * 1e6);
        }
    }
    found
}

/// The derivative, and the time for it.
fn run(
    method: Method,
    scene: &Scene,
    tangent: &Tangent,
    spp: u32,
    seed: u64,
) -> (f64, GradientImage) {
    let options = RenderOptions::new(spp, seed);
    let settings = GradientOptions {
        method,
        ..GradientOptions::new(options)
    };
    let started = Instant::now();
    let image = gradient(
        &PreparedScene::new(scene.clone()),
        tangent,
        &settings,
        &Unwatched,
    )
    .expect("covered");
    (started.elapsed().as_secs_f64(), image)
}

/// Of a sample, averaged over pixels and channels.
fn variance(image: &GradientImage) -> f64 {
    let errors = image.gradient.standard_error.pixels.iter();
    let samples = image.statistics.samples_per_pixel.iter();
    let pixels = errors.zip(samples);
    let sum: f64 = pixels.map(|(&e, &n)| e.dot(e) / 3.0 * f64::from(n)).sum();
    sum / image.gradient.mean.pixels.len() as f64
}

/// Three digits that count.
fn digits(x: f64) -> String {
    let magnitude = x.abs().log10().floor();
    format!("{x:.*}", (2.0 - magnitude).clamp(0.0, 9.0) as usize)
}
