//! Figure 9: a box in a room moves along x. Ours against finite differences, and
//! against warped-area sampling at equal samples.

use capwalk_render::{Method, WalkSettings, WasSettings, check};
use capwalk_scene_io::image::{Style, robust_limit};

use crate::claim::{self, Claim, Measured};
use crate::figure::{Figure, Row, Shown, Table};
use crate::gradients::{Run, Subject, mean_l1, shown};
use crate::settings::{Failure, Settings};

/// Half the distance of differences for a picture 256 pixels wide: a tenth of
/// a pixel. Outlines cross pixels linearly, so that is no bias.
const STEP: f64 = 1.5e-3;

/// The methods that are compared at equal samples.
pub fn methods() -> Vec<(&'static str, Method)> {
    vec![
        ("ours", Method::Walk),
        ("WAS", Method::Was(WasSettings::default())),
    ]
}

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let quality = settings.quality;
    let size = quality.choose([16, 12], [128, 96], [512, 384]);
    let spp = quality.choose(8, 32, 64);
    let (converged_spp, difference_spp) = quality.choose((16, 32), (256, 1024), (2048, 16_384));
    let subject = Subject::builtin("box-room", size, STEP * 256.0 / f64::from(size[0]))?;

    let walk = WalkSettings::default();
    let converged = subject.gradient(Method::Walk, walk, converged_spp, 1, settings)?;
    let difference = subject.difference(difference_spp, 2, settings)?;
    let mut compared = Vec::new();
    for (i, (name, method)) in methods().into_iter().enumerate() {
        let run = subject.gradient(method, walk, spp, 3 + i as u64, settings)?;
        compared.push(Compared::new(name, run, &converged, &difference));
    }

    let limit = robust_limit([&converged.gradient().mean]);
    let picture = Shown {
        title: "(a) picture".into(),
        image: converged.image.value.mean.clone(),
        style: Style::Photographic { exposure: 0.0 },
    };
    let above = [
        ("(b) differences".into(), difference.gradient()),
        ("(c) ours".into(), converged.gradient()),
    ];
    let letters = ["(d)", "(e)", "(f)"];
    let titles = compared.iter().zip(letters).map(|(compared, letter)| {
        let title = format!("{letter} {}, {} samples", compared.name, compared.run.spp);
        (title, compared.run.gradient())
    });
    let equal: Vec<_> = titles.collect();
    let rows = vec![
        Row::Pictures([vec![picture], shown(&above, limit)].concat()),
        Row::Pictures(shown(&equal, limit)),
    ];

    let comparison = check::compare(converged.gradient(), difference.gradient());
    let mut claims = vec![Claim {
        statement: "Figure 9 (b), (c): our derivative matches finite differences".into(),
        paper: "“closely matches”".into(),
        ours: claim::in_words(&comparison),
        verdict: claim::of_check(&comparison),
    }];
    claims.extend(equal_samples("Figure 9 (d) to (f)", &compared, &[]));
    Ok(Figure {
        caption: format!(
            "Derivative by the x-translation of the box, {} × {} pixels with a box filter, direct \
             light. (b) central differences over ±{:.2e} with {difference_spp} samples per pixel on \
             each side, (c) ours with {converged_spp}; below, equal samples, {spp} per pixel. Mean \
             L1 errors are against (c), whose agreement with (b) is tested first; baselines have 8 \
             auxiliary rays for every direction.",
            size[0], size[1], subject.step
        ),
        rows,
        tables: vec![table(&compared)],
        claims,
        ..Figure::default()
    })
}

/// A method at equal samples, and its distance from the truth.
pub struct Compared {
    pub name: &'static str,
    pub run: Run,
    /// Mean L1 error against a converged reference.
    pub error: Measured,
    /// Against finite differences: how much is missing or too much.
    factor: Measured,
}

impl Compared {
    pub fn new(name: &'static str, run: Run, reference: &Run, difference: &Run) -> Self {
        let comparison = check::compare(run.gradient(), difference.gradient());
        Self {
            name,
            error: mean_l1(run.gradient(), reference.gradient()),
            factor: Measured {
                value: comparison.slope,
                error: comparison.slope_error,
            },
            run,
        }
    }
}

/// That the first method has the least error at equal samples; `paper` are its
/// errors in the same order, if it gives any.
pub fn equal_samples(place: &str, compared: &[Compared], paper: &[f64]) -> Vec<Claim> {
    let (ours, others) = compared.split_first().expect("there is our method");
    let claims = others.iter().enumerate().map(|(i, other)| Claim {
        statement: format!(
            "{place}: at equal samples our error is below that of {}",
            other.name
        ),
        paper: match paper.get(i + 1) {
            Some(theirs) => format!("mean L1 {} against {theirs}", paper[0]),
            None => "by eye".into(),
        },
        ours: format!(
            "mean L1 {} against {} ({} times)",
            ours.error,
            other.error,
            other.error.over(ours.error)
        ),
        verdict: claim::below(ours.error, other.error),
    });
    claims.collect()
}

/// All methods at equal samples.
pub fn table(compared: &[Compared]) -> Table {
    let rows = compared.iter().map(|compared| {
        vec![
            compared.name.to_owned(),
            compared.run.spp.to_string(),
            claim::digits(compared.run.seconds),
            compared.error.to_string(),
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
            "factor to differences",
        ],
        rows: rows.collect(),
    }
}
