//! Light and its derivatives where they can be written down: an oracle that
//! shares nothing with the estimators, and has no step as finite differences do.

use std::f64::consts::PI;

use crate::common::agree::tangent;
use crate::common::exact::{equals, means, settings};
use crate::common::irradiance::irradiance;
use crate::common::*;
use capwalk_diff::{PreparedScene, Unwatched, WalkSettings, Wanted, backward, gradient};
use capwalk_geometry::Mesh;
use capwalk_math::quadrature::gauss_legendre;
use capwalk_math::{Affine, Rgb, Vec3};
use capwalk_scene::primitive::{disk, rectangle};
use capwalk_scene::*;

/// A point that is lit, and its unit normal.
type Lit = (Vec3, Vec3);

/// What is left of a polygon on the positive side of a plane through `o`.
fn clip(polygon: &[Vec3], o: Vec3, plane: Vec3) -> Vec<Vec3> {
    let height = |p: Vec3| (p - o).dot(plane);
    let mut kept = Vec::new();
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        let (above, next) = (height(a), height(b));
        if above >= 0.0 {
            kept.push(a);
        }
        if (above < 0.0) != (next < 0.0) {
            kept.push(a + (b - a) * (above / (above - next)));
        }
    }
    kept
}

/// Irradiance from a polygon of radiance 1, by Lambert's formula: half the sum
/// of the angles of its edges, each times the cosine at which its plane with the
/// point is seen.
fn lambert(polygon: &[Vec3], (o, n): Lit) -> f64 {
    let visible = clip(polygon, o, n);
    let edges = visible.iter().enumerate().map(|(i, &a)| {
        let (a, b) = (a - o, visible[(i + 1) % visible.len()] - o);
        let cross = a.cross(b);
        match cross.length() {
            0.0 => 0.0,
            length => length.atan2(a.dot(b)) * n.dot(cross) / length,
        }
    });
    0.5 * edges.sum::<f64>().abs()
}

/// What is left of a polygon in the cone from `o` over a triangle before it.
fn behind(polygon: &[Vec3], triangle: [Vec3; 3], o: Vec3) -> Vec<Vec3> {
    let [a, b, c] = triangle.map(|p| p - o);
    let side = a.cross(b).dot(c).signum();
    let planes = [a.cross(b), b.cross(c), c.cross(a)];
    let inside = planes.into_iter();
    inside.fold(polygon.to_vec(), |rest, plane| clip(&rest, o, plane * side))
}

fn triangles<'a>(scene: &'a Scene, id: &'a str) -> impl Iterator<Item = [Vec3; 3]> + 'a {
    let shapes = scene.shapes.iter().filter(move |shape| shape.id == id);
    shapes.flat_map(|shape| {
        let mesh = &shape.mesh;
        mesh.faces
            .iter()
            .map(|face| face.map(|i| mesh.positions[i as usize]))
    })
}

/// Irradiance from the emitter, of radiance 1, less what the triangles of the thing
/// before it hide, if there is one.
fn exact(scene: &Scene, lit: Lit) -> f64 {
    let of_emitter = triangles(scene, "lamp").map(|emitter| {
        let hidden = triangles(scene, "thing").map(|t| lambert(&behind(&emitter, t, lit.0), lit));
        lambert(&emitter, lit) - hidden.sum::<f64>()
    });
    of_emitter.sum()
}

/// The derivative of a closed form along a motion: its central difference, which
/// has eight digits.
fn difference_of(scene: &Scene, tangent: &Tangent, of: impl Fn(&Scene) -> f64) -> f64 {
    const STEP: f64 = 1e-4;
    let [above, below] = [STEP, -STEP].map(|step| of(&scene.moved(tangent, step)));
    (above - below) / (2.0 * STEP)
}

/// Estimates at points along motions against the closed form. Errors are at most
/// this fraction of the light of the emitter, per unit of the motion.
fn meet_exact(scene: &Scene, points: &[Lit], names: &[&str], samples: u32, precision: f64) {
    scene.check().expect("a valid scene");
    for name in names {
        let tangent = tangent(scene, name);
        let walk = WalkSettings::default();
        let results = irradiance(scene, &tangent, points, walk, samples, 3).expect("covered");
        for (i, (result, &lit)) in results.iter().zip(points).enumerate() {
            let value = exact(scene, lit);
            let moments = result.value;
            let title = format!("point {i}");
            equals(
                &title,
                moments.mean,
                moments.standard_error(),
                value,
                precision,
            );
            let derivative = difference_of(scene, &tangent, |scene| exact(scene, lit));
            let moments = result.gradient;
            let title = format!("point {i}, {name}");
            equals(
                &title,
                moments.mean,
                moments.standard_error(),
                derivative,
                precision,
            );
        }
    }
}

/// A scene with nothing but what is added to it.
fn nothing() -> Scene {
    empty(v(0.0, -5.0, 1.0), v(0.0, 0.0, 1.0), 40.0, 4)
}

/// Below a rectangular emitter, tilted, and so that the emitter is partly below the
/// horizon.
fn three_points() -> Vec<Lit> {
    [
        (v(0.3, -0.2, 0.0), v(0.0, 0.0, 1.0)),
        (v(-0.5, 0.4, 0.2), v(0.5, -0.3, 0.8)),
        (v(0.1, 0.0, 0.3), v(0.9, 0.2, -0.05)),
    ]
    .map(|(o, n)| (o, n.normalized()))
    .to_vec()
}

const RIGID: [&str; 7] = [
    "lamp.translate.x",
    "lamp.translate.y",
    "lamp.translate.z",
    "lamp.rotate.x",
    "lamp.rotate.y",
    "lamp.rotate.z",
    "lamp.scale",
];

#[test]
fn a_rectangular_emitter() {
    let mut scene = nothing();
    add_emitter(&mut scene, v(0.1, 0.0, 1.2), 0.9, 0.4, 1.0);
    meet_exact(&scene, &three_points(), &RIGID, 20_000, 0.02);
    // One edge, and one corner by itself.
    let others = [
        "lamp.positions[0,2] + lamp.positions[1,2]",
        "lamp.positions[0,0] + lamp.positions[1,0]",
        "lamp.positions[2,1]",
    ];
    meet_exact(&scene, &three_points(), &others, 20_000, 0.02);
}

/// With so many edges that they are boundaries of the field: no emitter-edge term. Below the
/// middle of a true disk E = π L r² / (r² + h²).
#[test]
fn a_disk_emitter() {
    let (radius, height) = (0.5, 1.1);
    let down = Affine::rotate(v(1.0, 0.0, 0.0), PI);
    let size = Affine::scale(Vec3::splat(radius));
    let mut scene = nothing();
    let (mesh, normals) = disk(Affine::translate(v(0.0, 0.0, height)) * down * size);
    add(&mut scene, "lamp", mesh, normals, 0.0);
    light_up(&mut scene, 1.0);
    let below = (Vec3::zero(), v(0.0, 0.0, 1.0));

    // The polygon is near the disk.
    let squared = radius * radius + height * height;
    let e = PI * radius * radius / squared;
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-3 * b.abs(), "{a} {b}");
    near(exact(&scene, below), e);
    let along =
        |name: &str| difference_of(&scene, &tangent(&scene, name), |scene| exact(scene, below));
    near(along("lamp.scale"), 2.0 * e * height * height / squared);
    near(along("lamp.translate.z"), -2.0 * e * height / squared);

    let points = [below, three_points()[1]];
    meet_exact(&scene, &points, &RIGID, 20_000, 0.03);
}

fn add_emitter_behind_triangle(scene: &mut Scene) {
    add_emitter(scene, v(0.1, 0.0, 1.2), 0.9, 0.4, 1.0);
    let triangle = Mesh {
        positions: vec![
            v(-0.05, -0.1, 0.6),
            v(0.15, -0.05, 0.55),
            v(0.05, 0.12, 0.65),
        ],
        faces: vec![[0, 1, 2]],
    };
    add(scene, "thing", triangle, ShadingNormals::Face, 0.5);
}

/// A triangle before the emitter: within its silhouette as seen from the first point,
/// across an edge of it from the second, beside it from the third.
#[test]
fn a_triangle_before_an_emitter() {
    let mut scene = nothing();
    add_emitter_behind_triangle(&mut scene);
    let points = [
        (v(0.0, 0.05, 0.0), v(0.0, 0.0, 1.0)),
        (v(0.35, -0.1, 0.1), v(-0.2, 0.1, 1.0).normalized()),
        (v(-1.0, 0.2, 0.0), v(0.3, 0.0, 1.0).normalized()),
    ];
    let hides = |lit: Lit| {
        let mut bare = scene.clone();
        bare.shapes.retain(|shape| shape.id != "thing");
        1.0 - exact(&scene, lit) / exact(&bare, lit)
    };
    let [within, across, beside] = points.map(hides);
    assert!(within > 0.05 && across > 0.02 && beside == 0.0);
    let motions = [
        "thing.translate.x",
        "thing.translate.y - 0.5*thing.translate.z",
        "thing.rotate.x + thing.rotate.z",
        "thing.scale",
        "thing.positions[0,0]",
        "lamp.translate.x",
        "thing.translate.x + lamp.rotate.z - lamp.translate.z",
    ];
    meet_exact(&scene, &points, &motions, 40_000, 0.04);
}

/// The same in an image, so narrow that its four pixels see one point of a floor,
/// forward and reverse.
#[test]
fn a_point_in_an_image() {
    let point = v(0.35, -0.1, 0.0);
    let mut scene = empty(v(-3.0, -4.0, 1.0), point, 0.05, 2);
    add_emitter_behind_triangle(&mut scene);
    add_floor(&mut scene, 3.0);
    scene.check().expect("a valid scene");
    let at = |scene: &Scene, point: Vec3| 0.7 / PI * exact(scene, (point, v(0.0, 0.0, 1.0)));
    let settings = settings(20_000);
    let adjoint = Image {
        width: 2,
        height: 2,
        pixels: vec![Rgb::new(0.25, 0.0, 0.0); 4],
    };
    let wanted = Wanted::all(&scene);
    let reverse = backward(
        &PreparedScene::new(scene.clone()),
        &adjoint,
        &wanted,
        &settings,
        &Unwatched,
    )
    .expect("covered");
    // Where the ray of the image meets the floor moves with the camera and the
    // floor.
    let ray = point - scene.sensor.origin();
    for (name, slides) in [
        ("thing.translate.x", Vec3::zero()),
        ("thing.rotate.x + thing.rotate.z", Vec3::zero()),
        ("thing.scale - lamp.scale", Vec3::zero()),
        ("lamp.translate.x - lamp.rotate.y", Vec3::zero()),
        ("lamp.translate.z", Vec3::zero()),
        ("floor.translate.z", ray / ray.z),
        ("sensor.translate.x", v(1.0, 0.0, 0.0)),
        ("0.2*sensor.rotate.z", v(0.0, 0.0, 0.2).cross(ray)),
    ] {
        let tangent = tangent(&scene, name);
        let [above, below] = [1e-4, -1e-4].map(|step| {
            let point = point + slides * step;
            at(&scene.moved(&tangent, step), point)
        });
        let exact = (above - below) / 2e-4;
        let forward = gradient(
            &PreparedScene::new(scene.clone()),
            &tangent,
            &settings,
            &Unwatched,
        )
        .expect("covered");
        let (mean, error) = means(&forward.value)[0];
        equals("image", mean, error, at(&scene, point), 0.01);
        let (mean, error) = means(&forward.gradient)[0];
        equals(&format!("forward, {name}"), mean, error, exact, 0.02);
        let (mean, error) = reverse.along(&tangent);
        equals(&format!("reverse, {name}"), mean, error, exact, 0.02);
    }
}

/// The form factor of two parallel rectangles whose sides are parallel: x from
/// `a` to `b` and y from `c` to `d` in one plane, `e` to `f` and `g` to `h` in the
/// other, `z` above it (Howell's catalogue, C-13; Ehlert and Smith 1993).
fn parallel_rectangles([a, b, c, d]: [f64; 4], [e, f, g, h]: [f64; 4], z: f64) -> f64 {
    let term = |x: f64, y: f64| {
        let (p, q) = (x.hypot(z), y.hypot(z));
        let logarithm = (x * x + y * y + z * z).ln();
        y * p * (y / p).atan() + x * q * (x / q).atan() - 0.5 * z * z * logarithm
    };
    let mut sum = 0.0;
    for (sign_x, x) in [(1.0, a - f), (1.0, b - e), (-1.0, a - e), (-1.0, b - f)] {
        for (sign_y, y) in [(1.0, c - h), (1.0, d - g), (-1.0, c - g), (-1.0, d - h)] {
            sum += sign_x * sign_y * term(x, y);
        }
    }
    sum / (2.0 * PI * (b - a) * (d - c))
}

/// Mean irradiance on a unit square from one above it is π times their form
/// factor, and changes with it when the emitter rises or moves aside.
#[test]
fn form_factors_of_parallel_squares() {
    // Howell's C-11 at distance 1, a number that is often printed.
    let unit = [0.0, 1.0, 0.0, 1.0];
    assert!((parallel_rectangles(unit, unit, 1.0) - 0.199_824_9).abs() < 1e-7);

    let (height, aside) = (0.9, [0.25, -0.1]);
    let factor = |dx: f64, dy: f64, dz: f64| {
        let [x, y] = [aside[0] + dx, aside[1] + dy];
        PI * parallel_rectangles(unit, [x, x + 1.0, y, y + 1.0], height + dz)
    };
    let mut scene = nothing();
    let down = Affine::rotate(v(1.0, 0.0, 0.0), PI);
    let centre = v(0.5 + aside[0], 0.5 + aside[1], height);
    let half = Affine::scale(v(0.5, 0.5, 1.0));
    let (mesh, normals) = rectangle(Affine::translate(centre) * down * half);
    add(&mut scene, "lamp", mesh, normals, 0.0);
    light_up(&mut scene, 1.0);

    let nodes = gauss_legendre(6);
    let mut points = Vec::new();
    let mut weights = Vec::new();
    for (x, weight_x) in &nodes {
        for (y, weight_y) in &nodes {
            points.push((v(*x, *y, 0.0), v(0.0, 0.0, 1.0)));
            weights.push(weight_x * weight_y);
        }
    }
    // The rule is exact enough.
    let pairs = weights.iter().zip(&points);
    let sum: f64 = pairs
        .map(|(weight, &lit)| weight * exact(&scene, lit))
        .sum();
    assert!((sum - factor(0.0, 0.0, 0.0)).abs() < 1e-6);

    const STEP: f64 = 1e-4;
    for (axis, [dx, dy, dz]) in [
        ("x", [STEP, 0.0, 0.0]),
        ("y", [0.0, STEP, 0.0]),
        ("z", [0.0, 0.0, STEP]),
    ] {
        let tangent = tangent(&scene, &format!("lamp.translate.{axis}"));
        let walk = WalkSettings::default();
        let results = irradiance(&scene, &tangent, &points, walk, 4_000, 3).expect("covered");
        let (mut value, mut change, mut errors) = (0.0, 0.0, [0.0, 0.0]);
        for (result, weight) in results.iter().zip(&weights) {
            value += weight * result.value.mean;
            change += weight * result.gradient.mean;
            errors[0] += (weight * result.value.standard_error()).powi(2);
            errors[1] += (weight * result.gradient.standard_error()).powi(2);
        }
        let [error, change_error] = errors.map(f64::sqrt);
        equals("form factor", value, error, factor(0.0, 0.0, 0.0), 2e-3);
        let derivative = (factor(dx, dy, dz) - factor(-dx, -dy, -dz)) / (2.0 * STEP);
        equals(
            &format!("form factor, {axis}"),
            change,
            change_error,
            derivative,
            8e-3,
        );
    }
}
