//! `capwalk check`: a gradient against finite differences, with a verdict.

pub mod layers;
pub mod timed;

use anyhow::{Result, ensure};
use capwalk::{
    Check, CheckOptions, Comparison, RenderOptions, Statistics, Verdict, comparison_text,
    coplanar_text, edge_on_text, touching_text,
};
use serde_json::{Value, json};

use crate::args::{self, TypedMethod};
use crate::diagnostics::Outcome;
use crate::memory::{self, Need};
use crate::output::Files;
use crate::{console, direction, method, progress, report, source};

pub fn run(args: &args::Check) -> Result<Outcome> {
    let typed = &args.gradient;
    let (prepared, mut read) = source::load(&typed.scene)?;
    let scene = prepared.scene();
    memory::check(scene, Need::Check)?;
    let tangent = direction::tangent(&prepared, &typed.tangent, &mut read)?;
    // What decides are the noisiest pixels.
    let sampling = RenderOptions {
        adaptive: true,
        ..source::options(&typed.sampling, scene)
    };
    let stem = format!("{}-check", source::stem(&typed.scene));
    let files =
        Files::new(&typed.output.output, &stem, &["png"], &read)?.limited(typed.colours.limit);
    ensure!(
        method::typed(&typed.method) != TypedMethod::Fd,
        "check compares with finite differences: with --method fd there is nothing to check. Use \
         another method, or `compare` for images of `gradient` with different steps"
    );
    let options = CheckOptions {
        gradient: method::options(sampling, &typed.method)?,
        reference_spp: args.reference_spp,
        step: typed.step,
    };
    let limit = progress::left_of(typed.sampling.time_limit);
    let checked = timed::check(&prepared, &tangent, &options, limit)?;
    let Check {
        gradient,
        reference,
        comparison,
        made,
        references,
        reference_samples,
        coplanar,
        edge_on,
        touching,
        ..
    } = &checked.check;
    let (of_gradient, of_reference) = (&gradient.statistics, &reference.statistics);

    let parameter = direction::describe(&typed.tangent);
    let written = layers::write(&files, &typed.scene, &parameter, &checked)?;
    method::log(&checked.chosen);
    console::remark(&coplanar_text(coplanar));
    console::remark(&touching_text(touching));
    console::remark(&edge_on_text(edge_on));
    console::remark(&method::remark(&options.gradient));
    console::remark(&report::warnings("gradient", of_gradient));
    console::remark(&report::warnings("reference", of_reference));
    if typed.output.json {
        let document = json!({
            "scene": typed.scene.scene,
            "set": source::settings_json(&typed.scene),
            "parameter": parameter,
            "size": scene.film.crop_size,
            "spp": sampling.spp,
            "seed": sampling.seed,
            "method": checked.chosen.options.method.name(),
            "choice": method::choice_json(&checked.chosen),
            "reference_spp": made.spp,
            "step": made.step,
            "sides": made.sides.name(),
            "references": references,
            "reference_samples": reference_samples,
            "comparison": comparison_json(comparison),
            "coplanar": coplanar,
            "touching": touching,
            "edge_on": edge_on.iter().map(|at| json!({"shape": at.shape, "face": at.face})).collect::<Vec<_>>(),
            "gradient": report::statistics_json(of_gradient, checked.seconds[0]),
            "reference": report::statistics_json(of_reference, checked.seconds[1]),
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        let of_all = Statistics {
            samples: *reference_samples,
            ..Statistics::default()
        };
        console::print(&format!(
            "{}{}reference: {}\n\n{}{}\n{}",
            report::work("gradient", of_gradient, checked.seconds[0]),
            report::work("reference", &of_all, checked.seconds[1]),
            reference_text(&checked.check),
            comparison_text(comparison),
            verdict(&checked.check),
            report::written(&written)
        ))?;
    }
    Ok(match report::outcome(&[of_gradient, of_reference]) {
        Outcome::Done => outcome(comparison),
        trouble => trouble,
    })
}

/// Which differences decided, in words.
fn reference_text(check: &Check) -> String {
    let of = match check.references {
        1 => "",
        2 => " (one of two references)",
        3 => " (one of three references)",
        4 => " (one of four references)",
        5 => " (one of five references)",
        _ => " (one of six references)",
    };
    format!("{}{of}", check.made.describe())
}

/// What follows, in a sentence that names options of the command line.
pub fn verdict(check: &Check) -> String {
    check.verdict(|option, value| match value {
        None => format!("--{option}"),
        Some(value) => format!("--{option} {value}"),
    })
}

/// How a command ends that came to this comparison.
pub fn outcome(comparison: &Comparison) -> Outcome {
    match &comparison.verdict {
        Verdict::Right => Outcome::Done,
        Verdict::Wrong { .. } => Outcome::Wrong,
        Verdict::Inconclusive { .. } => Outcome::Inconclusive,
    }
}

/// All numbers of a comparison.
pub fn comparison_json(c: &Comparison) -> Value {
    let (name, reason, samples_factor) = match &c.verdict {
        Verdict::Right => ("right", None, None),
        Verdict::Wrong { reason } => ("wrong", Some(reason), None),
        Verdict::Inconclusive {
            samples_factor,
            doubt,
        } => ("inconclusive", doubt.as_ref(), Some(samples_factor)),
    };
    json!({
        "verdict": name,
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
        "scale_factor": c.scale_factor,
        "scale_factor_error": c.scale_factor_error,
        "worst": c.worst.iter().map(|&(x, y, z)| json!({"x": x, "y": y, "z": z})).collect::<Vec<_>>(),
    })
}
