//! Images from files, as a scene needs them, and to files.

use std::path::Path;

use capwalk_scene::Image;
use capwalk_scene_io::image::{self, LayeredImage, Preview, VALUE};

use crate::error::{Error, UnusableImage};

/// The first of these layers that is in the file. It must have the size of the scene's
/// image, and its pixels finite numbers.
pub fn read_layer(path: &Path, layers: &[&str], size: [u32; 2]) -> Result<Image, Error> {
    usable(path, &image::read(path)?, layers, size)
}

/// Weights of pixels and channels from a file: its layer `value`, or else its first. They
/// are finite, at least 0, and not all 0.
pub fn read_mask(path: &Path, size: [u32; 2]) -> Result<Image, Error> {
    let layered = image::read(path)?;
    let first = layered.layers.first().map_or(VALUE, |layer| &layer.name);
    let mask = usable(path, &layered, &[VALUE, first], size)?;
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
    layered: &LayeredImage,
    layers: &[&str],
    size: [u32; 2],
) -> Result<Image, Error> {
    let unusable = |error: UnusableImage| Error::UnusableImage {
        path: path.into(),
        error,
    };
    let Some(image) = layers.iter().find_map(|name| layered.layer(name)) else {
        return Err(unusable(UnusableImage::NoLayer {
            asked: layers.iter().map(|&name| name.into()).collect(),
            known: layered.layers.iter().map(|l| l.name.clone()).collect(),
        }));
    };
    let expected = size.map(|n| n as usize);
    let found = [image.width, image.height];
    if found != expected {
        return Err(unusable(UnusableImage::Size { found, expected }));
    }
    match image.pixels.iter().position(|pixel| !pixel.is_finite()) {
        None => Ok(image.clone()),
        Some(index) => Err(unusable(UnusableImage::NotFinite {
            column: index % image.width,
            row: index / image.width,
            pixel: image.pixels[index].to_array(),
        })),
    }
}
