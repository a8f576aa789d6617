//! Images in NPZ files.

use std::io::{Cursor, Read};

use capwalk_math::Rgb;
use capwalk_scene::Image;
use npyz::{DType, NpyFile, Order, TypeChar};
use zip::{ZipArchive, ZipWriter};

use super::layered::{Layer, LayeredImage};
use crate::archive::{add_array, add_pairs, open, pairs};

/// The array of sample counts.
const SAMPLES: &str = "samples";
/// The array of keys and values.
const METADATA: &str = "metadata";

/// The bytes of an NPZ file.
pub(super) fn encode(
    layered: &LayeredImage,
    [width, height]: [usize; 2],
) -> Result<Vec<u8>, String> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let (width, height) = (width as u64, height as u64);
    for Layer { name, image } in &layered.layers {
        let pixels = image.pixels.iter().flat_map(|pixel| pixel.to_array());
        let values = pixels.map(|value| value as f32);
        add_array(&mut archive, name, "<f4", &[height, width, 3], values)?;
    }
    if let Some(samples) = &layered.samples {
        let values = samples.iter().copied();
        add_array(&mut archive, SAMPLES, "<u4", &[height, width], values)?;
    }
    add_pairs(&mut archive, METADATA, &layered.metadata)?;
    let bytes = archive.finish().map_err(|error| error.to_string())?;
    Ok(bytes.into_inner())
}

/// The layers in an NPZ file: arrays of shape `(height, width,
/// 3)`, or `(height, width)` for grey ones, of 4 or 8 byte floats.
pub(super) fn decode(bytes: &[u8]) -> Result<LayeredImage, String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let mut layered = LayeredImage::default();
    for i in 0..archive.len() {
        let (name, array) = open(&mut archive, i)?;
        let in_array = |error: std::io::Error| format!("the array \"{name}\": {error}");
        let holds = |kind| match array.dtype() {
            DType::Plain(t) => t.type_char() == kind,
            _ => false,
        };
        match name.as_str() {
            SAMPLES if holds(TypeChar::Uint) => {
                layered.samples = Some(array.into_vec().map_err(in_array)?);
            }
            METADATA if holds(TypeChar::UnicodeStr) => {
                layered.metadata = pairs(array).map_err(in_array)?;
            }
            _ => {
                let image = image(array).map_err(|why| format!("the array \"{name}\" {why}"))?;
                layered.push(&name, image);
            }
        }
    }
    Ok(layered)
}

fn image(array: NpyFile<impl Read>) -> Result<Image, String> {
    let (height, width, channels) = match *array.shape() {
        [height, width] | [height, width, 1] => (height, width, 1),
        [height, width, 3] => (height, width, 3),
        ref shape => {
            return Err(format!(
                "has the shape {shape:?}; expected (height, width, 3), (height, width, 1) or \
                 (height, width)"
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
