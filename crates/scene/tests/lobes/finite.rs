//! No value and no derivative is infinite or NaN, in the corners of everything.

use capwalk_math::{Dual, Vec3};
use capwalk_scene::lobe::*;

use crate::table;
use crate::tools::{Random, direction};

/// Corners: along the normal, along the surface, next to both, opposite to
/// each other; and directions between.
fn directions() -> Vec<Vec3> {
    let mut random = Random::new(8);
    let mut directions = vec![
        Vec3::new(0.0, 0.0, 1.0),
        Vec3::new(0.0, 0.0, -1.0),
        Vec3::new(1.0, 0.0, 0.0),
        Vec3::new(-1.0, 0.0, 0.0),
        Vec3::new(0.6, -0.8, -0.0),
        Vec3::new(-0.6, 0.8, 1e-16),
        Vec3::new(0.6, -0.8, -1e-16),
        Vec3::new(1e-9, 0.0, 1.0),
        direction(1e-6, 1.0),
    ];
    directions.extend((0..12).map(|_| direction(2.0 * random.next() - 1.0, 7.0 * random.next())));
    directions
}

fn lobes() -> Vec<(&'static str, Lobe)> {
    let mut lobes = table::smooth();
    lobes.extend(table::sharp());
    lobes.push((
        "principled of ones",
        Lobe::Principled(table::PLAIN).map(&mut |_| 1.0),
    ));
    lobes.push(("principled of zeros", {
        let black = Lobe::Principled(table::PLAIN).map(&mut |_| 0.0);
        let Lobe::Principled(black) = black else {
            unreachable!("was one")
        };
        Lobe::Principled(Principled { eta: 1.5, ..black })
    }));
    lobes
}

#[test]
fn eval_and_pdf_are_finite() {
    for (name, lobe) in lobes() {
        let bsdf = LocalBsdf::from(lobe.clone());
        let moving = lobe.map(&mut |x| Dual::new(x, [1.0]));
        for wi in directions() {
            for wo in directions() {
                let found = moving.eval(
                    wi.with_tangent(Vec3::new(0.3, 0.2, 0.4)),
                    wo.with_tangent(Vec3::new(-0.2, 0.5, 0.1)),
                );
                let pdf = bsdf.pdf(wi, wo);
                let all = found.value().is_finite() && found.tangent(0).is_finite();
                assert!(
                    all && pdf.is_finite(),
                    "{name}, {wi:?}, {wo:?}: {found:?}, pdf {pdf}"
                );
                assert!(
                    found
                        .value()
                        .to_array()
                        .iter()
                        .all(|&channel| channel >= 0.0),
                    "{name}: {found:?}"
                );
                assert!(pdf >= 0.0, "{name}: {pdf}");
            }
        }
    }
}

/// Alone, from behind, without weight, and beside another one.
#[test]
fn eval_and_pdf_are_the_same_together() {
    for (name, lobe) in lobes() {
        let bsdf = LocalBsdf::from(lobe.clone());
        let mut without_weight = LocalBsdf::default();
        without_weight.push(0.0, lobe.clone());
        let mut beside = LocalBsdf::from(lobe);
        beside.push(0.3, table::smooth()[0].1.clone());
        let explored = without_weight.clone().explored();
        let behind = bsdf.clone().seen_from(Side::Back);
        for bsdf in [bsdf, without_weight, beside, explored, behind] {
            for wi in directions() {
                for wo in directions() {
                    let apart = (bsdf.eval(wi, wo), bsdf.pdf(wi, wo));
                    assert_eq!(bsdf.eval_and_pdf(wi, wo), apart, "{name}, {wi:?}, {wo:?}");
                }
            }
        }
    }
}

/// What is drawn from and scattered by rough metal and plastic is the same in plain numbers.
#[test]
fn rough_surfaces_are_the_same_in_plain_numbers() {
    let mut random = Random::new(5);
    let (mut known, mut drawn) = (0, 0);
    for (name, lobe) in lobes() {
        let mut bsdf = LocalBsdf::default();
        bsdf.push(0.7, lobe);
        let Some(surface) = bsdf.rough_surface() else {
            continue;
        };
        known += 1;
        for wi in directions() {
            let raised = Vec3::new(wi.x, wi.y, wi.z.abs());
            let visible = branchless::visible_over_cos(&surface.facets, raised);
            let enters = surface.passes(raised.z);
            let base = branchless::base_probability(enters, surface.chances);
            for _ in 0..20 {
                let (choice, u) = (random.next(), random.pair());
                if choice >= base {
                    let expected = bsdf.draw(wi, choice, u).map(|drawn| drawn.wo);
                    let facets = &surface.facets;
                    let view = branchless::stretched(facets, raised);
                    let normal =
                        branchless::stretched_normal(facets.distribution, &view, visible, u);
                    let found = branchless::mirrored_at(facets, &view, normal, raised);
                    let apart = expected.map_or(found.z.max(0.0), |wo| (found - wo).length());
                    assert!(apart < 1e-7, "{name}: {wi:?} {apart:e}");
                    drawn += 1;
                }
            }
            for wo in directions().into_iter().filter(|wo| wo.z > 0.0) {
                let mirrored = branchless::mirrored(&surface.facets, raised, visible, wo);
                let fresnel = branchless::fresnel_dielectric(mirrored.cos, surface.eta2);
                let coat = surface
                    .metal(mirrored.cos)
                    .unwrap_or(surface.specular * fresnel);
                let passes = enters * surface.passes(wo.z) * wo.z;
                let f = coat * mirrored.scattered + surface.base * passes;
                let pdf = base * cosine_pdf(wo) + (1.0 - base) * mirrored.pdf;
                let (expected, expected_pdf) = bsdf.eval_and_pdf(wi, wo);
                let error = (f - expected).to_array().map(f64::abs);
                // Of exponential functions below some size one counts as zero.
                let most = |size: f64| 1e-11 * size + 1e-250;
                let is_close = error
                    .iter()
                    .all(|error| *error <= most(expected.max_component()))
                    && (pdf - expected_pdf).abs() <= most(expected_pdf);
                assert!(is_close, "{name}: {wi:?} {wo:?}");
            }
        }
    }
    assert!(
        known >= 4 && drawn > 1000,
        "{known} rough surfaces, {drawn} directions prove little"
    );
}

#[test]
fn samples_are_finite() {
    const ALMOST_ONE: f64 = 1.0 - f64::EPSILON / 2.0;
    let numbers = [0.0, 1e-300, 0.25, 0.5, 0.75, ALMOST_ONE];
    let specular = table::specular()
        .into_iter()
        .map(|(name, lobe, _)| (name, lobe));
    for (name, lobe) in lobes().into_iter().chain(specular) {
        let bsdf = LocalBsdf::from(lobe.clone());
        let moving = LocalBsdf::from(lobe.map(&mut |x| Dual::new(x, [1.0])));
        for wi in directions() {
            for choice in numbers {
                for u in numbers.into_iter().flat_map(|u| numbers.map(|v| [u, v])) {
                    let Some(sample) = bsdf.sample(wi, choice, u) else {
                        continue;
                    };
                    let what = format!("{name}, wi = {wi:?}, {choice}, {u:?}: {sample:?}");
                    assert!(sample.pdf > 0.0 && sample.pdf.is_finite(), "{what}");
                    assert!((sample.wo.length() - 1.0).abs() < 1e-9, "{what}");
                    let Some(event) = sample.specular else {
                        continue;
                    };
                    let (wo, throughput) = moving.specular(event, wi.with_tangent(Vec3::zero()));
                    let finite = wo.tangent(0).is_finite() && throughput.tangent(0).is_finite();
                    assert!(finite && throughput.value().is_finite(), "{what}");
                }
            }
        }
    }
}
