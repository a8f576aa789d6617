//! Sums in fixed point, which are the same in every order: `sums.slang` adds them up.

use capwalk_diff::Wanted;
use capwalk_geometry::buffers::NONE;
use capwalk_scene::{
    Emitter, EmitterVectors, Gradient, Pattern, Scene, SensorVectors, ShapeVectors,
};

use crate::texture_records::Shown;

/// Words before the sums: how many derivatives were too large, and how many not finite.
const COUNTS: usize = 2;

/// Words of a sum.
const WORDS: usize = 4;

/// Derivatives that are as large as expected have so many binary digits. Those with six more have
/// room in a sum (`LARGEST_DERIVATIVE`).
const DIGITS: i32 = 80;

/// If any is larger, units are larger by so many binary digits, and everything is done again.
const FEWER_DIGITS: i32 = 20;

/// The derivatives with respect to the texels that are asked for.
#[derive(Debug)]
pub struct TexelSums {
    textures: Vec<TextureSums>,
    /// How many sums there are.
    pub count: usize,
    /// A unit is two to minus this.
    digits: i32,
}

/// Those of one record of a texture.
#[derive(Clone, Copy, Debug)]
struct TextureSums {
    shown: Shown,
    /// The first sum, if any is asked for.
    first: Option<usize>,
}

/// What a part of the work adds.
#[derive(Debug)]
pub struct PartSums {
    /// In units.
    pub sums: Vec<i128>,
    /// Derivatives that were left out because they are too large for a sum.
    pub too_large: u32,
    /// Derivatives that were left out because they are infinite or NaN.
    pub non_finite: u32,
}

impl TexelSums {
    /// Those that are wanted of these textures, of a loss whose derivatives with respect to pixels
    /// are near one at most. Units are chosen by what derivatives are expected: as large as that,
    /// times the brightest radiance if that is above one.
    pub fn new(scene: &Scene, shown: &[Shown], wanted: &Wanted) -> Self {
        let brightness: f64 = scene
            .emitters
            .iter()
            .map(|e| brightest(scene, e))
            .fold(0.0, f64::max);
        let mut count = 0;
        let textures = shown.iter().map(|&shown| {
            let id = shown.numbers;
            let is_wanted = wanted.textures[id.0 as usize];
            let first = is_wanted.then_some(count);
            if is_wanted {
                count += scene.texture(id).data.len();
            }
            TextureSums { shown, first }
        });
        let textures = textures.collect();
        // Units that single precision has, whatever is expected.
        let exponent = brightness.max(1.0).log2().ceil().clamp(0.0, 120.0);
        Self {
            textures,
            count,
            digits: DIGITS - exponent as i32,
        }
    }

    /// The words of the sums on the device.
    pub fn words(&self) -> usize {
        COUNTS + WORDS * self.count
    }

    /// Where the sums of each texture are and how many units are one, as `colours.slang` reads it.
    pub fn changes(&self) -> Vec<u32> {
        let of = |texture: &TextureSums| {
            let first = texture.first.map_or(NONE, |first| first as u32);
            [first, 2_f32.powi(self.digits).to_bits()]
        };
        self.textures.iter().flat_map(of).collect()
    }

    /// Makes room for derivatives that were too large.
    pub fn widen(&mut self) {
        self.digits -= FEWER_DIGITS;
    }

    /// What the words of a device say.
    pub fn read(&self, words: &[u32]) -> PartSums {
        let (counts, sums) = words.split_at(COUNTS);
        let sums = sums.as_chunks::<WORDS>().0.iter();
        let sum = |words: &[u32; WORDS]| {
            let from_highest = words.iter().rev();
            from_highest.fold(0, |sum: u128, &word| sum << 32 | u128::from(word)) as i128
        };
        PartSums {
            sums: sums.map(sum).collect(),
            too_large: counts[0],
            non_finite: counts[1],
        }
    }

    /// The gradient that these sums are so many times.
    pub fn gradient(&self, scene: &Scene, wanted: &Wanted, sums: &[i128], times: f64) -> Gradient {
        let data = scene.textures.iter().zip(&wanted.textures);
        let data = data.map(|(texture, &wanted)| wanted.then(|| vec![0.0; texture.data.len()]));
        let mut data: Vec<Option<Vec<f64>>> = data.collect();
        for texture in &self.textures {
            let (Some(first), Some(numbers)) =
                (texture.first, &mut data[texture.shown.numbers.0 as usize])
            else {
                continue;
            };
            let unit = texture.shown.scale * 2_f64.powi(-self.digits) / times;
            for (number, &sum) in numbers.iter_mut().zip(&sums[first..]) {
                *number += sum as f64 * unit;
            }
        }
        let shapes: Vec<Option<ShapeVectors>> = vec![None; scene.shapes.len()];
        let emitters = vec![EmitterVectors::default(); scene.emitters.len()];
        Gradient::new(shapes, data, emitters, SensorVectors::default())
    }
}

/// The largest radiance of an emitter.
fn brightest(scene: &Scene, emitter: &Emitter) -> f64 {
    let shape = emitter.shape().map(|shape| scene.shape(shape));
    let radiance = emitter.radiance();
    let numbers = shape.map_or(radiance, |shape| scene.numbers_of(radiance, shape));
    let largest = |id| {
        let data: &[f64] = &scene.texture(id).data;
        data.iter().fold(0.0_f64, |most, x| most.max(x.abs()))
    };
    let scale = match &scene.texture(radiance).pattern {
        Pattern::MeshAttribute { scale, .. } => scale.abs(),
        _ => emitter.factor().map_or(1.0, largest),
    };
    largest(numbers) * scale
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Words of 128 bits, the lowest first, with their sign.
    #[test]
    fn sums_are_read_with_their_sign() {
        let none = TexelSums {
            textures: Vec::new(),
            count: 2,
            digits: 0,
        };
        let minus_three = [u32::MAX - 2, u32::MAX, u32::MAX, u32::MAX];
        let large = [5, 0, 7, 0];
        let words = [&[4, 9][..], &minus_three, &large].concat();
        assert_eq!(words.len(), none.words());
        let read = none.read(&words);
        assert_eq!(read.sums, [-3, (7 << 64) + 5]);
        assert_eq!((read.too_large, read.non_finite), (4, 9));
    }
}
