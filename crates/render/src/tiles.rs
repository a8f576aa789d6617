//! The parallel loop over pixels and samples.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use capwalk_boundary::{PixelStreams, Sampler, Stream, pool};
use capwalk_geometry::effort;
use capwalk_math::Moments;
use capwalk_scene::{Image, Scene};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::estimate::{Estimate, Statistics};
use crate::grid::{Grid, Part};
use crate::options::{RenderOptions, Watch};
use crate::ordered_sum::{Accumulate, OrderedSum};
use crate::partial::{Along, Partial};

/// What one sample of one pixel gives: `C` numbers to be averaged, and what
/// it cost.
#[derive(Clone, Copy, Debug)]
pub struct Sample<const C: usize> {
    /// The numbers.
    pub numbers: [f64; C],
    /// Closest-silhouette queries asked.
    pub cone_queries: u64,
    /// Its effort, in about twenty nanoseconds.
    pub effort: u64,
}

impl<const C: usize> Default for Sample<C> {
    fn default() -> Self {
        Self {
            numbers: [0.0; C],
            cone_queries: 0,
            effort: 0,
        }
    }
}

/// Consecutive samples of a pixel that are to be taken.
#[derive(Clone, Debug)]
pub struct SampleRun {
    /// The column and row of the pixel.
    pub pixel: [u32; 2],
    /// The random numbers of its samples.
    pub streams: PixelStreams,
    /// Which samples.
    pub numbers: Range<u32>,
}

/// How many samples these are.
pub fn count_samples(runs: &[SampleRun]) -> usize {
    runs.iter().map(|run| run.numbers.len()).sum()
}

/// Appends samples of an image of light, in order.
pub type TakeSamples<'a> = dyn Fn(&[SampleRun], &mut Vec<Sample<3>>) + Sync + 'a;

/// Takes samples one after the other, and counts their effort: so much, and that of their queries.
pub fn one_by_one<const C: usize>(
    besides_queries: u64,
    sample: impl Fn([u32; 2], &Stream) -> Sample<C> + Sync,
) -> impl Fn(&[SampleRun], &mut Vec<Sample<C>>) + Sync {
    move |runs, taken| {
        for run in runs {
            taken.extend(run.numbers.clone().map(|number| {
                let before = effort();
                let sample = sample(run.pixel, &run.streams.stream(number));
                Sample {
                    effort: besides_queries + effort().wrapping_sub(before),
                    ..sample
                }
            }));
        }
    }
}

/// Running averages of the pixels of a band, row by row.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct PixelSums {
    /// As many per pixel as a sample has numbers.
    moments: Vec<Moments>,
    /// One per pixel.
    tallies: Vec<Tally>,
}

/// What was done in a pixel.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
struct Tally {
    /// Samples that are to be taken.
    wanted: u32,
    /// Samples that were taken.
    samples: u32,
    non_finite: u32,
    cone_queries: u64,
    /// Effort of its samples.
    effort: u64,
}

impl PixelSums {
    /// Nothing taken yet, of so many samples that are wanted of each pixel.
    pub(crate) fn new(wanted: impl Iterator<Item = u32>, channels: usize) -> Self {
        Self::default().restarted(wanted, channels)
    }

    /// The same in memory that was another's.
    fn restarted(mut self, wanted: impl Iterator<Item = u32>, channels: usize) -> Self {
        self.tallies.clear();
        self.tallies.extend(wanted.map(|wanted| Tally {
            wanted,
            ..Tally::default()
        }));
        self.moments.clear();
        let numbers = self.tallies.len() * channels;
        self.moments.resize(numbers, Moments::default());
        self
    }

    /// Adds a sample of a pixel, the next one, that depends on no other.
    pub(crate) fn add_sample<const C: usize>(&mut self, pixel: usize, numbers: [f64; C]) {
        let tally = &mut self.tallies[pixel];
        tally.samples += 1;
        let numbers = tally.finite(numbers);
        let moments = self.moments[pixel * C..].iter_mut();
        moments.zip(numbers).for_each(|(moments, x)| moments.add(x));
    }
}

/// Numbers of a pixel that follow each other, each the mean of a group of samples: their sums need no
/// division.
#[derive(Clone, Copy)]
struct Run<const C: usize> {
    count: u64,
    /// The first ones.
    from: [f64; C],
    /// Of differences from those, and of their squares.
    sums: [f64; C],
    squares: [f64; C],
    /// A group that is not complete: its samples, and their sum.
    begun: u32,
    sum: [f64; C],
}

impl<const C: usize> Default for Run<C> {
    fn default() -> Self {
        Self {
            count: 0,
            from: [0.0; C],
            sums: [0.0; C],
            squares: [0.0; C],
            begun: 0,
            sum: [0.0; C],
        }
    }
}

impl<const C: usize> Run<C> {
    /// Adds samples, which make groups of so many.
    fn add_samples(&mut self, samples: &[Sample<C>], group: u32, tally: &mut Tally) {
        for sample in samples {
            tally.cone_queries += sample.cone_queries;
            tally.effort += sample.effort;
            let numbers = tally.finite(sample.numbers);
            if group == 1 {
                self.add(numbers);
                continue;
            }
            let sums = self.sum.iter_mut().zip(numbers);
            sums.for_each(|(sum, x)| *sum += x);
            self.begun += 1;
            if self.begun == group {
                self.end_group();
            }
        }
        tally.samples += samples.len() as u32;
    }

    /// Adds the mean of the samples of a group, if there are any.
    fn end_group(&mut self) {
        let (sum, count) = (std::mem::replace(&mut self.sum, [0.0; C]), self.begun);
        self.begun = 0;
        if count > 0 {
            self.add(sum.map(|sum| sum / f64::from(count)));
        }
    }

    #[inline]
    fn add(&mut self, numbers: [f64; C]) {
        if self.count == 0 {
            self.from = numbers;
        }
        self.count += 1;
        for (i, number) in numbers.into_iter().enumerate() {
            let difference = number - self.from[i];
            self.sums[i] += difference;
            self.squares[i] += difference * difference;
        }
    }

    /// Adds the numbers to those of a pixel, and forgets them. What is left of a group goes on: where
    /// groups have several samples, a pass has one of each pixel.
    fn add_to(&mut self, moments: &mut [Moments]) {
        if self.count == 0 {
            return;
        }
        for (i, moments) in moments.iter_mut().enumerate() {
            let Self { count, from, .. } = *self;
            match count {
                1 => moments.add(from[i]),
                _ => moments.merge(&Moments::from_sums(
                    count,
                    from[i],
                    self.sums[i],
                    self.squares[i],
                )),
            }
        }
        debug_assert_eq!(self.begun, 0);
        *self = Self::default();
    }
}

/// True if a sample's numbers can be averaged.
fn is_finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|x| x.abs() <= LARGEST_NUMBER)
}

impl Accumulate for PixelSums {
    fn fits(&self, next: &Self) -> bool {
        (self.moments.len(), self.tallies.len()) == (next.moments.len(), next.tallies.len())
    }

    fn add(&mut self, next: &Self) {
        let moments = self.moments.par_iter_mut().zip(&next.moments);
        let tallies = self.tallies.par_iter_mut().zip(&next.tallies);
        pool::install(|| {
            (moments.with_min_len(MANY)).for_each(|(own, other)| own.merge(other));
            (tallies.with_min_len(MANY)).for_each(|(own, other)| own.add(other));
        });
    }
}

impl Tally {
    /// The numbers of a sample if they can be averaged; else it is counted, and they are zero.
    fn finite<const C: usize>(&mut self, numbers: [f64; C]) -> [f64; C] {
        match is_finite(&numbers) {
            true => numbers,
            false => {
                self.non_finite += 1;
                [0.0; C]
            }
        }
    }

    fn add(&mut self, other: &Self) {
        self.wanted += other.wanted;
        self.samples += other.samples;
        self.non_finite += other.non_finite;
        self.cone_queries += other.cone_queries;
        self.effort += other.effort;
    }
}

/// So many sums are worth a thread's attention.
const MANY: usize = 4096;

/// The largest number of a sample that counts as finite: images are kept in single
/// precision, and the sums of squares of larger ones overflow.
const LARGEST_NUMBER: f64 = f32::MAX as f64;

/// Effort of a sample of an image besides its queries: shading and sampling.
pub const EFFORT_OF_LIGHT: u64 = 10;
/// The same with their derivatives.
pub const EFFORT_OF_DERIVATIVE: u64 = 100;

/// Samples that are taken together: so many that what is set up for them costs little.
const TOGETHER: usize = 256;
/// A task has at least so many pixels, more where each has few samples in a pass.
const LEAST_PIXELS: usize = 16;
/// But for each thread a pass has at least so many tasks, some of which take longer than others.
const TASKS_PER_THREAD: usize = 8;
/// The work is done in at least this many passes over the image, so that it
/// can be stopped with all pixels nearly equally far.
const PASSES: u32 = 32;
/// Samples of a pixel in one pass at most (except for a group), so that it can be
/// stopped at once.
const MOST_PER_PASS: u32 = 32;

/// Which of so many samples are taken; most pixels ask about as many as the one before.
struct Remembered<F> {
    count: u32,
    range: Range<u32>,
    find: F,
}

impl<F: Fn(u32) -> Range<u32>> Remembered<F> {
    fn new(find: F) -> Self {
        Self {
            count: 0,
            range: 0..0,
            find,
        }
    }

    #[inline]
    fn of(&mut self, count: u32) -> Range<u32> {
        if count != self.count {
            (self.count, self.range) = (count, (self.find)(count));
        }
        self.range.clone()
    }
}

/// The cells that the samples of an image are cut into.
pub fn grid(scene: &Scene, options: &RenderOptions) -> Grid {
    let group = Sampler::new(&scene.settings, options.seed, options.spp).group();
    let groups = options.spp.div_ceil(group);
    options.grid.filled(groups, scene.film.crop_size[1])
}

/// How many samples each pixel gets.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SampleCounts {
    /// As many as the options ask for.
    Even,
    /// These, row by row, see [`adaptive`](crate::adaptive).
    Each(Vec<u32>),
}

impl SampleCounts {
    /// The samples of a pixel.
    fn of(&self, pixel: u32, options: &RenderOptions) -> u32 {
        match self {
            Self::Even => options.spp,
            Self::Each(counts) => counts[pixel as usize],
        }
    }

    /// The most that a pixel gets.
    fn most(&self, options: &RenderOptions) -> u32 {
        match self {
            Self::Even => options.spp,
            Self::Each(counts) => counts.iter().copied().max().unwrap_or_default(),
        }
    }
}

/// Averages the samples of the cells of a part, so many of each pixel. `take_some` appends the
/// samples of some runs, in their order, each of which must not depend on the others. The same to
/// the bit for every number of threads and every
/// way to cut the work: each pixel adds the samples of a batch in order, and then the batches.
///
/// `work` is the fingerprint of a work that is cut: then only cells that were finished
/// before the watch stopped are there. Without, all are, with the samples that they have.
pub fn average<const C: usize>(
    scene: &Scene,
    options: &RenderOptions,
    counts: &SampleCounts,
    work: Option<u64>,
    part: &Part,
    watch: &dyn Watch,
    take_some: impl Fn(&[SampleRun], &mut Vec<Sample<C>>) + Sync,
) -> Partial<PixelSums> {
    let sampler = Sampler::new(&scene.settings, options.seed, options.spp);
    let group = sampler.group();
    let [width, height] = scene.film.crop_size;
    let grid = part.grid();
    // A batch is cut into passes over its pixels, the same part of each pixel's samples in each.
    let per_pass = options.spp.div_ceil(PASSES).min(MOST_PER_PASS);
    let longest = counts.most(options).div_ceil(grid.batches);
    let passes = longest.div_ceil(per_pass.next_multiple_of(group)).max(1);
    let pixels_of = |band: u32| {
        let rows = grid.rows(band, height);
        rows.start * width..rows.end * width
    };
    // Those of the pixels, one after the other, in a batch.
    let samples_of = |batch: u32, pixels: Range<u32>| {
        let mut of_batch = Remembered::new(move |count| grid.samples(batch, count, group));
        pixels.map(move |pixel| of_batch.of(counts.of(pixel, options)))
    };
    let count_of = move |batch, pixels| samples_of(batch, pixels).map(|range| range.len() as u32);
    let cells = grid.cells().filter(|&cell| part.contains(cell));
    let total = cells
        .flat_map(|cell| count_of(cell.batch, pixels_of(cell.band)))
        .map(u64::from)
        .sum();
    let done = AtomicU64::new(0);

    // A pass over some pixels, which are consecutive.
    let take =
        |first: u32, [batch, pass]: [u32; 2], moments: &mut [Moments], tallies: &mut [Tally]| {
            if watch.should_stop() {
                return;
            }
            // Samples to be taken together; of each of their runs the pixel, and whether it is the last.
            let mut runs: Vec<SampleRun> = Vec::with_capacity(TOGETHER);
            let mut of: Vec<(usize, bool)> = Vec::with_capacity(TOGETHER);
            let mut taken = Vec::with_capacity(TOGETHER);
            let mut sums = Run::default();
            let pixels = first..first + tallies.len() as u32;
            let (mut waiting, mut work) = (0, 0);
            let mut take_all = |runs: &mut Vec<SampleRun>, of: &mut Vec<(usize, bool)>| {
                taken.clear();
                take_some(runs, &mut taken);
                let mut rest = &taken[..];
                for (run, (i, is_last)) in runs.drain(..).zip(of.drain(..)) {
                    let (samples, others) = rest.split_at(run.numbers.len());
                    rest = others;
                    sums.add_samples(samples, group, &mut tallies[i]);
                    if is_last {
                        sums.end_group();
                    }
                    sums.add_to(&mut moments[i * C..(i + 1) * C]);
                }
                debug_assert!(rest.is_empty());
            };
            let mut parts = Remembered::new(|count| Grid::part(count, group, passes, pass));
            for (i, (pixel, of_batch)) in pixels.clone().zip(samples_of(batch, pixels)).enumerate()
            {
                let of_pass = parts.of(of_batch.len() as u32);
                let end = of_batch.start + of_pass.end;
                let mut next = of_batch.start + of_pass.start;
                work += of_pass.len() as u64;
                let (place, streams) = (
                    [pixel % width, pixel / width],
                    sampler.in_pixel(u64::from(pixel)),
                );
                while next < end {
                    let numbers = next..end.min(next.saturating_add((TOGETHER - waiting) as u32));
                    (next, waiting) = (numbers.end, waiting + numbers.len());
                    of.push((i, next == end));
                    runs.push(SampleRun {
                        pixel: place,
                        streams,
                        numbers,
                    });
                    if waiting == TOGETHER {
                        take_all(&mut runs, &mut of);
                        waiting = 0;
                    }
                }
            }
            take_all(&mut runs, &mut of);
            let before = done.fetch_add(work, Ordering::Relaxed);
            watch.progress(before + work, total);
        };

    let most_pixels = TOGETHER / per_pass.max(1) as usize;
    let mut sums = vec![OrderedSum::default(); grid.bands as usize];
    // Memory that is used again: where pixels have few samples, new memory takes a quarter of the time.
    let mut spare: Vec<PixelSums> = Vec::new();
    pool::install(|| {
        for batch in 0..grid.batches {
            let mut empty = |band: u32| {
                let memory = spare.pop().unwrap_or_default();
                (band, memory.restarted(count_of(batch, pixels_of(band)), C))
            };
            let bands = part.bands_of(batch).into_iter();
            let mut bands: Vec<(u32, PixelSums)> = bands.map(&mut empty).collect();
            let pixels: usize = bands.iter().map(|(_, sums)| sums.tallies.len()).sum();
            let share = pixels / (TASKS_PER_THREAD * rayon::current_num_threads());
            let size = most_pixels.min(share).max(LEAST_PIXELS);
            for pass in 0..passes {
                if watch.should_stop() {
                    break;
                }
                bands.par_iter_mut().for_each(|(band, sums)| {
                    let first = pixels_of(*band).start;
                    let moments = sums.moments.par_chunks_mut(C * size);
                    let chunks = moments.zip(sums.tallies.par_chunks_mut(size));
                    chunks.enumerate().for_each(|(chunk, (moments, tallies))| {
                        let first = first + (chunk * size) as u32;
                        take(first, [batch, pass], moments, tallies);
                    });
                });
            }
            for (band, term) in bands {
                let mut tallies = term.tallies.iter();
                let is_finished = tallies.all(|pixel| pixel.samples == pixel.wanted);
                if work.is_none() || is_finished {
                    sums[band as usize].insert_and_spare(batch, term, &mut spare);
                }
            }
        }
    });
    Partial::new(work.unwrap_or_default(), grid, Along::Batches, sums)
}

impl PixelSums {
    /// True if these are sums for the pixels of a band, with so many numbers for each.
    pub fn is_of(&self, scene: &Scene, grid: Grid, band: u32, channels: usize) -> bool {
        let [width, height] = scene.film.crop_size;
        let pixels = grid.rows(band, height).len() * width as usize;
        self.tallies.len() == pixels && self.moments.len() == pixels * channels
    }
}

/// Averages of all pixels, row by row.
pub struct Averages {
    bands: Vec<PixelSums>,
    channels: usize,
    /// What was done.
    pub statistics: Statistics,
}

impl Averages {
    /// The averages of a complete work, from its bands.
    pub fn new(bands: Vec<PixelSums>) -> Self {
        let tallies = || bands.iter().flat_map(|band| &band.tallies);
        let sum = |of: fn(&Tally) -> u64| tallies().map(of).sum();
        let statistics = Statistics {
            samples_per_pixel: tallies().map(|pixel| pixel.samples).collect(),
            complete: tallies().all(|pixel| pixel.samples == pixel.wanted),
            samples: sum(|pixel| u64::from(pixel.samples)),
            non_finite: sum(|pixel| u64::from(pixel.non_finite)),
            cone_queries: sum(|pixel| pixel.cone_queries),
            effort: sum(|pixel| pixel.effort),
            ..Statistics::default()
        };
        let numbers: usize = bands.iter().map(|band| band.moments.len()).sum();
        Self {
            channels: numbers / statistics.samples_per_pixel.len(),
            bands,
            statistics,
        }
    }

    /// The mean effort of a sample of each pixel, in about twenty nanoseconds.
    pub fn efforts(&self) -> impl Iterator<Item = f64> {
        let tallies = self.bands.iter().flat_map(|band| &band.tallies);
        tallies.map(|pixel| pixel.effort as f64 / f64::from(pixel.samples.max(1)))
    }

    /// Three consecutive numbers as an image with errors.
    pub fn estimate(&self, scene: &Scene, first: usize) -> Estimate {
        self.channels(scene, [first, first + 1, first + 2])
    }

    /// One number as a grey image with errors.
    pub fn grey(&self, scene: &Scene, number: usize) -> Estimate {
        self.channels(scene, [number; 3])
    }

    fn channels(&self, scene: &Scene, numbers: [usize; 3]) -> Estimate {
        let [width, height] = scene.film.crop_size.map(|n| n as usize);
        let pixels = || {
            let bands = self.bands.iter();
            bands.flat_map(|band| band.moments.chunks_exact(self.channels))
        };
        let image = |of: fn(&Moments) -> f64| Image {
            width,
            height,
            pixels: pixels()
                .map(|moments| numbers.map(|number| of(&moments[number])).into())
                .collect(),
        };
        Estimate {
            mean: image(|moments| moments.mean),
            standard_error: image(Moments::standard_error),
        }
    }
}

#[cfg(test)]
mod tests {
    use capwalk_scene::SamplerKind;

    use super::*;
    use crate::options::Unwatched;

    /// Averages of numbers that are no images, against sums over the samples of each pixel: however many
    /// samples are taken together, and where they make groups that are larger than that, or incomplete.
    #[test]
    fn averages_are_those_of_the_samples() {
        let mut scene = capwalk_scene::builtin::scene("leaf").expect("a built-in scene");
        let cases = [
            (SamplerKind::Independent, 1, [31, 5]),
            (SamplerKind::Independent, 77, [3, 7]),
            (SamplerKind::Sobol, 48, [26, 16]),
            (SamplerKind::Sobol, 333, [9, 5]),
            (SamplerKind::Sobol, 9001, [3, 2]),
        ];
        for (kind, spp, size) in cases {
            (scene.film.size, scene.film.crop_size) = (size, size);
            scene.settings.sampler = kind;
            let options = RenderOptions::new(spp, 7);
            let pixels = size[0] * size[1];
            let uneven = (0..pixels).map(|pixel| pixel * 37 % (spp + 1));
            for counts in [SampleCounts::Even, SampleCounts::Each(uneven.collect())] {
                let number = |stream: &Stream| [stream.number(0), 3.0 + stream.number(1)];
                let take = one_by_one(0, |_, stream| Sample {
                    numbers: number(stream),
                    ..Sample::default()
                });
                let grid = grid(&scene, &options);
                let (part, watch) = (Part::whole(grid), &Unwatched);
                let partial = average(&scene, &options, &counts, None, &part, watch, take);
                let bands = partial.into_sums();
                let found: Vec<&[Moments]> = (bands.iter())
                    .flat_map(|band| band.moments.chunks_exact(2))
                    .collect();
                let sampler = Sampler::new(&scene.settings, options.seed, spp);
                let group = sampler.group();
                for (pixel, found) in (0..pixels).zip(found) {
                    let mut expected = [Moments::default(); 2];
                    for batch in 0..grid.batches {
                        let samples = grid.samples(batch, counts.of(pixel, &options), group);
                        let samples: Vec<[f64; 2]> = samples
                            .map(|sample| number(&sampler.stream(u64::from(pixel), sample)))
                            .collect();
                        for of_group in samples.chunks(group as usize) {
                            for (i, expected) in expected.iter_mut().enumerate() {
                                let sum: f64 = of_group.iter().map(|numbers| numbers[i]).sum();
                                expected.add(sum / of_group.len() as f64);
                            }
                        }
                    }
                    for (found, expected) in found.iter().zip(&expected) {
                        let what = format!("{kind:?}, {spp}, {pixel}: {found:?}, {expected:?}");
                        assert_eq!(found.count, expected.count, "{what}");
                        let errors = [
                            found.mean - expected.mean,
                            found.sum_of_squares - expected.sum_of_squares,
                        ];
                        assert!(errors.iter().all(|error| error.abs() < 1e-9), "{what}");
                    }
                }
            }
        }
    }

    /// What is no number that a file can hold.
    const BAD: [[f64; 3]; 3] = [
        [1.0, f64::NAN, 1.0],
        [1.0, f64::NEG_INFINITY, 1.0],
        [1.0, 1.0, -1e39],
    ];

    /// Samples that are not finite, or would not be in single precision, count as zero,
    /// are all counted, and never reach the image.
    #[test]
    fn non_finite_samples_are_counted() {
        let mut scene = capwalk_scene::builtin::scene("leaf").expect("a built-in scene");
        scene.film.size = [8, 6];
        scene.film.crop_size = [8, 6];
        let options = RenderOptions::new(50, 3);
        let count = AtomicU64::new(0);
        let bad = |stream: &Stream| {
            let is_bad = stream.number(0) < 0.1;
            count.fetch_add(is_bad.into(), Ordering::Relaxed);
            is_bad
        };
        let part = Part::whole(grid(&scene, &options));
        let partial = average(
            &scene,
            &options,
            &SampleCounts::Even,
            None,
            &part,
            &Unwatched,
            one_by_one(0, |_, stream| Sample {
                numbers: match bad(stream) {
                    true => BAD[(10.0 * stream.number(1)) as usize % BAD.len()],
                    false => [1.0; 3],
                },
                ..Sample::default()
            }),
        );
        let sums = partial.into_sums();
        let averages = Averages::new(sums);
        let statistics = &averages.statistics;
        let share = statistics.non_finite as f64 / statistics.samples as f64;
        assert_eq!(statistics.samples, 8 * 6 * 50);
        assert!((share - 0.1).abs() < 0.03, "{share}");
        assert_eq!(statistics.non_finite, count.into_inner());
        assert!(statistics.too_many_non_finite() && statistics.complete);
        let image = averages.estimate(&scene, 0).mean;
        for channel in 0..3 {
            let mean = image
                .pixels
                .iter()
                .map(|p| p.to_array()[channel])
                .sum::<f64>()
                / 48.0;
            assert!((mean - (1.0 - share)).abs() < 1e-12, "{channel}: {mean}");
        }
    }
}
