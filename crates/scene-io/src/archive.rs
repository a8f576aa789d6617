//! NPZ: a zip archive of NumPy arrays, uncompressed as `numpy.savez` writes it.

use std::io::{self, Cursor, Read};

use npyz::{DType, NpyFile, WriterBuilder};
use zip::read::ZipFile;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use crate::npy::{self, PackedArray};

/// Adds an array of a type in NumPy's notation. There must be as many values as
/// the shape says.
pub(crate) fn add_array<T: npyz::Serialize>(
    archive: &mut ZipWriter<Cursor<Vec<u8>>>,
    name: &str,
    descr: &str,
    shape: &[u64],
    values: impl Iterator<Item = T>,
) -> Result<(), String> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        // The same values give the same bytes at any time.
        .last_modified_time(DateTime::default())
        .large_file(shape.iter().product::<u64>() > u64::from(u32::MAX) / 64);
    let started = archive.start_file(format!("{name}.npy"), options);
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

/// An array of an archive.
pub(crate) type Entry<'a, 'b> = PackedArray<ZipFile<'a, Cursor<&'b [u8]>>>;

/// Deflated bytes unpack to at most so many times their number.
const DEFLATED: u64 = 1032;

/// The name and the header of an array in the archive.
pub(crate) fn open<'a, 'b>(
    archive: &'a mut ZipArchive<Cursor<&'b [u8]>>,
    index: usize,
) -> Result<(String, Entry<'a, 'b>), String> {
    let file = archive.by_index(index).map_err(|error| error.to_string())?;
    let name = file.name().map_err(|error| error.to_string())?.into_owned();
    let name = name.strip_suffix(".npy").unwrap_or(&name).to_owned();
    let size = file
        .size()
        .min(file.compressed_size().saturating_mul(DEFLATED));
    let array = npy::open(file, size).map_err(|why| format!("the array \"{name}\" {why}"))?;
    Ok((name, array))
}

/// The keys and values in an array of strings.
pub(crate) fn pairs(array: NpyFile<impl Read>) -> io::Result<Vec<(String, String)>> {
    let strings: Vec<String> = array.into_vec()?;
    let pairs = strings.chunks_exact(2);
    Ok(pairs.map(|p| (p[0].clone(), p[1].clone())).collect())
}
