//! `capwalk demo`: everything at once, on a scene that is hard for others.

use std::time::{Duration, Instant};

use anyhow::Result;
use capwalk::scene::builtin;
use capwalk::{
    CheckOptions, Error, Estimator, GradientImage, GradientOptions, Method, Prepared,
    RenderOptions, Rendering, Tangent, WalkSettings, comparison_text,
};
use serde_json::json;

use super::check::{self, layers, timed};
use super::gradient;
use crate::args::{Demo, SceneArgs};
use crate::diagnostics::Outcome;
use crate::output::{self, Files};
use crate::progress::{Progress, left_of};
use crate::{console, report, source};

const SCENE: &str = "lattice-shadow";

/// Half the scene's size: four times the samples in each pixel.
const SIZE: [u32; 2] = [128, 96];
/// Samples per pixel, chosen so that the check comes to a verdict within a
/// minute on two cores.
const SPP: u32 = 96;
/// One sample for so many of `SPP` goes to the estimator that is only shown for
/// its variance, but never fewer than have one.
const LITERAL_SHARE: u32 = 12;
const LEAST_FOR_VARIANCE: u32 = 2;
/// Samples of the reference on each side of the difference, for each of `SPP`:
/// the lattice's fine structure makes differences noisy.
const REFERENCE_FACTOR: u32 = 8;
const SEED: u64 = 1;

/// When the image and the literal gradient must be done, as shares of a time
/// limit; the check has the rest. Without a limit each takes less than a tenth
/// of the time.
const IMAGE_UNTIL: f64 = 0.1;
const LITERAL_UNTIL: f64 = 0.2;

/// What the demo works out.
struct Results {
    rendering: Rendering,
    literal: GradientImage,
    checked: timed::Checked,
    /// Seconds for the image, the literal gradient, and everything.
    seconds: [f64; 3],
}

pub fn run(args: &Demo) -> Result<Outcome> {
    let scene_args = SceneArgs {
        scene: SCENE.into(),
        size: Some(args.size.unwrap_or(SIZE)),
        ..SceneArgs::default()
    };
    let (prepared, read) = source::load(&scene_args)?;
    let parameter = builtin::default_parameter(SCENE).expect("it is built in");
    let scene = prepared.scene();
    let tangent = prepared.registry().tangent(scene, parameter)?;
    let file = |what: &str| {
        let stem = args.output.join(format!("{SCENE}{what}"));
        Files::new(&[], &stem.display().to_string(), &["exr", "png"], &read)
    };
    let [image_files, gradient_files, check_files] =
        [file("")?, file("-gradient")?, file("-check")?];

    let results = work(args, &prepared, &tangent)?;
    let Results {
        rendering,
        literal,
        checked,
        seconds,
    } = &results;
    let (check, options) = (&checked.check, checked.chosen.options.sampling());
    let gradient = &check.gradient;

    let mut layered = output::layered("render", &scene_args, None, &options);
    output::push_statistics(&mut layered, &[&rendering.statistics]);
    output::push_estimate(&mut layered, "value", "stderr", &rendering.value);
    let mut written = image_files.write(&layered, &[])?;
    let layered = gradient::layered(
        &scene_args,
        parameter,
        checked.chosen.options.method.name(),
        &options,
        gradient,
    );
    written.extend(gradient_files.write(&layered, &[])?);
    let of_check = layers::write(&check_files, &scene_args, parameter, checked)?;
    written.extend(of_check);

    let all = [
        &rendering.statistics,
        &literal.statistics,
        &gradient.statistics,
        &check.reference.statistics,
    ];
    for (what, statistics) in ["image", "literal gradient", "gradient", "reference"]
        .iter()
        .zip(all)
    {
        console::remark(&report::warnings(what, statistics));
    }
    let variance =
        |image: &GradientImage| report::variance_per_sample(&image.gradient, &image.statistics);
    let queries = gradient.statistics.cone_queries as f64 / checked.seconds[0];
    if args.json {
        let document = json!({
            "scene": SCENE,
            "parameter": parameter,
            "size": scene.film.crop_size,
            "spp": options.spp,
            "seed": options.seed,
            "literal_spp": literal_spp(options.spp),
            "reference_spp": check.made.spp,
            "step": check.made.step,
            "comparison": check::comparison_json(&check.comparison),
            "variance_per_sample": {
                "auto": variance(gradient),
                "literal": variance(literal),
            },
            "silhouette_queries_per_second": queries,
            "render": report::statistics_json(&rendering.statistics, seconds[0]),
            "literal": report::statistics_json(&literal.statistics, seconds[1]),
            "gradient": report::statistics_json(&gradient.statistics, checked.seconds[0]),
            "reference": report::statistics_json(all[3], checked.seconds[1]),
            "seconds": seconds[2],
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        let [width, height] = scene.film.crop_size;
        let variances = [
            (
                checked.chosen.options.method.name(),
                report::number(variance(gradient)),
            ),
            ("walk, literal", report::number(variance(literal))),
        ];
        console::print(&format!(
            "{SCENE}, {width} x {height} pixels, derivative for {parameter}\n\n\
             {}\nvariance per sample\n{}\n\
             {} million silhouette queries per second, {} in all\n{}\n{}",
            comparison_text(&check.comparison),
            report::list(&variances),
            report::number(queries / 1e6),
            report::seconds(seconds[2]),
            check::verdict(check),
            report::written(&written)
        ))?;
    }
    Ok(match report::outcome(&all) {
        Outcome::Done => check::outcome(&check.comparison),
        trouble => trouble,
    })
}

/// The image, the literal gradient, and the check, one after the other. Each
/// has what the earlier ones left of its share of what preparation leaves of a time limit.
fn work(args: &Demo, prepared: &Prepared, tangent: &Tangent) -> Result<Results> {
    let sampling = &args.sampling;
    let sampled = |spp: u32| RenderOptions::new(spp, sampling.seed.unwrap_or(SEED));
    let spp = sampling.spp.unwrap_or(SPP);
    let options = CheckOptions {
        gradient: sampled(spp).into(),
        reference_spp: Some(spp.saturating_mul(REFERENCE_FACTOR)),
        step: None,
    };

    let progress = Progress::new("prepare", left_of(sampling.time_limit));
    let work = prepared.gradient_work(tangent, &options.gradient)?;
    let is_prepared = work.prepare(&progress);
    progress.finish();
    is_prepared.map_err(Error::from)?;

    let limit = left_of(sampling.time_limit);
    let started = Instant::now();
    let left_until = |share| left(limit, share, started.elapsed());

    let progress = Progress::new("render", left_until(IMAGE_UNTIL));
    let rendering = prepared.render(&sampled(spp), &progress)?;
    let render_seconds = progress.finish().as_secs_f64();

    let progress = Progress::new("literal", left_until(LITERAL_UNTIL));
    let literal = GradientOptions {
        method: Method::Walk,
        walk: WalkSettings {
            estimator: Estimator::Literal,
            ..WalkSettings::default()
        },
        ..sampled(literal_spp(spp)).into()
    };
    let literal = prepared.gradient(tangent, &literal, &progress);
    let literal_seconds = progress.finish().as_secs_f64();
    let literal = literal?;

    let checked = timed::check(prepared, tangent, &options, left_until(1.0))?;
    Ok(Results {
        rendering,
        literal,
        checked,
        seconds: [
            render_seconds,
            literal_seconds,
            started.elapsed().as_secs_f64(),
        ],
    })
}

/// What is left of a share of the time limit after so long; nothing if that is
/// over.
fn left(limit: Option<Duration>, share: f64, elapsed: Duration) -> Option<Duration> {
    Some(limit?.mul_f64(share).saturating_sub(elapsed))
}

/// Samples of the literal estimator beside so many of the other.
fn literal_spp(spp: u32) -> u32 {
    (spp / LITERAL_SHARE).max(LEAST_FOR_VARIANCE)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a stage does not use is left to those after it, and a stage that
    /// takes too long leaves less, never a limit of its own.
    #[test]
    fn stages_share_the_time_limit() {
        let seconds = Duration::from_secs;
        let limit = Some(seconds(100));
        assert_eq!(left(None, IMAGE_UNTIL, seconds(5)), None);
        assert_eq!(left(limit, IMAGE_UNTIL, seconds(0)), Some(seconds(10)));
        assert_eq!(left(limit, LITERAL_UNTIL, seconds(3)), Some(seconds(17)));
        assert_eq!(left(limit, 1.0, seconds(20)), Some(seconds(80)));
        assert_eq!(left(limit, LITERAL_UNTIL, seconds(30)), Some(seconds(0)));
    }
}
