//! Fixed-step walks on disks (Algorithms 2 to 4, Eqs. 18 to 27): the field's
//! derivative against differences of the field, its divergence against the
//! boundary term.

use std::cell::RefCell;

use capwalk_math::{Moments, Vec2};
use capwalk_paper::walk::plane::{CurvePoint, Plane};
use capwalk_walk::{Domain, Estimator, WalkSettings, sample_field, sample_value};

#[path = "../../../crates/walk/tests/common/mod.rs"]
mod common;
use common::{assert_mean, number};

/// A corner that points inward, sides of different lengths.
fn polygon() -> Vec<Vec2> {
    [
        [-1.0, -0.8],
        [0.9, -1.0],
        [1.1, 0.7],
        [0.1, 0.1],
        [-0.7, 0.9],
    ]
    .map(|[x, y]| Vec2::new(x, y))
    .to_vec()
}

fn domains() -> [(&'static str, Plane); 2] {
    [
        ("polygon", Plane::polygon(&polygon())),
        ("disk", Plane::circle(Vec2::new(0.1, -0.1), 0.8)),
    ]
}

/// Boundary velocities that differ everywhere, discontinuous at some corners.
fn velocity(site: &CurvePoint) -> Vec2 {
    let Vec2 { x, y } = site.point;
    let turn = 0.4 * site.curve as f64;
    Vec2::new((3.0 * x + y).sin() + turn, x * y - turn + 0.5)
}

fn settings(steps: u32, max_radius: f64) -> WalkSettings {
    WalkSettings {
        steps,
        max_radius,
        ..Default::default()
    }
}

/// Mean and standard error of the field along `d`.
fn field_along(domain: &Plane, x: Vec2, d: Vec2, walk: &WalkSettings, set: u64) -> Moments {
    let mut moments = Moments::default();
    for i in 0..60_000 {
        let site = sample_value(domain, x, walk, |k| number(set, i, k));
        moments.add(site.map_or(0.0, |site| velocity(&site).dot(d)));
    }
    moments
}

/// The mean of the derivative along a straight step is the difference of the
/// field at its ends, without an error of any order.
#[test]
fn derivatives_are_differences_of_the_field() {
    let (a, b) = (Vec2::new(-0.45, -0.1), Vec2::new(-0.2, -0.5));
    let onto = Vec2::new(0.8, 0.6);
    for (name, domain) in domains() {
        for (steps, max_radius, estimator) in [
            (1, 0.25, Estimator::Anchored),
            (1, f64::INFINITY, Estimator::Literal),
            (1, f64::INFINITY, Estimator::Anchored),
            (2, f64::INFINITY, Estimator::Anchored),
            (2, 0.25, Estimator::Literal),
            (3, f64::INFINITY, Estimator::Anchored),
        ] {
            let walk = WalkSettings {
                estimator,
                ..settings(steps, max_radius)
            };
            let mut derivative = Moments::default();
            for i in 0..60_000 {
                let random = |d| number(1, i, d);
                let x = a + (b - a) * random(99);
                let field = sample_field(&domain, x, &walk, random);
                derivative.add(field.directional_derivative(b - a, velocity).dot(onto));
            }
            let [ahead, behind] =
                [(b, 2), (a, 3)].map(|(x, set)| field_along(&domain, x, onto, &walk, set));
            let expected = ahead.mean - behind.mean;
            let error = ahead.standard_error().hypot(behind.standard_error());
            let what = format!("{name}, M = {steps}, D ≤ {max_radius}, {estimator:?}");
            assert_mean(&derivative, expected, 4.0 * error, &what);
            let noise = derivative.standard_error().hypot(error);
            assert!(
                expected.abs() > 15.0 * noise,
                "{what}: {expected} ± {noise}"
            );
        }
    }
}

/// Samples ask for the numbers that they say they take; the literal estimator's two
/// walks share none, as Algorithm 4 has it.
#[test]
fn literal_walks_share_no_numbers() {
    let (_, domain) = &domains()[0];
    for steps in 1..5 {
        for (estimator, count) in [
            (Estimator::Anchored, 2 * steps),
            (Estimator::Literal, 4 * steps - 1),
        ] {
            let walk = WalkSettings {
                estimator,
                ..settings(steps, f64::INFINITY)
            };
            let asked = RefCell::new(Vec::new());
            sample_field(domain, Vec2::new(-0.2, -0.4), &walk, |i| {
                asked.borrow_mut().push(i);
                number(4, 0, i)
            });
            let mut asked = asked.into_inner();
            let times = asked.len() as u32;
            asked.sort_unstable();
            asked.dedup();
            assert_eq!(asked.len() as u32, count, "{estimator:?}, M = {steps}");
            assert!(asked.iter().all(|&i| i < walk.dimensions()));
            if estimator == Estimator::Literal {
                assert_eq!(times, count, "no number twice, M = {steps}");
            }
        }
    }
}

/// At single points, by quadrature of one step's two numbers on both sides.
#[test]
fn derivative_is_that_of_the_mean() {
    let walk = settings(1, f64::INFINITY);
    let n = 400;
    let cells = || (0..n * n).map(|i| [i / n, i % n].map(|k| (f64::from(k) + 0.5) / f64::from(n)));
    let share = f64::from(n * n).recip();
    for (name, domain) in domains() {
        for (k, x) in [Vec2::new(-0.5, 0.1), Vec2::new(0.3, -0.6)]
            .into_iter()
            .enumerate()
        {
            let d = Vec2::unit(0.15 + 0.3 * k as f64);
            let mean = |x: Vec2| {
                cells().fold(Vec2::new(0.0, 0.0), |sum, u| {
                    let site = sample_value(&domain, x, &walk, |i| u[i as usize]);
                    sum + velocity(&site.expect("the boundary is everywhere")) * share
                })
            };
            let h = 0.01;
            let expected = (mean(x + d * h) - mean(x - d * h)) * (0.5 / h);
            let found = cells().fold(Vec2::new(0.0, 0.0), |sum, u| {
                let field = sample_field(&domain, x, &walk, |i| u[i as usize]);
                sum + field.directional_derivative(d, velocity) * share
            });
            // The quadrature meets discontinuities: it is good to a few parts in a hundred.
            let error = (found - expected).length();
            assert!(error < 0.03, "{name} at {x:?}: {found:?}, {expected:?}");
            assert!(expected.length() > 0.2, "nothing to see at {x:?}");
        }
    }
}

/// Eqs. (3) and (21): the divergence over the polygon is the boundary term.
#[test]
fn divergence_is_the_boundary_term() {
    let corners = polygon();
    let domain = Plane::polygon(&corners);
    let mut boundary_term = 0.0;
    for (curve, &a) in corners.iter().enumerate() {
        let along = corners[(curve + 1) % corners.len()] - a;
        let outward = Vec2::new(along.y, -along.x);
        let n = 1000;
        for k in 0..n {
            let t = (f64::from(k) + 0.5) / f64::from(n);
            let point = a + along * t;
            boundary_term += velocity(&CurvePoint { curve, t, point }).dot(outward) / f64::from(n);
        }
    }
    // Rays to the right cross the polygon an odd number of times.
    let is_inside = |x: Vec2| {
        let sides = corners.iter().zip(corners.iter().cycle().skip(1));
        let crossed = sides.filter(|(a, b)| {
            (a.y > x.y) != (b.y > x.y) && a.x + (b.x - a.x) * (x.y - a.y) / (b.y - a.y) > x.x
        });
        crossed.count() % 2 == 1
    };
    let [lowest, size] = [Vec2::new(-1.2, -1.2), Vec2::new(2.4, 2.4)];
    for (steps, max_radius, antithetic) in [
        (1, 9.0, false),
        (1, 0.1, true),
        (2, 9.0, true),
        (3, 0.2, false),
    ] {
        let walk = WalkSettings {
            antithetic,
            ..settings(steps, max_radius)
        };
        let mut moments = Moments::default();
        for i in 0..200_000 {
            let random = |d| number(4, i, d);
            let x = lowest + Vec2::new(size.x * random(98), size.y * random(99));
            let divergence = match is_inside(x) {
                true => sample_field(&domain, x, &walk, random).evaluate(velocity).1,
                false => 0.0,
            };
            moments.add(divergence * size.x * size.y);
        }
        assert_mean(
            &moments,
            boundary_term,
            1e-4,
            &format!("M = {steps}, D ≤ {max_radius}"),
        );
        assert!(moments.standard_error() < 0.05 * boundary_term.abs());
    }
}

/// On the two sides of the medial axis the field of no steps differs, the field
/// of one step does not: no steps are not valid (Section 5.1, base cases).
#[test]
fn field_of_no_steps_is_discontinuous_at_the_medial_axis() {
    let domain = Plane::polygon(
        &[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(|[x, y]| Vec2::new(x, y)),
    );
    let height = |site: &CurvePoint| site.point.y;
    let value = |y: f64, steps: u32| {
        let walk = settings(steps, f64::INFINITY);
        let mut moments = Moments::default();
        for i in 0..10_000 {
            let site = sample_value(&domain, Vec2::new(1.0, y), &walk, |d| number(5, i, d));
            moments.add(height(&site.expect("there is a boundary")));
        }
        moments.mean
    };
    assert_eq!([value(0.499, 0), value(0.501, 0)], [0.0, 1.0]);
    assert!((value(0.499, 1) - value(0.501, 1)).abs() < 0.01);
}

/// `Plane` walks on both sides of its curves, and only up to `max_radius`.
#[test]
fn nothing_is_found_beyond_the_reach() {
    let domain = Plane::circle(Vec2::new(0.0, 0.0), 1.0);
    let walk = settings(1, 0.2);
    let far = sample_field(&domain, Vec2::new(1.5, 0.0), &walk, |_| 0.3);
    assert!(far.is_zero());
    let near = sample_field(&domain, Vec2::new(1.1, 0.0), &walk, |_| 0.3);
    assert!(!near.is_zero());
    let outside = domain
        .closest(Vec2::new(3.0, 4.0), 10.0)
        .expect("it is 4 away");
    assert!((outside.distance - 4.0).abs() < 1e-12);
}
