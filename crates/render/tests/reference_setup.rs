//! METHOD's reference set-up: floor points under a square lamp, an icosphere
//! of 320 faces between them, moving in x.

mod common;

use capwalk_math::{Moments, Vec3};
use capwalk_render::diff::probe::{Irradiance, difference, irradiance};
use capwalk_render::{Estimator, WalkSettings};
use capwalk_scene::primitive::icosphere;
use capwalk_scene::*;
use common::{add, add_lamp, empty, v};

fn scene() -> Scene {
    let mut scene = empty(v(0.0, -5.0, 1.0), v(0.0, 0.0, 1.0), 40.0, 4);
    add_lamp(&mut scene, v(0.0, 0.0, 2.0), 1.0, 0.0, 1.0);
    let mut ball = icosphere(4);
    assert_eq!(ball.faces.len(), 320);
    ball.positions
        .iter_mut()
        .for_each(|p| *p = *p * 0.35 + v(0.0, 0.0, 1.0));
    add(&mut scene, "ball", ball, ShadingNormals::Face, 0.5);
    scene.check().expect("a valid scene");
    scene
}

/// Cell centres of a 12 × 12 grid over [-1.2, 1.2]².
fn points() -> Vec<(Vec3, Vec3)> {
    let centre = |i: i32| (f64::from(i) + 0.5) * 0.2 - 1.2;
    (0..144)
        .map(|i| (v(centre(i % 12), centre(i / 12), 0.0), v(0.0, 0.0, 1.0)))
        .collect()
}

fn mean_variance(results: &[Irradiance]) -> f64 {
    let sum: f64 = results.iter().map(|point| point.gradient.variance()).sum();
    sum / results.len() as f64
}

/// Central differences with common random numbers. The step is small against
/// the ball's faces; its bias is below a thousandth.
fn differences(scene: &Scene, motion: &Motion) -> Vec<Moments> {
    let step = 1e-2;
    let sides = [scene.moved(motion, step), scene.moved(motion, -step)];
    let mut moments = difference(&sides, &points(), 20_000, 7);
    for point in &mut moments {
        point.mean /= 2.0 * step;
        point.sum_of_squares /= (2.0 * step) * (2.0 * step);
    }
    moments
}

#[test]
fn anchored_is_unbiased_and_has_the_promised_variance() {
    let scene = scene();
    let motion = params::motion(&scene, "ball.translate.x").expect("a known name");
    let walk = WalkSettings {
        max_radius: 0.6,
        ..Default::default()
    };
    let results = irradiance(&scene, &motion, &points(), walk, 2_000, 1).expect("covered");
    let variance = mean_variance(&results);
    println!("anchored: mean variance per sample {variance:.3}");
    assert!(variance < 0.6, "{variance}");

    let reference = differences(&scene, &motion);
    let chi: f64 = results
        .iter()
        .zip(&reference)
        .map(|(point, reference)| {
            let error = point
                .gradient
                .standard_error()
                .hypot(reference.standard_error());
            let z = (point.gradient.mean - reference.mean) / error.max(1e-12);
            z * z
        })
        .sum::<f64>()
        / 144.0;
    println!("chi²/n {chi:.3}");
    // Chi-squared with 144 degrees of freedom leaves this band once in 10⁴.
    assert!((0.58..1.55).contains(&chi), "{chi}");
}

#[test]
fn literal_has_a_variance_beyond_use() {
    let scene = scene();
    let motion = params::motion(&scene, "ball.translate.x").expect("a known name");
    let walk = WalkSettings {
        estimator: Estimator::Literal,
        max_radius: 0.6,
        ..Default::default()
    };
    let results = irradiance(&scene, &motion, &points(), walk, 2_000, 1).expect("covered");
    let variance = mean_variance(&results);
    println!("literal: mean variance per sample {variance:.3e}");
    assert!(variance > 1e4, "{variance}");
}
