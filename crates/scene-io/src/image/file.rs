//! Images to files and back.

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use capwalk_scene::Image;

use super::error::ImageError;
use super::exr_file::ExrFile;
use super::format::{Format, READABLE, WRITABLE, format, save};
use super::layered::{GRADIENT, LayeredImage, VALUE};
use super::npz_file::{self, NpzFile};
use super::panel::{self, Preview, Written};
use super::{exr, tone};
use crate::atomic;
use crate::files::open_file;

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
    let encoded = match format {
        Format::Exr => exr::encode(layered, size),
        Format::Npz => npz_file::encode(layered, size),
        Format::Picture(kind) => return panel::write_preview(path, kind, layered, preview),
    };
    save(
        path,
        &encoded.map_err(|reason| ImageError::write(path, reason))?,
    )?;
    let shown = [VALUE, GRADIENT]
        .iter()
        .filter_map(|name| layered.layer(name));
    Ok(Written {
        non_finite_pixels: shown.map(tone::non_finite_pixels).sum(),
        limit: None,
    })
}

/// An image file of which the headers were read: which layers it has, and how large they are.
/// Their pixels are read one layer at a time.
///
/// The layer `value` is from the channels `R, G, B`, other layers are from channels with a common
/// prefix, and everything else is a grey layer of its own. Values are single precision.
pub struct ImageFile {
    path: PathBuf,
    layers: Layers,
}

/// The layers of a file in one of the formats.
enum Layers {
    Exr(ExrFile<BufReader<File>>),
    Npz(NpzFile<BufReader<File>>),
}

impl ImageFile {
    /// Reads the headers of an EXR or NPZ file.
    pub fn open(path: &Path) -> Result<Self, ImageError> {
        let format = format(path, READABLE)?;
        let source = || {
            let file = open_file(path).map_err(|error| format!("{error}; expected an image"))?;
            Ok(BufReader::new(file))
        };
        let layers = match format {
            Format::Exr => source().and_then(ExrFile::open).map(Layers::Exr),
            Format::Npz => source().and_then(NpzFile::open).map(Layers::Npz),
            Format::Picture(_) => {
                return Err(ImageError::UnknownEnding {
                    path: path.to_owned(),
                    known: READABLE,
                });
            }
        };
        let file = Self {
            layers: layers.map_err(|reason| ImageError::read(path, reason))?,
            path: path.to_owned(),
        };
        match file.names().is_empty() {
            true => file.located(Err("it has no layers; expected an image".into())),
            false => Ok(file),
        }
    }

    /// The names of its layers.
    pub fn names(&self) -> Vec<&str> {
        match &self.layers {
            Layers::Exr(file) => file.names().collect(),
            Layers::Npz(file) => file.names().collect(),
        }
    }

    /// Width and height of a layer; `None` if there is none of this name.
    pub fn size(&mut self, name: &str) -> Result<Option<[usize; 2]>, ImageError> {
        let Some(layer) = self.place(name) else {
            return Ok(None);
        };
        let size = match &mut self.layers {
            Layers::Exr(file) => Ok(file.size(layer)),
            Layers::Npz(file) => file.size(layer),
        };
        self.located(size.map(Some))
    }

    /// The first layer of this name, if there is one.
    pub fn image(&mut self, name: &str) -> Result<Option<Image>, ImageError> {
        let Some(layer) = self.place(name) else {
            return Ok(None);
        };
        let image = match &mut self.layers {
            Layers::Exr(file) => file.image(layer),
            Layers::Npz(file) => file.image(layer),
        };
        self.located(image.map(Some))
    }

    /// Everything that is in it.
    fn all(&mut self) -> Result<LayeredImage, ImageError> {
        let names: Vec<String> = self.names().into_iter().map(str::to_owned).collect();
        let mut layered = LayeredImage::default();
        for name in names {
            if layered.layer(&name).is_none()
                && let Some(image) = self.image(&name)?
            {
                layered.push(&name, image);
            }
        }
        let [width, height] = self.located(layered.size())?;
        let samples = match &mut self.layers {
            Layers::Exr(file) => file.samples(width * height),
            Layers::Npz(file) => file.samples(width * height),
        };
        layered.samples = self.located(samples)?;
        let metadata = match &mut self.layers {
            Layers::Exr(file) => Ok(file.metadata().to_vec()),
            Layers::Npz(file) => file.metadata(),
        };
        layered.metadata = self.located(metadata)?;
        Ok(layered)
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.names().iter().position(|&other| other == name)
    }

    fn located<T>(&self, result: Result<T, String>) -> Result<T, ImageError> {
        result.map_err(|reason| ImageError::read(&self.path, reason))
    }
}

/// Reads all layers of an image, so nothing is left out; see [`ImageFile`] for some of them.
pub fn read(path: &Path) -> Result<LayeredImage, ImageError> {
    ImageFile::open(path)?.all()
}
