//! EXR: single precision, one channel per layer and colour.

use std::io::Cursor;

use capwalk_math::Rgb;
use capwalk_scene::Image;
use exr::image::write::WritableImage;
use exr::image::{Blocks, read::read};
use exr::meta::MetaData;
use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Compression, Encoding, FlatImage, FlatSamples,
    ImageAttributes, LayerAttributes, LineOrder, ReadChannels, ReadLayers, Text, Vec2,
};

use super::layered::{Layer, LayeredImage, VALUE};

/// Metadata keys get this prefix, so that they cannot meet EXR's own names.
const PREFIX: &str = "capwalk:";
/// The channel of sample counts.
const SAMPLES: &str = "samples";
const COLOURS: [&str; 3] = ["R", "G", "B"];
/// Bytes of pixels for each byte of a file, at most: more than any of the compressions reaches
/// (deflate 1032, of three bytes in four).
const MOST_COMPRESSION: usize = 2048;
/// Bytes of a chunk of pixels, at least: its place in the table, its own place, its length.
const LEAST_CHUNK: usize = 16;
/// Channels of a file, at most; their names are compared with each other.
const MOST_CHANNELS: usize = 16_384;

/// The bytes of an EXR file: all channels in one part, losslessly compressed.
pub(crate) fn encode(
    layered: &LayeredImage,
    [width, height]: [usize; 2],
) -> Result<Vec<u8>, String> {
    let mut channels = Vec::new();
    for Layer { name, image } in &layered.layers {
        for (i, colour) in COLOURS.iter().enumerate() {
            let name = match name.as_str() {
                VALUE => (*colour).to_owned(),
                _ => format!("{name}.{colour}"),
            };
            let values = image.pixels.iter().map(|pixel| pixel[i] as f32).collect();
            channels.push(AnyChannel::new(text(&name), FlatSamples::F32(values)));
        }
    }
    if let Some(samples) = &layered.samples {
        let values = FlatSamples::U32(samples.clone());
        channels.push(AnyChannel::new(text(SAMPLES), values));
    }
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let layer = exr::image::Layer::new(
        (width, height),
        LayerAttributes::default(),
        encoding,
        AnyChannels::sort(channels.into()),
    );
    let attributes = ImageAttributes::with_size(Vec2(width, height));
    let mut image = exr::image::Image::new(attributes, layer);
    for (key, value) in &layered.metadata {
        let key = text(&format!("{PREFIX}{key}"));
        image
            .attributes
            .other
            .insert(key, AttributeValue::Text(text(value)));
    }
    let mut bytes = Cursor::new(Vec::new());
    image
        .write()
        .to_buffered(&mut bytes)
        .map_err(|error| error.to_string())?;
    let mut bytes = bytes.into_inner();
    sort_attributes(&mut bytes);
    Ok(bytes)
}

/// Text as UTF-8, which is what OpenEXR stores.
fn text(string: &str) -> Text {
    Text::from_slice_unchecked(string.as_bytes())
}

/// Orders the attributes of a one-part file by name. The library writes custom
/// ones in the order of a hash table, another one each time. Offsets later in
/// the file stay right, since the header keeps its length.
fn sort_attributes(bytes: &mut [u8]) {
    // Magic number and version, then attributes until an empty name:
    // name 0, type 0, length (four bytes, little-endian), value.
    const START: usize = 8;
    let mut attributes: Vec<Vec<u8>> = Vec::new();
    let mut at = START;
    while bytes[at] != 0 {
        let start = at;
        for _ in 0..2 {
            let length = bytes[at..].iter().position(|&b| b == 0);
            at += length.expect("names end") + 1;
        }
        let length = bytes[at..at + 4].try_into().expect("four bytes");
        at += 4 + u32::from_le_bytes(length) as usize;
        attributes.push(bytes[start..at].to_vec());
    }
    attributes.sort();
    bytes[START..at].copy_from_slice(&attributes.concat());
}

/// Compares what the header announces with the length of the file, before the library takes
/// memory for it.
fn check_size(bytes: &[u8]) -> Result<(), String> {
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false);
    let meta = meta.map_err(|error| error.to_string())?;
    let (mut channels, mut chunks, mut pixel_bytes) = (0, 0_usize, 0_usize);
    for part in &meta.headers {
        let Vec2(width, height) = part.layer_size;
        let of_pixel = part.channels.bytes_per_pixel;
        let of_part = width.saturating_mul(height).saturating_mul(of_pixel);
        pixel_bytes = pixel_bytes.saturating_add(of_part);
        chunks = chunks.saturating_add(part.chunk_count);
        channels += part.channels.list.len();
    }
    if channels > MOST_CHANNELS {
        return Err(format!(
            "it has {channels} channels; at most {MOST_CHANNELS} are read"
        ));
    }
    let length = bytes.len();
    let least = (pixel_bytes / MOST_COMPRESSION).max(chunks.saturating_mul(LEAST_CHUNK));
    match least > length {
        true => Err(format!(
            "its header announces {pixel_bytes} bytes of pixels, which its {length} bytes cannot \
             hold"
        )),
        false => Ok(()),
    }
}

/// The layers in all parts of an EXR file.
pub(crate) fn decode(bytes: &[u8]) -> Result<LayeredImage, String> {
    check_size(bytes)?;
    let image: FlatImage = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(|error| error.to_string())?;
    let mut layered = LayeredImage::default();
    let shared = image.attributes.other.iter();
    let of_parts = image
        .layer_data
        .iter()
        .flat_map(|part| &part.attributes.other);
    for (key, value) in shared.chain(of_parts) {
        if let AttributeValue::Text(value) = value {
            let key = string(key);
            let key = key.strip_prefix(PREFIX).unwrap_or(&key).to_owned();
            layered.metadata.push((key, string(value)));
        }
    }
    layered.metadata.sort();
    layered.metadata.dedup();
    for part in image.layer_data {
        let Vec2(width, height) = part.size;
        let prefix = part.attributes.layer_name.as_ref().map(string);
        let mut channels: Vec<(String, FlatSamples)> = Vec::new();
        for channel in part.channel_data.list {
            let name = string(&channel.name);
            let name = match &prefix {
                // Some writers repeat the part's name, some do not.
                Some(prefix) if !name.starts_with(&format!("{prefix}.")) => {
                    format!("{prefix}.{name}")
                }
                _ => name,
            };
            if channel.sampling != Vec2(1, 1) {
                return Err(format!(
                    "the channel \"{name}\" is subsampled; expected all pixels"
                ));
            }
            match channel.sample_data {
                FlatSamples::U32(counts) if name == SAMPLES => layered.samples = Some(counts),
                values => channels.push((name, values)),
            }
        }
        layered.layers.extend(layers(channels, width, height));
    }
    // Stable: the value, then the others as their channels are sorted.
    layered.layers.sort_by_key(|layer| layer.name != VALUE);
    Ok(layered)
}

fn string(text: &Text) -> String {
    String::from_utf8_lossy(text.as_slice()).into_owned()
}

/// Groups channels into layers: three that differ in an ending of R, G, B (or
/// X, Y, Z) are a colour, each other one is grey.
fn layers(channels: Vec<(String, FlatSamples)>, width: usize, height: usize) -> Vec<Layer> {
    let values = |name: &str| {
        let (_, samples) = channels.iter().find(|(other, _)| other == name)?;
        let values: Vec<f64> = samples.values_as_f32().map(f64::from).collect();
        Some(values)
    };
    let image = |[r, g, b]: [&[f64]; 3]| Image {
        width,
        height,
        pixels: (0..width * height)
            .map(|i| Rgb::new(r[i], g[i], b[i]))
            .collect(),
    };
    let mut layers: Vec<Layer> = Vec::new();
    for (name, _) in &channels {
        let (prefix, last) = match name.rsplit_once('.') {
            Some((prefix, last)) => (format!("{prefix}."), last),
            None => (String::new(), name.as_str()),
        };
        let triples = [COLOURS, ["X", "Y", "Z"]];
        let triple = triples.iter().find(|triple| triple.contains(&last));
        let colours = triple.and_then(|triple| {
            let [r, g, b] = triple.map(|c| values(&format!("{prefix}{c}")));
            Some([r?, g?, b?])
        });
        let layer = match &colours {
            Some([r, g, b]) => Layer {
                name: match prefix.strip_suffix('.') {
                    Some(prefix) => prefix.into(),
                    None => VALUE.into(),
                },
                image: image([r, g, b]),
            },
            None => {
                let grey = values(name).expect("the name is in the list");
                Layer {
                    // Luminance alone is a grey image.
                    name: if name == "Y" {
                        VALUE.into()
                    } else {
                        name.clone()
                    },
                    image: image([&grey; 3]),
                }
            }
        };
        if layers.iter().all(|other| other.name != layer.name) {
            layers.push(layer);
        }
    }
    layers
}
