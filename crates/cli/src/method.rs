//! The method that the command line names, and options that only some methods
//! have.

use anyhow::{Result, bail};
use capwalk_diff::{
    Estimator, GradientOptions, Method, Options, WalkSettings, WasBoundary, WasSettings,
};
use clap::ValueEnum;

use crate::args::{
    DomainName, EstimatorName, MethodArgs, MethodName, WalkArgs, WasArgs, WasBoundaryName,
};

/// How to estimate a gradient, by a method that differentiates samples.
pub fn gradient_options(options: Options, args: &MethodArgs) -> Result<GradientOptions> {
    let (method, walk) = method_and_walk(args)?;
    Ok(GradientOptions {
        options,
        method,
        walk,
    })
}

/// The method, if it is one that differentiates samples, and its walk.
pub fn method_and_walk(args: &MethodArgs) -> Result<(Method, WalkSettings)> {
    refuse_options_of_others(args)?;
    let method = match args.method {
        MethodName::Walk => match args.walk.domain {
            None | Some(DomainName::Sphere) => Method::Walk,
            Some(DomainName::Triangle) => Method::TriangleWalk,
            Some(DomainName::Explicit) => Method::ExplicitWalk,
        },
        MethodName::Edges => Method::Edges,
        MethodName::Was => Method::Was(was(&args.was)),
        MethodName::PsdrWas => Method::PsdrWas(was(&args.was)),
        MethodName::Fd => bail!(
            "finite differences give the derivative of a picture by one parameter. Use `capwalk \
             gradient --method fd -p NAME` for each parameter"
        ),
    };
    Ok((method, walk(&args.walk)))
}

/// An error if an option is there that the method has no use for.
pub fn refuse_options_of_others(args: &MethodArgs) -> Result<()> {
    let (walk, was) = (&args.walk, &args.was);
    let options = [
        (MethodName::Walk, "domain", walk.domain.is_some()),
        (MethodName::Walk, "walk-steps", walk.walk_steps.is_some()),
        (MethodName::Walk, "estimator", walk.estimator.is_some()),
        (MethodName::Walk, "max-angle", walk.max_angle.is_some()),
        (MethodName::Walk, "antithetic", walk.antithetic),
        (MethodName::Was, "was-kappa", was.was_kappa.is_some()),
        (MethodName::Was, "was-rays", was.was_rays.is_some()),
        (MethodName::Was, "was-boundary", was.was_boundary.is_some()),
        (
            MethodName::Was,
            "was-antithetic",
            was.was_antithetic.is_some(),
        ),
        (MethodName::Was, "was-debias", was.was_debias),
    ];
    for (owner, option, is_given) in options {
        let is_own = match args.method {
            MethodName::PsdrWas => owner == MethodName::Was,
            // Where no edges are gathered, it walks.
            MethodName::Edges => owner == MethodName::Walk && option != "domain",
            method => owner == method,
        };
        if is_given && !is_own {
            bail!(
                "--{option} belongs to the method {}, and the method is {}. Leave it out, or say \
                 --method {}",
                name(&owner),
                name(&args.method),
                name(&owner)
            );
        }
    }
    Ok(())
}

/// The name as it is typed.
pub fn name(value: &impl ValueEnum) -> String {
    let value = value.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

/// What is to be said about results whose standard errors do not bound their errors.
pub fn remark(args: &MethodArgs) -> String {
    let method = name(&args.method);
    match args.method {
        MethodName::Walk | MethodName::Edges if has_infinite_variance(&args.walk) => {
            "walks with the estimator literal have infinite variance: standard errors are too \
             small, and verdicts by them mean little. Use anchored, the default\n"
                .into()
        }
        MethodName::Walk | MethodName::Edges => String::new(),
        MethodName::Was | MethodName::PsdrWas if args.was.was_debias => format!(
            "{method} is a baseline: its standard errors can be too small near edges, and what \
             moves in mirrors is missing. `capwalk check` measures how wrong it is\n"
        ),
        MethodName::Was | MethodName::PsdrWas => format!(
            "{method} is a baseline and biased: its standard errors do not bound its errors, and \
             what moves in mirrors is missing. `capwalk check` measures how wrong it is\n"
        ),
        MethodName::Fd => "fd is a baseline: its standard errors leave out its bias, of the order \
                           of the step squared\n"
            .into(),
    }
}

/// In pairs of opposite azimuths what is infinite cancels (METHOD 2).
fn has_infinite_variance(args: &WalkArgs) -> bool {
    matches!(args.estimator, Some(EstimatorName::Literal)) && !args.antithetic
}

fn walk(args: &WalkArgs) -> WalkSettings {
    let default = WalkSettings::default();
    WalkSettings {
        steps: args.walk_steps.unwrap_or(default.steps),
        max_radius: args.max_angle.map_or(default.max_radius, f64::to_radians),
        estimator: match args.estimator {
            None => default.estimator,
            Some(EstimatorName::Anchored) => Estimator::Anchored,
            Some(EstimatorName::Literal) => Estimator::Literal,
        },
        antithetic: args.antithetic,
    }
}

fn was(args: &WasArgs) -> WasSettings {
    let default = WasSettings::default();
    WasSettings {
        kappa: args.was_kappa.unwrap_or(default.kappa),
        rays: args.was_rays.unwrap_or(default.rays),
        boundary: match args.was_boundary {
            None => default.boundary,
            Some(WasBoundaryName::Normals) => WasBoundary::Normals,
            Some(WasBoundaryName::Edges) => WasBoundary::Edges,
        },
        antithetic: args.was_antithetic.unwrap_or(default.antithetic),
        debias: args.was_debias,
    }
}
