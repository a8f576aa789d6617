//! Gradients against finite differences, one scene per phenomenon. In every
//! case `check::compare` must say right: an error of a tenth would have been
//! seen. Besides, the mean of z² must lie in [0.8, 1.25] over at least 1000
//! pixels, which are independent of each other, and their signs must cancel.
//!
//! The comparison's tests together raise a false alarm in about one case of
//! 4000; the seeds are fixed, so a case that passes goes on passing.

mod common;

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use capwalk_render::check::{Verdict, compare};
use capwalk_render::{
    GradientOptions, Options, Unwatched, WalkSettings, finite_difference, gradient,
};
use capwalk_scene::primitive::{cube, icosphere, sphere};
use capwalk_scene::*;
use common::*;

/// Sizes and seeds of a case.
struct Case {
    size: u32,
    gradient_spp: u32,
    reference_spp: u32,
    step: f64,
    walk: WalkSettings,
}

impl Default for Case {
    fn default() -> Self {
        Self {
            size: 36,
            gradient_spp: 400,
            reference_spp: 1024,
            step: 3e-2,
            walk: WalkSettings::default(),
        }
    }
}

/// Runs both and demands agreement.
fn agree(name: &str, mut scene: Scene, motion: &Motion, case: Case) {
    scene.film.size = [case.size; 2];
    scene.film.crop_size = [case.size; 2];
    scene.check().expect("a valid scene");
    let options = |spp: u32, seed: u64| Options {
        spp,
        seed,
        threads: None,
    };
    let settings = GradientOptions {
        options: options(case.gradient_spp, 1),
        walk: case.walk,
    };
    let ours = gradient(&scene, motion, &settings, &Unwatched).expect("covered");
    let reference = finite_difference(
        &scene,
        motion,
        case.step,
        &options(case.reference_spp, 2),
        &Unwatched,
    )
    .expect("covered");
    assert_eq!(
        ours.statistics.non_finite + reference.statistics.non_finite,
        0,
        "{name}"
    );

    let result = compare(&ours.gradient, &reference.gradient);
    println!(
        "{name}: {} pixels, mean z² {:.3} ± {:.3}, sign {:.2}, slope {:.3} ± {:.3}, worst {:?}",
        result.pixels,
        result.mean_z_squared,
        result.mean_z_squared_error,
        result.sign,
        result.slope,
        result.slope_error,
        result.worst[0]
    );
    assert_eq!(result.verdict, Verdict::Right, "{name}");
    assert!(
        result.pixels >= 1000,
        "{name}: only {} pixels have noise",
        result.pixels
    );
    let z2 = result.mean_z_squared;
    assert!((0.8..=1.25).contains(&z2), "{name}: mean z² {z2}");
    assert!(
        result.sign.abs() < 4.0,
        "{name}: systematic sign {}",
        result.sign
    );
}

fn motion(scene: &Scene, expression: &str) -> Motion {
    params::motion(scene, expression).expect("a known name")
}

/// A camera that sees only the floor (its middle ±1.2) from above.
fn shadow_stage() -> Scene {
    let mut scene = empty(v(0.3, -0.4, 6.0), v(0.0, 0.0, 0.0), 22.0, 40);
    scene.sensor.near_clip = 5.6; // what is above the floor is not seen
    add_floor(&mut scene, 3.0);
    add_lamp(&mut scene, v(0.1, 0.0, 3.0), 0.8, 0.3, 10.0);
    scene
}

fn triangle() -> Mesh {
    Mesh {
        positions: vec![v(-0.45, -0.3, 1.2), v(0.5, -0.25, 1.0), v(0.05, 0.5, 1.1)],
        faces: vec![[0, 1, 2]],
    }
}

fn placed(mut mesh: Mesh, map: Affine) -> Mesh {
    mesh.positions.iter_mut().for_each(|p| *p = map.point(*p));
    mesh
}

fn small_ball() -> Mesh {
    placed(
        icosphere(4),
        Affine::translate(v(0.0, 0.0, 1.0)) * Affine::scale(Vec3::splat(0.5)),
    )
}

fn tilted_cube() -> (Mesh, ShadingNormals) {
    let turn = Affine::rotate(v(0.3, 0.8, 0.5), 0.7);
    cube(Affine::translate(v(0.0, 0.0, 1.1)) * turn * Affine::scale(v(0.3, 0.4, 0.25)))
}

fn with(mesh: Mesh) -> Scene {
    let mut scene = shadow_stage();
    add(&mut scene, "thing", mesh, ShadingNormals::Face, 0.5);
    scene
}

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

/// A visible, shaded thing over a lit floor, its shadow in the picture too.
fn visible_stage(from: Vec3) -> Scene {
    let mut scene = empty(from, v(0.0, 0.05, 0.4), 22.0, 36);
    add_floor(&mut scene, 4.0);
    add_lamp(&mut scene, v(0.9, -0.6, 2.6), 0.8, 0.3, 10.0);
    scene
}

/// The silhouette of a visible thing crosses pixels: short steps, so that the
/// difference does not run over whole pixels.
fn primary() -> Case {
    Case {
        size: 46,
        step: 4e-3,
        gradient_spp: 320,
        reference_spp: 960,
        ..Case::default()
    }
}

fn visible_ball(filter: Filter) -> Scene {
    let mut scene = visible_stage(v(1.2, -4.0, 1.9));
    let (mesh, normals) = sphere(Affine::IDENTITY, v(0.0, 0.0, 0.55), 0.5);
    add(&mut scene, "ball", mesh, normals, 0.6);
    scene.film.filter = filter;
    scene
}

fn primary_case(name: &str, scene: Scene, expression: &str) {
    let motion = motion(&scene, expression);
    agree(name, scene, &motion, primary());
}

#[test]
fn ball_with_box_filter() {
    primary_case("ball, box", visible_ball(Filter::Box), "ball.translate.x");
}

#[test]
fn ball_with_tent_filter() {
    let scene = visible_ball(Filter::Tent { radius: 1.0 });
    primary_case("ball, tent", scene, "ball.translate.x");
}

#[test]
fn ball_with_gaussian_filter() {
    let scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    primary_case("ball, gaussian", scene, "ball.translate.x");
}

/// The film samples beyond its border: no filter is cut off.
#[test]
fn ball_with_sampled_border() {
    let mut scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    scene.film.sample_border = true;
    primary_case("ball, border sampled", scene, "ball.translate.z");
}

fn visible_cube() -> Scene {
    let mut scene = visible_stage(v(1.2, -4.0, 1.9));
    let (mesh, normals) = tilted_cube();
    let mesh = placed(mesh, Affine::translate(v(0.0, 0.0, -0.5)));
    add(&mut scene, "thing", mesh, normals, 0.6);
    scene
}

#[test]
fn moving_camera() {
    let scene = visible_cube();
    let motion = motion(&scene, "sensor.translate.x");
    let case = Case {
        step: 1e-3,
        reference_spp: 2000,
        ..primary()
    };
    agree("camera moves", scene, &motion, case);
}

#[test]
fn turning_camera() {
    let case = Case {
        step: 2.5e-4,
        reference_spp: 2000,
        ..primary()
    };
    let scene = visible_cube();
    let motion = motion(&scene, "sensor.rotate.z");
    agree("camera turns", scene, &motion, case);
}

#[test]
fn turning_camera_with_tent_filter() {
    let case = Case {
        step: 2.5e-4,
        reference_spp: 2000,
        ..primary()
    };
    let mut scene = visible_cube();
    scene.film.filter = Filter::Tent { radius: 1.0 };
    let motion = motion(&scene, "sensor.rotate.y+sensor.translate.z");
    agree("camera turns, tent", scene, &motion, case);
}

/// A lamp in the picture moves, and with it the light it casts.
#[test]
fn visible_lamp_moves() {
    let mut scene = visible_cube();
    scene.sensor.fov_x = 50.0_f64.to_radians();
    let turned = Affine::translate(v(-0.2, 0.4, 1.3)) * Affine::rotate(v(1.0, 0.2, 0.0), 1.9);
    let (mesh, normals) =
        capwalk_scene::primitive::rectangle(turned * Affine::scale(v(0.4, 0.3, 1.0)));
    add(&mut scene, "screen", mesh, normals, 0.3);
    light_up(&mut scene, 3.0);
    let motion = motion(&scene, "screen.translate.x");
    // The faint light of the screen changes in rare samples only; a smooth
    // filter allows a step that finds them.
    scene.film.filter = Filter::Tent { radius: 1.0 };
    let case = Case {
        step: 6e-3,
        reference_spp: 2400,
        ..primary()
    };
    agree("visible lamp", scene, &motion, case);
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
    scene.emitters = vec![Emitter::Constant {
        id: "sky".into(),
        radiance: capwalk_math::Rgb::splat(1.0),
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

/// Nothing moves but colours.
#[test]
fn radiance_and_reflectance() {
    let scene = visible_cube();
    let lamp = motion(&scene, "lamp.emitter.radiance.value");
    agree("radiance", scene.clone(), &lamp, primary());
    let floor = motion(&scene, "floor.bsdf.reflectance.value");
    // Only the floor's pixels have noise.
    agree("reflectance", scene, &floor, primary());
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

#[test]
fn box_room() {
    builtin_case("box-room", "box.translate.x", primary());
}

/// Surfaces that pass through each other: the camera sees a jump where no mesh
/// has an edge, and both sides of it move.
#[test]
fn interpenetrating_shapes() {
    let mut scene = visible_cube();
    scene.shapes[2].mesh = placed(
        scene.shapes[2].mesh.clone(),
        Affine::translate(v(0.0, 0.0, -0.35)),
    );
    let ball = placed(
        icosphere(3),
        Affine::translate(v(0.3, -0.25, 0.25)) * Affine::scale(Vec3::splat(0.3)),
    );
    add(&mut scene, "ball", ball, ShadingNormals::Face, 0.9);
    primary_case(
        "interpenetrating",
        scene,
        "thing.translate.z+ball.translate.x",
    );
}

/// What lies before the near plane is not seen, and hides nothing.
#[test]
fn screen_before_the_near_plane() {
    let mut scene = visible_cube();
    let towards = v(1.2, -4.0, 1.9) - v(0.0, 0.05, 0.4);
    let facing = Affine::look_at(v(0.9, -3.0, 1.525), v(1.2, -4.0, 1.9), v(0.0, 0.0, 1.0));
    let (mesh, normals) = capwalk_scene::primitive::rectangle(facing.expect("not up"));
    add(&mut scene, "screen", mesh, normals, 0.5);
    scene.sensor.near_clip = 0.4 * towards.length();
    primary_case("near plane", scene, "thing.translate.x");
}

/// Smooth normals: the horizon of each face bounds the light it reflects, on
/// whichever side of its winding the eye is.
#[test]
fn rotating_coarse_smooth_ball() {
    for inside_out in [false, true] {
        let mut scene = visible_stage(v(1.2, -4.0, 1.9));
        let place = Affine::translate(v(0.0, 0.0, 0.55)) * Affine::scale(Vec3::splat(0.5));
        let mut ball = placed(icosphere(1), place);
        if inside_out {
            ball.faces.iter_mut().for_each(|face| face.swap(1, 2));
        }
        let normals = ShadingNormals::computed(&ball);
        add(&mut scene, "ball", ball, normals, 0.6);
        let name = format!("coarse smooth ball, inside out: {inside_out}");
        let motion = motion(&scene, "ball.rotate.y");
        let case = Case {
            gradient_spp: 600,
            reference_spp: 1600,
            ..primary()
        };
        agree(&name, scene, &motion, case);
    }
}

/// The numbers of Russian roulette are nobody else's.
#[test]
fn early_roulette() {
    let mut scene = empty(v(0.3, -2.0, 1.0), v(0.0, 1.0, 0.0), 60.0, 36);
    add_floor(&mut scene, 8.0);
    add_lamp(&mut scene, v(0.0, 0.0, 4.0), 10.0, 0.3, 3.0);
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(2),
        rr_depth: 1,
        hide_emitters: false,
    };
    let motion = motion(&scene, "sensor.rotate.x");
    agree("early roulette", scene, &motion, primary());
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

/// A surface cut by a clip plane in view is refused, by name.
#[test]
fn clipped_surfaces_are_refused() {
    let mut scene = visible_cube();
    scene.sensor.near_clip = 4.2;
    let motion = motion(&scene, "thing.translate.x");
    let settings = GradientOptions {
        options: Options {
            spp: 2,
            seed: 1,
            threads: None,
        },
        walk: WalkSettings::default(),
    };
    let refusal = gradient(&scene, &motion, &settings, &Unwatched).expect_err("clipped");
    assert!(refusal.reason.contains("near_clip of 4.2"), "{refusal}");
}
