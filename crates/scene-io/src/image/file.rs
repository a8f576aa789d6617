//! Images to files and back.

use std::path::Path;

use super::error::ImageError;
use super::format::{Format, READABLE, WRITABLE, format, save};
use super::layered::{GRADIENT, LayeredImage, VALUE};
use super::panel::{self, Preview, Written};
use super::{exr, npz_file, tone};
use crate::atomic;
use crate::files::read_file;

/// Checks that an image could be written under this name, so that a long
/// computation need not end in an error: the ending is known and a file can be
/// made there. Leaves nothing behind.
pub fn check_writable(path: &Path) -> Result<(), ImageError> {
    format(path, WRITABLE)?;
    atomic::check_writable(path).map_err(|error| ImageError::write(path, error))
}

/// Writes an image in the format that its name ends in.
pub fn write(
    path: &Path,
    layered: &LayeredImage,
    preview: &Preview,
) -> Result<Written, ImageError> {
    let format = format(path, WRITABLE)?;
    let size = layered
        .size()
        .map_err(|reason| ImageError::write(path, reason))?;
    if format == Format::Png {
        return panel::write_preview(path, layered, preview);
    }
    let bytes = match format {
        Format::Exr => exr::encode(layered, size),
        Format::Npz | Format::Png => npz_file::encode(layered, size),
    };
    let bytes = bytes.map_err(|reason| ImageError::write(path, reason))?;
    save(path, &bytes)?;
    let shown = [VALUE, GRADIENT]
        .iter()
        .filter_map(|name| layered.layer(name));
    Ok(Written {
        non_finite_pixels: shown.map(tone::non_finite_pixels).sum(),
        limit: None,
    })
}

/// Reads an image: the layer `value` from the channels `R, G, B`, other
/// layers from channels with a common prefix, and everything else as a grey
/// layer of its own, so nothing is left out. Values are single precision.
pub fn read(path: &Path) -> Result<LayeredImage, ImageError> {
    let format = format(path, READABLE)?;
    let read_error = |reason: String| ImageError::read(path, reason);
    let bytes = || {
        read_file(path).map_err(|error| {
            let expected = "expected an image (.exr or .npz)";
            read_error(format!("{error}; {expected}"))
        })
    };
    let layered = match format {
        Format::Exr => exr::decode(&bytes()?),
        Format::Npz => npz_file::decode(&bytes()?),
        Format::Png => {
            return Err(ImageError::UnknownEnding {
                path: path.to_owned(),
                known: READABLE,
            });
        }
    };
    let layered = layered.map_err(read_error)?;
    layered.size().map_err(read_error)?;
    Ok(layered)
}
