//! Gathered edges (METHOD 8) against finite differences, and against walks: each is
//! the other's oracle. What is demanded of each case, and how often it raises a
//! false alarm, is said in `phenomena_shadows.rs`. More phenomena are run by
//! both methods in `cli/tests/phenomena`.

use std::sync::Arc;
use std::time::Instant;

use crate::common::agree::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_boundary::Gathers;
use capwalk_diff::check::{Verdict, compare};
use capwalk_diff::{
    GradientImage, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, gradient,
    with_threads,
};
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::{disk, icosphere, rectangle};
use capwalk_scene::*;

fn edges(case: Case) -> Case {
    Case {
        method: Method::EDGES,
        ..case
    }
}

fn shadow_case(name: &str, scene: Scene, expression: &str) {
    let tangent = tangent(&scene, expression);
    // Little noise: a longer step, which blurs what it looks at, would be seen.
    let case = Case {
        step: 1e-2,
        gradient_spp: 16,
        reference_spp: 640,
        min_pixels: 400,
        ..Case::default()
    };
    agree(name, scene, &tangent, edges(case));
}

/// A stage whose emitter is another one, above the thing.
fn lit_by(mesh: Mesh, radiance: f64) -> Scene {
    let mut scene = with(triangle());
    scene.shapes.retain(|shape| shape.id != "lamp");
    scene.emitters.clear();
    add(&mut scene, "bulb", mesh, ShadingNormals::Face, 0.0);
    light_up(&mut scene, radiance);
    scene
}

fn down(size: f64) -> Affine {
    let turn = Affine::rotate(v(1.0, 0.1, 0.0), std::f64::consts::PI);
    Affine::translate(v(0.2, 0.1, 3.0)) * turn * Affine::scale(v(size, size, size))
}

#[test]
fn shadow() {
    shadow_case("shadow by edges", with(triangle()), "thing.translate.y");
}

/// Faces that are seen edge-on, and the horizon of the floor's own edges.
#[test]
fn occluder_and_receiver() {
    let scene = with(tilted_cube().0);
    let expression = "thing.rotate.y + floor.translate.z + 0.5*floor.translate.x";
    shadow_case("occluder and receiver", scene, expression);
}

#[test]
fn emitter_moves() {
    let expression = "lamp.translate.x + lamp.rotate.x";
    shadow_case("emitter", with(small_ball()), expression);
}

/// One of three corners: its edges are not parallel.
#[test]
fn triangular_emitter() {
    let corners = [[-0.5, -0.4, 0.0], [0.6, -0.3, 0.0], [-0.1, 0.7, 0.0]];
    let mesh = Mesh {
        positions: corners.map(|p| down(1.0).point(p.into())).to_vec(),
        faces: vec![[0, 1, 2]],
    };
    let scene = lit_by(mesh, 10.0);
    shadow_case(
        "triangular emitter",
        scene,
        "thing.translate.x + bulb.translate.y",
    );
}

/// More edges than are sampled one by one elsewhere; the window of a disk is a
/// square.
#[test]
fn round_emitter() {
    let scene = lit_by(disk(down(0.5)).0, 10.0);
    shadow_case("disk", scene, "thing.translate.x + bulb.translate.y");
}

/// An emitter that is not flat, and shows its own silhouette.
#[test]
fn spherical_emitter() {
    let mesh = placed(icosphere(5), down(0.4));
    let scene = lit_by(mesh, 8.0);
    shadow_case("ball", scene, "thing.translate.x - bulb.translate.y");
}

/// Emitters that hide each other, of which one is looked at at a time.
#[test]
fn two_emitters() {
    let mut scene = with(triangle());
    let (mesh, normals) = rectangle(down(0.3));
    let mesh = placed(mesh, Affine::translate(v(0.1, 0.2, -0.7)));
    add(&mut scene, "bulb", mesh, normals, 0.0);
    light_up(&mut scene, 6.0);
    let expression = "thing.translate.x + bulb.translate.y - lamp.translate.x";
    shadow_case("two emitters", scene, expression);
}

/// Edges before an emitter that are too many to list: subtrees of them are sampled, in scenes of each kind of
/// edge, among them a blade that cuts through the emitter, which is no edge of a mesh.
#[test]
fn subtrees_before_emitters() {
    let all_in_subtrees = Method::Edges(Gathers {
        listed: 0,
        points: 2,
        ..Gathers::ALL
    });
    let mut cut = lit_by(rectangle(down(0.5)).0, 10.0);
    let blade = Affine::translate(v(0.25, 0.1, 3.0))
        * Affine::rotate(v(0.0, 1.0, 0.1), std::f64::consts::FRAC_PI_2)
        * Affine::scale(v(0.7, 0.7, 0.7));
    let (mesh, normals) = rectangle(blade);
    add(&mut cut, "blade", mesh, normals, 0.3);
    let scenes = [
        (
            "ball",
            with(small_ball()),
            "thing.translate.y + lamp.translate.x",
        ),
        (
            "cut emitter",
            cut,
            "blade.translate.x + 0.5*thing.translate.x",
        ),
    ];
    for (name, scene, expression) in scenes {
        let tangent = tangent(&scene, expression);
        let case = Case {
            step: 1e-2,
            gradient_spp: 64,
            reference_spp: 640,
            min_pixels: 400,
            method: all_in_subtrees,
            ..Case::default()
        };
        agree(&format!("subtrees, {name}"), scene, &tangent, case);
    }
}

/// What lies in the plane of an emitter, on it or beside it, hides nothing of it: the emitter is in
/// front. Turned out of the plane, it does.
#[test]
fn blind_in_the_plane_of_an_emitter() {
    let mut scene = lit_by(rectangle(down(0.5)).0, 8.0);
    let shapes = Arc::make_mut(&mut scene.shapes[1]);
    assert_eq!(shapes.id, "thing");
    let place = Affine::translate(v(0.2, 0.0, 0.0)) * down(0.3);
    shapes.mesh = rectangle(place).0;
    scene.film.size = [24; 2];
    scene.film.crop_size = [24; 2];
    let flat = by(
        Method::EDGES,
        &scene,
        &tangent(&scene, "thing.translate.x"),
        16,
    );
    // Up to what light changes between the two rays beside an edge.
    let is_zero = |image: &Image| image.pixels.iter().all(|p| p.max_component().abs() < 1e-7);
    assert!(
        is_zero(&flat.gradient.mean),
        "what hides nothing has a shadow"
    );
    let shape = Arc::make_mut(&mut scene.shapes[1]);
    shape.mesh.positions[0].z -= 0.1;
    let bent = by(
        Method::EDGES,
        &scene,
        &tangent(&scene, "thing.translate.x"),
        16,
    );
    assert!(!is_zero(&bent.gradient.mean));
}

/// An emitter in the plane of a ceiling is in front of it, whichever comes first: it has a border,
/// and shadows.
#[test]
fn emitter_in_a_ceiling() {
    let place = |scene: &mut Scene, name: &str, size: f64| {
        let (mesh, normals) = rectangle(down(size));
        add(scene, name, mesh, normals, 0.0);
    };
    for is_first in [true, false] {
        let mut scene = with(triangle());
        scene.shapes.retain(|shape| shape.id != "lamp");
        scene.emitters.clear();
        if is_first {
            place(&mut scene, "ceiling", 2.0);
        }
        place(&mut scene, "bulb", 0.4);
        light_up(&mut scene, 8.0);
        if !is_first {
            place(&mut scene, "ceiling", 2.0);
        }
        for expression in ["thing.translate.x", "bulb.translate.x + 0.5*bulb.scale"] {
            let name = match is_first {
                true => format!("emitter behind a ceiling, {expression}"),
                false => format!("emitter before a ceiling, {expression}"),
            };
            shadow_case(&name, scene.clone(), expression);
        }
    }
}

/// A box of six rectangles: at each of its edges two edges lie on each other.
#[test]
fn edges_on_edges() {
    let (scene, expression) = box_of_sides();
    shadow_case("shadow of edges on edges", scene, &expression);
}

/// Emitters before a sky: what one method samples is hidden by what the other does.
#[test]
fn emitter_before_a_sky() {
    let mut scene = with(triangle());
    add_constant_light(&mut scene, 0.6);
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    let expression = "thing.translate.x + lamp.translate.y + 0.5*floor.translate.z";
    shadow_case("emitter before a sky", scene, expression);
}

fn camera_case(name: &str, scene: Scene, expression: &str, case: Case) {
    let tangent = tangent(&scene, expression);
    agree(name, scene, &tangent, edges(case));
}

/// A silhouette and a shadow.
#[test]
fn silhouettes() {
    for filter in [Filter::Box, Filter::Gaussian { stddev: 0.5 }] {
        let case = Case {
            step: 3e-3,
            gradient_spp: 20,
            reference_spp: 340,
            min_pixels: 700,
            ..primary()
        };
        let name = format!("silhouette, {filter:?}");
        camera_case(&name, visible_ball(filter), "ball.translate.x", case);
    }
}

/// Every edge moves, and the image between them.
#[test]
fn camera() {
    let case = Case {
        step: 1e-3,
        gradient_spp: 24,
        reference_spp: 1400,
        ..primary()
    };
    let expression = "sensor.translate.x + 0.3*sensor.rotate.z + 0.2*sensor.x_fov";
    camera_case("camera", visible_cube(), expression, case);
}

/// Each point of the lens has its own silhouettes.
#[test]
fn lens() {
    let scene = through_lens(visible_ball(Filter::Gaussian { stddev: 0.5 }), 0.12, 2.9);
    let expression = "ball.translate.x + 0.3*sensor.translate.x + 0.2*sensor.aperture_radius";
    let case = Case {
        step: 3e-3,
        gradient_spp: 6,
        reference_spp: 120,
        ..primary()
    };
    camera_case("lens", scene, expression, case);
}

/// Edges between faces of which both are seen, and curves where surfaces cross,
/// which belong to no mesh.
#[test]
fn crossing() {
    let mut scene = visible_cube();
    let (mesh, normals) = capwalk_scene::primitive::cube(Affine::scale(v(0.8, 0.2, 0.7)));
    add(&mut scene, "blade", mesh, normals, 0.4);
    let case = Case {
        step: 2e-3,
        gradient_spp: 64,
        ..primary()
    };
    camera_case(
        "crossing",
        scene,
        "thing.translate.x - blade.translate.z",
        case,
    );
}

/// A wall stands through a floor of the same width: the borders of both meet at the ends of the
/// curve where they cross.
#[test]
fn crossing_of_surfaces_of_one_width() {
    let mut scene = empty(v(0.2, -3.0, 1.2), v(0.0, 0.3, 0.2), 40.0, 36);
    add_emitter(&mut scene, v(0.3, -1.2, 3.0), 1.0, 0.3, 6.0);
    let (floor, normals) = rectangle(Affine::scale(v(0.8, 0.8, 1.0)));
    add(&mut scene, "floor", floor, normals, 0.2);
    let upright = Affine::rotate(v(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_2);
    let stand = Affine::translate(v(0.0, 0.31, 0.37)) * upright;
    let (wall, normals) = rectangle(stand * Affine::scale(v(0.8, 0.8, 1.0)));
    add(&mut scene, "wall", wall, normals, 0.9);
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    let case = Case {
        min_pixels: 300,
        ..primary()
    };
    let tangent = tangent(&scene, "floor.translate.z");
    let methods = [(Method::Walk, 160), (Method::EDGES, 40)];
    agree_by(&methods, "one width", scene, &tangent, case);
}

/// A mask goes at a low angle through a floor that is much wider than all that is seen of it: behind
/// the mask and above the floor, the other surface is as near as rays beside their crossing pass it.
#[test]
fn crossing_of_a_mask_at_a_low_angle() {
    mask_on_floor(
        "mask",
        Affine::translate(Vec3::zero()),
        "leaf.translate.z",
        5e-4,
        1030,
    );
}

/// A mask of which a border lies on the floor and slides there, at a low angle.
#[test]
fn border_of_a_mask_on_a_floor() {
    let along = Affine::rotate(v(0.0, 0.0, 1.0), 0.3_f64.atan());
    let from_axis = Affine::translate(v(0.0, 0.5, 0.0));
    mask_on_floor("border", along * from_axis, "leaf.translate.y", 5e-3, 340);
}

/// A mask, placed before it is turned out of a floor, seen from above.
fn mask_on_floor(name: &str, place: Affine, parameter: &str, step: f64, spp: u32) {
    let mut scene = empty(v(0.3, -3.0, 2.0), Vec3::zero(), 22.0, 12);
    scene.film.filter = Filter::Tent { radius: 1.0 };
    let radiance = scene.add_texture(Texture::colour("sky.radiance", Rgb::splat(1.0)));
    let id = "sky".into();
    scene.emitters.push(Emitter::Constant { id, radiance });
    let (floor, normals) = rectangle(Affine::scale(v(1e6, 1e6, 1.0)));
    add(&mut scene, "floor", floor, normals, 0.5);
    let turn = Affine::rotate(v(1.0, 0.3, 0.0), 0.2);
    let (leaf, normals) = rectangle(turn * place * Affine::scale(v(0.5, 0.5, 1.0)));
    add(&mut scene, "leaf", leaf, normals, 0.6);
    crate::common::materials::make(&mut scene, "leaf", |n| Bsdf::Mask {
        opacity: n.number("opacity", 0.5),
        nested: n.diffuse("green", [0.2, 0.6, 0.3]),
    });
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(4),
        rr_depth: 5,
        hide_emitters: false,
    };
    let case = Case {
        size: 12,
        gradient_spp: spp,
        reference_spp: 8000,
        step,
        min_pixels: 100,
        ..primary()
    };
    camera_case(name, scene, parameter, case);
}

/// What moves before a mirror is seen in it, too, and before the emitter that it shows.
#[test]
fn mirror() {
    let mut scene = visible_cube();
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 5,
        hide_emitters: false,
    };
    crate::common::materials::make(&mut scene, "floor", |n| n.copper());
    let case = Case {
        step: 2e-3,
        gradient_spp: 310,
        reference_spp: 2100,
        min_pixels: 300,
        ..primary()
    };
    camera_case("mirror", scene, "thing.translate.x", case);
}

/// Lists that are kept change no bit.
#[test]
fn threads_change_nothing() {
    let scene = visible_ball(Filter::Gaussian { stddev: 0.5 });
    let tangent = tangent(&scene, "ball.translate.x + sensor.translate.z");
    let run = |threads| {
        let options = RenderOptions::new(5, 2);
        let settings = GradientOptions {
            method: Method::EDGES,
            ..GradientOptions::new(options)
        };
        let prepared = PreparedScene::new(scene.clone());
        let work = || gradient(&prepared, &tangent, &settings, &Unwatched);
        with_threads(threads, work)
            .expect("covered")
            .gradient
            .mean
            .pixels
    };
    assert_eq!(run(1), run(3));
}

pub fn by(method: Method, scene: &Scene, tangent: &Tangent, spp: u32) -> GradientImage {
    let options = GradientOptions {
        method,
        ..GradientOptions::new(RenderOptions::new(spp, u64::from(method == Method::Walk)))
    };
    let started = Instant::now();
    let result = gradient(
        &PreparedScene::new(scene.clone()),
        tangent,
        &options,
        &Unwatched,
    )
    .expect("covered");
    let errors = result.gradient.standard_error.pixels.iter();
    let variance: f64 = errors.map(|e| e.dot(*e) * f64::from(spp) / 3.0).sum();
    let (pixels, seconds) = (
        scene.film.pixel_count() as f64,
        started.elapsed().as_secs_f64(),
    );
    println!(
        "{method:?}: variance {:.3e}, {:.2} µs per sample",
        variance / pixels,
        1e6 * seconds / f64::from(spp) / pixels
    );
    result
}

/// Demands that both methods agree.
fn methods_agree(name: &str, mut scene: Scene, expression: &str, spp: u32) {
    scene.film.crop_offset = [0, 0];
    scene.film.size = [32; 2];
    scene.film.crop_size = [32; 2];
    let tangent = tangent(&scene, expression);
    let ours = by(Method::EDGES, &scene, &tangent, spp);
    let walk = by(Method::Walk, &scene, &tangent, 2 * spp);
    let result = compare(&ours.gradient, &walk.gradient);
    println!("{name}: {result}");
    assert_eq!(result.verdict, Verdict::Right, "{name}");
    assert_eq!(ours.statistics.non_finite, 0, "{name}");
}

/// The built-in scenes as users get them, but small.
#[test]
fn walks_agree() {
    let scene = |name| builtin::scene(name).expect("a built-in scene");
    methods_agree("leaf", scene("leaf"), "leaf.translate.x", 64);
    methods_agree("ball", scene("ball"), "ball.translate.x", 64);
    let lattice = scene("lattice-shadow");
    methods_agree("lattice-shadow", lattice, "lattice.translate.x", 100);
    methods_agree("box-room", scene("box-room"), "box.translate.x", 64);
}
