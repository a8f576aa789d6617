//! The loop over pixels and samples where something else than threads of the CPU takes the
//! samples: a device, which needs many at a time.

use capwalk_boundary::Sampler;
use capwalk_scene::Scene;

use crate::options::{RenderOptions, Watch};
use crate::ordered_sum::OrderedSum;
use crate::sample_range::SampleRange;
use crate::tiles::{self, Averages, PixelSums};

/// The averages of the samples that `take` gives for some of them, as many at a time as `most` says
/// each time, in their order: each one's numbers, or `None` if the watch stopped the work before all
/// of them were there. They are added as those of the CPU are, so that equal samples give equal
/// bits, whatever `most` is. Independent numbers only, and as many samples of each pixel as the
/// options say.
pub fn average_on_device<E, const N: usize>(
    scene: &Scene,
    options: &RenderOptions,
    most: impl Fn() -> usize,
    watch: &dyn Watch,
    mut take: impl FnMut(&SampleRange) -> Result<Option<Vec<[f64; N]>>, E>,
) -> Result<Averages, E> {
    let sampler = Sampler::new(&scene.settings, options.seed, options.spp);
    let grid = tiles::grid(scene, options);
    let [width, height] = scene.film.crop_size;
    let pixels_of = |band: u32| {
        let rows = grid.rows(band, height);
        rows.start * width..rows.end * width
    };
    // Of each pixel, its band and its place there.
    let in_band =
        (0..grid.bands).flat_map(|band| pixels_of(band).zip(0..).map(move |(_, i)| (band, i)));
    let in_band: Vec<(u32, usize)> = in_band.collect();
    let pixels = width * height;
    let (mut done, total) = (0, u64::from(pixels) * u64::from(options.spp));
    let mut sums = vec![OrderedSum::default(); grid.bands as usize];
    for batch in 0..grid.batches {
        let samples = grid.samples(batch, options.spp, 1);
        let wanted = samples.len() as u32;
        let band = |band| PixelSums::new(pixels_of(band).map(|_| wanted), N);
        let mut bands: Vec<PixelSums> = (0..grid.bands).map(band).collect();
        // One sample of every pixel, then the next one.
        let [mut at, end] = [samples.start, samples.end].map(|n| u64::from(n) * u64::from(pixels));
        while at < end && !watch.should_stop() {
            let count = (most().max(1) as u64).min(end - at);
            let some = SampleRange::new(sampler, &scene.film, at..at + count);
            let Some(taken) = take(&some)? else {
                break;
            };
            debug_assert_eq!(taken.len(), some.len());
            for (i, sample) in taken.into_iter().enumerate() {
                let [pixel, _] = some.pixel_and_sample(i);
                let (band, pixel) = in_band[pixel as usize];
                bands[band as usize].add_sample(pixel, sample);
            }
            at += count;
            done += some.len() as u64;
            watch.progress(done, total);
        }
        for (sum, band) in sums.iter_mut().zip(bands) {
            sum.insert(batch, band);
        }
    }
    let sums = sums.into_iter().filter_map(OrderedSum::into_sum);
    Ok(Averages::new(sums.collect()))
}
