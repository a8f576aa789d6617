//! Edges sampled before the environment (METHOD 8), against finite differences and against
//! walks. What is demanded of each case, and how often it raises a false alarm, is said
//! in `phenomena_shadows.rs`.

use crate::common::agree::*;
use crate::common::materials::{make, rough_glass, rough_metal};
use crate::common::stages::*;
use crate::common::*;
use crate::phenomena_edges::by;
use capwalk_diff::check::compare;
use capwalk_diff::{Estimate, Method, PreparedScene, RenderOptions, Unwatched, finite_difference};
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
        size: 22,
        gradient_spp: 100,
        reference_spp: 5000,
        min_pixels: 300,
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

/// A floor of rough metal, in whose highlight some edges of many are.
#[test]
fn glossy_receiver() {
    let mut scene = under_constant_light(with(small_ball()));
    make(&mut scene, "floor", |n| {
        rough_metal(n.mirror(), n.facets(Distribution::Ggx, 0.08))
    });
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    let expression = "thing.translate.x + 0.3*thing.rotate.y";
    let case = Case {
        gradient_spp: 300,
        reference_spp: 4000,
        ..case()
    };
    sky_case("glossy", scene, expression, case);
}

/// A ball with interpolated normals that turns, so that the faces' own horizons move
/// against the sky. Differences seldom see that: all pixels are added up.
#[test]
fn turning_smooth_ball() {
    let mut scene = under_constant_light(empty(v(1.2, -4.0, 1.9), v(0.0, 0.0, 0.6), 0.4, 4));
    add_floor(&mut scene, 4.0);
    let ball = icosphere(1);
    let normals = ShadingNormals::Given(ball.positions.clone());
    let place = Affine::translate(v(0.0, 0.0, 0.6)) * Affine::scale(Vec3::splat(0.5));
    add(&mut scene, "ball", placed(ball, place), normals, 0.6);
    let tangent = tangent(&scene, "ball.rotate.y + ball.rotate.z");
    let sum = |estimate: &Estimate| {
        let pixels = estimate.mean.pixels.iter();
        let errors = estimate.standard_error.pixels.iter();
        let variance: f64 = errors.map(|error| error.g * error.g).sum();
        (pixels.map(|pixel| pixel.g).sum::<f64>(), variance.sqrt())
    };
    let (ours, error) = sum(&by(Method::EDGES, &scene, &tangent, 2000).gradient);
    let options = RenderOptions::new(80_000, 2);
    let prepared = PreparedScene::new(scene);
    let differences = finite_difference(&prepared, &tangent, 1e-2, &options, &Unwatched);
    let (expected, noise) = sum(&differences.expect("covered").gradient);
    println!("{ours} ± {error}, differences {expected} ± {noise}");
    assert!((ours - expected).abs() < 4.0 * error.hypot(noise));
    assert!(noise < 0.04 * expected.abs());
}

/// Light from both sides of a rough pane, whose edges are open.
#[test]
fn transmitting_surface() {
    let mut scene = under_constant_light(with(triangle()));
    make(&mut scene, "floor", |n| {
        let facets = n.facets(Distribution::Beckmann, 0.5);
        rough_glass(n.glass(), facets)
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
    let case = Case {
        gradient_spp: 600,
        ..case()
    };
    sky_case("transmitting", scene, expression, case);
}

/// A box of six rectangles: at each of its edges two edges lie on each other, in
/// different subtrees or the same.
#[test]
fn edges_on_edges() {
    let (mut scene, expression) = box_of_sides();
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
        &expression,
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
    scene.film.size = [22; 2];
    scene.film.crop_size = [22; 2];
    let tangent = tangent(&scene, expression);
    let [ours, walk] =
        [Method::EDGES, Method::Walk].map(|method| by(method, &scene, &tangent, 200));
    let result = compare(&ours.gradient, &walk.gradient);
    println!("{name}: {result}");
    assert!((0.8..=1.25).contains(&result.mean_z_squared), "{name}");
    assert!(result.sign.abs() < 4.0, "{name}");
    assert_eq!(ours.statistics.non_finite, 0, "{name}");
}
