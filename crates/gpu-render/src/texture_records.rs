//! Textures as the kernels read them: `layout.rs` says which word is what.

use std::collections::BTreeMap;

use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::{Pattern, Scene, Shape, Texture, TextureId};

use crate::layout::texture::*;
use crate::layout::texture_kind::*;
use crate::layout::wrap::*;

/// The records of textures, once for all shapes that show the same.
#[derive(Default)]
pub struct TextureRecords {
    /// Where they start, by what a material names and what the numbers are.
    places: BTreeMap<(u32, u32), u32>,
    /// What each has, in their order.
    pub shown: Vec<Shown>,
}

/// What a record of a texture has.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Whose numbers they are, all or only those of the first texel.
    pub numbers: TextureId,
    /// By what they are multiplied.
    pub scale: f64,
}

impl TextureRecords {
    /// Where the record of a texture starts as a shape shows it (none for the environment), which is
    /// appended if it is not there.
    pub fn add(
        &mut self,
        scene: &Scene,
        id: TextureId,
        shape: Option<&Shape>,
        words: &mut Vec<u32>,
    ) -> u32 {
        let numbers = shape.map_or(id, |shape| scene.numbers_of(id, shape));
        // The environment has one colour, that of the first texel.
        let is_shown = shape.is_some();
        let key = (id.0, if is_shown { numbers.0 } else { u32::MAX });
        *self.places.entry(key).or_insert_with(|| {
            let scale = match &scene.texture(id).pattern {
                Pattern::MeshAttribute { scale, .. } => *scale,
                _ => 1.0,
            };
            let number = self.shown.len() as u32;
            self.shown.push(Shown { numbers, scale });
            add_texture(scene.texture(numbers), scale, is_shown, number, words)
        })
    }
}

/// Appends a record of this number, and returns where it starts.
fn add_texture(
    texture: &Texture,
    scale: f64,
    is_shown: bool,
    number: u32,
    words: &mut Vec<u32>,
) -> u32 {
    let at = words.len() as u32;
    let plain = Bitmap {
        width: 1,
        height: 1,
        filter: TexelFilter::Nearest,
        wrap: Wrap::Repeat,
        to_uv: UvTransform::IDENTITY,
    };
    let (kind, bitmap) = match &texture.pattern {
        _ if !is_shown => (CONSTANT, plain),
        // An attribute is one of the last two; no shape has the texels of the environment.
        Pattern::Constant | Pattern::MeshAttribute { .. } | Pattern::Environment => {
            (CONSTANT, plain)
        }
        Pattern::Bitmap(bitmap) => (BITMAP, bitmap.clone()),
        Pattern::Checkerboard { to_uv } => (
            CHECKERBOARD,
            Bitmap {
                to_uv: *to_uv,
                ..plain
            },
        ),
        Pattern::PerVertex => (PER_VERTEX, plain),
        Pattern::PerFace => (PER_FACE, plain),
    };
    let wrap = match bitmap.wrap {
        Wrap::Repeat => REPEAT,
        Wrap::Mirror => MIRROR,
        Wrap::Clamp => CLAMP,
    };
    let is_bilinear = bitmap.filter == TexelFilter::Bilinear;
    let mut head = [0; TEXELS];
    head[0] = kind as u32;
    head[CHANNELS] = texture.channels as u32;
    head[WIDTH] = bitmap.width;
    head[HEIGHT] = bitmap.height;
    head[IS_BILINEAR] = is_bilinear.into();
    head[WRAP] = wrap as u32;
    let to_uv = bitmap.to_uv.rows.as_flattened();
    for (place, &factor) in to_uv.iter().enumerate() {
        let at = TO_UV + 2 * place;
        head[at..at + 2].copy_from_slice(&two_floats(factor));
    }
    head[NUMBER] = number;
    words.extend(head);
    words.extend(texture.data.iter().map(|x| float(scale * x)));
    at
}

/// A number as the kernels read it, rounded to single precision.
pub fn float(x: f64) -> u32 {
    (x as f32).to_bits()
}

/// The number in single precision, and the rest, as words.
pub fn two_floats(x: f64) -> [u32; 2] {
    let rounded = f64::from(x as f32);
    [rounded, x - rounded].map(float)
}
