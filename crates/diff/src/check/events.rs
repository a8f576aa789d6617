//! How many events the differences saw, and how many a right gradient makes.
//!
//! Where a silhouette moves, a sample of the reference differs between its two sides only if
//! the silhouette passed it: an event, by which the sample changes by at most what samples
//! differ by. If no sample met one, the reference is 0 ± 0 everywhere, which says that events
//! are rare, not that nothing changes.
//!
//! The same happens in single pixels: samples see how the light changes smoothly, with a small
//! error, and none of them meets the event that makes most of the derivative. The stated error
//! knows nothing of events that were not met. That of a right gradient's differences does: `k`
//! events of one size in a sum, and `λ` on average, have the variance `λ` in units of its square,
//! of which `k` is stated. What a pixel lacks, `λ - k`, is known from the gradient in question,
//! and the size of events from the pixels that met some. A gradient is called wrong only if
//! these errors do not explain the differences either.

use capwalk_render::Estimate;

use super::pixel::channel;
use super::{Comparison, EXCLUDED_AT, EXCLUDED_ERROR, FALSE_ALARM, Verdict, compared, doubtful};
use crate::gradient_image::GradientImage;

/// So many pixels with an event are enough for the statistics of a comparison.
const ENOUGH: usize = 10;

/// The least change of a pixel's samples, in events, that counts as one.
const PART_OF_EVENT: f64 = 0.1;

/// Compares a gradient with differences of the same size, like [`compare`](super::compare). Where the
/// differences saw so few events that a right gradient may make as few, they are no evidence
/// against it: that is inconclusive.
///
/// `span` is how far the parameter moves from one side of the differences to the other.
pub fn compare_with_differences(
    gradient: &GradientImage,
    differences: &GradientImage,
    span: f64,
) -> Comparison {
    let (mut comparison, contradiction) = compared(&gradient.gradient, &differences.gradient);
    let is_held_against_it = matches!(
        comparison.verdict,
        Verdict::Wrong { .. } | Verdict::Inconclusive { doubt: Some(_), .. }
    );
    if is_held_against_it && let Some(verdict) = too_few(gradient, differences, span) {
        comparison.verdict = verdict;
        comparison.few_events = true;
        return comparison;
    }
    if !contradiction.too_large.is_empty() && contradiction.too_small.is_none() {
        let with_all = with_unseen_events(gradient, differences);
        let (explained, left) = compared(&gradient.gradient, &with_all);
        if left.too_large.is_empty() {
            let doubt = format!(
                "{}; events that the differences did not see may explain it",
                contradiction.too_large.join("; ")
            );
            comparison.verdict = doubtful(explained.verdict, doubt);
        }
    }
    comparison
}

/// The differences with the errors that they have if the gradient is right: with those of the
/// events that a pixel has not met and would have met on average.
fn with_unseen_events(gradient: &GradientImage, differences: &GradientImage) -> Estimate {
    let mut estimate = differences.gradient.clone();
    let samples = &differences.statistics.samples_per_pixel;
    let sizes = event_sizes(&estimate, samples);
    let pixels = estimate.standard_error.pixels.iter_mut().enumerate();
    for (i, error) in pixels {
        let (g, r) = (gradient.gradient.mean.pixels[i], estimate.mean.pixels[i]);
        let of_channel = |c: usize| {
            let (g, r) = (channel(g, c), channel(r, c));
            // Of what is left out of the comparison, nothing.
            let unseen = (g.abs() - r * g.signum()).min(g.abs()).max(0.0);
            let variance = unseen * sizes[c] / f64::from(samples[i]);
            (channel(*error, c).powi(2) + variance).sqrt()
        };
        *error = [0, 1, 2].map(of_channel).into();
    }
    estimate
}

/// By how much an event changes a sample of the differences, in each channel: the mean square of
/// samples over their mean size. Of what changes smoothly this is little more than the size.
fn event_sizes(differences: &Estimate, samples: &[u32]) -> [f64; 3] {
    [0, 1, 2].map(|c| {
        let (mut squares, mut sizes) = (0.0, 0.0);
        let pixels = differences.mean.pixels.iter();
        for ((&mean, &error), &n) in pixels.zip(&differences.standard_error.pixels).zip(samples) {
            let (mean, error) = (channel(mean, c), channel(error, c));
            if mean.is_finite() && error.is_finite() {
                squares += mean * mean + error * error * f64::from(n);
                sizes += mean.abs();
            }
        }
        if sizes > 0.0 { squares / sizes } else { 0.0 }
    })
}

/// The verdict if a right gradient may make as few events as were seen, and they are too few
/// for any other.
fn too_few(gradient: &GradientImage, differences: &GradientImage, span: f64) -> Option<Verdict> {
    let seen = seen(differences, span);
    let expected = expected(gradient, differences, span);
    if seen >= ENOUGH || expected <= 0.0 || at_most(seen, expected) < FALSE_ALARM {
        return None;
    }
    let seen = match seen {
        0 => "no event".into(),
        1 => "an event in one pixel only".into(),
        n => format!("events in {n} pixels only"),
    };
    let about = match expected {
        0.1.. => format!("about {expected:.1}"),
        _ => "less than 0.1".into(),
    };
    // Relative errors of counts fall with their root.
    let needed = (2.0 * EXCLUDED_AT / EXCLUDED_ERROR).powi(2);
    Some(Verdict::Inconclusive {
        samples_factor: (needed / expected).max(2.0),
        doubt: Some(format!(
            "the differences saw {seen}, where a right gradient makes {about}: that \
             is no evidence against it, and takes more samples of the reference or a larger step"
        )),
    })
}

/// How large the samples of each pixel are: the root of their mean square there or in the rest
/// of the image, whichever is larger. An event changes one of them by about as much.
fn sizes(differences: &GradientImage) -> Vec<[f64; 3]> {
    let samples = &differences.statistics.samples_per_pixel;
    // Mean square of the samples of a pixel.
    let square = |i: usize, c: usize| {
        let value = &differences.value;
        let (mean, error) = (value.mean.pixels[i], value.standard_error.pixels[i]);
        let square = channel(mean, c).powi(2) + channel(error, c).powi(2) * f64::from(samples[i]);
        if square.is_finite() { square } else { 0.0 }
    };
    let pixels = || 0..samples.len();
    let of_image = [0, 1, 2].map(|c| {
        let sum: f64 = pixels().map(|i| square(i, c)).sum();
        sum / samples.len() as f64
    });
    let size = |i| [0, 1, 2].map(|c| square(i, c).max(of_image[c]).sqrt());
    pixels().map(size).collect()
}

/// What a derivative of each pixel is in events of the differences, given its size by its mean and
/// error: with a derivative `g`, the samples of a pixel change by `span · g` on average.
fn in_events(
    derivative: &Estimate,
    size_of: impl Fn(f64, f64) -> f64,
    differences: &GradientImage,
    span: f64,
) -> impl Iterator<Item = f64> {
    let samples = differences.statistics.samples_per_pixel.iter();
    let pixels = samples.zip(sizes(differences)).enumerate();
    pixels.map(move |(i, (&samples, size))| {
        let (mean, error) = (
            derivative.mean.pixels[i],
            derivative.standard_error.pixels[i],
        );
        let channels = [0, 1, 2].map(|c| {
            let g = size_of(channel(mean, c).abs(), channel(error, c));
            f64::from(samples) * span * g / size[c]
        });
        // Not a number where nothing is seen and nothing changes, or too few samples were taken.
        let events = channels.into_iter().filter(|events| !events.is_nan());
        events.fold(0.0, f64::max)
    })
}

/// Pixels in which samples of the differences changed by as much as an event does, or a clear
/// part of it: what is not discontinuous changes a little in all of them.
fn seen(differences: &GradientImage, span: f64) -> usize {
    let events = in_events(&differences.gradient, f64::max, differences, span);
    events.filter(|&events| events > PART_OF_EVENT).count()
}

/// Events that differences would see on average if the gradient were right, at least.
fn expected(gradient: &GradientImage, differences: &GradientImage, span: f64) -> f64 {
    // What is certain of the derivative: its noise makes no events.
    let certain = |mean: f64, error: f64| (mean - error).max(0.0);
    in_events(&gradient.gradient, certain, differences, span).sum()
}

/// Probability of at most so many events if so many happen on average.
fn at_most(count: usize, mean: f64) -> f64 {
    if mean.is_infinite() {
        return 0.0;
    }
    let mut term = (-mean).exp();
    let mut sum = term;
    for k in 1..=count {
        term *= mean / k as f64;
        sum += term;
    }
    sum
}
