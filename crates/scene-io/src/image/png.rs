//! PNG: 8 bits per channel, sRGB.

use super::drawing::Raster;

/// The bytes of a PNG file with metadata as text chunks.
pub(super) fn encode(raster: &Raster, metadata: &[(String, String)]) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let encoded = (|| {
        let mut encoder = png::Encoder::new(&mut bytes, raster.width as u32, raster.height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        for (key, value) in metadata {
            // International text: UTF-8.
            encoder.add_itxt_chunk(key.clone(), value.clone())?;
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(raster.colours.as_flattened())?;
        writer.finish()
    })();
    match encoded {
        Ok(()) => Ok(bytes),
        Err(error) => Err(error.to_string()),
    }
}
