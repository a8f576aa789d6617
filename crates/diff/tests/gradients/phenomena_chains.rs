//! Light that arrives by way of curved mirrors and refracting glass, in both modes. (Differences of such images are in
//! the folders of `tests/scenes`.)

use crate::common::both_modes::{adjoint, agree_by, everything, settings, small};
use crate::common::materials::*;
use crate::common::refused::mirror_floor;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{
    Dips, Estimate, GradientOptions, Method, PreparedScene, RenderOptions, Unwatched, Wanted,
    backward, gradient, render,
};
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::lobe::Conductor;
use capwalk_scene::primitive::{cube, icosphere, rectangle};
use capwalk_scene::*;

/// A cube beside or in a smooth ball under a sky.
fn beside_a_ball(thing: Vec3) -> Scene {
    seen_from(v(0.0, -4.0, 0.6), v(0.0, 0.0, 0.0), 24.0, thing)
}

/// The same, as a camera sees it that looks from one point to another.
fn seen_from(from: Vec3, to: Vec3, fov: f64, thing: Vec3) -> Scene {
    let mut scene = empty(from, to, fov, 24);
    let ball = placed(icosphere(2), Affine::scale(Vec3::splat(0.6)));
    let normals = ShadingNormals::computed(&ball);
    add(&mut scene, "ball", ball, normals, 0.5);
    let turn = Affine::rotate(v(0.3, 0.2, 1.0), 0.6);
    let place = Affine::translate(thing) * turn * Affine::scale(Vec3::splat(0.2));
    let (thing, normals) = cube(place);
    add(&mut scene, "thing", thing, normals, 0.5);
    let radiance = scene.add_texture(Texture::colour("sky", Rgb::new(0.6, 0.7, 1.0)));
    scene.emitters.push(Emitter::Constant {
        id: "sky".into(),
        radiance,
    });
    scene
}

/// Forward and reverse mode are one linear map, also through chains, by both methods: everything moves, or nothing but
/// what is seen behind glass whose refractive index changes.
#[test]
fn both_modes_are_one_map() {
    let mut mirror = beside_a_ball(v(-0.7, -1.0, -0.1));
    make(&mut mirror, "ball", |n| n.mirror());
    make(&mut mirror, "thing", |n| n.coat(false));
    let mut glassy = beside_a_ball(v(0.05, 0.0, 0.0));
    make(&mut glassy, "ball", |n| n.glass());
    let mut behind = beside_a_ball(v(0.1, 1.2, 0.0));
    make(&mut behind, "ball", |n| n.glass());
    let mut parallel = mirror.clone();
    parallel.sensor.model = SensorModel::Orthographic;
    for (name, mut scene) in [
        ("mirror", mirror),
        ("glass", glassy),
        ("behind glass", behind),
        ("parallel rays", parallel),
        ("smooth floor", mirror_floor()),
    ] {
        small(&mut scene, 5);
        let all = everything(&scene, 7);
        let mut numbers = Tangent::zero(&scene);
        numbers.textures.clone_from(&all.textures);
        let prepared = PreparedScene::new(scene);
        for (motion, method) in [
            (&all, Method::Walk),
            (&all, Method::EDGES),
            (&numbers, Method::Walk),
            (&numbers, Method::EDGES),
        ] {
            let settings = GradientOptions {
                method,
                ..settings(6)
            };
            let name = format!("{name} by {}", method.name());
            agree_by(&name, &prepared, motion, &settings);
        }
    }
}

/// The sum of an image, and its standard error.
fn sum(image: &Estimate) -> (f64, f64) {
    let pixels = image.mean.pixels.iter().map(|pixel| pixel.mean());
    let errors = image.standard_error.pixels.iter();
    let squares = errors.map(|error| error.mean().powi(2));
    (pixels.sum(), squares.sum::<f64>().sqrt())
}

/// Light that has a field along its chain and all other light are the image together: also behind a pane, through
/// which a ray goes on, and where a coat both scatters and reflects.
#[test]
fn no_light_is_lost() {
    let mut mirror = beside_a_ball(v(-0.7, -1.0, -0.1));
    make(&mut mirror, "ball", |n| n.mirror());
    make(&mut mirror, "thing", |n| n.coat(false));
    let place = Affine::translate(v(0.0, -2.0, 0.0)) * Affine::rotate(v(1.0, 0.0, 0.0), 1.5);
    let (pane, normals) = rectangle(place * Affine::scale(Vec3::splat(2.0)));
    let mut behind = mirror.clone();
    add(&mut behind, "pane", pane, normals, 0.0);
    make(&mut behind, "pane", |n| n.pane());
    let mut glassy = beside_a_ball(v(0.05, 0.0, 0.0));
    make(&mut glassy, "ball", |n| n.glass());
    for (name, mut scene) in [("mirror", mirror), ("pane", behind), ("glass", glassy)] {
        small(&mut scene, 6);
        let motion = everything(&scene, 7);
        let prepared = PreparedScene::new(scene);
        let options = RenderOptions::new(200, 3);
        let image = render(&prepared, &options, &Unwatched);
        let derivative = gradient(&prepared, &motion, &options.into(), &Unwatched);
        let [(all, error), (found, own_error)] =
            [image.value, derivative.expect("covered").value].map(|image| sum(&image));
        let error = error.hypot(own_error);
        println!("{name}: {found} instead of {all} ± {error}");
        assert!(
            (found - all).abs() < 4.5 * error,
            "{name}: {found} {all} ± {error}"
        );
        assert!(error < 0.02 * all, "{name}");
    }
}

/// Where images are magnified or shrunk without bound, and where refraction ends, no sample is lost: derivatives and
/// their errors are finite, and both modes agree.
#[test]
fn numbers_are_finite_where_derivatives_have_no_bound() {
    // The edges of a glowing cube half-way between the centre of a concave mirror and that.
    let mut focus = seen_from(
        v(0.0, -0.5, 0.05),
        v(0.0, 0.6, 0.0),
        50.0,
        v(0.02, 0.3, 0.0),
    );
    make(&mut focus, "ball", |n| n.mirror());
    let radiance = focus.add_texture(Texture::colour("glow", Rgb::new(3.0, 2.0, 1.0)));
    let shape = ShapeId(focus.shapes.len() as u32 - 1);
    focus.shape_mut(shape).emitter = Some(EmitterId(focus.emitters.len() as u32));
    focus.emitters.push(Emitter::Area { shape, radiance });
    // The limb of a mirror ball, from near.
    let mut limb = seen_from(v(0.0, -4.0, 0.0), v(0.59, 0.0, 0.0), 1.0, v(1.2, 0.3, 0.0));
    make(&mut limb, "ball", |n| n.mirror());
    // Out of a glass ball, where light begins to be reflected totally.
    let mut critical = seen_from(v(0.0, -0.5, 0.1), v(0.45, 0.3, 0.1), 60.0, v(1.2, 1.0, 0.1));
    make(&mut critical, "ball", |n| n.glass());
    for (name, mut scene) in [
        ("focus", focus),
        ("limb", limb),
        ("critical angle", critical),
    ] {
        small(&mut scene, 4);
        let motion = everything(&scene, 7);
        let prepared = PreparedScene::new(scene);
        let options = settings(64);
        let found = gradient(&prepared, &motion, &options, &Unwatched).expect("covered");
        assert_eq!(found.statistics.non_finite, 0, "{name}");
        let (_, error) = sum(&found.gradient);
        assert!(error.is_finite() && error > 0.0, "{name}: {error}");
        agree_by(name, &prepared, &motion, &settings(16));
    }
}

/// What a convex mirror shows is continuous up to its silhouette, however coarse it is: under an even sky, a perfect
/// one cannot be seen.
#[test]
fn a_coarse_mirror_ball_is_even_under_an_even_sky() {
    let mut scene = beside_a_ball(v(0.0, 9.0, 0.0));
    let ball = placed(icosphere(1), Affine::scale(Vec3::splat(0.6)));
    scene.shapes.truncate(1);
    let shape = scene.shape_mut(ShapeId(0));
    shape.normals = ShadingNormals::computed(&ball);
    shape.mesh = ball;
    make(&mut scene, "ball", |n| Conductor {
        eta: n.colour("eta", [0.0; 3]),
        k: n.colour("k", [1.0; 3]),
        specular_reflectance: n.colour("specular_reflectance", [1.0; 3]),
    });
    paths(&mut scene, 2);
    let options = RenderOptions {
        spp: 16,
        ..RenderOptions::of(&scene)
    };
    let image = render(&PreparedScene::new(scene), &options, &Unwatched).value;
    for pixel in &image.mean.pixels {
        let difference = *pixel - Rgb::new(0.6, 0.7, 1.0);
        assert!(difference.map(f64::abs).max_component() < 1e-9, "{pixel:?}");
    }
}

/// Both modes say how many rays dip below the faces of a smooth mirror where it is concave: none where it is convex or
/// its faces are flat, and none are looked for where nothing moves.
#[test]
fn rays_that_dip_below_faces_are_counted() {
    let mut convex = beside_a_ball(v(-0.7, -1.0, -0.1));
    make(&mut convex, "ball", |n| n.mirror());
    small(&mut convex, 3);
    // Seen from within, beside a corner, along its wall.
    let corner = icosphere(2).positions[0];
    let (from, way) = (corner * (0.6 * 0.985), corner.cross(v(0.3, 0.5, 0.7)));
    let mut smooth = seen_from(from, from + way, 90.0, v(0.1, 0.0, 0.0));
    smooth.sensor.near_clip = 1e-4;
    make(&mut smooth, "ball", |n| n.mirror());
    small(&mut smooth, 3);
    let ball = smooth.shape_mut(ShapeId(0));
    ball.mesh.faces.iter_mut().for_each(|face| face.swap(0, 1));
    ball.normals = ShadingNormals::computed(&ball.mesh);
    let mut flat = convex.clone();
    flat.shape_mut(ShapeId(0)).normals = ShadingNormals::Face;
    // Before other cameras flat mirrors have images, and no chains.
    flat.sensor.model = SensorModel::Orthographic;
    let dips = |scene: Scene, moves: bool| {
        let mut motion = everything(&scene, 7);
        if !moves {
            let mut numbers = Tangent::zero(&scene);
            numbers.textures.clone_from(&motion.textures);
            motion = numbers;
        }
        let adjoint = adjoint(&scene, 3);
        let prepared = PreparedScene::new(scene);
        let forward = gradient(&prepared, &motion, &settings(1), &Unwatched).expect("covered");
        let wanted = Wanted::by(&motion);
        let reverse = backward(&prepared, &adjoint, &wanted, &settings(1), &Unwatched);
        let found = forward.statistics.dips;
        assert_eq!(found, reverse.expect("covered").statistics.dips);
        found
    };
    let found = dips(convex, true);
    assert!(found.dip == 0 && found.events > 100, "{found:?}");
    let found = dips(smooth.clone(), true);
    println!("{found:?}");
    assert!(found.dip > 0 && found.dip < found.events / 10, "{found:?}");
    assert!(found.remark().is_some());
    assert_eq!(dips(smooth, false), Dips::default());
    let found = dips(flat, true);
    assert!(found.dip == 0 && found.events > 100, "{found:?}");
    assert_eq!(found.remark(), None);
}
