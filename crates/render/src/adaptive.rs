//! Adaptive sampling: pixels get samples by how noisy they are.
//!
//! The mean of the variances of an image's pixels is smallest, for so much effort in all, if
//! the number of samples of each pixel is in proportion to `√(variance / effort)` of its samples
//! (Neyman 1934). These are known only from samples, and rare events are seen by few. So a pilot
//! takes some of each pixel, and looks at the surroundings of a pixel as well as at itself; and
//! a part of the samples is spread evenly: what the pilot did not see has at most
//! four times the variance that it would have.
//!
//! The pilot's random numbers are independent of those of the image. So the numbers of samples
//! know nothing of the samples, and the means stay unbiased.

use std::sync::OnceLock;

use capwalk_boundary::Sampler;
use capwalk_scene::Scene;

use crate::options::{RenderOptions, Silent, Watch};
use crate::partial::Partial;
use crate::surroundings::Surroundings;
use crate::tiles::{Averages, PixelSums, SampleCounts};

/// The part of the samples that is spread evenly.
const EVEN: f64 = 0.25;

/// More samples of a pixel than anyone waits for.
const MOST_COUNTED: f64 = 4e9;

/// The part of an image's samples that a pilot takes, and the most of each pixel.
const SHARE: u32 = 8;
const MOST: u32 = 256;

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

impl Noise {
    /// The samples of each pixel that take as much effort as `options.spp` of each would.
    pub fn counts(&self, scene: &Scene, options: &RenderOptions) -> SampleCounts {
        let products = self.root * (self.wanted.len() as f64).sqrt();
        let scale = self.effort_of_spp / products;
        // Whole groups of samples that belong together, and two of them for a standard error.
        let group = group(scene, options);
        let fewest = options.spp.min(2 * group);
        let rate = |wanted: &f64| EVEN + (1.0 - EVEN) * scale * wanted;
        // Nobody gets so many samples that they cannot be counted.
        let highest = self.wanted.iter().map(rate).fold(0.0, f64::max);
        let spp = f64::from(options.spp).min(MOST_COUNTED / highest);
        let count = |wanted: &f64| {
            let groups = (rate(wanted) * spp / f64::from(group)).round() as u32;
            groups.saturating_mul(group).max(fewest)
        };
        SampleCounts::Each(self.wanted.iter().map(count).collect())
    }
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
/// as `options.spp` of each pixel would. Those, where nothing is adaptive. `known` keeps what is
/// found, unless the watch stopped the pilot: then it says nothing.
pub fn sample_counts(
    known: &OnceLock<SampleCounts>,
    scene: &Scene,
    options: &RenderOptions,
    watch: &dyn Watch,
    first: usize,
    average: impl FnOnce(&RenderOptions, &dyn Watch) -> Partial<PixelSums>,
) -> SampleCounts {
    if let Some(known) = known.get() {
        return known.clone();
    }
    let noise = match options.adaptive {
        true => noise(scene, options, watch, first, average),
        false => None,
    };
    let noise = noise.filter(|noise| noise.root > 0.0);
    let found = noise.map_or(SampleCounts::Even, |noise| noise.counts(scene, options));
    match watch.should_stop() {
        true => found,
        false => known.get_or_init(|| found).clone(),
    }
}

/// How many samples of a pixel belong together.
fn group(scene: &Scene, options: &RenderOptions) -> u32 {
    Sampler::new(&scene.settings, options.seed, options.spp).group()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use capwalk_boundary::Stream;
    use capwalk_scene::SamplerKind;

    use super::*;
    use crate::grid::Part;
    use crate::options::Unwatched;
    use crate::tiles::{self, EFFORT_OF_DERIVATIVE, Sample};

    /// Samples of rare events, rarer from pixel to pixel: their mean is 1.
    fn event(pixel: [u32; 2], stream: &Stream) -> Sample<3> {
        let probability = 0.5 / f64::from(1 + pixel[0]);
        let number = match stream.number(0) < probability {
            true => 1.0 / probability,
            false => 0.0,
        };
        Sample {
            numbers: [number; 3],
            ..Sample::default()
        }
    }

    /// The scene with 8 × 6 pixels.
    fn scene(sampler: SamplerKind) -> Scene {
        let mut scene = capwalk_scene::builtin::scene("leaf").expect("built in");
        (scene.film.size, scene.film.crop_size) = ([8, 6], [8, 6]);
        scene.settings.sampler = sampler;
        scene
    }

    fn averages(scene: &Scene, options: &RenderOptions) -> (SampleCounts, Averages) {
        let average = |options: &RenderOptions, counts: &SampleCounts| {
            let part = Part::whole(tiles::grid(scene, options));
            let take = tiles::one_by_one(EFFORT_OF_DERIVATIVE, event);
            tiles::average(scene, options, counts, None, &part, &Unwatched, take)
        };
        let known = OnceLock::new();
        let counts = sample_counts(&known, scene, options, &Unwatched, 0, |pilot, _| {
            average(pilot, &SampleCounts::Even)
        });
        let sums = average(options, &counts).into_sums();
        (counts, Averages::new(sums))
    }

    /// Over many images, the mean is right within its error, as few samples as there are: numbers
    /// of samples that knew the samples would make it too small.
    #[test]
    fn means_are_unbiased() {
        for sampler in [SamplerKind::Independent, SamplerKind::Sobol] {
            let scene = Arc::new(scene(sampler));
            let mut moments = capwalk_math::Moments::default();
            for seed in 0..4000 {
                let options = RenderOptions {
                    adaptive: true,
                    ..RenderOptions::new(24, seed)
                };
                let (counts, averages) = averages(&scene, &options);
                assert!(matches!(counts, SampleCounts::Each(_)));
                let pixels = averages.estimate(&scene, 0).mean.pixels;
                moments.add(pixels.iter().map(|p| p.r).sum::<f64>() / pixels.len() as f64);
            }
            let z = (moments.mean - 1.0) / moments.standard_error();
            assert!(z.abs() < 4.0, "{sampler:?}: {} is off by {z}", moments.mean);
        }
    }

    /// Noisy pixels get more samples than others, all of them some, and all together what was
    /// asked for. Few samples are spread evenly.
    #[test]
    fn counts_follow_the_noise() {
        let scene = scene(SamplerKind::Independent);
        let with = |spp| RenderOptions {
            adaptive: true,
            ..RenderOptions::new(spp, 3)
        };
        let (counts, averages) = averages(&scene, &with(256));
        let SampleCounts::Each(counts) = counts else {
            panic!("nothing was adapted");
        };
        let row = |x: usize| (0..6).map(|y| counts[8 * y + x]).sum::<u32>() / 6;
        assert!(row(7) > row(0) * 3 / 2, "{counts:?}");
        assert!(counts.iter().all(|&n| f64::from(n) >= EVEN * 256.0));
        let mean = f64::from(counts.iter().sum::<u32>()) / 48.0;
        assert!((mean / 256.0 - 1.0).abs() < 0.01, "{mean}");
        assert_eq!(averages.statistics.samples_per_pixel, counts);
        assert!(averages.statistics.complete);
        assert_eq!(self::averages(&scene, &with(8)).0, SampleCounts::Even);
    }
}
