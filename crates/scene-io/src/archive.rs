//! NPZ: a zip archive of NumPy arrays, uncompressed as `numpy.savez` writes it.
//!
//! Nothing is unpacked before it is known to be wanted: opening an archive reads the list of
//! its arrays, and an array's header says what is in it before its numbers are read.

use std::collections::HashSet;
use std::io::{self, Cursor, Read, Seek, SeekFrom};

use npyz::{DType, NpyFile, WriterBuilder};
use zip::read::ZipFile;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use crate::npy::{self, PackedArray};

/// The longest name of an array, bytes: a bound on messages and on the list of an archive.
/// Names are those of parameters, and sums of them.
pub(crate) const LONGEST_NAME: usize = 8192;

/// The most bytes that an array of keys and values may unpack to. Each string takes four
/// times the length of the longest; those of a job with thousands of parameters have 40 MB.
const LONGEST_PAIRS: u64 = 1 << 26;

/// Adds an array of a type in NumPy's notation. There must be as many values as
/// the shape says.
pub(crate) fn add_array<T: npyz::Serialize>(
    archive: &mut ZipWriter<Cursor<Vec<u8>>>,
    name: &str,
    descr: &str,
    shape: &[u64],
    values: impl Iterator<Item = T>,
) -> Result<(), String> {
    let file = format!("{name}.npy");
    // What could not be read again is not written.
    let length = file.len();
    if length > LONGEST_NAME {
        return Err(format!(
            "the name of an array would have {length} bytes; expected at most {LONGEST_NAME}"
        ));
    }
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        // The same values give the same bytes at any time.
        .last_modified_time(DateTime::default())
        .large_file(shape.iter().product::<u64>() > u64::from(u32::MAX) / 64);
    let started = archive.start_file(file, options);
    started.map_err(|error| error.to_string())?;
    let type_string = descr.parse().expect("one of NumPy's types");
    let written = (|| {
        let mut writer = npyz::WriteOptions::new()
            .dtype(DType::new_scalar(type_string))
            .shape(shape)
            .writer(archive)
            .begin_nd()?;
        writer.extend(values)?;
        writer.finish()
    })();
    written.map_err(|error: io::Error| error.to_string())
}

/// Adds keys and values as an array of strings `(n, 2)`; nothing if there are
/// none.
pub(crate) fn add_pairs(
    archive: &mut ZipWriter<Cursor<Vec<u8>>>,
    name: &str,
    pairs: &[(String, String)],
) -> Result<(), String> {
    if pairs.is_empty() {
        return Ok(());
    }
    let strings = || pairs.iter().flat_map(|(key, value)| [key, value]);
    let longest = strings().map(|s| s.chars().count()).max().unwrap_or(0);
    let descr = format!("<U{}", longest.max(1));
    let shape = [pairs.len() as u64, 2];
    add_array(archive, name, &descr, &shape, strings().cloned())
}

/// The arrays in an archive, still packed.
pub(crate) struct Archive<R> {
    zip: ZipArchive<R>,
    /// Names of its arrays, in the order of the archive.
    names: Vec<String>,
}

/// An array in an archive whose header was read.
pub(crate) type Member<'a, 'b, R> = PackedArray<&'a mut ZipFile<'b, R>>;

/// Deflated bytes unpack to at most so many times their number.
const DEFLATED: u64 = 1032;

impl<R: Read + Seek> Archive<R> {
    /// Reads the list of arrays, which has at most so many bytes.
    pub fn open(mut source: R, longest_list: u64) -> Result<Self, String> {
        let length = listed_bytes(&mut source).map_err(|error| error.to_string())?;
        if length > longest_list {
            return Err(format!(
                "its list of arrays has {length} bytes; expected at most {longest_list}"
            ));
        }
        let zip = ZipArchive::new(source).map_err(|error| error.to_string())?;
        let mut names = Vec::with_capacity(zip.len());
        if zip.has_duplicate_names() {
            return Err("two of its arrays have the same name".into());
        }
        let mut known = HashSet::new();
        for name in zip.file_names() {
            let name = name.map_err(|error| error.to_string())?;
            let length = name.len();
            if length > LONGEST_NAME {
                return Err(format!(
                    "the name of an array has {length} bytes; expected at most {LONGEST_NAME}"
                ));
            }
            let name = name.strip_suffix(".npy").unwrap_or(&name).to_owned();
            if !known.insert(name.clone()) {
                return Err(format!("two of its arrays have the name \"{name}\""));
            }
            names.push(name);
        }
        Ok(Self { zip, names })
    }

    /// The names of its arrays, each at its index.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Something of an array's header.
    pub fn peek<T>(
        &mut self,
        index: usize,
        of: impl FnOnce(&Member<R>) -> Result<T, String>,
    ) -> Result<T, String> {
        let Self { zip, names } = self;
        let found = member(zip, index).and_then(|mut file| of(&opened(&mut file)?));
        found.map_err(|why| format!("the array \"{}\" {why}", names[index]))
    }

    /// What is read of an array, which must be all of it: its end is where the array's is, and its
    /// checksum is right.
    pub fn read<T>(
        &mut self,
        index: usize,
        read: impl FnOnce(Member<R>) -> Result<T, String>,
    ) -> Result<T, String> {
        let Self { zip, names } = self;
        let found = member(zip, index).and_then(|mut file| {
            let found = read(opened(&mut file)?)?;
            // The checksum is compared when there is no more.
            match file.read(&mut [0]) {
                Ok(0) => Ok(found),
                Ok(_) => Err("has bytes behind its end".into()),
                Err(error) => Err(format!("is damaged: {error}")),
            }
        });
        found.map_err(|why| format!("the array \"{}\" {why}", names[index]))
    }

    /// The keys and values in an array of strings.
    pub fn pairs(&mut self, index: usize) -> Result<Vec<(String, String)>, String> {
        self.check_pairs(index)?;
        self.read(index, |array| {
            let strings: io::Result<Vec<String>> = array.into_vec();
            let strings = strings.map_err(|error| format!("cannot be read: {error}"))?;
            let pairs = strings.chunks_exact(2);
            Ok(pairs.map(|p| (p[0].clone(), p[1].clone())).collect())
        })
    }

    /// An error if an array of keys and values is longer than such are.
    pub fn check_pairs(&mut self, index: usize) -> Result<(), String> {
        let file = member(&mut self.zip, index)?;
        match file.size() {
            bytes if bytes > LONGEST_PAIRS => Err(format!(
                "the array \"{}\" has {bytes} bytes of text; expected at most {LONGEST_PAIRS}",
                self.names[index]
            )),
            _ => Ok(()),
        }
    }
}

fn member<R: Read + Seek>(zip: &mut ZipArchive<R>, index: usize) -> Result<ZipFile<'_, R>, String> {
    let file = zip.by_index(index);
    file.map_err(|error| format!("cannot be read: {error}"))
}

fn opened<'a, 'b, R: Read>(file: &'a mut ZipFile<'b, R>) -> Result<Member<'a, 'b, R>, String> {
    let (size, packed) = (file.size(), file.compressed_size());
    if size > packed.saturating_mul(DEFLATED) {
        return Err(format!(
            "announces {size} bytes, which its {packed} packed bytes cannot hold"
        ));
    }
    npy::open(file, size)
}

/// How many bytes the list of an archive has, by what stands at its end; 0 if nothing does,
/// which is an error of the archive.
fn listed_bytes(source: &mut (impl Read + Seek)) -> io::Result<u64> {
    /// Begins the end of an archive, of 22 bytes and a comment of at most 65535.
    const END: &[u8] = b"PK\x05\x06";
    /// Begins the place of the longer end that large archives have, of 20 bytes, before it.
    const PLACE: &[u8] = b"PK\x06\x07";
    let length = source.seek(SeekFrom::End(0))?;
    let start = length.saturating_sub(22 + 65535 + 20);
    source.seek(SeekFrom::Start(start))?;
    let mut tail = Vec::new();
    source.take(length - start).read_to_end(&mut tail)?;
    let number = |at: usize, bytes: &[u8]| {
        let bytes = bytes.get(at..at + 8);
        bytes.map_or(0, |b| {
            u64::from_le_bytes(b.try_into().expect("eight bytes"))
        })
    };
    let end = tail.windows(END.len()).rposition(|window| window == END);
    let Some(end) = end.filter(|end| end + 22 <= tail.len()) else {
        return Ok(0);
    };
    // Four bytes, behind the first twelve.
    let bytes = number(end + 8, &tail) >> 32;
    let place = end
        .checked_sub(20)
        .filter(|&at| tail[at..].starts_with(PLACE));
    let Some(place) = place else {
        return Ok(bytes);
    };
    source.seek(SeekFrom::Start(number(place + 8, &tail)))?;
    let mut long_end = Vec::new();
    source.take(56).read_to_end(&mut long_end)?;
    Ok(bytes.max(number(40, &long_end)).min(length))
}

/// The numbers of an array of `float32` or `float64`, row by row.
pub(crate) fn floats<'a>(
    array: NpyFile<impl Read + 'a>,
    types: &[&str],
) -> Result<Box<dyn Iterator<Item = Result<f64, String>> + 'a>, String> {
    if array.order() != npyz::Order::C {
        return Err("is stored column by column; expected row by row (C order)".into());
    }
    let descr = array.dtype().descr();
    let wrong = || format!("has the type {descr}; expected {}", types.join(" or "));
    let damaged = |error: io::Error| format!("is damaged: {error}");
    match array.try_data::<f64>() {
        Ok(doubles) => Ok(Box::new(doubles.map(move |x| x.map_err(damaged)))),
        Err(array) if types.contains(&"float32") => {
            let singles = array.try_data::<f32>().map_err(|_| wrong())?;
            Ok(Box::new(
                singles.map(move |x| x.map(f64::from).map_err(damaged)),
            ))
        }
        Err(_) => Err(wrong()),
    }
}
