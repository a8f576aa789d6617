//! Variance per sample of both estimators in METHOD's reference set-up, as
//! `cargo bench -p capwalk-diff --bench reference_setup` prints it, for
//! several largest angles, with the time of a sample: estimators are compared
//! by variance times time.

#[path = "../tests/gradients/common/mod.rs"]
mod common;

use std::time::Instant;

use capwalk_diff::{Estimator, WalkSettings};
use capwalk_scene::params;
use common::irradiance::irradiance;

const SAMPLES: u32 = 4_000;

fn main() {
    let scene = common::reference_scene();
    let tangent = params::Registry::new(&scene)
        .tangent(&scene, "ball.translate.x")
        .expect("a known name");
    let points = common::reference_points();
    println!("{SAMPLES} samples at each of {} floor points", points.len());
    println!("estimator   A_max   variance   largest of a point   µs/sample   variance × µs");
    for estimator in [Estimator::Anchored, Estimator::Literal] {
        for max_radius in [0.1, 0.2, 0.6, 1.2] {
            let walk = WalkSettings {
                estimator,
                max_radius,
                ..Default::default()
            };
            let start = Instant::now();
            let results = irradiance(&scene, &tangent, &points, walk, SAMPLES, 1);
            let results = results.expect("the walk is valid");
            let count = f64::from(SAMPLES) * points.len() as f64;
            let time = start.elapsed().as_secs_f64() * 1e6 / count;
            let variances = results.iter().map(|point| point.gradient.variance());
            let largest = variances.clone().fold(0.0, f64::max);
            let mean = variances.sum::<f64>() / points.len() as f64;
            println!(
                "{:<11} {max_radius:<7} {mean:<10.3} {largest:<20.3} {time:<11.2} {:.2}",
                format!("{estimator:?}").to_lowercase(),
                mean * time
            );
        }
    }
}
