//! Sums in fixed point, which are the same in every order: `sums.slang` adds them up.

use std::collections::BTreeSet;

use capwalk_diff::Wanted;
use capwalk_geometry::buffers::NONE;
use capwalk_scene::{
    EmitterVectors, Gradient, Image, Scene, SensorVectors, ShapeVectors, TextureId,
};

use crate::texture_records::Shown;

/// Words before the sums: how many derivatives were too large, and how many not finite.
const COUNTS: usize = 2;

/// Derivatives that are as large as expected have so many binary digits. Those with six more have
/// room in a sum (`LARGEST_DERIVATIVE`).
const DIGITS: i32 = 32;

/// If any is larger, units are larger by so many binary digits, and everything is done again.
const FEWER_DIGITS: i32 = 10;

/// The derivatives by the texels that are asked for.
#[derive(Debug)]
pub struct TexelSums {
    textures: Vec<TextureSums>,
    /// How many sums there are.
    pub count: usize,
}

/// Those of one record of a texture.
#[derive(Clone, Copy, Debug)]
struct TextureSums {
    shown: Shown,
    /// The first sum, if any is asked for.
    first: Option<usize>,
    /// A unit is two to minus this.
    digits: i32,
}

/// What a part of the work adds.
#[derive(Debug)]
pub struct PartSums {
    /// In units.
    pub sums: Vec<i64>,
    /// Derivatives that were left out because they are too large for a sum.
    pub too_large: u32,
    /// Derivatives that were left out because they are infinite or NaN.
    pub non_finite: u32,
}

impl TexelSums {
    /// Those that are wanted of these textures. Units are chosen by what derivatives are expected:
    /// as large as that of the loss by light, times the light for what does not emit.
    pub fn new(scene: &Scene, shown: &[Shown], wanted: &Wanted, adjoint: &Image) -> Self {
        let emitting = radiances(scene);
        let texels = emitting.iter().flat_map(|&id| &scene.texture(id).data);
        let brightest = texels.fold(0.0_f64, |most, x| most.max(x.abs()));
        let pixels = adjoint.pixels.iter().flat_map(|pixel| pixel.to_array());
        let steepest = pixels.fold(0.0_f64, |most, x| most.max(x.abs()));
        let mut count = 0;
        let textures = shown.iter().map(|&shown| {
            let id = shown.numbers;
            let is_wanted = wanted.textures[id.0 as usize];
            let first = is_wanted.then_some(count);
            if is_wanted {
                count += scene.texture(id).data.len();
            }
            let expected = match emitting.contains(&id) {
                true => steepest,
                false => steepest * brightest,
            };
            // Units that single precision has, whatever is expected.
            let exponent = expected.log2().ceil().clamp(-60.0, 120.0);
            let digits = DIGITS
                - if exponent.is_nan() {
                    0
                } else {
                    exponent as i32
                };
            TextureSums {
                shown,
                first,
                digits,
            }
        });
        let textures = textures.collect();
        Self { textures, count }
    }

    /// The words of the sums on the device.
    pub fn words(&self) -> usize {
        COUNTS + 2 * self.count
    }

    /// Where the sums of each texture are and how many units are one, as `colours.slang` reads it.
    pub fn changes(&self) -> Vec<u32> {
        let of = |texture: &TextureSums| {
            let first = texture.first.map_or(NONE, |first| first as u32);
            [first, 2_f32.powi(texture.digits).to_bits()]
        };
        self.textures.iter().flat_map(of).collect()
    }

    /// Makes room for derivatives that were too large.
    pub fn widen(&mut self) {
        for texture in &mut self.textures {
            texture.digits -= FEWER_DIGITS;
        }
    }

    /// What the words of a device say.
    pub fn read(&self, words: &[u32]) -> PartSums {
        let (counts, sums) = words.split_at(COUNTS);
        let sums = sums.as_chunks::<2>().0.iter();
        let sum = |&[low, high]: &[u32; 2]| (u64::from(high) << 32 | u64::from(low)) as i64;
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
            let unit = texture.shown.scale * 2_f64.powi(-texture.digits) / times;
            for (number, &sum) in numbers.iter_mut().zip(&sums[first..]) {
                *number += sum as f64 * unit;
            }
        }
        let shapes: Vec<Option<ShapeVectors>> = vec![None; scene.shapes.len()];
        let emitters = vec![EmitterVectors::default(); scene.emitters.len()];
        Gradient::new(shapes, data, emitters, SensorVectors::default())
    }
}

/// The textures whose numbers are radiances.
fn radiances(scene: &Scene) -> BTreeSet<TextureId> {
    let of = |emitter: &capwalk_scene::Emitter| {
        let radiance = emitter.radiance();
        let shape = emitter.shape().map(|shape| scene.shape(shape));
        shape.map_or(radiance, |shape| scene.numbers_of(radiance, shape))
    };
    scene.emitters.iter().map(of).collect()
}
