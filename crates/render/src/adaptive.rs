//! Adaptive sampling: pixels get samples by how noisy they are.
//!
//! The mean of the variances of an image's pixels is smallest, for so much effort in all, if
//! the number of samples of each pixel is in proportion to `√(variance / effort)` of its samples
//! (Neyman 1934). These are known only from samples, and rare events are seen by few. So a pilot
//! takes some of each pixel, and looks at the surroundings of a pixel as well as at itself; and
//! a part of the samples is spread evenly: what the pilot did not see has at most
//! 1 / [`EVEN`] times the variance that it would have.
//!
//! The pilot's random numbers are independent of those of the image. So the numbers of samples
//! know nothing of the samples, and the means stay unbiased.

use capwalk_boundary::Sampler;
use capwalk_scene::Scene;

use crate::options::{RenderOptions, Silent, Watch};
use crate::partial::Partial;
use crate::surroundings::Surroundings;
use crate::tiles::{Averages, PixelSums, SampleCounts};

/// The part of the samples that is spread evenly.
const EVEN: f64 = 0.25;

/// The part of an image's samples that a pilot takes, and the most of each pixel.
const SHARE: u32 = 8;
const MOST: u32 = 32;

/// Makes the random numbers of a pilot independent of those of the image; π.
const PILOT_SEED: u64 = 0x243f_6a88_85a3_08d3;

/// How noisy an image is, as far as a pilot can tell.
pub struct Noise {
    /// `√(mean variance × effort)` if samples go where they are needed.
    pub root: f64,
    /// The effort of one sample of every pixel.
    pub effort_of_spp: f64,
    /// For each pixel, `√(variance / effort)` of its samples.
    wanted: Vec<f64>,
}

/// The noise of an image whose samples give three numbers from `first` on. The pilot's are
/// averaged by `average`, as many of each pixel. `None` if the samples that the options ask for
/// are too few for a pilot.
pub fn noise(
    scene: &Scene,
    options: &RenderOptions,
    watch: &dyn Watch,
    first: usize,
    average: impl FnOnce(&RenderOptions, &dyn Watch) -> Partial<PixelSums>,
) -> Option<Noise> {
    let pilot = RenderOptions {
        spp: (options.spp / SHARE).min(MOST),
        seed: options.seed ^ PILOT_SEED,
        adaptive: false,
        ..*options
    };
    if pilot.spp < 2 * group(scene, &pilot) {
        return None;
    }
    let averages = Averages::new(average(&pilot, &Silent(watch)).into_sums());
    let standard_error = averages.estimate(scene, first).standard_error;
    let around = Surroundings::new(&standard_error);
    let deviation = |x: usize, y: usize| {
        let variance = |c: usize| 0.5 * (around.own(x, y, c) + around.variance(x, y, c));
        let mean: f64 = (0..3).map(variance).sum();
        (mean * f64::from(pilot.spp)).sqrt()
    };
    let (width, height) = (standard_error.width, standard_error.height);
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let efforts: Vec<f64> = averages.efforts().collect();
    let wanted = pixels
        .zip(&efforts)
        .map(|((x, y), e)| deviation(x, y) / e.sqrt());
    let wanted: Vec<f64> = wanted.collect();
    let products: f64 = wanted.iter().zip(&efforts).map(|(n, e)| n * e).sum();
    Some(Noise {
        root: products / (efforts.len() as f64).sqrt(),
        effort_of_spp: efforts.iter().sum(),
        wanted,
    })
}

/// The samples of each pixel of an image like that of [`noise`]: they take about as much effort
/// as `options.spp` of each pixel would. Those, where nothing is adaptive.
pub fn sample_counts(
    scene: &Scene,
    options: &RenderOptions,
    watch: &dyn Watch,
    first: usize,
    average: impl FnOnce(&RenderOptions, &dyn Watch) -> Partial<PixelSums>,
) -> SampleCounts {
    let noise = options
        .adaptive
        .then(|| noise(scene, options, watch, first, average));
    let Some(noise) = noise.flatten().filter(|noise| noise.root > 0.0) else {
        return SampleCounts::Even;
    };
    let products = noise.root * (noise.wanted.len() as f64).sqrt();
    let scale = noise.effort_of_spp / products;
    // Whole groups of samples that belong together, and two of them for a standard error.
    let group = group(scene, options);
    let fewest = options.spp.min(2 * group);
    let count = |wanted: &f64| {
        let rate = EVEN + (1.0 - EVEN) * scale * wanted;
        let groups = (rate * f64::from(options.spp) / f64::from(group)).round() as u32;
        groups.saturating_mul(group).max(fewest)
    };
    SampleCounts::Each(noise.wanted.iter().map(count).collect())
}

/// How many samples of a pixel belong together.
fn group(scene: &Scene, options: &RenderOptions) -> u32 {
    Sampler::new(&scene.settings, options.seed, options.spp).group()
}
