//! Variance times time of derivative images, as
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
mod measure;

use capwalk_diff::{
    Estimator, GradientImage, GradientOptions, PreparedScene, RenderOptions, Unwatched,
    WalkSettings, finite_difference, gradient,
};
use capwalk_scene::{Scene, Tangent, params};
use folder::{Demand, Folder};
use measure::{Clock, digits, variance};

/// Samples per pixel to begin with, and for what is done once.
const FEW: u32 = 4;
/// Seconds that must lie between few and many samples: many ticks of the clock.
const LONG: f64 = 0.4;
const ROUNDS: u64 = 3;

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
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, parameter)
        .expect("a parameter of the scene");
    let ways = [
        Way::Walk(Estimator::Anchored),
        Way::Walk(Estimator::Literal),
        Way::Differences(step),
    ];
    let many = ways.each_ref().map(|way| way.many(&scene, &tangent));
    let (mut variances, mut seconds) = ([0.0; 3], [f64::INFINITY; 3]);
    for round in 1..=ROUNDS {
        for (i, way) in ways.iter().enumerate() {
            let (few, _) = way.run(&scene, &tangent, FEW, round);
            let (all, image) = way.run(&scene, &tangent, many[i], round);
            let pixels = image.gradient.mean.pixels.len() as f64;
            let samples = f64::from(many[i] - FEW) * pixels;
            seconds[i] = seconds[i].min((all - few) / samples);
            variances[i] += variance(&image) / ROUNDS as f64;
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
    fn many(&self, scene: &Scene, tangent: &Tangent) -> u32 {
        let mut many = 8 * FEW;
        while self.run(scene, tangent, many, 0).0 < LONG {
            many *= 2;
        }
        many
    }

    /// The derivative, and the processor's time for it.
    fn run(&self, scene: &Scene, tangent: &Tangent, spp: u32, seed: u64) -> (f64, GradientImage) {
        let options = RenderOptions::new(spp, seed);
        let started = Clock::start();
        let image = match *self {
            Self::Walk(estimator) => {
                let walk = WalkSettings {
                    estimator,
                    ..WalkSettings::default()
                };
                gradient(
                    &PreparedScene::new(scene.clone()),
                    tangent,
                    &GradientOptions {
                        walk,
                        ..GradientOptions::new(options)
                    },
                    &Unwatched,
                )
            }
            Self::Differences(step) => {
                finite_difference(scene, tangent, step, &options, &Unwatched)
            }
        };
        (started.seconds(), image.expect("covered"))
    }
}
