//! Edges sampled before the environment (METHOD 8), against finite differences and against
//! walks. What is demanded of each case, and how often it raises a false alarm, is said
//! in `phenomena_shadows.rs`.

use crate::common::agree::*;
use crate::common::materials::make;
use crate::common::stages::*;
use crate::common::*;
use crate::phenomena_edges::by;
use capwalk_diff::Method;
use capwalk_diff::check::compare;
use capwalk_math::{Affine, Vec3};
use capwalk_scene::lobe::Distribution;
use capwalk_scene::primitive::icosphere;
use capwalk_scene::*;

/// Against differences, and against walks.
fn sky_case(name: &str, scene: Scene, expression: &str, case: Case) {
    let tangent = tangent(&scene, expression);
    agree(name, scene, &tangent, case);
}

fn case() -> Case {
    Case {
        size: 28,
        gradient_spp: 200,
        reference_spp: 800,
        min_pixels: 400,
        method: Method::EDGES,
        ..Case::default()
    }
}

#[test]
fn moving_occluder() {
    let scene = under_constant_light(with(triangle()));
    let expression = "thing.translate.z + 0.5*thing.translate.x";
    sky_case("occluder", scene, expression, case());
}

#[test]
fn environment_map() {
    let scene = under_a_sky(with(small_ball()));
    sky_case("map", scene, "thing.translate.y - thing.rotate.x", case());
}

/// The receiver moves below a thing that does not, and the camera with it.
#[test]
fn receiver_and_camera_move() {
    let scene = under_constant_light(with(tilted_cube().0));
    let expression = "floor.translate.z + 0.5*floor.rotate.x + 0.4*sensor.translate.x";
    sky_case("receiver", scene, expression, case());
}

/// A ball with interpolated normals that turns, so that the faces' horizons move against
/// the sky, while its silhouette nearly stays.
#[test]
fn turning_smooth_ball() {
    let scene = under_constant_light(smooth_ball(1));
    let case = Case {
        step: 2e-2,
        ..case()
    };
    sky_case("turning ball", scene, "ball.rotate.y + ball.rotate.z", case);
}

/// A coarse ball on the floor, not seen beyond its silhouette.
fn smooth_ball(n: u32) -> Scene {
    let mut scene = empty(v(1.2, -4.0, 1.9), v(0.0, 0.0, 0.6), 7.0, 36);
    add_floor(&mut scene, 4.0);
    let ball = icosphere(n);
    let normals = ShadingNormals::Given(ball.positions.clone());
    let place = Affine::translate(v(0.0, 0.0, 0.6)) * Affine::scale(Vec3::splat(0.5));
    add(&mut scene, "ball", placed(ball, place), normals, 0.6);
    scene
}

/// Light from both sides of a rough pane, whose edges are open.
#[test]
fn transmitting_surface() {
    let mut scene = under_constant_light(with(triangle()));
    make(&mut scene, "floor", |n| {
        let facets = n.facets(Distribution::Beckmann, 0.5);
        Bsdf::RoughDielectric(n.glass(), facets)
    });
    let ball = placed(small_ball(), Affine::translate(v(0.2, 0.3, -1.9)));
    add(&mut scene, "below", ball, ShadingNormals::Face, 0.5);
    // Differences want the lobe sampled, too.
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    let expression = "thing.translate.x + below.translate.y + below.translate.z";
    sky_case("transmitting", scene, expression, case());
}

/// A box of six rectangles: at each of its edges two edges lie on each other, in
/// different subtrees or the same.
#[test]
fn edges_on_edges() {
    let mut scene = shadow_stage();
    let (mesh, _) = tilted_cube();
    let mut parts = Vec::new();
    for (i, faces) in mesh.faces.chunks(2).enumerate() {
        let id = format!("side{i}");
        let side = capwalk_geometry::Mesh {
            positions: mesh.positions.clone(),
            faces: faces.to_vec(),
        };
        parts.push(format!("{id}.translate.x"));
        add(&mut scene, &id, side, ShadingNormals::Face, 0.5);
    }
    add(
        &mut scene,
        "far",
        placed(icosphere(4), Affine::translate(v(0.0, 0.0, 9.0))),
        ShadingNormals::Face,
        0.5,
    );
    sky_case(
        "edges on edges",
        under_constant_light(scene),
        &parts.join(" + "),
        case(),
    );
}

/// Walks towards the same light, whose noise is too large for a verdict.
#[test]
fn walks_agree_under_the_sky() {
    let turning = "ball.translate.z + 0.3*ball.rotate.x";
    let ball = visible_ball(Filter::Gaussian { stddev: 0.5 });
    meet_noisy_walks("sky, ball", under_constant_light(ball), turning);
    let cube = under_a_sky(visible_cube());
    meet_noisy_walks("sky, cube", cube, "thing.rotate.z + floor.translate.z");
}

fn meet_noisy_walks(name: &str, mut scene: Scene, expression: &str) {
    scene.film.crop_offset = [0, 0];
    scene.film.size = [28; 2];
    scene.film.crop_size = [28; 2];
    let tangent = tangent(&scene, expression);
    let [ours, walk] =
        [Method::EDGES, Method::Walk].map(|method| by(method, &scene, &tangent, 200));
    let result = compare(&ours.gradient, &walk.gradient);
    println!("{name}: {result}");
    assert!((0.8..=1.25).contains(&result.mean_z_squared), "{name}");
    assert!(result.sign.abs() < 4.0, "{name}");
    assert_eq!(ours.statistics.non_finite, 0, "{name}");
}
