//! The `[method]` of a job: how gradients are estimated.

use capwalk_render::{Estimator, Method, WalkSettings, WasBoundary, WasSettings};
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::Table;

use crate::args::MethodName;

use super::{integer, number, positive, truth};

/// The method, and its walk if it walks.
pub fn read(root: &Table) -> Result<(Method, WalkSettings), LoadError> {
    let mut walk = WalkSettings::default();
    let Some(table) = root.table("method")? else {
        return Ok((Method::default(), walk));
    };
    let types = [
        ("walk", MethodName::Walk),
        ("edges", MethodName::Edges),
        ("was", MethodName::Was),
    ];
    let name = match table.get("type") {
        Some(value) => value.choice(&types)?,
        None => MethodName::Walk,
    };
    let method = match name {
        MethodName::Was => was(&table)?,
        MethodName::Edges => {
            steps(&table, &mut walk)?;
            Method::Edges
        }
        _ => walking(&table, &mut walk)?,
    };
    table.finish()?;
    Ok((method, walk))
}

/// The walk of a method that walks, if not everywhere.
fn steps(table: &Table, walk: &mut WalkSettings) -> Result<(), LoadError> {
    if let Some(steps) = integer(table, "steps", 1..=64)? {
        walk.steps = steps as u32;
    }
    let expected = "an angle above 0 and up to 180 degrees";
    let angle = number(table, "max_angle", expected, |x| x > 0.0 && x <= 180.0)?;
    walk.max_radius = angle.map_or(walk.max_radius, f64::to_radians);
    walk.antithetic = truth(table, "antithetic")?.unwrap_or(walk.antithetic);
    if let Some(estimator) = table.get("estimator") {
        let estimators = [
            ("anchored", Estimator::Anchored),
            ("literal", Estimator::Literal),
        ];
        walk.estimator = estimator.choice(&estimators)?;
    }
    Ok(())
}

fn walking(table: &Table, walk: &mut WalkSettings) -> Result<Method, LoadError> {
    steps(table, walk)?;
    let domains = [("sphere", Method::Walk), ("triangle", Method::TriangleWalk)];
    match table.get("domain") {
        Some(domain) => domain.choice(&domains),
        None => Ok(Method::Walk),
    }
}

fn was(table: &Table) -> Result<Method, LoadError> {
    let mut was = WasSettings::default();
    was.kappa = positive(table, "kappa")?.unwrap_or(was.kappa);
    if let Some(rays) = integer(table, "rays", 1..=65536)? {
        was.rays = rays as u32;
    }
    if let Some(boundary) = table.get("boundary") {
        let boundaries = [
            ("edges", WasBoundary::Edges),
            ("normals", WasBoundary::Normals),
        ];
        was.boundary = boundary.choice(&boundaries)?;
    }
    was.antithetic = truth(table, "antithetic")?.unwrap_or(was.antithetic);
    was.debias = truth(table, "debias")?.unwrap_or(was.debias);
    Ok(Method::Was(was))
}
