//! The `[method]` of a job: how gradients are estimated.

use capwalk_diff::{Method, WalkSettings};
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::Table;

use super::table::{integer, number, truth};
use crate::method::{Choice, MethodChoice, MethodName, WalkChoice};

/// What `[method]` says.
#[derive(Clone, Copy, Debug, Default)]
pub struct MethodKeys {
    pub method: Method,
    /// The walk of a method that walks.
    pub walk: WalkSettings,
}

/// The method and its walk; the default ones without the table.
pub fn read(root: &Table) -> Result<MethodKeys, LoadError> {
    let Some(value) = root.get("method") else {
        return Ok(MethodKeys::default());
    };
    let table = value.table("[method]")?;
    // Keys of walks ask for one.
    let mut walks = MethodName::Walk.options();
    let method = match choice(&table, "type")? {
        Some(method) => method,
        None if walks.any(|key| table.get(key).is_some()) => MethodName::Walk,
        None => MethodName::Auto,
    };
    let mut chosen = MethodChoice {
        method,
        ..MethodChoice::default()
    };
    // Of the keys, only those of the method mean something.
    let table = value.table(&format!("[method] of type \"{}\"", method.name()))?;
    table.get("type");
    match method {
        MethodName::Auto => {}
        MethodName::Walk | MethodName::Edges => {
            chosen.walk = walk(&table)?;
        }
    }
    table.finish()?;
    let (method, walk) = chosen
        .resolve()
        .map_err(|error| value.error(error.to_string()))?;
    Ok(MethodKeys { method, walk })
}

/// The walk of a method that walks, if not everywhere.
fn walk(table: &Table) -> Result<WalkChoice, LoadError> {
    let expected = "an angle above 0 and up to 180 degrees";
    Ok(WalkChoice {
        steps: integer(table, "steps", 1..=64)?.map(|steps| steps as u32),
        estimator: choice(table, "estimator")?,
        max_angle: number(table, "max_angle", expected, |x| x > 0.0 && x <= 180.0)?,
        antithetic: truth(table, "antithetic")?,
    })
}

/// One of the choices by its name, if the key is there.
fn choice<T: Choice>(table: &Table, key: &'static str) -> Result<Option<T>, LoadError> {
    table
        .get(key)
        .map(|value| value.choice(T::NAMES))
        .transpose()
}
