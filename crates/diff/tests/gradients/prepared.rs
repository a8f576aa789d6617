//! A prepared scene that was changed answers like one that was made of the result, to the
//! bit: whatever was refitted, kept or built anew.

use std::sync::Arc;

use crate::common::stages::{placed, under_a_sky, visible_ball, visible_cube, with_parallel_rays};
use crate::common::{add, add_emitter, v};
use capwalk_diff::{
    GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, Wanted, backward, gradient,
    render,
};
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::params::Registry;
use capwalk_scene::primitive::icosphere;
use capwalk_scene::{
    Attribute, Emitter, Filter, Image, Pattern, Scene, ShadingNormals, ShapeId, ShapeVectors,
    Texture,
};

const SAMPLING: RenderOptions = RenderOptions::new(2, 7);

fn bits(image: &Image) -> Vec<u64> {
    let channels = image.pixels.iter().flat_map(|pixel| pixel.to_array());
    channels.map(f64::to_bits).collect()
}

/// All numbers that a prepared scene gives: its image, its derivative by both unbiased
/// methods, and the gradient with respect to everything.
fn answers(prepared: &PreparedScene, along: &str) -> Vec<u64> {
    let scene = prepared.scene();
    let tangent = Registry::new(scene).tangent(scene, along).expect("a name");
    let [width, height] = scene.film.crop_size.map(|n| n as usize);
    let mut adjoint = Image::new(width, height);
    adjoint.pixels.fill(Rgb::new(0.3, -0.7, 1.1));
    let mut numbers = bits(&render(prepared, &SAMPLING, &Unwatched).value.mean);
    for method in [Method::Walk, Method::EDGES, Method::Auto] {
        let options = GradientOptions {
            method,
            ..SAMPLING.into()
        };
        let forward = gradient(prepared, &tangent, &options, &Unwatched).expect("covered");
        numbers.extend(bits(&forward.gradient.mean));
        let wanted = Wanted::all(scene);
        let reverse = backward(prepared, &adjoint, &wanted, &options, &Unwatched);
        let reverse = reverse.expect("covered");
        let gradient = reverse.gradient();
        let vertices = gradient.shapes.iter().flatten();
        let vertices = vertices.flat_map(|s| s.vertices.iter().flat_map(|v| v.to_array()));
        let textures = gradient.textures.iter().flatten().flatten().copied();
        numbers.extend(vertices.chain(textures).map(f64::to_bits));
    }
    numbers
}

/// Where nothing moves no boundaries are listed: the derivative with respect to a colour is that with
/// them, up to the rounding of paths that are traced together. A motion by nothing of shading normals
/// asks for them.
#[test]
fn colours_need_no_boundaries() {
    let mut scene = under_a_sky(visible_ball(Filter::Tent { radius: 1.0 }));
    (scene.film.size, scene.film.crop_size) = ([9, 8], [9, 8]);
    add_emitter(&mut scene, v(0.3, -0.2, 3.0), 0.8, 0.2, 4.0);
    let name = "floor.bsdf.reflectance.value";
    let colour = Registry::new(&scene).tangent(&scene, name).expect("a name");
    let mut turning = colour.clone();
    for (motion, shape) in turning.shapes.iter_mut().zip(&scene.shapes) {
        let zeros = |count: usize| vec![Vec3::zero(); count];
        *motion = Some(ShapeVectors {
            vertices: zeros(shape.mesh.positions.len()),
            normals: shape.normals.per_vertex().map(|all| zeros(all.len())),
        });
    }
    assert!(!Wanted::by(&colour).moves() && Wanted::by(&turning).moves());
    let prepared = PreparedScene::new(scene);
    let images = |tangent| {
        [Method::Walk, Method::EDGES].map(|method| {
            let options = GradientOptions {
                method,
                ..SAMPLING.into()
            };
            let image = gradient(&prepared, tangent, &options, &Unwatched).expect("covered");
            let channels = image.gradient.mean.pixels.iter();
            channels
                .flat_map(|pixel| pixel.to_array())
                .collect::<Vec<f64>>()
        })
    };
    let are_close = |a: &[f64], b: &[f64]| {
        let largest = a.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9 * largest)
    };
    let is_listed = || prepared.has_boundaries();
    let without = images(&colour);
    assert!(without[0].iter().any(|&x| x != 0.0));
    let mut wanted = Wanted::by(&colour);
    let mut adjoint = Image::new(9, 8);
    adjoint.pixels.fill(Rgb::splat(1.0));
    let reverse = |wanted: &Wanted| {
        let options = SAMPLING.into();
        let found = backward(&prepared, &adjoint, wanted, &options, &Unwatched).expect("covered");
        let textures = found.gradient().textures.iter().flatten();
        textures.flatten().copied().collect::<Vec<f64>>()
    };
    let reverse_without = reverse(&wanted);
    assert!(!is_listed());
    for (with, without) in images(&turning).iter().zip(&without) {
        assert!(are_close(with, without));
    }
    assert!(is_listed());
    wanted.normals.fill(true);
    assert!(are_close(&reverse(&wanted), &reverse_without));
}

/// Changes one scene step by step, and compares after each.
fn agree(mut start: Scene, along: &str, steps: &[(&str, f64)]) {
    start.film.size = [9, 8];
    start.film.crop_size = [9, 8];
    let mut prepared = PreparedScene::new(start);
    // What is made on demand is there before the first change.
    answers(&prepared, along);
    for &(name, step) in steps {
        let before = Arc::clone(prepared.scene());
        let tangent = Registry::new(&before).tangent(&before, name);
        let tangent = tangent.expect("a name");
        let next = before.moved(&tangent, step);
        next.check().expect("a valid scene");
        // A copy that goes over to it, and does not change the scene that is there.
        let copied = prepared.updated(next.clone());
        let is_unchanged = prepared.scene() == &before;
        prepared.update(next.clone());
        let fresh = answers(&PreparedScene::new(next), along);
        assert!(answers(&prepared, along) == fresh, "{name}");
        assert!(
            is_unchanged && answers(&copied, along) == fresh,
            "a copy, {name}"
        );
    }
}

/// Sides of a cube that bend and become flat again, faces that begin to cross the floor,
/// colours, lights and the camera.
#[test]
fn whatever_changes() {
    let steps = [
        ("thing.translate.x", 0.05),
        ("floor.bsdf.reflectance.value", -0.1),
        ("thing.positions[3,1]", 0.02),
        ("thing.positions[3,1]", -0.02),
        ("thing.translate.z - thing.translate.y", 0.4),
        ("lamp.translate.x + 0.3*lamp.scale", 0.1),
        ("sensor.translate.x + sensor.rotate.y", 0.02),
        ("thing.scale", 0.1),
        ("lamp.emitter.radiance.value", 0.5),
    ];
    agree(visible_cube(), "thing.translate.y", &steps);
}

/// The brightness of several emitters, by which they are chosen: the scale of a sky, one texel of
/// it, and numbers at the faces of an emitter.
#[test]
fn brightness_of_emitters() {
    let mut scene = under_a_sky(visible_cube());
    add_emitter(&mut scene, v(0.3, -0.2, 3.0), 0.8, 0.2, 4.0);
    let glow = scene.add_texture(Texture {
        id: "lamp.face_glow".into(),
        channels: 1,
        data: vec![2.0, 5.0],
        pattern: Pattern::PerFace,
    });
    let name = "face_glow".to_string();
    let attribute = Attribute {
        name: name.clone(),
        texture: glow,
    };
    let shape = ShapeId(scene.shapes.len() as u32 - 1);
    scene.shape_mut(shape).attributes.push(attribute);
    let radiance = scene.add_texture(Texture {
        id: "lamp.glow".into(),
        channels: 1,
        data: Vec::new(),
        pattern: Pattern::MeshAttribute { name, scale: 2.0 },
    });
    *scene.emitters.last_mut().expect("the emitter") = Emitter::Area { shape, radiance };
    let steps = [
        ("sky.scale", 1.5),
        ("lamp.face_glow[1]", 3.0),
        ("sky.data[3,1]", 2.0),
        ("thing.translate.x", 0.05),
    ];
    agree(scene, "thing.translate.y", &steps);
}

/// A mesh that is squeezed until its trees are worn out.
#[test]
fn large_motions() {
    let mut ball = visible_ball(Filter::Gaussian { stddev: 0.5 });
    let shape = ball.shapes_mut().find(|shape| shape.id == "ball");
    let shape = shape.expect("it is there");
    let place = Affine::translate(v(0.0, 0.0, 0.55)) * Affine::scale(Vec3::splat(0.5));
    shape.mesh = placed(icosphere(4), place);
    shape.normals = ShadingNormals::computed(&shape.mesh);
    let steps = [
        ("ball.rotate.z + 0.1*ball.translate.y", 3.0),
        ("ball.scale", -0.9),
    ];
    agree(ball, "ball.translate.x", &steps);
}

/// Normals that come apart along the seam of a flat sheet, and come together again: no
/// vertex moves, and the seam becomes an edge.
#[test]
fn normals_at_a_seam() {
    let mut scene = visible_cube();
    let corners = [
        [-0.7, 0.9],
        [0.7, 0.9],
        [0.7, 1.8],
        [-0.7, 0.9],
        [0.7, 1.8],
        [-0.7, 1.8],
    ];
    let sheet = Mesh {
        positions: corners.map(|[x, y]| Vec3::new(x, y, 0.3)).to_vec(),
        faces: vec![[0, 1, 2], [3, 4, 5]],
    };
    let up = ShadingNormals::Given(vec![Vec3::new(0.0, 0.0, 1.0); 6]);
    add(&mut scene, "sheet", sheet, up, 0.7);
    let steps = [
        ("sheet.normals[3,0]", 0.3),
        ("sheet.normals[4,0] + sheet.normals[5,1]", -0.2),
        ("floor.bsdf.reflectance.value", 0.1),
    ];
    agree(scene, "sheet.translate.x + thing.translate.y", &steps);
}

/// Where the edges have a second tree, in image space.
#[test]
fn before_an_orthographic_sensor() {
    let scene = with_parallel_rays(visible_cube(), 1.5);
    let steps = [
        ("thing.translate.x", 0.05),
        ("sensor.translate.x", 0.1),
        ("sensor.rotate.z", 0.1),
        ("floor.bsdf.reflectance.value", 0.1),
    ];
    agree(scene, "thing.translate.y", &steps);
}
