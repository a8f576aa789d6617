//! Gradients against finite differences, one scene per phenomenon: what moves in
//! flat mirrors and behind panes. What is demanded of each case, and how often
//! it raises a false alarm, is said in `phenomena_shadows.rs`.

use std::f64::consts::FRAC_PI_2;

use crate::common::agree::*;
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{
    Gathers, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, gradient,
};
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::{cube, rectangle, sphere};
use capwalk_scene::*;

/// A block on a floor, seen from behind it; what it hides is seen in a leaning
/// mirror. Nothing but the mirror and the block is inside the image.
fn block_before_a_mirror() -> Scene {
    let mut scene = empty(v(0.35, -2.2, 1.3), v(0.05, 1.5, 0.75), 32.0, 36);
    add_floor(&mut scene, 6.0);
    add_emitter(&mut scene, v(0.6, -0.4, 3.0), 2.5, 0.3, 2.0);
    let turn = Affine::rotate(v(0.1, 0.2, 1.0), 0.5);
    let (block, normals) =
        cube(Affine::translate(v(-0.1, 0.35, 0.5)) * turn * Affine::scale(v(0.22, 0.28, 0.35)));
    add(&mut scene, "block", block, normals, 0.6);
    let leaning = Affine::rotate(v(1.0, 0.15, 0.1), 1.72);
    let (mirror, normals) =
        rectangle(Affine::translate(v(0.1, 1.5, 0.8)) * leaning * Affine::scale(v(2.5, 2.2, 1.0)));
    add(&mut scene, "mirror", mirror, normals, 0.5);
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    make(&mut scene, "mirror", |n| n.mirror());
    paths(&mut scene, 3);
    scene
}

fn add_sky(scene: &mut Scene) {
    let radiance = scene.add_texture(Texture::colour("sky", Rgb::new(0.6, 0.7, 1.0)));
    scene.emitters.push(Emitter::Constant {
        id: "sky".into(),
        radiance,
    });
}

/// A step that moves silhouettes by less than 0.2 pixels, for a smooth filter.
fn case(spp: u32) -> Case {
    Case {
        step: 6e-3,
        gradient_spp: spp,
        reference_spp: 5 * spp / 2,
        size: 28,
        min_pixels: 300,
        // Silhouettes and their images cross.
        patience: 3.0,
        ..Case::default()
    }
}

/// By walks, and by gathered edges, as the camera sees them in mirrors, with a part of the samples:
/// they have less noise.
fn moves(name: &str, scene: Scene, expression: &str, case: Case) {
    moves_by(name, scene, expression, case, 4);
}

fn moves_by(name: &str, scene: Scene, expression: &str, case: Case, part: u32) {
    let tangent = tangent(&scene, expression);
    agree_by(
        &both(case.gradient_spp, part),
        &format!("{name}, {expression}"),
        scene,
        &tangent,
        case,
    );
}

fn both(walk_spp: u32, part: u32) -> [(Method, u32); 2] {
    [(Method::Walk, walk_spp), (Method::EDGES, walk_spp / part)]
}

/// A block moves, seen directly and in a flat mirror.
#[test]
fn block_seen_in_a_mirror() {
    let scene = block_before_a_mirror();
    let case = Case {
        size: 22,
        min_pixels: 200,
        ..case(500)
    };
    moves("mirror", scene, "block.translate.x", case);
}

/// The mirror turns and slides behind what hides it.
#[test]
fn moving_mirror() {
    let scene = block_before_a_mirror();
    let expression = "mirror.rotate.z + 0.3*mirror.translate.y";
    moves("mirror", scene, expression, case(300));
}

/// One corner of a mirror moves: its halves bend against each other.
#[test]
fn corner_of_a_mirror() {
    let scene = block_before_a_mirror();
    let mut corners = vec![v(0.0, 0.0, 0.0); 4];
    corners[1] = v(0.1, 1.0, 0.2);
    let tangent = params::vertex_tangent(&scene, "mirror", corners).expect("a mirror");
    let case = Case {
        reference_spp: 2000,
        ..case(220)
    };
    let methods = both(case.gradient_spp, 1);
    agree_by(&methods, "mirror, a corner", scene, &tangent, case);
}

/// The camera moves before a mirror.
#[test]
fn camera_before_a_mirror() {
    let scene = block_before_a_mirror();
    let expression = "sensor.translate.x + 0.3*sensor.rotate.z";
    let case = Case {
        patience: 4.5,
        gradient_spp: 220,
        ..case(400)
    };
    moves_by("mirror", scene, expression, case, 2);
}

/// Two panels lie in one plane, and the second of them moves: the plane has no one motion.
#[test]
fn panels_of_one_plane() {
    let mut scene = block_before_a_mirror();
    let whole = scene.shapes.pop().expect("the mirror");
    for (name, side) in [("stationary", 1.0), ("panel", -1.0)] {
        let mut mesh = whole.mesh.clone();
        let [a, b] = [mesh.positions[0], mesh.positions[1]];
        let across = (b - a).normalized();
        let middle = (a + b) * 0.5;
        for p in &mut mesh.positions {
            let x = across.dot(*p - middle) / (b - a).length();
            *p += across * ((0.5 * x + 0.255 * side - x) * (b - a).length());
        }
        add(&mut scene, name, mesh, ShadingNormals::Face, 0.5);
        make(&mut scene, name, |n| n.mirror());
    }
    let case = Case {
        min_pixels: 100,
        method: Method::EDGES,
        ..case(300)
    };
    let tangent = tangent(&scene, "panel.rotate.z + 0.3*panel.translate.y");
    agree("panels", scene, &tangent, case);
}

/// A second mirror stands across: the block is seen in each and in both, one
/// after the other.
#[test]
fn two_mirrors() {
    let mut scene = block_before_a_mirror();
    let across = Affine::rotate(v(0.1, 1.0, 0.05), 1.5);
    let (mirror, normals) =
        rectangle(Affine::translate(v(-0.7, 0.3, 0.8)) * across * Affine::scale(v(2.2, 2.5, 1.0)));
    add(&mut scene, "second", mirror, normals, 0.5);
    make(&mut scene, "second", |n| n.mirror());
    paths(&mut scene, 4);
    let expression = "block.translate.x + 0.2*second.rotate.z";
    let case = Case {
        patience: 12.0,
        ..case(400)
    };
    moves("two mirrors", scene, expression, case);
}

/// A block moves behind a pane that also shows the front of it.
#[test]
fn block_behind_a_pane() {
    let mut scene = block_before_a_mirror();
    make(&mut scene, "mirror", |n| n.pane());
    let (behind, normals) = tilted_cube();
    let behind = placed(behind, Affine::translate(v(0.6, 2.6, -0.3)));
    add(&mut scene, "behind", behind, normals, 0.7);
    add_sky(&mut scene);
    let expression = "behind.translate.x + 0.2*mirror.rotate.z";
    let case = Case {
        patience: 6.8,
        gradient_spp: 135,
        ..case(300)
    };
    moves("pane", scene, expression, case);
}

/// A block moves over a polished floor.
#[test]
fn block_over_a_polished_floor() {
    let mut scene = block_before_a_mirror();
    scene.shapes.pop();
    make(&mut scene, "floor", |n| n.coat(false));
    moves("polished", scene, "block.translate.x", case(600));
}

/// A floor is lit directly and by way of a mirror; a triangle out of view moves
/// between them.
#[test]
fn shadow_by_way_of_a_mirror() {
    let mut scene = block_before_a_mirror();
    let block = scene.shape_mut(ShapeId(2));
    block.mesh = placed(triangle(), Affine::translate(v(0.1, 0.2, 0.2)));
    scene.sensor.world_from_camera =
        Affine::look_at(v(0.2, 0.6, 0.8), v(0.1, -0.1, 0.0), v(0.0, 0.0, 1.0)).expect("upright");
    scene.film.filter = Filter::Box;
    let case = Case {
        step: 2e-2,
        gradient_spp: 270,
        reference_spp: 640,
        patience: 4.7,
        ..Case::default()
    };
    moves_by("by way of a mirror", scene, "block.translate.y", case, 1);
}

/// Samples per pixel.
const SAMPLES: u32 = 32;
/// Of one sample: it is 0.05, and was 14 to 44 when boundaries near the horizon moved fast.
const MOST_VARIANCE: f64 = 0.5;

/// The variance of one sample of the derivative of a pixel, in the mean over pixels, for a smooth
/// ball of 60,500 triangles that moves over a floor and before a mirror.
fn variance_before_a_mirror(seed: u64) -> f64 {
    let (from, to) = (v(1.5, 2.6, 5.0), v(0.0, 0.6, -0.6));
    let mut scene = empty(from, to, 36.0, 28);
    let camera = Affine::look_at(from, to, v(0.0, 1.0, 0.0));
    scene.sensor.world_from_camera = camera.expect("upright");
    let turned = |angle| Affine::rotate(v(1.0, 0.0, 0.0), angle);
    let wide = |half: f64, height: f64| Affine::scale(v(half, height, 1.0));
    let flat = [
        (
            "floor",
            v(0.0, 0.0, 2.0),
            turned(-FRAC_PI_2) * wide(3.0, 3.0),
        ),
        (
            "lamp",
            v(-1.0, 5.0, 0.0),
            turned(FRAC_PI_2) * wide(0.5, 0.5),
        ),
        ("mirror", v(0.0, 0.8, -2.0), wide(2.0, 0.6)),
    ];
    for (name, place, shape) in flat {
        let (mesh, normals) = rectangle(Affine::translate(place) * shape);
        add(&mut scene, name, mesh, normals, 0.6);
        if name == "lamp" {
            light_up(&mut scene, 40.0);
        }
    }
    let (ball, normals) = sphere(Affine::IDENTITY, v(0.0, 0.8, 0.0), 0.5);
    add(&mut scene, "ball", ball, normals, 0.4);
    make(&mut scene, "mirror", |n| n.mirror());
    paths(&mut scene, 3);
    let tangent = tangent(&scene, "ball.translate.x");
    let settings = GradientOptions {
        method: Method::Edges(Gathers {
            indirect: false,
            ..Gathers::ALL
        }),
        ..GradientOptions::new(RenderOptions::new(SAMPLES, seed))
    };
    let prepared = PreparedScene::new(scene);
    let result = gradient(&prepared, &tangent, &settings, &Unwatched).expect("covered");
    let errors = &result.gradient.standard_error.pixels;
    let sum: f64 = errors.iter().map(|error| error.dot(*error) / 3.0).sum();
    f64::from(SAMPLES) * sum / errors.len() as f64
}

/// Around points of a finely tessellated shape no boundaries close to them move fast: no seed has
/// large values where directions towards surfaces walk.
#[test]
fn fine_ball_before_a_mirror() {
    let variances = [0, 1, 2].map(variance_before_a_mirror);
    let largest = variances.into_iter().fold(0.0, f64::max);
    assert!(largest < MOST_VARIANCE, "{variances:?}");
}

/// Where a mirror shows too many edges in a pixel, the camera's field is walked there, as if no edges were gathered in
/// pixels at all: 9,000 triangles apart behind the camera. The edges of 100 are gathered.
#[test]
fn too_many_edges_in_a_mirror_are_walked() {
    let derivative = |triangles: u32, method| {
        let mut scene = empty(v(0.0, 0.0, 0.0), v(0.0, 1.0, 0.0), 40.0, 1);
        let wall =
            Affine::translate(v(0.0, 2.0, 0.0)) * Affine::rotate(v(1.0, 0.0, 0.0), FRAC_PI_2);
        let (mirror, normals) = rectangle(wall * Affine::scale(Vec3::splat(2.0)));
        add(&mut scene, "mirror", mirror, normals, 0.5);
        make(&mut scene, "mirror", |n| n.mirror());
        let corners = (0..3 * triangles).map(|corner| {
            let i = f64::from(corner / 3);
            let centre = [0.618_034, 0.414_214].map(|k| 2.0 * (i * k).fract() - 1.0);
            let aside = [[0.0, 0.0], [0.05, 0.0], [0.0, 0.05]][corner as usize % 3];
            v(centre[0] + aside[0], -3.0, centre[1] + aside[1])
        });
        let mesh = Mesh {
            positions: corners.collect(),
            faces: (0..triangles)
                .map(|i| [3 * i, 3 * i + 2, 3 * i + 1])
                .collect(),
        };
        add(&mut scene, "dust", mesh, ShadingNormals::Face, 0.0);
        light_up(&mut scene, 1.0);
        paths(&mut scene, 2);
        let tangent = tangent(&scene, "dust.translate.x");
        let settings = GradientOptions {
            method,
            ..GradientOptions::new(RenderOptions::new(256, 3))
        };
        let prepared = PreparedScene::new(scene);
        let result = gradient(&prepared, &tangent, &settings, &Unwatched).expect("covered");
        result.gradient
    };
    let walked = Method::Edges(Gathers {
        camera: false,
        ..Gathers::ALL
    });
    for (triangles, are_gathered) in [(100, true), (9_000, false)] {
        let [gathered, walked] =
            [Method::EDGES, walked].map(|method| derivative(triangles, method));
        assert!(walked.standard_error.pixels[0].r > 0.0, "{triangles}");
        assert_eq!(gathered != walked, are_gathered, "{triangles}");
    }
}

/// Halves of a mirror that rounding bends against each other by less than makes an
/// edge are one mirror: what lies far behind the camera is seen across both.
#[test]
fn halves_of_a_mirror_are_one() {
    let image = |bend: f64| {
        let mut scene = empty(v(0.05, 0.2, 0.3), v(0.05, 1.5, 0.3), 24.0, 12);
        let mesh = Mesh {
            positions: vec![
                v(-1.2, 1.5, -1.0),
                v(1.2, 1.5 + bend, -1.0),
                v(1.2, 1.7, 1.4),
                v(-1.2, 1.7, 1.4),
            ],
            faces: vec![[0, 1, 2], [0, 2, 3]],
        };
        add(&mut scene, "mirror", mesh, ShadingNormals::Face, 0.5);
        make(&mut scene, "mirror", |n| n.mirror());
        let (block, normals) =
            cube(Affine::translate(v(0.1, -5.0, 0.9)) * Affine::scale(Vec3::splat(0.8)));
        add(&mut scene, "block", block, normals, 0.0);
        light_up(&mut scene, 1.0);
        paths(&mut scene, 2);
        scene.check().expect("a valid scene");
        let tangent = tangent(&scene, "block.translate.x");
        // Edges would be chosen from two lists instead of one.
        let settings = GradientOptions {
            method: Method::Walk,
            ..GradientOptions::new(RenderOptions::new(32, 1))
        };
        let result = gradient(
            &PreparedScene::new(scene.clone()),
            &tangent,
            &settings,
            &Unwatched,
        )
        .expect("covered");
        result.gradient.mean.pixels
    };
    let (flat, bent) = (image(0.0), image(1.5e-6));
    let size = |pixels: &[Rgb]| pixels.iter().map(|p| p.r.abs()).sum::<f64>();
    let differences: Vec<Rgb> = flat.iter().zip(&bent).map(|(&a, &b)| a - b).collect();
    let (off, all) = (size(&differences), size(&flat));
    assert!(all > 0.0 && off < 1e-4 * all, "{off} of {all}");
}

const BEFORE_THE_PANE: Vec3 = Vec3::new(1.2, -4.0, 1.9);

/// A stage with a bitmap on its floor, seen through a pane of a material before the camera, whose
/// edges are outside of the image, by paths of so many segments.
fn behind_a_pane<B: Into<Bsdf>>(
    mut scene: Scene,
    segments: u32,
    material: impl FnOnce(&mut Slots) -> B,
) -> Scene {
    unit_square(&mut scene, "floor");
    let name = "floor.bsdf.reflectance";
    let reflectance = scene.textures.iter_mut().find(|map| map.id == name);
    let texels = (0..16).map(|i| f64::from(i) / 15.0).collect();
    *reflectance.expect("the floor's") = bitmap(name.into(), 4, 1, texels).into();
    let towards = Affine::look_at(BEFORE_THE_PANE, v(0.0, 0.05, 0.4), v(0.0, 0.0, 1.0));
    let towards = towards.expect("not up");
    let (mesh, normals) = rectangle(towards * Affine::translate(v(0.0, 0.0, 0.5)));
    add(&mut scene, "pane", mesh, normals, 0.5);
    make(&mut scene, "pane", material);
    paths(&mut scene, segments);
    scene
}

/// Light that passes a surface goes on along the same ray, wherever that surface moves: not even
/// rounding has a derivative.
#[test]
fn what_moves_and_lets_light_pass() {
    let mask = |opacity: f64| {
        move |n: &mut Slots| Bsdf::Mask {
            opacity: n.number("opacity", opacity),
            nested: n.diffuse("glass", [0.5; 3]),
        }
    };
    // A walk would find the pane's edges, and be zero in the mean alone.
    let settings = GradientOptions {
        method: Method::EDGES,
        ..GradientOptions::new(RenderOptions::new(4, 5))
    };
    let mean = |image: &Image| {
        let sum = image.pixels.iter().map(|pixel| pixel.r).sum::<f64>();
        sum / image.pixels.len() as f64
    };
    let stage = || visible_stage(BEFORE_THE_PANE);
    let floor = behind_a_pane(stage(), 3, mask(0.0));
    let sky = behind_a_pane(under_a_sky(stage()), 2, mask(0.0));
    let glass = behind_a_pane(stage(), 3, |n| n.pane());
    let cases = [
        ("floor", "pane.translate.x", floor),
        ("sky", "pane.rotate.x", sky),
        ("glass", "pane.translate.x", glass),
    ];
    for (name, expression, scene) in cases {
        let tangent = tangent(&scene, expression);
        let pane = tangent.shapes.iter().flatten().next().expect("it moves");
        assert!(pane.vertices.iter().all(|&v| v != Vec3::zero()), "{name}");
        let prepared = PreparedScene::new(scene);
        let result = gradient(&prepared, &tangent, &settings, &Unwatched).expect("covered");
        assert!(mean(&result.value.mean) > 0.02, "{name} is seen");
        let pixels = &result.gradient.mean.pixels;
        assert!(pixels.iter().all(|&pixel| pixel == Rgb::zero()), "{name}");
    }
    // The pane is there.
    let opaque = behind_a_pane(stage(), 3, mask(1.0));
    let tangent = tangent(&opaque, "pane.translate.x");
    let result = gradient(&PreparedScene::new(opaque), &tangent, &settings, &Unwatched);
    assert!(mean(&result.expect("covered").value.mean) < 0.01);
}
