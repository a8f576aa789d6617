//! Image files as textures: PNG, JPEG, BMP, TGA, Radiance HDR and OpenEXR, as
//! linear numbers.

use std::io::Cursor;

use capwalk_scene::memory::{OF_SKY_TEXEL, available, mib};
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader};

use crate::image::decode_exr_value;
use crate::value::linear_of_srgb;

/// The texels of an image file, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BitmapFile {
    pub width: u32,
    pub height: u32,
    /// 1 or 3.
    pub channels: usize,
    pub data: Vec<f64>,
}

/// What an image becomes.
#[derive(Clone, Copy)]
pub(crate) enum BitmapUse {
    Texture,
    Environment,
}

impl BitmapUse {
    /// Bytes of a texel of so many channels, and of what is made of it.
    fn bytes(self, channels: u64) -> u64 {
        match self {
            Self::Texture => 8 * channels,
            // Greys are copied to three channels.
            Self::Environment if channels == 1 => 8 + 24 + OF_SKY_TEXEL,
            Self::Environment => 24 + OF_SKY_TEXEL,
        }
    }
}

/// Which channels of an image are read.
#[derive(Clone, Copy)]
pub(crate) enum Channels {
    /// Red, green and blue, or the grey of an image without colours.
    Colour,
    /// One of red, green, blue and alpha, counted from 0.
    One(usize),
}

/// The most pixels that are read: more than textures have. In double precision they take 6 GiB.
const MOST_PIXELS: u64 = 1 << 28;

/// Pixels for each byte of a file, at most: more than any of the compressions reaches (deflate
/// 1032 bytes of eight pixels).
const MOST_COMPRESSION: u64 = 1 << 14;

/// Endings of the names of files, in small letters.
pub(crate) const ENDINGS: [&str; 7] = ["png", "jpg", "jpeg", "bmp", "tga", "hdr", "exr"];

/// The image in the bytes of a file whose name has this ending. Files with 8 or
/// 16 bits are decoded from sRGB to linear light, unless they are `raw`. An error
/// if there is no memory for what it becomes.
pub(crate) fn read(
    bytes: &[u8],
    ending: &str,
    raw: bool,
    wanted: Channels,
    becomes: BitmapUse,
) -> Result<BitmapFile, String> {
    let format = match ending {
        "exr" => return read_exr(bytes, becomes),
        "png" => ImageFormat::Png,
        "jpg" | "jpeg" => ImageFormat::Jpeg,
        "bmp" => ImageFormat::Bmp,
        "tga" => ImageFormat::Tga,
        "hdr" => ImageFormat::Hdr,
        _ => {
            return Err(format!(
                "expected a file that ends in {}",
                ENDINGS.join(", ")
            ));
        }
    };
    check_size(bytes, format, becomes)?;
    let image = ImageReader::with_format(Cursor::new(bytes), format).decode();
    let image = image.map_err(|error| error.to_string())?;
    let (width, height) = (image.width(), image.height());
    let channels = match wanted {
        Channels::Colour if image.color().has_color() => 3,
        Channels::Colour | Channels::One(_) => 1,
    };
    let data = match (&image, channels) {
        (DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_), _) => {
            let rgb = image.into_rgb32f().into_raw();
            return finish(width, height, 3, doubles(&rgb, |x| x.into())?);
        }
        _ if image.color().bytes_per_pixel() / image.color().channel_count() == 1 => {
            let bytes = match (wanted, channels) {
                (Channels::One(channel), _) => one(&image.into_rgba8(), channel),
                (_, 1) => image.into_luma8().into_raw(),
                _ => image.into_rgb8().into_raw(),
            };
            let decoded = decoded(u8::MAX.into(), raw);
            doubles(&bytes, |x| decoded[usize::from(x)])?
        }
        _ => {
            let words = match (wanted, channels) {
                (Channels::One(channel), _) => one(&image.into_rgba16(), channel),
                (_, 1) => image.into_luma16().into_raw(),
                _ => image.into_rgb16().into_raw(),
            };
            let decoded = decoded(u16::MAX, raw);
            doubles(&words, |x| decoded[usize::from(x)])?
        }
    };
    finish(width, height, channels, data)
}

/// What whole numbers from 0 to the `largest` stand for: fractions of it, from sRGB to linear light
/// unless they are `raw`. An image has each of them many times.
fn decoded(largest: u16, raw: bool) -> Vec<f64> {
    let fractions = (0..=largest).map(|x| f64::from(x) / f64::from(largest));
    match raw {
        true => fractions.collect(),
        false => fractions.map(linear_of_srgb).collect(),
    }
}

/// One channel of four.
fn one<T: Copy>(rgba: &[T], channel: usize) -> Vec<T> {
    let pixels = rgba.as_chunks::<4>().0.iter();
    pixels.map(|pixel| pixel[channel]).collect()
}

/// An error if the header announces more pixels than are read, than the file can hold, or than
/// there is memory for.
fn check_size(bytes: &[u8], format: ImageFormat, becomes: BitmapUse) -> Result<(), String> {
    let decoder = ImageReader::with_format(Cursor::new(bytes), format).into_decoder();
    let decoder = decoder.map_err(|error| error.to_string())?;
    let (width, height) = decoder.dimensions();
    let (pixels, length) = (u64::from(width) * u64::from(height), bytes.len() as u64);
    if pixels > MOST_PIXELS {
        return Err(format!(
            "it has {width} x {height} pixels; expected at most {MOST_PIXELS} in all"
        ));
    }
    if pixels / MOST_COMPRESSION > length {
        return Err(format!(
            "its header announces {width} x {height} pixels, which its {length} bytes cannot hold"
        ));
    }
    let channels = if decoder.color_type().has_color() {
        3
    } else {
        1
    };
    let needed = decoder.total_bytes() + pixels * becomes.bytes(channels);
    check_memory([width as usize, height as usize], needed, available())
}

/// An error if pixels need more memory than is free.
fn check_memory(size: [usize; 2], needed: u64, free: Option<u64>) -> Result<(), String> {
    let [width, height] = size;
    match free.filter(|&free| needed > free) {
        None => Ok(()),
        Some(free) => Err(format!(
            "its {width} x {height} pixels need {} MiB of memory, and {} MiB are free; make it \
             smaller",
            mib(needed),
            mib(free)
        )),
    }
}

/// Numbers in double precision, or an error if there is no memory for them.
fn doubles<T: Copy>(numbers: &[T], convert: impl Fn(T) -> f64) -> Result<Vec<f64>, String> {
    let mut doubles = Vec::new();
    let count = numbers.len();
    let reserved = doubles.try_reserve_exact(count);
    reserved.map_err(|_| format!("there is no memory for its {count} numbers"))?;
    doubles.extend(numbers.iter().map(|&x| convert(x)));
    Ok(doubles)
}

fn read_exr(bytes: &[u8], becomes: BitmapUse) -> Result<BitmapFile, String> {
    let image = decode_exr_value(bytes, MOST_PIXELS, |size| {
        let pixels = size[0] as u64 * size[1] as u64;
        // Once as they are read, and once as texels.
        check_memory(size, pixels * (24 + becomes.bytes(3)), available())
    })?;
    let mut data = Vec::new();
    let reserved = data.try_reserve_exact(3 * image.pixels.len());
    reserved.map_err(|_| "there is no memory for its pixels")?;
    data.extend(image.pixels.iter().flat_map(|pixel| pixel.to_array()));
    finish(image.width as u32, image.height as u32, 3, data)
}

fn finish(width: u32, height: u32, channels: usize, data: Vec<f64>) -> Result<BitmapFile, String> {
    if width == 0 || height == 0 {
        return Err("it has no pixels".into());
    }
    match data.iter().position(|x| !x.is_finite()) {
        None => Ok(BitmapFile {
            width,
            height,
            channels,
            data,
        }),
        Some(i) => {
            let (pixel, number) = (i / channels, data[i]);
            let (x, y) = (pixel % width as usize, pixel / width as usize);
            Err(format!("its pixel ({x}, {y}) has the value {number}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{GrayImage, ImageBuffer, Luma, Rgb, RgbImage, RgbaImage};
    use std::io::Cursor;

    fn bytes(image: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        let image: DynamicImage = image.into();
        image.write_to(&mut bytes, format).expect("can be written");
        bytes.into_inner()
    }

    /// 0x80 is 0.2158605 in linear light, 0x0a is on the straight part.
    #[test]
    fn eight_bits_are_decoded_from_srgb_unless_raw() {
        let image = RgbImage::from_raw(2, 1, vec![255, 128, 10, 0, 1, 2]).expect("six bytes");
        for (format, ending) in [
            (ImageFormat::Png, "png"),
            (ImageFormat::Bmp, "bmp"),
            (ImageFormat::Tga, "tga"),
        ] {
            let file = bytes(image.clone(), format);
            let read_as =
                |raw| read(&file, ending, raw, Channels::Colour, BitmapUse::Texture).expect(ending);
            let raw = read_as(true);
            assert_eq!((raw.width, raw.height, raw.channels), (2, 1, 3));
            let expected = [255, 128, 10, 0, 1, 2].map(|x| f64::from(x) / 255.0);
            assert_eq!(raw.data, expected, "{ending}");
            let linear = read_as(false).data;
            assert_eq!(linear[0], 1.0);
            assert!((linear[1] - 0.215860500).abs() < 1e-9, "{ending}");
            assert!((linear[2] - 0.003035270).abs() < 1e-9, "{ending}");
        }
    }

    #[test]
    fn greys_sixteen_bits_and_alpha() {
        let grey = GrayImage::from_raw(1, 2, vec![255, 51]).expect("two bytes");
        let grey = read(
            &bytes(grey, ImageFormat::Png),
            "png",
            true,
            Channels::Colour,
            BitmapUse::Texture,
        )
        .expect("grey");
        assert_eq!((grey.channels, grey.data), (1, vec![1.0, 0.2]));
        let deep = ImageBuffer::<Luma<u16>, _>::from_raw(1, 1, vec![13107]).expect("one word");
        let deep = read(
            &bytes(deep, ImageFormat::Png),
            "png",
            true,
            Channels::Colour,
            BitmapUse::Texture,
        )
        .expect("16 bits");
        assert_eq!((deep.channels, deep.data), (1, vec![0.2]));
        // Colours are not multiplied by alpha.
        let alpha = RgbaImage::from_raw(1, 1, vec![255, 51, 0, 51]).expect("one pixel");
        let alpha = read(
            &bytes(alpha, ImageFormat::Png),
            "png",
            true,
            Channels::Colour,
            BitmapUse::Texture,
        )
        .expect("alpha");
        assert_eq!((alpha.channels, alpha.data), (3, vec![1.0, 0.2, 0.0]));
    }

    /// A grey JPEG of one colour has it up to rounding.
    #[test]
    fn jpeg_and_hdr() {
        let flat = RgbImage::from_pixel(8, 8, Rgb([51, 102, 204]));
        let flat = read(
            &bytes(flat, ImageFormat::Jpeg),
            "jpg",
            true,
            Channels::Colour,
            BitmapUse::Texture,
        )
        .expect("jpeg");
        for (i, expected) in [0.2, 0.4, 0.8].into_iter().enumerate() {
            assert!(
                (flat.data[i] - expected).abs() < 0.015,
                "{:?}",
                &flat.data[..3]
            );
        }
        let bright = ImageBuffer::<Rgb<f32>, _>::from_raw(1, 1, vec![0.5, 8.0, 64.0]);
        let bright = bytes(bright.expect("one pixel"), ImageFormat::Hdr);
        let bright =
            read(&bright, "hdr", false, Channels::Colour, BitmapUse::Texture).expect("hdr");
        assert_eq!(bright.data, [0.5, 8.0, 64.0]);
    }

    /// What is made of the texels counts, too.
    #[test]
    fn images_that_do_not_fit_are_errors() {
        let bytes = |becomes: BitmapUse| 4096 * 4096 * becomes.bytes(3);
        let (texture, sky) = (bytes(BitmapUse::Texture), bytes(BitmapUse::Environment));
        let free = Some(400 << 20);
        assert_eq!(check_memory([4096, 4096], texture, free), Ok(()));
        let error = check_memory([4096, 4096], sky, free).expect_err("it needs more");
        let expected = "its 4096 x 4096 pixels need 640 MiB of memory, and 400 MiB are free";
        assert!(error.starts_with(expected), "{error}");
    }

    /// A file cut off anywhere is an error, never a panic or half an image.
    #[test]
    fn broken_files_are_errors() {
        let image = RgbImage::from_pixel(5, 4, Rgb([51, 102, 204]));
        let whole = bytes(image, ImageFormat::Png);
        for length in 0..whole.len() - 12 {
            assert!(
                read(
                    &whole[..length],
                    "png",
                    false,
                    Channels::Colour,
                    BitmapUse::Texture
                )
                .is_err(),
                "{length} bytes"
            );
        }
        assert!(read(&whole, "exr", false, Channels::Colour, BitmapUse::Texture).is_err());
        let error = read(&whole, "gif", false, Channels::Colour, BitmapUse::Texture)
            .expect_err("no such format");
        assert!(error.contains("png, jpg"), "{error}");
        assert!(
            finish(2, 1, 1, vec![0.0, f64::NAN])
                .expect_err("NaN")
                .contains("(1, 0)")
        );
    }
}
