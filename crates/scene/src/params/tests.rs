use super::*;
use crate::emitter::Emitter;
use crate::film::Film;
use crate::filter::Filter;
use crate::ids::{BsdfId, EmitterId, ShapeId, TextureId};
use crate::material::bsdf::{Bsdf, Material};
use crate::material::lobe::Diffuse;
use crate::primitive;
use crate::scene::Scene;
use crate::scene_vector::Tangent;
use crate::sensor::{Sensor, SensorModel};
use crate::settings::{Integrator, SamplerKind, Settings};
use crate::shape::{ShadingNormals, Shape};
use crate::texture::Texture;
use std::sync::Arc;

use capwalk_math::{Affine, Rgb, Vec3};

fn list(scene: &Scene) -> Vec<Parameter> {
    Registry::new(scene).scalars(scene)
}

fn tangent(scene: &Scene, expression: &str) -> Result<Tangent, ParameterError> {
    Registry::new(scene).tangent(scene, expression)
}

fn request(scene: &Scene, text: &str) -> Result<Request, ParameterError> {
    Registry::new(scene).request(scene, text)
}

/// A ball, an emitter, and a sheet whose id holds all that could confuse a parser.
pub(super) fn example() -> Scene {
    let place = Affine::translate(Vec3::new(0.4, 1.0, -0.3))
        * Affine::rotate(Vec3::new(1.0, 2.0, 0.5), 0.4)
        * Affine::scale(Vec3::new(1.0, 0.5, 0.8));
    let mut ball = primitive::icosphere(2);
    let given = ball.positions.iter().map(|&n| place.normal(n).normalized());
    let given = given.collect();
    ball.positions.iter_mut().for_each(|p| *p = place.point(*p));
    let (emitter, _) = primitive::rectangle(Affine::translate(Vec3::new(0.0, 3.0, 0.1)));
    let (sheet, _) = primitive::disk(place);
    let shape = |id: &str, mesh, normals, bsdf, emitter| Shape {
        emitter,
        ..Shape::new(id, mesh, normals, BsdfId(bsdf))
    };
    let computed = ShadingNormals::computed(&sheet);
    let diffuse = |id: &str, reflectance| Material {
        id: id.into(),
        bsdf: Bsdf::from(Diffuse {
            reflectance: TextureId(reflectance),
        }),
    };
    let two_sided = |id: &str, front, back| Material {
        id: id.into(),
        bsdf: Bsdf::TwoSided {
            front: BsdfId(front),
            back: BsdfId(back),
        },
    };
    Scene {
        shapes: [
            Shape {
                world_from_object: place,
                ..shape("ball", ball, ShadingNormals::Given(given), 2, None)
            },
            shape("lamp", emitter, ShadingNormals::Face, 1, Some(EmitterId(0))),
            shape("-a.b+2*c", sheet, computed, 3, None),
        ]
        .map(Arc::new)
        .to_vec(),
        materials: vec![
            diffuse("red", 0),
            diffuse("lamp.bsdf", 1),
            two_sided("both", 0, 0),
            two_sided("mixed", 0, 1),
        ],
        emitters: vec![
            Emitter::Area {
                shape: ShapeId(1),
                radiance: TextureId(2),
            },
            Emitter::Constant {
                id: "sky".into(),
                radiance: TextureId(3),
            },
        ],
        textures: [
            Texture::colour("red.reflectance", Rgb::new(0.8, 0.1, 0.2)),
            Texture::colour("lamp.bsdf.reflectance", Rgb::splat(0.5)),
            Texture::colour("lamp.emitter.radiance", Rgb::new(5.0, 6.0, 7.0)),
            Texture::colour("sky.radiance", Rgb::splat(0.25)),
        ]
        .map(Arc::new)
        .to_vec(),
        sensor: Sensor {
            id: "eye".into(),
            world_from_camera: Affine::translate(Vec3::new(0.0, 1.0, -5.0))
                * Affine::rotate(Vec3::new(0.1, 1.0, 0.0), 0.2),
            model: SensorModel::ThinLens {
                fov_x: 0.7,
                aperture_radius: 0.2,
                focus_distance: 3.0,
            },
            near_clip: 0.01,
            far_clip: 1e4,
        },
        film: Film::new(4, 3, Filter::Box),
        settings: Settings {
            integrator: Integrator::Direct {
                emitter_samples: 1,
                bsdf_samples: 1,
                hide_emitters: false,
            },
            spp: 4,
            sampler: SamplerKind::Independent,
            seed: 0,
        },
    }
}

/// Central differences of all positions, normals and colours of two scenes,
/// and of the images of some camera points.
pub(super) fn numbers(scene: &Scene) -> Vec<Vec3> {
    let mut numbers = Vec::new();
    for shape in &scene.shapes {
        numbers.extend_from_slice(&shape.mesh.positions);
        numbers.extend(shape.normals.per_vertex().into_iter().flatten());
    }
    for texture in &scene.textures {
        numbers.extend((0..texture.texels()).map(|i| Vec3::from(texture.texel(i).to_array())));
    }
    let camera = &scene.sensor.world_from_camera;
    numbers.extend([[0.0; 3], [1.0, 0.0, 0.0], [0.3, -0.2, 2.0]].map(|p| camera.point(p.into())));
    let optics = scene.sensor.state().optics;
    numbers.push(Vec3::new(optics.x.to_degrees(), optics.y, optics.z));
    numbers
}

/// What `name` should do, written down a second time: the scene changed by the
/// finite amount `h`.
fn changed(scene: &Scene, parameter: &Parameter, h: f64) -> Scene {
    let mut scene = scene.clone();
    let name = parameter.alias_of.as_ref().unwrap_or(&parameter.name);
    let axis = match &name[name.len() - 1..] {
        "x" | "r" => Vec3::new(1.0, 0.0, 0.0),
        "y" | "g" => Vec3::new(0.0, 1.0, 0.0),
        "z" | "b" => Vec3::new(0.0, 0.0, 1.0),
        _ => Vec3::splat(1.0),
    };
    let about = |p: Vec3, map: Affine| Affine::translate(p) * map * Affine::translate(-p);
    let shape = scene.shapes.iter().position(|s| name.starts_with(&s.id));
    let map = shape.map(|i| match parameter.kind {
        ParameterKind::Translation => Affine::translate(axis * h),
        ParameterKind::Rotation => about(scene.shapes[i].centre(), Affine::rotate(axis, h)),
        ParameterKind::Scale => about(
            scene.shapes[i].centre(),
            Affine::scale(Vec3::splat(1.0 + h)),
        ),
        _ => Affine::IDENTITY,
    });
    if let (Some(map), Some(i)) = (map, shape) {
        let shape = scene.shape_mut(ShapeId(i as u32));
        shape
            .mesh
            .positions
            .iter_mut()
            .for_each(|p| *p = map.point(*p));
        if let ShadingNormals::Given(n) | ShadingNormals::Computed(n) = &mut shape.normals {
            n.iter_mut().for_each(|n| *n = map.normal(*n).normalized());
        }
    }
    let camera = &mut scene.sensor.world_from_camera;
    match parameter.kind {
        ParameterKind::SensorTranslation => camera.translation += axis * h,
        ParameterKind::SensorRotation => {
            *camera = about(camera.translation, Affine::rotate(axis, h)) * *camera;
        }
        ParameterKind::FieldOfView
        | ParameterKind::ApertureRadius
        | ParameterKind::FocusDistance => {
            let SensorModel::ThinLens {
                fov_x,
                aperture_radius,
                focus_distance,
            } = &mut scene.sensor.model
            else {
                unreachable!("the example has a lens")
            };
            match parameter.kind {
                ParameterKind::FieldOfView => *fov_x += h.to_radians(),
                ParameterKind::ApertureRadius => *aperture_radius += h,
                _ => *focus_distance += h,
            }
        }
        ParameterKind::Radiance | ParameterKind::Reflectance => {
            let holders = ["red", "lamp.bsdf", "lamp.emitter", "sky"];
            let texture = holders.iter().position(|id| name.starts_with(id));
            let data = &mut scene
                .texture_mut(TextureId(texture.expect("one of them") as u32))
                .data;
            (0..3).for_each(|i| data[i] += axis[i] * h);
        }
        _ => {}
    }
    scene
}

/// Every listed name, alone: differences of the scene moved along its motion
/// equal differences of the scene changed by hand.
#[test]
fn every_name_means_what_it_says() {
    let scene = example();
    let h = 1e-5;
    let parameters = list(&scene);
    // 3 shapes × 7, 2 emitters × 4, `red` and its aliases `both`, `ball.bsdf`
    // and `lamp.bsdf` × 4, the sensor under two names × 9.
    assert_eq!(parameters.len(), 21 + 8 + 16 + 18);
    for parameter in parameters {
        let says = |word: &str| parameter.name.contains(word);
        let is_colour = says(".radiance") || says(".reflectance");
        assert_eq!(parameter.kind == ParameterKind::Radiance, says(".radiance"));
        assert_eq!(parameter.moves_discontinuities, !is_colour);
        let tangent = tangent(&scene, &parameter.name).expect("it is listed");
        let above = numbers(&scene.moved(&tangent, h));
        let below = numbers(&scene.moved(&tangent, -h));
        let expected_above = numbers(&changed(&scene, &parameter, h));
        let expected_below = numbers(&changed(&scene, &parameter, -h));
        let mut moves = false;
        for i in 0..above.len() {
            let difference = (above[i] - below[i]) / (2.0 * h);
            let expected = (expected_above[i] - expected_below[i]) / (2.0 * h);
            let error = (difference - expected).length();
            assert!(error < 1e-8, "{}: number {i}: {error:e}", parameter.name);
            moves |= difference.length() > 0.1;
        }
        assert!(moves, "{} does nothing", parameter.name);
    }
}

/// Unit normals turn without becoming longer, and only when the shape turns.
#[test]
fn given_normals_turn() {
    let scene = example();
    let normals = scene.shapes[0].normals.per_vertex().expect("given");
    let turning = tangent(&scene, "ball.rotate.y").expect("listed");
    let velocities = scene.normal_velocities(&turning, 0).expect("moves");
    for (n, v) in normals.iter().zip(velocities) {
        assert!((Vec3::new(n.z, 0.0, -n.x) - v).length() < 1e-15); // e_y × n
    }
    for name in ["ball.translate.x", "ball.scale"] {
        let tangent = tangent(&scene, name).expect("listed");
        let velocities = scene.normal_velocities(&tangent, 0).expect("moves");
        assert!(velocities.iter().all(|&v| v == Vec3::zero()), "{name}");
    }
}

#[test]
fn terms_add_with_signs_and_factors() {
    let scene = example();
    let one = |name: &str| tangent(&scene, name).expect(name);
    let sum = one(" ball.translate.x+ -0.5 * lamp.translate.y - 2*sensor.rotate.z ");
    assert_eq!(sum.shapes[0], one("ball.translate.x").shapes[0]);
    let emitter = sum.shapes[1].as_ref().expect("moves");
    assert!(
        emitter
            .vertices
            .iter()
            .all(|&v| v == Vec3::new(0.0, -0.5, 0.0))
    );
    assert_eq!(sum.sensor.rotation, Vec3::new(0.0, 0.0, -2.0));
    assert_eq!(
        one("1e+1*sky.radiance.value").textures[3],
        Some(vec![10.0; 3])
    );
    // The same texture twice.
    let both = one("sky.radiance.value - 3*sky.radiance.value.g");
    assert_eq!(both.textures[3], Some(vec![1.0, -2.0, 1.0]));
    // The same shape twice: a motion and a turn.
    let both = one("ball.translate.x + ball.rotate.z");
    let (moving, turning) = (one("ball.translate.x"), one("ball.rotate.z"));
    let vertex = |m: &Tangent| m.shapes[0].as_ref().expect("moves").vertices[5];
    assert_eq!(vertex(&both), vertex(&moving) + vertex(&turning));
    assert!(both.shapes[0].as_ref().expect("moves").normals.is_some());
}

#[test]
fn ids_may_contain_signs_and_dots() {
    let scene = example();
    for (text, x) in [
        ("-a.b+2*c.translate.x", 1.0),
        ("--a.b+2*c.translate.x", -1.0),
        ("3*-a.b+2*c.translate.x", 3.0),
        ("ball.translate.y + -a.b+2*c.translate.x", 1.0),
        ("ball.translate.y - -a.b+2*c.translate.x", -1.0),
    ] {
        let tangent = tangent(&scene, text).expect(text);
        let vertices = &tangent.shapes[2].as_ref().expect("moves").vertices;
        assert!(vertices.iter().all(|v| v.x == x), "{text}");
    }
}

#[test]
fn wrong_names_suggest_right_ones() {
    let scene = example();
    let message = |text: &str| tangent(&scene, text).expect_err(text).to_string();
    assert_eq!(
        message("bal.translate.x"),
        "the scene has no parameter \"bal.translate.x\"; did you mean `ball.translate.x`, \
         `ball.translate.y` or `ball.translate.z`?"
    );
    for (text, part) in [
        (
            "lamp.radiance.value",
            "did you mean `lamp.emitter.radiance.value`",
        ),
        (
            "ball.rotate",
            "`ball.rotate.x`, `ball.rotate.y` or `ball.rotate.z`",
        ),
        (
            "ball.translate.y + blal.scale",
            "no parameter \"blal.scale\"; did you mean `ball.scale`",
        ),
        ("gizmo.x + 2*ball.scale", "no parameter \"gizmo.x\""),
        (
            "x*ball.scale",
            "\"x\" stands before `*`; expected a finite number",
        ),
        (
            "inf*ball.scale",
            "\"inf\" stands before `*`; expected a finite number",
        ),
        ("", "expected a parameter's name"),
        ("ball.scale +", "expected a parameter's name"),
        ("mixed.reflectance.value", "made of different ones"),
        (
            "-a.b+2*c.bsdf.reflectance.value.r",
            "made of different ones",
        ),
        ("gizmo", "no parameter \"gizmo\""),
    ] {
        assert!(message(text).contains(part), "{text}: {}", message(text));
    }
}

/// Names of an object that exists suggest its own parameters, never those of
/// another.
#[test]
fn suggestions_stay_with_the_object() {
    let scene = example();
    for expression in ["ball.diffuse_reflectance.value", "1*ball.positons"] {
        let message = tangent(&scene, expression)
            .expect_err(expression)
            .to_string();
        for other in ["lamp", "red", "sensor", "-a.b"] {
            assert!(!message.contains(&format!("`{other}")), "{message}");
        }
    }
    let names = [
        "spot.intensity.value",
        "floor.translate.x",
        "floor.bsdf.diffuse_reflectance.value",
        "floor.positions",
        "wall.bsdf.reflectance.value",
    ];
    let near = |wanted: &str| near::near(wanted, names.into_iter());
    assert!(near("spot.translate.x").is_empty());
    assert_eq!(near("flor.translate.x"), ["floor.translate.x"]);
    assert_eq!(near("floor.vertex_positions"), ["floor.positions"]);
    assert_eq!(
        near("floor.bsdf.reflectance.value"),
        ["floor.bsdf.diffuse_reflectance.value"]
    );
}

/// Lights without extent move and turn as far as that means something; for the rest the
/// message says what there is.
#[test]
fn lights_without_extent_have_places() {
    let mut scene = example();
    scene.emitters.push(Emitter::Point {
        id: "bulb".into(),
        position: Vec3::new(1.0, 2.0, 3.0),
        intensity: TextureId(0),
    });
    scene.emitters.push(Emitter::Directional {
        id: "sun".into(),
        direction: Vec3::new(0.0, -1.0, 0.0),
        irradiance: TextureId(0),
    });
    let velocities = |name: &str| scene.anchor_velocities(&tangent(&scene, name).expect(name));
    let y = Vec3::new(0.0, 1.0, 0.0);
    assert_eq!(velocities("bulb.translate.y"), [y, Vec3::zero()]);
    let turning = velocities("sun.rotate.z");
    assert_eq!(turning[0], Vec3::zero());
    let along_x = Vec3::new(1.0, 0.0, 0.0);
    assert!((turning[1] - along_x).length() < 1e-15, "{turning:?}");

    let message = |name: &str| tangent(&scene, name).expect_err(name).to_string();
    assert!(message("bulb.rotate.x").contains("`bulb.translate.x` (y, z) move it"));
    assert!(message("sun.translate.x").contains("`sun.rotate.x` (y, z) turn"));
    assert!(message("bulb.colour").contains("no parameter"));
    assert!(request(&scene, "bulb.position").is_ok());
}

#[test]
fn one_name_for_two_things_is_refused() {
    let mut scene = example();
    scene.shape_mut(ShapeId(0)).id = "sensor".into();
    let error = tangent(&scene, "sensor.translate.x").expect_err("ambiguous");
    assert!(error.to_string().contains("two different things"));
    assert!(tangent(&scene, "eye.translate.x").is_ok());
    assert!(tangent(&scene, "sensor.scale").is_ok());
}

#[test]
fn vertices_move_unless_the_mesh_would_tear() {
    let mut scene = example();
    let count = scene.shapes[0].mesh.positions.len();
    let velocities: Vec<Vec3> = (0..count).map(|i| Vec3::splat(i as f64)).collect();
    let tangent = vertex_tangent(&scene, "ball", velocities.clone()).expect("right");
    assert_eq!(
        tangent.shapes[0].as_ref().expect("moves").vertices,
        velocities
    );
    assert!(tangent.shapes[1].is_none());

    let message = |scene: &Scene, shape: &str, v: Vec<Vec3>| {
        vertex_tangent(scene, shape, v)
            .expect_err(shape)
            .to_string()
    };
    assert!(message(&scene, "bal", vec![]).contains("did you mean `ball`"));
    assert!(message(&scene, "ball", vec![]).contains("0 velocities were given"));
    let mut bad = velocities.clone();
    bad[7].y = f64::NAN;
    assert!(message(&scene, "ball", bad).contains("vertex 7"));
    // A seam: the last vertex lies on the first.
    let positions = &mut scene.shape_mut(ShapeId(0)).mesh.positions;
    positions[count - 1] = positions[0];
    let torn = message(&scene, "ball", velocities);
    assert!(
        torn.contains(&format!("vertices 0 and {}", count - 1)),
        "{torn}"
    );
    let together = vec![Vec3::splat(1.0); count];
    assert!(vertex_tangent(&scene, "ball", together).is_ok());
}

/// A texture that two materials and an emitter refer to is one parameter, called
/// by its own name first.
#[test]
fn a_shared_texture_is_one_parameter() {
    let mut scene = example();
    scene.texture_mut(TextureId(0)).id = "paint".into();
    scene.materials[1].bsdf = Bsdf::from(Diffuse {
        reflectance: TextureId(0),
    });
    scene.emitters[1] = Emitter::Constant {
        id: "sky".into(),
        radiance: TextureId(0),
    };
    let expected = one_texel(&scene, 0, [1.0; 3]);
    let names = [
        "paint.value",
        "sky.radiance.value",
        "red.reflectance.value",
        "both.reflectance.value",
        "lamp.bsdf.reflectance.value",
    ];
    let parameters = list(&scene);
    for name in names {
        assert_eq!(tangent(&scene, name).expect(name).textures, expected);
        let listed: Vec<_> = parameters.iter().filter(|p| p.name == name).collect();
        let alias = (name != "paint.value").then(|| "paint.value".to_owned());
        assert_eq!(listed.len(), 1, "{name}");
        assert_eq!(listed[0].alias_of, alias, "{name}");
    }
    let green = tangent(&scene, "red.reflectance.value.g").expect("listed");
    assert_eq!(green.textures, one_texel(&scene, 0, [0.0, 1.0, 0.0]));
}

fn one_texel(scene: &Scene, texture: usize, velocity: [f64; 3]) -> Vec<Option<Vec<f64>>> {
    let mut textures = vec![None; scene.textures.len()];
    textures[texture] = Some(velocity.to_vec());
    textures
}
