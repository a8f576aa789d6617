//! METHOD's reference set-up: floor points under a square emitter, an icosphere
//! of 320 faces between them, moving in x.

use crate::common::irradiance::{Irradiance, difference, irradiance};
use crate::common::{reference_points, reference_scene};
use capwalk_diff::{Estimator, WalkSettings};
use capwalk_math::Moments;
use capwalk_scene::*;

fn mean_variance(results: &[Irradiance]) -> f64 {
    let sum: f64 = results.iter().map(|point| point.gradient.variance()).sum();
    sum / results.len() as f64
}

/// Central differences with common random numbers. The step is small against
/// the ball's faces; its bias is below a thousandth.
fn differences(scene: &Scene, tangent: &Tangent) -> Vec<Moments> {
    let step = 1e-2;
    let sides = [scene.moved(tangent, step), scene.moved(tangent, -step)];
    let mut moments = difference(&sides, &reference_points(), 20_000, 7);
    for point in &mut moments {
        point.mean /= 2.0 * step;
        point.sum_of_squares /= (2.0 * step) * (2.0 * step);
    }
    moments
}

#[test]
fn anchored_is_unbiased_and_has_the_promised_variance() {
    let scene = reference_scene();
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, "ball.translate.x")
        .expect("a known name");
    let walk = WalkSettings {
        max_radius: 0.6,
        ..Default::default()
    };
    let results =
        irradiance(&scene, &tangent, &reference_points(), walk, 2_000, 1).expect("covered");
    let variance = mean_variance(&results);
    println!("anchored: mean variance per sample {variance:.3}");
    assert!(variance < 0.6, "{variance}");

    let reference = differences(&scene, &tangent);
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
    let scene = reference_scene();
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, "ball.translate.x")
        .expect("a known name");
    let walk = WalkSettings {
        estimator: Estimator::Literal,
        max_radius: 0.6,
        ..Default::default()
    };
    let results =
        irradiance(&scene, &tangent, &reference_points(), walk, 2_000, 1).expect("covered");
    let variance = mean_variance(&results);
    println!("literal: mean variance per sample {variance:.3e}");
    assert!(variance > 1e4, "{variance}");
}
