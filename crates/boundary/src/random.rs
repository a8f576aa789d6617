//! Random numbers by address: a number is a function of the seed, the pixel,
//! the sample and the dimension, never of a thread or of what was drawn
//! before. So images do not depend on scheduling, and two scenes rendered
//! with the same seed share their numbers (finite differences rely on it).

use std::ops::Range;

use capwalk_scene::{SamplerKind, Settings};

/// How the samples of a pixel are drawn.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    kind: SamplerKind,
    seed: u64,
    /// Samples per independently scrambled batch; 1 for independent numbers.
    group: u32,
}

/// Batches per pixel that the error of Sobol sampling is estimated from.
const SOBOL_BATCHES: u32 = 16;
/// `sobol_burley` has this many dimensions and points; batches stay below.
const SOBOL_DIMENSIONS: u32 = sobol_burley::NUM_DIMENSIONS;
const SOBOL_POINTS: u32 = 1 << 16;

impl Sampler {
    /// The sampler for `spp` samples per pixel.
    pub fn new(settings: &Settings, seed: u64, spp: u32) -> Self {
        let group = match settings.sampler {
            SamplerKind::Independent => 1,
            // Sobol points are well spread in groups of a power of two.
            SamplerKind::Sobol => match (spp / SOBOL_BATCHES).min(SOBOL_POINTS) {
                0 => 1,
                wanted => 1 << wanted.ilog2(),
            },
        };
        Self {
            kind: settings.sampler,
            seed,
            group,
        }
    }

    /// Consecutive samples that are not independent of each other; errors are
    /// estimated from the means of such batches.
    pub fn group(&self) -> u32 {
        self.group
    }

    /// The seed from which a device makes the keys of streams ([`Stream::independent_key`]); `None`
    /// for Sobol's points.
    pub fn independent_seed(&self) -> Option<u64> {
        (self.kind == SamplerKind::Independent).then_some(self.seed)
    }

    /// The numbers of one sample of one pixel.
    #[inline]
    pub fn stream(&self, pixel: u64, sample: u32) -> Stream {
        self.in_pixel(pixel).stream(sample)
    }

    /// Those of the samples of a pixel.
    #[inline]
    pub fn in_pixel(&self, pixel: u64) -> PixelStreams {
        PixelStreams {
            sampler: *self,
            key: mix(self.seed ^ mix(pixel.wrapping_add(GOLDEN))),
        }
    }
}

/// The random numbers of all samples of one pixel.
#[derive(Clone, Copy, Debug)]
pub struct PixelStreams {
    sampler: Sampler,
    key: u64,
}

impl PixelStreams {
    /// Those of a sample.
    #[inline]
    pub fn stream(&self, sample: u32) -> Stream {
        let Sampler { kind, group, .. } = self.sampler;
        let sobol = match kind {
            SamplerKind::Independent => None,
            SamplerKind::Sobol => {
                let batch_key = mix(self.key ^ u64::from(sample / group) ^ (1 << 63));
                Some((sample % group, batch_key as u32))
            }
        };
        Stream {
            key: mix(self.key ^ u64::from(sample).wrapping_mul(GOLDEN)),
            sobol,
        }
    }
}

/// The random numbers of one sample.
#[derive(Clone, Copy, Debug)]
pub struct Stream {
    key: u64,
    /// Index and scramble of the Sobol point, if that is the sampler.
    sobol: Option<(u32, u32)>,
}

impl Stream {
    /// Independent numbers that no sample of any image has: the `number`-th stream of a seed.
    pub fn independent(seed: u64, number: u64) -> Self {
        Self {
            key: mix(seed ^ mix(number.wrapping_add(GOLDEN))),
            sobol: None,
        }
    }

    /// The number of a dimension, uniform in [0, 1).
    #[inline]
    pub fn number(&self, dimension: u32) -> f64 {
        match self.sobol {
            Some(point) if dimension < SOBOL_DIMENSIONS => sobol(point, dimension),
            _ => independent(self.key, dimension),
        }
    }

    /// The key from which a device makes the same numbers; `None` for Sobol's points.
    pub fn independent_key(&self) -> Option<u64> {
        self.sobol.is_none().then_some(self.key)
    }

    /// Independent numbers without end, for what takes a random number of them in
    /// the place of one dimension.
    pub fn branch(&self, dimension: u32) -> Self {
        let key = self
            .key
            .wrapping_add(u64::from(dimension + 1).wrapping_mul(GOLDEN));
        Self {
            key: mix(mix(key) ^ BRANCH),
            sobol: None,
        }
    }

    /// The numbers of a dimension and the next.
    #[inline]
    pub fn pair(&self, dimension: u32) -> [f64; 2] {
        [self.number(dimension), self.number(dimension + 1)]
    }
}

/// The random numbers of several samples that one sampler draws.
#[derive(Clone, Copy, Debug)]
pub struct Streams<const N: usize> {
    keys: [u64; N],
    sobol: Option<[(u32, u32); N]>,
}

impl<const N: usize> Streams<N> {
    /// The same stream in all lanes.
    pub fn splat(stream: Stream) -> Self {
        Self {
            keys: [stream.key; N],
            sobol: stream.sobol.map(|point| [point; N]),
        }
    }

    /// Sets some of them to those of consecutive samples of a pixel, from the first on.
    #[inline]
    pub fn set(&mut self, some: Range<usize>, pixel: &PixelStreams, first: u32) {
        for (i, sample) in some.zip(first..) {
            let stream = pixel.stream(sample);
            self.keys[i] = stream.key;
            debug_assert_eq!(self.sobol.is_some(), stream.sobol.is_some());
            if let (Some(points), Some(point)) = (&mut self.sobol, stream.sobol) {
                points[i] = point;
            }
        }
    }

    /// The number of a dimension in one of them, [`Stream::number`].
    #[inline]
    pub fn number(&self, sample: usize, dimension: u32) -> f64 {
        match self.sobol {
            Some(points) if dimension < SOBOL_DIMENSIONS => sobol(points[sample], dimension),
            _ => independent(self.keys[sample], dimension),
        }
    }

    /// The number of a dimension in each that has its bit in `asked`, [`Stream::number`]; anything
    /// in the others. Independent ones are made in a loop without a branch, of which the compiler
    /// makes vectors; Sobol's one by one.
    #[inline(always)]
    pub fn numbers(&self, dimension: u32, asked: u32) -> [f64; N] {
        match self.sobol {
            Some(points) if dimension < SOBOL_DIMENSIONS => {
                std::array::from_fn(|i| match asked >> i & 1 {
                    1 => sobol(points[i], dimension),
                    _ => 0.0,
                })
            }
            _ => {
                let mut numbers = [0.0; N];
                for (number, key) in numbers.iter_mut().zip(self.keys) {
                    *number = independent(key, dimension);
                }
                numbers
            }
        }
    }

    /// [`Self::numbers`] of a dimension and of the next.
    #[inline(always)]
    pub fn pairs(&self, dimension: u32, asked: u32) -> [[f64; N]; 2] {
        // One after the other: a call of `map` would not be compiled for the same instructions.
        [
            self.numbers(dimension, asked),
            self.numbers(dimension + 1, asked),
        ]
    }
}

/// A coordinate of a Sobol point, given by its index and scramble.
#[inline(never)]
fn sobol((index, seed): (u32, u32), dimension: u32) -> f64 {
    f64::from(sobol_burley::sample(index, dimension, seed))
}

/// A number of a sample by its key.
#[inline(always)]
fn independent(key: u64, dimension: u32) -> f64 {
    let bits = mix(key.wrapping_add(u64::from(dimension + 1).wrapping_mul(GOLDEN)));
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

/// 2^64 over the golden ratio: consecutive multiples are well spread.
pub const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Makes branches differ from the numbers that they grow from; π.
const BRANCH: u64 = 0x243f_6a88_85a3_08d3;

/// The factors of SplitMix.
pub const MIXERS: [u64; 2] = [0xbf58_476d_1ce4_e5b9, 0x94d0_49bb_1331_11eb];

/// A bijection of 64 bits that looks random (the finaliser of SplitMix64,
/// Steele et al. 2014).
#[inline(always)]
fn mix(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(MIXERS[0]);
    x = (x ^ (x >> 27)).wrapping_mul(MIXERS[1]);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_math::Moments;
    use capwalk_scene::Integrator;

    fn settings(sampler: SamplerKind) -> Settings {
        let integrator = Integrator::Direct {
            emitter_samples: 1,
            bsdf_samples: 1,
            hide_emitters: false,
        };
        Settings {
            integrator,
            spp: 1,
            sampler,
            seed: 0,
        }
    }

    /// Means and correlations of neighbouring pixels, samples and dimensions
    /// are those of independent uniform numbers (4.5 σ: one run in 10⁴ for
    /// the dozen numbers tested).
    #[test]
    fn numbers_are_uniform_and_uncorrelated() {
        for kind in [SamplerKind::Independent, SamplerKind::Sobol] {
            // One sample per batch: every stream is scrambled by itself.
            let sampler = Sampler::new(&settings(kind), 5, 1);
            let mut sums = [Moments::default(); 6];
            for pixel in 0..200 {
                for sample in 0..100 {
                    let x = sampler.stream(pixel, sample).number(3) - 0.5;
                    let others = [
                        sampler.stream(pixel + 1, sample).number(3),
                        sampler.stream(pixel, sample + 1).number(3),
                        sampler.stream(pixel, sample).number(4),
                        sampler.stream(pixel, sample).number(300),
                    ];
                    sums[0].add(x);
                    sums[1].add(x * x - 1.0 / 12.0);
                    for (sum, other) in sums[2..].iter_mut().zip(others) {
                        sum.add(x * (other - 0.5));
                    }
                }
            }
            for (i, sum) in sums.iter().enumerate() {
                assert!(
                    sum.mean.abs() < 4.5 * sum.standard_error(),
                    "{kind:?}, statistic {i}: {} ± {}",
                    sum.mean,
                    sum.standard_error()
                );
            }
        }
    }

    /// Several samples have the numbers that each of them has, to the bit.
    #[test]
    fn several_samples_have_the_numbers_of_each() {
        for kind in [SamplerKind::Independent, SamplerKind::Sobol] {
            let sampler = Sampler::new(&settings(kind), 5, 64);
            let all: [Stream; 8] =
                std::array::from_fn(|i| sampler.stream(7 + i as u64 / 3, i as u32));
            let mut streams = Streams::<8>::splat(all[0]);
            for (pixel, some) in [(7, 0..3), (8, 3..6), (9, 6..8)] {
                let first = some.start as u32;
                streams.set(some, &sampler.in_pixel(pixel), first);
            }
            for dimension in [0, 1, 17, SOBOL_DIMENSIONS - 1, SOBOL_DIMENSIONS, 1 << 20] {
                let expected = all.map(|stream| stream.number(dimension));
                assert_eq!(streams.numbers(dimension, 255), expected, "{kind:?}");
                let some = streams.numbers(dimension, 0b0110_0001);
                for i in [0, 5, 6] {
                    assert_eq!(some[i], expected[i], "{kind:?}");
                }
            }
        }
    }

    /// Sobol points integrate a smooth function far better than chance.
    #[test]
    fn sobol_batches_are_low_discrepancy() {
        let error = |kind: SamplerKind| {
            let sampler = Sampler::new(&settings(kind), 1, 16 * 1024);
            let mut sum = 0.0;
            for i in 0..1024 {
                let [x, y] = sampler.stream(0, i).pair(0);
                sum += x * y;
            }
            (sum / 1024.0 - 0.25_f64).abs()
        };
        assert!(error(SamplerKind::Sobol) < 1e-3);
        assert!(error(SamplerKind::Sobol) < error(SamplerKind::Independent));
    }
}
