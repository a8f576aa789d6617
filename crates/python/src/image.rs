//! Images as PNG, for notebooks, and in files.

use std::path::PathBuf;

use capwalk::FilesRead;
use capwalk::scene_io::image::{
    LayeredImage, Preview, Scale, Style, pixels_as_png, preview_as_png, write,
};
use capwalk::scene_io::read_image as read;
use numpy::{PyArray3, PyReadonlyArrayDyn};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::watched::{detached, interruptible};
use crate::{arrays, errors};

/// The bytes of a PNG file: a photograph, or with a limit false colours, from blue at minus the limit to
/// red at the limit.
#[pyfunction]
pub fn png<'py>(
    py: Python<'py>,
    image: PyReadonlyArrayDyn<'py, f64>,
    limit: Option<f64>,
) -> PyResult<Bound<'py, PyBytes>> {
    let image = arrays::to_image("the image", &image)?;
    let style = match limit {
        // The bar beside it is even.
        Some(limit) => Style::Diverging(Scale::even(limit)),
        None => Style::Photographic { exposure: 0.0 },
    };
    let bytes = detached(py, || pixels_as_png(&image, style))?;
    let bytes = bytes.map_err(|error| errors::exception(py, error))?;
    Ok(PyBytes::new(py, &bytes))
}

/// The limit of false colours for an image ([`Scale::of`]).
#[pyfunction]
pub fn limit(image: PyReadonlyArrayDyn<'_, f64>) -> PyResult<f64> {
    let image = arrays::to_image("the image", &image)?;
    Ok(Scale::of([&image]).limit)
}

/// An image in a file, (height, width, 3).
#[pyfunction]
pub fn read_image(
    py: Python<'_>,
    path: PathBuf,
    layer: Option<String>,
    raw: bool,
) -> PyResult<Bound<'_, PyArray3<f64>>> {
    let image = interruptible(py, move || read(&path, layer.as_deref(), raw))?;
    arrays::from_image(py, &image.map_err(|error| errors::exception(py, error))?)
}

/// Images by their names, and notes on them.
type Layers<'py> = Vec<(String, PyReadonlyArrayDyn<'py, f64>)>;

/// Writes images into one file, by their names there, with notes on them, in pictures with false
/// colours up to a limit. It is none of the files that were `read`.
#[pyfunction]
pub fn write_images(
    py: Python<'_>,
    path: PathBuf,
    layers: Layers<'_>,
    notes: Vec<(String, String)>,
    read: Vec<PathBuf>,
    limit: Option<f64>,
) -> PyResult<()> {
    let read: FilesRead = read.into_iter().collect();
    read.refuse(&path)
        .map_err(|error| errors::exception(py, error))?;
    let layered = layered(&layers, notes)?;
    let preview = Preview {
        limit,
        ..Preview::default()
    };
    let written = detached(py, || write(&path, &layered, &preview))?;
    written.map_err(|error| errors::exception(py, error))?;
    Ok(())
}

/// The picture of images that [`write_images`] writes into a PNG file.
#[pyfunction]
pub fn preview<'py>(
    py: Python<'py>,
    layers: Layers<'py>,
    notes: Vec<(String, String)>,
) -> PyResult<Bound<'py, PyBytes>> {
    let layered = layered(&layers, notes)?;
    let bytes = detached(py, || preview_as_png(&layered, &Preview::default()))?;
    let bytes = bytes.map_err(|error| errors::exception(py, error))?;
    Ok(PyBytes::new(py, &bytes))
}

fn layered(layers: &Layers<'_>, metadata: Vec<(String, String)>) -> PyResult<LayeredImage> {
    let mut layered = LayeredImage {
        metadata,
        ..LayeredImage::default()
    };
    for (name, array) in layers {
        layered.push(name, arrays::to_image(name, array)?);
    }
    Ok(layered)
}
