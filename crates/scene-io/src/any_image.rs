//! Images of any format that is read, as linear numbers: photographs, renderings, masks.

use std::path::Path;

use capwalk_math::Rgb;
use capwalk_scene::Image;

use crate::bitmap::{self, BitmapFile, BitmapUse, Channels};
use crate::files::read_file;
use crate::image::{ImageError, ImageFile, VALUE};

/// Endings of the names of files.
const ENDINGS: &str = ".exr, .npz, .png, .jpg, .jpeg, .bmp, .tga, .hdr";

/// The layer of opacities, as EXR files call it.
const OPACITY: &str = "A";

/// An image in an EXR, NPZ, PNG, JPEG, BMP, TGA or Radiance HDR file. Files with 8 or 16 bits are
/// decoded from sRGB to linear light, unless they are `raw`; the others are linear. Greys are equal
/// in all channels.
///
/// Without the name of a `layer` it is `value`, the channels `R, G, B`, or else the only layer of the
/// file. In all formats `A` is the opacity, 1 where a PNG, BMP, TGA or JPEG file has none, by which
/// colours are not multiplied.
pub fn read_image(path: &Path, layer: Option<&str>, raw: bool) -> Result<Image, ImageError> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    let ending = ending.to_ascii_lowercase();
    if ["exr", "npz"].contains(&ending.as_str()) {
        return of_layers(path, layer);
    }
    if !bitmap::ENDINGS.contains(&ending.as_str()) {
        return Err(ImageError::UnknownEnding {
            path: path.to_owned(),
            known: ENDINGS,
        });
    }
    let (wanted, raw) = match layer {
        None | Some(VALUE) => (Channels::Colour, raw),
        // Opacities are never encoded.
        Some(OPACITY) if ending != "hdr" => (Channels::One(3), true),
        Some(name) => {
            let known = match ending.as_str() {
                "hdr" => VALUE.to_owned(),
                _ => format!("{VALUE}, {OPACITY}"),
            };
            return Err(no_layer(path, name, &known));
        }
    };
    let bytes = read_file(path).map_err(|error| ImageError::read(path, error))?;
    let file = bitmap::read(&bytes, &ending, raw, wanted, BitmapUse::Texture);
    Ok(image(file.map_err(|error| ImageError::read(path, error))?))
}

/// A layer of an EXR or NPZ file.
fn of_layers(path: &Path, layer: Option<&str>) -> Result<Image, ImageError> {
    let mut file = ImageFile::open(path)?;
    let names = file.names();
    let known = names.join(", ");
    let name = match (layer, names.as_slice()) {
        (Some(name), _) => name.to_owned(),
        (None, [only]) => only.to_string(),
        (None, names) if names.contains(&VALUE) => VALUE.to_owned(),
        (None, _) => {
            let reason = format!("it has several layers; choose one of {known}");
            return Err(ImageError::read(path, reason));
        }
    };
    let image = file.image(&name)?;
    image.ok_or_else(|| no_layer(path, &name, &known))
}

fn no_layer(path: &Path, name: &str, known: &str) -> ImageError {
    let reason = format!("it has no layer \"{name}\"; its layers are {known}");
    ImageError::read(path, reason)
}

fn image(file: BitmapFile) -> Image {
    let pixels = file.data.chunks_exact(file.channels);
    Image {
        width: file.width as usize,
        height: file.height as usize,
        pixels: pixels
            .map(|p| Rgb::new(p[0], p[p.len() / 2], p[p.len() - 1]))
            .collect(),
    }
}
