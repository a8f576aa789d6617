//! The method that the command line names, in the library's terms.

use anyhow::{Result, anyhow, bail, ensure};
#[cfg(feature = "paper")]
use capwalk::WasChoice;
use capwalk::{
    Caveat, Choice, Chosen, GradientOptions, Method, MethodChoice, MethodName, MissingName,
    OptionError, RenderOptions, Trial, WalkChoice, caveat,
};
use clap::ValueEnum;
use clap::builder::PossibleValue;

use serde_json::{Value, json};

use crate::args::{self, MethodArgs};
use crate::report;

/// How to estimate a gradient, by a method that differentiates samples.
pub fn options(sampling: RenderOptions, args: &MethodArgs) -> Result<GradientOptions> {
    refuse_options_of_others(args)?;
    let Some(method) = MethodName::named(&name(&typed(args)?)) else {
        bail!(
            "finite differences give the derivative of an image with respect to one parameter. \
             Use `capwalk gradient --method fd -p NAME` for each parameter"
        );
    };
    let allowed: Vec<MissingName> = args.allow_missing.iter().map(named).collect();
    let options = GradientOptions {
        allow_missing: MissingName::allow(&allowed),
        ..GradientOptions::new(sampling)
    };
    Ok(choice(method, args).apply(options)?)
}

/// An error if the method is left out of this program, or if an option is there that it
/// has no use for.
pub fn refuse_options_of_others(args: &MethodArgs) -> Result<()> {
    let typed = typed(args)?;
    let refused = match MethodName::named(&name(&typed)) {
        Some(method) => match choice(method, args).resolve() {
            Err(OptionError::OfAnotherMethod { option, owner, .. }) => Some((option, owner)),
            Err(other) => return Err(other.into()),
            Ok(_) => None,
        },
        // Differences have no options.
        None => choice(MethodName::default(), args).given(),
    };
    ensure!(
        args.allow_missing.is_empty() || name(&typed) != name(&args::MethodName::Fd),
        "--allow-missing is for methods that differentiate samples: finite differences miss \
         nothing. Leave it out"
    );
    let Some((option, owner)) = refused else {
        return Ok(());
    };
    let owner = owner.name();
    Err(anyhow!(
        "--{} belongs to the method {owner}, and the method is {}. Leave it out, or say \
         --method {owner}",
        flag(option, owner),
        name(&typed),
    ))
}

/// An error for what is there with the feature `paper` only: without it, it is hidden.
fn refuse_left_out(option: &str, value: &impl ValueEnum) -> Result<()> {
    let value = value.to_possible_value();
    match value.filter(PossibleValue::is_hide_set) {
        None => Ok(()),
        Some(value) => Err(anyhow!(
            "{option} {} is there to be compared with, and this program was built without it. \
             Build it with the feature `paper`: cargo install --locked --path crates/cli \
             --features paper",
            value.get_name()
        )),
    }
}

/// What a library's option is called on the command line.
fn flag(option: &str, owner: &str) -> String {
    match (option, owner) {
        ("steps", _) => "walk-steps".into(),
        (option, "was") => format!("was-{option}"),
        (option, _) => option.replace('_', "-"),
    }
}

fn choice(method: MethodName, args: &MethodArgs) -> MethodChoice {
    let walk = &args.walk;
    // The library may have more options than this program.
    let mut choice = MethodChoice {
        method,
        ..MethodChoice::default()
    };
    choice.walk = WalkChoice {
        domain: walk.domain.as_ref().map(named),
        steps: walk.walk_steps,
        estimator: walk.estimator.as_ref().map(named),
        max_angle: walk.max_angle,
        antithetic: walk.antithetic.then_some(true),
    };
    #[cfg(feature = "paper")]
    {
        let was = &args.was;
        choice.was = WasChoice {
            kappa: was.was_kappa,
            rays: was.was_rays,
            boundary: was.was_boundary.as_ref().map(named),
            antithetic: was.was_antithetic,
            debias: was.was_debias.then_some(true),
        };
    }
    choice
}

/// The library's choice of the name that was typed.
fn named<T: Choice>(typed: &impl ValueEnum) -> T {
    T::named(&name(typed)).expect("names are those of the library, as a test says")
}

/// The method that was typed, or that the options ask for: those of walks ask for one. An
/// error for what is left out of this program.
pub fn typed(args: &MethodArgs) -> Result<args::MethodName> {
    if let Some(method) = &args.method {
        refuse_left_out("--method", method)?;
    }
    if let Some(domain) = &args.walk.domain {
        refuse_left_out("--domain", domain)?;
    }
    let walks = choice(MethodName::Walk, args).has_own();
    Ok(args.method.unwrap_or(match walks {
        true => args::MethodName::Walk,
        false => args::MethodName::Auto,
    }))
}

/// The name as it is typed.
pub fn name(value: &impl ValueEnum) -> String {
    let value = value.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

/// What the root of the number of pieces of edges before an emitter is multiplied by to give the
/// number of points on them; nothing where none are gathered there.
fn points(method: Method) -> Option<u32> {
    let gathers = method.traits().gathers;
    gathers.emitters.then_some(gathers.points)
}

/// How a method was chosen, for `--json`.
pub fn choice_json(chosen: &Chosen) -> Value {
    let trial = |trial: &Trial| {
        json!({
            "method": trial.method.name(),
            "gathers": trial.method.traits().gathers.names(),
            "points": points(trial.method),
            "max_angle": trial.max_radius.to_degrees(),
            "variance_per_sample": trial.variance,
            "effort_per_sample": trial.effort,
        })
    };
    json!({
        "gathers": chosen.options.method.traits().gathers.names(),
        "points": points(chosen.options.method),
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
        let angle = report::number(max_radius.to_degrees());
        format!("{}{along}{points}, walks up to {angle}°", method.name())
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
        Some(Caveat::HeavyTail) => {
            "with --domain triangle rare samples are very large, where silhouettes cross borders \
             of triangles: while there are none among the samples, standard errors are too small. \
             Use the domain sphere, the default\n"
                .into()
        }
        Some(Caveat::ErrorsTooSmall) => format!(
            "{method} is a baseline: its standard errors can be too small near edges, and what \
             moves in mirrors is missing. `capwalk check` measures how wrong it is\n"
        ),
        Some(_) => format!(
            "{method} is a baseline and biased: its standard errors do not bound its errors, and \
             what moves in mirrors is missing. `capwalk check` measures how wrong it is\n"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk::{DomainName, Estimator};

    /// Everything that can be typed has a meaning; with the feature `paper` also the
    /// other way round.
    #[test]
    fn names_are_those_of_the_library() {
        fn same<T: Choice, A: ValueEnum>(only_typed: &[&str]) {
            let typed = A::value_variants().iter();
            let offered = typed.filter_map(ValueEnum::to_possible_value);
            let offered = offered.filter(|value| !value.is_hide_set());
            let offered: Vec<String> = offered.map(|value| value.get_name().into()).collect();
            let known = T::NAMES.iter().map(|(name, _)| *name);
            let known: Vec<&str> = known.chain(only_typed.iter().copied()).collect();
            assert!(offered.iter().all(|name| known.contains(&name.as_str())));
            if cfg!(feature = "paper") {
                assert_eq!(offered, known);
            }
        }
        same::<MethodName, args::MethodName>(&["fd"]);
        same::<DomainName, args::DomainName>(&[]);
        same::<MissingName, args::MissingArg>(&[]);
        same::<Estimator, args::EstimatorName>(&[]);
        #[cfg(feature = "paper")]
        same::<capwalk::WasBoundary, args::was::WasBoundaryName>(&[]);
    }
}
