use super::vertices::{Directions, Selection};
use std::f64::consts::{PI, TAU};

use super::*;
use capwalk_diff::{Purpose, Seed};
use capwalk_math::Vec3;
use capwalk_scene::params::Registry;
use capwalk_scene::{Gradient, Scene, SensorVectors, ShadingNormals, Tangent, builtin};

pub(crate) fn spec(name: &str) -> VariableSpec {
    VariableSpec {
        name: name.into(),
        ..VariableSpec::default()
    }
}

/// The scene `ball` with a ball of 82 vertices.
pub(crate) fn ball() -> Scene {
    const RINGS: u32 = 8;
    const SECTORS: u32 = 10;
    let mut scene = builtin::scene("ball").expect("built in");
    let ball = scene
        .shapes_mut()
        .find(|shape| shape.id == "ball")
        .expect("a ball");
    let centre = ball.centre();
    let mut normals = vec![Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, -1.0, 0.0)];
    for ring in 1..=RINGS {
        let (height, width) = (f64::from(ring) * PI / f64::from(RINGS + 1)).sin_cos();
        for sector in 0..SECTORS {
            let (sin, cos) = (f64::from(sector) * TAU / f64::from(SECTORS)).sin_cos();
            normals.push(Vec3::new(height * cos, width, -height * sin));
        }
    }
    let at = |ring: u32, sector: u32| 2 + ring * SECTORS + sector % SECTORS;
    let mesh = &mut ball.mesh;
    mesh.faces.clear();
    for s in 0..SECTORS {
        mesh.faces.push([0, at(0, s), at(0, s + 1)]);
        mesh.faces.push([1, at(RINGS - 1, s + 1), at(RINGS - 1, s)]);
        for r in 1..RINGS {
            mesh.faces.push([at(r - 1, s), at(r, s), at(r, s + 1)]);
            mesh.faces
                .push([at(r - 1, s), at(r, s + 1), at(r - 1, s + 1)]);
        }
    }
    mesh.positions = normals.iter().map(|&n| centre + n * 0.5).collect();
    ball.normals = ShadingNormals::Given(normals);
    scene
}

pub(crate) fn variables(scene: &Scene, specs: &[VariableSpec]) -> Variables {
    let made = specs
        .iter()
        .map(|spec| variable(scene, &Registry::new(scene), spec).expect("fine"));
    Variables::new(scene, made.collect()).expect("they fit")
}

/// Numbers that look random, in [-1, 1).
fn random(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut number = || {
        state = Seed(state).of_iteration(0, 0, Purpose::Image).0;
        2.0 * (state >> 11) as f64 / (1u64 << 53) as f64 - 1.0
    };
    (0..count).map(|_| number()).collect()
}

/// Groups of specs that can stand together, of every kind.
fn cases() -> Vec<Vec<VariableSpec>> {
    let vertices = |directions, vertices, lambda| VariableSpec {
        directions: Some(directions),
        vertices: Some(vertices),
        lambda,
        ..spec("ball.positions")
    };
    let x = Vec3::new(1.0, 0.0, 0.0);
    let z = Vec3::new(0.0, 0.0, 1.0);
    let some = Selection::Numbers(vec![3..20, 20..40]);
    vec![
        vec![
            spec("floor.translate"),
            spec("floor.rotate.y"),
            spec("ball.translate.x"),
            spec("ball.translate.z"),
            spec("ball.rotate.x"),
            spec("ball.rotate.y"),
            spec("ball.rotate.z"),
            spec("ball.scale"),
            spec("sensor.rotate.x"),
            spec("sensor.rotate.z"),
            spec("lamp.emitter.radiance.value.g"),
        ],
        vec![
            spec("sensor.rotate"),
            spec("sensor.translate"),
            spec("sensor.x_fov"),
            spec("floor.bsdf.reflectance.value"),
            spec("lamp.translate.x - 2*floor.translate.y"),
        ],
        vec![spec("ball.positions"), spec("ball.normals")],
        vec![spec("ball.to_world"), spec("sensor.to_world")],
        vec![vertices(Directions::Plane([x, z]), some.clone(), None)],
        vec![
            vertices(Directions::Normals, Selection::All, Some(9.0)),
            spec("ball.translate.y - ball.translate.x"),
        ],
        vec![vertices(Directions::Radial(None), some.clone(), Some(2.0))],
        vec![vertices(Directions::Radial(Some(x)), some.clone(), None)],
        vec![vertices(Directions::Along(x + z * 0.5), some, None)],
        vec![
            VariableSpec {
                curve: Some(Curve::Log),
                ..spec("lamp.emitter.radiance.value")
            },
            VariableSpec {
                curve: Some(Curve::Sigmoid),
                bounds: Some([-0.5, 2.0]),
                ..spec("floor.bsdf.reflectance.value")
            },
        ],
    ]
}

/// All numbers of a scene that a motion moves, in the same order as those of the
/// motion.
fn difference(a: &Scene, b: &Scene, step: f64) -> Tangent {
    let mut tangent = Tangent::zero(a);
    for (i, (a, b)) in a.shapes.iter().zip(&b.shapes).enumerate() {
        let rate = |a: &[Vec3], b: &[Vec3]| -> Vec<Vec3> {
            a.iter().zip(b).map(|(&a, &b)| (b - a) / step).collect()
        };
        let normals = match (&a.normals, &b.normals) {
            (ShadingNormals::Given(a), ShadingNormals::Given(b)) => Some(rate(a, b)),
            _ => None,
        };
        tangent.shapes[i] = Some(capwalk_scene::ShapeVectors {
            vertices: rate(&a.mesh.positions, &b.mesh.positions),
            normals,
        });
    }
    for (i, (a, b)) in a.textures.iter().zip(&b.textures).enumerate() {
        let rates = a.data.iter().zip(&b.data).map(|(a, b)| (b - a) / step);
        tangent.textures[i] = Some(rates.collect());
    }
    tangent
}

/// The Euclidean norm of all velocities.
fn norm(tangent: &Tangent) -> f64 {
    let sum = std::cell::Cell::new(0.0);
    tangent.map(|x| {
        sum.set(sum.get() + x * x);
        x
    });
    sum.into_inner().sqrt()
}

/// The motion of a sensor as that of its state.
fn sensor_velocities(scene: &Scene, tangent: &Tangent) -> Vec<Vec3> {
    let state = scene.sensor.moving_state(&tangent.sensor);
    let mut all = state.axes.map(|axis| axis.tangent(0)).to_vec();
    all.extend([state.origin.tangent(0), state.optics.tangent(0)]);
    all
}

/// `push` is the derivative of `apply` by central differences, away from rest.
#[test]
fn pushes_are_derivatives() {
    let base = ball();
    for specs in cases() {
        let variables = variables(&base, &specs);
        let count = variables.count();
        let nudge = random(count, 1);
        let unknowns: Vec<f64> = variables
            .initial()
            .iter()
            .zip(&nudge)
            .map(|(u, n)| u + 0.1 * n)
            .collect();
        let values = variables.values(&unknowns);
        let mut velocities = random(count, 2);
        // The last row of a matrix stays.
        for (variable, range) in variables.iter() {
            if variable.name.ends_with("to_world") {
                velocities[range.start + 12..range.end].fill(0.0);
            }
        }
        let mut values = values;
        for (variable, range) in variables.iter() {
            if variable.name.ends_with("to_world") {
                values[range.start + 12..range.end].copy_from_slice(&[0.0, 0.0, 0.0, 1.0]);
            }
        }
        let h = 1e-5;
        let at = |h: f64| {
            let moved: Vec<f64> = values
                .iter()
                .zip(&velocities)
                .map(|(x, v)| x + h * v)
                .collect();
            variables.apply(&base, &moved).expect("a scene")
        };
        let scene = at(0.0);
        let (low, high) = (at(-h), at(h));
        let mut error = variables.push(&base, &scene, &values, &velocities);
        // Normals that were nudged are made unit: only their direction is compared.
        let differences = difference(&low, &high, 2.0 * h);
        let moving = norm(&error);
        assert!(moving > 0.03, "{specs:?}");
        let expected = sensor_velocities(&scene, &error);
        let sensor = [&low, &high].map(|scene| {
            let state = scene.sensor.state();
            [&state.axes[..], &[state.origin, state.optics]].concat()
        });
        for (i, expected) in expected.iter().enumerate() {
            let found = (sensor[1][i] - sensor[0][i]) / (2.0 * h);
            assert!((found - *expected).length() < 1e-7, "{specs:?} sensor {i}");
        }
        error.sensor = SensorVectors::default();
        error.add(&differences.scaled(-1.0));
        let worst = norm(&error);
        let scale = 1.0 + norm(&differences);
        let normals_nudged = specs.iter().any(|spec| spec.name == "ball.normals");
        let tolerance = if normals_nudged { 0.2 } else { 1e-6 };
        assert!(worst < tolerance * scale, "{specs:?}: {worst} of {scale}");
    }
}

/// `<J x, y> = <x, Jᵀ y>` for values and for unknowns, away from rest.
#[test]
fn pulls_are_transposes() {
    let base = ball();
    for specs in cases() {
        let variables = variables(&base, &specs);
        let count = variables.count();
        let nudge = random(count, 3);
        let mut unknowns: Vec<f64> = variables
            .initial()
            .iter()
            .zip(&nudge)
            .map(|(u, n)| u + 0.1 * n)
            .collect();
        for (variable, range) in variables.iter() {
            if variable.name.ends_with("to_world") {
                unknowns[range.start + 12..range.end].copy_from_slice(&[0.0, 0.0, 0.0, 1.0]);
            }
        }
        let values = variables.values(&unknowns);
        let scene = variables.apply(&base, &values).expect("a scene");
        let velocities = random(count, 4);
        let tangent = variables.push(&base, &scene, &values, &velocities);
        // Any covector on everything.
        let mut seed = 10;
        let mut vectors = |count: usize| -> Vec<Vec3> {
            seed += 1;
            let numbers = random(3 * count, seed);
            numbers
                .chunks_exact(3)
                .map(|v| Vec3::new(v[0], v[1], v[2]))
                .collect()
        };
        let mut covector = Gradient::zero(&scene);
        for (i, shape) in scene.shapes.iter().enumerate() {
            covector.shapes[i] = Some(capwalk_scene::ShapeVectors {
                vertices: vectors(shape.mesh.positions.len()),
                normals: shape.normals.per_vertex().map(|n| vectors(n.len())),
            });
        }
        for (i, texture) in scene.textures.iter().enumerate() {
            covector.textures[i] = Some(random(texture.data.len(), 100 + i as u64));
        }
        let all = vectors(3);
        covector.sensor.translation = all[0];
        covector.sensor.rotation = all[1];
        covector.sensor.optics = all[2];
        let shape_matrix = specs.iter().any(|spec| spec.name == "ball.to_world");
        if shape_matrix {
            // Turns of the sensor are not those of its axes: no inner product.
            covector.sensor = SensorVectors::default();
        }
        let pulled = variables.pull(&base, &scene, &values, &covector);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut compared = tangent;
        if shape_matrix {
            // The last rows have no derivative.
            compared.sensor = SensorVectors::default();
        }
        let (left, right) = (covector.dot(&compared), dot(&velocities, &pulled));
        assert!(left.abs() > 1e-3, "{specs:?}: nothing to compare");
        assert!(
            (left - right).abs() < 1e-9 * left.abs().max(1.0),
            "{specs:?}: {left} {right}"
        );

        // The same through the reparameterizations, whose derivative is by differences.
        let by_unknowns = variables.pull_reparameterization(&unknowns, &pulled);
        let at = |h: f64| {
            let moved: Vec<f64> = unknowns
                .iter()
                .zip(&velocities)
                .map(|(u, v)| u + h * v)
                .collect();
            dot(&variables.values(&moved), &pulled)
        };
        let difference = (at(1e-6) - at(-1e-6)) / 2e-6;
        let derivative = dot(&by_unknowns, &velocities);
        assert!(
            (difference - derivative).abs() < 1e-6 * derivative.abs().max(1.0),
            "{specs:?}: {difference} {derivative}"
        );
    }
}

/// Three numbers are the vector, beside other numbers of the same place; and the matrix of a
/// shape goes with it.
#[test]
fn translations_are_vectors() {
    let base = ball();
    let others = [spec("ball.rotate.z"), spec("ball.scale")];
    let scene_of = |names: &[&str], values: &[f64]| {
        let specs: Vec<_> = names.iter().map(|name| spec(name)).collect();
        let variables = variables(&base, &[&specs[..], &others].concat());
        let scene = variables.apply(&base, &[values, &[0.3, 1.5]].concat());
        let result = variables.result(0, &base, &variables.initial());
        (scene.expect("a scene"), result)
    };
    let numbers = ["x", "y", "z"].map(|axis| format!("ball.translate.{axis}"));
    let numbers = numbers.each_ref().map(|name| name.as_str());
    let (by_numbers, _) = scene_of(&numbers, &[0.5, -0.2, 0.1]);
    let (by_vector, result) = scene_of(&["ball.translate"], &[0.5, -0.2, 0.1]);
    assert!(by_numbers == by_vector && by_vector != base);
    assert_eq!((result.shape, result.numbers), (vec![3], vec![0.0; 3]));
    // In the coordinates of its file a shape stays as it is.
    let place = |scene: &Scene| {
        let shape = scene.shapes.iter().find(|shape| shape.id == "ball");
        let shape = shape.expect("a ball").clone();
        let object_from_world = shape.world_from_object.inverse().expect("it has one");
        shape
            .mesh
            .positions
            .iter()
            .map(|&p| object_from_world.point(p))
            .collect::<Vec<_>>()
    };
    for (there, here) in place(&base).into_iter().zip(place(&by_vector)) {
        assert!((there - here).length() < 1e-12);
    }
}

/// Copies of a vertex move together and are one unknown.
#[test]
fn seams_are_one_unknown() {
    let mut scene = ball();
    let index = scene
        .shapes
        .iter()
        .position(|s| s.id == "ball")
        .expect("a ball");
    let mesh = &mut scene.shape_mut(capwalk_scene::ShapeId(index as u32)).mesh;
    let count = mesh.positions.len();
    let copy = mesh.positions[5];
    mesh.positions.push(copy);
    let with_it = mesh
        .faces
        .iter()
        .position(|face| face.contains(&5))
        .expect("it is used");
    mesh.faces[with_it] = mesh.faces[with_it].map(|i| if i == 5 { count as u32 } else { i });
    scene
        .shape_mut(capwalk_scene::ShapeId(index as u32))
        .normals = ShadingNormals::Face;
    let variables = variables(&scene, &[spec("ball.positions")]);
    assert_eq!(variables.count(), 3 * count);
    let mut values = vec![0.0; 3 * count];
    values[3 * 5 + 1] = 0.25;
    let moved = variables.apply(&scene, &values).expect("nothing tears");
    let positions = &moved.shapes[index].mesh.positions;
    assert_eq!(positions[5], copy + Vec3::new(0.0, 0.25, 0.0));
    assert_eq!(positions[count], positions[5]);
}

/// The rim of a disk of 25 vertices in a plane: the fifty unknowns of figure 12.
#[test]
fn rim_of_a_disk_in_its_plane() {
    let mut scene = builtin::scene("leaf").expect("built in");
    let index = scene
        .shapes
        .iter()
        .position(|s| s.id == "leaf")
        .expect("a leaf");
    let rim = (0..25).map(|i| {
        let (sin, cos) = (f64::from(i) / 25.0 * std::f64::consts::TAU).sin_cos();
        Vec3::new(cos, 1.5, sin)
    });
    let mesh = &mut scene.shape_mut(capwalk_scene::ShapeId(index as u32)).mesh;
    mesh.positions = std::iter::once(Vec3::new(0.0, 1.5, 0.0))
        .chain(rim)
        .collect();
    mesh.faces = (0..25).map(|i| [0, 1 + i, 1 + (i + 1) % 25]).collect();
    let plane = Directions::Plane([Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.0)]);
    let spec = VariableSpec {
        vertices: Some(Selection::Border),
        directions: Some(plane),
        ..spec("leaf.positions")
    };
    let variables = variables(&scene, std::slice::from_ref(&spec));
    assert_eq!(variables.count(), 50);
    let indices = VariableSpec {
        vertices: Some(Selection::Numbers(vec![1..2, 2..26])),
        ..spec
    };
    let same = super::variable(&scene, &Registry::new(&scene), &indices).expect("fine");
    assert_eq!(same.initial.len(), 50);
    let moved = variables.apply(&scene, &random(50, 9)).expect("a scene");
    let heights = moved.shapes[index].mesh.positions.iter().map(|p| p.y);
    assert!(heights.into_iter().all(|y| y == 1.5));
}

#[test]
fn names_and_values_are_those_of_the_scene() {
    let scene = ball();
    let initial = |name: &str| {
        variable(&scene, &Registry::new(&scene), &spec(name))
            .expect("fine")
            .initial
    };
    assert_eq!(initial("ball.scale"), [1.0]);
    assert_eq!(initial("ball.rotate.y"), [0.0]);
    assert_eq!(initial("lamp.emitter.radiance.value"), [34.0; 3]);
    assert_eq!(initial("lamp.emitter.radiance.value.r"), [34.0]);
    assert_eq!(initial("1*lamp.emitter.radiance.value"), [0.0]);
    assert_eq!(initial("sensor.x_fov").len(), 1);
    // A value of 40 is a radiance of 40.
    let variables = variables(&scene, &[spec("lamp.emitter.radiance.value.r")]);
    let bright = variables.apply(&scene, &[40.0]).expect("a scene");
    let radiance = bright
        .textures
        .iter()
        .find(|t| t.id == "lamp.emitter.radiance");
    assert_eq!(radiance.expect("it is there").data, [40.0, 34.0, 34.0]);
    let dark = variables.apply(&scene, &[-1.0]).expect_err("dark");
    assert!(dark.to_string().contains("at least 0"), "{dark}");
}

#[track_caller]
pub(crate) fn refused(specs: &[VariableSpec], part: &str) {
    let scene = ball();
    let made: Result<Vec<_>, _> = specs
        .iter()
        .map(|spec| variable(&scene, &Registry::new(&scene), spec))
        .collect();
    let error = made
        .and_then(|made| Variables::new(&scene, made))
        .expect_err(part);
    assert!(error.to_string().contains(part), "{error}");
}

#[test]
fn what_does_not_fit_is_refused() {
    refused(&[spec("ball.translat.x")], "ball.translate.x");
    let one = spec("ball.translate.x");
    refused(&[one.clone(), one.clone()], "twice");
    refused(&[spec("ball.positions"), one.clone()], "the same numbers");
    refused(&[spec("ball.to_world"), one.clone()], "the same numbers");
    for other in ["ball.translate.x", "ball.positions", "ball.to_world"] {
        refused(&[spec("ball.translate"), spec(other)], "the same numbers");
    }
    refused(
        &[spec("sensor.rotate"), spec("sensor.to_world")],
        "the same numbers",
    );
    refused(
        &[spec("ball.normals[0,0]")],
        "name the array \"ball.normals\"",
    );
    refused(
        &[spec("ball.rotate.x + ball.rotate.y")],
        "a sum with a rotation",
    );
    let with = |change: &dyn Fn(&mut VariableSpec)| {
        let mut spec = one.clone();
        change(&mut spec);
        spec
    };
    refused(
        &[with(&|w| w.lambda = Some(3.0))],
        "`lambda` has no meaning",
    );
    refused(
        &[with(&|w| w.bounds = Some([1.0, 0.0]))],
        "the lower one first",
    );
    refused(&[with(&|w| w.bounds = Some([0.5, 1.0]))], "cannot be 0");
    refused(&[with(&|w| w.curve = Some(Curve::Log))], "above 0");
    refused(&[with(&|w| w.start = Some(vec![1.0, 2.0]))], "2 numbers");
    let positions = |selection| VariableSpec {
        vertices: Some(selection),
        ..spec("ball.positions")
    };
    refused(&[positions(Selection::Border)], "no vertex is selected");
    for (beyond, text) in [
        (999..1000, "no vertex 999"),
        (7..usize::MAX, "no vertex 82"),
    ] {
        refused(&[positions(Selection::Numbers(vec![0..1, beyond]))], text);
    }
    let both = VariableSpec {
        lambda: Some(3.0),
        bounds: Some([-1.0, 1.0]),
        ..spec("ball.positions")
    };
    refused(&[both], "both `lambda` and bounds");
    let stiff = VariableSpec {
        lambda: Some(1e13),
        ..spec("ball.positions")
    };
    refused(&[stiff], "a number from 0 to 1e12");
}
