//! Methods at equal samples: what figures 1 and 9 have in common.

use capwalk_render::{Method, WalkSettings, WasSettings, check};
use capwalk_scene_io::image::{Style, robust_limit};

use crate::claim::{self, Claim, Measured, Verdict};
use crate::figure::{Figure, Row, Shown, Table};
use crate::gradients::{Run, Squares, Subject, l1_gain, mean_l1, mean_size, shown};
use crate::settings::{Failure, Settings};

/// What is compared, and what the paper says about it.
pub struct Comparison<'a> {
    pub subject: &'a Subject,
    /// "Figure 9".
    pub place: &'static str,
    /// What the paper says of the agreement with finite differences.
    pub agreement: &'static str,
    /// The paper's mean L1 errors of ours, WAS and PSDR-WAS, if it has any.
    pub errors: &'a [f64],
    /// Samples per pixel: of each method, of the reference, which is computed by
    /// [`Method::Edges`] and has the least noise, and of differences.
    pub spp: [u32; 3],
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
    let was = WasSettings::default();
    vec![
        ("ours", Method::Walk, Kind::Ours),
        ("ours on triangles", Method::TriangleWalk, Kind::Ours),
        ("WAS", Method::Was(was), Kind::Baseline),
        ("PSDR-WAS", Method::PsdrWas(was), Kind::Baseline),
        ("edges (beyond the paper)", Method::Edges, Kind::Beyond),
    ]
}

/// A method at equal samples, and its distance from the truth.
struct Compared {
    name: &'static str,
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
    let reference = subject.gradient(Method::Edges, walk, spp[1], 1, settings)?;
    let difference = subject.difference(spp[2], 2, settings)?;
    let mut compared = Vec::new();
    for (i, (name, method, kind)) in methods().into_iter().enumerate() {
        let run = subject.gradient(method, walk, spp[0], 3 + i as u64, settings)?;
        let against = check::compare(run.gradient(), difference.gradient());
        compared.push(Compared {
            name,
            kind,
            error: mean_l1(run.gradient(), reference.gradient()),
            squares: Squares::of(run.gradient(), reference.gradient()),
            factor: Measured {
                value: against.slope,
                error: against.slope_error,
            },
            run,
        });
    }

    let limit = robust_limit([&reference.gradient().mean]);
    let picture = Shown {
        title: "picture".into(),
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
        let title = format!(
            "{}, {} samples, L1 {error}",
            compared.name, compared.run.spp
        );
        (title, compared.run.gradient())
    });
    let below: Vec<_> = below.collect();
    Ok(Figure {
        rows: vec![
            Row::Pictures([vec![picture], shown(&above, limit)].concat()),
            Row::Pictures(shown(&below, limit)),
        ],
        tables: vec![table(&compared)],
        claims: claims(comparison, &compared, [&reference, &difference]),
        ..Figure::default()
    })
}

/// Ours agrees with differences, and has the least error at equal samples.
fn claims(
    comparison: &Comparison,
    compared: &[Compared],
    [reference, difference]: [&Run; 2],
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
    for ours in compared
        .iter()
        .filter(|compared| compared.kind == Kind::Ours)
    {
        let statement = format!(
            "{place}: the derivative by {} matches finite differences",
            ours.name
        );
        claims.push(agreement(statement, &ours.run));
    }
    let statement = format!("{place}: so does the reference of the errors below");
    claims.push(agreement(statement, reference));
    for other in compared
        .iter()
        .filter(|compared| compared.kind == Kind::Baseline)
    {
        let bias = other.squares.bias;
        claims.push(Claim {
            statement: format!("{place}: {} with 8 auxiliary rays is biased", other.name),
            paper: "“biased”, by eye".into(),
            ours: format!(
                "mean square of the bias {bias}, of noise {}",
                claim::digits(other.squares.noise)
            ),
            verdict: claim::below(Measured::exact(0.0), bias),
        });
    }
    let of = |kind: Kind| {
        compared
            .iter()
            .filter(move |compared| compared.kind == kind)
    };
    for ours in of(Kind::Ours) {
        for (i, other) in of(Kind::Baseline).enumerate() {
            claims.push(Claim {
                statement: format!(
                    "{place}: at equal samples the error of {} is below that of {}",
                    ours.name, other.name
                ),
                paper: match (comparison.errors.first(), comparison.errors.get(i + 1)) {
                    (Some(ours), Some(theirs)) => {
                        format!(
                            "mean L1 {ours} against {theirs} ({:.2} times)",
                            theirs / ours
                        )
                    }
                    _ => "by eye".into(),
                },
                ours: format!(
                    "mean L1 {} against {} ({} times)",
                    ours.error,
                    other.error,
                    other.error.over(ours.error)
                ),
                verdict: order(ours, other, reference),
            });
        }
    }
    claims
}

/// That the error of ours is below another one's, pixel by pixel.
fn order(ours: &Compared, other: &Compared, reference: &Run) -> Verdict {
    let gain = l1_gain(
        ours.run.gradient(),
        other.run.gradient(),
        reference.gradient(),
    );
    match claim::below(Measured::exact(0.0), gain) {
        Verdict::Holds => Verdict::Holds,
        Verdict::CouldNotTell(_) => {
            Verdict::CouldNotTell(format!("they differ by {gain}, pixel by pixel"))
        }
        _ => Verdict::DoesNotHold(format!(
            "{}; a picture of zeros has {}",
            noise_and_bias(&ours.squares, &other.squares),
            mean_size(reference.gradient())
        )),
    }
}

/// Why the error of an unbiased method is above that of a biased one.
fn noise_and_bias(ours: &Squares, other: &Squares) -> String {
    let [noise, others, bias] = [ours.noise, other.noise, other.bias.value.max(0.0)].map(f64::sqrt);
    let times = (noise / bias).powi(2);
    let until = match times.is_finite() && times > 1.0 {
        true => format!(
            ": {} times the samples would bring ours below it",
            claim::digits(times)
        ),
        false => String::new(),
    };
    let [noise, others, bias] = [noise, others, bias].map(claim::digits);
    format!(
        "the noise of ours is {noise} (root mean square), that of the other {others}, with a bias of \
         {bias}{until}"
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
            "seconds",
            "mean L1 error",
            "noise, root mean square",
            "bias, mean square",
            "best factor to differences",
        ],
        rows: rows.collect(),
    }
}
