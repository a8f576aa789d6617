//! Warped-area sampling beside the walk, as
//! `cargo bench -p capwalk-paper --bench baselines` prints it for some folders of
//! `tests/scenes`, or for those named behind `--`, with their first parameter:
//! how large the derivative is relative to central differences, which shows bias,
//! and variance times time of a sample relative to the walk.
//!
//! The size is the inner product with the derivative by walks of another seed,
//! relative to that of the differences; both have standard errors from their
//! pixels.

#[allow(dead_code, reason = "a bench has no refusals")]
#[path = "../../../crates/cli/tests/phenomena/folder.rs"]
mod folder;
#[path = "../../../crates/cli/benches/measure/mod.rs"]
mod measure;

use capwalk_diff::{
    GradientImage, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched,
    finite_difference, gradient,
};
use capwalk_paper::fields::{WasSettings, was};
use capwalk_scene::params;
use folder::{Demand, Folder};
use measure::{Clock, digits, variance};

/// Samples per pixel.
const SPP: u32 = 256;
/// Samples of differences for each one.
const REFERENCE_FACTOR: u32 = 16;

const SCENES: [&str; 3] = [
    "shadow_of_a_moving_occluder",
    "emitter_on_black",
    "object_moves_in_a_planar_mirror",
];

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
    println!("| scene | method | size, of differences | variance × time, of the walk |");
    println!("|---|---|---|---|");
    for folder in folder::all() {
        let is_usual = SCENES.contains(&folder.name.as_str());
        if if some { is_named(&folder) } else { is_usual } {
            measure(&folder);
        }
    }
}

/// The methods that are compared with the walk.
fn baselines() -> Vec<(&'static str, WasSettings)> {
    let default = WasSettings::default();
    let with = |rays| WasSettings { rays, ..default };
    let single = WasSettings {
        antithetic: false,
        ..default
    };
    let debias = WasSettings {
        debias: true,
        ..default
    };
    vec![
        ("was, 8 rays", default),
        ("was, 32 rays", with(32)),
        ("was, 8 rays, no pairs", single),
        ("was, 8 rays, debiased", debias),
    ]
}

fn measure(folder: &Folder) {
    let scene = folder.scene();
    let mut checks = folder.checks().into_iter();
    let check = checks.find_map(|check| match check.demand {
        Demand::Agree(differences) => Some((check.parameter, differences.step)),
        Demand::Refuse(_) => None,
    });
    let Some((parameter, step)) = check else {
        return;
    };
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, &parameter)
        .expect("a parameter of the scene");
    let options = |spp, seed| RenderOptions::new(spp, seed);
    let run = |method, seed| {
        let settings = GradientOptions {
            method,
            ..GradientOptions::new(options(SPP, seed))
        };
        let clock = Clock::start();
        let image = gradient(
            &PreparedScene::new(scene.clone()),
            &tangent,
            &settings,
            &Unwatched,
        )
        .expect("covered");
        let cost = variance(&image) * clock.seconds();
        (image, cost)
    };
    let (weights, _) = run(Method::Walk, 1);
    let (walk, cost) = run(Method::Walk, 2);
    let spread = options(SPP * REFERENCE_FACTOR, 3);
    let prepared = PreparedScene::new(scene.clone());
    let differences = finite_difference(&prepared, &tangent, step, &spread, &Unwatched);
    let (reference, reference_error) = size(&differences.expect("covered"), &weights);
    let row = |name: &str, image: &GradientImage, ratio: f64| {
        let (size, error) = size(image, &weights);
        let relative = size / reference;
        let error = error.hypot(relative * reference_error) / reference.abs();
        println!(
            "| {} | {name} | {relative:.3} ± {error:.3} | {} |",
            folder.name,
            digits(ratio)
        );
    };
    row("walk", &walk, 1.0);
    for (name, settings) in baselines() {
        let (image, own) = run(was(settings), 2);
        row(name, &image, own / cost);
    }
}

/// The inner product of a derivative with weights of each pixel, and its standard
/// error.
fn size(image: &GradientImage, weights: &GradientImage) -> (f64, f64) {
    let weights = &weights.gradient.mean.pixels;
    let means = image.gradient.mean.pixels.iter().zip(weights);
    let errors = image.gradient.standard_error.pixels.iter().zip(weights);
    let sum: f64 = means.map(|(g, &w)| g.dot(w)).sum();
    // Channels of a pixel share their samples: at worst their errors add up.
    let error = |e: &capwalk_math::Rgb, w: &capwalk_math::Rgb| {
        (e.r * w.r).abs() + (e.g * w.g).abs() + (e.b * w.b).abs()
    };
    let squares: f64 = errors.map(|(e, w)| error(e, w).powi(2)).sum();
    (sum, squares.sqrt())
}
