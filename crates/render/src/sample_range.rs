//! Consecutive samples of an image.

use std::ops::Range;

use capwalk_boundary::{Sampler, Stream};
use capwalk_scene::Film;
use rayon::prelude::*;

/// A sample of an image.
#[derive(Clone, Copy, Debug)]
pub struct SamplePlace {
    /// The column and row of its pixel.
    pub pixel: [u32; 2],
    /// Its random numbers.
    pub stream: Stream,
}

/// Some samples of an image, in this order: the first one of every pixel, row by row, then the
/// second one of every pixel, and so on.
#[derive(Clone, Debug)]
pub struct SampleRange {
    sampler: Sampler,
    /// Columns and pixels of the image.
    width: u32,
    pixels: u32,
    /// Which ones: the number of each is that of its pixel, and as many as there are pixels for
    /// each sample before it.
    numbers: Range<u64>,
}

impl SampleRange {
    /// The samples of these numbers.
    pub fn new(sampler: Sampler, film: &Film, numbers: Range<u64>) -> Self {
        let [width, height] = film.crop_size;
        Self {
            sampler,
            width,
            pixels: width * height,
            numbers,
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        (self.numbers.end - self.numbers.start) as usize
    }

    /// True if there are none.
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// What draws them.
    pub fn sampler(&self) -> &Sampler {
        &self.sampler
    }

    /// Some of them.
    pub fn part(&self, part: Range<usize>) -> Self {
        let start = self.numbers.start;
        Self {
            numbers: start + part.start as u64..start + part.end as u64,
            ..self.clone()
        }
    }

    /// The pixel of one, row by row, and which of its samples it is.
    #[inline]
    pub fn pixel_and_sample(&self, index: usize) -> [u32; 2] {
        let (number, pixels) = (self.numbers.start + index as u64, u64::from(self.pixels));
        [number % pixels, number / pixels].map(|number| number as u32)
    }

    /// Where one is taken.
    #[inline]
    pub fn place(&self, index: usize) -> SamplePlace {
        let [pixel, sample] = self.pixel_and_sample(index);
        SamplePlace {
            pixel: [pixel % self.width, pixel / self.width],
            stream: self.sampler.stream(u64::from(pixel), sample),
        }
    }

    /// Where they are taken, in order.
    pub fn places(&self) -> impl IndexedParallelIterator<Item = SamplePlace> {
        (0..self.len())
            .into_par_iter()
            .map(|index| self.place(index))
    }
}

#[cfg(test)]
mod tests {
    use capwalk_scene::{Filter, Integrator, SamplerKind, Settings};

    use super::*;

    /// Also where a part begins and ends within the image.
    #[test]
    fn parts_have_the_samples_of_the_whole() {
        let settings = Settings {
            integrator: Integrator::Direct {
                emitter_samples: 1,
                bsdf_samples: 1,
                hide_emitters: false,
            },
            spp: 4,
            sampler: SamplerKind::Independent,
            seed: 0,
        };
        let sampler = Sampler::new(&settings, 3, 4);
        let film = Film::new(5, 3, Filter::Box);
        let whole = SampleRange::new(sampler, &film, 30..60);
        let part = whole.part(7..20);
        assert_eq!((whole.len(), part.len()), (30, 13));
        assert_eq!(part.pixel_and_sample(0), [7, 2]);
        assert_eq!(part.pixel_and_sample(9), [1, 3]);
        let place = part.place(9);
        assert_eq!(place.pixel, [1, 0]);
        let key = sampler.stream(1, 3).independent_key();
        assert_eq!(place.stream.independent_key(), key);
        let keys = |range: &SampleRange| -> Vec<_> {
            let keys = range.places().map(|place| place.stream.independent_key());
            keys.collect()
        };
        assert_eq!(keys(&whole)[7..20], keys(&part));
    }
}
