//! `eval` and `specular` over duals against central differences, in every
//! number and every direction.

use capwalk_math::{Dual, Real, Rgb, Vec3};
use capwalk_scene::lobe::*;

use crate::table;
use crate::tools::{direction, sphere_integral};

/// Lobes have at most this many numbers, and two directions three each.
const MOST: usize = 32;
type D = Dual<MOST>;

/// The lobe and the directions with the `variable`-th of all numbers moved by
/// `by`. Directions come last.
fn moved(lobe: &Lobe, w: [Vec3; 2], variable: usize, by: f64) -> (Lobe, [Vec3; 2], usize) {
    let mut place = 0;
    let mut step = |x: f64| {
        place += 1;
        if place - 1 == variable { x + by } else { x }
    };
    let lobe = lobe.map(&mut step);
    let w = w.map(|w| Vec3::from(w.to_array().map(&mut step)));
    (lobe, w, place)
}

/// All numbers as independent variables.
fn variables(lobe: &Lobe, w: [Vec3; 2]) -> (Lobe<D>, [Vec3<D>; 2]) {
    let mut place = 0;
    let mut variable = |x: f64| {
        place += 1;
        D::variable(x, place - 1)
    };
    let lobe = lobe.map(&mut variable);
    let w = w.map(|w| {
        let [x, y, z] = w.to_array().map(&mut variable);
        Vec3::new(x, y, z)
    });
    (lobe, w)
}

/// Compares the derivatives of the numbers that `at` computes.
fn compare(
    what: &str,
    lobe: &Lobe,
    w: [Vec3; 2],
    dual: &[D],
    at: impl Fn(&Lobe, [Vec3; 2]) -> Vec<f64>,
) {
    const STEP: f64 = 1e-6;
    let (_, _, count) = moved(lobe, w, 0, 0.0);
    let values = at(lobe, w);
    for (value, dual) in values.iter().zip(dual) {
        assert!(
            (value - dual.value).abs() <= 1e-12 * value.abs(),
            "{what}: {value} {dual:?}"
        );
    }
    for variable in 0..count {
        let step = |by: f64| {
            let (lobe, w, _) = moved(lobe, w, variable, by);
            at(&lobe, w)
        };
        for (place, (above, below)) in step(STEP).iter().zip(step(-STEP)).enumerate() {
            let difference = (above - below) / (2.0 * STEP);
            let tangent = dual[place].tangent[variable];
            // Third derivatives of sharp lobes, and rounding.
            let allowed = 2e-5 * difference.abs() + 1e-5 * values[place].abs() + 1e-8;
            assert!(
                (tangent - difference).abs() < allowed,
                "{what}, {w:?}: number {place} by variable {variable}: {tangent} {difference}"
            );
        }
    }
}

#[test]
fn eval_has_right_derivatives() {
    let mut count = 0;
    for (name, lobe) in table::smooth().into_iter().chain(table::sharp()) {
        let bsdf = LocalBsdf::from(lobe.clone());
        for wi in table::views(&lobe) {
            let mut others = vec![
                direction(0.7, 2.0),
                direction(0.1, 4.0),
                direction(-0.6, 1.0),
            ];
            for choice in [0.01, 0.6, 0.99] {
                let drawn = bsdf.sample(wi, choice, [0.3, 0.6]);
                others.extend(drawn.filter(|s| s.specular.is_none()).map(|s| s.wo));
            }
            for wo in others {
                let w = [wi, wo];
                let (dual_lobe, [dual_wi, dual_wo]) = variables(&lobe, w);
                let dual = dual_lobe.eval(dual_wi, dual_wo).to_array();
                compare(name, &lobe, w, &dual, |lobe, [wi, wo]| {
                    lobe.eval(wi, wo).to_array().to_vec()
                });
                count += usize::from(dual[0].value > 0.0);
            }
        }
    }
    assert!(count > 200, "only {count} pairs of directions scatter");
}

#[test]
fn specular_has_right_derivatives() {
    for (name, lobe, events) in table::specular() {
        for wi in table::views(&lobe) {
            for &event in &events {
                let event = Specular { lobe: 0, event };
                let w = [wi, wi];
                let (dual_lobe, [dual_wi, _]) = variables(&lobe, w);
                let both =
                    |(wo, throughput): (Vec3, Rgb)| [wo.to_array(), throughput.to_array()].concat();
                let (wo, throughput) = dual_lobe.specular(event, dual_wi);
                let dual = [wo.to_array(), throughput.to_array()].concat();
                compare(name, &lobe, w, &dual, |lobe, [wi, _]| {
                    both(lobe.specular(event, wi))
                });
            }
        }
    }
}

/// A blend has the derivatives of its weights; with constant weights it is itself.
#[test]
fn weights_have_derivatives() {
    let (wi, wo) = (direction(0.6, 1.0), direction(0.8, 3.0));
    let mut bsdf = LocalBsdf::<Dual<1>>::default();
    let mut primal = LocalBsdf::default();
    for (place, (_, lobe)) in table::smooth().into_iter().take(2).enumerate() {
        let weight = [0.3, 0.7][place];
        bsdf.push(
            Dual::new(weight, [[1.0, -1.0][place]]),
            lobe.map(&mut Dual::constant),
        );
        primal.push(weight, lobe);
    }
    assert_eq!(bsdf.value(), primal);
    let value = bsdf.eval(wi.map(Dual::constant), wo.map(Dual::constant));
    let lobes: Vec<&Lobe> = primal.lobes().map(|(_, lobe)| lobe).collect();
    let difference = lobes[0].eval(wi, wo) - lobes[1].eval(wi, wo);
    assert!((value.tangent(0) - difference).length() < 1e-14);
    assert!((value.value() - primal.eval(wi, wo)).length() < 1e-14);
}

/// A lobe of weight zero is drawn if it is to be explored, and only then; the
/// density is that of what is drawn.
#[test]
fn lobes_of_weight_zero_are_explored() {
    let black = Diffuse {
        reflectance: Rgb::splat(0.0),
    };
    for explores in [false, true] {
        let mut bsdf = LocalBsdf::default();
        bsdf.push(1.0, Lobe::Diffuse(black));
        bsdf.push(0.0, Lobe::Null(Null::default()));
        let bsdf = if explores { bsdf.explored() } else { bsdf };
        let wi = direction(0.6, 1.0);
        let places = (0..1000).map(|i| f64::from(i) / 1000.0);
        let drawn = places.filter_map(|u| bsdf.sample(wi, u, [0.3, 0.6]));
        let passing: Vec<_> = drawn.filter(|drawn| drawn.specular.is_some()).collect();
        assert_eq!(passing.is_empty(), !explores);
        let share = passing.len() as f64 / 1000.0;
        assert!(passing.iter().all(|drawn| (drawn.pdf - share).abs() < 2e-3));
    }
}

/// Nothing is discontinuous: the derivative of all that is reflected or transmitted is the
/// integral of derivatives. A discontinuity along a curve that moves would be missing.
/// Seen from the thinner side; from the denser one the derivative is unbounded
/// where total reflection begins, which these sums do not resolve.
#[test]
fn integrals_of_derivatives_are_derivatives_of_integrals() {
    for (name, lobe) in table::smooth() {
        if name.contains("thinner inside") {
            continue;
        }
        let dual_lobe = lobe.map(&mut Dual::<1>::constant);
        for angle in [0.3, 1.1] {
            let total = |angle: f64| {
                let (sin, cos) = Dual::<1>::variable(angle, 0).sin_cos();
                let wi = Vec3::new(sin, Dual::constant(0.0), cos);
                sphere_integral(40, |wo| {
                    let value = dual_lobe.eval(wi, wo.map(Dual::constant)).r;
                    [value.value, value.tangent[0]].map(|x| x * (1.0 + wo.x))
                })
            };
            const STEP: f64 = 1e-3;
            let difference = (total(angle + STEP)[0] - total(angle - STEP)[0]) / (2.0 * STEP);
            let [value, tangent] = total(angle);
            let error = (tangent - difference).abs();
            assert!(
                error < 2e-3 * (value + tangent.abs()),
                "{name}, angle {angle}: {tangent} {difference}, value {value}"
            );
        }
    }
}
