//! `capwalk gradient`: the derivative of an image with respect to one parameter.

use anyhow::{Result, bail, ensure};
use capwalk::scene_io::image::LayeredImage;
use capwalk::{Device, DifferenceOptions, GradientImage, GradientOptions, RenderOptions};
use serde_json::json;

use crate::args::{Gradient, GradientOn, SceneArgs, TypedMethod};
use crate::diagnostics::Outcome;
use crate::memory::{self, Need};
use crate::output::{self, Files};
use crate::progress::{self, Progress};
use crate::{console, direction, method, report, source};

pub fn run(
    GradientOn {
        gradient: args,
        device,
    }: &GradientOn,
) -> Result<Outcome> {
    let (prepared, mut read) = source::load(&args.scene)?;
    let scene = prepared.scene();
    let tangent = direction::tangent(&prepared, &args.tangent, &mut read)?;
    let options = RenderOptions {
        adaptive: args.adaptive,
        device: *device,
        ..source::options(&args.sampling, scene)
    };
    memory::check(scene, Need::Gradient)?;
    let stem = format!("{}-gradient", source::stem(&args.scene));
    let files = Files::new(&args.output.output, &stem, &["exr", "png"], &read)?;
    let files = files.limited(args.colours.limit);

    let way = Way::new(args, options, || prepared.fine_difference_step(&tangent))?;
    let progress = Progress::new("gradient", progress::left_of(args.sampling.time_limit));
    let result = match way {
        Way::Samples(options) => prepared.gradient(&tangent, &options, &progress),
        Way::Differences { .. } if *device == Device::Gpu => {
            bail!("--method fd has no GPU: leave out --device, or take another method")
        }
        Way::Differences { step } => {
            let options = DifferenceOptions {
                spp: options.spp,
                adaptive: options.adaptive,
                seed: options.seed,
                step: Some(step),
            };
            prepared.finite_difference(&tangent, &options, &progress)
        }
    };
    let elapsed = progress.finish().as_secs_f64();
    let result = result?;

    let (value, gradient, statistics) = (&result.value, &result.gradient, &result.statistics);
    console::remark(&report::remark_on_device(statistics));
    if statistics.samples == 0 {
        return report::nothing("a sample of the gradient was taken");
    }
    let parameter = direction::describe(&args.tangent);
    let chosen = result.chosen.as_ref();
    let method = chosen.map_or("fd", |chosen| chosen.options.method.name());
    let mut layered = layered(&args.scene, &parameter, method, &options, &result);
    if let Some(step) = way.step() {
        output::note(&mut layered, "step", step);
    }
    output::note_device(&mut layered, statistics);
    let written = files.write(&layered, &[])?;
    match chosen {
        Some(chosen) => {
            method::log(chosen);
            console::remark(&method::remark(&chosen.options));
        }
        None => console::remark(method::remark_on_differences()),
    }
    console::remark(&report::warnings("gradient", statistics));
    let variance = report::variance_per_sample(gradient, statistics);
    if args.output.json {
        let document = json!({
            "scene": args.scene.scene,
            "set": source::settings_json(&args.scene),
            "parameter": parameter,
            "size": scene.film.crop_size,
            "spp": options.spp,
            "seed": options.seed,
            "method": method,
            "choice": chosen.map(method::choice_json),
            "step": way.step(),
            "device": statistics.device.name(),
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
            match variance.is_nan() {
                true => "- (at least two samples per pixel are needed)".into(),
                false => report::number(variance),
            },
            report::written(&written)
        ))?;
    }
    Ok(report::outcome(&[statistics]))
}

/// How the gradient is made.
enum Way {
    /// Samples are differentiated.
    Samples(GradientOptions),
    /// Images on both sides are subtracted.
    Differences {
        /// In units of the parameter.
        step: f64,
    },
}

impl Way {
    fn new(
        args: &Gradient,
        options: RenderOptions,
        default_step: impl Fn() -> f64,
    ) -> Result<Self> {
        let typed = method::typed(&args.method);
        if typed == TypedMethod::Fd {
            method::refuse_options_of_others(&args.method)?;
            let step = args.step.unwrap_or_else(default_step);
            return Ok(Self::Differences { step });
        }
        ensure!(
            args.step.is_none(),
            "--step is for finite differences, but the method is {}. Leave it out, or use \
             --method fd",
            typed.name()
        );
        Ok(Self::Samples(method::options(options, &args.method)?))
    }

    fn step(&self) -> Option<f64> {
        match self {
            Self::Samples(_) => None,
            Self::Differences { step } => Some(*step),
        }
    }
}

/// What the files of a gradient hold that was made by the method of this name.
pub fn layered(
    scene: &SceneArgs,
    parameter: &str,
    method: &str,
    options: &RenderOptions,
    result: &GradientImage,
) -> LayeredImage {
    let mut layered = output::layered("gradient", scene, Some(parameter), options);
    output::note(&mut layered, "method", method);
    output::push_statistics(&mut layered, &[&result.statistics]);
    output::push_estimate(&mut layered, "value", "value_stderr", &result.value);
    output::push_estimate(&mut layered, "gradient", "stderr", &result.gradient);
    layered
}
