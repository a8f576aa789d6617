//! `capwalk gradient`: the derivative of a picture for one parameter.

use anyhow::Result;
use capwalk_render::{GradientImage, Options};
use capwalk_scene_io::image::Picture;
use serde_json::json;

use crate::args::Gradient;
use crate::diagnostics::Outcome;
use crate::output::{self, Files};
use crate::progress::Progress;
use crate::{console, moving, report, source};

pub fn run(args: &Gradient) -> Result<Outcome> {
    let scene = source::load(&args.scene)?;
    let motion = moving::motion(&scene, &args.motion)?;
    let options = source::options(&args.sampling, &scene);
    let stem = format!("{}-gradient", source::stem(&args.scene));
    let files = Files::new(&args.output.output, &stem, &["exr", "png"])?;

    let progress = Progress::new("gradient", args.sampling.time_limit);
    let settings = source::gradient_options(options, &args.walk);
    let result = capwalk_render::gradient(&scene, &motion, &settings, &progress);
    let elapsed = progress.finish().as_secs_f64();
    let result = result?;

    let (value, gradient, statistics) = (&result.value, &result.gradient, &result.statistics);
    let parameter = moving::describe(&args.motion);
    let name = &args.scene.scene;
    let picture = picture(name, &parameter, &options, &result);
    let written = files.write(&picture, &[])?;
    console::remark(&report::warnings("gradient", statistics));
    let variance = report::variance_per_sample(gradient, statistics);
    if args.output.json {
        let document = json!({
            "scene": args.scene.scene,
            "parameter": parameter,
            "size": scene.film.crop_size,
            "spp": options.spp,
            "seed": options.seed,
            "mean": report::mean_colour(&value.mean),
            "mean_gradient": report::mean_colour(&gradient.mean),
            "variance_per_sample": variance,
            "statistics": report::statistics_json(statistics, elapsed),
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        console::print(&format!(
            "{}variance per sample: {}\n{}",
            report::work("gradient", statistics, elapsed),
            report::number(variance),
            report::written(&written)
        ))?;
    }
    Ok(report::outcome(&[statistics]))
}

/// What the files of a gradient hold.
pub fn picture(scene: &str, parameter: &str, options: &Options, result: &GradientImage) -> Picture {
    let mut picture = output::picture("gradient", scene, Some(parameter), options);
    output::push_statistics(&mut picture, &[&result.statistics]);
    output::push_estimate(&mut picture, "value", "value_stderr", &result.value);
    output::push_estimate(&mut picture, "gradient", "stderr", &result.gradient);
    picture
}
