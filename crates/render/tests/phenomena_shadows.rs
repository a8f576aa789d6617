//! Gradients against finite differences, one scene per phenomenon: shadows, on
//! a floor that is all the camera sees.
//!
//! In every case `check::compare` must say right: an error of a tenth would
//! have been seen. Besides, the mean of z² must lie in [0.8, 1.25] over at
//! least 1000 pixels, which are independent of each other, and their signs must
//! cancel. The comparison's tests together raise a false alarm in about one
//! case of 4000; the seeds are fixed, so a case that passes goes on passing.

mod common;

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use capwalk_render::WalkSettings;
use capwalk_scene::primitive::icosphere;
use capwalk_scene::*;
use common::agree::*;
use common::stages::*;
use common::*;

fn shadow_case(name: &str, scene: Scene, expression: &str) {
    let motion = motion(&scene, expression);
    agree(name, scene, &motion, Case::default());
}

#[test]
fn lamp_over_a_triangle() {
    shadow_case("triangle", with(triangle()), "thing.translate.x");
}

#[test]
fn lamp_over_an_icosphere() {
    shadow_case("icosphere", with(small_ball()), "thing.translate.x");
}

#[test]
fn moving_lamp() {
    shadow_case("moving lamp", with(triangle()), "lamp.translate.y");
}

#[test]
fn rotating_lamp() {
    shadow_case("rotating lamp", with(triangle()), "lamp.rotate.y");
}

#[test]
fn rotating_occluder() {
    shadow_case("rotating occluder", with(tilted_cube().0), "thing.rotate.z");
}

#[test]
fn scaling_occluder() {
    shadow_case("scaling occluder", with(small_ball()), "thing.scale");
}

#[test]
fn cube_with_split_vertices() {
    shadow_case("cube", with(tilted_cube().0), "thing.translate.z");
}

#[test]
fn receiver_and_occluder_move_together() {
    let expression = "floor.translate.y+thing.translate.y";
    shadow_case("floor and thing", with(triangle()), expression);
}

/// Every face has vertices of its own, as at seams of texture coordinates.
#[test]
fn mesh_with_seams() {
    let ball = small_ball();
    let seamed = Mesh {
        positions: (0..ball.faces.len())
            .flat_map(|face| ball.corners(face))
            .collect(),
        faces: (0..ball.faces.len() as u32)
            .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
            .collect(),
    };
    shadow_case("seams", with(seamed), "thing.translate.x");
}

/// The lower half of a ball: borders and silhouettes, seen from inside too.
#[test]
fn open_mesh() {
    let mut ball = small_ball();
    let keep: Vec<bool> = (0..ball.faces.len())
        .map(|f| ball.corners(f).iter().all(|p| p.z < 1.2))
        .collect();
    let mut keep = keep.iter();
    ball.faces.retain(|_| *keep.next().expect("one per face"));
    shadow_case("open mesh", with(ball), "thing.translate.x+thing.rotate.y");
}

/// One corner of an icosahedron moves, and pulls five faces with it.
#[test]
fn single_vertex_motion() {
    let place = Affine::translate(v(0.0, 0.0, 1.0))
        * Affine::rotate(v(0.3, 0.2, 0.9), 0.4)
        * Affine::scale(Vec3::splat(0.5));
    let scene = with(placed(icosphere(1), place));
    let corners = &scene.shape(ShapeId(2)).mesh.positions;
    let rightmost = (0..corners.len()).max_by(|&i, &k| corners[i].x.total_cmp(&corners[k].x));
    let mut velocities = vec![Vec3::zero(); corners.len()];
    velocities[rightmost.expect("it has vertices")] = v(1.0, 0.5, -0.3);
    let motion = params::vertex_motion(&scene, "thing", velocities).expect("fits");
    let case = Case {
        size: 52,
        step: 1e-2,
        ..Case::default()
    };
    agree("single vertex", scene, &motion, case);
}

#[test]
fn two_crossing_occluders() {
    let mut scene = with(triangle());
    let other = placed(
        triangle(),
        Affine::translate(v(0.1, 0.1, 0.15)) * Affine::rotate(v(1.0, 0.4, 0.2), 0.5),
    );
    add(&mut scene, "other", other, ShadingNormals::Face, 0.5);
    shadow_case("crossing", scene, "thing.translate.x+other.translate.y");
}

/// A lamp with too many edges for explicit flux: they join the boundaries.
#[test]
fn spherical_lamp_moves() {
    let mut scene = with(triangle());
    let ball = placed(
        icosphere(4),
        Affine::translate(v(0.3, 0.2, 2.4)) * Affine::scale(Vec3::splat(0.35)),
    );
    add(&mut scene, "bulb", ball, ShadingNormals::Face, 0.0);
    light_up(&mut scene, 8.0);
    shadow_case("spherical lamp", scene, "bulb.translate.x");
}

/// Light from all around, sampled by the material.
#[test]
fn occluder_under_constant_light() {
    let mut scene = with(tilted_cube().0);
    scene.shapes.remove(1); // the lamp
    scene.shapes[1].id = "thing".into();
    let radiance = Texture::colour("sky.radiance", capwalk_math::Rgb::splat(1.0));
    let radiance = scene.add_texture(radiance);
    scene.emitters = vec![Emitter::Constant {
        id: "sky".into(),
        radiance,
    }];
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    let motion = motion(&scene, "thing.translate.z");
    agree(
        "sky",
        scene,
        &motion,
        Case {
            step: 3e-2,
            ..Case::default()
        },
    );
}

/// Paths of two segments are what direct light is.
#[test]
fn path_of_depth_two() {
    let mut scene = with(triangle());
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(2),
        rr_depth: 5,
        hide_emitters: false,
    };
    shadow_case("path, depth 2", scene, "thing.translate.y");
}

/// Several steps, antithetic, over a wide angle: another field, the same
/// derivative.
#[test]
fn other_walks() {
    let scene = with(triangle());
    let motion = motion(&scene, "thing.translate.x");
    for (steps, max_radius, antithetic) in [(2, 0.6, false), (1, 0.05, true), (3, 3.0, true)] {
        let walk = WalkSettings {
            steps,
            max_radius,
            antithetic,
            ..Default::default()
        };
        let name = format!("M = {steps}, A_max = {max_radius}");
        agree(
            &name,
            scene.clone(),
            &motion,
            Case {
                size: 42,
                walk,
                ..Case::default()
            },
        );
    }
}

fn builtin_case(scene: &str, expression: &str, case: Case) {
    let name = format!("{scene}, {expression}");
    let mut scene = builtin::scene(scene).expect("a built-in scene");
    scene.film.crop_offset = [0, 0];
    let motion = motion(&scene, expression);
    agree(&name, scene, &motion, case);
}

#[test]
fn lattice_shadow() {
    // Its tubes are thin: a step of their size would blur their shadows.
    for axis in ["x", "y", "z"] {
        let case = Case {
            step: 1e-2,
            ..Case::default()
        };
        builtin_case("lattice-shadow", &format!("lattice.translate.{axis}"), case);
    }
}

/// A blade cuts through the lamp.
#[test]
fn lamp_cut_by_a_blade() {
    let blade = Mesh {
        positions: vec![v(-0.7, -0.6, 2.3), v(-0.6, 0.7, 2.2), v(0.5, 0.1, 3.5)],
        faces: vec![[0, 1, 2]],
    };
    shadow_case("blade", with(blade), "thing.translate.x");
}

/// Correlated samples: their errors come from batches.
#[test]
fn sobol_points() {
    let mut scene = with(triangle());
    scene.settings.sampler = SamplerKind::Sobol;
    let case = Case {
        gradient_spp: 512,
        reference_spp: 1024,
        ..Case::default()
    };
    let motion = motion(&scene, "thing.translate.x");
    agree("sobol", scene, &motion, case);
}

/// Adds a square lamp of side 1 that faces down at height 3.
fn add_square_lamp(scene: &mut Scene, id: &str, corner: [f64; 2], radiance: f64) {
    let [x, y] = corner;
    let mesh = Mesh {
        positions: [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]]
            .map(|[dx, dy]| v(x + dx, y + dy, 3.0))
            .to_vec(),
        faces: vec![[0, 1, 2], [0, 2, 3]],
    };
    add(scene, id, mesh, ShadingNormals::Face, 0.0);
    light_up(scene, radiance);
}

/// Lamps that touch along an edge, or a part of one: what jumps there is counted
/// once.
#[test]
fn touching_lamps() {
    for shift in [0.0, 0.375] {
        let mut scene = shadow_stage();
        scene.shapes.retain(|shape| shape.id == "floor");
        scene.emitters.clear();
        add_square_lamp(&mut scene, "left", [-1.0, -0.5], 10.0);
        add_square_lamp(&mut scene, "right", [0.0, shift - 0.5], 1.0);
        add(&mut scene, "thing", triangle(), ShadingNormals::Face, 0.5);
        shadow_case("touching lamps", scene, "thing.translate.x");
    }
}
