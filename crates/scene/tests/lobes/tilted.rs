//! Lobes about normals of their own: what is drawn, continuity, derivatives.

use std::f64::consts::PI;

use capwalk_math::{Dual, Moments, Real, Rgb, Vec3};
use capwalk_scene::bsdf::NormalLimits;
use capwalk_scene::lobe::*;

use crate::table;
use crate::tools::{Random, direction};

const LIMITS: NormalLimits = NormalLimits {
    flip_invalid: true,
    shadowing: true,
};

/// A tilt by about 30 degrees.
const NORMAL: Vec3 = Vec3::new(0.4, -0.35, 0.9);

fn tilted(lobe: &Lobe, limits: NormalLimits) -> LocalBsdf {
    let mut bsdf = LocalBsdf::default();
    bsdf.push_tilted(0.6, lobe.clone(), Some(Tilt::new(NORMAL, limits)));
    bsdf
}

fn uniform(random: &mut Random) -> Vec3 {
    let [u, v] = random.pair();
    direction(2.0 * u - 1.0, 2.0 * PI * v)
}

/// Uniform directions give the same integrals of light, and of the density, as
/// those that are drawn.
#[test]
fn tilted_lobes_draw_by_their_density() {
    const SAMPLES: usize = 30_000;
    const MOST_SIGMA: f64 = 5.0;
    let light = |wo: Vec3| 1.0 + 0.5 * wo.x - 0.3 * wo.y * wo.z;
    let other = Lobe::Diffuse(Diffuse {
        reflectance: Rgb::splat(0.5),
    });
    for (name, lobe) in table::smooth() {
        let limits = NormalLimits {
            shadowing: !name.contains("cloth"),
            ..LIMITS
        };
        let mut bsdf = tilted(&lobe, limits);
        bsdf.push(0.3, other.clone());
        for wi in table::views(&lobe) {
            let mut random = Random::new(7);
            let mut moments = [[Moments::default(); 2]; 2];
            for _ in 0..SAMPLES {
                let wo = uniform(&mut random);
                let value = bsdf.eval(wi, wo).r * light(wo);
                moments[0][0].add(value * 4.0 * PI);
                moments[0][1].add(bsdf.pdf(wi, wo) * 4.0 * PI);
                let drawn = bsdf.sample(wi, random.next(), random.pair());
                let drawn = drawn.filter(|sample| sample.specular.is_none());
                moments[1][0]
                    .add(drawn.map_or(0.0, |s| bsdf.eval(wi, s.wo).r * light(s.wo) / s.pdf));
                moments[1][1].add(f64::from(u8::from(drawn.is_some())));
            }
            let [uniform, drawn] = moments;
            for (what, (a, b)) in uniform.iter().zip(drawn).enumerate() {
                let error = a.standard_error().hypot(b.standard_error());
                assert!(
                    (a.mean - b.mean).abs() < MOST_SIGMA * error + 1e-12,
                    "{name}, {wi:?}, integral {what}: {} {} ± {error}",
                    a.mean,
                    b.mean
                );
            }
        }
    }
}

/// Where the rules of both normals cut light off, nothing is discontinuous,
/// neither where the viewer passes the plane of the tilted normal, nor where the
/// light passes that or the surface.
#[test]
fn cut_off_light_is_continuous() {
    const STEP: f64 = 1e-9;
    let n = NORMAL.normalized();
    for (name, lobe) in table::smooth() {
        if lobe.is_two_sided() {
            continue; // total reflection begins steeply
        }
        let bsdf = tilted(&lobe, LIMITS);
        let up = Vec3::new(0.0, 0.0, 1.0);
        let along = Vec3::new(0.3, 0.9, 0.2);
        for (normal, along, fixed) in [
            (n, along, direction(0.6, 0.5)),
            (n, along, direction(0.9, 3.5)),
            (up, along, direction(0.6, 0.5)),
            (up, -along, direction(0.6, 0.5)),
        ] {
            let in_plane = along.reject_from(normal).normalized();
            let [above, below] = [STEP, -STEP].map(|by| (in_plane + normal * by).normalized());
            if normal == n && in_plane.z > 0.1 {
                let change = bsdf.eval(above, fixed) - bsdf.eval(below, fixed);
                assert!(change.length() < 1e-5, "{name}: {change:?} by the viewer");
            }
            let change = bsdf.eval(fixed, above) - bsdf.eval(fixed, below);
            assert!(change.length() < 1e-5, "{name}: {change:?} by the light");
        }
    }
}

/// Derivatives by the normal and both directions, against central differences,
/// also where the viewer is behind the tilted normal.
#[test]
fn tilts_have_derivatives() {
    const STEP: f64 = 1e-6;
    type D = Dual<9>;
    for (name, lobe) in table::smooth() {
        for wi in [direction(0.8, 2.0), direction(0.15, PI - 0.7)] {
            let wo = direction(0.5, 4.5);
            let numbers: Vec<f64> = [NORMAL, wi, wo].iter().flat_map(|v| v.to_array()).collect();
            let vector = |x: &[f64], i: usize| Vec3::new(x[i], x[i + 1], x[i + 2]);
            let at = |x: &[f64]| {
                let mut bsdf = LocalBsdf::default();
                let tilt = Tilt::new(vector(x, 0), LIMITS);
                bsdf.push_tilted(1.0, lobe.clone(), Some(tilt));
                bsdf.eval(vector(x, 3), vector(x, 6))
            };
            let dual = |i: usize| -> Vec3<D> {
                Vec3::new(
                    D::variable(numbers[i], i),
                    D::variable(numbers[i + 1], i + 1),
                    D::variable(numbers[i + 2], i + 2),
                )
            };
            let mut bsdf = LocalBsdf::<D>::default();
            let tilt = Tilt::new(dual(0), LIMITS);
            bsdf.push_tilted(D::constant(1.0), lobe.map(&mut D::constant), Some(tilt));
            let value = bsdf.eval(dual(3), dual(6));
            assert_eq!(bsdf.value().eval(wi, wo), value.value(), "{name}");
            assert!(value.r.value > 0.0, "{name}: nothing to see");
            for i in 0..numbers.len() {
                let step = |by: f64| {
                    let mut x = numbers.clone();
                    x[i] += by;
                    at(&x)
                };
                let difference = (step(STEP) - step(-STEP)) / (2.0 * STEP);
                let error = (value.tangent(i) - difference).length();
                let allowed = 2e-5 * difference.length() + 1e-5 * value.value().length() + 1e-8;
                assert!(error < allowed, "{name}, number {i}: {error:e}");
            }
        }
    }
}

/// Without turning normals back, what they turn away from is black; a level tilt
/// changes nothing but by its shadows.
#[test]
fn normals_that_turn_away() {
    let lobe = Lobe::Diffuse(Diffuse {
        reflectance: Rgb::splat(0.5),
    });
    let behind = direction(0.2, (-NORMAL.y).atan2(-NORMAL.x));
    assert!(behind.dot(NORMAL) < 0.0);
    let wo = direction(0.9, 1.0);
    assert!(tilted(&lobe, LIMITS).eval(behind, wo).r > 0.05);
    let limits = NormalLimits {
        flip_invalid: false,
        ..LIMITS
    };
    let bsdf = tilted(&lobe, limits);
    assert_eq!(bsdf.eval(behind, wo), Rgb::zero());
    assert_eq!(bsdf.pdf(behind, wo), 0.0);
    assert!(bsdf.sample(behind, 0.5, [0.5, 0.5]).is_none());
    let plain = LocalBsdf::from(lobe);
    let level = plain.eval(behind, wo);
    let mut untilted = LocalBsdf::default();
    let up = Vec3::new(0.0, 0.0, 2.0);
    let Some((_, lobe)) = plain.lobes().next() else {
        panic!("one lobe");
    };
    untilted.push_tilted(1.0, lobe.clone(), Some(Tilt::new(up, LIMITS)));
    assert!((untilted.eval(behind, wo) - level).length() < 1e-15);
    assert_eq!(
        tilted(lobe, LIMITS).levelled().eval(behind, wo),
        level * 0.6
    );
}
