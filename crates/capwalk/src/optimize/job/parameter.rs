//! A `[[parameter]]` of a job.

use capwalk_inverse::variable::vertices::{Directions, Selection};
use capwalk_inverse::variable::{Curve, VariableSpec};
use capwalk_math::Vec3;
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::{Place, Table, Value};

use super::table::{positive, truth};

/// What is to be found, and where its name stands.
pub fn read(table: &Table, uniform: bool) -> Result<(VariableSpec, Place), LoadError> {
    let name = table.require("name", "the name of a parameter of the scene")?;
    let start = table
        .get("start")
        .map(|value| value.numbers())
        .transpose()?;
    let bounds = table.get("bounds");
    let bounds = bounds
        .map(|value| value.array("[lowest, highest]"))
        .transpose()?;
    let curves = [("sigmoid", Curve::Sigmoid), ("log", Curve::Log)];
    let curve = table.get("reparam");
    let curve = curve.map(|value| value.choice(&curves)).transpose()?;
    let lambda = table.get("lambda");
    let lambda = lambda.map(|value| value.number("a number of at least 0", |x| x >= 0.0));
    let spec = VariableSpec {
        name: name.text()?.into(),
        start,
        bounds,
        curve,
        lr: positive(table, "lr")?,
        uniform: truth(table, "uniform")?.unwrap_or(uniform),
        vertices: table
            .get("vertices")
            .map(|value| selection(&value))
            .transpose()?,
        directions: directions(table)?,
        lambda: lambda.transpose()?,
    };
    table.finish()?;
    Ok((spec, name.place()))
}

/// `"all"`, `"border"`, or a list of numbers and ranges: `[0, "5..9"]`.
fn selection(value: &Value) -> Result<Selection, LoadError> {
    let items = value.items();
    if let [only] = &items[..]
        && let Ok(word) = only.text()
        && !word.contains("..")
    {
        let words = [("all", true), ("border", false)];
        return Ok(match only.choice(&words)? {
            true => Selection::All,
            false => Selection::Border,
        });
    }
    let mut numbers = Vec::new();
    for item in items {
        match item.text() {
            Ok(text) => {
                let ends = text.split_once("..");
                let ends = ends.and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
                let (first, end): (usize, usize) = ends
                    .filter(|(first, end)| first < end && *end <= u32::MAX as usize)
                    .ok_or_else(|| {
                        item.wrong("a range such as \"1..26\": from 1, up to 25, counted from 0")
                    })?;
                numbers.push(first..end);
            }
            Err(_) => {
                let number = item.integer(0..=i64::from(u32::MAX))? as usize;
                numbers.push(number..number + 1);
            }
        }
    }
    Ok(Selection::Numbers(numbers))
}

fn directions(table: &Table) -> Result<Option<Directions>, LoadError> {
    let plane = table.get("plane").map(|value| plane(&value)).transpose()?;
    let Some(along) = table.get("along") else {
        return Ok(plane.map(Directions::Plane));
    };
    let expected = "\"normals\", \"radial\", or a vector [x, y, z]";
    let directions = match along.text() {
        Ok("normals") => Directions::Normals,
        Ok("radial") => {
            let normal = plane.map(|[a, b]| a.cross(b));
            return Ok(Some(Directions::Radial(normal)));
        }
        Ok(_) => return Err(along.wrong(expected)),
        Err(_) => match Vec3::from(along.array::<3>(expected)?) {
            zero if zero == Vec3::zero() => return Err(along.wrong("a vector that is not zero")),
            direction => Directions::Along(direction),
        },
    };
    match plane {
        None => Ok(Some(directions)),
        Some(_) => Err(along.error("`plane` goes with `along = \"radial\"` only; leave out one")),
    }
}

/// Two of the letters x, y, z, or two vectors.
fn plane(value: &Value) -> Result<[Vec3; 2], LoadError> {
    let expected = "two axes such as \"xz\", or two vectors [[x, y, z], [x, y, z]]";
    let axes = match value.text() {
        Ok(text) => {
            let axis = |letter: char| match letter {
                'x' => Some(Vec3::new(1.0, 0.0, 0.0)),
                'y' => Some(Vec3::new(0.0, 1.0, 0.0)),
                'z' => Some(Vec3::new(0.0, 0.0, 1.0)),
                _ => None,
            };
            let axes: Option<Vec<Vec3>> = text.chars().map(axis).collect();
            axes.and_then(|axes| axes.try_into().ok())
        }
        Err(_) => {
            let [a, b, c, d, e, f] = value.array(expected)?;
            Some([Vec3::new(a, b, c), Vec3::new(d, e, f)])
        }
    };
    let spans = |axes: &[Vec3; 2]| axes[0].cross(axes[1]) != Vec3::zero();
    axes.filter(spans).ok_or_else(|| value.wrong(expected))
}
