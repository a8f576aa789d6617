//! The method that the command line names, in the library's terms.

use anyhow::{Result, anyhow, bail};
use capwalk::{
    Caveat, Choice, Chosen, GradientOptions, Method, MethodChoice, MethodName, OptionError,
    RenderOptions, Trial, WalkChoice, caveat,
};
use serde_json::{Value, json};

use crate::args::{MethodArgs, TypedMethod};
use crate::report;

/// How to estimate a gradient, by a method that differentiates samples.
pub fn options(sampling: RenderOptions, args: &MethodArgs) -> Result<GradientOptions> {
    refuse_options_of_others(args)?;
    let TypedMethod::Of(method) = typed(args) else {
        bail!(
            "finite differences give the derivative of an image with respect to one parameter. \
             Use `capwalk gradient --method fd -p NAME` for each parameter"
        );
    };
    Ok(choice(method, args).apply(GradientOptions::new(sampling))?)
}

/// An error if an option is there that the method has no use for.
pub fn refuse_options_of_others(args: &MethodArgs) -> Result<()> {
    let typed = typed(args);
    let refused = match typed {
        TypedMethod::Of(method) => match choice(method, args).resolve() {
            Err(OptionError::OfAnotherMethod { option, owner, .. }) => Some((option, owner)),
            Err(other) => return Err(other.into()),
            Ok(_) => None,
        },
        // Differences have no options.
        TypedMethod::Fd => choice(MethodName::default(), args).given(),
    };
    let Some((option, owner)) = refused else {
        return Ok(());
    };
    let owner = owner.name();
    Err(anyhow!(
        "--{} belongs to the method {owner}, and the method is {}. Leave it out, or say \
         --method {owner}",
        flag(option),
        typed.name(),
    ))
}

/// What a library's option is called on the command line.
fn flag(option: &str) -> String {
    match option {
        "steps" => "walk-steps".into(),
        option => option.replace('_', "-"),
    }
}

fn choice(method: MethodName, args: &MethodArgs) -> MethodChoice {
    let walk = &args.walk;
    let walk = WalkChoice {
        steps: walk.walk_steps,
        estimator: walk.estimator,
        max_angle: walk.max_angle,
        antithetic: walk.antithetic.then_some(true),
    };
    MethodChoice { method, walk }
}

/// The method that was typed, or that the options ask for: those of walks ask for one.
pub fn typed(args: &MethodArgs) -> TypedMethod {
    let walks = choice(MethodName::Walk, args).has_own();
    args.method.unwrap_or(TypedMethod::Of(match walks {
        true => MethodName::Walk,
        false => MethodName::Auto,
    }))
}

/// What the root of the number of pieces of edges before an emitter is multiplied by to give the
/// number of points on them; nothing where none are gathered there.
fn points(method: Method) -> Option<u32> {
    let gathers = method.traits().gathers;
    gathers.emitters.then_some(gathers.points)
}

/// How many points a sample takes on the edges in its pixel; nothing where none are gathered there.
fn camera_points(method: Method) -> Option<u32> {
    let gathers = method.traits().gathers;
    gathers.camera.then_some(gathers.camera_points)
}

/// How a method was chosen, for `--json`.
pub fn choice_json(chosen: &Chosen) -> Value {
    let trial = |trial: &Trial| {
        json!({
            "method": trial.method.name(),
            "gathers": trial.method.traits().gathers.names(),
            "points": points(trial.method),
            "camera_points": camera_points(trial.method),
            "max_angle": trial.max_radius.to_degrees(),
            "variance_per_sample": trial.variance,
            "effort_per_sample": trial.effort,
        })
    };
    json!({
        "gathers": chosen.options.method.traits().gathers.names(),
        "points": points(chosen.options.method),
        "camera_points": camera_points(chosen.options.method),
        "max_angle": chosen.options.walk.max_radius.to_degrees(),
        "trials": chosen.trials.iter().map(trial).collect::<Vec<_>>(),
    })
}

/// Says with `-v` how a method was chosen, and why.
pub fn log(chosen: &Chosen) {
    let describe = |method: Method, max_radius: f64| {
        let segments = method.traits().gathers.names();
        let along = match segments.is_empty() {
            true => String::new(),
            false => format!(" ({})", segments.join(", ")),
        };
        let points = points(method);
        let points = points.map_or_else(String::new, |points| format!(", {points} √n points"));
        let in_pixels = match camera_points(method) {
            None | Some(1) => String::new(),
            Some(count) => format!(", {count} points in a pixel"),
        };
        let angle = report::number(max_radius.to_degrees());
        format!(
            "{}{along}{points}{in_pixels}, walks up to {angle}°",
            method.name()
        )
    };
    for trial in &chosen.trials {
        let few = match trial.is_carried_by_few() {
            true => format!(
                ", {} with the few samples that carry it",
                report::number(trial.upper_cost())
            ),
            false => String::new(),
        };
        log::info!(
            "tried {}: variance {} x effort {} = {}{few}",
            describe(trial.method, trial.max_radius),
            report::number(trial.variance),
            report::number(trial.effort),
            report::number(trial.cost())
        );
    }
    let options = &chosen.options;
    log::info!(
        "method: {}",
        describe(options.method, options.walk.max_radius)
    );
}

/// What is to be said about differences, whose standard errors leave out their bias.
pub fn remark_on_differences() -> &'static str {
    "fd is a baseline: its standard errors leave out its bias, of the order of the step squared\n"
}

/// What is to be said about results whose standard errors do not bound their errors.
pub fn remark(options: &GradientOptions) -> String {
    let method = options.method.name();
    match caveat(options.method, &options.walk) {
        None => String::new(),
        Some(Caveat::InfiniteVariance) => {
            "walks with the estimator literal have infinite variance: standard errors are too \
             small, and verdicts by them mean little. Use anchored, the default\n"
                .into()
        }
        Some(_) => format!(
            "{method} is biased: its standard errors do not bound its errors. `capwalk check` \
             measures how wrong it is\n"
        ),
    }
}
