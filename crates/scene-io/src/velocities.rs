//! Velocities of the vertices of a mesh as files: a `.npy` array of shape (V, 3), or a
//! text with one `x y z` per line and comments behind `#`.

use std::io;
use std::path::{Path, PathBuf};

use capwalk_math::Vec3;

use crate::files::read_file;
use crate::npy;

/// Why a file holds no velocities.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum VelocityFileError {
    /// The file cannot be read.
    #[error("cannot open {}", path.display())]
    Open {
        /// The file.
        path: PathBuf,
        /// Why.
        #[source]
        error: io::Error,
    },
    /// Its contents are something else.
    #[error("{} is not usable", path.display())]
    Unusable {
        /// The file.
        path: PathBuf,
        /// Why.
        #[source]
        error: NotVelocities,
    },
}

/// What is wrong with the contents of a file of velocities.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NotVelocities {
    /// The array has other dimensions.
    #[error("the array has the shape {shape:?}; expected (V, 3)")]
    Shape {
        /// Its shape.
        shape: Vec<u64>,
    },
    /// The array is in Fortran order.
    #[error("the array is stored column by column; save numpy.ascontiguousarray(array) instead")]
    ColumnByColumn,
    /// The array has integers, or something else.
    #[error("the array holds no floating point numbers; expected float32 or float64")]
    NoFloats,
    /// The array ends too early, or its header is damaged.
    #[error("the array {0}")]
    Damaged(String),
    /// The bytes are neither an array nor UTF-8.
    #[error("it is neither a .npy file nor text")]
    NoText,
    /// A line has something else than three numbers.
    #[error("line {line} is \"{text}\"; expected three numbers, \"x y z\"")]
    Line {
        /// The line, counted from 1.
        line: usize,
        /// What is there.
        text: String,
    },
}

/// One velocity per row of the file, in its order, world units per unit of the parameter.
pub fn read_velocities(path: &Path) -> Result<Vec<Vec3>, VelocityFileError> {
    let bytes = read_file(path).map_err(|error| VelocityFileError::Open {
        path: path.into(),
        error,
    })?;
    let numbers = match bytes.starts_with(b"\x93NUMPY") {
        true => npy_numbers(&bytes),
        false => text_numbers(&bytes),
    };
    let numbers = numbers.map_err(|error| VelocityFileError::Unusable {
        path: path.into(),
        error,
    })?;
    let rows = numbers.chunks_exact(3);
    Ok(rows.map(|row| Vec3::new(row[0], row[1], row[2])).collect())
}

fn npy_numbers(bytes: &[u8]) -> Result<Vec<f64>, NotVelocities> {
    let open = || npy::open(bytes, bytes.len() as u64).map_err(NotVelocities::Damaged);
    let shape = open()?.shape().to_vec();
    if !matches!(shape[..], [_, 3]) {
        return Err(NotVelocities::Shape { shape });
    }
    if open()?.order() != npyz::Order::C {
        return Err(NotVelocities::ColumnByColumn);
    }
    if let Ok(doubles) = open()?.try_data::<f64>() {
        return collect(doubles);
    }
    let floats = open()?.try_data::<f32>();
    let floats = floats.map_err(|_| NotVelocities::NoFloats)?;
    collect(floats.map(|x| x.map(f64::from)))
}

fn collect(numbers: impl Iterator<Item = io::Result<f64>>) -> Result<Vec<f64>, NotVelocities> {
    let numbers: io::Result<Vec<f64>> = numbers.collect();
    numbers.map_err(|error| NotVelocities::Damaged(format!("cannot be read: {error}")))
}

fn text_numbers(bytes: &[u8]) -> Result<Vec<f64>, NotVelocities> {
    let text = std::str::from_utf8(bytes).map_err(|_| NotVelocities::NoText)?;
    let mut numbers = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default();
        let mut words = line.split_whitespace().peekable();
        if words.peek().is_none() {
            continue;
        }
        let row: Result<Vec<f64>, _> = words.map(str::parse).collect();
        match row {
            Ok(row) if row.len() == 3 => numbers.extend(row),
            _ => {
                return Err(NotVelocities::Line {
                    line: i + 1,
                    text: line.trim().into(),
                });
            }
        }
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_text() {
        let rows = b"# velocities\n1 2 3\n\n 4e-1 -5 6 # last\n";
        assert_eq!(text_numbers(rows).unwrap(), [1.0, 2.0, 3.0, 0.4, -5.0, 6.0]);
        let message = text_numbers(b"1 2 3\n1 2\n").unwrap_err().to_string();
        assert_eq!(
            message,
            "line 2 is \"1 2\"; expected three numbers, \"x y z\""
        );
    }

    /// An array file as numpy writes it.
    fn npy(dtype: &str, shape: &str, data: &[u8]) -> Vec<u8> {
        let header = format!("{{'descr': '{dtype}', 'fortran_order': False, 'shape': {shape}, }}");
        let header = format!("{header:117}\n"); // 128 bytes with what stands before
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((header.len() as u16).to_le_bytes());
        bytes.extend(header.bytes());
        bytes.extend(data);
        bytes
    }

    #[test]
    fn arrays_of_numpy() {
        let numbers = [1.0, -2.0, 0.5, 4.0, 5.0, 6.0];
        let doubles: Vec<u8> = numbers.iter().flat_map(|x: &f64| x.to_le_bytes()).collect();
        let floats = numbers.iter().map(|&x| x as f32);
        let floats: Vec<u8> = floats.flat_map(f32::to_le_bytes).collect();
        assert_eq!(
            npy_numbers(&npy("<f8", "(2, 3)", &doubles)).unwrap(),
            numbers
        );
        assert_eq!(
            npy_numbers(&npy("<f4", "(2, 3)", &floats)).unwrap(),
            numbers
        );
        let message = |bytes: &[u8]| npy_numbers(bytes).unwrap_err().to_string();
        assert_eq!(
            message(&npy("<f8", "(3, 2)", &doubles)),
            "the array has the shape [3, 2]; expected (V, 3)"
        );
        assert!(message(&npy("<i8", "(2, 3)", &doubles)).contains("float32 or float64"));
        assert!(message(&npy("<f8", "(4, 3)", &doubles)).contains("ends before its shape [4, 3]"));
        // Held to the form of plain arrays before the library sees it.
        let nested = message(&npy("<f8", "((2,), 3)", &doubles));
        assert!(nested.contains("that NumPy does not write"), "{nested}");
    }
}
