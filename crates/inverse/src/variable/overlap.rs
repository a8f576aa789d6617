//! Which numbers of a scene a variable changes, and which variables get in each
//! other's way.

use capwalk_math::Vec3;
use capwalk_scene::{EmitterVectors, Scene, ShapeId, ShapeVectors, Tangent};

use super::error::VariableError;
use super::kind::{Map, Variable, turn};
use super::pose::Pose;

/// A motion that is not zero where the variable changes something.
pub(super) fn support(scene: &Scene, variable: &Variable) -> Tangent {
    let ones = vec![1.0; variable.initial.len()];
    match &variable.map {
        Map::Array(array) => array.tangent(scene, &ones),
        Map::Line { tangent, .. } => (**tangent).clone(),
        Map::Vertices(vertices) => vertices.push(scene, &ones),
        Map::Pose { shape, parts } => {
            let mut tangent = Tangent::zero(scene);
            for &part in parts {
                let of_shape = Pose::default().push(&scene.shapes[*shape], part, 1.0);
                tangent.add_to_shape(ShapeId(*shape as u32), of_shape);
            }
            tangent
        }
        Map::Turn { axes } => turn(scene, axes, &ones),
    }
}

/// An error if two variables change the same numbers, and the changes are not
/// simply added.
pub(super) fn refuse(scene: &Scene, variables: &[Variable]) -> Result<(), VariableError> {
    let supports: Vec<Tangent> = variables.iter().map(|v| support(scene, v)).collect();
    for (i, first) in variables.iter().enumerate() {
        for (k, second) in variables.iter().enumerate().skip(i + 1) {
            if first.name == second.name {
                let name = first.name.clone();
                return Err(VariableError::Twice { name });
            }
            if !add_up(first, second) && overlap(&supports[i], &supports[k]) {
                let names = [first, second].map(|variable| variable.name.clone());
                return Err(VariableError::Overlap { names });
            }
        }
    }
    Ok(())
}

/// True if both may change the same number.
fn add_up(first: &Variable, second: &Variable) -> bool {
    let adds = |map: &Map| matches!(map, Map::Line { .. } | Map::Vertices(_));
    match (&first.map, &second.map) {
        (Map::Pose { shape: a, parts: p }, Map::Pose { shape: b, parts: q }) => {
            a == b && !p.iter().any(|part| q.contains(part))
        }
        (Map::Turn { axes: a }, Map::Turn { axes: b }) => a.end <= b.start || b.end <= a.start,
        (first, second) => adds(first) && adds(second),
    }
}

fn overlap(a: &Tangent, b: &Tangent) -> bool {
    let moves = |shape: &ShapeVectors| shape.vertices.iter().any(|&v| v != Vec3::zero());
    let turns = |shape: &ShapeVectors| shape.normals.is_some();
    let shapes = a.shapes.iter().zip(&b.shapes);
    let mut shapes = shapes.filter_map(|(a, b)| Some((a.as_ref()?, b.as_ref()?)));
    let textures = a.textures.iter().zip(&b.textures);
    let mut textures = textures.filter_map(|(a, b)| Some((a.as_ref()?, b.as_ref()?)));
    let places = |tangent: &Tangent| {
        let sensor = &tangent.sensor;
        let turning = sensor.axes.iter().any(|&v| v != Vec3::zero());
        let turning = turning || sensor.rotation != Vec3::zero();
        let [t, o] = [sensor.translation, sensor.optics].map(|v| v.to_array().map(|x| x != 0.0));
        [t[0], t[1], t[2], turning, o[0], o[1], o[2]]
    };
    let lights = a.emitters.iter().zip(&b.emitters);
    let mut lights = lights.flat_map(|(a, b)| {
        let places = |light: &EmitterVectors| {
            let [x, y, z] = light.translation.to_array().map(|x| x != 0.0);
            [x, y, z, light.rotation != Vec3::zero()]
        };
        places(a).into_iter().zip(places(b))
    });
    lights.any(|(a, b)| a && b)
        || shapes.any(|(a, b)| (moves(a) && moves(b)) || (turns(a) && turns(b)))
        || textures.any(|(a, b)| a.iter().zip(b).any(|(&a, &b)| a != 0.0 && b != 0.0))
        || places(a).iter().zip(places(b)).any(|(&a, b)| a && b)
}
