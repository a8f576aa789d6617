//! `capwalk backward`: the gradient of a loss with respect to many parameters.

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Result, bail, ensure};
use capwalk::params::shape_text;
use capwalk::scene_io::arrays::{self, Array, Arrays, LONGEST_NAME, METADATA};
use capwalk::text::{cut, listed};
use capwalk::{
    Choice, Distance, Error, FilesRead, GradientOptions, Gradients, Image, ImageLoss, Loss,
    ParameterGradient, Prepared, RenderOptions, Scene, read_layer,
};
use serde_json::{Value, json};

use crate::args::Backward;
use crate::diagnostics::Outcome;
use crate::memory::{self, Need};
use crate::progress::{self, Progress};
use crate::{console, method, output, report, source};

/// One of so many parts of a time limit is for the image that a loss is of: samples of
/// its gradient take several times as long.
const IMAGE_SHARE: u32 = 4;

pub fn run(args: &Backward) -> Result<Outcome> {
    let (prepared, mut read) = source::load(&args.scene)?;
    let scene = prepared.scene();
    memory::check(scene, Need::Loss)?;
    let names = match args.param.is_empty() {
        true => all_names(&prepared)?,
        false => args.param.clone(),
    };
    check_names(&names, args.errors)?;
    let sampling = source::options(&args.sampling, scene);
    // The image of a loss comes from the CPU.
    let on_device = RenderOptions {
        device: args.device,
        ..sampling
    };
    let options = method::options(on_device, &args.method)?;
    read.extend(
        &[&args.objective.adjoint, &args.target]
            .into_iter()
            .flatten()
            .collect(),
    );
    let file = output_file(args, &read)?;
    let given = given_image(args, scene)?;

    let loss = match args.objective.loss {
        None => None,
        Some(distance) => match measured(&prepared, distance, &given, &sampling, args)? {
            None => return report::nothing("every pixel of the image had a sample"),
            loss => loss,
        },
    };
    let adjoint = loss
        .as_ref()
        .map_or(&given, |loss| &loss.image.measured.adjoint);
    let rest = progress::left_of(args.sampling.time_limit);
    let progress = Progress::new("gradient", rest);
    let result = prepared.backward(adjoint, &names, &options, &progress);
    let elapsed = progress.finish().as_secs_f64();
    let gradients = result?;
    let (chosen, options) = (&gradients.chosen, gradients.chosen.options);
    let statistics = &gradients.statistics;
    console::remark(&report::remark_on_device(statistics));
    if statistics.samples == 0 {
        return report::nothing("a sample of the gradient was taken");
    }

    arrays::write(&file, &contents(args, &options, &gradients, loss.as_ref()))?;
    let written = vec![file.display().to_string()];
    let mut pieces = vec![statistics];
    if let Some(loss) = &loss {
        console::remark(&report::warnings("image", &loss.image.statistics));
        pieces.push(&loss.image.statistics);
    }
    method::log(chosen);
    console::remark(&method::remark(&options));
    console::remark(&report::warnings("gradient", statistics));
    if args.json {
        let document = json!({
            "scene": args.scene.scene,
            "set": source::settings_json(&args.scene),
            "size": scene.film.crop_size,
            "spp": options.spp,
            "seed": options.seed,
            "method": options.method.name(),
            "choice": method::choice_json(chosen),
            "device": statistics.device.name(),
            "loss": loss.as_ref().map(MeasuredLoss::to_json),
            "parameters": gradients.iter().map(to_json).collect::<Vec<_>>(),
            "statistics": report::statistics_json(statistics, elapsed),
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        console::print(&format!(
            "{}{}\n{}{}",
            loss.as_ref()
                .map(MeasuredLoss::describe)
                .unwrap_or_default(),
            report::work("gradient", statistics, elapsed),
            table(&gradients),
            report::written(&written)
        ))?;
    }
    Ok(report::outcome(&pieces))
}

/// All arrays with respect to which the gradient is not refused; warns of the others.
fn all_names(prepared: &Prepared) -> Result<Vec<String>> {
    let names = prepared.gradient_names();
    if let Some(refusal) = names.refusal {
        ensure!(
            !names.allowed.is_empty(),
            "nothing in this scene can be differentiated: {refusal}"
        );
        if !names.refused.is_empty() {
            let refused = listed(&names.refused);
            console::remark(&format!("warning: {refused} are left out: {refusal}\n"));
        }
    }
    Ok(names.allowed)
}

/// The array of standard errors of an array.
fn errors_name(name: &str) -> String {
    format!("{name}.stderr")
}

/// Each array of the file needs a name of its own.
fn check_names(names: &[String], errors: bool) -> Result<()> {
    let mut taken = HashSet::from([METADATA.to_owned()]);
    for name in names {
        let longest = match errors {
            true => errors_name(name).len(),
            false => name.len(),
        };
        ensure!(
            longest <= LONGEST_NAME,
            "an array of the output would have a name of {longest} bytes, \"{}\"; expected at most \
             {LONGEST_NAME}: give objects shorter ids, or ask for a shorter sum",
            cut(name)
        );
        ensure!(
            taken.insert(name.clone()) && (!errors || taken.insert(errors_name(name))),
            "two arrays of the output would have the name \"{name}\"; ask for it once, and give \
             objects different ids"
        );
    }
    Ok(())
}

/// Where the gradient goes; that it can be written there is known afterwards.
fn output_file(args: &Backward, read: &FilesRead) -> Result<PathBuf> {
    let default = || format!("{}-backward.npz", source::stem(&args.scene)).into();
    let file = args.output.clone().unwrap_or_else(default);
    read.refuse(&file).map_err(Error::from)?;
    // A wrong ending should not leave a folder behind.
    if file
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("npz"))
    {
        output::make_folder(&file)?;
    }
    match arrays::check_writable(&file) {
        Ok(()) => Ok(file),
        Err(error) => Err(error.into()),
    }
}

/// The adjoint or the target that was given.
fn given_image(args: &Backward, scene: &Scene) -> Result<Image> {
    let (file, defaults): (_, &[&str]) = match (&args.objective.adjoint, &args.target) {
        (Some(file), _) => (file, &["adjoint", "value"]),
        (None, Some(file)) => (file, &["value"]),
        (None, None) => bail!("neither --adjoint nor --target was given"),
    };
    let asked = args.layer.as_deref();
    let layers = asked.as_ref().map_or(defaults, std::slice::from_ref);
    Ok(read_layer(file, layers, scene.film.crop_size)?)
}

/// A loss that was asked for by name.
struct MeasuredLoss {
    distance: Distance,
    image: ImageLoss,
    /// How long its image took.
    elapsed: Duration,
}

/// The loss; `None` if it was stopped before every pixel had a sample.
fn measured(
    prepared: &Prepared,
    distance: Distance,
    target: &Image,
    sampling: &RenderOptions,
    args: &Backward,
) -> Result<Option<MeasuredLoss>> {
    let loss = Loss {
        distance,
        levels: 1,
    };
    let limit = progress::left_of(args.sampling.time_limit);
    let limit = limit.map(|limit| limit / IMAGE_SHARE);
    let progress = Progress::new("image", limit);
    let image = prepared.loss(&loss, target, None, sampling, &progress);
    let elapsed = progress.finish();
    match image {
        Ok(image) => Ok(Some(MeasuredLoss {
            distance,
            image,
            elapsed,
        })),
        Err(Error::Stopped { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

impl MeasuredLoss {
    /// Mean over pixels and channels of the image as it is, with its noise.
    fn value(&self) -> f64 {
        let measured = &self.image.measured;
        measured.value + measured.noise.unwrap_or(0.0)
    }

    /// What there is to say about it, in lines.
    fn describe(&self) -> String {
        let mut text = format!("loss ({}): {:.6e}", self.distance.name(), self.value());
        if let Some(noise) = self.image.measured.noise {
            let noise = report::significant(noise, 2);
            text += &format!(", of which about {noise} is noise of the image");
        }
        text += &format!("\nthe image has the seed {}\n", self.image.seed);
        let seconds = self.elapsed.as_secs_f64();
        report::work("image", &self.image.statistics, seconds) + &text
    }

    /// The report as JSON.
    fn to_json(&self) -> Value {
        let seconds = self.elapsed.as_secs_f64();
        json!({
            "name": self.distance.name(),
            "value": self.value(),
            "noise": self.image.measured.noise,
            "seed": self.image.seed,
            "statistics": report::statistics_json(&self.image.statistics, seconds),
        })
    }
}

fn to_json(gradient: &ParameterGradient) -> Value {
    match gradient.is_scalar() {
        true => json!({
            "name": gradient.name,
            "shape": gradient.shape,
            "value": gradient.size,
            "standard_error": gradient.size_error,
        }),
        false => json!({
            "name": gradient.name,
            "shape": gradient.shape,
            "norm": gradient.size,
            "standard_error": gradient.size_error,
            "noise": gradient.noise(),
        }),
    }
}

fn table(gradients: &Gradients) -> String {
    let mut rows = vec![
        ["", "shape", "norm or value", "standard error", "noise"]
            .map(String::from)
            .to_vec(),
    ];
    rows.extend(gradients.iter().map(|gradient| {
        let (shape, noise) = match gradient.is_scalar() {
            true => ("scalar".into(), String::new()),
            false => (
                shape_text(&gradient.shape),
                report::significant(gradient.noise(), 2),
            ),
        };
        vec![
            gradient.name.clone(),
            shape,
            report::significant(gradient.size, 4),
            report::significant(gradient.size_error, 2),
            noise,
        ]
    }));
    report::table(&rows)
}

/// The file: the gradient, its errors if they are wanted, and how it was made.
fn contents(
    args: &Backward,
    options: &GradientOptions,
    gradients: &Gradients,
    loss: Option<&MeasuredLoss>,
) -> Arrays {
    let mut metadata = output::origin("backward", &args.scene, &options.sampling());
    let mut note = |key: &str, value: String| metadata.push((key.to_owned(), value));
    let path = |path: &Path| path.display().to_string();
    note("method", options.method.name().into());
    if let Some(file) = &args.objective.adjoint {
        note("adjoint", path(file));
    }
    if let (Some(loss), Some(target)) = (loss, &args.target) {
        note("loss", loss.distance.name().into());
        note("target", path(target));
        note("loss_value", loss.value().to_string());
        note("image_seed", loss.image.seed.to_string());
    }
    let statistics = &gradients.statistics;
    let complete = statistics.complete && loss.is_none_or(|loss| loss.image.statistics.complete);
    note("samples", statistics.samples.to_string());
    note("complete", complete.to_string());
    note("non_finite_samples", statistics.non_finite.to_string());
    let mut arrays = Vec::new();
    for gradient in gradients {
        let mut push = |name: String, numbers: &[f64]| {
            arrays.push(Array {
                name,
                shape: gradient.shape.clone(),
                numbers: numbers.to_vec(),
            });
        };
        push(gradient.name.clone(), &gradient.numbers);
        if args.errors {
            push(errors_name(&gradient.name), &gradient.standard_errors);
        }
    }
    Arrays { arrays, metadata }
}
