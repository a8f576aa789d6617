//! Synthetic images with known truth, fixed seeds, counted failures.

use capwalk_math::Rgb;
use capwalk_scene::Image;

use super::*;

const SIZE: usize = 40;

/// A small generator of standard normal numbers: SplitMix64 (Steele et al.
/// 2014) and Box and Muller 1958.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (2.0 * std::f64::consts::PI * self.uniform()).cos()
    }

    /// Number of events if `mean` are expected (Knuth).
    fn poisson(&mut self, mean: f64) -> f64 {
        let (limit, mut product, mut count) = ((-mean).exp(), self.uniform(), 0.0);
        while product > limit {
            product *= self.uniform();
            count += 1.0;
        }
        count
    }
}

/// A derivative like that of a shadow's edge: a dark and a bright ridge on a
/// ground of zero.
fn truth(x: usize, y: usize) -> f64 {
    let at = (x as f64 + 0.3 * y as f64) / SIZE as f64;
    let ridge = |centre: f64, width: f64| (-((at - centre) / width).powi(2)).exp();
    2.0 * ridge(0.4, 0.15) - ridge(0.9, 0.1)
}

/// How far noise reaches, in standard deviations per unit of `sigma`: strong
/// on the ridges, weak beside them.
fn noise_at(x: usize, y: usize) -> f64 {
    0.1 + truth(x, y).abs()
}

/// An image of `factor · truth + offset` with noise, whose stated errors are
/// `stated` times the true ones.
fn gaussian(noise: &mut Noise, sigma: f64, factor: f64, offset: f64, stated: f64) -> Estimate {
    estimate_of(|x, y| {
        let sigma = sigma * noise_at(x, y);
        let value = factor * truth(x, y) + offset + sigma * noise.normal();
        (value, stated * sigma)
    })
}

fn estimate_of(mut pixel: impl FnMut(usize, usize) -> (f64, f64)) -> Estimate {
    let mut mean = Image::new(SIZE, SIZE);
    let mut standard_error = Image::new(SIZE, SIZE);
    for (y, x) in (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (y, x))) {
        let (value, error) = pixel(x, y);
        mean.pixels[y * SIZE + x] = Rgb::splat(value);
        standard_error.pixels[y * SIZE + x] = Rgb::splat(error);
    }
    Estimate {
        mean,
        standard_error,
    }
}

/// Verdicts of many trials: right, wrong, could not tell.
fn count(trials: u64, mut trial: impl FnMut(&mut Noise) -> Comparison) -> [u32; 3] {
    let mut counts = [0; 3];
    for seed in 0..trials {
        counts[match trial(&mut Noise(seed << 32)).verdict {
            Verdict::Right => 0,
            Verdict::Wrong { .. } => 1,
            Verdict::Inconclusive { .. } => 2,
        }] += 1;
    }
    counts
}

/// No false alarm in 300 checks; four tests at 6.3e-5 each would raise one in
/// 13 such runs of other seeds. The statistics have the moments they claim.
#[test]
fn right_gradients_pass() {
    let (mut z_squared, mut signs, mut factors) = (0.0, 0.0, 0.0);
    let mut plain = capwalk_math::Moments::default();
    let counts = count(300, |noise| {
        let reference = gaussian(noise, 0.3, 1.0, 0.0, 1.0);
        let c = compare(&gaussian(noise, 0.3, 1.0, 0.0, 1.0), &reference);
        z_squared += ((c.mean_z_squared - 1.0) / c.mean_z_squared_error).powi(2) / 300.0;
        signs += c.sign.powi(2) / 300.0;
        plain.add(c.mean_z_squared_plain);
        factors += ((c.scale_factor - 1.0) / c.scale_factor_error).powi(2) / 300.0;
        c
    });
    assert_eq!(counts, [300, 0, 0]);
    // A mean of 300 squared standard normal variables is within four standard
    // errors, 0.33, of 1.
    for mean in [z_squared, signs, factors] {
        assert!((mean - 1.0).abs() < 0.33, "{z_squared} {signs} {factors}");
    }
    // With Gaussian noise the plain mean of z² is 1 as well.
    let off = plain.mean - 1.0;
    assert!(off.abs() < 4.0 * plain.standard_error(), "{plain:?}");
    assert!(plain.standard_error() < 0.005, "{plain:?}");
}

/// A factor of 10 to 20 per cent is found, or hidden by noise, but never
/// called right.
#[test]
fn a_wrong_factor_is_never_right() {
    for (factor, sigma, wrong_at_least) in [
        (0.9, 0.1, 100),
        (1.1, 0.1, 100),
        (0.8, 0.5, 95),
        (1.3, 1.0, 20),
        (0.85, 4.0, 0),
    ] {
        let [right, wrong, unsure] = count(100, |noise| {
            let reference = gaussian(noise, sigma, 1.0, 0.0, 1.0);
            compare(&gaussian(noise, sigma, factor, 0.0, 1.0), &reference)
        });
        // At exactly ten per cent, two standard errors leave 2.3 per cent.
        assert!(right <= 3, "factor {factor}, sigma {sigma}: {right} right");
        assert!(
            wrong >= wrong_at_least,
            "factor {factor}, sigma {sigma}: {wrong} wrong, {unsure} unsure"
        );
    }
}

/// A term is missing in a third of the pixels, with as many errors as noise just reaches, and
/// noise differs by magnitudes from one pixel to the next: a few pixels carry the mean of
/// `z²` and widen its error, scale and sign are right. That is never called right; the same
/// noise alone nearly always is.
#[test]
fn a_term_missing_in_a_part_of_the_image_is_never_right() {
    let against = |missing: f64| {
        count(200, |noise| {
            let sigmas: Vec<f64> = (0..SIZE * SIZE)
                .map(|_| 1e-3 * (1.3 * noise.normal()).exp())
                .collect();
            let reference = estimate_of(|x, y| {
                let sigma = sigmas[y * SIZE + x];
                let sign = if noise.uniform() < 0.5 { -1.0 } else { 1.0 };
                let term = if 3 * x < SIZE { sign * missing } else { 0.0 };
                (truth(x, y) + sigma * (term + noise.normal()), sigma)
            });
            let gradient = estimate_of(|x, y| (truth(x, y), 1e-6));
            compare(&gradient, &reference)
        })
    };
    let [right, wrong, unsure] = against(4.0);
    assert_eq!(right, 0, "{wrong} wrong, {unsure} unsure");
    assert!(unsure > 100, "{wrong} wrong, {unsure} unsure");
    let [right, wrong, unsure] = against(0.0);
    assert!(right > 180, "{right} right, {wrong} wrong, {unsure} unsure");
}

/// Noise in the gradient does not bring the scale factor down.
#[test]
fn the_scale_factor_is_not_attenuated() {
    let mut mean = capwalk_math::Moments::default();
    for seed in 0..100 {
        let mut noise = Noise(seed << 32);
        let reference = gaussian(&mut noise, 0.1, 1.0, 0.0, 1.0);
        mean.add(compare(&gaussian(&mut noise, 1.0, 1.0, 0.0, 1.0), &reference).scale_factor);
    }
    let off = mean.mean - 1.0;
    assert!(off.abs() < 4.0 * mean.standard_error(), "{mean:?}");
    assert!(mean.standard_error() < 0.01, "{mean:?}"); // ordinary regression: 0.5
}

/// A common offset far below the noise of each pixel.
#[test]
fn a_systematic_sign_is_found() {
    let counts = count(100, |noise| {
        let reference = gaussian(noise, 0.5, 1.0, 0.0, 1.0);
        compare(&gaussian(noise, 0.5, 1.0, 0.08, 1.0), &reference)
    });
    assert_eq!(counts, [0, 100, 0]);
}

/// Standard errors that are half or twice the truth.
#[test]
fn wrong_standard_errors_are_found() {
    for stated in [0.5, 2.0] {
        let counts = count(50, |noise| {
            let reference = gaussian(noise, 0.3, 1.0, 0.0, 1.0);
            compare(&gaussian(noise, 0.3, 1.0, 0.0, stated), &reference)
        });
        assert_eq!(counts, [0, 50, 0], "stated {stated}");
    }
}

/// One pixel that is wrong among 1600.
#[test]
fn one_wrong_pixel_is_found() {
    let mut noise = Noise(1);
    let reference = gaussian(&mut noise, 0.3, 1.0, 0.0, 1.0);
    let mut gradient = gaussian(&mut noise, 0.3, 1.0, 0.0, 1.0);
    gradient.mean.pixels[7 * SIZE + 30] += Rgb::splat(8.0);
    let comparison = compare(&gradient, &reference);
    assert_eq!((comparison.worst[0].0, comparison.worst[0].1), (30, 7));
    let Verdict::Wrong { reason } = comparison.verdict else {
        panic!("{:?}", comparison.verdict);
    };
    assert!(reason.contains("pixel (30, 7)"), "{reason}");
}

/// Differences are rare events of large size: `z` of a pixel is far from
/// normal, and a pixel that met no event states an error of zero. Right
/// gradients pass all the same, and wrong ones do not.
#[test]
fn rare_events_raise_no_false_alarm() {
    for events in [1.0, 4.0, 30.0] {
        let sparse = |noise: &mut Noise| {
            estimate_of(|x, y| {
                let (truth, size) = (truth(x, y), 1.0 / events);
                let count = noise.poisson(events * truth.abs());
                (truth.signum() * size * count, size * f64::sqrt(count))
            })
        };
        let against = |factor: f64| {
            count(200, |noise| {
                let c = compare(&gaussian(noise, 0.05, factor, 0.0, 1.0), &sparse(noise));
                // A pixel that met no event is not infinitely wrong.
                assert!(c.worst[0].2.abs() < 9.0, "{:?}", c.worst[0]);
                c
            })
        };
        // At one event per pixel, 1 in 5000 is called wrong; at four, none was.
        let [_, wrong, _] = against(1.0);
        assert!(wrong <= 1, "{events} events: {wrong} wrong");
        let [right, ..] = against(0.8);
        assert_eq!(right, 0, "{events} events");
    }
}

/// A gradient without noise beside differences that see rare events: most of their pixels
/// have none. Left out where they have none, they would be too large.
#[test]
fn rare_events_beside_no_noise_raise_no_false_alarm() {
    for events in [0.3, 3.0] {
        let mut factors = capwalk_math::Moments::default();
        let counts = count(100, |noise| {
            let gradient = estimate_of(|x, y| (truth(x, y), 1e-6 * truth(x, y).abs()));
            let reference = estimate_of(|x, y| {
                // The mean and its error, as 100 samples tell.
                let met = noise.poisson(events);
                let per_event = truth(x, y) / events;
                let spread = met * (1.0 - met / 100.0) * 100.0 / 99.0;
                (met * per_event, spread.max(0.0).sqrt() * per_event.abs())
            });
            let c = compare(&gradient, &reference);
            factors.add((c.scale_factor - 1.0) / c.scale_factor_error);
            c
        });
        assert_eq!(counts[1], 0, "{events} events: {counts:?}");
        let off = factors.mean.abs();
        assert!(off < 4.0 * factors.standard_error(), "{factors:?}");
        assert!((0.6..1.5).contains(&factors.variance()), "{factors:?}");
    }
}

/// Exact pixels beside noisy ones, as those of a visible emitter: they are large and agree,
/// and say nothing of the others.
#[test]
fn exact_pixels_hide_no_wrong_ones() {
    let is_exact = |x: usize| x < 6;
    let against = |factor: f64, bias: f64, sigma: f64| {
        count(100, |noise| {
            let mut image = |factor: f64, exact: f64| {
                estimate_of(|x, y| match is_exact(x) {
                    true => (30.0 * exact, 0.0),
                    false => (factor * truth(x, y) + sigma * noise.normal(), sigma),
                })
            };
            let gradient = image(factor, 1.0);
            compare(&gradient, &image(1.0, 1.0 + bias))
        })
    };
    assert_eq!(against(1.0, 0.0, 0.1)[1], 0);
    // The bias of the reference where nothing is noisy is not held against the gradient.
    assert_eq!(against(1.0, 5e-3, 0.1)[1], 0);
    assert_eq!(against(0.8, 0.0, 0.1)[0], 0);
    // Noise that hides a wrong factor is not made up for.
    assert_eq!(against(1.0, 0.0, 30.0)[0], 0);
}

/// The promised number of samples is enough nine times out of ten, and not
/// many times too large.
#[test]
fn the_promised_samples_are_enough() {
    for sigma in [1.0, 2.0, 4.0] {
        let mut noise = Noise(5 << 32);
        let reference = gaussian(&mut noise, sigma, 1.0, 0.0, 1.0);
        let first = compare(&gaussian(&mut noise, sigma, 1.0, 0.0, 1.0), &reference);
        let Verdict::Inconclusive { samples_factor, .. } = first.verdict else {
            panic!("sigma {sigma}: {:?}", first.verdict);
        };
        let with = |factor: f64| {
            let sigma = sigma / factor.sqrt();
            count(50, |noise| {
                let reference = gaussian(noise, sigma, 1.0, 0.0, 1.0);
                compare(&gaussian(noise, sigma, 1.0, 0.0, 1.0), &reference)
            })
        };
        assert!(
            with(samples_factor)[0] >= 40,
            "sigma {sigma}: {samples_factor}"
        );
        assert!(
            with(samples_factor / 8.0)[0] <= 10,
            "sigma {sigma}: {samples_factor}"
        );
    }
}

/// A gradient that misses the whole effect.
#[test]
fn a_zero_gradient_is_wrong() {
    let counts = count(20, |noise| {
        let reference = gaussian(noise, 0.3, 1.0, 0.0, 1.0);
        compare(&estimate_of(|_, _| (0.0, 0.0)), &reference)
    });
    assert_eq!(counts, [0, 20, 0]);
}

#[test]
fn images_without_noise() {
    let exact = |factor: f64| estimate_of(|x, y| (factor * truth(x, y), 0.0));
    let verdict = |a: &Estimate, b: &Estimate| compare(a, b).verdict;
    assert_eq!(verdict(&exact(0.0), &exact(0.0)), Verdict::Right);
    assert_eq!(verdict(&exact(1.0), &exact(1.001)), Verdict::Right);
    assert!(matches!(
        verdict(&exact(1.0), &exact(1.1)),
        Verdict::Wrong { .. }
    ));
    assert!(matches!(
        verdict(&exact(0.0), &exact(1.0)),
        Verdict::Wrong { .. }
    ));
}

#[test]
fn one_sample_tells_nothing() {
    let unknown = estimate_of(|x, y| (truth(x, y), f64::NAN));
    let comparison = compare(&unknown, &unknown);
    assert_eq!(
        comparison.verdict,
        Verdict::Inconclusive {
            samples_factor: 2.0,
            doubt: None
        }
    );
    assert_eq!(comparison.relative_l1, 0.0);
    assert!((comparison.correlation - 1.0).abs() < 1e-12);
}

/// Images that were stopped early are judged by the pixels that were reached.
#[test]
fn pixels_without_an_error_are_left_out() {
    let mut noise = Noise(3);
    let reference = gaussian(&mut noise, 0.1, 1.0, 0.0, 1.0);
    let mut gradient = gaussian(&mut noise, 0.1, 1.0, 0.0, 1.0);
    for index in 0..SIZE * SIZE / 3 {
        gradient.mean.pixels[index] = Rgb::splat(0.0);
        gradient.standard_error.pixels[index] = Rgb::splat(f64::NAN);
    }
    let comparison = compare(&gradient, &reference);
    assert_eq!(comparison.left_out, SIZE * SIZE / 3);
    assert_eq!(comparison.pixels, SIZE * SIZE - SIZE * SIZE / 3);
    assert_eq!(comparison.verdict, Verdict::Right);
}

/// One pixel in ten states a tenth of its error. By hand: all differences are 1,
/// `z` is 10 there and 1 elsewhere; the ratio of sums hardly notices.
#[test]
fn mean_z_squared_with_and_without_weights() {
    let stated = |x: usize| if x % 10 == 3 { 0.1 } else { 1.0 };
    let gradient = estimate_of(|x, _| (1.0, 0.6 * stated(x)));
    let reference = estimate_of(|x, _| (0.0, 0.8 * stated(x)));
    let comparison = compare(&gradient, &reference);
    let plain = 0.1 * 100.0 + 0.9;
    let found = comparison.mean_z_squared_plain;
    assert!((found - plain).abs() < 1e-12 * plain, "{found}");
    // One over the mean variance, 0.901; weights vary by a fifth.
    let weighted = comparison.mean_z_squared;
    assert!((weighted - 1.0 / 0.901).abs() < 0.05, "{weighted}");
}

/// Where nothing has noise there is no z.
#[test]
fn images_without_noise_have_no_z_squared() {
    let exact = estimate_of(|x, y| (truth(x, y), 0.0));
    let comparison = compare(&exact, &exact);
    assert!(comparison.mean_z_squared.is_nan());
    assert!(comparison.mean_z_squared_plain.is_nan());
}

/// An error in one channel only is seen in its third of the pixels.
#[test]
fn every_channel_is_looked_at() {
    for c in 0..3 {
        let mut noise = Noise(c << 32);
        let reference = gaussian(&mut noise, 0.1, 1.0, 0.0, 1.0);
        let mut gradient = gaussian(&mut noise, 0.1, 1.0, 0.0, 1.0);
        for pixel in &mut gradient.mean.pixels {
            let factors = std::array::from_fn::<_, 3, _>(|i| 1.0 + 0.5 * f64::from(i as u64 == c));
            *pixel = Rgb::new(
                pixel.r * factors[0],
                pixel.g * factors[1],
                pixel.b * factors[2],
            );
        }
        let verdict = compare(&gradient, &reference).verdict;
        assert!(matches!(verdict, Verdict::Wrong { .. }), "channel {c}");
    }
}

/// Where a difference is only rounding, the reference says nothing of its own:
/// the pixel is judged by the noise around it.
#[test]
fn rounding_counts_as_zero() {
    let mut noise = Noise(3);
    let step = 0.05;
    // Right, but for a corner without an event in the reference.
    let corner = |x: usize, y: usize| x < 4 && y < 4;
    let (gradient, noisy) = (
        gaussian(&mut noise, 0.1, 1.0, 0.0, 1.0),
        gaussian(&mut noise, 0.1, 1.0, 0.0, 1.0),
    );
    let with_corner = |estimate: &Estimate, value: f64, error: f64| {
        estimate_of(|x, y| match corner(x, y) {
            true => (value, error),
            false => {
                let i = y * SIZE + x;
                let error = estimate.standard_error.pixels[i].r;
                (estimate.mean.pixels[i].r, error)
            }
        })
    };
    let gradient = with_corner(&gradient, 1e-3, 1e-5);
    let image = |gradient: Estimate| crate::GradientImage {
        chosen: None,
        value: estimate_of(|_, _| (0.5, 0.01)),
        gradient,
        statistics: Default::default(),
    };
    let rounded = image(with_corner(&noisy, -1.6e-15, 7e-16));
    let worst = |reference: &Estimate| compare(&gradient, reference).worst[0].2.abs();
    assert!(worst(&rounded.gradient) > 40.0);
    let cleaned = without_rounding(&rounded, step);
    assert_eq!(cleaned, with_corner(&noisy, 0.0, 0.0));
    assert!(worst(&cleaned) < 6.0, "{}", worst(&cleaned));

    // Numbers that are small but no rounding stay.
    let small = image(with_corner(&noisy, 2e-11, 1e-11));
    assert_eq!(without_rounding(&small, step), small.gradient);
    // Nothing but rounding is nothing.
    let nothing = without_rounding(&image(estimate_of(|_, _| (1e-15, 1e-15))), step);
    assert_eq!(nothing, estimate_of(|_, _| (0.0, 0.0)));
}

/// A gradient image whose samples are all near 1, with so many of them in each pixel.
fn with_samples(gradient: Estimate, samples: u32) -> crate::GradientImage {
    crate::GradientImage {
        chosen: None,
        value: estimate_of(|_, _| (1.0, 0.1 / f64::from(samples).sqrt())),
        gradient,
        statistics: crate::Statistics {
            samples_per_pixel: vec![samples; SIZE * SIZE],
            ..Default::default()
        },
    }
}

/// Differences of silhouettes see an event where one passes a sample, and each changes it by
/// what it is worth. Where there is none, the reference is 0 ± 0 in all pixels, and few of
/// them say no more.
#[test]
fn differences_without_events_are_no_evidence() {
    let samples = 100;
    let total: f64 = (0..SIZE * SIZE)
        .map(|i| truth(i % SIZE, i / SIZE).abs())
        .sum();
    // How far to move for so many events in the whole image.
    let span = |events: f64| events / (f64::from(samples) * total);
    // Besides, what is smooth changes a little everywhere.
    let against = |events: f64, really: f64| {
        let span = span(events);
        let mut doubts = 0;
        let counts = count(200, |noise| {
            let gradient = gaussian(noise, 0.01, 1.0, 0.0, 1.0);
            let n = f64::from(samples);
            let reference = estimate_of(|x, y| {
                let met = noise.poisson(really * n * span * truth(x, y).abs());
                let worth = truth(x, y).signum() / (n * span);
                let smooth = 1e-5 * worth.abs();
                (met * worth, f64::sqrt(met) * worth.abs() + smooth)
            });
            let images = [gradient, reference].map(|image| with_samples(image, samples));
            let c = compare_with_differences(&images[0], &images[1], span);
            let has_reason = |doubt: &str| doubt.contains("the differences saw");
            if let Verdict::Inconclusive {
                doubt: Some(doubt),
                samples_factor,
            } = &c.verdict
            {
                doubts += u32::from(has_reason(doubt));
                assert!(*samples_factor > 10.0 && samples_factor.is_finite());
            }
            c
        });
        (counts, doubts)
    };
    // A right gradient: none of them wrong.
    for events in [0.01, 0.3, 2.0, 5.0] {
        let (counts, doubts) = against(events, 1.0);
        assert_eq!(counts[..2], [0, 0], "{events} events: {counts:?}");
        assert!(doubts > 20, "{events} events: {doubts} of {counts:?}");
    }
    // Nothing changes, and the gradient is not zero: wrong as soon as events are missed.
    for (events, wrong) in [(0.1, 0), (5.0, 0), (12.0, 200), (1000.0, 200)] {
        let (counts, _) = against(events, 0.0);
        assert_eq!(counts, [0, wrong, 200 - wrong], "{events} events");
    }
    // A gradient that misses nearly all of what changes.
    let (counts, _) = against(20.0, 100.0);
    assert_eq!(counts, [0, 200, 0]);
}

/// All samples see what changes smoothly, with a small error, and few of them an event, of which most
/// of the derivative is made: where pixels met none, the stated errors say nothing of that.
#[test]
fn events_that_pixels_did_not_meet_are_no_evidence() {
    let samples = 100;
    let worth = 20.0;
    let against = |factor: f64| {
        count(200, |noise| {
            let gradient = gaussian(noise, 0.02, factor, 0.0, 1.0);
            let reference = estimate_of(|x, y| {
                let (smooth, rare) = (0.1 * truth(x, y), 0.9 * truth(x, y));
                let met = noise.poisson(rare.abs() / worth);
                let error = f64::hypot(0.1 * smooth, f64::sqrt(met) * worth);
                (smooth + rare.signum() * met * worth, error)
            });
            let images = [gradient, reference].map(|image| with_samples(image, samples));
            let span = 1.0 / (f64::from(samples) * worth);
            compare_with_differences(&images[0], &images[1], span)
        })
    };
    // By the stated errors alone four of the right ones are called wrong.
    let [_, wrong, _] = against(1.0);
    assert_eq!(wrong, 0);
    // What events do not explain is wrong, of either sign.
    for sign in [1.0, -1.0] {
        let nothing = with_samples(estimate_of(|_, _| (0.0, 0.0)), samples);
        let mut noise = Noise(1);
        let reference = with_samples(gaussian(&mut noise, 0.02, sign, 0.0, 1.0), samples);
        let verdict = compare_with_differences(&nothing, &reference, 1e-3).verdict;
        assert!(matches!(verdict, Verdict::Wrong { .. }), "{verdict:?}");
    }
    let [_, wrong, _] = against(4.0);
    assert!(wrong > 190, "{wrong}");
}

/// Samples without noise, such as those of a visible emitter, all change by little: no rare
/// events.
#[test]
fn samples_without_noise_are_evidence() {
    let mut images =
        [1.0, 0.0].map(|factor| with_samples(estimate_of(|x, y| (factor * truth(x, y), 0.0)), 16));
    let verdict = compare_with_differences(&images[0], &images[1], 0.02).verdict;
    assert!(matches!(verdict, Verdict::Wrong { .. }), "{verdict:?}");
    // In a black image, nothing that is there could hide.
    images[1].value = estimate_of(|_, _| (0.0, 0.0));
    let verdict = compare_with_differences(&images[0], &images[1], 1e-9).verdict;
    assert!(matches!(verdict, Verdict::Wrong { .. }), "{verdict:?}");
}
