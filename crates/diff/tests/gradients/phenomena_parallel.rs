//! Derivatives of what moves before an orthographic sensor, and of such sensors
//! that move: against the exact silhouette of a triangle, and against finite
//! differences.

use crate::common::agree::*;
use crate::common::exact::{equals, means, settings};
use crate::common::materials::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_diff::{PreparedScene, Unwatched, gradient};
use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Rgb};
use capwalk_scene::primitive::rectangle;
use capwalk_scene::*;

/// Every entry of the sensor's matrix.
const ANY_MATRIX: &str = "0.4*sensor.to_world[0,0] - sensor.to_world[0,1] \
    + 0.5*sensor.to_world[2,1] - 0.3*sensor.to_world[1,0] + 0.4*sensor.to_world[2,2] \
    + sensor.to_world[1,2] + sensor.to_world[2,3]";

/// A slanted black triangle under a sky of radiance 1.
fn triangle_under_sky(filter: Filter) -> Scene {
    let mut scene = empty(v(1.2, -4.0, 1.9), v(0.0, 0.0, 1.1), 22.0, 4);
    let mesh = Mesh {
        positions: vec![v(-0.45, -0.7, 1.2), v(0.5, 0.25, 0.8), v(0.05, 0.5, 1.5)],
        faces: vec![[0, 1, 2]],
    };
    add(&mut scene, "thing", mesh, ShadingNormals::Face, 0.0);
    let radiance = scene.add_texture(Texture::colour("sky.radiance", Rgb::splat(1.0)));
    scene.emitters.push(Emitter::Constant {
        id: "sky".into(),
        radiance,
    });
    scene.film.filter = filter;
    with_parallel_rays(scene, 1.2)
}

/// The share of the film's quarters, and first of all of it, where the sky is seen.
fn sky_seen(scene: &Scene) -> [f64; 5] {
    let camera_from_world = scene.sensor.world_from_camera.inverse();
    let camera_from_world = camera_from_world.expect("a sensor");
    // The film is a square from -1 to 1, its first column at the left, which is +x.
    let corners = scene.shapes[0].mesh.positions.iter();
    let triangle: Vec<[f64; 2]> = corners
        .map(|&p| camera_from_world.point(p))
        .map(|p| [-p.x, -p.y])
        .collect();
    let quarters = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
    let [a, b, c, d] = quarters.map(|[x, y]| 1.0 - area(&half(&half(&triangle, 0, x), 1, y)));
    [0.25 * (a + b + c + d), a, b, c, d]
}

/// The part of a polygon on the given side of the line where a coordinate is 0.
fn half(polygon: &[[f64; 2]], axis: usize, side: f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    for (i, &a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        if a[axis] * side >= 0.0 {
            kept.push(a);
        }
        if (a[axis] < 0.0) != (b[axis] < 0.0) {
            let t = a[axis] / (a[axis] - b[axis]);
            kept.push([0, 1].map(|i| a[i] + (b[i] - a[i]) * t));
        }
    }
    kept
}

fn area(polygon: &[[f64; 2]]) -> f64 {
    let twice = polygon.iter().enumerate().map(|(i, a)| {
        let b = polygon[(i + 1) % polygon.len()];
        a[0] * b[1] - a[1] * b[0]
    });
    0.5 * twice.sum::<f64>().abs()
}

/// The silhouette of a triangle, without any light that it could reflect: what moves is
/// its image, and that is an affine map of it.
#[test]
fn triangle_against_its_area() {
    const STEP: f64 = 1e-4;
    for name in [
        "thing.translate.y + 0.5*thing.rotate.z",
        "0.7*thing.to_world[0,0] + thing.to_world[2,1]",
        "sensor.translate.x",
        "0.2*sensor.rotate.x",
        "0.3*sensor.rotate.y - 0.2*sensor.rotate.z",
        "sensor.to_world[0,0] + 0.3*sensor.to_world[1,1]",
        "0.3*sensor.to_world[1,2] - 0.3*sensor.to_world[2,2]",
    ] {
        let scene = triangle_under_sky(Filter::Box);
        scene.check().expect("a valid scene");
        let tangent = tangent(&scene, name);
        let result = gradient(
            &PreparedScene::new(scene.clone()),
            &tangent,
            &settings(10000),
            &Unwatched,
        )
        .expect("covered");
        let [above, below] = [STEP, -STEP].map(|step| sky_seen(&scene.moved(&tangent, step)));
        let [value, derivative] = [&result.value, &result.gradient].map(means);
        for (i, exact) in sky_seen(&scene).into_iter().enumerate() {
            equals(&format!("value {i}"), value[i].0, value[i].1, exact, 0.01);
            let exact = (above[i] - below[i]) / (2.0 * STEP);
            let title = format!("{name}, {i}");
            equals(&title, derivative[i].0, derivative[i].1, exact, 0.02);
        }
    }
}

/// Every edge of the image moves at a velocity of its own: black things under a sky,
/// so that nothing but silhouettes has a derivative.
#[test]
fn sensor_of_any_matrix() {
    let mut scene = triangle_under_sky(Filter::Gaussian { stddev: 0.5 });
    let ball = placed(small_ball(), Affine::translate(v(0.1, 0.6, -0.3)));
    add(&mut scene, "ball", ball, ShadingNormals::Face, 0.0);
    let tangent = tangent(&scene, ANY_MATRIX);
    let case = Case {
        size: 24,
        step: 2e-3,
        gradient_spp: 225,
        reference_spp: 1500,
        min_pixels: 100,
        ..primary()
    };
    agree("any matrix, parallel rays", scene, &tangent, case);
}

/// A dusty pane stands before a cube and its shadow: silhouettes are seen through it.
#[test]
fn cube_behind_a_pane() {
    let mut scene = visible_cube();
    scene.film.filter = Filter::Gaussian { stddev: 0.5 };
    let turn = Affine::rotate(v(1.0, 0.3, 0.0), 1.2);
    let (mesh, normals) = rectangle(Affine::translate(v(0.3, -1.0, 0.7)) * turn);
    add(&mut scene, "pane", mesh, normals, 0.0);
    make(&mut scene, "pane", |n| Bsdf::Mask {
        opacity: n.number("opacity", 0.3),
        nested: n.diffuse("dust", [0.5; 3]),
    });
    scene.settings.integrator = Integrator::Path {
        max_depth: Some(3),
        rr_depth: 5,
        hide_emitters: false,
    };
    // Of what is seen through dust, a sample says less.
    let tangent = tangent(&scene, "thing.translate.x");
    let few = primary();
    let case = Case {
        step: 3e-3,
        gradient_spp: 2 * few.gradient_spp,
        reference_spp: 2 * few.reference_spp,
        ..few
    };
    agree(
        "behind a pane, parallel rays",
        with_parallel_rays(scene, 0.85),
        &tangent,
        case,
    );
}
