//! Textures as the kernels read them: `surfaces.slang` says which word is what.

use capwalk_scene::texture::{Bitmap, TexelFilter, UvTransform, Wrap};
use capwalk_scene::{Pattern, Scene, Shape, Texture, TextureId};

/// Appends the record of a texture as a shape shows it (none for the environment), and returns
/// where it starts.
pub fn add_texture(
    scene: &Scene,
    id: TextureId,
    shape: Option<&Shape>,
    words: &mut Vec<u32>,
) -> u32 {
    let at = words.len() as u32;
    let scale = match &scene.texture(id).pattern {
        Pattern::MeshAttribute { scale, .. } => *scale,
        _ => 1.0,
    };
    let texture = scene.texture(shape.map_or(id, |shape| scene.numbers_of(id, shape)));
    let plain = Bitmap {
        width: 1,
        height: 1,
        filter: TexelFilter::Nearest,
        wrap: Wrap::Repeat,
        to_uv: UvTransform::IDENTITY,
    };
    let (kind, bitmap) = match &texture.pattern {
        // An attribute is one of the last two; no shape has the texels of the environment.
        Pattern::Constant | Pattern::MeshAttribute { .. } | Pattern::Environment => (0, plain),
        Pattern::Bitmap(bitmap) => (1, bitmap.clone()),
        Pattern::Checkerboard { to_uv } => (
            2,
            Bitmap {
                to_uv: *to_uv,
                ..plain
            },
        ),
        Pattern::PerVertex => (3, plain),
        Pattern::PerFace => (4, plain),
    };
    let wrap = match bitmap.wrap {
        Wrap::Repeat => 0,
        Wrap::Mirror => 1,
        Wrap::Clamp => 2,
    };
    let is_bilinear = bitmap.filter == TexelFilter::Bilinear;
    words.extend([kind, channels(texture), float(scale)]);
    words.extend([bitmap.width, bitmap.height, is_bilinear.into(), wrap]);
    words.extend(bitmap.to_uv.rows.as_flattened().iter().copied().map(float));
    words.extend(texture.data.iter().copied().map(float));
    at
}

fn channels(texture: &Texture) -> u32 {
    texture.channels as u32
}

/// A number as the kernels read it, rounded to single precision.
pub fn float(x: f64) -> u32 {
    (x as f32).to_bits()
}
