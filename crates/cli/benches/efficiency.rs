//! Variance times time of derivative images, as
//! `cargo bench -p capwalk-cli --bench efficiency` prints it for the first
//! parameter of every folder of `tests/scenes`: of what `auto` chooses, of `walk`, of
//! `edges`, and of central differences with common random numbers and the step of the
//! folder. Names of folders behind `--` choose some.
//!
//! Variance is that of a sample, averaged over pixels and channels; time is that
//! of the CPU for a sample, without what is done once, as the pilot of `auto` is. All
//! run in turn in each of several rounds, each with other random numbers; variances are
//! means over the rounds, times the smallest of them.

#[allow(dead_code, reason = "a bench has no refusals")]
#[path = "../tests/phenomena/folder.rs"]
mod folder;
mod measure;

use std::borrow::Cow;

use capwalk_diff::{
    GradientImage, GradientOptions, GradientWork, Method, PreparedScene, RenderOptions, Unwatched,
    finite_difference, gradient,
};
use capwalk_scene::{Tangent, params};
use folder::{Demand, Folder};
use measure::{Clock, digits, variance};

/// Samples per pixel to begin with, and for what is done once.
const FEW: u32 = 4;
/// Seconds that must lie between few and many samples: many ticks of the clock.
const LONG: f64 = 0.4;
const ROUNDS: u64 = 3;
/// Samples per pixel of the work that the pilot of `auto` is a part of.
const PILOT_SPP: u32 = 256;

fn main() {
    capwalk_diff::with_threads(1, measure_all);
}

fn measure_all() {
    // `cargo test` runs benches once, without measuring.
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if !arguments.iter().any(|argument| argument == "--bench") {
        return;
    }
    let is_named = |folder: &Folder| arguments.contains(&folder.name);
    let some = folder::all().iter().any(is_named);
    println!(
        "| scene | parameter | auto, variance × µs | chosen | walk | edges | differences | step |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut ratios = Vec::new();
    for folder in folder::all() {
        let checks = folder.checks().into_iter();
        let mut differences = checks.filter_map(|check| match check.demand {
            Demand::Agree(differences) => Some((check.parameter, differences.step)),
            Demand::Refuse(_) => None,
        });
        let Some((parameter, step)) = differences.next().filter(|_| !some || is_named(&folder))
        else {
            continue;
        };
        let (chosen, [auto, others @ ..]) = measure(&folder, &parameter, step);
        let others = others.map(|other| other / auto);
        let [walk, edges, differences] = others.map(digits);
        println!(
            "| {} | `{parameter}` | {} | {chosen} | {walk} | {edges} | {differences} | {step} |",
            folder.name,
            digits(auto * 1e6),
        );
        ratios.push(others);
    }
    for (i, what) in ["walk", "edges", "differences"].iter().enumerate() {
        let mut ratios: Vec<f64> = ratios.iter().map(|others| others[i]).collect();
        ratios.sort_by(f64::total_cmp);
        println!(
            "\n{what} over auto: median {}, least {}, below 1 in {} of {} scenes",
            digits(ratios[ratios.len() / 2]),
            digits(ratios[0]),
            ratios.iter().filter(|&&ratio| ratio < 1.0).count(),
            ratios.len()
        );
    }
}

/// Variance times seconds of a sample, of the four ways, and what the first one chose.
fn measure(folder: &Folder, parameter: &str, step: f64) -> (String, [f64; 4]) {
    let scene = folder.scene();
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, parameter)
        .expect("a parameter of the scene");
    let by = |method| GradientOptions {
        method,
        ..GradientOptions::new(RenderOptions::new(PILOT_SPP, 0))
    };
    let prepared = PreparedScene::new(scene.clone());
    let work = GradientWork::new(&prepared, Cow::Borrowed(&tangent), by(Method::Auto));
    let chosen = work.chosen(&Unwatched).expect("covered").options;
    let gathers = chosen.method.traits().gathers;
    let angle = digits(chosen.walk.max_radius);
    let described = format!(
        "{} {} {angle}",
        chosen.method.name(),
        gathers.names().join("+")
    );
    let ways = [
        Way::Samples(chosen),
        Way::Samples(by(Method::Walk)),
        Way::Samples(by(Method::EDGES)),
        Way::Differences(step),
    ];
    let many = ways.each_ref().map(|way| way.many(&prepared, &tangent));
    let (mut variances, mut seconds) = ([0.0; 4], [f64::INFINITY; 4]);
    for round in 1..=ROUNDS {
        for (i, way) in ways.iter().enumerate() {
            let (few, _) = way.run(&prepared, &tangent, FEW, round);
            let (all, image) = way.run(&prepared, &tangent, many[i], round);
            let pixels = image.gradient.mean.pixels.len() as f64;
            let samples = f64::from(many[i] - FEW) * pixels;
            seconds[i] = seconds[i].min((all - few) / samples);
            variances[i] += variance(&image) / ROUNDS as f64;
        }
    }
    (described, [0, 1, 2, 3].map(|i| variances[i] * seconds[i]))
}

enum Way {
    /// Samples are differentiated.
    Samples(GradientOptions),
    /// With this step.
    Differences(f64),
}

impl Way {
    /// Samples per pixel that take long.
    fn many(&self, prepared: &PreparedScene, tangent: &Tangent) -> u32 {
        let mut many = 8 * FEW;
        while self.run(prepared, tangent, many, 0).0 < LONG {
            many *= 2;
        }
        many
    }

    /// The derivative, and the CPU's time for it.
    fn run(
        &self,
        prepared: &PreparedScene,
        tangent: &Tangent,
        spp: u32,
        seed: u64,
    ) -> (f64, GradientImage) {
        let started = Clock::start();
        let image = match *self {
            Self::Samples(options) => {
                let options = GradientOptions {
                    spp,
                    seed,
                    ..options
                };
                gradient(prepared, tangent, &options, &Unwatched)
            }
            Self::Differences(step) => {
                let options = RenderOptions::new(spp, seed);
                finite_difference(prepared, tangent, step, &options, &Unwatched)
            }
        };
        (started.seconds(), image.expect("covered"))
    }
}
