use super::super::tests::{example, numbers};
use super::super::{Registry, Request};
use super::*;
use crate::scene_vector::{Gradient, SensorVectors};
use crate::shape::Attribute;
use crate::texture::{Bitmap, Pattern, TexelFilter, Texture, UvTransform, Wrap};

/// The example with a seam: the last vertex of the ball lies on the first.
fn with_seam() -> Scene {
    let mut scene = example();
    let positions = &mut scene.shape_mut(ShapeId(0)).mesh.positions;
    *positions.last_mut().expect("a ball") = positions[0];
    scene
}

/// The scene of `with_seam` with numbers in all forms that textures have.
fn with_textures() -> Scene {
    let mut scene = with_seam();
    let data = |count: usize| random(count, 9).iter().map(|x| x * x).collect();
    let mut form = |id: u32, channels, data, pattern| {
        let texture = scene.texture_mut(TextureId(id));
        (texture.channels, texture.data, texture.pattern) = (channels, data, pattern);
    };
    let to_uv = UvTransform::IDENTITY;
    form(0, 3, data(6), Pattern::Checkerboard { to_uv });
    let bitmap = Bitmap {
        width: 3,
        height: 2,
        filter: TexelFilter::Bilinear,
        wrap: Wrap::Repeat,
        to_uv,
    };
    form(1, 1, data(6), Pattern::Bitmap(bitmap));
    form(3, 1, data(1), Pattern::Constant);
    scene.add_texture(Texture {
        id: "ball.vertex_color".into(),
        channels: 3,
        data: data(42 * 3),
        pattern: Pattern::PerVertex,
    });
    scene.shape_mut(ShapeId(0)).attributes.push(Attribute {
        name: "vertex_color".into(),
        texture: TextureId(4),
    });
    scene
}

/// Numbers between -1 and 1 that look random.
fn random(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

/// Velocities that vertices at the same place share, and that keep the last rows
/// of matrices.
fn admissible(scene: &Scene, array: &ArrayParameter) -> Vec<f64> {
    let mut velocities = random(array.count(), 21);
    match array.place {
        Place::ShapeToWorld(_) | Place::SensorToWorld => {
            velocities[12..].fill(0.0);
            velocities
        }
        Place::Positions(id) => {
            let positions = &scene.shape(id).mesh.positions;
            flat(&shared(&weld(positions), &vectors(&velocities)))
        }
        _ => velocities,
    }
}

fn named(scene: &Scene, name: &str) -> ArrayParameter {
    let registry = Registry::new(scene);
    let array = registry.array(name).expect("one thing").expect(name);
    array.clone()
}

fn tangent(scene: &Scene, expression: &str) -> Result<Tangent, ParameterError> {
    Registry::new(scene).tangent(scene, expression)
}

fn request(scene: &Scene, text: &str) -> Result<Request, ParameterError> {
    Registry::new(scene).request(scene, text)
}

fn stepped(scene: &Scene, array: &ArrayParameter, velocities: &[f64], step: f64) -> Scene {
    let old = array.get(scene);
    let new: Vec<f64> = old
        .iter()
        .zip(velocities)
        .map(|(x, v)| x + step * v)
        .collect();
    let mut scene = scene.clone();
    array.set(&mut scene, &new).expect("admissible");
    scene
}

#[test]
fn arrays_are_listed_in_the_order_of_parameters() {
    let listed: Vec<(String, String)> = Registry::new(&example())
        .arrays()
        .iter()
        .map(|array| (array.name.clone(), array.shape_text()))
        .collect();
    let expected = [
        ("ball.positions", "(42, 3)"),
        ("ball.vertex_positions", "(42, 3)"),
        ("ball.normals", "(42, 3)"),
        ("ball.vertex_normals", "(42, 3)"),
        ("ball.to_world", "(4, 4)"),
        ("ball.translate", "(3,)"),
        ("lamp.positions", "(4, 3)"),
        ("lamp.vertex_positions", "(4, 3)"),
        ("lamp.to_world", "(4, 4)"),
        ("lamp.translate", "(3,)"),
        ("-a.b+2*c.positions", "(225, 3)"),
        ("-a.b+2*c.vertex_positions", "(225, 3)"),
        ("-a.b+2*c.to_world", "(4, 4)"),
        ("-a.b+2*c.translate", "(3,)"),
        ("lamp.emitter.radiance.value", "(3,)"),
        ("sky.radiance.value", "(3,)"),
        ("red.reflectance.value", "(3,)"),
        ("both.reflectance.value", "(3,)"),
        ("ball.bsdf.reflectance.value", "(3,)"),
        ("lamp.bsdf.reflectance.value", "(3,)"),
        ("sensor.translate", "(3,)"),
        ("eye.translate", "(3,)"),
        ("sensor.rotate", "(3,)"),
        ("sensor.to_world", "(4, 4)"),
        ("eye.rotate", "(3,)"),
        ("eye.to_world", "(4, 4)"),
        ("sensor.x_fov", "(1,)"),
        ("eye.x_fov", "(1,)"),
        ("sensor.aperture_radius", "(1,)"),
        ("eye.aperture_radius", "(1,)"),
        ("sensor.focus_distance", "(1,)"),
        ("eye.focus_distance", "(1,)"),
    ];
    assert_eq!(
        listed,
        expected.map(|(name, shape)| (name.into(), shape.into()))
    );
    let alias = |name: &str| named(&example(), name).alias_of;
    assert_eq!(
        alias("both.reflectance.value").as_deref(),
        Some("red.reflectance.value")
    );
    assert_eq!(alias("eye.rotate").as_deref(), Some("sensor.rotate"));
    assert_eq!(alias("sensor.rotate"), None);
    let scene = with_textures();
    for (name, shape) in [
        ("red.reflectance.color0.value", "(3,)"),
        ("ball.bsdf.reflectance.color1.value", "(3,)"),
        ("lamp.bsdf.reflectance.data", "(2, 3, 1)"),
        ("sky.radiance.value", "(1,)"),
        ("ball.vertex_color", "(42, 3)"),
    ] {
        assert_eq!(named(&scene, name).shape_text(), shape, "{name}");
    }
    // The short name of a single number is a scalar's.
    assert_eq!(Registry::new(&scene).array("sky.radiance"), Ok(None));
}

/// Each array has numbers of its own.
#[test]
fn parts_of_a_texture_are_apart() {
    let scene = with_textures();
    let data = &scene.textures[0].data;
    for (part, range) in [("color0", 0..3), ("color1", 3..6)] {
        let array = named(&scene, &format!("red.reflectance.{part}.value"));
        assert_eq!(array.get(&scene), data[range], "{part}");
    }
}

/// Setting numbers does what their motion says, for every array: differences of
/// everything in the scene on both ways.
#[test]
fn every_array_means_what_it_says() {
    let scene = with_textures();
    let h = 1e-5;
    for array in Registry::new(&scene).arrays() {
        assert_eq!(array.get(&scene).len(), array.count(), "{}", array.name);
        let velocities = admissible(&scene, array);
        let tangent = array.tangent(&scene, &velocities);
        let set = [h, -h].map(|h| numbers(&stepped(&scene, array, &velocities, h)));
        let moved = [h, -h].map(|h| numbers(&scene.moved(&tangent, h)));
        let mut moves = false;
        for i in 0..set[0].len() {
            let [by_set, by_motion] = [&set, &moved].map(|x| (x[0][i] - x[1][i]) / (2.0 * h));
            let error = (by_set - by_motion).length();
            assert!(error < 1e-7, "{}: number {i}: {error:e}", array.name);
            moves |= by_set.length() > 0.1;
        }
        assert!(moves, "{} does nothing", array.name);
    }
}

/// A translation moves a shape from where it is, and its matrix says so; its derivatives are
/// those of its three numbers, and the sum over all vertices.
#[test]
fn translations_move_shapes_and_their_matrices() {
    let scene = example();
    for name in ["ball", "lamp", "-a.b+2*c"] {
        let named = |array: &str| named(&scene, &format!("{name}.{array}"));
        let (translate, to_world) = (named("translate"), named("to_world"));
        assert_eq!(translate.get(&scene), [0.0; 3]);
        let offset = [0.5, -0.25, 2.0];
        let mut moved = scene.clone();
        translate.set(&mut moved, &offset).expect("it moves");
        assert_eq!(translate.get(&moved), [0.0; 3], "from where it is");
        let [before, after] = [&scene, &moved].map(|scene| to_world.get(scene));
        for i in 0..3 {
            let shift = after[4 * i + 3] - before[4 * i + 3];
            assert!((shift - offset[i]).abs() < 1e-14, "{name}: {shift}");
        }
        // Back by the other way.
        to_world.set(&mut moved, &before).expect("it moves back");
        let pairs = numbers(&scene).into_iter().zip(numbers(&moved));
        for (there, back) in pairs {
            assert!((there - back).length() < 1e-12, "{name}");
        }

        let mut gradient = Gradient::zero(&scene);
        for (covectors, shape) in gradient.shapes.iter_mut().zip(&scene.shapes) {
            *covectors = Some(ShapeVectors {
                vertices: vectors(&random(3 * shape.mesh.positions.len(), 8)),
                normals: None,
            });
        }
        let by_vertices = named("positions").gradient(&scene, &gradient);
        let read = translate.gradient(&scene, &gradient);
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let total: f64 = by_vertices.iter().skip(axis).step_by(3).sum();
            assert!((read[axis] - total).abs() < 1e-12, "{name}.{letter}");
            let one = tangent(&scene, &format!("{name}.translate.{letter}"));
            let one = gradient.dot(&one.expect("a number"));
            assert!((read[axis] - one).abs() < 1e-12, "{name}.{letter}");
        }
    }
}

/// Matrices that cannot put anything in the world leave it as it was.
#[test]
fn wrong_matrices_are_refused() {
    let scene = example();
    for name in ["ball.to_world", "eye.to_world"] {
        let array = named(&scene, name);
        for (index, value, part) in [
            (13, 0.1, "last row"),
            (0, -9.0, "inverted"),
            (5, f64::NAN, "finite"),
        ] {
            let mut numbers = array.get(&scene);
            numbers[index] = value;
            let mut other = scene.clone();
            let error = array.set(&mut other, &numbers).expect_err("wrong");
            assert!(error.to_string().contains(part), "{name}: {error}");
            assert!(other == scene);
        }
    }
}

/// The same sum of products whether a gradient is read as an array or the
/// array's change as a motion.
#[test]
fn gradients_are_transposed_motions() {
    let scene = with_textures();
    let mut gradient = Gradient::zero(&scene);
    for (i, shape) in scene.shapes.iter().enumerate() {
        let count = 3 * shape.mesh.positions.len();
        let given = matches!(shape.normals, ShadingNormals::Given(_));
        gradient.shapes[i] = Some(ShapeVectors {
            vertices: vectors(&random(count, 3)),
            normals: given.then(|| vectors(&random(count, 4))),
        });
    }
    for (texture, covectors) in scene.textures.iter().zip(&mut gradient.textures) {
        *covectors = Some(random(texture.data.len(), 5));
    }
    gradient.sensor = SensorVectors {
        translation: vectors(&random(3, 1))[0],
        rotation: vectors(&random(3, 2))[0],
        axes: [0, 1, 2].map(|i| vectors(&random(9, 6))[i]),
        optics: vectors(&random(3, 8))[0],
    };
    for array in Registry::new(&scene).arrays() {
        let velocities = admissible(&scene, array);
        let read = array.gradient(&scene, &gradient);
        let dot: f64 = read.iter().zip(&velocities).map(|(a, b)| a * b).sum();
        let expected = gradient.dot(&array.tangent(&scene, &velocities));
        let name = &array.name;
        assert!((dot - expected).abs() < 1e-12, "{name}: {dot} {expected}");
        assert!(expected.abs() > 1e-3, "{name}: nothing to compare");
        // A step along it is admissible.
        stepped(&scene, array, &read, -0.01);
        let nothing = array.gradient(&scene, &Gradient::zero(&scene));
        assert_eq!(nothing, vec![0.0; array.count()], "{name}");
    }
}

#[test]
fn computed_normals_follow_positions() {
    let mut scene = example();
    let sheet = named(&scene, "-a.b+2*c.positions");
    let bent: Vec<f64> = sheet.get(&scene).iter().map(|x| x + 0.1 * x * x).collect();
    sheet.set(&mut scene, &bent).expect("admissible");
    let shape = &scene.shapes[2];
    assert_eq!(shape.normals, ShadingNormals::computed(&shape.mesh));
    assert_ne!(shape.normals, example().shapes[2].normals);
}

#[test]
fn bad_numbers_are_refused_and_change_nothing() {
    let scene = with_seam();
    let refused = |name: &str, numbers: Vec<f64>| {
        let mut changed = scene.clone();
        let error = named(&scene, name)
            .set(&mut changed, &numbers)
            .expect_err(name);
        assert_eq!(changed, scene, "{name}");
        error.to_string()
    };
    let message = refused("lamp.positions", vec![0.0; 11]);
    assert!(
        message.contains("11 numbers") && message.contains("(4, 3)"),
        "{message}"
    );
    let mut numbers = vec![0.5; 3];
    numbers[1] = f64::NAN;
    let message = refused("sky.radiance.value", numbers);
    assert!(
        message.contains("number 1") && message.contains("NaN"),
        "{message}"
    );
    let message = refused("ball.normals", vec![0.0; 42 * 3]);
    assert!(message.contains("longer than 0"), "{message}");
    let message = refused("ball.positions", random(42 * 3, 1));
    assert!(
        message.contains("vertices 0 and 41") && message.contains("tear"),
        "{message}"
    );
}

#[test]
fn requests_are_arrays_or_expressions() {
    let scene = example();
    let is_array = |text: &str| matches!(request(&scene, text).expect(text), Request::Array(_));
    for text in [
        "ball.positions",
        "-a.b+2*c.positions",
        "red.reflectance.value",
        " eye.rotate ",
        "ball.translate",
        "ball.vertex_positions",
    ] {
        assert!(is_array(text), "{text}");
    }
    for text in [
        "ball.translate.x",
        "1*red.reflectance.value",
        "eye.rotate.x",
        "red.reflectance.value.g",
    ] {
        assert!(!is_array(text), "{text}");
    }
    let message = |text: &str| request(&scene, text).expect_err(text).to_string();
    for (text, part) in [
        ("bal.positions", "did you mean `ball.positions`"),
        (
            "lamp.radiance.value",
            "did you mean `lamp.emitter.radiance.value`",
        ),
        ("ball.translate.w", "`ball.translate.x`"),
        (
            "ball.vertexPositions",
            "did you mean `ball.vertex_positions`?",
        ),
        (
            "ball.vertex_texcoords",
            "\"ball.vertex_texcoords\" is not a parameter: derivatives with respect to texture coordinates",
        ),
        ("2*ball.positions", "\"ball.positions\" is an array"),
        ("ball.positions[42]", "(42, 3)"),
        ("2*ball.positions[1,x]", "\"[1,x]\""),
        ("ball.positions[1,0,0]", "\"[1,0,0]\""),
        ("ball.positions[1", "\"[1\"; expected whole numbers"),
        ("ball.positions[1]a", "expected whole numbers"),
        ("lamp.normals", "no parameter \"lamp.normals\""),
        ("mixed.reflectance.value", "made of different ones"),
        ("", "expected a parameter's name"),
    ] {
        assert!(message(text).contains(part), "{text}: {}", message(text));
    }
    let scalar = tangent(&scene, "ball.positions").expect_err("an array");
    assert!(scalar.to_string().contains("is an array"), "{scalar}");
    let mut twice = example();
    twice.texture_mut(TextureId(2)).id = "sky.radiance".into();
    let error = request(&twice, "sky.radiance.value").expect_err("ambiguous");
    assert!(
        error.to_string().contains("two different things"),
        "{error}"
    );
}

/// Elements of arrays are parameters: their motion is what the array's own is
/// with a one in their place, and vertices at the same place stay together.
#[test]
fn elements_are_parameters() {
    let scene = example();
    let tangent = |scene: &Scene, text: &str| tangent(scene, text).expect(text);
    for (text, name, numbers) in [
        ("ball.positions[7,2]", "ball.positions", vec![(23, 1.0)]),
        (
            "-2*ball.normals[ 3 ]",
            "ball.normals",
            vec![(9, -2.0), (10, -2.0), (11, -2.0)],
        ),
        (
            "eye.translate[1]+ 0.5*eye.translate[2]",
            "eye.translate",
            vec![(1, 1.0), (2, 0.5)],
        ),
        (
            "sky.radiance.value[1]",
            "sky.radiance.value",
            vec![(1, 1.0)],
        ),
        (
            "-a.b+2*c.positions[4,0]",
            "-a.b+2*c.positions",
            vec![(12, 1.0)],
        ),
    ] {
        let array = named(&scene, name);
        let mut velocities = vec![0.0; array.count()];
        for (index, velocity) in numbers {
            velocities[index] = velocity;
        }
        let expected = array.tangent(&scene, &velocities);
        assert_eq!(tangent(&scene, text), expected, "{text}");
    }
    let mixed = tangent(&scene, "ball.translate.x - ball.positions[0,0]");
    let ball = mixed.shapes[0].clone().expect("it moves");
    assert_eq!(ball.vertices[0], Vec3::zero());
    assert_eq!(ball.vertices[1], Vec3::new(1.0, 0.0, 0.0));

    let seamed = with_seam();
    let count = seamed.shapes[0].mesh.positions.len();
    let welded = tangent(&seamed, &format!("ball.positions[{},1]", count - 1));
    let ball = welded.shapes[0].clone().expect("it moves");
    let moved: Vec<usize> = (0..count)
        .filter(|&i| ball.vertices[i] == Vec3::new(0.0, 1.0, 0.0))
        .collect();
    assert_eq!(moved, [0, count - 1]);
}
