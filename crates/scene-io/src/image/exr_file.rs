//! Reading EXR files: the headers, then the channels of one layer.

use std::collections::HashMap;
use std::io::{self, BufRead, Read, Seek, SeekFrom};

use capwalk_math::Rgb;
use capwalk_scene::Image;
use exr::block::reader::ChunksReader;
use exr::block::{self, UncompressedBlock};
use exr::meta::attribute::LevelMode;
use exr::meta::header::Header;
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::{AttributeValue, SampleType, Text, Vec2, f16};

use super::exr::{COLOURS, PREFIX, SAMPLES};
use super::layered::VALUE;
use super::pixels::reserve;

/// Bytes of pixels for each byte of a file, at most: more than any of the compressions reaches
/// (deflate 1032, of three bytes in four).
const MOST_COMPRESSION: usize = 2048;
/// Bytes of a chunk of pixels, at least: its place in the table, its own place, its length.
const LEAST_CHUNK: usize = 16;
/// Bytes of a chunk of pixels, at most, of which one is unpacked at a time. Those of images of
/// 32,768 pixels a row with a dozen channels have up to 400 MB.
const LARGEST_CHUNK: usize = 1 << 29;
/// Channels of a file, at most.
const MOST_CHANNELS: usize = 16_384;
/// Bytes of all headers, at most: enough for these channels and for notes of a megabyte.
const LONGEST_HEADER: u64 = 1 << 21;

/// Attributes of all headers, at most: each costs microseconds, and files have dozens.
const MOST_ATTRIBUTES: usize = 1 << 14;

/// An EXR file of which the headers were read.
pub(super) struct ExrFile<R> {
    source: R,
    layers: Vec<ExrLayer>,
    samples: Option<Channels>,
    metadata: Vec<(String, String)>,
    /// Its bytes.
    length: u64,
}

struct ExrLayer {
    name: String,
    channels: Channels,
}

/// Channels of one part of a file.
#[derive(Clone, Copy)]
struct Channels {
    part: usize,
    /// Red, green and blue, which are the same for a grey layer.
    of_colours: [usize; 3],
    /// Width and height.
    size: [usize; 2],
}

impl<R: BufRead + Seek> ExrFile<R> {
    /// Reads the headers.
    pub fn open(mut source: R) -> Result<Self, String> {
        let (meta, length) = read_headers(&mut source)?;
        let (mut layers, mut samples) = (Vec::new(), None);
        for (part, header) in meta.headers.iter().enumerate() {
            let names = channel_names(header)?;
            let Vec2(width, height) = header.layer_size;
            let channels = |of_colours| Channels {
                part,
                of_colours,
                size: [width, height],
            };
            let mut named = Vec::new();
            for (index, (name, channel)) in names.into_iter().zip(&header.channels.list).enumerate()
            {
                match name == SAMPLES && channel.sample_type == SampleType::U32 {
                    true => samples = Some(channels([index; 3])),
                    false => named.push((name, index)),
                }
            }
            let of_part = layers_of(&named).into_iter();
            layers.extend(of_part.map(|(name, of_colours)| ExrLayer {
                name,
                channels: channels(of_colours),
            }));
        }
        // Stable: the value, then the others as their channels are sorted.
        layers.sort_by_key(|layer: &ExrLayer| layer.name != VALUE);
        Ok(Self {
            source,
            layers,
            samples,
            metadata: metadata(&meta),
            length,
        })
    }

    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.layers.iter().map(|layer| layer.name.as_str())
    }

    /// Width and height of a layer.
    pub fn size(&self, layer: usize) -> [usize; 2] {
        self.layers[layer].channels.size
    }

    pub fn image(&mut self, layer: usize) -> Result<Image, String> {
        let channels = self.layers[layer].channels;
        let [width, height] = channels.size;
        let mut pixels = reserve(channels.size)?;
        // What no chunk fills is no number.
        pixels.resize(width * height, Rgb::splat(f64::NAN));
        self.each_line(channels, |colour, start, numbers: &[f32]| {
            let end = start + numbers.len();
            let row = pixels.get_mut(start..end).unwrap_or_default();
            for (pixel, &number) in row.iter_mut().zip(numbers) {
                let channels = [&mut pixel.r, &mut pixel.g, &mut pixel.b];
                *channels[colour] = f64::from(number);
            }
        })?;
        Ok(Image {
            width,
            height,
            pixels,
        })
    }

    /// Samples of each pixel, of which there are so many.
    pub fn samples(&mut self, pixels: usize) -> Result<Option<Vec<u32>>, String> {
        let Some(channels) = self.samples else {
            return Ok(None);
        };
        let [width, height] = channels.size;
        if width.checked_mul(height) != Some(pixels) {
            return Err(format!(
                "there are {width} x {height} sample counts; expected one for each of {pixels} pixels"
            ));
        }
        let mut counts = reserve(channels.size)?;
        counts.resize(pixels, 0);
        self.each_line(channels, |_, start, numbers: &[u32]| {
            let end = start + numbers.len();
            let row = counts.get_mut(start..end).unwrap_or_default();
            row.copy_from_slice(&numbers[..row.len()]);
        })?;
        Ok(Some(counts))
    }

    pub fn metadata(&self) -> &[(String, String)] {
        &self.metadata
    }

    /// Shows pieces of rows of these channels, in any order: which colour it is, which pixel it
    /// begins at, row by row, and its numbers.
    fn each_line<T: FromSample>(
        &mut self,
        channels: Channels,
        mut show: impl FnMut(usize, usize, &[T]),
    ) -> Result<(), String> {
        let text = |error: exr::error::Error| error.to_string();
        self.source.rewind().map_err(|error| error.to_string())?;
        let mut tracked = Tracked::new(&mut self.source);
        let reader = block::read(&mut tracked, false).map_err(text)?;
        let parts = reader.headers().len();
        let header = reader.headers().get(channels.part).cloned();
        let header = header.ok_or("it changed while it was read")?;
        let in_full = Vec2(0, 0);
        let chunks = reader.filter_chunks(false, |_, _, block| {
            block.layer == channels.part && block.level == in_full
        });
        let blocks = chunks.map_err(text)?.sequential_decompressor(false);
        let mut numbers = Vec::new();
        for block in blocks {
            let block: UncompressedBlock = block.map_err(text)?;
            for line in block.lines(&header.channels) {
                let place = line.location;
                let colours = channels.of_colours.iter().enumerate();
                let mut colours = colours
                    .filter(|(_, index)| **index == place.channel)
                    .peekable();
                if colours.peek().is_none() {
                    continue;
                }
                let kind = header.channels.list[place.channel].sample_type;
                numbers.clear();
                for i in 0..place.sample_count {
                    numbers.push(T::of(kind, line.value, i));
                }
                let start = place.position.y() * channels.size[0] + place.position.x();
                colours.for_each(|(colour, _)| show(colour, start, &numbers));
            }
        }
        // The last chunk that was read is the last one, if there are no others.
        let is_all = parts == 1 && has_one_level(&header);
        match self.length.saturating_sub(tracked.end) {
            behind if is_all && behind > 0 => {
                Err(format!("it has {behind} bytes behind its last pixels"))
            }
            _ => Ok(()),
        }
    }
}

/// True if a part has its pixels in full size only.
fn has_one_level(header: &Header) -> bool {
    match header.blocks {
        BlockDescription::Tiles(tiles) => tiles.level_mode == LevelMode::Singular,
        BlockDescription::ScanLines => true,
    }
}

/// A source that knows how far it was read.
struct Tracked<'a, R> {
    source: &'a mut R,
    position: u64,
    /// The furthest position.
    end: u64,
}

impl<'a, R> Tracked<'a, R> {
    /// A source that stands at its beginning.
    fn new(source: &'a mut R) -> Self {
        Self {
            source,
            position: 0,
            end: 0,
        }
    }
}

impl<R: Read> Read for Tracked<'_, R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let count = self.source.read(bytes)?;
        self.position += count as u64;
        self.end = self.end.max(self.position);
        Ok(count)
    }
}

impl<R: Seek> Seek for Tracked<'_, R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.position = self.source.seek(to)?;
        Ok(self.position)
    }
}

/// Numbers as they are wanted, whichever type the file has.
trait FromSample {
    /// The number with this index among those of `bytes`.
    fn of(kind: SampleType, bytes: &[u8], index: usize) -> Self;
}

/// Some bytes of others, zero where these end.
fn part<const N: usize>(bytes: &[u8], index: usize) -> [u8; N] {
    let part = bytes.get(index * N..(index + 1) * N);
    part.and_then(|part| part.try_into().ok()).unwrap_or([0; N])
}

impl FromSample for u32 {
    fn of(_: SampleType, bytes: &[u8], index: usize) -> Self {
        Self::from_ne_bytes(part(bytes, index))
    }
}

impl FromSample for f32 {
    fn of(kind: SampleType, bytes: &[u8], index: usize) -> Self {
        match kind {
            SampleType::F16 => f16::from_ne_bytes(part(bytes, index)).to_f32(),
            SampleType::F32 => Self::from_ne_bytes(part(bytes, index)),
            SampleType::U32 => u32::from_ne_bytes(part(bytes, index)) as Self,
        }
    }
}

/// The headers, which announce no more than the file can hold, and the length of the file.
fn read_headers<R: BufRead + Seek>(source: &mut R) -> Result<(MetaData, u64), String> {
    let length = source.seek(SeekFrom::End(0)).and_then(|length| {
        source.rewind()?;
        Ok(length)
    });
    let length = length.map_err(|error| error.to_string())?;
    if attributes(&mut source.take(LONGEST_HEADER)).unwrap_or(0) > MOST_ATTRIBUTES {
        return Err(format!(
            "its headers have more than {MOST_ATTRIBUTES} attributes, which is the most that is read"
        ));
    }
    source.rewind().map_err(|error| error.to_string())?;
    let mut start = source.take(LONGEST_HEADER);
    let meta = MetaData::read_from_buffered(&mut start, false);
    let meta = meta.map_err(|error| match start.limit() {
        0 => format!(
            "its header has more than {LONGEST_HEADER} bytes, which is the most that is read"
        ),
        _ => error.to_string(),
    })?;
    check_size(&meta, usize::try_from(length).unwrap_or(usize::MAX))?;
    Ok((meta, length))
}

/// How many attributes headers have, counted up to more than the most; an error where they end
/// too early.
fn attributes(start: &mut impl BufRead) -> io::Result<usize> {
    /// The flag of files with several parts, whose headers end with an empty one.
    const PARTS: u32 = 0x1000;
    let mut word = [0; 4];
    start.read_exact(&mut word)?;
    start.read_exact(&mut word)?;
    let has_parts = u32::from_le_bytes(word) & PARTS != 0;
    let (mut count, mut of_part) = (0, 0);
    while count <= MOST_ATTRIBUTES {
        let mut name = Vec::new();
        start.read_until(0, &mut name)?;
        if name.len() <= 1 {
            if !has_parts || of_part == 0 {
                break;
            }
            of_part = 0;
            continue;
        }
        // Its type, its length, and so many bytes.
        start.read_until(0, &mut name)?;
        start.read_exact(&mut word)?;
        let length = u64::from(u32::from_le_bytes(word));
        io::copy(&mut start.by_ref().take(length), &mut io::sink())?;
        (count, of_part) = (count + 1, of_part + 1);
    }
    Ok(count)
}

/// Compares what headers announce with the length of the file, before memory is taken for it.
fn check_size(meta: &MetaData, length: usize) -> Result<(), String> {
    let (mut channels, mut chunks, mut pixel_bytes, mut chunk_bytes) = (0, 0_usize, 0_usize, 0);
    for part in &meta.headers {
        if part.deep {
            return Err("it has deep data; expected one number for each pixel and channel".into());
        }
        let Vec2(width, height) = part.layer_size;
        let row = width.saturating_mul(part.channels.bytes_per_pixel);
        let pixels_of_chunk = match part.blocks {
            BlockDescription::Tiles(tiles) => {
                let Vec2(width, height) = tiles.tile_size;
                width.saturating_mul(height)
            }
            BlockDescription::ScanLines => {
                let rows = part.compression.scan_lines_per_block();
                width.saturating_mul(rows.min(height))
            }
        };
        let of_chunk = pixels_of_chunk.saturating_mul(part.channels.bytes_per_pixel);
        chunk_bytes = of_chunk.max(chunk_bytes);
        pixel_bytes = pixel_bytes.saturating_add(row.saturating_mul(height));
        chunks = chunks.saturating_add(part.chunk_count);
        channels += part.channels.list.len();
    }
    if channels > MOST_CHANNELS {
        return Err(format!(
            "it has {channels} channels; at most {MOST_CHANNELS} are read"
        ));
    }
    let least = (pixel_bytes / MOST_COMPRESSION).max(chunks.saturating_mul(LEAST_CHUNK));
    if least > length {
        return Err(format!(
            "its header announces {pixel_bytes} bytes of pixels, which its {length} bytes cannot \
             hold"
        ));
    }
    match chunk_bytes > LARGEST_CHUNK {
        true => Err(format!(
            "{chunk_bytes} bytes of its pixels are stored together; expected at most \
             {LARGEST_CHUNK}"
        )),
        false => Ok(()),
    }
}

/// All texts among the attributes.
fn metadata(meta: &MetaData) -> Vec<(String, String)> {
    let shared = meta
        .headers
        .iter()
        .map(|part| &part.shared_attributes.other);
    let own = meta.headers.iter().map(|part| &part.own_attributes.other);
    let mut metadata = Vec::new();
    for (key, value) in shared.chain(own).flatten() {
        if let AttributeValue::Text(value) = value {
            let key = string(key);
            let key = key.strip_prefix(PREFIX).unwrap_or(&key).to_owned();
            metadata.push((key, string(value)));
        }
    }
    metadata.sort();
    metadata.dedup();
    metadata
}

fn string(text: &Text) -> String {
    String::from_utf8_lossy(text.as_slice()).into_owned()
}

/// The names of a part's channels, with that of the part before them.
fn channel_names(header: &Header) -> Result<Vec<String>, String> {
    let prefix = header.own_attributes.layer_name.as_ref().map(string);
    let names = header.channels.list.iter().map(|channel| {
        let name = string(&channel.name);
        let name = match &prefix {
            // Some writers repeat the part's name, some do not.
            Some(prefix) if !name.starts_with(&format!("{prefix}.")) => {
                format!("{prefix}.{name}")
            }
            _ => name,
        };
        match channel.sampling == Vec2(1, 1) {
            true => Ok(name),
            false => Err(format!(
                "the channel \"{name}\" is subsampled; expected all pixels"
            )),
        }
    });
    names.collect()
}

/// Groups channels into layers: three that differ in an ending of R, G, B (or
/// X, Y, Z) are a colour, each other one is grey.
fn layers_of(channels: &[(String, usize)]) -> Vec<(String, [usize; 3])> {
    // The first of several with one name.
    let mut places = HashMap::new();
    for (name, index) in channels {
        places.entry(name.as_str()).or_insert(*index);
    }
    let mut layers: Vec<(String, [usize; 3])> = Vec::new();
    let mut taken = std::collections::HashSet::new();
    for (name, index) in channels {
        let (prefix, last) = match name.rsplit_once('.') {
            Some((prefix, last)) => (format!("{prefix}."), last),
            None => (String::new(), name.as_str()),
        };
        let triples = [COLOURS, ["X", "Y", "Z"]];
        let triple = triples.iter().find(|triple| triple.contains(&last));
        let colours = triple.and_then(|triple| {
            let place = |c: &str| places.get(format!("{prefix}{c}").as_str()).copied();
            let [r, g, b] = triple.map(place);
            Some([r?, g?, b?])
        });
        let layer = match (colours, prefix.strip_suffix('.')) {
            (Some(colours), Some(prefix)) => (prefix.to_owned(), colours),
            (Some(colours), None) => (VALUE.to_owned(), colours),
            // Luminance alone is a grey image.
            (None, _) if name == "Y" => (VALUE.to_owned(), [*index; 3]),
            (None, _) => (name.clone(), [*index; 3]),
        };
        if taken.insert(layer.0.clone()) {
            layers.push(layer);
        }
    }
    layers
}

/// The layer that is an image by itself, of the bytes of a file, if its size is not refused.
pub(crate) fn decode_value(
    bytes: &[u8],
    most_pixels: u64,
    refuse: impl FnOnce([usize; 2]) -> Result<(), String>,
) -> Result<Image, String> {
    let mut file = ExrFile::open(std::io::Cursor::new(bytes))?;
    let layer = file.names().position(|name| name == VALUE);
    let layer = layer.ok_or("it has no channels R, G, B or Y")?;
    let [width, height] = file.size(layer);
    if (width as u64).saturating_mul(height as u64) > most_pixels {
        return Err(format!(
            "it has {width} x {height} pixels; expected at most {most_pixels} in all"
        ));
    }
    refuse([width, height])?;
    file.image(layer)
}
