//! What the gradient of a loss costs, as
//! `cargo bench -p capwalk-diff --bench reverse_cost` prints it: the time of a
//! sample on one thread, in ratios to the image and to the derivative image
//! for one parameter, on a mesh of about 250,000 vertices.
//!
//! Every way runs with few and with many samples, all of them in turn in each of
//! several rounds. The difference of the two over the samples between them is the
//! time of a sample; what is left is fixed: trees, and for reverse mode the sums
//! over batches and the maps after the samples. Both are medians over the rounds.
//! Derivatives by colours ask what the image asks: their ratio to the image is
//! what recording and sweeping cost, with the queries of moving geometry left out.
//! Memory is the process's peak after a way first ran, and can only grow from row
//! to row.
//!
//! `-- --once WAY SAMPLES` runs a way once, by its number from 0, on a smaller mesh
//! with so many samples per pixel: for tools that count instructions.

#[path = "../tests/gradients/common/mod.rs"]
mod common;

use std::time::Instant;

use capwalk_diff::{
    GradientOptions, Method, PreparedScene, RenderOptions, Statistics, Unwatched, Wanted, backward,
    gradient, render,
};
use capwalk_math::Rgb;
use capwalk_scene::primitive::icosphere;
use capwalk_scene::{Image, Scene, ShadingNormals, Tangent, params};
use common::{add, add_emitter, add_floor, empty, v};

/// Edges of the sphere are cut into so many: `10 n² + 2` vertices.
const FREQUENCY: u32 = 158;
/// Pixels in a row and rows.
const SIZE: u32 = 48;
/// Samples per pixel: as many as reverse mode has batches, and more.
const FEW: u32 = 16;
const MANY: u32 = 48;
/// Odd, so that there is a median.
const ROUNDS: usize = 5;
/// The mesh on which instructions are counted.
const COUNTED_FREQUENCY: u32 = 40;

fn main() {
    capwalk_diff::with_threads(1, measure_all);
}

fn measure_all() {
    if let Some([way, samples]) = once() {
        WAYS[way].1(&Bench::new(COUNTED_FREQUENCY), samples as u32);
        return;
    }
    // `cargo test` runs benches once, without measuring.
    let measures = std::env::args().any(|argument| argument == "--bench");
    let (frequency, rounds) = match measures {
        true => (FREQUENCY, ROUNDS),
        false => (8, 1),
    };
    let bench = Bench::new(frequency);
    let mut times = vec![Vec::new(); WAYS.len()];
    let mut queries = vec![0.0; WAYS.len()];
    let mut peaks = vec![None; WAYS.len()];
    for round in 0..rounds {
        for (i, (_, run)) in WAYS.iter().enumerate() {
            let time = |spp: u32| {
                let started = Instant::now();
                let statistics = run(&bench, spp);
                (started.elapsed().as_secs_f64(), statistics)
            };
            let ((few, _), (many, statistics)) = (time(FEW), time(MANY));
            let samples = f64::from(SIZE * SIZE) * f64::from(MANY - FEW);
            let sample = (many - few) / samples;
            times[i].push((sample, many - sample * statistics.samples as f64));
            queries[i] = statistics.cone_queries as f64 / statistics.samples as f64;
            if round == 0 {
                peaks[i] = peak_memory();
            }
        }
    }
    if measures {
        bench.print(&times, &queries, &peaks);
    }
}

/// The numbers behind `--once`.
fn once() -> Option<[usize; 2]> {
    let mut numbers = std::env::args().skip_while(|argument| argument != "--once");
    numbers.next()?;
    let mut number = || numbers.next()?.parse().ok();
    Some([number()?, number()?])
}

/// A way to use samples; what it did.
type Way = fn(&Bench, u32) -> Statistics;

const WAYS: [(&str, Way); 6] = [
    ("image", |bench, spp| {
        render(
            &PreparedScene::new(bench.scene.clone()),
            &options(spp).sampling(),
            &Unwatched,
        )
        .statistics
    }),
    ("forward, one translation of the mesh", |bench, spp| {
        let result = gradient(
            &PreparedScene::new(bench.scene.clone()),
            &bench.tangent,
            &options(spp),
            &Unwatched,
        );
        result.expect("covered").statistics
    }),
    ("reverse, colours: same queries", |bench, spp| {
        let colour = |name| {
            params::Registry::new(&bench.scene)
                .tangent(&bench.scene, name)
                .expect("a colour")
        };
        let mut colours = colour("ball.bsdf.reflectance.value");
        colours.add(&colour("floor.bsdf.reflectance.value"));
        bench.backward(&Wanted::by(&colours), spp)
    }),
    ("reverse, the emitter's 4 vertices", |bench, spp| {
        let emitter = params::Registry::new(&bench.scene)
            .tangent(&bench.scene, "lamp.translate.x")
            .expect("a shape");
        bench.backward(&Wanted::by(&emitter), spp)
    }),
    ("reverse, the mesh's vertices", |bench, spp| {
        bench.backward(&Wanted::by(&bench.tangent), spp)
    }),
    ("reverse, everything", |bench, spp| {
        bench.backward(&Wanted::all(&bench.scene), spp)
    }),
];

/// A scene and what is done with it.
struct Bench {
    scene: Scene,
    tangent: Tangent,
    adjoint: Image,
}

impl Bench {
    /// A bumpy ball over a floor under an emitter, in view with its shadow.
    fn new(frequency: u32) -> Self {
        let mut scene = empty(v(0.4, -5.0, 2.6), v(0.0, 0.0, 0.8), 34.0, SIZE);
        add_floor(&mut scene, 3.0);
        let mut ball = icosphere(frequency);
        for p in &mut ball.positions {
            let bumps = (9.0 * p.x).sin() * (8.0 * p.y + 1.0).sin() * (10.0 * p.z).sin();
            *p = *p * (0.8 + 0.06 * bumps) + v(0.0, 0.0, 1.0);
        }
        let normals = ShadingNormals::computed(&ball);
        add(&mut scene, "ball", ball, normals, 0.6);
        add_emitter(&mut scene, v(0.8, -0.6, 3.5), 0.9, 0.3, 12.0);
        scene.check().expect("a valid scene");
        let tangent = params::Registry::new(&scene)
            .tangent(&scene, "ball.translate.x")
            .expect("a shape");
        let size = SIZE as usize;
        let weights = (0..size * size).map(|i| Rgb::splat((0.1 * i as f64).sin()));
        let adjoint = Image {
            width: size,
            height: size,
            pixels: weights.collect(),
        };
        Self {
            scene,
            tangent,
            adjoint,
        }
    }

    fn backward(&self, wanted: &Wanted, spp: u32) -> Statistics {
        let result = backward(
            &PreparedScene::new(self.scene.clone()),
            &self.adjoint,
            wanted,
            &options(spp),
            &Unwatched,
        );
        result.expect("covered").statistics
    }

    fn print(&self, times: &[Vec<(f64, f64)>], queries: &[f64], peaks: &[Option<f64>]) {
        let vertices = self.scene.shapes[1].mesh.positions.len();
        println!("a mesh of {vertices} vertices, {SIZE} x {SIZE} pixels, one thread");
        println!(
            "{:38}{:>12}{:>10}{:>10}{:>16}{:>10}{:>10}",
            "", "µs/sample", "/image", "/forward", "queries/sample", "fixed, s", "peak, MiB"
        );
        let sample = |i: usize| median(times[i].iter().map(|&(sample, _)| sample));
        for (i, (name, _)) in WAYS.iter().enumerate() {
            let peak = peaks[i].map_or("-".into(), |peak| format!("{peak:.0}"));
            println!(
                "{name:38}{:>12.2}{:>10.2}{:>10.2}{:>16.2}{:>10.2}{peak:>10}",
                1e6 * sample(i),
                sample(i) / sample(0),
                sample(i) / sample(1),
                queries[i],
                median(times[i].iter().map(|&(_, fixed)| fixed)),
            );
        }
    }
}

fn options(spp: u32) -> GradientOptions {
    GradientOptions {
        method: Method::Walk,
        ..GradientOptions::new(RenderOptions::new(spp, 1))
    }
}

fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Most memory that this process ever had, MiB, where the system says it.
fn peak_memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kibibytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes / 1024.0)
}
