//! The toy of Section 3.3: an integral whose derivative is 1, by each of the
//! fields that the paper compares (Eqs. 7 to 11, figure 3).

use capwalk_math::Moments;
use capwalk_math::quadrature::gauss_legendre;
use capwalk_paper::walk::interval::{End, Interval};
use capwalk_paper::walk::random_step::{ShellSettings, sample_harmonic};
use capwalk_paper::walk::weighted_average::WeightedAverage;
use capwalk_walk::{Estimator, WalkSettings, sample_field, sample_value};

#[path = "../../../crates/walk/tests/common/mod.rs"]
mod common;
use common::{assert_mean, number};

/// Section 3.3: the right end moves, the length grows by one.
fn velocity(end: &End) -> f64 {
    match end {
        End::Left => 0.0,
        End::Right => 1.0,
    }
}

fn settings(steps: u32, estimator: Estimator) -> WalkSettings {
    WalkSettings {
        steps,
        max_radius: 1.0,
        estimator,
        antithetic: false,
    }
}

#[test]
fn toy_integral_has_derivative_one() {
    for steps in [1, 2, 3, 4, 16] {
        for antithetic in [false, true] {
            let settings = WalkSettings {
                antithetic,
                ..settings(steps, Estimator::Anchored)
            };
            let mut moments = Moments::default();
            for i in 0..40_000 {
                let random = |d| number(1, i, d);
                let field = sample_field(&Interval, random(99), &settings, random);
                moments.add(field.evaluate(velocity).1);
            }
            assert_mean(&moments, 1.0, 1e-12, &format!("M = {steps}"));
            assert!(moments.standard_error() < 0.05);
        }
    }
}

/// The field of no steps is discontinuous in the middle, and beside that it is
/// constant: its divergence would say that the derivative is 0.
#[test]
fn field_of_no_steps_is_not_valid() {
    let none = settings(0, Estimator::Anchored);
    let value = |x: f64| {
        let site = sample_value(&Interval, x, &none, |_| 0.5);
        site.as_ref().map_or(0.0, velocity)
    };
    assert_eq!([0.01, 0.2, 0.499].map(value), [0.0; 3]);
    assert_eq!([0.501, 0.8, 0.99].map(value), [1.0; 3]);
}

/// The field of `steps` steps and its derivative on a grid of `n` cells by its
/// definition, Eq. (20) in one dimension: means over `(0, 2x)`, and the mirror
/// image `v(1 - x) = 1 - v(x)`.
fn by_recursion(steps: u32, n: usize) -> impl Fn(f64) -> (f64, f64) {
    let mut before: Vec<f64> = Vec::new();
    let mut field: Vec<f64> = (0..=n).map(|i| f64::from(u8::from(2 * i >= n))).collect();
    for _ in 0..steps {
        // Integrals from 0, by trapezoids.
        let mut integrals = vec![0.0; n + 1];
        for i in 1..=n {
            integrals[i] = integrals[i - 1] + 0.5 * (field[i - 1] + field[i]) / n as f64;
        }
        before = field;
        let mean = |i: usize| match i {
            0 => 0.0,
            i => integrals[2 * i] / (2.0 * i as f64 / n as f64),
        };
        field = (0..=n)
            .map(|i| match 2 * i <= n {
                true => mean(i),
                false => 1.0 - mean(n - i),
            })
            .collect();
    }
    move |x| {
        let i = (x * n as f64).round() as usize;
        let (near, far) = match 2 * i <= n {
            true => (i, 2 * i),
            // v'(1 - x) = v'(x), from v(1 - x) = 1 - v(x).
            false => (n - i, 2 * (n - i)),
        };
        // d/dx [V(2x) / 2x], where V is the integral of the field before.
        let derivative = (before[far] - field[near]) / (near as f64 / n as f64);
        (field[i], derivative)
    }
}

#[test]
fn fixed_step_fields_are_their_definition() {
    for (steps, estimator) in [
        (1, Estimator::Anchored),
        (1, Estimator::Literal),
        (2, Estimator::Anchored),
        (4, Estimator::Literal),
        (16, Estimator::Anchored),
    ] {
        let exact = by_recursion(steps, 10_000);
        for x in [0.11, 0.31, 0.46, 0.62, 0.93] {
            let [mut value, mut derivative] = [Moments::default(); 2];
            for i in 0..20_000 {
                let random = |d| number(2, i, d);
                let settings = settings(steps, estimator);
                let field = sample_field(&Interval, x, &settings, random);
                let (v, dv) = field.evaluate(velocity);
                value.add(v);
                derivative.add(dv);
            }
            let (v, dv) = exact(x);
            let what = format!("M = {steps}, {estimator:?} at {x}");
            assert_mean(&value, v, 1e-3, &what);
            assert_mean(&derivative, dv, 5e-3, &what);
        }
    }
}

/// `v(x) = x`, whatever the number of steps a walk takes.
#[test]
fn harmonic_field_is_a_straight_line() {
    for estimator in [Estimator::Literal, Estimator::Anchored] {
        let settings = ShellSettings {
            shell: 1e-6,
            estimator,
            ..Default::default()
        };
        for x in [0.03, 0.3, 0.5, 0.77] {
            let [mut value, mut derivative] = [Moments::default(); 2];
            for i in 0..20_000 {
                let walk = sample_harmonic(&Interval, x, &settings, |d| number(3, i, d));
                let (v, dv) = walk.expect("it arrives").sample.evaluate(velocity);
                value.add(v);
                derivative.add(dv);
            }
            assert_mean(&value, x, 1e-6, "value");
            assert_mean(&derivative, 1.0, 1e-5, "derivative");
        }
    }
}

/// Continuous, right at both ends, derivative one; and steep in a small part.
#[test]
fn weighted_average_is_valid_and_narrow() {
    let field = WeightedAverage::default();
    assert!(field.value_and_derivative(1e-3).0 < 1e-6);
    assert!(field.value_and_derivative(1.0 - 1e-4).0 > 1.0 - 1e-3);
    // Nodes crowd towards 1, where the derivative is.
    let nodes = gauss_legendre(200);
    let integral = |from: f64| -> f64 {
        let terms = nodes.iter().map(|(t, w)| {
            let x = 1.0 - (1.0 - from) * t.powi(2);
            w * (1.0 - from) * 2.0 * t * field.value_and_derivative(x).1
        });
        terms.sum()
    };
    let (all, end) = (integral(0.0), integral(0.8));
    assert!((all - 1.0).abs() < 1e-4, "{all}");
    assert!(end > 0.95, "{end} of the derivative lies in the last fifth");
}
