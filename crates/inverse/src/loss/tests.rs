use capwalk_diff::{Purpose, Seed};

use super::*;

/// Numbers that look random, in [0, 1).
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = Seed(state).of_iteration(0, 0, Purpose::Image).0;
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn image(width: usize, height: usize, mut number: impl FnMut() -> f64) -> Image {
    let mut colour = || Rgb::new(number(), number(), number());
    Image {
        width,
        height,
        pixels: (0..width * height).map(|_| colour()).collect(),
    }
}

fn estimate(mean: Image, error: f64) -> Estimate {
    Estimate {
        standard_error: Image {
            pixels: vec![Rgb::splat(error); mean.pixels.len()],
            ..mean
        },
        mean,
    }
}

const DISTANCES: [Distance; 4] = [
    Distance::L1,
    Distance::L2,
    Distance::Relative { epsilon: 0.01 },
    Distance::Log { epsilon: 0.1 },
];

/// Derivatives by every pixel and channel against central differences, for every
/// distance, with and without a mask that has zeros, at one size and at several,
/// of images whose sides are odd.
#[test]
fn adjoints_are_derivatives() {
    let (width, height) = (7, 5);
    let rendered = image(width, height, numbers(1));
    let target = image(width, height, numbers(2));
    let mut random = numbers(3);
    let mask = image(width, height, || match random() {
        w if w < 0.3 => 0.0,
        w => w,
    });
    for distance in DISTANCES {
        for levels in [1, 2, 4, 9] {
            for weights in [None, Some(&mask)] {
                let loss = Loss { distance, levels };
                let value = |rendered: &Image| {
                    let exact = estimate(rendered.clone(), 0.0);
                    loss.measure(&exact, &target, weights).value
                };
                let exact = estimate(rendered.clone(), 0.0);
                let adjoint = loss.measure(&exact, &target, weights).adjoint;
                for pixel in 0..rendered.pixels.len() {
                    for channel in 0..3 {
                        let at = |h: f64| {
                            let mut moved = rendered.clone();
                            let mut colour = moved.pixels[pixel].to_array();
                            colour[channel] += h;
                            moved.pixels[pixel] = colour.into();
                            value(&moved)
                        };
                        let difference = (at(1e-6) - at(-1e-6)) / 2e-6;
                        let derivative = adjoint.pixels[pixel][channel];
                        assert!(
                            (derivative - difference).abs() < 1e-6 * (1.0 + derivative.abs()),
                            "{distance:?} {levels} {pixel} {channel}: {derivative} {difference}"
                        );
                    }
                }
            }
        }
    }
}

/// By hand, of one pixel against another.
#[test]
fn values_are_those_by_hand() {
    let rendered = estimate(image(2, 1, || 0.5), 0.0);
    let mut target = image(2, 1, || 0.25);
    target.pixels[1] = Rgb::splat(1.0);
    let value = |distance, weights| {
        let loss = Loss {
            distance,
            levels: 1,
        };
        loss.measure(&rendered, &target, weights).value
    };
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-15, "{a} {b}");
    near(value(Distance::L1, None), (0.25 + 0.5) / 2.0);
    near(value(Distance::L2, None), (0.0625 + 0.25) / 2.0);
    let relative = Distance::Relative { epsilon: 0.01 };
    near(value(relative, None), (0.0625 / 0.0725 + 0.25 / 1.01) / 2.0);
    let log = Distance::Log { epsilon: 0.0 };
    near(value(log, None), 2.0_f64.ln().powi(2));
    let mut mask = image(2, 1, || 1.0);
    mask.pixels[1] = Rgb::zero();
    near(value(Distance::L2, Some(&mask)), 0.0625);
    // At half the size, the mean of the target is 5/8.
    let two = Loss {
        distance: Distance::L1,
        levels: 2,
    };
    let both = two.measure(&rendered, &target, None).value;
    near(both, (0.375 + 0.125) / 2.0);
}

/// What stands under a mask may be anything.
#[test]
fn what_is_masked_does_not_count() {
    let mut rendered = estimate(image(4, 3, numbers(5)), 0.1);
    let target = image(4, 3, numbers(6));
    let mut mask = image(4, 3, || 1.0);
    mask.pixels[5] = Rgb::zero();
    for distance in DISTANCES {
        let loss = Loss {
            distance,
            levels: 3,
        };
        let clean = loss.measure(&rendered, &target, Some(&mask));
        assert_eq!(clean.adjoint.pixels[5], Rgb::zero());
        rendered.mean.pixels[5] = Rgb::splat(-7.0);
        rendered.standard_error.pixels[5] = Rgb::splat(f64::NAN);
        assert_eq!(loss.measure(&rendered, &target, Some(&mask)), clean);
        rendered.mean.pixels[5] = Rgb::splat(0.5);
        rendered.standard_error.pixels[5] = Rgb::splat(0.1);
    }
}

/// The mean loss of noisy images is that of the mean image, if the distance is
/// a square; and its spread is at most the standard error, and at least a fifth of
/// it (the error adds the channels as if they had the same noise, which is √3 too
/// much; near zero it is another √2, and squares of uniform noise spread by 0.63 of
/// what those of normal noise do). 4 standard errors of the mean over 2000 images:
/// one run in 10⁴ per case, with a fixed seed.
#[test]
fn noise_is_subtracted_and_errors_hold() {
    let mut random = numbers(7);
    let truth = image(6, 4, numbers(8));
    let far = image(6, 4, numbers(9));
    let mask = image(6, 4, numbers(10));
    let sigma = 0.2;
    for (distance, levels) in [
        (Distance::L2, 1),
        (Distance::L2, 3),
        (Distance::Relative { epsilon: 0.1 }, 2),
    ] {
        for target in [&truth, &far] {
            let loss = Loss { distance, levels };
            let expected = loss
                .measure(&estimate(truth.clone(), 0.0), target, Some(&mask))
                .value;
            let (mut values, mut errors) = (capwalk_math::Moments::default(), 0.0);
            let count = 2000;
            for _ in 0..count {
                let mut noisy = truth.clone();
                for pixel in &mut noisy.pixels {
                    // Uniform, with this standard deviation.
                    let mut noise = || sigma * 12.0_f64.sqrt() * (random() - 0.5);
                    *pixel += Rgb::new(noise(), noise(), noise());
                }
                let measured = loss.measure(&estimate(noisy, sigma), target, Some(&mask));
                values.add(measured.value);
                errors += measured.standard_error.powi(2) / f64::from(count);
            }
            let z = (values.mean - expected) / values.standard_error();
            assert!(z.abs() < 4.0, "{distance:?} {levels}: {z}");
            let spread = values.standard_error() * f64::from(count).sqrt();
            let ratio = spread / errors.sqrt();
            assert!(
                (0.2..1.0).contains(&ratio),
                "{distance:?} {levels}: {ratio}"
            );
        }
    }
}
