//! Figure 10: the number of steps at equal time, on the shadow of a lattice.

use capwalk_diff::{Method, WalkSettings};
use capwalk_math::Moments;
use capwalk_scene_io::image::Scale;

use crate::claim::{self, Claim, Measured, Verdict, digits};
use crate::figure::{Figure, Row, Table};
use crate::gradients::{Run, mean_l1, mean_size, shown};
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
    let reference_spp = quality.choose(16, 512, 4000);
    let subject = lattice::shadow(settings, size)?;
    let walk = |steps: u32| WalkSettings {
        steps,
        ..WalkSettings::default()
    };
    let reference = subject.gradient(Method::EDGES, walk(1), reference_spp, 1, settings)?;

    // Seconds per sample, measured by turns so that a slow phase of the machine
    // slows all of them; without what is done once.
    let rounds = quality.choose(2, 8, 12);
    let pilot = (spp / 12).max(2);
    let mut costs = [Moments::default(); 3];
    for round in 0..rounds {
        for (cost, steps) in costs.iter_mut().zip(STEPS) {
            let seconds = |spp: u32| -> Result<f64, Failure> {
                let set = 100 + round;
                let run = subject.gradient(Method::FittedWalk, walk(steps), spp, set, settings)?;
                Ok(run.seconds)
            };
            let (once, all) = (seconds(1)?, seconds(1 + pilot)?);
            cost.add((all - once) / f64::from(pilot));
        }
    }
    let costs = costs.map(Measured::from);
    let unclear = costs.iter().any(|cost| cost.z(0.0) < 3.0);
    let mut runs: Vec<(u32, Run, Measured)> = Vec::new();
    for (i, steps) in STEPS.into_iter().enumerate() {
        let samples = f64::from(spp) * costs[0].value / costs[i].value;
        // Without a meaning where times are unclear, but never endless.
        let samples = (samples.round() as u32).clamp(2, 4 * spp);
        let set = 10 + i as u64;
        let run = subject.gradient(Method::FittedWalk, walk(steps), samples, set, settings)?;
        let error = mean_l1(run.gradient(), reference.gradient());
        runs.push((steps, run, error));
    }

    let limit = Scale::of([&reference.gradient().mean]).limit;
    let mut images = vec![("reference".into(), reference.gradient())];
    for (steps, run, error) in &runs {
        let title = format!(
            "M = {steps}, {} samples, L1 {}",
            run.spp,
            digits(error.value)
        );
        images.push((title, run.gradient()));
    }
    let rows = vec![Row::Images(shown(&images, limit))];
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
            "CPU seconds",
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
                "{one}, {two} ({} times), {four} ({} times); an image of zeros has {}",
                two.over(one),
                four.over(one),
                mean_size(reference.gradient())
            ),
            verdict: match unclear || !equal_times(&runs) {
                true => Verdict::Inconclusive("the times are not equal enough".into()),
                false => claim::all([claim::below(one, two), claim::below(one, four)]),
            },
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
                costs[1].over(costs[0]),
                costs[2].over(costs[0])
            ),
            verdict: match unclear {
                true => Verdict::Inconclusive("the times are too noisy".into()),
                false => linear(costs),
            },
        },
    ];
    Ok(Figure {
        caption: format!(
            "Derivative of the shadow of the {} by its y-translation, {} × {} pixels. Samples are chosen for the time \
             of {spp} samples of one step. Mean L1 errors are against the method `edges` with {reference_spp} \
             samples, whose own noise is part of all of them; figure 1 tests that it is right.",
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

/// True if no run took more than a quarter longer than another.
fn equal_times(runs: &[(u32, Run, Measured)]) -> bool {
    let seconds = runs.iter().map(|(_, run, _)| run.seconds);
    let least = seconds.clone().fold(f64::INFINITY, f64::min);
    seconds.fold(0.0, f64::max) <= 1.25 * least
}

/// That each further step costs the same, within a third.
fn linear(costs: [Measured; 3]) -> Verdict {
    const TOLERANCE: f64 = 1.0 / 3.0;
    let difference = |a: Measured, b: Measured, steps: f64| Measured {
        value: (b.value - a.value) / steps,
        error: b.error.hypot(a.error) / steps,
    };
    let [one, two, four] = costs;
    let ratio = difference(two, four, 2.0).over(difference(one, two, 1.0));
    let text = format!("a third or fourth step costs {ratio} times a second one");
    if (ratio.value - 1.0).abs() + 3.0 * ratio.error < TOLERANCE {
        Verdict::Holds
    } else if (ratio.value - 1.0).abs() - 3.0 * ratio.error > TOLERANCE {
        Verdict::DoesNotHold(text)
    } else {
        Verdict::Inconclusive(text)
    }
}
