//! What should be seen, and from where: `[[view]]` and `[target]`.

use capwalk_inverse::variable::VariableSpec;
use capwalk_scene_io::LoadError;
use capwalk_scene_io::toml::{Document, Place, Table, Value};

use super::table::{MOST, integer, positive};

/// A text and where it stands.
#[derive(Clone, Debug)]
pub struct Located {
    pub text: String,
    pub place: Place,
}

/// A value of `$name` in scene files, and where it stands.
#[derive(Clone, Debug)]
pub struct Define {
    pub name: String,
    pub value: String,
    pub place: Place,
}

/// From where to look, and at what.
#[derive(Debug)]
pub struct ViewKeys {
    pub place: Place,
    pub weight: f64,
    /// Another scene file, for its sensor.
    pub scene: Option<Located>,
    /// Which of a scene's sensors, if the view says so, and where it does.
    pub sensor: Option<(usize, Place)>,
    pub to_world: Option<([f64; 16], Place)>,
    pub x_fov: Option<(f64, Place)>,
    pub mask: Option<Located>,
    pub target: TargetKeys,
}

/// What should be seen.
#[derive(Clone, Debug)]
pub enum TargetKeys {
    /// An image in a file.
    Image {
        file: Located,
        layer: Option<String>,
    },
    /// A scene that is rendered: another one, or the job's with other numbers.
    Rendered {
        scene: Option<Located>,
        /// Values of `$name` in its file, before those of the job.
        defines: Vec<Define>,
        set: Vec<(VariableSpec, Place)>,
        spp: u32,
    },
}

/// Samples per pixel of targets that are rendered, unless the job says otherwise.
const TARGET_SPP: u32 = 512;

/// The text of a value, with its place.
pub fn located(value: &Value) -> Result<Located, LoadError> {
    Ok(Located {
        text: value.text()?.into(),
        place: value.place(),
    })
}

/// The text of a key, if it is there.
pub fn maybe_located(table: &Table, key: &'static str) -> Result<Option<Located>, LoadError> {
    table.get(key).map(|value| located(&value)).transpose()
}

/// The values of `$name` in a table's `defines`.
pub fn defines(table: &Table) -> Result<Vec<Define>, LoadError> {
    let Some(table) = table.table("defines")? else {
        return Ok(Vec::new());
    };
    let entries = table.entries();
    entries
        .map(|(name, place, value)| {
            Ok(Define {
                name: name.to_owned(),
                value: value.written()?,
                place,
            })
        })
        .collect()
}

/// The views, or one from where the scene's sensor is.
pub fn views(document: &Document, root: &Table) -> Result<Vec<ViewKeys>, LoadError> {
    let common = root.table("target")?;
    let mask = maybe_located(root, "mask")?;
    let tables = root.tables("view")?;
    let target = |own: Option<Table>, place: Place| match own.as_ref().or(common.as_ref()) {
        Some(table) => target(table),
        None => Err(document.error_with_help(
            place,
            "there is no target",
            "expected a [target]: an `image`, a `scene` to render, or numbers to `set` in it",
        )),
    };
    if tables.is_empty() {
        return Ok(vec![ViewKeys {
            place: root.place(),
            weight: 1.0,
            scene: None,
            sensor: None,
            to_world: None,
            x_fov: None,
            mask,
            target: target(None, root.place())?,
        }]);
    }
    let mut views = Vec::new();
    for table in tables {
        let place = table.place();
        let view = ViewKeys {
            place,
            weight: positive(&table, "weight")?.unwrap_or(1.0),
            scene: maybe_located(&table, "scene")?,
            sensor: match table.get("sensor") {
                Some(value) => {
                    let number = value.integer(0..=1_000_000)? as usize;
                    Some((number, value.place()))
                }
                None => None,
            },
            to_world: match table.get("to_world") {
                Some(value) => {
                    let matrix = value.array("a matrix of 4 rows of 4 numbers")?;
                    Some((matrix, value.place()))
                }
                None => None,
            },
            x_fov: match table.get("x_fov") {
                Some(value) => {
                    let fov = value.number("degrees from 0 to 180", |x| x > 0.0 && x < 180.0)?;
                    Some((fov, value.place()))
                }
                None => None,
            },
            mask: maybe_located(&table, "mask")?.or_else(|| mask.clone()),
            target: target(table.table("target")?, place)?,
        };
        table.finish()?;
        views.push(view);
    }
    Ok(views)
}

fn target(table: &Table) -> Result<TargetKeys, LoadError> {
    let target = match table.get("image") {
        Some(file) => TargetKeys::Image {
            file: located(&file)?,
            layer: maybe_located(table, "layer")?.map(|layer| layer.text),
        },
        None => TargetKeys::Rendered {
            scene: maybe_located(table, "scene")?,
            defines: defines(table)?,
            set: match table.table("set")? {
                Some(set) => set
                    .entries()
                    .map(|(name, place, value)| {
                        let spec = VariableSpec {
                            name: name.into(),
                            start: Some(value.numbers()?),
                            ..VariableSpec::default()
                        };
                        Ok((spec, place))
                    })
                    .collect::<Result<_, LoadError>>()?,
                None => Vec::new(),
            },
            spp: integer(table, "spp", 1..=MOST)?.map_or(TARGET_SPP, |n| n as u32),
        },
    };
    table.finish()?;
    Ok(target)
}
