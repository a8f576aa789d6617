//! A sampling map is right if and only if its area element is 1/pdf.

use capwalk_math::Vec3;
use capwalk_scene::lobe::*;

use crate::table;

/// Area element of `u -> wo`, by central differences; `None` where a step
/// leaves the square or draws something else.
fn area_element(lobe: &LocalBsdf, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<f64> {
    const STEP: f64 = 1e-6; // error of the order of its square
    let at = |du: f64, dv: f64| {
        let sample = lobe.sample(wi, choice, [u[0] + du, u[1] + dv])?;
        sample.specular.is_none().then_some(sample.wo)
    };
    let along_u = (at(STEP, 0.0)? - at(-STEP, 0.0)?) / (2.0 * STEP);
    let along_v = (at(0.0, STEP)? - at(0.0, -STEP)?) / (2.0 * STEP);
    Some(along_u.cross(along_v).length())
}

/// The probability that a lobe, having drawn the normal between `wi` and `wo`,
/// draws `wo`.
fn branch_probability(lobe: &Lobe, wi: Vec3, wo: Vec3) -> f64 {
    let Lobe::RoughDielectric(lobe) = lobe else {
        return 1.0;
    };
    let reflects = wi.z * wo.z > 0.0;
    let eta = if wi.z > 0.0 { lobe.eta } else { 1.0 / lobe.eta };
    let h = (wi + wo * if reflects { 1.0 } else { eta }).normalized();
    let reflectance = fresnel_dielectric(wi.dot(h).abs(), eta);
    if reflects {
        reflectance
    } else {
        1.0 - reflectance
    }
}

/// Plastics and principled materials draw from several maps at once: the
/// chi-squared test is for them.
#[test]
fn area_element_of_sample_is_one_over_pdf() {
    let mut count = 0;
    for (name, lobe) in table::smooth().into_iter().chain(table::sharp()) {
        if !matches!(
            lobe,
            Lobe::Diffuse(_) | Lobe::RoughConductor(_) | Lobe::RoughDielectric(_)
        ) {
            continue;
        }
        let bsdf = LocalBsdf::from(lobe.clone());
        for wi in table::views(&lobe) {
            for u in [[0.3, 0.7], [0.02, 0.2], [0.85, 0.9], [0.5, 0.4]] {
                for choice in [0.001, 0.999] {
                    let Some(sample) = bsdf.sample(wi, choice, u) else {
                        continue;
                    };
                    let Some(area) = area_element(&bsdf, wi, choice, u) else {
                        continue;
                    };
                    let branch = branch_probability(&lobe, wi, sample.wo);
                    let error = (area * sample.pdf / branch - 1.0).abs();
                    assert!(error < 1e-5, "{name}, wi = {wi:?}, u = {u:?}: {error:e}");
                    count += 1;
                }
            }
        }
    }
    assert!(count > 250, "only {count} places were tested");
}
