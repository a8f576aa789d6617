//! Images as PNG, for notebooks, and in files.

use std::path::PathBuf;

use capwalk::FilesRead;
use capwalk::scene_io::image::{LayeredImage, Preview, Scale, Style, pixels_as_png, write};
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

/// Writes images into one file, by their names there, with notes on them. It is none of those that
/// were `read`.
#[pyfunction]
pub fn write_images(
    py: Python<'_>,
    path: PathBuf,
    layers: Vec<(String, PyReadonlyArrayDyn<'_, f64>)>,
    notes: Vec<(String, String)>,
    read: Vec<PathBuf>,
) -> PyResult<()> {
    let read: FilesRead = read.into_iter().collect();
    read.refuse(&path)
        .map_err(|error| errors::exception(py, error))?;
    let mut layered = LayeredImage {
        metadata: notes,
        ..LayeredImage::default()
    };
    for (name, array) in &layers {
        layered.push(name, arrays::to_image(name, array)?);
    }
    let written = detached(py, || write(&path, &layered, &Preview::default()))?;
    written.map_err(|error| errors::exception(py, error))?;
    Ok(())
}
