//! From what a user asks for to a variable.

use capwalk_math::Vec3;
use capwalk_scene::params::{ArrayParameter, ParameterKind, Registry, Request};
use capwalk_scene::{Scene, SensorVectors, Tangent};

use super::error::VariableError;
use super::kind::{Map, Variable};
use super::pose::PoseComponent;
use super::reparameterization::Reparameterization;
use super::vertices::{Directions, Selection, Vertices};
use crate::smooth::Smoother;

/// What is to be found, from where, and between which bounds: the specification of a
/// variable.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VariableSpec {
    /// An array, a parameter, or a sum of parameters.
    pub name: String,
    /// Where to begin instead of where the scene is: one number for all, or one
    /// for each.
    pub start: Option<Vec<f64>>,
    /// Lowest and highest value.
    pub bounds: Option<[f64; 2]>,
    /// A curve between unknowns and values.
    pub curve: Option<Curve>,
    /// Its own learning rate.
    pub lr: Option<f64>,
    /// True if all its unknowns take steps by the same rate.
    pub uniform: bool,
    /// For positions, which vertices move.
    pub vertices: Option<Selection>,
    /// For positions, the directions in which they move.
    pub directions: Option<Directions>,
    /// For positions, the weight of the Laplacian (large steps).
    pub lambda: Option<f64>,
}

/// Curves between unknowns and values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curve {
    /// Between the bounds, or 0 and 1.
    Sigmoid,
    /// Above 0.
    Log,
}

/// Largest `lambda`: above it, `I + λL` differs from `λL`, which has no inverse, by
/// less than a few thousand roundings.
const MAX_LAMBDA: f64 = 1e12;

/// The variable with this specification.
pub fn variable(
    scene: &Scene,
    registry: &Registry,
    spec: &VariableSpec,
) -> Result<Variable, VariableError> {
    let request = registry.request(scene, &spec.name)?;
    let (map, rest) = match request {
        Request::Array(array) => array_map(scene, spec, array)?,
        Request::Tangent(tangent) => scalar_map(scene, registry, spec, tangent)?,
    };
    let name = || spec.name.clone();
    if !matches!(map, Map::Vertices(_)) {
        let only = [
            ("vertices", spec.vertices.is_some()),
            ("plane` and `along", spec.directions.is_some()),
            ("lambda", spec.lambda.is_some()),
        ];
        if let Some((option, _)) = only.into_iter().find(|&(_, given)| given) {
            let name = name();
            return Err(VariableError::OnlyForVertices { name, option });
        }
    }
    let reparameterization = reparameterization(scene, spec, &map)?;
    let initial = start(spec, rest)?;
    if let Some((value, expected)) = reparameterization.refused(&initial) {
        return Err(VariableError::Start {
            name: name(),
            value,
            expected,
        });
    }
    if let Some((value, limit)) = map.refused(&initial) {
        return Err(VariableError::Start {
            name: name(),
            value,
            expected: limit.to_string(),
        });
    }
    Ok(Variable {
        name: spec.name.clone(),
        initial,
        reparameterization,
        lr: spec.lr,
        uniform: spec.uniform,
        map,
    })
}

/// The map of an array, and its values in the scene.
fn array_map(
    scene: &Scene,
    spec: &VariableSpec,
    array: ArrayParameter,
) -> Result<(Map, Vec<f64>), VariableError> {
    let moved_shape = || {
        let all_ones = array.tangent(scene, &vec![1.0; array.count()]);
        let shape = all_ones.shapes.iter().position(Option::is_some);
        shape.expect("positions and translations are those of a shape")
    };
    match array.kind {
        ParameterKind::Positions => {
            let shape = moved_shape();
            let selection = spec.vertices.clone().unwrap_or(Selection::All);
            let directions = spec.directions.unwrap_or(Directions::Free);
            let vertices = Vertices::new(scene, shape, &selection, directions)?;
            let rest = vec![0.0; vertices.count()];
            Ok((Map::Vertices(vertices), rest))
        }
        ParameterKind::Translation => {
            let shape = moved_shape();
            let parts = (0..3).map(PoseComponent::Translate).collect();
            Ok((Map::Pose { shape, parts }, vec![0.0; 3]))
        }
        ParameterKind::SensorRotation => Ok((Map::Turn { axes: 0..3 }, vec![0.0; 3])),
        _ => {
            let rest = array.get(scene);
            Ok((Map::Array(array), rest))
        }
    }
}

/// The map of a single number, and its value in the scene.
fn scalar_map(
    scene: &Scene,
    registry: &Registry,
    spec: &VariableSpec,
    tangent: Tangent,
) -> Result<(Map, Vec<f64>), VariableError> {
    let name = spec.name.trim();
    let listed = registry.scalar(scene, name);
    let axis = ["x", "y", "z"]
        .iter()
        .position(|a| name.ends_with(&format!(".{a}")));
    let shape = tangent.shapes.iter().position(Option::is_some);
    let pose = |part: PoseComponent| {
        let parts = vec![part];
        shape.map(|shape| Map::Pose { shape, parts })
    };
    let (map, value) = match (&listed, axis) {
        (Some(listed), Some(axis)) if listed.kind == ParameterKind::Translation => {
            (pose(PoseComponent::Translate(axis)), 0.0)
        }
        (Some(listed), Some(axis)) if listed.kind == ParameterKind::Rotation => {
            (pose(PoseComponent::Rotate(axis)), 0.0)
        }
        (Some(listed), _) if listed.kind == ParameterKind::Scale => {
            (pose(PoseComponent::Scale), 1.0)
        }
        (Some(listed), Some(axis)) if listed.kind == ParameterKind::SensorRotation => {
            let axes = axis..axis + 1;
            (Some(Map::Turn { axes }), 0.0)
        }
        // Everything else goes along a straight line. Where that is no single
        // number of the scene, its value is how far it has gone.
        (listed, _) => {
            let value = match listed.as_ref().map(|listed| &listed.value[..]) {
                Some(&[value]) => Some(value),
                _ => element(scene, registry, name),
            };
            let turns = tangent.shapes.iter().flatten().any(|s| s.normals.is_some());
            let mut lights = tangent.emitters.iter();
            let turns = turns || lights.any(|light| light.rotation != Vec3::zero());
            if turns || tangent.sensor.rotation != SensorVectors::default().rotation {
                return Err(rotation_error(registry, name));
            }
            if value.is_none() {
                refuse_offset(spec, &tangent)?;
            }
            let (tangent, from) = (Box::new(tangent), value.unwrap_or(0.0));
            (Some(Map::Line { tangent, from }), from)
        }
    };
    let map = map.expect("a pose is that of a shape");
    Ok((map, vec![value]))
}

/// Why something that turns is not an unknown: it is one number of an array, or of a sum.
fn rotation_error(registry: &Registry, name: &str) -> VariableError {
    let array = name.rfind(['.', '[']).map(|end| &name[..end]);
    let is_array = |array: &&str| matches!(registry.array(array), Ok(Some(_)));
    match array.filter(is_array) {
        Some(array) => VariableError::PartOfRotation {
            name: name.into(),
            array: array.into(),
        },
        None => VariableError::RotationInSum { name: name.into() },
    }
}

/// What the number is now that a name such as `ball.positions[12,0]` means; `None`
/// if it is something else, or several numbers.
fn element(scene: &Scene, registry: &Registry, name: &str) -> Option<f64> {
    let (array, inside) = name.rsplit_once('[')?;
    let array = registry.array(array).ok()??;
    let indices = inside.strip_suffix(']')?.split(',');
    let indices = indices.map(|index| index.trim().parse().ok());
    let indices: Vec<usize> = indices.collect::<Option<_>>()?;
    if array.shape[indices.len().min(array.shape.len())..]
        .iter()
        .any(|&side| side != 1)
    {
        return None;
    }
    let pairs = indices.iter().zip(&array.shape);
    let number = pairs.fold(0, |number, (index, side)| number * side + index);
    array.get(scene).get(number).copied()
}

/// An error if values are asked for where the scene's numbers have values of their
/// own, but this is only how far they have gone: a user would mean the former.
fn refuse_offset(spec: &VariableSpec, tangent: &Tangent) -> Result<(), VariableError> {
    let has_values = spec.name.contains('[')
        || tangent.textures.iter().any(Option::is_some)
        || tangent.sensor.optics != SensorVectors::default().optics;
    let asked = [
        ("its value", spec.start.is_some()),
        ("`bounds`", spec.bounds.is_some()),
        ("`reparam`", spec.curve.is_some()),
    ];
    match asked.into_iter().find(|&(_, given)| given && has_values) {
        None => Ok(()),
        Some((what, _)) => Err(VariableError::NoValue {
            name: spec.name.clone(),
            what,
        }),
    }
}

fn reparameterization(
    scene: &Scene,
    spec: &VariableSpec,
    map: &Map,
) -> Result<Reparameterization, VariableError> {
    let name = || spec.name.clone();
    if let Some([low, high]) = spec.bounds
        && !(low.is_finite() && high.is_finite() && low < high)
    {
        return Err(VariableError::Bounds {
            name: name(),
            bounds: [low, high],
        });
    }
    let smooths = spec.lambda.is_some_and(|lambda| lambda != 0.0);
    if smooths && (spec.bounds.is_some() || spec.curve.is_some()) {
        return Err(VariableError::SmoothedWithBounds { name: name() });
    }
    Ok(match (spec.curve, spec.bounds, spec.lambda, map) {
        (_, _, Some(lambda), Map::Vertices(vertices)) if smooths => {
            if !(lambda > 0.0 && lambda <= MAX_LAMBDA) {
                return Err(VariableError::Lambda {
                    name: name(),
                    lambda,
                    largest: MAX_LAMBDA,
                });
            }
            let edges = vertices.edges(&scene.shapes[vertices.shape].mesh);
            let smoother = Smoother::new(vertices.nodes(), &edges, lambda);
            let smoother = smoother.ok_or_else(|| VariableError::Factorization { name: name() })?;
            let dims = vertices.dims;
            Reparameterization::Smooth { smoother, dims }
        }
        (Some(Curve::Sigmoid), bounds, ..) => {
            Reparameterization::Sigmoid(bounds.unwrap_or([0.0, 1.0]))
        }
        (Some(Curve::Log), Some(_), ..) => {
            return Err(VariableError::LogWithBounds { name: name() });
        }
        (Some(Curve::Log), None, ..) => Reparameterization::Log,
        (None, Some(bounds), ..) => Reparameterization::Clamp(bounds),
        (None, None, ..) => Reparameterization::None,
    })
}

fn start(spec: &VariableSpec, rest: Vec<f64>) -> Result<Vec<f64>, VariableError> {
    match spec.start.as_deref() {
        None => Ok(rest),
        Some(&[all]) => Ok(vec![all; rest.len()]),
        Some(each) if each.len() == rest.len() => Ok(each.to_vec()),
        Some(each) => Err(VariableError::StartLength {
            name: spec.name.clone(),
            given: each.len(),
            numbers: rest.len(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variable::ApplyError;
    use crate::variable::pose::PoseLimit;
    use crate::variable::tests::{ball, refused, spec, variables};

    /// `x.value[0]` and `x.value.r` are the same number: what it is, its bounds, and
    /// what a value makes of the scene.
    #[test]
    fn one_number_of_an_array_is_what_it_is() {
        let scene = ball();
        let with = |name: &str, start: Option<f64>| VariableSpec {
            start: start.map(|start| vec![start]),
            bounds: Some([1.0, 50.0]),
            ..spec(name)
        };
        let (short, long) = (
            "lamp.emitter.radiance.value.r",
            " lamp.emitter.radiance.value[0]",
        );
        for start in [None, Some(40.0)] {
            let [a, b] = [short, long].map(|name| variables(&scene, &[with(name, start)]));
            assert_eq!(a.initial(), [start.unwrap_or(34.0)]);
            assert_eq!(a.initial(), b.initial());
            for values in [a.initial(), vec![12.0]] {
                let made = [&a, &b].map(|v| v.apply(&scene, &values).expect("a scene").textures);
                assert_eq!(made[0], made[1]);
            }
        }
        let initial = |name: &str| {
            variable(&scene, &Registry::new(&scene), &spec(name))
                .expect("fine")
                .initial
        };
        let vertex = scene.shapes.iter().find(|shape| shape.id == "ball");
        let vertex = vertex.expect("a ball").mesh.positions[12];
        assert_eq!(initial("ball.positions[12, 1]"), [vertex.y]);
        let row = [
            initial("ball.positions[12]"),
            initial("2*lamp.emitter.radiance.value[0]"),
        ];
        assert_eq!(row, [[0.0], [0.0]], "how far it has gone");
        // Where a value is only how far, none can be meant.
        for name in [
            "ball.positions[12]",
            "2*lamp.emitter.radiance.value[0]",
            "1*lamp.emitter.radiance.value",
            "ball.positions[12,0] + ball.positions[13,0]",
        ] {
            refused(&[with(name, None)], "`bounds` would be a distance");
            refused(&[with(name, Some(0.5))], "its value would be a distance");
        }
        let sum = with("lamp.translate.x - 2*floor.translate.y", Some(2.0));
        assert_eq!(variables(&scene, &[sum]).initial(), [2.0]);
    }

    /// What a file could not say is refused by the name of what was to have it.
    #[test]
    fn poses_have_limits() {
        let scene = ball();
        for (name, value, expected) in [
            ("ball.translate.x", 1e200, "a distance of at most 1e30"),
            ("ball.translate", -1e31, "a distance of at most 1e30"),
            ("ball.rotate.x", 1e300, "an angle of at most 1e6 radians"),
            ("sensor.rotate.y", -1e7, "an angle of at most 1e6 radians"),
            ("ball.scale", 1e200, "a scale above 0, of at most 1e30"),
        ] {
            let start = VariableSpec {
                start: Some(vec![value]),
                ..spec(name)
            };
            refused(&[start], expected);
            // Nor does an optimisation go there.
            let variables = variables(&scene, &[spec(name)]);
            let values = vec![value; variables.count()];
            let error = variables.apply(&scene, &values).expect_err(name);
            let text = error.to_string();
            assert!(text.contains(name) && text.contains(expected), "{text}");
        }
    }

    /// A shape does not pass through its centre.
    #[test]
    fn scales_stay_above_0() {
        let scale = |start| VariableSpec {
            start: Some(vec![start]),
            ..spec("ball.scale")
        };
        for start in [0.0, -1.0] {
            refused(&[scale(start)], "expected a scale above 0");
        }
        let scene = ball();
        let variables = variables(&scene, &[scale(0.5)]);
        assert!(variables.apply(&scene, &[0.1]).is_ok());
        for value in [0.0, -0.1] {
            let error = variables.apply(&scene, &[value]).expect_err("no size");
            let expected = ApplyError::Pose {
                name: "ball.scale".into(),
                value,
                limit: PoseLimit::Scale,
            };
            assert_eq!(error, expected);
        }
    }
}
