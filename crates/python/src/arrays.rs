//! Images and numbers of the scene as NumPy arrays, and back.

use capwalk::params::shape_text;
use capwalk::{Error, Image, Rgb};
use numpy::{
    IntoPyArray, PyArray3, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::errors;

/// An image as an array (height, width, 3).
pub fn from_image<'py>(py: Python<'py>, image: &Image) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let numbers: Vec<f64> = image.pixels.iter().flat_map(|p| p.to_array()).collect();
    let shape = [image.height, image.width, 3];
    numbers.into_pyarray(py).reshape(shape)
}

/// An array (height, width, 3) as an image, or (height, width) or (height, width, 1) as a grey
/// one; `what` it is for the message.
pub fn to_image(what: &str, array: &PyReadonlyArrayDyn<'_, f64>) -> PyResult<Image> {
    let (height, width, channels) = match *array.shape() {
        [height, width] | [height, width, 1] if height * width > 0 => (height, width, 1),
        [height, width, 3] if height * width > 0 => (height, width, 3),
        ref shape => {
            let found = shape_text(shape);
            let text = format!(
                "{what} has the shape {found}; expected (height, width, 3), or (height, width) \
                 for equal channels"
            );
            return Err(errors::argument(array.py(), text));
        }
    };
    let numbers = to_numbers(array);
    let pixels = numbers.chunks_exact(channels);
    Ok(Image {
        width,
        height,
        pixels: pixels
            .map(|p| Rgb::new(p[0], p[channels / 2], p[channels - 1]))
            .collect(),
    })
}

/// Numbers, row by row, as an array of this shape.
pub fn from_numbers<'py>(
    py: Python<'py>,
    shape: &[usize],
    numbers: Vec<f64>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    numbers.into_pyarray(py).reshape(shape.to_vec())
}

/// The numbers of an array, row by row, however it lies in memory.
pub fn to_numbers(array: &PyReadonlyArrayDyn<'_, f64>) -> Vec<f64> {
    array.as_array().iter().copied().collect()
}

/// Refuses an array of another shape than the scene has; `name` is what it is for.
pub fn check_shape(name: &str, expected: &[usize], found: &[usize]) -> Result<(), Error> {
    match expected == found {
        true => Ok(()),
        false => Err(Error::Shape {
            name: name.into(),
            expected: shape_text(expected),
            found: shape_text(found),
        }),
    }
}
