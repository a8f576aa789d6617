//! Named arrays of numbers as files: NPZ, the archive of NumPy arrays that
//! `numpy.load` opens. What is known about them stands in one more array,
//! [`METADATA`], as pairs of strings.
//!
//! Files appear whole or not at all, and the same arrays always give the same
//! bytes.

use std::collections::HashSet;
use std::fs::File;
use std::io::{BufReader, Cursor, Read, Seek, Write};
use std::path::{Path, PathBuf};

use zip::ZipWriter;

use crate::archive::{self, Archive, floats};
use crate::atomic;
use crate::files::open_file;
use crate::image::ImageError;

/// The array of keys and values; no other one may have this name.
pub const METADATA: &str = "metadata";

/// The longest name of an array, bytes.
pub const LONGEST_NAME: usize = archive::LONGEST_NAME - ".npy".len();

/// The most bytes that the list of arrays has: enough for those of 20,000 shapes.
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

/// A file of arrays of which the list was read. Arrays are read one at a time.
pub struct ArrayFile {
    path: PathBuf,
    archive: Archive<BufReader<File>>,
}

impl ArrayFile {
    /// Reads the list of arrays.
    pub fn open(path: &Path) -> Result<Self, ImageError> {
        check_ending(path)?;
        let file = open_file(path).map_err(|error| ImageError::read(path, error))?;
        let archive = Archive::open(BufReader::new(file), LONGEST_LIST);
        Ok(Self {
            archive: archive.map_err(|reason| ImageError::read(path, reason))?,
            path: path.to_owned(),
        })
    }

    /// Keys and values.
    pub fn metadata(&mut self) -> Result<Vec<(String, String)>, ImageError> {
        let Some(index) = self.place(METADATA) else {
            return Ok(Vec::new());
        };
        let pairs = self.archive.pairs(index);
        pairs.map_err(|reason| ImageError::read(&self.path, reason))
    }

    /// How many numbers an array has; `None` if there is none of this name.
    pub fn count(&mut self, name: &str) -> Result<Option<u64>, ImageError> {
        let Some(index) = self.place(name) else {
            return Ok(None);
        };
        let count = self.archive.peek(index, |array| Ok(array.len()));
        let count = count.map_err(|reason| ImageError::read(&self.path, reason));
        count.map(Some)
    }

    /// The numbers of an array of `float64`, if there is one of this name.
    pub fn numbers(&mut self, name: &str) -> Result<Option<Vec<f64>>, ImageError> {
        let Some(index) = self.place(name) else {
            return Ok(None);
        };
        let array = read_array(&mut self.archive, index);
        let array = array.map_err(|reason| ImageError::read(&self.path, reason));
        array.map(|array| Some(array.numbers))
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.archive.names().iter().position(|other| other == name)
    }
}

/// Reads arrays of `float64` as [`write()`] and `numpy.savez` write them, all of them; see
/// [`ArrayFile`] for some.
pub fn read(path: &Path) -> Result<Arrays, ImageError> {
    let mut file = ArrayFile::open(path)?;
    decode(&mut file.archive).map_err(|reason| ImageError::read(path, reason))
}

fn decode(archive: &mut Archive<impl Read + Seek>) -> Result<Arrays, String> {
    let mut arrays = Arrays::default();
    for index in 0..archive.names().len() {
        match archive.names()[index] == METADATA {
            true => arrays.metadata = archive.pairs(index)?,
            false => arrays.arrays.push(read_array(archive, index)?),
        }
    }
    Ok(arrays)
}

fn read_array(archive: &mut Archive<impl Read + Seek>, index: usize) -> Result<Array, String> {
    let name = archive.names()[index].clone();
    archive.read(index, |array| {
        let shape: Vec<usize> = array.shape().iter().map(|&n| n as usize).collect();
        let count = shape.iter().product();
        let mut numbers = Vec::new();
        let reserved = numbers.try_reserve_exact(count);
        reserved.map_err(|_| format!("has {count} numbers, for which there is no memory"))?;
        for number in floats(array, &["float64"])? {
            numbers.push(number?);
        }
        Ok(Array {
            name,
            shape,
            numbers,
        })
    })
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

    fn decoded(bytes: &[u8]) -> Result<Arrays, String> {
        decode(&mut Archive::open(Cursor::new(bytes), LONGEST_LIST)?)
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
        // Or one at a time.
        let mut file = ArrayFile::open(&path).expect("readable");
        assert_eq!(file.count("a.positions"), Ok(Some(6)));
        assert_eq!(file.count("b.positions"), Ok(None));
        let numbers = file.numbers("2*a.translate.x - b/c").expect("readable");
        assert_eq!(numbers, Some(vec![std::f64::consts::PI]));
        assert_eq!(file.metadata().expect("readable"), example().metadata);
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
            assert!(decoded(&bytes[..end]).is_err(), "{end}");
        }
        let text = b"(2, 3, )";
        let place = bytes.windows(text.len()).position(|w| w == text);
        let place = place.expect("the shape of the first array");
        let message = |shape: &[u8; 8]| {
            let mut broken = bytes.clone();
            broken[place..place + text.len()].copy_from_slice(shape);
            decoded(&broken).expect_err("broken")
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
