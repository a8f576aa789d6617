//! Formats of image files by the endings of their names.

use std::io::Write;
use std::path::Path;

use super::error::ImageError;
use crate::atomic;

/// Formats, by the endings of names.
#[derive(Clone, Copy)]
pub(super) enum Format {
    Exr,
    Npz,
    Picture(Picture),
}

/// Formats of pictures to look at, which cannot be read back.
#[derive(Clone, Copy)]
pub(super) enum Picture {
    Png,
    Svg,
}

pub(super) fn format(path: &Path, known: &'static str) -> Result<Format, ImageError> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    match ending.to_ascii_lowercase().as_str() {
        "exr" => Ok(Format::Exr),
        "npz" => Ok(Format::Npz),
        "png" => Ok(Format::Picture(Picture::Png)),
        "svg" => Ok(Format::Picture(Picture::Svg)),
        _ => Err(ImageError::UnknownEnding {
            path: path.to_owned(),
            known,
        }),
    }
}

/// Endings of files that can be written.
pub(super) const WRITABLE: &str = ".exr, .npz, .png, .svg";
/// Endings of pictures.
pub(super) const PICTURES: &str = ".png, .svg";
/// Endings of files that can be read.
pub(super) const READABLE: &str = ".exr, .npz";

/// Writes a file, whole or not at all.
pub(super) fn save(path: &Path, bytes: &[u8]) -> Result<(), ImageError> {
    atomic::write_atomically(path, |file| file.write_all(bytes))
        .map_err(|error| ImageError::write(path, error))
}

/// True for the name of a picture to look at: `.png` or `.svg`.
pub fn is_picture(path: &Path) -> bool {
    matches!(format(path, PICTURES), Ok(Format::Picture(_)))
}
