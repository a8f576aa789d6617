//! Gradients against finite differences: what the camera sees first, without
//! light. What is demanded of each case, and how often it raises a false alarm,
//! is said in `phenomena_shadows.rs`; here a pixel without a silhouette has no
//! noise, so fewer of them have some.

use crate::common::agree::*;
use crate::common::stages::*;
use crate::common::*;
use capwalk_math::Vec3;
use capwalk_scene::*;

fn aov_case(aov: Aov, mut scene: Scene, expression: &str) {
    scene.settings.integrator = Integrator::Aov(aov);
    let tangent = tangent(&scene, expression);
    let case = Case {
        size: 48,
        gradient_spp: 128,
        reference_spp: 384,
        min_pixels: 500,
        ..Case::default()
    };
    // Differences with a box filter are smeared where silhouettes pass the borders
    // of pixels: small steps.
    let step = match scene.film.filter {
        Filter::Box => 1e-3,
        _ => 3e-3,
    };
    agree(aov.name(), scene, &tangent, Case { step, ..case });
}

fn close_ball() -> Scene {
    let mut scene = visible_ball(Filter::Tent { radius: 1.0 });
    *fov_x(&mut scene) *= 0.6;
    scene
}

#[test]
fn position() {
    let mut scene = visible_cube();
    scene.film.filter = Filter::Tent { radius: 1.0 };
    aov_case(Aov::Position, scene, "thing.translate.x + thing.rotate.z");
}

#[test]
fn texture_coordinates() {
    aov_case(
        Aov::Uv,
        visible_cube(),
        "thing.translate.x + thing.rotate.x",
    );
}

#[test]
fn face_normals() {
    aov_case(
        Aov::GeometricNormal,
        visible_cube(),
        "thing.rotate.x + thing.translate.z",
    );
}

/// Smooth normals that turn with the motion of the vertices.
#[test]
fn shading_normals() {
    let mut scene = close_ball();
    scene.settings.integrator = Integrator::Aov(Aov::ShadingNormal);
    aov_case(Aov::ShadingNormal, scene, "ball.scale + ball.translate.y");
}

#[test]
fn albedo() {
    aov_case(
        Aov::Albedo,
        visible_cube(),
        "thing.translate.x + sensor.rotate.y",
    );
}

/// The area of a mask grows as the area of the disk that is seen: a closed form
/// beside the differences. A ball of radius r at distance d from a camera covers
/// on the film plane at distance 1 a disk of radius r / √(d² - r²).
#[test]
fn area_of_a_disk() {
    let mut scene = empty(v(0.0, -4.0, 0.0), v(0.0, 0.0, 0.0), 30.0, 32);
    let (mesh, normals) = primitive::sphere(capwalk_math::Affine::IDENTITY, Vec3::zero(), 0.5);
    add(&mut scene, "ball", mesh, normals, 0.5);
    scene.settings.integrator = Integrator::Aov(Aov::Mask);
    let (r, d) = (0.5_f64, 4.0_f64);
    let focal = 16.0 / 15f64.to_radians().tan(); // pixels
    let squared = d * d - r * r;
    // d/ds of π focal² r² / (d² - r²), r = 0.5 s
    let expected = std::f64::consts::PI * focal * focal * 2.0 * r * r * d * d / (squared * squared);
    let settings = capwalk_diff::GradientOptions {
        method: capwalk_diff::Method::Walk,
        ..capwalk_diff::GradientOptions::new(capwalk_diff::RenderOptions::new(256, 2))
    };
    let tangent = tangent(&scene, "ball.scale");
    let nobody = &capwalk_diff::Unwatched;
    let result = capwalk_diff::gradient(
        &capwalk_diff::PreparedScene::new(scene.clone()),
        &tangent,
        &settings,
        nobody,
    )
    .expect("covered");
    let sum: f64 = result.gradient.mean.pixels.iter().map(|p| p.r).sum();
    let errors = result.gradient.standard_error.pixels.iter();
    let error = errors.map(|p| p.r * p.r).sum::<f64>().sqrt();
    println!("area: {sum:.3} ± {error:.3}, expected {expected:.3}");
    // 4.5 standard errors; the mesh is within 1e-4 of the sphere.
    assert!((sum - expected).abs() < 4.5 * error + 1e-3 * expected);
    assert!(error < 0.02 * expected, "{error}");
}
