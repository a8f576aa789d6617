//! `capwalk demo`: everything at once, on a scene that is hard for others.

use std::time::Instant;

use anyhow::Result;
use capwalk_render::{Estimator, GradientImage, GradientOptions, Options, WalkSettings};
use capwalk_scene::{builtin, params};
use serde_json::json;

use super::check::{self, Checked, Reference};
use super::gradient;
use crate::args::Demo;
use crate::diagnostics::Outcome;
use crate::output::{self, Files};
use crate::progress::Progress;
use crate::{console, moving, report};

const SCENE: &str = "lattice-shadow";

/// Half the scene's size: four times the samples in each pixel.
const SIZE: [u32; 2] = [128, 96];
/// Samples per pixel, chosen so that the check comes to a verdict within a
/// minute on two cores.
const SPP: u32 = 96;
/// Samples of the estimator that is only shown for its variance.
const LITERAL_SPP: u32 = 8;
/// Samples of the reference on each side of the difference.
const REFERENCE_SPP: u32 = 768;
const SEED: u64 = 1;

pub fn run(args: &Demo) -> Result<Outcome> {
    let started = Instant::now();
    let mut scene = builtin::scene(SCENE).expect("it is built in");
    scene.film.size = SIZE;
    scene.film.crop_size = SIZE;
    let parameter = builtin::default_parameter(SCENE).expect("it is built in");
    let motion = params::motion(&scene, parameter)?;
    let file = |name: &str, endings: &[&str]| {
        let stem = args.output.join(name).display().to_string();
        Files::new(&[], &stem, endings)
    };
    let picture_files = file(SCENE, &["exr", "png"])?;
    let gradient_files = file("lattice-shadow-gradient", &["exr", "png"])?;
    let check_files = file("lattice-shadow-check", &["png"])?;

    let options = |spp: u32| Options {
        spp,
        seed: SEED,
        threads: args.threads,
    };
    let progress = Progress::new("render", None);
    let rendering = capwalk_render::render(&scene, &options(SPP), &progress);
    let render_seconds = progress.finish().as_secs_f64();

    let settings = |estimator, spp| GradientOptions {
        options: options(spp),
        walk: WalkSettings {
            estimator,
            ..WalkSettings::default()
        },
    };
    let progress = Progress::new("literal", None);
    let literal = settings(Estimator::Literal, LITERAL_SPP);
    let literal = capwalk_render::gradient(&scene, &motion, &literal, &progress);
    progress.finish();
    let literal = literal?;

    let reference = Reference {
        step: moving::default_step(&scene, &motion),
        spp: REFERENCE_SPP,
    };
    let anchored = settings(Estimator::Anchored, SPP);
    let checked = check::check(&scene, &motion, &anchored, &reference, None)?;
    let Checked {
        gradient,
        reference: differences,
        comparison,
        ..
    } = &checked;

    let mut picture = output::picture("render", SCENE, None, &options(SPP));
    output::push_statistics(&mut picture, &[&rendering.statistics]);
    output::push_estimate(&mut picture, "value", "stderr", &rendering.value);
    let mut written = picture_files.write(&picture, &[])?;
    let picture = gradient::picture(SCENE, parameter, &checked.options, gradient);
    written.extend(gradient_files.write(&picture, &[])?);
    written.extend(check::picture::write(
        &check_files,
        SCENE,
        parameter,
        &checked,
    )?);

    let all = [
        &rendering.statistics,
        &literal.statistics,
        &gradient.statistics,
        &differences.statistics,
    ];
    for (what, statistics) in ["picture", "literal gradient", "gradient", "reference"]
        .iter()
        .zip(all)
    {
        console::remark(&report::warnings(what, statistics));
    }
    let variance =
        |image: &GradientImage| report::variance_per_sample(&image.gradient, &image.statistics);
    let queries = gradient.statistics.cone_queries as f64 / checked.seconds[0];
    let seconds = started.elapsed().as_secs_f64();
    if args.json {
        let document = json!({
            "scene": SCENE,
            "parameter": parameter,
            "comparison": check::comparison_json(comparison),
            "variance_per_sample": {
                "anchored": variance(gradient),
                "literal": variance(&literal),
            },
            "silhouette_queries_per_second": queries,
            "seconds": { "render": render_seconds, "gradient": checked.seconds[0],
                         "reference": checked.seconds[1], "all": seconds },
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        let [width, height] = SIZE;
        let variances = [
            ("anchored", report::number(variance(gradient))),
            ("literal", report::number(variance(&literal))),
        ];
        console::print(&format!(
            "{SCENE}, {width} x {height} pixels, derivative for {parameter}\n\n\
             {}\nvariance per sample\n{}\n\
             {} million silhouette queries per second, {} in all\n{}\n{}",
            check::describe(comparison),
            report::list(&variances),
            report::number(queries / 1e6),
            report::seconds(seconds),
            check::verdict(&checked),
            report::written(&written)
        ))?;
    }
    Ok(match report::outcome(&all) {
        Outcome::Done => check::outcome(comparison),
        trouble => trouble,
    })
}
