//! `gltf_texture`: one of a glTF file, as its materials use it.

use capwalk_scene::texture::{Bitmap, TexelFilter, Wrap};
use capwalk_scene::{Pattern, Texture};
use gltf::texture::{MagFilter, WrappingMode};

use super::lowering::Lowering;
use super::texture::{choice, uv_transform};
use crate::bitmap::{self, BitmapUse, Channels};
use crate::fields::Fields;
use crate::mesh::{MeshFileError, unsupported};
use crate::node::PropertyValue;
use crate::problem::Problem;
use crate::texts::Span;

/// What can be taken of a texture.
const CHANNELS: [&str; 6] = ["color", "normal", "red", "green", "blue", "alpha"];

impl Lowering<'_> {
    pub(super) fn gltf_texture(
        &mut self,
        fields: &Fields,
        id: String,
    ) -> Result<(Texture, Span), Problem> {
        let example = "add <string name=\"filename\" value=\"room.glb\"/>";
        let source = self.gltf(fields, example)?;
        let span = fields.span_of("filename");
        let at = |error| source.problem(fields, error);
        source.file.check_rest().map_err(at)?;
        let index = fields.count("texture", 0, 0)? as usize;
        let document = &source.file.document;
        let texture = document.textures().nth(index).ok_or_else(|| {
            let count = document.textures().len();
            let message = format!("there is no texture {index}");
            Problem::invalid(fields.span_of("texture"), message)
                .help(format!("the file has {count} (counted from 0)"))
        })?;
        let place = format!("textures[{index}]");
        let image = document.as_json().textures[index].source.value();
        if image >= document.images().len() {
            let message = "it has no image but by an extension, which is not read";
            let help = "export images as PNG or JPEG";
            return Err(at(unsupported(&place, message, help)));
        }
        let pattern = pattern(&texture, &place).map_err(at)?;
        let open = |name: &str| source.open(name);
        let (bytes, ending) = source.file.image(image, &open).map_err(at)?;

        let channel = choice(fields, "channel", &CHANNELS)?;
        let channels = match channel {
            "red" => Channels::One(0),
            "green" => Channels::One(1),
            "blue" => Channels::One(2),
            "alpha" => Channels::One(3),
            _ => Channels::Colour,
        };
        let raw = channel != "color";
        let texels = bitmap::read(&bytes, ending, raw, channels, BitmapUse::Texture);
        let mut texels = texels.map_err(|error| {
            let shown = source.path.display();
            let message = format!("cannot read images[{image}] of \"{shown}\": {error}");
            Problem::image(span, message).help("export images as PNG or JPEG")
        })?;
        let factor = match fields.get("factor").map(|property| &property.value) {
            Some(&PropertyValue::Rgb(factor)) => factor.to_array(),
            _ => [fields.float("factor", 1.0)?; 3],
        };
        if texels.channels == 1 && matches!(channel, "color" | "normal") {
            texels.data = texels.data.iter().flat_map(|&grey| [grey; 3]).collect();
            texels.channels = 3;
        }
        let is_map = channel == "normal";
        for (i, texel) in texels.data.iter_mut().enumerate() {
            let channel = i % texels.channels;
            *texel = match is_map {
                // Normals are (n + 1) / 2; the third number keeps its size.
                true if channel < 2 => 0.5 + factor[channel] * (*texel - 0.5),
                true => *texel,
                false => *texel * factor[channel],
            };
        }
        if let Some(cutoff) = fields.optional_float("cutoff")? {
            let cut = |texel: &mut f64| *texel = f64::from(*texel >= cutoff);
            texels.data.iter_mut().for_each(cut);
        }
        let texture = Texture {
            id,
            channels: texels.channels,
            data: texels.data,
            pattern: Pattern::Bitmap(Bitmap {
                width: texels.width,
                height: texels.height,
                to_uv: uv_transform(fields)?,
                filter: match fields.get("cutoff") {
                    // Between 0 and 1 there is nothing.
                    Some(_) => TexelFilter::Nearest,
                    None => pattern.0,
                },
                wrap: pattern.1,
            }),
        };
        Ok((texture, span))
    }
}

/// How a texture is looked up.
fn pattern(texture: &gltf::Texture, place: &str) -> Result<(TexelFilter, Wrap), MeshFileError> {
    let sampler = texture.sampler();
    if sampler.wrap_s() != sampler.wrap_t() {
        let message = "it goes on beyond its borders in another way along u than along v";
        return Err(unsupported(
            place,
            message,
            "give both the same wrapping mode",
        ));
    }
    let filter = match sampler.mag_filter() {
        Some(MagFilter::Nearest) => TexelFilter::Nearest,
        Some(MagFilter::Linear) | None => TexelFilter::Bilinear,
    };
    let wrap = match sampler.wrap_s() {
        WrappingMode::ClampToEdge => Wrap::Clamp,
        WrappingMode::MirroredRepeat => Wrap::Mirror,
        WrappingMode::Repeat => Wrap::Repeat,
    };
    Ok((filter, wrap))
}
