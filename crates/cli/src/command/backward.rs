//! `capwalk backward`: the gradient of a loss by many parameters.

mod objective;

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use anyhow::{Result, bail, ensure};
use capwalk_diff::{GradientOptions, Prepared, Wanted};
use capwalk_scene::params::{ArrayParameter, Registry, Request};
use capwalk_scene::{Motion, Scene};
use capwalk_scene_io::arrays::{self, Array, Arrays, METADATA};
use serde_json::{Value, json};

use crate::args::Backward;
use crate::diagnostics::Outcome;
use crate::progress::{self, Progress};
use crate::{console, method, moving, output, report, source};
use objective::{Loss, Objective};

pub fn run(args: &Backward) -> Result<Outcome> {
    let scene = source::load(&args.scene)?;
    let (parameters, left_out) = match args.param.is_empty() {
        true => all_parameters(&scene)?,
        false => (parameters(&scene, &args.param)?, String::new()),
    };
    console::remark(&left_out);
    check_names(&parameters, args.errors)?;
    let options = source::options(&args.sampling, &scene);
    let settings = method::gradient_options(options, &args.method)?;
    let file = output_file(args)?;
    let read = objective::read(args, &scene)?;

    let Some(objective) = objective::objective(args, &scene, &options, read)? else {
        return nothing("every pixel of the picture had a sample");
    };
    let Objective { adjoint, loss } = objective;
    let rest = args.sampling.time_limit.map(|limit| {
        let used = loss.as_ref().map(Loss::elapsed).unwrap_or_default();
        limit.saturating_sub(used)
    });
    let progress = Progress::new("gradient", rest);
    let wanted = wanted(&scene, &parameters);
    let result = capwalk_diff::backward(
        &Prepared::new(scene.clone()),
        &adjoint,
        &wanted,
        &settings,
        &progress,
    );
    let elapsed = progress.finish().as_secs_f64();
    let result = result?;
    let statistics = &result.statistics;
    if statistics.samples == 0 {
        return nothing("a sample of the gradient was taken");
    }

    let gradients: Vec<Gradient> = parameters
        .iter()
        .map(|parameter| Gradient::new(&scene, parameter, &result))
        .collect();
    arrays::write(
        &file,
        &contents(args, &settings, &gradients, loss.as_ref(), statistics),
    )?;
    let written = vec![file.display().to_string()];
    let mut pieces = vec![statistics];
    if let Some(loss) = &loss {
        console::remark(&report::warnings("picture", &loss.statistics));
        pieces.push(&loss.statistics);
    }
    console::remark(&method::remark(&args.method));
    console::remark(&report::warnings("gradient", statistics));
    if args.json {
        let document = json!({
            "scene": args.scene.scene,
            "size": scene.film.crop_size,
            "spp": options.spp,
            "seed": options.seed,
            "method": settings.method.name(),
            "loss": loss.as_ref().map(Loss::to_json),
            "parameters": gradients.iter().map(Gradient::to_json).collect::<Vec<_>>(),
            "statistics": report::statistics_json(statistics, elapsed),
            "files": written,
        });
        console::print_json(&document)?;
    } else {
        console::print(&format!(
            "{}{}\n{}{}",
            loss.as_ref().map(Loss::describe).unwrap_or_default(),
            report::work("gradient", statistics, elapsed),
            table(&gradients),
            report::written(&written)
        ))?;
    }
    Ok(report::outcome(&pieces))
}

/// How it ends if it was stopped too early to write anything.
fn nothing(before: &str) -> Result<Outcome> {
    if !progress::interrupted() {
        bail!("the time limit ended before {before}; nothing was written. Give more time");
    }
    console::remark(&format!("stopped before {before}; nothing was written\n"));
    Ok(Outcome::Interrupted)
}

/// Something to differentiate by, under the name that was typed.
struct Parameter {
    name: String,
    request: Request,
}

/// All arrays that can be differentiated by, under their first names, and a
/// warning that names the others.
fn all_parameters(scene: &Scene) -> Result<(Vec<Parameter>, String)> {
    let registry = Registry::new(scene);
    let arrays = registry.arrays().iter();
    let first_names = arrays.filter(|array| array.alias_of.is_none()).cloned();
    let parameters = |arrays: Vec<ArrayParameter>| -> Vec<Parameter> {
        let arrays = arrays.into_iter();
        let parameter = |array: ArrayParameter| Parameter {
            name: array.name.clone(),
            request: Request::Array(array),
        };
        arrays.map(parameter).collect()
    };
    let Some(refusal) = capwalk_diff::refusal(&Prepared::new(scene.clone())) else {
        return Ok((parameters(first_names.collect()), String::new()));
    };
    let (refused, others): (Vec<_>, Vec<_>) =
        first_names.partition(|array| array.moves_discontinuities);
    ensure!(
        !others.is_empty(),
        "nothing in this scene can be differentiated: {refusal}"
    );
    let names: Vec<&str> = refused.iter().map(|array| array.name.as_str()).collect();
    let left_out = match names.is_empty() {
        true => String::new(),
        false => format!("warning: {} are left out: {refusal}\n", names.join(", ")),
    };
    Ok((parameters(others), left_out))
}

/// What was asked for.
fn parameters(scene: &Scene, names: &[String]) -> Result<Vec<Parameter>> {
    let registry = Registry::new(scene);
    let mut parameters = Vec::new();
    for name in names {
        let request = registry.request(scene, name)?;
        if let Request::Motion(motion) = &request {
            ensure!(
                !moving::is_zero(motion),
                "nothing moves: the parameters in \"{name}\" add up to zero"
            );
        }
        let name = name.clone();
        parameters.push(Parameter { name, request });
    }
    Ok(parameters)
}

/// The array of standard errors of an array.
fn errors_name(name: &str) -> String {
    format!("{name}.stderr")
}

/// Each array of the file needs a name of its own.
fn check_names(parameters: &[Parameter], errors: bool) -> Result<()> {
    let mut names = HashSet::from([METADATA.to_owned()]);
    for Parameter { name, .. } in parameters {
        ensure!(
            names.insert(name.clone()) && (!errors || names.insert(errors_name(name))),
            "two arrays of the output would be called \"{name}\"; ask for it once, and give \
             things with equal ids different ones"
        );
    }
    Ok(())
}

/// Where the gradient goes; that it can be written there is known afterwards.
fn output_file(args: &Backward) -> Result<PathBuf> {
    let default = || format!("{}-backward.npz", source::stem(&args.scene)).into();
    let file = args.output.clone().unwrap_or_else(default);
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

fn wanted(scene: &Scene, parameters: &[Parameter]) -> Wanted {
    let mut wanted = Wanted::by(&Motion::zero(scene));
    for parameter in parameters {
        wanted.add(&Wanted::by(&match &parameter.request {
            Request::Motion(motion) => motion.clone(),
            Request::Array(array) => array.motion(scene, &vec![1.0; array.count()]),
        }));
    }
    wanted
}

/// The derivatives by one parameter.
struct Gradient {
    name: String,
    /// As of an array; empty for a scalar.
    shape: Vec<usize>,
    /// As NumPy writes it, or that there is none.
    shape_text: String,
    numbers: Vec<f64>,
    errors: Vec<f64>,
    /// Length of the array, or the one number.
    size: f64,
    /// Standard error of that, to first order.
    size_error: f64,
}

impl Gradient {
    fn new(scene: &Scene, parameter: &Parameter, result: &capwalk_diff::Backward) -> Self {
        let name = parameter.name.clone();
        match &parameter.request {
            Request::Motion(motion) => {
                let (value, error) = result.along(motion);
                Self {
                    name,
                    shape: Vec::new(),
                    shape_text: "scalar".into(),
                    numbers: vec![value],
                    errors: vec![error],
                    size: value,
                    size_error: error,
                }
            }
            Request::Array(array) => Self::of_array(scene, name, array, result),
        }
    }

    fn of_array(
        scene: &Scene,
        name: String,
        array: &ArrayParameter,
        result: &capwalk_diff::Backward,
    ) -> Self {
        let (numbers, errors) = result.numbers(|gradient| array.gradient(scene, gradient));
        let size = norm(&numbers);
        // The derivative of the norm is the unit vector along the gradient.
        let unit: Vec<f64> = match size {
            0.0 => vec![0.0; numbers.len()],
            size => numbers.iter().map(|x| x / size).collect(),
        };
        let (_, size_error) = result.along(&array.motion(scene, &unit));
        Self {
            name,
            shape: array.shape.clone(),
            shape_text: array.shape_text(),
            numbers,
            errors,
            size,
            size_error,
        }
    }

    fn is_scalar(&self) -> bool {
        self.shape.is_empty()
    }

    /// The norm that an array of only noise would have about.
    fn noise(&self) -> f64 {
        norm(&self.errors)
    }

    fn to_json(&self) -> Value {
        match self.is_scalar() {
            true => json!({
                "name": self.name,
                "shape": self.shape,
                "value": self.size,
                "standard_error": self.size_error,
            }),
            false => json!({
                "name": self.name,
                "shape": self.shape,
                "norm": self.size,
                "standard_error": self.size_error,
                "noise": self.noise(),
            }),
        }
    }
}

fn norm(numbers: &[f64]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn table(gradients: &[Gradient]) -> String {
    let mut rows = vec![
        ["", "shape", "norm or value", "standard error", "noise"]
            .map(String::from)
            .to_vec(),
    ];
    rows.extend(gradients.iter().map(|gradient| {
        let noise = match gradient.is_scalar() {
            true => String::new(),
            false => report::significant(gradient.noise(), 2),
        };
        vec![
            gradient.name.clone(),
            gradient.shape_text.clone(),
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
    settings: &GradientOptions,
    gradients: &[Gradient],
    loss: Option<&Loss>,
    statistics: &capwalk_diff::Statistics,
) -> Arrays {
    let mut metadata = output::origin("backward", &args.scene.scene, &settings.options);
    let mut note = |key: &str, value: String| metadata.push((key.to_owned(), value));
    let path = |path: &Path| path.display().to_string();
    note("method", settings.method.name().into());
    if let Some(file) = &args.objective.adjoint {
        note("adjoint", path(file));
    }
    if let (Some(loss), Some(target)) = (loss, &args.target) {
        note("loss", loss.name().into());
        note("target", path(target));
        note("loss_value", loss.value.to_string());
        note("picture_seed", loss.seed.to_string());
    }
    let complete = statistics.complete && loss.is_none_or(|loss| loss.statistics.complete);
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
            push(errors_name(&gradient.name), &gradient.errors);
        }
    }
    Arrays { arrays, metadata }
}
