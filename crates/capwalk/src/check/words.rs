//! What a check says, in words.

use capwalk_diff::GradientImage;
use capwalk_diff::check::{Comparison, Verdict};

use super::Check;
use crate::edge_on::EdgeOnFace;
use crate::text::{count, list, number, plus_minus, significant};

/// How many of the worst pixels are shown.
const SHOWN_PIXELS: usize = 4;

/// Pairs of shapes, and faces, that are named, at most.
const SHOWN_PAIRS: usize = 5;

impl Check {
    /// What follows, in a sentence. `option` writes an option as the reader would give it:
    /// its name, `step` or `spp`, and its value if it should have one.
    pub fn verdict(&self, option: impl Fn(&str, Option<u64>) -> String) -> String {
        // Samples that were really taken: the work may have been stopped.
        let taken = |image: &GradientImage| {
            let statistics = &image.statistics;
            statistics.samples as f64 / statistics.samples_per_pixel.len() as f64
        };
        let [spp, reference_spp] = [taken(&self.gradient), taken(&self.reference)];
        match &self.comparison.verdict {
            Verdict::Right if self.comparison.scale_factor.is_nan() => {
                "right: both are zero everywhere: nothing in the image changes".into()
            }
            Verdict::Right => {
                "right: they agree, and a factor wrong by 10 % would have been seen".into()
            }
            Verdict::Wrong { reason } => {
                let step = option("step", None);
                format!(
                    "wrong: {reason}\n(if a smaller {step} changes this, the reference is at fault)"
                )
            }
            Verdict::Inconclusive { .. } if spp.min(reference_spp) < 2.0 => {
                "inconclusive: standard errors need at least two samples per pixel".into()
            }
            Verdict::Inconclusive {
                samples_factor,
                doubt,
            } => {
                let enough = |spp: f64| Some((spp * samples_factor).ceil() as u64);
                let needed = || {
                    format!(
                        "about {} times the samples would be enough ({} {})",
                        significant(*samples_factor, 2),
                        option("spp", enough(spp)),
                        option("reference-spp", enough(reference_spp))
                    )
                };
                let what = match (doubt, samples_factor.is_finite()) {
                    (Some(doubt), true) => format!("{doubt}; {}", needed()),
                    (Some(doubt), false) => doubt.clone(),
                    (None, true) => needed(),
                    (None, false) => "the gradient shows no derivative, only noise".into(),
                };
                format!("inconclusive: {what}")
            }
        }
    }
}

/// The first of these things by their names, and how many more of that kind there are.
fn first<T>(things: &[T], kind: &str, name: impl Fn(&T) -> String) -> String {
    let names: Vec<String> = things.iter().take(SHOWN_PAIRS).map(name).collect();
    let more = match things.len().saturating_sub(SHOWN_PAIRS) {
        0 => String::new(),
        n => format!(" and {n} more {kind}"),
    };
    names.join(", ") + &more
}

/// What is to be said about shapes that lie on each other and move against each other: a line,
/// or nothing.
pub fn coplanar_text(pairs: &[[String; 2]]) -> String {
    let names = first(pairs, "pairs", |[a, b]| format!("\"{a}\" and \"{b}\""));
    match pairs {
        [] => String::new(),
        _ => format!(
            "note: {names} have faces in one plane that overlap, and move against each other: \
             where that is seen the image has no derivative: one of them comes out of the plane of \
             the other, or which of them is in front is up to rounding. Move them apart a little\n"
        ),
    }
}

/// What is to be said about shapes that lie with an edge on others and move off them: a line, or
/// nothing.
pub fn touching_text(pairs: &[[String; 2]]) -> String {
    let names = first(pairs, "pairs", |[a, b]| format!("\"{a}\" on \"{b}\""));
    match pairs {
        [] => String::new(),
        _ => format!(
            "note: an edge lies on another shape and moves off it ({names}): where that is seen the \
             image has no derivative: to one side of the motion a gap opens, to the other they cross or \
             overlap. Move them apart a little, or into each other\n"
        ),
    }
}

/// What is to be said about faces that the camera sees edge-on and moves against: a line, or nothing.
pub fn edge_on_text(faces: &[EdgeOnFace]) -> String {
    let names = first(faces, "faces", |EdgeOnFace { shape, face }| {
        format!("face {face} of \"{shape}\"")
    });
    match faces {
        [] => String::new(),
        _ => format!(
            "note: the camera sees {names} exactly edge-on, and moves against that: where it is seen \
             the image has no derivative: one side of it comes into view to one side of the motion, the \
             other to the other. Move the camera a little\n"
        ),
    }
}

/// The best factor from gradient to reference, or that none can be told.
fn scale_factor(c: &Comparison) -> String {
    match c.knows_scale_factor() {
        true => {
            let factor = plus_minus(c.scale_factor, c.scale_factor_error);
            format!("{factor} (reference / gradient)")
        }
        false => "- (the gradient is too noisy to say by which factor it is off)".into(),
    }
}

/// The numbers of a comparison, one on each line; `-` stands for what images
/// without noise, or of zeros, do not have.
pub fn comparison_text(c: &Comparison) -> String {
    let worst = c.worst.iter().take(SHOWN_PIXELS);
    let worst: Vec<String> = worst
        .map(|(x, y, z)| format!("({x}, {y}) {z:.1}"))
        .collect();
    let worst = match worst.is_empty() {
        true => "-".into(),
        false => worst.join(", "),
    };
    let if_any = |x: f64, text: String| if x.is_nan() { "-".into() } else { text };
    let mut lines = vec![
        (
            "relative L1",
            format!(
                "{} (noise alone: {})",
                number(c.relative_l1),
                number(c.relative_l1_of_noise)
            ),
        ),
        (
            "correlation",
            if_any(c.correlation, format!("{:.4}", c.correlation)),
        ),
        ("scale factor", if_any(c.scale_factor, scale_factor(c))),
        (
            "mean z²",
            format!(
                "{} over {} pixels with noise",
                if_any(
                    c.mean_z_squared,
                    plus_minus(c.mean_z_squared, c.mean_z_squared_error)
                ),
                count(c.pixels as u64)
            ),
        ),
        (
            "plain mean z²",
            format!(
                "{} (all pixels alike; off 1 where noise is rare events)",
                if_any(c.mean_z_squared_plain, number(c.mean_z_squared_plain))
            ),
        ),
        (
            "sign",
            if_any(c.sign, format!("{:+.2} standard errors", c.sign)),
        ),
        ("worst z", worst),
    ];
    if c.left_out > 0 {
        lines.push((
            "left out",
            format!("{} pixels without a standard error", c.left_out),
        ));
    }
    list(&lines)
}
