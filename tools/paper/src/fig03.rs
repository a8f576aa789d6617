//! Figure 3: the toy of Section 3.3, an integral whose derivative is 1, by the
//! fields that the paper compares.

use capwalk_math::Moments;
use capwalk_walk::{Estimator, WalkSettings, sample_field};
use rayon::prelude::*;

use crate::claim::{self, Claim, Measured, Verdict, digits};
use crate::figure::{Curve, Figure, Plot, Row, Scale, Table};
use crate::random::random;
use crate::settings::{Failure, Settings};
use crate::walk::interval::{End, Interval};
use crate::walk::random_step::{ShellSettings, sample_harmonic};
use crate::walk::weighted_average::WeightedAverage;

/// A way to build a field.
#[derive(Clone, Copy)]
enum Construction {
    /// Eq. (7), its integrals by quadrature.
    Average,
    /// Eq. (7) from this many auxiliary points.
    Ratio(u32),
    /// Eq. (12).
    Harmonic,
    /// Eq. (20).
    Steps(u32),
}

impl Construction {
    fn name(self) -> String {
        match self {
            Self::Average => "weighted average".into(),
            Self::Ratio(points) => format!("weighted average, {points} points"),
            Self::Harmonic => "harmonic".into(),
            Self::Steps(steps) => format!("M = {steps}"),
        }
    }

    /// A sample of the field and its divergence at `x`.
    fn sample(self, x: f64, number: impl Fn(u32) -> f64) -> (f64, f64) {
        let velocity = |end: &End| match end {
            End::Left => 0.0,
            End::Right => 1.0,
        };
        let field = WeightedAverage::default();
        match self {
            Self::Average => field.value_and_derivative(x),
            Self::Ratio(points) => field.estimate(x, (0..points).map(|i| 2.0 * number(i))),
            Self::Harmonic => {
                let settings = ShellSettings {
                    estimator: Estimator::Anchored,
                    ..ShellSettings::default()
                };
                let walk = sample_harmonic(&Interval, x, &settings, number);
                let walk = walk.expect("walks between two ends arrive");
                walk.sample.evaluate(velocity)
            }
            Self::Steps(steps) => {
                let settings = WalkSettings {
                    steps,
                    max_radius: 1.0,
                    ..WalkSettings::default()
                };
                sample_field(&Interval, x, &settings, number).evaluate(velocity)
            }
        }
    }

    /// Field and divergence over the interval.
    fn curves(self, settings: &Settings, samples: u64) -> [Curve; 2] {
        const POINTS: u64 = 100;
        let samples = match self {
            Self::Average => 1,
            _ => samples,
        };
        let points = (0..POINTS).into_par_iter().map(|i| {
            let x = (i as f64 + 0.5) / POINTS as f64;
            let [mut value, mut derivative] = [Moments::default(); 2];
            for k in 0..samples {
                let number = |d: u32| random([settings.seed, i, k, u64::from(d)]);
                let (v, dv) = self.sample(x, number);
                value.add(v);
                derivative.add(dv);
            }
            [value, derivative].map(|moments| {
                let error = moments.standard_error();
                [x, moments.mean, if error.is_nan() { 0.0 } else { error }]
            })
        });
        let points: Vec<[[f64; 3]; 2]> = points.collect();
        [0, 1].map(|k| Curve {
            name: self.name(),
            points: points.iter().map(|point| point[k]).collect(),
        })
    }

    /// Eq. (11) from uniform points of the interval.
    fn integral(self, settings: &Settings, samples: u64) -> Moments {
        let mut moments = Moments::default();
        for i in 0..samples {
            let number = |d: u32| random([settings.seed, 1 << 32, i, u64::from(d)]);
            let x = number(u32::MAX);
            moments.add(self.sample(x, number).1);
        }
        moments
    }
}

/// The smallest part of the interval that holds 90 % of the divergence.
fn support(divergence: &Curve) -> f64 {
    let mut sizes: Vec<f64> = divergence.points.iter().map(|p| p[1].abs()).collect();
    sizes.sort_by(|a, b| b.total_cmp(a));
    let all: f64 = sizes.iter().sum();
    let mut sum = 0.0;
    let enough = sizes.iter().take_while(|&&size| {
        let before = sum;
        sum += size;
        before < 0.9 * all
    });
    enough.count() as f64 / sizes.len() as f64
}

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    use Construction::{Average, Harmonic, Ratio, Steps};
    let quality = settings.quality;
    let per_point = quality.choose(200, 10_000, 100_000);
    let samples = quality.choose(2_000, 200_000, 2_000_000);
    let watch = (settings.stages)("toy");

    let (before, ours) = ([Average, Harmonic], [Steps(1), Steps(4), Steps(16)]);
    let curves = |these: &[Construction]| -> Vec<[Curve; 2]> {
        these
            .iter()
            .map(|c| c.curves(settings, per_point))
            .collect()
    };
    let (before_curves, our_curves) = (curves(&before), curves(&ours));
    if watch.should_stop() {
        return Err(Failure::Stopped);
    }
    let plot = |title: &str, curves: &[[Curve; 2]], k: usize| Plot {
        title: title.into(),
        axes: ["x".into(), ["v", "∂v/∂x"][k].into()],
        scale: Scale::Linear,
        curves: curves.iter().map(|pair| pair[k].clone()).collect(),
    };
    let step = Curve {
        name: "y".into(),
        points: vec![
            [0.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.6, 0.0, 0.0],
        ],
    };
    let rows = vec![
        Row::Plots(vec![Plot {
            title: "(a) the step function, its end at θ = 1 moves".into(),
            axes: ["x".into(), "y".into()],
            scale: Scale::Linear,
            curves: vec![step],
        }]),
        Row::Plots(vec![
            plot("(b) velocity, earlier and harmonic", &before_curves, 0),
            plot("(c) velocity, fixed steps", &our_curves, 0),
        ]),
        Row::Plots(vec![
            plot("(b) divergence, earlier and harmonic", &before_curves, 1),
            plot("(c) divergence, fixed steps", &our_curves, 1),
        ]),
    ];

    let all = [Average, Ratio(8), Harmonic, Steps(1), Steps(4), Steps(16)];
    let integrals: Vec<Moments> = all
        .par_iter()
        .map(|construction| {
            // A sample of the quadrature costs as much as a hundred others.
            let share = if matches!(construction, Average) {
                10
            } else {
                1
            };
            construction.integral(settings, samples / share)
        })
        .collect();
    if watch.should_stop() {
        return Err(Failure::Stopped);
    }
    let of = |wanted: &dyn Fn(&Construction) -> bool| -> Vec<Measured> {
        let pairs = all.iter().zip(&integrals);
        let found = pairs.filter(|(construction, _)| wanted(construction));
        found.map(|(_, &moments)| moments.into()).collect()
    };
    let valid = of(&|c| !matches!(c, Ratio(_)));
    let ratio = of(&|c| matches!(c, Ratio(_)))[0];
    let supports = [&before_curves[0], &our_curves[0], &before_curves[1]].map(|c| support(&c[1]));
    let [average, one_step, harmonic] = supports;

    let claims = vec![
        Claim {
            statement: "Section 3.3: all valid fields lead to the same derivative".into(),
            paper: "∂I/∂θ = 1".into(),
            ours: in_list(&all, &integrals, |c| !matches!(c, Ratio(_))),
            verdict: claim::all_equal(&valid, 1.0, 0.05),
        },
        Claim {
            statement: "Section 3.2: the estimator of earlier work is biased".into(),
            paper: "E[1/f] ≠ 1/E[f]".into(),
            ours: format!("with 8 auxiliary points {ratio} instead of 1"),
            verdict: differs(ratio, 1.0),
        },
        Claim {
            statement: "Section 3.3: the divergence of earlier fields has a narrow support, \
                        fixed steps widen it, the harmonic field's is everywhere the same"
                .into(),
            paper: "figure 3, curves".into(),
            ours: format!(
                "90 % of the divergence in {:.0} % of the interval (weighted average), {:.0} % \
                 (M = 1), {:.0} % (harmonic; 90 % is all there can be)",
                100.0 * average,
                100.0 * one_step,
                100.0 * harmonic
            ),
            verdict: match average < one_step && one_step < harmonic {
                true => Verdict::Holds,
                false => Verdict::DoesNotHold("the order is another".into()),
            },
        },
        straight(&before_curves[1][1], &integrals[2]),
    ];
    let rows_of_table = all.iter().zip(&integrals).map(|(construction, &moments)| {
        vec![
            construction.name(),
            Measured::from(moments).to_string(),
            digits(moments.variance()),
        ]
    });
    let tables = vec![Table {
        title: "Derivative of the integral".into(),
        columns: vec!["field", "∂I/∂θ", "variance of a sample"],
        rows: rows_of_table.collect(),
    }];
    Ok(Figure {
        caption: format!(
            "A step function ends at θ = 1; the derivative of its integral is 1. Left, the weighted \
             average of earlier work (Eqs. 7 and 8; σ = 0.1, third power as in its programs) and the \
             harmonic field by walks of random length (Eqs. 16 and 17); right, fixed steps (Eq. 20) \
             with the anchored estimator. {per_point} walks at each point; bars are two standard \
             errors."
        ),
        rows,
        tables,
        claims,
        ..Figure::default()
    })
}

fn in_list(
    all: &[Construction],
    integrals: &[Moments],
    wanted: impl Fn(&Construction) -> bool,
) -> String {
    let pairs = all.iter().zip(integrals).filter(|(c, _)| wanted(c));
    let texts = pairs.map(|(c, &moments)| format!("{} ({})", Measured::from(moments), c.name()));
    texts.collect::<Vec<_>>().join(", ")
}

/// That a number is not another.
fn differs(number: Measured, expected: f64) -> Verdict {
    match claim::all_equal(&[number], expected, f64::INFINITY) {
        Verdict::Holds => Verdict::Inconclusive(format!("{number} may be {expected}")),
        _ => Verdict::Holds,
    }
}

/// The harmonic field's divergence is constant, so that its exact values would
/// have no variance; walks have.
fn straight(divergence: &Curve, integral: &Moments) -> Claim {
    let points: Vec<Measured> = divergence
        .points
        .iter()
        .map(|&[_, value, error]| Measured { value, error })
        .collect();
    Claim {
        statement: "Section 3.3: the harmonic field's divergence is constant, so that estimating \
                    the integral of its exact values has zero variance"
            .into(),
        paper: "v(x) = x".into(),
        ours: format!(
            "constant within errors at {} points; walks add a variance of {}",
            points.len(),
            digits(integral.variance())
        ),
        verdict: claim::all_equal(&points, 1.0, 0.2),
    }
}
