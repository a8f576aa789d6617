//! The arrays of a scene, and what they are called.

use super::array::{ArrayParameter, Place};
use super::names::{Entry, Names};
use super::optic::optic_text;
use super::parameter::ParameterKind;
use super::target::{Channel, Target};
use crate::ids::ShapeId;
use crate::scene::Scene;
use crate::shape::ShadingNormals;
use crate::texture::Pattern;

/// The arrays that are listed at the first of the scalars that change them.
pub(super) fn behind(
    scene: &Scene,
    names: &Names,
    entry: &Entry,
    users: &[String],
) -> Vec<ArrayParameter> {
    let Some(target) = entry.target else {
        return Vec::new();
    };
    let placed = |place| of_placed(&entry.name, names.alias_of(entry), place);
    match target {
        Target::Translate(id, 0) => of_shape(scene, id),
        // A single number has a short name too, which stays a scalar's.
        Target::Texels(id, part, quantity, Channel::All) if entry.name.ends_with(part.name) => {
            let texture = scene.texture(id);
            let mut shape = match (&texture.pattern, part.count) {
                (Pattern::Bitmap(bitmap), _) => vec![bitmap.height as usize, bitmap.width as usize],
                (Pattern::PerVertex | Pattern::PerFace, count) => vec![count],
                (Pattern::Constant | Pattern::Checkerboard { .. }, _) => Vec::new(),
                (Pattern::Environment, count) => match scene.environment_map_of(id) {
                    Some(map) => vec![map.height as usize, map.width as usize],
                    None => vec![count],
                },
                (Pattern::MeshAttribute { .. }, _) => unreachable!("its numbers are the shape's"),
            };
            shape.push(texture.channels);
            vec![ArrayParameter {
                name: entry.name.to_string(),
                kind: quantity.into(),
                shape,
                unit: quantity.unit(),
                moves_discontinuities: quantity.moves_edges(),
                description: format!("{} of {}", quantity.name(), users[id.0 as usize]),
                alias_of: names.alias_of(entry).map(String::from),
                place: Place::Texels(id, part),
            }]
        }
        Target::TranslateLight(id, 0) => {
            let moved = ArrayParameter {
                kind: ParameterKind::LightTranslation,
                unit: "world units",
                description: "moves the light, world axes".into(),
                ..placed(Place::LightTranslation(id))
            };
            let position = ArrayParameter {
                name: format!("{}.position", moved.name.trim_end_matches(".translate")),
                kind: ParameterKind::LightPosition,
                description: "where the light is".into(),
                place: Place::LightPosition(id),
                ..moved.clone()
            };
            vec![moved, position]
        }
        Target::RotateLight(id, 0) => vec![ArrayParameter {
            kind: ParameterKind::LightRotation,
            unit: "radians",
            description: "turns the light, world axes".into(),
            ..placed(Place::LightRotation(id))
        }],
        Target::TranslateSensor(0) => vec![ArrayParameter {
            kind: ParameterKind::SensorTranslation,
            unit: "world units",
            description: "moves the sensor, world axes".into(),
            ..placed(Place::SensorTranslation)
        }],
        Target::RotateSensor(0) => vec![
            ArrayParameter {
                kind: ParameterKind::SensorRotation,
                unit: "radians",
                description: "turns the sensor about its origin, world axes".into(),
                ..placed(Place::SensorRotation)
            },
            sensor_to_world(placed(Place::SensorToWorld)),
        ],
        Target::SensorOptic(optic) => {
            let (kind, unit, description) = optic_text(optic);
            vec![ArrayParameter {
                kind,
                shape: vec![1],
                unit,
                description: description.into(),
                ..placed(Place::SensorOptic(optic))
            }]
        }
        Target::Translate(..)
        | Target::Rotate(..)
        | Target::Scale(_)
        | Target::Texels(..)
        | Target::TranslateLight(..)
        | Target::RotateLight(..)
        | Target::TranslateSensor(_)
        | Target::RotateSensor(_) => Vec::new(),
    }
}

fn of_shape(scene: &Scene, id: ShapeId) -> Vec<ArrayParameter> {
    let shape = scene.shape(id);
    let name = &shape.id;
    let positions = ArrayParameter {
        name: format!("{name}.positions"),
        kind: ParameterKind::Positions,
        shape: vec![shape.mesh.positions.len(), 3],
        unit: "world units",
        moves_discontinuities: true,
        description: format!("vertices of {name}"),
        alias_of: None,
        place: Place::Positions(id),
    };
    let normals = ArrayParameter {
        name: format!("{name}.normals"),
        kind: ParameterKind::Normals,
        unit: "length 1",
        // They decide what a mirror shows.
        moves_discontinuities: true,
        description: format!("shading normals given with {name}"),
        place: Place::Normals(id),
        ..positions.clone()
    };
    let to_world = ArrayParameter {
        name: format!("{name}.to_world"),
        kind: ParameterKind::ToWorld,
        shape: vec![4, 4],
        unit: MATRIX,
        description: format!("matrix that puts {name} in the world"),
        place: Place::ShapeToWorld(id),
        ..positions.clone()
    };
    let translation = ArrayParameter {
        name: format!("{name}.translate"),
        kind: ParameterKind::Translation,
        shape: vec![3],
        description: format!("moves {name}, world axes"),
        place: Place::ShapeTranslation(id),
        ..positions.clone()
    };
    // Mitsuba's name, directly behind ours.
    let with_alias = |array: ArrayParameter, name: String| {
        let alias = ArrayParameter {
            name,
            alias_of: Some(array.name.clone()),
            ..array.clone()
        };
        [array, alias]
    };
    let mut arrays = Vec::from(with_alias(positions, format!("{name}.vertex_positions")));
    if let ShadingNormals::Given(_) = shape.normals {
        arrays.extend(with_alias(normals, format!("{name}.vertex_normals")));
    }
    arrays.extend([to_world, translation]);
    arrays
}

/// Unit of the numbers of a matrix.
const MATRIX: &str = "matrix entries";

fn sensor_to_world(rotation: ArrayParameter) -> ArrayParameter {
    let named = |name: &String| format!("{}.to_world", name.trim_end_matches(".rotate"));
    ArrayParameter {
        name: named(&rotation.name),
        alias_of: rotation.alias_of.as_ref().map(named),
        kind: ParameterKind::SensorToWorld,
        shape: vec![4, 4],
        unit: MATRIX,
        description: "matrix that puts the sensor in the world".into(),
        ..rotation
    }
}

/// What the arrays that place the sensor or a light have in common. The names are those of their
/// first entries, without the axis.
fn of_placed(name: &str, alias_of: Option<&str>, place: Place) -> ArrayParameter {
    let whole = |name: &str| name.trim_end_matches(".x").to_owned();
    ArrayParameter {
        name: whole(name),
        kind: ParameterKind::SensorTranslation,
        shape: vec![3],
        unit: "",
        moves_discontinuities: true,
        description: String::new(),
        alias_of: alias_of.map(whole),
        place,
    }
}
