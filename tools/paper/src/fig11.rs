//! Figure 11: derivatives of shadows, seen plainly and in a mirror,
//! beside explicit boundaries and Mitsuba's projective sampling.

use capwalk_diff::{Estimate, Method, WalkSettings, check};
use capwalk_scene::Image;
use capwalk_scene_io::image::Scale;

use crate::claim::{self, Claim, Measured, Verdict, digits};
use crate::figure::{Figure, Row, Table};
use crate::gradients::{Run, Subject, shown};
use crate::lattice;
use crate::projective::{self, Projective};
use crate::settings::{Failure, Settings};

/// A row of the figure.
struct Case {
    name: &'static str,
    subject: Subject,
    /// The shape that moves, and along which axis.
    moves: (&'static str, usize),
    spp: u32,
    difference_spp: u32,
}

pub fn draw(settings: &Settings) -> Result<Figure, Failure> {
    let quality = settings.quality;
    let [size, wide] = quality.choose(
        [[12, 9], [12, 5]],
        [[80, 60], [96, 40]],
        [[256, 192], [384, 160]],
    );
    let (spp, difference_spp) = quality.choose((16, 32), (256, 1024), (2048, 8192));
    let cases = [
        Case {
            name: "plain",
            subject: lattice::shadow(settings, size)?,
            moves: (lattice::shape(settings), 1),
            spp,
            difference_spp,
        },
        Case {
            name: "through a mirror",
            subject: lattice::in_mirror(wide)?,
            moves: ("lattice", 0),
            spp,
            difference_spp,
        },
    ];
    let mut figure = Figure {
        caption: format!(
            "Derivatives: the shadow of the {} by its y-translation, and the shadow of the Voronoi sphere \
             seen in a mirror by its x-translation. Finite differences ({difference_spp} samples per \
             pixel on each side), ours and the method `edges` ({spp} samples), and, where Python has \
             the package mitsuba, its projective sampling with its default guiding ({} times {} \
             samples).",
            lattice::name(settings),
            projective::SEEDS,
            projective::spp(settings)
        ),
        ..Figure::default()
    };
    let mut table = Table {
        title: "Against finite differences".into(),
        columns: vec!["view", "method", "agreement", "verdict", "CPU seconds"],
        rows: Vec::new(),
    };
    for (i, case) in cases.iter().enumerate() {
        draw_case(case, 20 * (i as u64 + 1), settings, &mut figure, &mut table)?;
    }
    figure.tables.push(table);
    Ok(figure)
}

fn draw_case(
    case: &Case,
    set: u64,
    settings: &Settings,
    figure: &mut Figure,
    table: &mut Table,
) -> Result<(), Failure> {
    let walk = WalkSettings::default();
    let subject = &case.subject;
    let difference = subject.difference(case.difference_spp, set, settings)?;
    let ours = subject.gradient(Method::FittedWalk, walk, case.spp, set + 1, settings)?;
    let edges = match subject.gradient(Method::EDGES, walk, case.spp, set + 2, settings) {
        Ok(run) => Ok(run),
        Err(Failure::Refused(refusal)) => Err(refusal.to_string()),
        Err(other) => return Err(other),
    };
    let projective = projective::run(subject, case.moves, settings)?;

    let rows = &mut table.rows;
    let line = |rows: &mut Vec<Vec<String>>, method: &str, estimate: &Estimate, seconds: f64| {
        let found = check::compare(estimate, difference.gradient());
        let verdict = claim::of_check(&found);
        rows.push(vec![
            case.name.into(),
            method.into(),
            claim::in_words(&found),
            verdict.to_string(),
            digits(seconds),
        ]);
        (found, verdict)
    };
    let (found, verdict) = line(rows, "ours", ours.gradient(), ours.seconds);
    figure.claims.push(Claim {
        statement: format!(
            "Figure 11, {}: our derivative matches finite differences",
            case.name
        ),
        paper: "“closely matches”".into(),
        ours: claim::in_words(&found),
        verdict,
    });
    let mut images = vec![
        ("finite differences".to_owned(), difference.gradient()),
        ("ours".to_owned(), ours.gradient()),
    ];
    match &edges {
        Ok(run) => {
            line(rows, "edges", run.gradient(), run.seconds);
            images.push(("edges".to_owned(), run.gradient()));
        }
        Err(reason) => rows.push(vec![
            case.name.into(),
            "edges".into(),
            "refused".into(),
            reason.clone(),
            String::new(),
        ]),
    }
    match &projective {
        Projective::Done {
            gradient,
            image,
            seconds,
        } => {
            line(rows, "projective sampling", gradient, *seconds);
            images.push(("projective sampling (Mitsuba)".to_owned(), gradient));
            figure.claims.push(projective_claim(
                case,
                [gradient, image],
                &ours,
                &difference,
            ));
        }
        Projective::NotThere(reason) => figure.claims.push(Claim {
            statement: statement(case),
            paper: "figure 11, by eye".into(),
            ours: "not run".into(),
            verdict: Verdict::Inconclusive(reason.clone()),
        }),
    }
    let limit = Scale::of([&ours.gradient().mean]).limit;
    figure.rows.push(Row::Images(shown(&images, limit)));
    Ok(())
}

fn statement(case: &Case) -> String {
    match case.name {
        "plain" => "Figure 11, plain: projective sampling deviates from finite differences".into(),
        _ => "Figure 11, through a mirror: projective sampling misses the shadow's tangent".into(),
    }
}

/// What the other method misses: everything in the mirror, something without.
fn projective_claim(
    case: &Case,
    [gradient, image]: [&Estimate; 2],
    ours: &Run,
    difference: &Run,
) -> Claim {
    let found = check::compare(gradient, difference.gradient());
    let share = part(gradient, ours.gradient(), difference.gradient());
    let (text, verdict) = match case.name {
        "plain" => (claim::in_words(&found), claim::of_deviation(&found)),
        _ => {
            let nearly_nothing = Measured::exact(0.1);
            (
                format!("it has {share} of what moves"),
                claim::below(share, nearly_nothing),
            )
        }
    };
    // A scene that it sees otherwise says nothing about its derivatives.
    let images = [&ours.image.value, &difference.image.value];
    let seen = part(image, images[0], images[1]);
    Claim {
        statement: statement(case),
        paper: "figure 11, by eye".into(),
        ours: text,
        verdict: match (seen.value - 1.0).abs() < 0.05 {
            true => verdict,
            false => Verdict::Inconclusive(format!("its image is {seen} times ours")),
        },
    }
}

/// How much of an image another one has: its product with one estimate of it, over
/// the product of two that are independent.
fn part(of: &Estimate, one: &Estimate, two: &Estimate) -> Measured {
    let product = |a: &Image, b: &Image| -> f64 {
        let pairs = a.pixels.iter().zip(&b.pixels);
        pairs.map(|(a, b)| a.dot(*b)).sum()
    };
    let whole = product(&one.mean, &two.mean);
    let pairs = of.standard_error.pixels.iter().zip(&one.mean.pixels);
    let variance: f64 = pairs
        .map(|(&error, &value)| (error * value).dot(error * value))
        .sum();
    Measured {
        value: product(&of.mean, &one.mean) / whole,
        error: variance.sqrt() / whole.abs(),
    }
}
