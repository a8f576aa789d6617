//! Pictures as files. The ending of the name chooses the format:
//!
//! | ending | what is in it |
//! |---|---|
//! | `.exr` | all layers in single precision as `R, G, B` (the layer `value`) and `<layer>.R, .G, .B`; sample counts as `samples`; metadata as text attributes `capwalk:<key>` |
//! | `.npz` | one array `(height, width, 3)` of `float32` per layer; `samples` as `(height, width)` of `uint32`; `metadata` as pairs of strings |
//! | `.png` | a preview of 8 bits: the gradient in false colours with a colour bar if there is one, the value otherwise |
//!
//! EXR and NPZ files can be read back, also such as other programs write.
//! Files appear whole or not at all, and the same picture always gives the
//! same bytes.

mod canvas;
mod exr;
mod font;
mod npz;
mod panel;
mod png;
mod tone;

use std::fmt;
use std::io::Write;
use std::path::{Path, PathBuf};

use capwalk_scene::Image;

pub use panel::{Panel, Style, colour_bar_as_png, pixels_as_png, write_panels};

pub(crate) use exr::decode as decode_exr;
pub(crate) use exr::encode as encode_exr;
pub use tone::{photographic, robust_limit};

use crate::atomic;

/// Named pictures of the same size, and what is known about them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// The pictures: `value`, `gradient`, `stderr` and so on.
    pub layers: Vec<Layer>,
    /// Keys and values: `scene`, `parameter`, `seed`, `spp`, `version`.
    pub metadata: Vec<(String, String)>,
    /// Samples taken in each pixel, row by row, if they are known.
    pub samples: Option<Vec<u32>>,
}

/// A picture and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Its name. [`VALUE`] is the picture itself, all others are shown in
    /// false colours.
    pub name: String,
    /// Its pixels.
    pub image: Image,
}

/// The name of the layer that is a picture of the scene.
pub const VALUE: &str = "value";
/// The name of the layer that is a derivative.
pub const GRADIENT: &str = "gradient";

impl Picture {
    /// Adds a layer behind the others.
    pub fn push(&mut self, name: &str, image: Image) {
        self.layers.push(Layer {
            name: name.into(),
            image,
        });
    }

    /// The layer with this name.
    pub fn layer(&self, name: &str) -> Option<&Image> {
        let layer = self.layers.iter().find(|layer| layer.name == name)?;
        Some(&layer.image)
    }

    /// Width and height, or a reason why the layers do not belong together.
    fn size(&self) -> Result<[usize; 2], String> {
        let first = self.layers.first().ok_or("the picture has no layers")?;
        let [width, height] = [first.image.width, first.image.height];
        for Layer { name, image } in &self.layers {
            if [image.width, image.height] != [width, height] {
                return Err(format!(
                    "\"{}\" has {width} x {height} pixels, but \"{name}\" has {} x {}",
                    first.name, image.width, image.height
                ));
            }
        }
        let samples = self.samples.as_ref().map(Vec::len);
        match samples.is_none_or(|count| count == width * height) {
            true => Ok([width, height]),
            false => Err("there are not as many sample counts as pixels".into()),
        }
    }
}

/// How a PNG preview looks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Preview {
    /// The value is multiplied by `2^exposure` before the sRGB curve; what is
    /// above 1 is white then.
    pub exposure: f64,
    /// Where the false colours of a gradient end on both sides; `None` chooses
    /// [`robust_limit`].
    pub limit: Option<f64>,
}

/// What there is to say about a file that was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Written {
    /// Pixels with an infinity or a NaN in the value or the gradient (in the
    /// layer that a PNG shows, where they are magenta).
    pub non_finite_pixels: usize,
    /// Where the false colours of a PNG end.
    pub limit: Option<f64>,
}

/// Why a picture could not be written or read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ImageError {
    /// The file's name does not say which format it has.
    UnknownEnding {
        /// The file.
        path: PathBuf,
        /// The endings that would be accepted.
        known: &'static str,
    },
    /// The file could not be written.
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The file could not be read or understood.
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: String,
    },
}

impl fmt::Display for ImageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownEnding { path, known } => write!(
                f,
                "the name {} does not tell a picture's format; known endings: {known}",
                path.display()
            ),
            Self::Write { path, reason } => write!(f, "cannot write {}: {reason}", path.display()),
            Self::Read { path, reason } => write!(f, "cannot read {}: {reason}", path.display()),
        }
    }
}

impl std::error::Error for ImageError {}

/// Formats, by the endings of names.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Exr,
    Png,
    Npz,
}

fn format(path: &Path, known: &'static str) -> Result<Format, ImageError> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    match ending.to_ascii_lowercase().as_str() {
        "exr" => Ok(Format::Exr),
        "png" => Ok(Format::Png),
        "npz" => Ok(Format::Npz),
        _ => Err(ImageError::UnknownEnding {
            path: path.to_owned(),
            known,
        }),
    }
}

/// The endings that [`write()`] knows.
const WRITABLE: &str = ".exr, .png, .npz";
/// The endings that [`read`] knows.
const READABLE: &str = ".exr, .npz";

/// Checks that a picture could be written under this name, so that a long
/// computation need not end in an error: the ending is known and a file can be
/// made there. Leaves nothing behind.
pub fn check_writable(path: &Path) -> Result<(), ImageError> {
    format(path, WRITABLE)?;
    atomic::check_writable(path).map_err(|error| write_error(path, error))
}

/// Writes a picture in the format that its name ends in.
pub fn write(path: &Path, picture: &Picture, preview: &Preview) -> Result<Written, ImageError> {
    let format = format(path, WRITABLE)?;
    let size = picture.size().map_err(|reason| write_error(path, reason))?;
    if format == Format::Png {
        return panel::write_preview(path, picture, preview);
    }
    let bytes = match format {
        Format::Exr => exr::encode(picture, size),
        Format::Npz | Format::Png => npz::encode(picture, size),
    };
    let bytes = bytes.map_err(|reason| write_error(path, reason))?;
    save(path, &bytes)?;
    let shown = [VALUE, GRADIENT]
        .iter()
        .filter_map(|name| picture.layer(name));
    Ok(Written {
        non_finite_pixels: shown.map(tone::non_finite_pixels).sum(),
        limit: None,
    })
}

/// Reads a picture: the layer `value` from the channels `R, G, B`, other
/// layers from channels with a common prefix, and everything else as a grey
/// layer of its own, so nothing is left out. Values are single precision.
pub fn read(path: &Path) -> Result<Picture, ImageError> {
    let format = format(path, READABLE)?;
    let read_error = |reason: String| ImageError::Read {
        path: path.to_owned(),
        reason,
    };
    let bytes = || {
        std::fs::read(path).map_err(|error| {
            let expected = "expected a picture (.exr or .npz), as `capwalk render` writes it";
            read_error(format!("{error}; {expected}"))
        })
    };
    let picture = match format {
        Format::Exr => exr::decode(&bytes()?),
        Format::Npz => npz::decode(&bytes()?),
        Format::Png => {
            return Err(ImageError::UnknownEnding {
                path: path.to_owned(),
                known: READABLE,
            });
        }
    };
    let picture = picture.map_err(read_error)?;
    picture.size().map_err(read_error)?;
    Ok(picture)
}

fn save(path: &Path, bytes: &[u8]) -> Result<(), ImageError> {
    atomic::write_atomically(path, |file| file.write_all(bytes))
        .map_err(|error| write_error(path, error))
}

fn write_error(path: &Path, reason: impl ToString) -> ImageError {
    ImageError::Write {
        path: path.to_owned(),
        reason: reason.to_string(),
    }
}

#[cfg(test)]
mod tests;
