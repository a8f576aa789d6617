//! The parallel loop over pixels and samples.

use capwalk_boundary::{Sampler, Stream, pool};
use capwalk_math::Moments;
use capwalk_scene::{Image, Scene};
use rayon::prelude::*;

use crate::estimate::{Estimate, Statistics};
use crate::options::{RenderOptions, Watch};

/// What one sample of one pixel gives: `C` numbers to be averaged, and what
/// it cost.
#[derive(Clone, Copy, Debug)]
pub struct Sample<const C: usize> {
    /// The numbers.
    pub numbers: [f64; C],
    /// Closest-silhouette queries asked.
    pub cone_queries: u64,
    /// Specular events behind which outlines can move.
    pub uncovered: u64,
}

/// Averages of all pixels, row by row.
pub struct Averages<const C: usize> {
    pixels: Vec<Accumulator<C>>,
    /// What was done.
    pub statistics: Statistics,
}

/// The running averages of a pixel.
#[derive(Clone)]
struct Accumulator<const C: usize> {
    moments: [Moments; C],
    /// Sum over the batch that is not complete yet.
    batch: [f64; C],
    in_batch: u32,
    samples: u32,
    non_finite: u32,
    cone_queries: u64,
    uncovered: u64,
}

/// Pixels that a worker takes at a time.
const CHUNK: usize = 16;
/// The work is done in at least this many passes over the picture, so that it
/// can be stopped with all pixels nearly equally far.
const PASSES: u32 = 32;
/// Samples of a pixel in one pass at most (except for a whole batch), so that
/// it can be stopped at once.
const MOST_PER_PASS: u32 = 32;

/// Averages `options.spp` samples of every pixel. `sample(pixel, stream)` gets
/// the pixel's column and row. The same to the bit for every number of
/// threads: each pixel adds its samples in order.
pub fn average<const C: usize>(
    scene: &Scene,
    options: &RenderOptions,
    watch: &dyn Watch,
    sample: impl Fn([u32; 2], &Stream) -> Sample<C> + Sync,
) -> Averages<C> {
    let sampler = Sampler::new(&scene.settings, options.seed, options.spp);
    let batch = sampler.batch();
    let width = scene.film.crop_size[0];
    let empty = Accumulator {
        moments: [Moments::default(); C],
        batch: [0.0; C],
        in_batch: 0,
        samples: 0,
        non_finite: 0,
        cone_queries: 0,
        uncovered: 0,
    };
    let mut pixels = vec![empty; scene.film.pixel_count()];
    let total = pixels.len() as u64 * u64::from(options.spp);
    let done = std::sync::atomic::AtomicU64::new(0);
    let per_pass = options.spp.div_ceil(PASSES).min(MOST_PER_PASS);
    let per_pass = per_pass.next_multiple_of(batch);

    let mut run = || {
        let mut first = 0;
        while first < options.spp && !watch.should_stop() {
            let last = first.saturating_add(per_pass).min(options.spp);
            let chunks = pixels.par_chunks_mut(CHUNK).enumerate();
            chunks.for_each(|(chunk, pixels)| {
                if watch.should_stop() {
                    return;
                }
                for (i, pixel) in pixels.iter_mut().enumerate() {
                    let index = (chunk * CHUNK + i) as u32;
                    let position = [index % width, index / width];
                    for number in first..last {
                        let stream = sampler.stream(u64::from(index), number);
                        pixel.add(sample(position, &stream), batch);
                    }
                }
                let work = pixels.len() as u64 * u64::from(last - first);
                let before = done.fetch_add(work, std::sync::atomic::Ordering::Relaxed);
                watch.progress(before + work, total);
            });
            first = last;
        }
    };
    pool::install(&mut run);

    pixels.iter_mut().for_each(Accumulator::finish_batch);
    let sum = |of: fn(&Accumulator<C>) -> u64| pixels.iter().map(of).sum();
    let statistics = Statistics {
        samples_per_pixel: pixels.iter().map(|pixel| pixel.samples).collect(),
        complete: pixels.iter().all(|pixel| pixel.samples == options.spp),
        samples: sum(|pixel| u64::from(pixel.samples)),
        non_finite: sum(|pixel| u64::from(pixel.non_finite)),
        cone_queries: sum(|pixel| pixel.cone_queries),
        uncovered: sum(|pixel| pixel.uncovered),
    };
    Averages { pixels, statistics }
}

impl<const C: usize> Accumulator<C> {
    fn add(&mut self, sample: Sample<C>, batch: u32) {
        self.samples += 1;
        self.cone_queries += sample.cone_queries;
        self.uncovered += sample.uncovered;
        if sample.numbers.iter().all(|x| x.is_finite()) {
            for (sum, x) in self.batch.iter_mut().zip(sample.numbers) {
                *sum += x;
            }
        } else {
            self.non_finite += 1;
        }
        self.in_batch += 1;
        if self.in_batch == batch {
            self.finish_batch();
        }
    }

    /// Averages what the batch has, which at the end may be less than a whole
    /// one.
    fn finish_batch(&mut self) {
        if self.in_batch == 0 {
            return;
        }
        for (moments, sum) in self.moments.iter_mut().zip(&mut self.batch) {
            moments.add(*sum / f64::from(self.in_batch));
            *sum = 0.0;
        }
        self.in_batch = 0;
    }
}

impl<const C: usize> Averages<C> {
    /// Three consecutive numbers as a picture with errors.
    pub fn estimate(&self, scene: &Scene, first: usize) -> Estimate {
        let [width, height] = scene.film.crop_size.map(|n| n as usize);
        let picture = |of: fn(&Moments) -> f64| Image {
            width,
            height,
            pixels: self
                .pixels
                .iter()
                .map(|pixel| {
                    [0, 1, 2]
                        .map(|channel| of(&pixel.moments[first + channel]))
                        .into()
                })
                .collect(),
        };
        Estimate {
            mean: picture(|moments| moments.mean),
            standard_error: picture(Moments::standard_error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::Unwatched;

    /// Samples that are not finite count as zero, are all counted, and never
    /// reach the picture.
    #[test]
    fn non_finite_samples_are_counted() {
        let mut scene = capwalk_scene::builtin::scene("leaf").expect("a built-in scene");
        scene.film.size = [8, 6];
        scene.film.crop_size = [8, 6];
        let options = RenderOptions { spp: 50, seed: 3 };
        let bad = |stream: &Stream| stream.number(0) < 0.1;
        let averages = average(&scene, &options, &Unwatched, |_, stream| Sample {
            numbers: match bad(stream) {
                true => [1.0, f64::NAN, f64::INFINITY],
                false => [1.0; 3],
            },
            cone_queries: 0,
            uncovered: 0,
        });
        let statistics = &averages.statistics;
        let share = statistics.non_finite as f64 / statistics.samples as f64;
        assert_eq!(statistics.samples, 8 * 6 * 50);
        assert!((share - 0.1).abs() < 0.03, "{share}");
        assert!(statistics.too_many_non_finite() && statistics.complete);
        let picture = averages.estimate(&scene, 0).mean;
        assert!(picture.pixels.iter().all(|pixel| pixel.is_finite()));
        let mean = picture.pixels.iter().map(|pixel| pixel.r).sum::<f64>() / 48.0;
        assert!((mean - (1.0 - share)).abs() < 1e-12, "{mean}");
    }
}
