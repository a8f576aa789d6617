//! Images in NPZ files.

use std::io::{Cursor, Read, Seek};

use capwalk_math::Rgb;
use capwalk_scene::Image;
use npyz::{DType, TypeChar};
use zip::ZipWriter;

use super::layered::{Layer, LayeredImage};
use super::pixels::collect_pixels;
use crate::archive::{Archive, Member, add_array, add_pairs, floats};

/// The array of sample counts.
const SAMPLES: &str = "samples";
/// The array of keys and values.
const METADATA: &str = "metadata";

/// The most bytes that the list of an image's layers has: enough for thousands of them.
const LONGEST_LIST: u64 = 1 << 20;

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

/// An NPZ file of which the list of arrays was read. Layers are arrays of shape `(height,
/// width, 3)`, or `(height, width)` for grey ones, of 4 or 8 byte floats.
pub(super) struct NpzFile<R> {
    archive: Archive<R>,
    /// Names of layers, and which arrays they are.
    layers: Vec<(String, usize)>,
    samples: Option<usize>,
    metadata: Option<usize>,
}

impl<R: Read + Seek> NpzFile<R> {
    /// Reads the list of arrays.
    pub fn open(source: R) -> Result<Self, String> {
        let mut archive = Archive::open(source, LONGEST_LIST)?;
        let names = archive.names().to_vec();
        let mut holds = |index: usize, kind: TypeChar| {
            archive.peek(index, |array| {
                let dtype = array.dtype();
                Ok(matches!(dtype, DType::Plain(t) if t.type_char() == kind))
            })
        };
        let (mut layers, mut samples, mut metadata) = (Vec::new(), None, None);
        for (index, name) in names.into_iter().enumerate() {
            match name.as_str() {
                SAMPLES if holds(index, TypeChar::Uint)? => samples = Some(index),
                METADATA if holds(index, TypeChar::UnicodeStr)? => metadata = Some(index),
                _ => layers.push((name, index)),
            }
        }
        if let Some(index) = metadata {
            archive.check_pairs(index)?;
        }
        Ok(Self {
            archive,
            layers,
            samples,
            metadata,
        })
    }

    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.layers.iter().map(|(name, _)| name.as_str())
    }

    /// Width and height of a layer.
    pub fn size(&mut self, layer: usize) -> Result<[usize; 2], String> {
        let index = self.layers[layer].1;
        self.archive.peek(index, |array| Ok(shape(array)?.0))
    }

    pub fn image(&mut self, layer: usize) -> Result<Image, String> {
        let index = self.layers[layer].1;
        self.archive.read(index, |array| {
            let (size, channels) = shape(&array)?;
            let mut numbers = floats(array, &["float32", "float64"])?;
            let next = || {
                numbers
                    .next()
                    .unwrap_or_else(|| Err("ends too early".into()))
            };
            collect_pixels(size, next, |next| match channels {
                1 => Ok(Rgb::splat(next()?)),
                _ => Ok(Rgb::new(next()?, next()?, next()?)),
            })
        })
    }

    /// Samples of each pixel, of which there are so many.
    pub fn samples(&mut self, pixels: usize) -> Result<Option<Vec<u32>>, String> {
        let Some(index) = self.samples else {
            return Ok(None);
        };
        let counts = self.archive.read(index, |array| {
            if array.len() != pixels as u64 {
                let shape = array.shape();
                return Err(format!(
                    "has the shape {shape:?}; expected a count for each of {pixels} pixels"
                ));
            }
            let counts: std::io::Result<Vec<u32>> = array.into_vec();
            counts.map_err(|error| format!("cannot be read: {error}"))
        });
        counts.map(Some)
    }

    pub fn metadata(&mut self) -> Result<Vec<(String, String)>, String> {
        self.metadata
            .map_or(Ok(Vec::new()), |index| self.archive.pairs(index))
    }
}

/// Width and height of an array, and how many channels it has.
fn shape<R>(array: &Member<R>) -> Result<([usize; 2], usize), String>
where
    R: Read,
{
    if let &[height, width, ..] = array.shape()
        && (height == 0 || width == 0)
    {
        return Err(format!(
            "has no pixels: it is {width} wide and {height} high"
        ));
    }
    match *array.shape() {
        [height, width] | [height, width, 1] => Ok(([width as usize, height as usize], 1)),
        [height, width, 3] => Ok(([width as usize, height as usize], 3)),
        ref shape => Err(format!(
            "has the shape {shape:?}; expected (height, width, 3), (height, width, 1) or \
             (height, width)"
        )),
    }
}
