//! Images from files, as a scene needs them, and to files.

use std::path::Path;

use capwalk_scene::Image;
use capwalk_scene_io::image::{self, ImageFile, LayeredImage, Preview, VALUE};

use crate::error::{Error, UnusableImage};

/// The first of these layers that is in the file. It must have the size of the scene's
/// image, and its pixels finite numbers. Nothing else of the file is unpacked.
pub fn read_layer(path: &Path, layers: &[&str], size: [u32; 2]) -> Result<Image, Error> {
    usable(path, &mut ImageFile::open(path)?, layers, size)
}

/// Weights of pixels and channels from a file: its layer `value`, or else its first. They
/// are finite, at least 0, and not all 0.
pub fn read_mask(path: &Path, size: [u32; 2]) -> Result<Image, Error> {
    let mut file = ImageFile::open(path)?;
    let first = file.names().first().map_or(VALUE, |name| name).to_owned();
    let mask = usable(path, &mut file, &[VALUE, &first], size)?;
    let weights = || mask.pixels.iter().flat_map(|pixel| pixel.to_array());
    let problem = match (weights().any(|w| w < 0.0), weights().all(|w| w == 0.0)) {
        (true, _) => "some pixels are below 0",
        (_, true) => "all pixels are 0: nothing would count",
        _ => return Ok(mask),
    };
    Err(Error::UnusableImage {
        path: path.into(),
        error: UnusableImage::NotWeights { problem },
    })
}

/// Writes an image into a file that ends in `.exr` or `.npz`, in floating point, or `.png`.
/// `layer` is its name there: a PNG shows a `value` as a photograph, everything else in
/// false colours, blue below zero and red above.
pub fn write_image(path: impl AsRef<Path>, layer: &str, image: &Image) -> Result<(), Error> {
    let mut layered = LayeredImage::default();
    layered.push(layer, image.clone());
    image::write(path.as_ref(), &layered, &Preview::default())?;
    Ok(())
}

fn usable(
    path: &Path,
    file: &mut ImageFile,
    layers: &[&str],
    size: [u32; 2],
) -> Result<Image, Error> {
    let unusable = |error: UnusableImage| Error::UnusableImage {
        path: path.into(),
        error,
    };
    let no_layer = |file: &ImageFile| {
        unusable(UnusableImage::NoLayer {
            asked: layers.iter().map(|&name| name.into()).collect(),
            known: file.names().into_iter().map(str::to_owned).collect(),
        })
    };
    let known = file.names();
    let Some(&layer) = layers.iter().find(|name| known.contains(name)) else {
        return Err(no_layer(file));
    };
    // Before its pixels take time and memory.
    let expected = size.map(|n| n as usize);
    let found = file.size(layer)?.ok_or_else(|| no_layer(file))?;
    if found != expected {
        return Err(unusable(UnusableImage::Size { found, expected }));
    }
    let image = file.image(layer)?.ok_or_else(|| no_layer(file))?;
    match image.pixels.iter().position(|pixel| !pixel.is_finite()) {
        None => Ok(image),
        Some(index) => Err(unusable(UnusableImage::NotFinite {
            column: index % image.width,
            row: index / image.width,
            pixel: image.pixels[index].to_array(),
        })),
    }
}
