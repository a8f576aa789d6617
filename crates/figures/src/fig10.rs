//! Figure 10: the number of steps at equal time, on the shadow of a lattice.

use capwalk_render::{Method, WalkSettings};
use capwalk_scene_io::image::robust_limit;

use crate::claim::{self, Claim, Measured, digits};
use crate::figure::{Figure, Row, Table};
use crate::gradients::{Run, mean_l1, shown};
use crate::lattice;
use crate::settings::{Failure, Settings};

/// Numbers of steps, and the paper's samples and mean L1 errors.
const STEPS: [u32; 3] = [1, 2, 4];
const PAPER: [(u32, f64); 3] = [(1000, 0.017), (480, 0.028), (310, 0.041)];

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let quality = settings.quality;
    let size = quality.choose([12, 9], [64, 48], [256, 192]);
    // Samples of one step; the others have as many as its time allows.
    let spp = quality.choose(8, 192, 1000);
    let reference_spp = quality.choose(16, 1536, 8000);
    let subject = lattice::shadow(settings, size)?;
    let walk = |steps: u32| WalkSettings {
        steps,
        ..WalkSettings::default()
    };
    let reference = subject.gradient(Method::Walk, walk(1), reference_spp, 1, settings)?;

    // Seconds per sample, measured by turns so that a slow phase of the machine
    // slows all of them.
    let pilot = (spp / 8).max(2);
    let mut costs = [0.0; 3];
    for round in 0..2 {
        for (cost, steps) in costs.iter_mut().zip(STEPS) {
            let set = 100 + round;
            let run = subject.gradient(Method::Walk, walk(steps), pilot, set, settings)?;
            *cost += run.seconds / f64::from(2 * pilot);
        }
    }
    let mut runs: Vec<(u32, Run, Measured)> = Vec::new();
    for (i, steps) in STEPS.into_iter().enumerate() {
        let samples = (f64::from(spp) * costs[0] / costs[i]).round().max(2.0) as u32;
        let set = 10 + i as u64;
        let run = subject.gradient(Method::Walk, walk(steps), samples, set, settings)?;
        let error = mean_l1(run.gradient(), reference.gradient());
        runs.push((steps, run, error));
    }

    let limit = robust_limit([&reference.gradient().mean]);
    let mut pictures = vec![("reference".into(), reference.gradient())];
    for (steps, run, error) in &runs {
        let title = format!(
            "M = {steps}, {} samples, L1 {}",
            run.spp,
            digits(error.value)
        );
        pictures.push((title, run.gradient()));
    }
    let rows = vec![Row::Pictures(shown(&pictures, limit))];
    let lines = runs
        .iter()
        .zip(PAPER)
        .map(|((steps, run, error), (spp, l1))| {
            vec![
                steps.to_string(),
                run.spp.to_string(),
                digits(run.seconds),
                error.to_string(),
                format!("{} samples, {}", spp, l1),
            ]
        });
    let table = Table {
        title: "Equal time".into(),
        columns: vec![
            "steps",
            "samples per pixel",
            "seconds",
            "mean L1 error",
            "paper",
        ],
        rows: lines.collect(),
    };
    let [one, two, four] = [0, 1, 2].map(|i| runs[i].2);
    let claims = vec![
        Claim {
            statement: "Figure 10: at equal time, more than one step does not pay".into(),
            paper: "mean L1 0.017, 0.028 (1.6 times), 0.041 (2.4 times) for M = 1, 2, 4".into(),
            ours: format!(
                "{one}, {two} ({} times), {four} ({} times)",
                two.over(one),
                four.over(one)
            ),
            verdict: claim::all([claim::below(one, two), claim::below(two, four)]),
        },
        Claim {
            statement: "Section 7.2: the running time scales linearly in the number of steps"
                .into(),
            paper: "1000, 480 and 310 samples in equal time".into(),
            ours: format!(
                "{}, {} and {} samples: a sample of 2 steps costs {} times, of 4 steps {} times",
                runs[0].1.spp,
                runs[1].1.spp,
                runs[2].1.spp,
                digits(costs[1] / costs[0]),
                digits(costs[2] / costs[0])
            ),
            verdict: linear(costs),
        },
    ];
    Ok(Figure {
        caption: format!(
            "Derivative of {} by its y-translation, {} × {} pixels. Samples are chosen for the time \
             of {spp} samples of one step. Mean L1 errors are against one step with {reference_spp} \
             samples and other random numbers, whose own noise is part of all of them.",
            lattice::name(settings),
            size[0],
            size[1]
        ),
        rows,
        tables: vec![table],
        claims,
        ..Figure::default()
    })
}

/// That each further step costs the same, within a third: times are noisy.
fn linear(costs: [f64; 3]) -> claim::Verdict {
    let [second, fourth] = [costs[1] - costs[0], (costs[2] - costs[1]) / 2.0];
    match (fourth / second - 1.0).abs() < 1.0 / 3.0 {
        true => claim::Verdict::Holds,
        false => claim::Verdict::DoesNotHold(format!(
            "the second step adds {} of a sample of one step, the third and fourth {} each",
            digits(second / costs[0]),
            digits(fourth / costs[0])
        )),
    }
}
