//! Estimates by sampling have the mean that they should have.

use capwalk_math::{Moments, Rgb, Vec3};
use capwalk_scene::lobe::*;

use crate::table;
use crate::tools::{Random, sphere_integral};

/// A standard error is trusted to this many of it: six in 1e10 by accident,
/// for some hundred comparisons.
const MOST_SIGMA: f64 = 6.0;

/// The integral of `eval` times a function that tells directions apart.
#[test]
fn mean_of_eval_over_pdf_is_the_integral_of_eval() {
    let light = |wo: Vec3| 1.0 + 0.5 * wo.x - 0.3 * wo.y * wo.z;
    for (name, lobe) in table::smooth() {
        let bsdf = LocalBsdf::from(lobe.clone());
        for wi in table::views(&lobe) {
            let integral = sphere_integral(24, |wo| {
                let value = bsdf.eval(wi, wo) * light(wo);
                value.to_array()
            });
            let mut random = Random::new(5);
            let mut moments = [Moments::default(); 3];
            for _ in 0..20_000 {
                let drawn = bsdf.sample(wi, random.next(), random.pair());
                let estimate = match drawn.filter(|sample| sample.specular.is_none()) {
                    Some(sample) => bsdf.eval(wi, sample.wo) * (light(sample.wo) / sample.pdf),
                    None => Rgb::zero(),
                };
                for (moments, x) in moments.iter_mut().zip(estimate.to_array()) {
                    moments.add(x);
                }
            }
            for (moments, integral) in moments.iter().zip(integral) {
                let error = (moments.mean - integral).abs();
                // The quadrature is this good.
                let allowed = MOST_SIGMA * moments.standard_error() + 1e-4 * integral;
                assert!(
                    error < allowed,
                    "{name}, wi = {wi:?}: {} {integral}",
                    moments.mean
                );
            }
        }
    }
}

/// Specular events come as often as they say.
#[test]
fn specular_events_have_their_probability() {
    for (name, lobe, events) in table::specular() {
        let mut bsdf = LocalBsdf::default();
        bsdf.push(0.3, Lobe::Null(Null::default()));
        bsdf.push(0.6, lobe.clone());
        for wi in table::views(&lobe) {
            let mut random = Random::new(9);
            let mut counts = vec![0.0; events.len()];
            let mut probabilities = vec![0.0; events.len()];
            const SAMPLES: f64 = 20_000.0;
            for _ in 0..SAMPLES as usize {
                let sample = bsdf
                    .sample(wi, random.next(), random.pair())
                    .filter(|sample| sample.specular.is_some_and(|event| event.lobe == 1));
                let Some(sample) = sample else { continue };
                let specular = sample.specular.expect("was filtered");
                let place = events.iter().position(|event| *event == specular.event);
                let Some(place) = place else { continue };
                counts[place] += 1.0;
                probabilities[place] = sample.pdf;
                assert_eq!(sample.wo, bsdf.specular(specular, wi).0);
            }
            for (count, p) in counts.iter().zip(&probabilities) {
                let spread = (SAMPLES * p * (1.0 - p)).sqrt();
                assert!(
                    (count - SAMPLES * p).abs() <= MOST_SIGMA * spread,
                    "{name}, wi = {wi:?}: {count} of {SAMPLES}, probability {p}"
                );
            }
        }
    }
}
