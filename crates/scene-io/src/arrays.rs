//! Named arrays of numbers as files: NPZ, the archive of NumPy arrays that
//! `numpy.load` opens. What is known about them stands in one more array,
//! [`METADATA`], as pairs of strings.
//!
//! Files appear whole or not at all, and the same arrays always give the same
//! bytes.

use std::collections::HashSet;
use std::io::{BufReader, Cursor, Read, Seek, Write};
use std::path::Path;

use zip::ZipWriter;

use crate::archive::{self, Archive, floats};
use crate::atomic;
use crate::files::open_file;
use crate::image::ImageError;

/// The array of keys and values; no other one may have this name.
pub const METADATA: &str = "metadata";

/// The most bytes that the list of arrays has: room for those of 20,000 shapes.
const LONGEST_LIST: u64 = 1 << 26;

/// The endings that [`write()`] and [`read`] know.
const KNOWN: &str = ".npz";

/// Numbers with a name and a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// What it is called.
    pub name: String,
    /// Its dimensions; none for a single number.
    pub shape: Vec<usize>,
    /// Its numbers, row by row.
    pub numbers: Vec<f64>,
}

/// Arrays, and what is known about them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arrays {
    /// The arrays; their names differ.
    pub arrays: Vec<Array>,
    /// Keys and values: `scene`, `seed`, `spp`, `version`.
    pub metadata: Vec<(String, String)>,
}

impl Arrays {
    /// The array with this name.
    pub fn get(&self, name: &str) -> Option<&Array> {
        self.arrays.iter().find(|array| array.name == name)
    }
}

/// Checks that arrays could be written under this name: it ends in `.npz`, and
/// a file can be made there. Leaves nothing behind.
pub fn check_writable(path: &Path) -> Result<(), ImageError> {
    check_ending(path)?;
    atomic::check_writable(path).map_err(|error| ImageError::write(path, error))
}

fn check_ending(path: &Path) -> Result<(), ImageError> {
    let ending = path.extension().unwrap_or_default();
    match ending.eq_ignore_ascii_case("npz") {
        true => Ok(()),
        false => Err(ImageError::UnknownEnding {
            path: path.to_owned(),
            known: KNOWN,
        }),
    }
}

/// Writes arrays of `float64`, and then the metadata if there is any. Two
/// arrays of the same name, or as many numbers as do not fill a shape, are
/// errors.
pub fn write(path: &Path, arrays: &Arrays) -> Result<(), ImageError> {
    check_ending(path)?;
    let bytes = encode(arrays).map_err(|reason| ImageError::write(path, reason))?;
    atomic::write_atomically(path, |file| file.write_all(&bytes))
        .map_err(|error| ImageError::write(path, error))
}

fn encode(arrays: &Arrays) -> Result<Vec<u8>, String> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let mut names = HashSet::from([METADATA]);
    for Array {
        name,
        shape,
        numbers,
    } in &arrays.arrays
    {
        if !names.insert(name) {
            return Err(format!("two arrays have the name \"{name}\""));
        }
        let shape: Vec<u64> = shape.iter().map(|&n| n as u64).collect();
        archive::add_array(&mut archive, name, "<f8", &shape, numbers.iter().copied())?;
    }
    archive::add_pairs(&mut archive, METADATA, &arrays.metadata)?;
    let bytes = archive.finish().map_err(|error| error.to_string())?;
    Ok(bytes.into_inner())
}

/// Reads arrays of `float64` as [`write()`] and `numpy.savez` write them.
pub fn read(path: &Path) -> Result<Arrays, ImageError> {
    check_ending(path)?;
    let file = open_file(path).map_err(|error| ImageError::read(path, error))?;
    decode(BufReader::new(file)).map_err(|reason| ImageError::read(path, reason))
}

fn decode(source: impl Read + Seek) -> Result<Arrays, String> {
    let mut archive = Archive::open(source, LONGEST_LIST)?;
    let mut arrays = Arrays::default();
    for (index, name) in archive.names().to_vec().into_iter().enumerate() {
        if name == METADATA {
            arrays.metadata = archive.pairs(index)?;
            continue;
        }
        let array = archive.read(index, |array| {
            let shape: Vec<usize> = array.shape().iter().map(|&n| n as usize).collect();
            let count = shape.iter().product();
            let mut numbers = Vec::new();
            let reserved = numbers.try_reserve_exact(count);
            reserved.map_err(|_| format!("has {count} numbers, for which there is no memory"))?;
            for number in floats(array, &["float64"])? {
                numbers.push(number?);
            }
            Ok((shape, numbers))
        });
        let (shape, numbers) = array?;
        arrays.arrays.push(Array {
            name,
            shape,
            numbers,
        });
    }
    Ok(arrays)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> Arrays {
        let array = |name: &str, shape: &[usize], numbers: &[f64]| Array {
            name: name.into(),
            shape: shape.to_vec(),
            numbers: numbers.to_vec(),
        };
        Arrays {
            arrays: vec![
                array(
                    "a.positions",
                    &[2, 3],
                    &[1.0, -2.0, 0.1, 1e-300, f64::NAN, 6.0],
                ),
                array("2*a.translate.x - b/c", &[], &[std::f64::consts::PI]),
                array("empty", &[0, 3], &[]),
            ],
            metadata: vec![
                ("scene".into(), "größe".into()),
                ("seed".into(), "5".into()),
            ],
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let folder = std::env::temp_dir().join(format!("capwalk-arrays-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a temporary directory");
        let path = folder.join("a.npz");
        check_writable(&path).expect("writable");
        write(&path, &example()).expect("writable");
        let back = read(&path).expect("readable");
        assert_eq!(format!("{back:?}"), format!("{:?}", example()));
        assert_eq!(
            back.get("2*a.translate.x - b/c").expect("there").shape,
            [0; 0]
        );
        let bytes = std::fs::read(&path).expect("readable");
        write(&path, &example()).expect("writable");
        assert_eq!(bytes, std::fs::read(&path).expect("readable"));
        std::fs::remove_dir_all(&folder).expect("removable");
    }

    /// A file cut off anywhere, or with an array that promises more than there
    /// is, is an error.
    #[test]
    fn broken_files_are_errors() {
        let bytes = encode(&example()).expect("fine");
        for end in 0..bytes.len() {
            assert!(decode(Cursor::new(&bytes[..end])).is_err(), "{end}");
        }
        let text = b"(2, 3, )";
        let place = bytes.windows(text.len()).position(|w| w == text);
        let place = place.expect("the shape of the first array");
        let message = |shape: &[u8; 8]| {
            let mut broken = bytes.clone();
            broken[place..place + text.len()].copy_from_slice(shape);
            decode(Cursor::new(broken)).expect_err("broken")
        };
        // Before memory is taken for what is promised, and before the library reads the header.
        for (shape, expected) in [
            (b"(9, 9, )", "ends before its shape"),
            (b"((2,),3)", "has a header that NumPy does not write"),
        ] {
            let error = message(shape);
            let expected = format!("the array \"a.positions\" {expected}");
            assert!(error.contains(&expected), "{error}");
        }
    }

    #[test]
    fn bad_arrays_and_names_are_errors() {
        let mut twice = example();
        twice.arrays[1].name = "a.positions".into();
        assert!(encode(&twice).expect_err("twice").contains("two arrays"));
        let mut reserved = example();
        reserved.arrays[1].name = METADATA.into();
        assert!(encode(&reserved).is_err());
        let mut short = example();
        short.arrays[0].numbers.pop();
        assert!(encode(&short).is_err());
        let error = check_writable("gradient.exr".as_ref()).expect_err("an ending");
        let message = error.to_string();
        assert!(
            message.contains("gradient.exr") && message.contains(".npz"),
            "{message}"
        );
    }
}
