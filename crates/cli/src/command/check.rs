//! `capwalk check`: a gradient against finite differences, with a verdict.

pub mod picture;

use std::time::{Duration, Instant};

use anyhow::{Result, ensure};
use capwalk_diff::check::{Comparison, Verdict, compare, without_rounding};
use capwalk_diff::{GradientImage, GradientOptions, Options, Prepared};
use capwalk_scene::{Motion, Scene};
use serde_json::{Value, json};

use crate::args::{Check, MethodName};
use crate::diagnostics::Outcome;
use crate::output::Files;
use crate::progress::Progress;
use crate::{console, method, moving, report, source};

/// Samples of the reference for each one of the gradient, if nothing is said:
/// differences are cheaper, and noisier.
const REFERENCE_FACTOR: u32 = 4;

/// Makes the reference's random numbers independent of the gradient's.
const REFERENCE_SEED: u64 = 0x9e37_79b9_7f4a_7c15;

/// How many of the worst pixels are shown.
const SHOWN_PIXELS: usize = 4;

/// A gradient, its reference, and how they compare.
pub struct Checked {
    pub gradient: GradientImage,
    pub reference: GradientImage,
    pub comparison: Comparison,
    /// How the gradient was sampled.
    pub options: Options,
    /// The name of its method.
    pub method: &'static str,
    /// How the reference was made.
    pub differences: Reference,
    /// Seconds for the gradient and for the reference.
    pub seconds: [f64; 2],
}

/// How to make the reference.
#[derive(Clone, Copy)]
pub struct Reference {
    /// Step of the central differences, in units of the parameter.
    pub step: f64,
    /// Samples per pixel on each side.
    pub spp: u32,
}

impl Reference {
    /// How the reference is sampled beside a gradient with these options.
    fn options(self, gradient: &Options) -> Options {
        Options {
            spp: self.spp,
            seed: gradient.seed ^ REFERENCE_SEED,
            ..*gradient
        }
    }
}

pub fn run(args: &Check) -> Result<Outcome> {
    let typed = &args.gradient;
    let scene = source::load(&typed.scene)?;
    let motion = moving::motion(&scene, &typed.motion)?;
    let options = source::options(&typed.sampling, &scene);
    let stem = format!("{}-check", source::stem(&typed.scene));
    let files = Files::new(&typed.output.output, &stem, &["png"])?;
    let reference = Reference {
        step: typed
            .step
            .unwrap_or_else(|| moving::default_step(&scene, &motion)),
        spp: args
            .reference_spp
            .unwrap_or(options.spp.saturating_mul(REFERENCE_FACTOR)),
    };
    ensure!(
        typed.method.method != MethodName::Fd,
        "check compares with finite differences: with --method fd there is nothing to check. Use \
         another method, or `compare` for pictures of `gradient` with different steps"
    );
    let settings = method::gradient_options(options, &typed.method)?;
    let limit = typed.sampling.time_limit;
    let checked = check(&scene, &motion, &settings, &reference, limit)?;
    let comparison = &checked.comparison;
    let (gradient, differences) = (&checked.gradient.statistics, &checked.reference.statistics);

    let parameter = moving::describe(&typed.motion);
    let written = picture::write(&files, &typed.scene.scene, &parameter, &checked)?;
    console::remark(&method::remark(&typed.method));
    console::remark(&report::warnings("gradient", gradient));
    console::remark(&report::warnings("reference", differences));
    if typed.output.json {
        let document = json!({
            "scene": typed.scene.scene,
            "parameter": parameter,
            "size": scene.film.crop_size,
            "spp": options.spp,
            "seed": options.seed,
            "method": checked.method,
            "reference_spp": reference.spp,
            "step": reference.step,
            "comparison": comparison_json(comparison),
            "gradient": report::statistics_json(gradient, checked.seconds[0]),
            "reference": report::statistics_json(differences, checked.seconds[1]),
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        console::print(&format!(
            "{}{}reference: central differences over ± {}\n\n{}{}\n{}",
            report::work("gradient", gradient, checked.seconds[0]),
            report::work("reference", differences, checked.seconds[1]),
            report::number(reference.step),
            describe(comparison),
            verdict(&checked),
            report::written(&written)
        ))?;
    }
    Ok(match report::outcome(&[gradient, differences]) {
        Outcome::Done => outcome(comparison),
        trouble => trouble,
    })
}

/// Estimates a gradient and its reference with independent random numbers, and
/// compares them. Half of a time limit is for the gradient.
pub fn check(
    scene: &Scene,
    motion: &Motion,
    settings: &GradientOptions,
    reference: &Reference,
    limit: Option<Duration>,
) -> Result<Checked> {
    let started = Instant::now();
    let progress = Progress::new("gradient", limit.map(|limit| limit / 2));
    let gradient =
        capwalk_diff::gradient(&Prepared::new(scene.clone()), motion, settings, &progress);
    let gradient_seconds = progress.finish().as_secs_f64();
    let gradient = gradient?;

    let rest = limit.map(|limit| limit.saturating_sub(started.elapsed()));
    let progress = Progress::new("reference", rest);
    let options = reference.options(&settings.options);
    let differences =
        capwalk_diff::finite_difference(scene, motion, reference.step, &options, &progress);
    let reference_seconds = progress.finish().as_secs_f64();
    let mut differences = differences?;
    differences.gradient = without_rounding(&differences, reference.step);
    Ok(Checked {
        comparison: compare(&gradient.gradient, &differences.gradient),
        gradient,
        reference: differences,
        options: settings.options,
        method: settings.method.name(),
        differences: *reference,
        seconds: [gradient_seconds, reference_seconds],
    })
}

/// The numbers of a comparison, one on each line; `-` stands for what pictures
/// without noise, or of zeros, do not have.
pub fn describe(c: &Comparison) -> String {
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
                report::number(c.relative_l1),
                report::number(c.relative_l1_of_noise)
            ),
        ),
        (
            "correlation",
            if_any(c.correlation, format!("{:.4}", c.correlation)),
        ),
        (
            "slope",
            format!(
                "{} (reference / gradient)",
                if_any(c.slope, report::plus_minus(c.slope, c.slope_error))
            ),
        ),
        (
            "mean z²",
            format!(
                "{} over {} pixels with noise",
                if_any(
                    c.mean_z_squared,
                    report::plus_minus(c.mean_z_squared, c.mean_z_squared_error)
                ),
                report::count(c.pixels as u64)
            ),
        ),
        (
            "plain mean z²",
            format!(
                "{} (all pixels alike; off 1 where noise is rare events)",
                if_any(
                    c.mean_z_squared_plain,
                    report::number(c.mean_z_squared_plain)
                )
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
    report::list(&lines)
}

/// What follows, in a sentence.
pub fn verdict(checked: &Checked) -> String {
    // Samples that were really taken: the work may have been stopped.
    let taken = |image: &GradientImage| {
        let statistics = &image.statistics;
        statistics.samples as f64 / statistics.samples_per_pixel.len() as f64
    };
    let (spp, reference_spp) = (taken(&checked.gradient), taken(&checked.reference));
    match &checked.comparison.verdict {
        Verdict::Right if checked.comparison.slope.is_nan() => {
            "right: both are zero everywhere: nothing in the picture changes".into()
        }
        Verdict::Right => {
            "right: they agree, and a factor wrong by 10 % would have been seen".into()
        }
        Verdict::Wrong { reason } => {
            format!(
                "wrong: {reason}\n(if a smaller --step changes this, the reference is at fault)"
            )
        }
        Verdict::CouldNotTell { .. } if spp.min(reference_spp) < 2.0 => {
            "could not tell: standard errors take at least two samples per pixel".into()
        }
        Verdict::CouldNotTell { samples_factor } if samples_factor.is_finite() => format!(
            "could not tell: about {} times the samples would be enough (--spp {} \
             --reference-spp {})",
            report::significant(*samples_factor, 2),
            (spp * samples_factor).ceil(),
            (reference_spp * samples_factor).ceil()
        ),
        Verdict::CouldNotTell { .. } => {
            "could not tell: there is no derivative to be seen, only noise".into()
        }
    }
}

/// How a command ends that came to this comparison.
pub fn outcome(comparison: &Comparison) -> Outcome {
    match comparison.verdict {
        Verdict::Right => Outcome::Done,
        Verdict::Wrong { .. } => Outcome::Wrong,
        Verdict::CouldNotTell { .. } => Outcome::CouldNotTell,
    }
}

/// All numbers of a comparison.
pub fn comparison_json(c: &Comparison) -> Value {
    let (verdict, reason, samples_factor) = match &c.verdict {
        Verdict::Right => ("right", None, None),
        Verdict::Wrong { reason } => ("wrong", Some(reason), None),
        Verdict::CouldNotTell { samples_factor } => ("could not tell", None, Some(samples_factor)),
    };
    json!({
        "verdict": verdict,
        "reason": reason,
        "samples_factor": samples_factor,
        "relative_l1": c.relative_l1,
        "relative_l1_of_noise": c.relative_l1_of_noise,
        "correlation": c.correlation,
        "mean_z_squared": c.mean_z_squared,
        "mean_z_squared_error": c.mean_z_squared_error,
        "mean_z_squared_plain": c.mean_z_squared_plain,
        "pixels": c.pixels,
        "left_out": c.left_out,
        "sign": c.sign,
        "slope": c.slope,
        "slope_error": c.slope_error,
        "worst": c.worst.iter().map(|&(x, y, z)| json!({"x": x, "y": y, "z": z})).collect::<Vec<_>>(),
    })
}
