//! Directions fall where the density says.

use std::f64::consts::PI;

use capwalk_math::Vec3;
use capwalk_math::stats::chi_squared_upper_tail;
use capwalk_scene::lobe::*;

use crate::table;
use crate::tools::{Random, integral};

const COSINES: usize = 16;
const AZIMUTHS: usize = 24;

/// A test of 1e-8, some dozens of times: a false alarm in a million changes of
/// the seed.
const FALSE_ALARM: f64 = 1e-8;

#[test]
fn samples_are_distributed_like_their_density() {
    for (name, lobe) in table::smooth() {
        for (place, wi) in table::views(&lobe).into_iter().enumerate() {
            let bsdf = LocalBsdf::from(lobe.clone());
            let seed = 1000 + place as u64;
            // Where the density is discontinuous inside bins, the coarse integrals are not
            // good enough; the fine ones take long.
            let p = p_value(&bsdf, wi, seed, 2);
            let p = if p > FALSE_ALARM {
                p
            } else {
                p_value(&bsdf, wi, seed, 12)
            };
            assert!(p > FALSE_ALARM, "{name}, wi = {wi:?}: p = {p:e}");
        }
    }
}

/// The density of a blend is that of its parts and of the choice.
#[test]
fn blends_are_distributed_like_their_density() {
    let mut bsdf = LocalBsdf::default();
    for (place, (_, lobe)) in table::smooth().into_iter().step_by(3).take(3).enumerate() {
        bsdf.push([0.2, 0.5, 0.1][place], lobe);
    }
    bsdf.push(0.4, Lobe::Null(Null::default()));
    for wi in table::views(&Lobe::Null(Null::default())) {
        let p = p_value(&bsdf, wi, 77, 2);
        assert!(p > FALSE_ALARM, "wi = {wi:?}: p = {p:e}");
    }
}

/// Probability of a histogram as uneven as this. Expected counts are integrals
/// of `pieces` by `pieces` tiles per bin.
fn p_value(bsdf: &LocalBsdf, wi: Vec3, seed: u64, pieces: usize) -> f64 {
    const SAMPLES: usize = 100_000;
    let mut random = Random::new(seed);
    let mut counts = vec![0.0; COSINES * AZIMUTHS + 1];
    for _ in 0..SAMPLES {
        let drawn = bsdf.sample(wi, random.next(), random.pair());
        let bin = match drawn.filter(|sample| sample.specular.is_none()) {
            // What draws nothing, or a specular event, is a bin too.
            None => COSINES * AZIMUTHS,
            Some(BsdfSample { wo, .. }) => {
                let row = ((wo.z + 1.0) * 0.5 * COSINES as f64) as usize;
                let turn = wo.y.atan2(wo.x) / (2.0 * PI);
                let column = ((turn - turn.floor()) * AZIMUTHS as f64) as usize;
                row.min(COSINES - 1) * AZIMUTHS + column.min(AZIMUTHS - 1)
            }
        };
        counts[bin] += 1.0;
    }
    let mut expected = Vec::with_capacity(counts.len());
    for row in 0..COSINES {
        let cosines = [row, row + 1].map(|r| 2.0 * r as f64 / COSINES as f64 - 1.0);
        for column in 0..AZIMUTHS {
            let azimuths = [column, column + 1].map(|c| 2.0 * PI * c as f64 / AZIMUTHS as f64);
            let [mass] = integral(cosines, azimuths, pieces, |wo| [bsdf.pdf(wi, wo)]);
            expected.push(mass * SAMPLES as f64);
        }
    }
    let nothing = SAMPLES as f64 - expected.iter().sum::<f64>();
    assert!(
        nothing > -1e-3 * SAMPLES as f64,
        "the density is {nothing} samples above one"
    );
    expected.push(nothing.max(0.0));
    // Bins of few samples are not normal: together.
    const FEW: f64 = 10.0;
    let (mut statistic, mut freedom) = (0.0, -1.0);
    let (mut few_counts, mut few_expected) = (0.0, 0.0);
    let mut add = |count: f64, expected: f64| {
        if expected >= FEW {
            statistic += (count - expected).powi(2) / expected;
            freedom += 1.0;
        } else {
            assert!(
                count < 60.0,
                "{count} samples where {expected} were expected"
            );
        }
    };
    for (&count, &expected) in counts.iter().zip(&expected) {
        if expected >= FEW {
            add(count, expected);
        } else {
            few_counts += count;
            few_expected += expected;
        }
    }
    add(few_counts, few_expected);
    chi_squared_upper_tail(statistic, freedom)
}
