//! NPZ: a zip archive of NumPy arrays, uncompressed as `numpy.savez` writes it.

use std::io::{Cursor, Read};

use capwalk_math::Rgb;
use capwalk_scene::Image;
use npyz::{DType, NpyFile, Order, TypeChar, WriterBuilder};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use super::{Layer, Picture};

/// The array of sample counts.
const SAMPLES: &str = "samples";
/// The array of keys and values.
const METADATA: &str = "metadata";

/// The bytes of an NPZ file.
pub(super) fn encode(picture: &Picture, [width, height]: [usize; 2]) -> Result<Vec<u8>, String> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let (width, height) = (width as u64, height as u64);
    for Layer { name, image } in &picture.layers {
        let pixels = image.pixels.iter().flat_map(|pixel| pixel.to_array());
        let values = pixels.map(|value| value as f32);
        add_array(&mut archive, name, "<f4", &[height, width, 3], values)?;
    }
    if let Some(samples) = &picture.samples {
        let values = samples.iter().copied();
        add_array(&mut archive, SAMPLES, "<u4", &[height, width], values)?;
    }
    if !picture.metadata.is_empty() {
        let strings = || {
            picture
                .metadata
                .iter()
                .flat_map(|(key, value)| [key, value])
        };
        let longest = strings().map(|s| s.chars().count()).max().unwrap_or(0);
        let descr = format!("<U{}", longest.max(1));
        let shape = [picture.metadata.len() as u64, 2];
        add_array(&mut archive, METADATA, &descr, &shape, strings().cloned())?;
    }
    let bytes = archive.finish().map_err(|error| error.to_string())?;
    Ok(bytes.into_inner())
}

fn add_array<T: npyz::Serialize>(
    archive: &mut ZipWriter<Cursor<Vec<u8>>>,
    name: &str,
    descr: &str,
    shape: &[u64],
    values: impl Iterator<Item = T>,
) -> Result<(), String> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        // The same picture gives the same bytes at any time.
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
    written.map_err(|error: std::io::Error| error.to_string())
}

/// The picture in the bytes of an NPZ file: arrays of shape `(height, width,
/// 3)`, or `(height, width)` for grey ones, of 4 or 8 byte floats.
pub(super) fn decode(bytes: &[u8]) -> Result<Picture, String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let mut picture = Picture::default();
    for i in 0..archive.len() {
        let file = archive.by_index(i).map_err(|error| error.to_string())?;
        let name = file.name().map_err(|error| error.to_string())?.into_owned();
        let name = name.strip_suffix(".npy").unwrap_or(&name);
        let in_array = |error: std::io::Error| format!("the array \"{name}\": {error}");
        let stored = file.size();
        let array = NpyFile::new(file).map_err(in_array)?;
        // Memory is taken for what the header promises: not more than there is.
        let items = array
            .shape()
            .iter()
            .try_fold(1_u64, |n, &m| n.checked_mul(m));
        let item = array.dtype().num_bytes().unwrap_or(1) as u64;
        if items
            .and_then(|n| n.checked_mul(item))
            .is_none_or(|size| size > stored)
        {
            let shape = array.shape();
            return Err(format!(
                "the array \"{name}\" ends before its shape {shape:?} is full"
            ));
        }
        let holds = |kind| match array.dtype() {
            DType::Plain(t) => t.type_char() == kind,
            _ => false,
        };
        match name {
            SAMPLES if holds(TypeChar::Uint) => {
                picture.samples = Some(array.into_vec().map_err(in_array)?);
            }
            METADATA if holds(TypeChar::UnicodeStr) => {
                let strings: Vec<String> = array.into_vec().map_err(in_array)?;
                let pairs = strings.chunks_exact(2);
                picture.metadata = pairs.map(|p| (p[0].clone(), p[1].clone())).collect();
            }
            _ => {
                let image = image(array).map_err(|why| format!("the array \"{name}\" {why}"))?;
                picture.push(name, image);
            }
        }
    }
    Ok(picture)
}

fn image(array: NpyFile<impl Read>) -> Result<Image, String> {
    let (height, width, channels) = match *array.shape() {
        [height, width] => (height, width, 1),
        [height, width, 3] => (height, width, 3),
        ref shape => {
            return Err(format!(
                "has the shape {shape:?}; expected (height, width, 3) or (height, width)"
            ));
        }
    };
    if array.order() != Order::C {
        return Err("is stored column by column; expected row by row (C order)".into());
    }
    let dtype = array.dtype();
    let values: Vec<f64> = match &dtype {
        DType::Plain(t) if t.type_char() == TypeChar::Float && t.size_field() == 4 => {
            let singles: Vec<f32> = array.into_vec().map_err(|error| error.to_string())?;
            singles.into_iter().map(f64::from).collect()
        }
        DType::Plain(t) if t.type_char() == TypeChar::Float && t.size_field() == 8 => {
            array.into_vec().map_err(|error| error.to_string())?
        }
        other => {
            let descr = other.descr();
            return Err(format!("has the type {descr}; expected float32 or float64"));
        }
    };
    let pixels = match channels {
        1 => values.into_iter().map(Rgb::splat).collect(),
        _ => values
            .chunks_exact(3)
            .map(|c| Rgb::new(c[0], c[1], c[2]))
            .collect(),
    };
    Ok(Image {
        width: width as usize,
        height: height as usize,
        pixels,
    })
}
