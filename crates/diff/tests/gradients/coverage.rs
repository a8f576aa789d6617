//! Whether a derivative is covered is decided before the work: one answer for a scene and what moves
//! in it, whatever the samples, and a word in the result where a sample shows more.

use std::borrow::Cow;

use crate::common::agree::tangent;
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{
    AllowMissing, BackwardWork, GradientImage, GradientOptions, GradientWork, KeptChoice, Method,
    Part, PreparedScene, Refusal, RenderOptions, SpecularCause, Unwatched, Wanted,
};
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::{cube, icosphere, rectangle};
use capwalk_scene::*;

const METHODS: [Method; 3] = [Method::Auto, Method::Walk, Method::EDGES];
/// Of the film, pixels.
const SIZES: [[u32; 2]; 4] = [[8, 6], [16, 12], [24, 18], [32, 24]];

fn set_size(scene: &mut Scene, size: [u32; 2]) {
    (scene.film.size, scene.film.crop_size) = (size, size);
}

fn add_cube(scene: &mut Scene, id: &str, centre: Vec3, half: f64) {
    let turn = Affine::rotate(v(0.3, 0.8, 0.5), 0.7);
    let (mesh, normals) = cube(Affine::translate(centre) * turn * Affine::scale(Vec3::splat(half)));
    add(scene, id, mesh, normals, 0.6);
}

/// A smooth ball of 320 faces.
fn add_ball(scene: &mut Scene, id: &str, radius: f64) {
    let place = Affine::translate(v(0.75, 0.2, 0.3)) * Affine::scale(Vec3::splat(radius));
    let ball = placed(icosphere(4), place);
    let normals = ShadingNormals::computed(&ball);
    add(scene, id, ball, normals, 0.5);
}

/// A small ball that is a perfect mirror on a floor, under an emitter.
fn stage() -> Scene {
    let mut scene = empty(v(0.2, -4.0, 1.5), v(0.0, 0.0, 0.4), 34.0, 8);
    set_size(&mut scene, [8, 6]);
    paths(&mut scene, 3);
    add_floor(&mut scene, 4.0);
    add_emitter(&mut scene, v(0.9, -0.6, 2.6), 0.8, 0.3, 10.0);
    add_ball(&mut scene, "ball", 0.15);
    make(&mut scene, "ball", |n| n.mirror());
    scene
}

/// A cube that stands where the ball shows it.
fn cube_beside_a_mirror_ball() -> Scene {
    let mut scene = stage();
    add_cube(&mut scene, "thing", v(-0.5, 0.1, 0.4), 0.2);
    scene
}

/// The same behind the camera's back and a wall that the ball does not see past.
fn cube_behind_a_wall() -> Scene {
    let mut scene = stage();
    add_cube(&mut scene, "thing", v(-2.5, 0.1, 0.4), 0.2);
    let place = Affine::translate(v(-1.5, 0.0, 1.5))
        * Affine::rotate(v(0.0, 1.0, 0.0), std::f64::consts::FRAC_PI_2)
        * Affine::scale(v(6.0, 6.0, 1.0));
    let (mesh, normals) = rectangle(place);
    add(&mut scene, "wall", mesh, normals, 0.5);
    scene
}

/// Both modes of a derivative of a scene, prepared anew, up to what they refuse.
fn both_refuse(scene: &Scene, options: GradientOptions) -> [Option<Refusal>; 2] {
    let moves = tangent(scene, "thing.translate.x");
    let prepared = || PreparedScene::new(scene.clone());
    let (forward, reverse) = (prepared(), prepared());
    let adjoint = ones(scene);
    [
        GradientWork::new(&forward, Cow::Borrowed(&moves), options).check(&Unwatched),
        BackwardWork::new(&reverse, &adjoint, Wanted::by(&moves), options).check(&Unwatched),
    ]
    .map(Result::err)
}

fn ones(scene: &Scene) -> Image {
    let [width, height] = scene.film.crop_size.map(|n| n as usize);
    let mut adjoint = Image::new(width, height);
    adjoint.pixels.fill(Rgb::splat(1.0));
    adjoint
}

fn with_method(method: Method, spp: u32, seed: u64) -> GradientOptions {
    GradientOptions {
        method,
        ..GradientOptions::new(RenderOptions::new(spp, seed))
    }
}

fn cause(refusal: &Option<Refusal>) -> Option<SpecularCause> {
    match refusal {
        Some(Refusal::SpecularMotion { cause }) => Some(*cause),
        _ => None,
    }
}

/// Whatever the size of the image, the samples, the seed, the method and the mode.
#[test]
fn the_answer_is_one() {
    for (scene, is_refused) in [
        (cube_beside_a_mirror_ball(), true),
        (cube_behind_a_wall(), false),
    ] {
        for size in SIZES {
            for method in METHODS {
                for seed in 0..3 {
                    let mut scene = scene.clone();
                    set_size(&mut scene, size);
                    let options = with_method(method, 1 + seed as u32, seed);
                    let refusals = both_refuse(&scene, options).map(|r| cause(&r).is_some());
                    assert_eq!(refusals, [is_refused; 2], "{size:?} {method:?} {seed}");
                }
            }
        }
    }
}

/// Neither does it matter which part of the film is rendered, and with which filter, nor in how many
/// parts the work is done; each of these refuses, and takes no sample before.
#[test]
fn parts_and_crops_have_the_same_answer() {
    let mut scene = cube_beside_a_mirror_ball();
    set_size(&mut scene, [32, 24]);
    // The left side of the film, without the ball.
    (scene.film.crop_offset, scene.film.crop_size) = ([0, 0], [4, 4]);
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    let moves = tangent(&scene, "thing.translate.x");
    let (prepared, adjoint) = (PreparedScene::new(scene.clone()), ones(&scene));
    for method in METHODS {
        let options = with_method(method, 4, 1);
        let forward = GradientWork::new(&prepared, Cow::Borrowed(&moves), options);
        let reverse = BackwardWork::new(&prepared, &adjoint, Wanted::by(&moves), options);
        let part = |grid| Part::nth(grid, 1, 2).expect("a part");
        let forward_part = forward.part(&part(forward.grid()), &Unwatched);
        let reverse_part = reverse.part(&part(reverse.grid()), &Unwatched);
        let refused = [
            forward.chosen(&Unwatched).is_err(),
            forward_part.is_err(),
            forward.whole(&Unwatched).is_err(),
            reverse.chosen(&Unwatched).is_err(),
            reverse_part.is_err(),
            reverse.whole(&Unwatched).is_err(),
        ];
        assert_eq!(refused, [true; 6], "{method:?}");
    }
}

/// Paths that end at the ball show nothing in it.
#[test]
fn paths_that_are_too_short_show_nothing() {
    let mut scene = cube_beside_a_mirror_ball();
    paths(&mut scene, 1);
    for method in METHODS {
        let refusals = both_refuse(&scene, with_method(method, 1, 0));
        assert_eq!(refusals, [None, None], "{method:?}");
    }
}

/// What is small is aimed at: the cube takes less than a millionth of the directions around the
/// ball, and the ball a ten-thousandth of the image.
#[test]
fn small_things_are_found() {
    let mut scene = stage();
    scene.shapes.retain(|shape| shape.id != "ball");
    scene.emitters = vec![];
    add_constant_light(&mut scene, 1.0);
    add_ball(&mut scene, "pearl", 0.015);
    make(&mut scene, "pearl", |n| n.mirror());
    add_cube(&mut scene, "thing", v(-2.5, -2.0, 2.0), 0.003);
    for method in METHODS {
        let refusals = both_refuse(&scene, with_method(method, 1, 0));
        assert!(refusals.iter().all(|r| cause(r).is_some()), "{method:?}");
    }
}

/// Only the rays of walks move that show something in the ball.
fn cube_hidden_from_a_mirror_ball() -> Scene {
    let mut scene = cube_beside_a_mirror_ball();
    // A wall stands between the ball and the cube, and the camera sees both.
    let place = Affine::translate(v(0.2, 0.1, 0.5))
        * Affine::rotate(v(0.0, 1.0, 0.0), std::f64::consts::FRAC_PI_2)
        * Affine::scale(v(0.8, 0.8, 1.0));
    let (mesh, normals) = rectangle(place);
    add(&mut scene, "wall", mesh, normals, 0.5);
    scene.shapes.retain(|shape| shape.id != "floor");
    paths(&mut scene, 2);
    scene
}

/// There, walks are refused, edges are not, and the method that chooses takes edges.
#[test]
fn only_walks_move_what_rests_in_a_mirror() {
    let scene = cube_hidden_from_a_mirror_ball();
    for refusal in both_refuse(&scene, with_method(Method::Walk, 1, 0)) {
        assert_eq!(cause(&refusal), Some(SpecularCause::Walks), "{refusal:?}");
        let text = refusal.expect("just seen").to_string();
        assert!(text.contains("rays of walks move"), "{text}");
    }
    for method in [Method::Auto, Method::EDGES] {
        let refusals = both_refuse(&scene, with_method(method, 1, 0));
        assert_eq!(refusals, [None, None], "{method:?}");
    }
    let moves = tangent(&scene, "thing.translate.x");
    let prepared = PreparedScene::new(scene);
    let auto = with_method(Method::Auto, 2, 0);
    let work = GradientWork::new(&prepared, Cow::Borrowed(&moves), auto);
    let chosen = work.chosen(&Unwatched).expect("covered").options;
    let gathers = chosen.method.traits().gathers;
    assert!(gathers.camera, "{gathers:?}");
}

/// A method that was chosen for a scene in which walks show all is not taken over where they do not.
#[test]
fn a_kept_method_covers_what_moves_now() {
    let scene = cube_hidden_from_a_mirror_ball();
    let mut without_mirror = scene.clone();
    make(&mut without_mirror, "ball", |n| lobe::Diffuse {
        reflectance: n.colour("reflectance", [0.5; 3]),
    });
    let moves = tangent(&scene, "thing.translate.x");
    let (adjoint, kept) = (ones(&scene), KeptChoice::default());
    let chosen = |scene: &Scene, method| {
        let (prepared, options) = (PreparedScene::new(scene.clone()), with_method(method, 1, 0));
        let forward = GradientWork::new(&prepared, Cow::Borrowed(&moves), options);
        let reverse = BackwardWork::new(&prepared, &adjoint, Wanted::by(&moves), options);
        let found = [
            forward.keeping(kept.clone()).chosen(&Unwatched),
            reverse.keeping(kept.clone()).chosen(&Unwatched),
        ];
        found.map(|chosen| {
            chosen
                .expect("covered")
                .options
                .method
                .traits()
                .gathers
                .camera
        })
    };
    assert_eq!(chosen(&without_mirror, Method::FittedWalk), [false; 2]);
    assert_eq!(chosen(&without_mirror, Method::Auto), [false; 2]);
    assert_eq!(chosen(&scene, Method::Auto), [true; 2]);
}

/// What a refractive index turns is seen elsewhere: it moves, though no shape does. Colours turn
/// nothing, and ask no probe.
#[test]
fn refractive_indices_move_what_is_seen() {
    let mut scene = stage();
    make(&mut scene, "ball", |n| n.glass());
    let prepared = PreparedScene::new(scene);
    for (name, is_refused) in [
        ("ball.bsdf.int_ior.value", true),
        ("ball.bsdf.specular_transmittance.value", false),
        ("floor.bsdf.reflectance.value", false),
    ] {
        let moves = tangent(prepared.scene(), name);
        let options = with_method(Method::Auto, 1, 0);
        let work = GradientWork::new(&prepared, Cow::Borrowed(&moves), options);
        assert_eq!(work.check(&Unwatched).is_err(), is_refused, "{name}");
    }
}

/// A large mirror that shows nothing of what moves, with one face in twenty thousand that does.
fn a_face_that_nobody_looks_at() -> Scene {
    const SIDE: u32 = 100;
    let mut scene = empty(v(0.0, 0.0, 10.0), v(0.0, 0.0, 0.0), 40.0, 8);
    add_constant_light(&mut scene, 1.0);
    scene.settings.integrator = Integrator::Direct {
        emitter_samples: 1,
        bsdf_samples: 1,
        hide_emitters: false,
    };
    let mut mirror = Mesh::default();
    for i in 0..=SIDE * (SIDE + 2) {
        let [x, y] = [i % (SIDE + 1), i / (SIDE + 1)].map(|k| f64::from(k) / f64::from(SIDE));
        mirror.positions.push(v(x - 3.2, 2.0 * y - 1.0, 0.0));
    }
    for i in (0..SIDE * (SIDE + 1)).filter(|i| i % (SIDE + 1) < SIDE) {
        let above = i + SIDE + 1;
        mirror
            .faces
            .extend([[i, i + 1, above + 1], [i, above + 1, above]]);
    }
    let first = mirror.positions.len() as u32;
    let corners = [(0.0, 0.0), (SMALL, 0.0), (0.0, SMALL)];
    mirror
        .positions
        .extend(corners.map(|(x, y)| v(2.0 + x, y, 0.0)));
    mirror.faces.push([first, first + 1, first + 2]);
    let normals = ShadingNormals::computed(&mirror);
    add(&mut scene, "mirror", mirror, normals, 0.5);
    make(&mut scene, "mirror", |n| n.mirror());
    add_cube(&mut scene, "thing", v(2.5, 0.0, 2.5), 0.3);
    light_up(&mut scene, 1.0);
    // A crop around the one face of an image of many pixels.
    let size = 4096;
    set_size(&mut scene, [size; 2]);
    let view = scene.sensor.view(&scene.film);
    let seen = view.film(view.towards(v(2.0 + 0.3 * SMALL, 0.3 * SMALL, 0.0)));
    scene.film.crop_offset = seen.map(|x| x as u32);
    scene.film.crop_size = [1, 1];
    scene
}

/// Of the one face, world units.
const SMALL: f64 = 0.02;

/// What a sample shows that the probe did not is no reason to stop: the result says so, in both modes
/// and in parts.
#[test]
fn what_only_a_sample_shows_is_said() {
    let scene = a_face_that_nobody_looks_at();
    let refusals = both_refuse(&scene, with_method(Method::EDGES, 1, 0));
    assert_eq!(refusals, [None, None]);
    let moves = tangent(&scene, "thing.translate.x");
    let (prepared, adjoint) = (PreparedScene::new(scene.clone()), ones(&scene));
    let options = with_method(Method::EDGES, 16, 1);
    let forward = GradientWork::new(&prepared, Cow::Borrowed(&moves), options);
    let reverse = BackwardWork::new(&prepared, &adjoint, Wanted::by(&moves), options);
    let whole = forward.whole(&Unwatched).expect("not refused");
    let part = forward.part(&Part::whole(forward.grid()), &Unwatched);
    let parts = forward.finish(part.expect("not refused")).expect("whole");
    let gradient = reverse.whole(&Unwatched).expect("not refused");
    let all = |image: &GradientImage| image.statistics.missing;
    assert_eq!(all(&whole), all(&parts));
    for missing in [all(&whole), gradient.statistics.missing] {
        let share = missing.expect("something is missing").share;
        assert!(share > 0.5, "{share}");
    }
    assert!(whole.missing.is_some() && whole.statistics.uncovered > 0);
    // The rest is a work of its own, and not refused either.
    let rest = forward.of_rest().whole(&Unwatched).expect("not refused");
    assert!(rest.missing.is_none());
}

/// With leave, what the probe finds is missing, also if no sample shows it.
#[test]
fn what_the_probe_finds_is_missing() {
    let mut scene = cube_beside_a_mirror_ball();
    set_size(&mut scene, [32, 24]);
    scene.film.crop_size = [2, 2];
    let moves = tangent(&scene, "thing.translate.x");
    let (prepared, adjoint) = (PreparedScene::new(scene.clone()), ones(&scene));
    let options = GradientOptions {
        allow_missing: AllowMissing { specular: true },
        ..with_method(Method::EDGES, 1, 1)
    };
    let forward = GradientWork::new(&prepared, Cow::Borrowed(&moves), options);
    let image = forward.whole(&Unwatched).expect("allowed");
    assert!(image.statistics.uncovered == 0 && image.missing.is_some());
    let reverse = BackwardWork::new(&prepared, &adjoint, Wanted::by(&moves), options);
    let gradient = reverse.whole(&Unwatched).expect("allowed");
    assert!(gradient.statistics.missing.is_some());
}
