//! The `[method]` of a job: how gradients are estimated, with the names of the
//! command line.

use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::Table;
use clap::ValueEnum;

use crate::args::{DomainName, MethodArgs, MethodName, WalkArgs, WasArgs};
use crate::method::name;

use super::{integer, number, positive, truth};

/// The methods that differentiate many parameters at once.
const METHODS: [MethodName; 4] = [
    MethodName::Walk,
    MethodName::Edges,
    MethodName::Was,
    MethodName::PsdrWas,
];

/// The method, as if it were typed.
pub fn read(root: &Table) -> Result<MethodArgs, LoadError> {
    let mut args = MethodArgs {
        method: MethodName::Walk,
        walk: WalkArgs::default(),
        was: WasArgs::default(),
    };
    let Some(value) = root.get("method") else {
        return Ok(args);
    };
    let kind = value.table("[method]")?;
    args.method = choice(&kind, "type", &METHODS)?.unwrap_or(args.method);
    // Of the keys, only those of the method mean something.
    let table = value.table(&format!("[method] of type \"{}\"", name(&args.method)))?;
    table.get("type");
    match args.method {
        MethodName::Was | MethodName::PsdrWas => args.was = was(&table)?,
        method => {
            if method == MethodName::Walk {
                args.walk.domain = choice(&table, "domain", DomainName::value_variants())?;
            }
            walk(&table, &mut args.walk)?;
        }
    }
    table.finish()?;
    Ok(args)
}

/// The walk of a method that walks, if not everywhere.
fn walk(table: &Table, walk: &mut WalkArgs) -> Result<(), LoadError> {
    walk.walk_steps = integer(table, "steps", 1..=64)?.map(|steps| steps as u32);
    walk.estimator = choice(table, "estimator", ValueEnum::value_variants())?;
    let expected = "an angle above 0 and up to 180 degrees";
    walk.max_angle = number(table, "max_angle", expected, |x| x > 0.0 && x <= 180.0)?;
    walk.antithetic = truth(table, "antithetic")?.unwrap_or(false);
    Ok(())
}

fn was(table: &Table) -> Result<WasArgs, LoadError> {
    Ok(WasArgs {
        was_kappa: positive(table, "kappa")?,
        was_rays: integer(table, "rays", 1..=65536)?.map(|rays| rays as u32),
        was_boundary: choice(table, "boundary", ValueEnum::value_variants())?,
        was_antithetic: truth(table, "antithetic")?,
        was_debias: truth(table, "debias")?.unwrap_or(false),
    })
}

/// One of these, by the name that it has on the command line.
fn choice<T: ValueEnum>(
    table: &Table,
    key: &'static str,
    choices: &[T],
) -> Result<Option<T>, LoadError> {
    let Some(value) = table.get(key) else {
        return Ok(None);
    };
    let names: Vec<String> = choices.iter().map(name).collect();
    let named: Vec<_> = names.iter().map(String::as_str).zip(choices).collect();
    Ok(Some(value.choice(&named)?.clone()))
}
