//! Methods at equal samples: what figures 1 and 9 have in common.

use capwalk_diff::{Method, WalkSettings, check};
use capwalk_scene_io::image::{Scale, Style};

use crate::claim::{self, Claim, Measured, Verdict};
use crate::fields::{ON_TRIANGLES, WasSettings, psdr_was, was};
use crate::figure::{Figure, Row, Shown, Table};
use crate::gradients::{Run, Squares, Subject, l1_gain, mean_l1, mean_size, shown};
use crate::reach::{self, Reached};
use crate::settings::{Failure, Settings};

/// What is compared, and what the paper says about it.
pub struct Comparison<'a> {
    pub subject: &'a Subject,
    /// "Figure 9".
    pub place: &'static str,
    /// What the paper says of the agreement with finite differences.
    pub agreement: &'static str,
    /// The paper's errors, if it has any.
    pub errors: Option<Errors>,
    /// Samples per pixel: of each method, of the reference, which is computed by
    /// [`Method::Edges`] and has the least noise, and of differences.
    pub spp: [u32; 3],
}

/// The paper's mean L1 errors.
pub struct Errors {
    pub ours: f64,
    pub was: f64,
    pub psdr_was: f64,
}

impl Errors {
    fn of(&self, method: Method) -> f64 {
        match method.name() {
            "was" => self.was,
            "psdr-was" => self.psdr_was,
            _ => self.ours,
        }
    }
}

/// Whose a method is.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// The paper's own, in one of two domains.
    Ours,
    /// What it is compared with.
    Baseline,
    /// What the paper does not have.
    Beyond,
}

fn methods() -> Vec<(&'static str, Method, Kind)> {
    let default = WasSettings::default();
    vec![
        ("ours", Method::FittedWalk, Kind::Ours),
        ("ours on triangles", ON_TRIANGLES, Kind::Ours),
        ("WAS", was(default), Kind::Baseline),
        ("PSDR-WAS", psdr_was(default), Kind::Baseline),
        ("edges (beyond the paper)", Method::EDGES, Kind::Beyond),
    ]
}

/// A method at equal samples, and its distance from the truth.
struct Compared {
    name: &'static str,
    method: Method,
    kind: Kind,
    run: Run,
    /// Mean L1 error against the reference.
    error: Measured,
    /// What is noise and what is bias, in mean squares.
    squares: Squares,
    /// Against finite differences: how much is missing or too much.
    factor: Measured,
}

/// The figure but for its caption.
pub fn draw(comparison: &Comparison, settings: &Settings) -> Result<Figure, Failure> {
    let Comparison { subject, spp, .. } = comparison;
    let walk = WalkSettings::default();
    let reference = subject.gradient(Method::EDGES, walk, spp[1], 1, settings)?;
    let difference = subject.difference(spp[2], 2, settings)?;
    let mut compared = Vec::new();
    for (i, (name, method, kind)) in methods().into_iter().enumerate() {
        let run = subject.gradient(method, walk, spp[0], 3 + i as u64, settings)?;
        let against = check::compare(run.gradient(), difference.gradient());
        compared.push(Compared {
            name,
            method,
            kind,
            error: mean_l1(run.gradient(), reference.gradient()),
            squares: Squares::of(run.gradient(), reference.gradient()),
            factor: Measured {
                value: against.scale_factor,
                error: against.scale_factor_error,
            },
            run,
        });
    }

    let reaches = reach::measure(subject, 100, settings)?;

    let limit = Scale::of([&reference.gradient().mean]).limit;
    let image = Shown {
        title: "image".into(),
        image: reference.image.value.mean.clone(),
        style: Style::Photographic { exposure: 0.0 },
    };
    let above = [
        ("finite differences".into(), difference.gradient()),
        (
            format!("reference: edges, {} samples", reference.spp),
            reference.gradient(),
        ),
    ];
    let below = compared.iter().map(|compared| {
        let error = claim::digits(compared.error.value);
        let reach = match compared.method {
            Method::FittedWalk => format!(", reach {:.3} rad", compared.run.reach),
            _ => String::new(),
        };
        let title = format!(
            "{}{reach}, {} samples, L1 {error}",
            compared.name, compared.run.spp
        );
        (title, compared.run.gradient())
    });
    let below: Vec<_> = below.collect();
    Ok(Figure {
        rows: vec![
            Row::Images([vec![image], shown(&above, limit)].concat()),
            Row::Images(shown(&below, limit)),
        ],
        tables: vec![
            table(&compared),
            reach::table(
                &reaches,
                of(&compared, Kind::Baseline).map(|c| (c.name, &c.run)),
            ),
        ],
        claims: claims(comparison, &compared, [&reference, &difference], &reaches),
        ..Figure::default()
    })
}

fn of(compared: &[Compared], kind: Kind) -> impl Iterator<Item = &Compared> {
    compared
        .iter()
        .filter(move |compared| compared.kind == kind)
}

/// Ours agrees with differences, and has the least error at equal samples, that on
/// surfaces the most.
fn claims(
    comparison: &Comparison,
    compared: &[Compared],
    [reference, difference]: [&Run; 2],
    reaches: &[Reached],
) -> Vec<Claim> {
    let place = comparison.place;
    let agreement = |statement: String, run: &Run| {
        let found = check::compare(run.gradient(), difference.gradient());
        Claim {
            statement,
            paper: comparison.agreement.into(),
            ours: claim::in_words(&found),
            verdict: claim::of_check(&found),
        }
    };
    let mut claims = Vec::new();
    for ours in of(compared, Kind::Ours) {
        let statement = format!(
            "{place}: the derivative by {} matches finite differences",
            ours.name
        );
        claims.push(agreement(statement, &ours.run));
    }
    let statement = format!("{place}: so does the reference of the errors below");
    claims.push(agreement(statement, reference));
    for other in of(compared, Kind::Baseline) {
        let bias = other.squares.bias;
        claims.push(Claim {
            statement: format!("{place}: {} with 8 auxiliary rays is biased", other.name),
            paper: "“biased”, by eye".into(),
            ours: format!(
                "mean square of the bias {bias}, of noise {}",
                claim::digits(other.squares.noise)
            ),
            verdict: claim::positive(bias),
        });
    }
    let baselines = || of(compared, Kind::Baseline);
    let first =
        of(compared, Kind::Ours).flat_map(|ours| baselines().map(move |other| (ours, other)));
    let pairs = first.chain(baselines().zip(baselines().skip(1)));
    claims.extend(pairs.map(|(smaller, larger)| Claim {
        statement: format!(
            "{place}: at equal samples the error of {} is below that of {}",
            smaller.name, larger.name
        ),
        paper: match &comparison.errors {
            Some(errors) => {
                let [small, large] = [smaller, larger].map(|method| errors.of(method.method));
                format!(
                    "mean L1 {small} against {large} ({:.2} times)",
                    large / small
                )
            }
            None => "by eye".into(),
        },
        ours: format!(
            "mean L1 {} against {} ({} times)",
            smaller.error,
            larger.error,
            larger.error.over(smaller.error)
        ),
        verdict: order(smaller, larger, reference, reaches),
    }));
    claims
}

/// That the error of a method is below another one's, pixel by pixel.
fn order(smaller: &Compared, larger: &Compared, reference: &Run, reaches: &[Reached]) -> Verdict {
    let gain = l1_gain(
        smaller.run.gradient(),
        larger.run.gradient(),
        reference.gradient(),
    );
    // What limits walks on triangles is mostly their borders.
    let reach = match smaller.method {
        Method::FittedWalk => {
            let larger = (larger.name, larger.run.variance());
            reach::in_words(reaches, smaller.run.reach, larger)
        }
        _ => String::new(),
    };
    match claim::positive(gain) {
        Verdict::DoesNotHold(_) => Verdict::DoesNotHold(format!(
            "{}{reach}; an image of zeros has {}",
            noise_and_bias(smaller, larger),
            mean_size(reference.gradient())
        )),
        Verdict::Inconclusive(_) => {
            Verdict::Inconclusive(format!("they differ by {gain}, pixel by pixel{reach}"))
        }
        other => other,
    }
}

/// Why the error of a method is above another one's.
fn noise_and_bias(method: &Compared, other: &Compared) -> String {
    let parts = |of: &Compared| [of.squares.noise, of.squares.bias.value.max(0.0)];
    let [[noise, own], [others, bias]] = [parts(method), parts(other)];
    let [own, until] = match method.kind {
        // Without a bias of its own it is ahead where only that of the other is left.
        Kind::Ours | Kind::Beyond => {
            let times = noise / bias;
            let until = match times.is_finite() && times > 1.0 {
                true => format!(
                    ": {} times the samples would bring {} below it",
                    claim::digits(times),
                    method.name
                ),
                false => String::new(),
            };
            [String::new(), until]
        }
        Kind::Baseline => {
            let own = claim::digits(own.sqrt());
            [format!(" with a bias of {own}"), String::new()]
        }
    };
    let [noise, others, bias] = [noise, others, bias].map(|square| claim::digits(square.sqrt()));
    format!(
        "the noise of {} is {noise} (root mean square){own}, that of {} {others} with a bias of \
         {bias}{until}",
        method.name, other.name
    )
}

/// All methods at equal samples.
fn table(compared: &[Compared]) -> Table {
    let rows = compared.iter().map(|compared| {
        vec![
            compared.name.to_owned(),
            compared.run.spp.to_string(),
            claim::digits(compared.run.seconds),
            compared.error.to_string(),
            claim::digits(compared.squares.noise.sqrt()),
            compared.squares.bias.to_string(),
            compared.factor.to_string(),
        ]
    });
    Table {
        title: "Equal samples".into(),
        columns: vec![
            "method",
            "samples per pixel",
            "CPU seconds",
            "mean L1 error",
            "noise, root mean square",
            "bias, mean square",
            "best factor to differences",
        ],
        rows: rows.collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_diff::{Estimate, GradientImage, Statistics};
    use capwalk_math::Rgb;
    use capwalk_scene::Image;

    /// An image of noise of this size around a chessboard.
    fn run(noise: f64, seed: u64) -> Run {
        let image = |pixel: &dyn Fn(u64) -> f64| Image {
            width: 16,
            height: 16,
            pixels: (0..256).map(|i| Rgb::splat(pixel(i))).collect(),
        };
        let error = |i| 2.0 * noise * (crate::random::random([seed, i, 0, 0]) - 0.5);
        let gradient = Estimate {
            mean: image(&|i| f64::from(i as u32 % 2) + error(i)),
            standard_error: image(&|_| noise / 3_f64.sqrt()),
        };
        Run {
            image: GradientImage {
                chosen: None,
                value: gradient.clone(),
                gradient,
                statistics: Statistics::default(),
            },
            spp: 10,
            reach: 0.2,
            seconds: 1.0,
        }
    }

    /// Claims about methods with so much noise, in the order of [`methods`].
    fn claims_about(noise: [f64; 5]) -> Vec<Claim> {
        let subject = Subject::builtin("leaf", [4, 3], 1e-3).expect("it is built in");
        let comparison = Comparison {
            subject: &subject,
            place: "Figure 0",
            agreement: "",
            errors: Some(Errors {
                ours: 1.0,
                was: 2.0,
                psdr_was: 5.0,
            }),
            spp: [10; 3],
        };
        let reference = run(1e-4, 0);
        let mut seed = 0;
        let compared = methods().into_iter().zip(noise);
        let compared = compared.map(|((name, method, kind), noise)| {
            seed += 1;
            let run = run(noise, seed);
            Compared {
                name,
                method,
                kind,
                error: mean_l1(run.gradient(), reference.gradient()),
                squares: Squares::of(run.gradient(), reference.gradient()),
                factor: Measured::exact(1.0),
                run,
            }
        });
        let compared: Vec<_> = compared.collect();
        let reached = |reach, variance| Reached {
            reach,
            variance: Measured::exact(variance),
            run: run(1e-3, 9),
        };
        let reaches = [reached(0.2, 50.0), reached(0.0125, 1e-6)];
        claims(&comparison, &compared, [&reference, &reference], &reaches)
    }

    fn find<'a>(claims: &'a [Claim], order: &str) -> &'a Claim {
        let found = claims.iter().find(|claim| claim.statement.ends_with(order));
        found.unwrap_or_else(|| panic!("no claim that {order}"))
    }

    #[test]
    fn baselines_are_compared_with_each_other() {
        let order = "the error of WAS is below that of PSDR-WAS";
        let claims = claims_about([0.01, 0.01, 0.1, 0.2, 0.01]);
        let claim = find(&claims, order);
        assert_eq!(claim.verdict, Verdict::Holds);
        assert_eq!(claim.paper, "mean L1 2 against 5 (2.50 times)");
        let claims = claims_about([0.01, 0.01, 0.2, 0.1, 0.01]);
        let verdict = find(&claims, order).verdict.to_string();
        for part in ["does not hold", "noise of WAS", "that of PSDR-WAS"] {
            assert!(verdict.contains(part), "{part} in {verdict}");
        }
        let claims = claims_about([0.01, 0.01, 0.1, 0.1, 0.01]);
        let verdict = find(&claims, order).verdict.to_string();
        assert!(verdict.contains("inconclusive"), "{verdict}");
    }

    #[test]
    fn only_what_is_not_below_gets_a_reason() {
        let ours = "the error of ours is below that of WAS";
        let claims = claims_about([0.01, 0.01, 0.1, 0.2, 0.01]);
        assert_eq!(find(&claims, ours).verdict, Verdict::Holds);
        let claims = claims_about([0.2, 0.2, 0.1, 0.2, 0.01]);
        let verdict = find(&claims, ours).verdict.to_string();
        assert!(verdict.contains("0.0125 rad"), "{verdict}");
        let on_triangles = "the error of ours on triangles is below that of WAS";
        let verdict = find(&claims, on_triangles).verdict.to_string();
        assert!(!verdict.contains("rad"), "{verdict}");
    }
}
