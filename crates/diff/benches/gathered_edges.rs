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
    Gathers, GradientImage, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched,
    WalkSettings, gradient,
};
use capwalk_geometry::Mesh;
use capwalk_math::Affine;
use capwalk_scene::lobe::Distribution;
use capwalk_scene::primitive::{cube, icosphere};
use capwalk_scene::*;
use common::materials::{make, rough_metal};
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
            "ball with silhouette, box filter",
            visible_ball(Filter::Box),
            "ball.translate.x",
        ),
        (
            "ball with silhouette, gaussian",
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
        ("ball, built in", built_in("ball"), "ball.translate.x"),
        ("leaf, built in", built_in("leaf"), "leaf.translate.x"),
        (
            "box-room, built in",
            built_in("box-room"),
            "box.translate.x",
        ),
    ]
}

/// The same, where environment light is what matters. The camera walks: what it sees of the
/// ball has its own noise.
fn sky_scenes() -> Vec<(&'static str, Scene, &'static str)> {
    let [smooth, bumpy] = [icosphere(62), bumpy_ball(62)];
    // The camera sees the floor beside the ball.
    let beside = |ball: &Mesh| {
        let mut scene = under_sky(ball.clone(), false);
        scene.sensor = empty(v(1.5, -1.5, 3.0), v(0.75, -0.75, 0.0), 12.0, SIZE).sensor;
        scene
    };
    // The camera sees the mirrored ball.
    let mirrored = |alpha: f64| {
        let mut scene = under_sky(bumpy.clone(), false);
        make(&mut scene, "floor", |n| {
            rough_metal(n.mirror(), n.facets(Distribution::Ggx, alpha))
        });
        scene.sensor = empty(v(0.0, -3.0, 1.2), v(0.0, -1.15, 0.0), 18.0, SIZE).sensor;
        scene
    };
    vec![
        (
            "bumpy ball of 76,880 faces in a floor of roughness 0.05 under the sky",
            mirrored(0.05),
            "ball.translate.x",
        ),
        (
            "bumpy ball of 76,880 faces in a floor of roughness 0.2 under the sky",
            mirrored(0.2),
            "ball.translate.x",
        ),
        (
            "floor beside a smooth ball of 76,880 faces under the sky",
            beside(&smooth),
            "ball.translate.z",
        ),
        (
            "floor beside a bumpy ball of 76,880 faces under the sky",
            beside(&bumpy),
            "ball.translate.z",
        ),
        (
            "smooth ball of 76,880 faces under the sky",
            under_sky(smooth, true),
            "ball.translate.z",
        ),
        (
            "bumpy ball of 76,880 faces under the sky",
            under_sky(bumpy, false),
            "ball.translate.z",
        ),
    ]
}

fn with_filter(mut scene: Scene, filter: Filter) -> Scene {
    scene.film.filter = filter;
    scene
}

/// A ball over a floor under constant light.
fn under_sky(ball: Mesh, is_smooth: bool) -> Scene {
    let scene = visible_stage(v(1.2, -4.0, 1.9));
    let mut scene = under_constant_light(scene);
    let place = Affine::translate(v(0.0, 0.0, 0.55)) * Affine::scale(v(0.5, 0.5, 0.5));
    let normals = match is_smooth {
        true => ShadingNormals::Given(ball.positions.clone()),
        false => ShadingNormals::Face,
    };
    add(&mut scene, "ball", placed(ball, place), normals, 0.6);
    with_filter(scene, Filter::Gaussian { stddev: 0.5 })
}

/// A ball with bumps of two sizes.
fn bumpy_ball(n: u32) -> Mesh {
    let mut ball = icosphere(n);
    for p in &mut ball.positions {
        let bumps = |k: f64| (k * p.x).sin() * (1.1 * k * p.y).sin() * (0.9 * k * p.z).sin();
        *p = *p * (1.0 + 0.1 * bumps(9.0) + 0.03 * bumps(31.0));
    }
    ball
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
    println!("| scene | moves | cutoff | walk, variance | µs | edges, variance | µs | gain |");
    println!("|---|---|---|---|---|---|---|---|");
    let standard = [Run::of(Method::Walk), Run::of(Method::EDGES)];
    let environment = Method::Edges(Gathers {
        environment: true,
        ..Gathers::NONE
    });
    let narrow = Run {
        max_angle: 0.05,
        ..Run::of(Method::Walk)
    };
    let sky = [
        [Run::of(Method::Walk), Run::of(environment)],
        [narrow, Run::of(environment)],
    ];
    let scenes = scenes().into_iter().map(|scene| (scene, vec![standard]));
    let sky_scenes = sky_scenes().into_iter().map(|scene| (scene, sky.to_vec()));
    for ((name, mut scene, parameter), pairs) in scenes.chain(sky_scenes) {
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
        for pair in pairs {
            let [walk, edges] = measure(&pair, &scene, &tangent);
            println!(
                "| {name} | `{parameter}` | {} | {} | {} | {} | {} | {} |",
                pair[0].max_angle,
                digits(walk[0]),
                digits(walk[1]),
                digits(edges[0]),
                digits(edges[1]),
                digits(walk[0] * walk[1] / (edges[0] * edges[1])),
            );
        }
    }
}

/// A method, and the angular cutoff of its walks.
#[derive(Clone, Copy)]
struct Run {
    method: Method,
    max_angle: f64,
}

impl Run {
    fn of(method: Method) -> Self {
        let max_angle = WalkSettings::default().max_radius;
        Self { method, max_angle }
    }
}

/// Variance and microseconds of a sample, of both runs.
fn measure(runs: &[Run; 2], scene: &Scene, tangent: &Tangent) -> [[f64; 2]; 2] {
    let many = runs.map(|method| {
        let mut many = 8 * FEW;
        while run(method, scene, tangent, many, 0).0 < LONG {
            many *= 2;
        }
        many
    });
    let mut found = [[0.0, f64::INFINITY]; 2];
    for round in 1..=ROUNDS {
        for (i, &method) in runs.iter().enumerate() {
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
    Run { method, max_angle }: Run,
    scene: &Scene,
    tangent: &Tangent,
    spp: u32,
    seed: u64,
) -> (f64, GradientImage) {
    let options = RenderOptions::new(spp, seed);
    let settings = GradientOptions {
        method,
        walk: WalkSettings {
            max_radius: max_angle,
            ..WalkSettings::default()
        },
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
