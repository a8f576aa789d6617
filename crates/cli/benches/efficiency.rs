//! Variance times time of derivative pictures, as
//! `cargo bench -p capwalk-cli --bench efficiency` prints it for the first
//! parameter of every folder of `tests/scenes`: of the estimators `anchored` and
//! `literal`, and of central differences with common random numbers and the
//! step of the folder. Names of folders behind `--` choose some.
//!
//! Variance is that of a sample, averaged over pixels and channels; time is that
//! of the processor for a sample, without what is done once. All three run in
//! turn in each of several rounds, each with other random numbers; variances are
//! means over the rounds, times the smallest of them.

#[allow(dead_code, reason = "a bench has no refusals")]
#[path = "../tests/phenomena/folder.rs"]
mod folder;

use std::time::Instant;

use capwalk_render::{
    Estimator, GradientImage, GradientOptions, Options, Unwatched, WalkSettings, finite_difference,
    gradient,
};
use capwalk_scene::{Motion, Scene, params};
use folder::{Demand, Folder};

/// Samples per pixel to begin with, and for what is done once.
const FEW: u32 = 4;
/// Seconds that must lie between few and many samples: many ticks of the clock.
const LONG: f64 = 0.4;
const ROUNDS: u64 = 3;

fn main() {
    // `cargo test` runs benches once, without measuring.
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if !arguments.iter().any(|argument| argument == "--bench") {
        return;
    }
    let is_named = |folder: &Folder| arguments.contains(&folder.name);
    let some = folder::all().iter().any(is_named);
    println!("| scene | parameter | anchored, variance × µs | literal | differences | step |");
    println!("|---|---|---|---|---|---|");
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
        let [anchored, literal, differences] = measure(&folder, &parameter, step);
        println!(
            "| {} | `{parameter}` | {} | {} | {} | {step} |",
            folder.name,
            digits(anchored * 1e6),
            digits(literal / anchored),
            digits(differences / anchored),
        );
        ratios.push(differences / anchored);
    }
    ratios.sort_by(f64::total_cmp);
    println!(
        "\ndifferences over anchored: median {}, below 1 in {} of {} scenes",
        digits(ratios[ratios.len() / 2]),
        ratios.iter().filter(|&&ratio| ratio < 1.0).count(),
        ratios.len()
    );
}

/// Variance times seconds of a sample, of the three ways.
fn measure(folder: &Folder, parameter: &str, step: f64) -> [f64; 3] {
    let scene = folder.scene();
    let motion = params::motion(&scene, parameter).expect("a parameter of the scene");
    let ways = [
        Way::Walk(Estimator::Anchored),
        Way::Walk(Estimator::Literal),
        Way::Differences(step),
    ];
    let many = ways.each_ref().map(|way| way.many(&scene, &motion));
    let (mut variances, mut seconds) = ([0.0; 3], [f64::INFINITY; 3]);
    for round in 1..=ROUNDS {
        for (i, way) in ways.iter().enumerate() {
            let (few, _) = way.run(&scene, &motion, FEW, round);
            let (all, picture) = way.run(&scene, &motion, many[i], round);
            let pixels = picture.gradient.mean.pixels.len() as f64;
            let samples = f64::from(many[i] - FEW) * pixels;
            seconds[i] = seconds[i].min((all - few) / samples);
            variances[i] += variance(&picture) / ROUNDS as f64;
        }
    }
    [0, 1, 2].map(|i| variances[i] * seconds[i])
}

enum Way {
    Walk(Estimator),
    /// With this step.
    Differences(f64),
}

impl Way {
    /// Samples per pixel that take long.
    fn many(&self, scene: &Scene, motion: &Motion) -> u32 {
        let mut many = 8 * FEW;
        while self.run(scene, motion, many, 0).0 < LONG {
            many *= 2;
        }
        many
    }

    /// The derivative, and the processor's time for it.
    fn run(&self, scene: &Scene, motion: &Motion, spp: u32, seed: u64) -> (f64, GradientImage) {
        let options = Options {
            spp,
            seed,
            threads: Some(1),
        };
        let started = Clock::start();
        let picture = match *self {
            Self::Walk(estimator) => {
                let walk = WalkSettings {
                    estimator,
                    ..WalkSettings::default()
                };
                gradient(
                    scene,
                    motion,
                    &GradientOptions {
                        walk,
                        ..GradientOptions::new(options)
                    },
                    &Unwatched,
                )
            }
            Self::Differences(step) => finite_difference(scene, motion, step, &options, &Unwatched),
        };
        (started.seconds(), picture.expect("covered"))
    }
}

/// Of a sample, averaged over pixels and channels.
fn variance(picture: &GradientImage) -> f64 {
    let errors = picture.gradient.standard_error.pixels.iter();
    let samples = picture.statistics.samples_per_pixel.iter();
    let pixels = errors.zip(samples);
    let sum: f64 = pixels.map(|(&e, &n)| e.dot(e) / 3.0 * f64::from(n)).sum();
    sum / picture.gradient.mean.pixels.len() as f64
}

/// Time of the processor where the system says it, which other programs disturb
/// less; else time on the wall.
struct Clock {
    processor: Option<f64>,
    wall: Instant,
}

impl Clock {
    fn start() -> Self {
        Self {
            processor: processor_seconds(),
            wall: Instant::now(),
        }
    }

    fn seconds(&self) -> f64 {
        match (self.processor, processor_seconds()) {
            (Some(start), Some(end)) => end - start,
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

/// Ticks of `/proc/self/stat` in a second.
const TICKS: f64 = 100.0;

/// Seconds that the processor has worked for this process, all threads.
fn processor_seconds() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The second field is the name in parentheses, which may contain anything.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut ticks = fields.split_whitespace().skip(11);
    let mut next = || ticks.next()?.parse::<f64>().ok();
    Some((next()? + next()?) / TICKS)
}

/// Three digits that count, and powers of ten where there were many.
fn digits(x: f64) -> String {
    let magnitude = x.abs().log10().floor();
    match magnitude < 4.0 {
        true => format!("{x:.*}", (2.0 - magnitude).clamp(0.0, 9.0) as usize),
        false => format!("{x:.1e}"),
    }
}
