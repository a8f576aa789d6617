//! Writing EXR files: single precision, one channel per layer and colour.

use std::io::Cursor;

use exr::image::Blocks;
use exr::image::write::WritableImage;
use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Compression, Encoding, FlatSamples, ImageAttributes,
    LayerAttributes, LineOrder, Text, Vec2,
};

use super::layered::{Layer, LayeredImage, VALUE};

/// Metadata keys get this prefix, so that they cannot meet EXR's own names.
pub(super) const PREFIX: &str = "capwalk:";
/// The channel of sample counts.
pub(super) const SAMPLES: &str = "samples";
pub(super) const COLOURS: [&str; 3] = ["R", "G", "B"];

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
