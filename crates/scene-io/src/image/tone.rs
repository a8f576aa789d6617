//! From numbers to colours on a screen.

use capwalk_math::Rgb;
use capwalk_scene::Image;

/// The colour of a pixel that is infinite or NaN: nothing else is magenta.
pub(super) const NON_FINITE: [u8; 3] = [255, 0, 255];

/// A linear colour as sRGB (IEC 61966-2-1), times `scale` and clamped to
/// `[0, 1]` before; magenta if it is infinite or NaN.
pub fn photographic(colour: Rgb, scale: f64) -> [u8; 3] {
    if !colour.is_finite() {
        return NON_FINITE;
    }
    colour.to_array().map(|linear| {
        let x = (linear * scale).clamp(0.0, 1.0);
        let encoded = match x <= 0.003_130_8 {
            true => 12.92 * x,
            false => 1.055 * x.powf(1.0 / 2.4) - 0.055,
        };
        (255.0 * encoded).round() as u8
    })
}

/// ColorBrewer's `RdBu` with 11 classes (Harrower and Brewer 2003), from blue
/// to red: perceptually even, readable with colour blindness.
const DIVERGING: [[u8; 3]; 11] = [
    [5, 48, 97],
    [33, 102, 172],
    [67, 147, 195],
    [146, 197, 222],
    [209, 229, 240],
    [247, 247, 247],
    [253, 219, 199],
    [244, 165, 130],
    [214, 96, 77],
    [178, 24, 43],
    [103, 0, 31],
];

/// A number between `-limit` (blue), 0 (white) and `limit` (red); beyond, the
/// colour of the limit.
pub(super) fn diverging(value: f64, limit: f64) -> [u8; 3] {
    if !value.is_finite() {
        return NON_FINITE;
    }
    let last = DIVERGING.len() - 1;
    let x = (0.5 + 0.5 * value / limit).clamp(0.0, 1.0) * last as f64;
    let i = (x as usize).min(last - 1);
    let t = x - i as f64;
    std::array::from_fn(|c| {
        let [a, b] = [DIVERGING[i][c], DIVERGING[i + 1][c]].map(f64::from);
        (a + (b - a) * t).round() as u8
    })
}

/// The number that stands for a colour in false colours: its mean.
pub(super) fn mean(colour: Rgb) -> f64 {
    (colour.r + colour.g + colour.b) / 3.0
}

/// The fraction of coloured pixels that false colours show without clamping.
const COVERED: f64 = 0.99;

/// A limit for the false colours of some images: 99 % of their finite means
/// that are not zero lie within it. Rounded up to two digits; 1 if there are
/// none.
pub fn robust_limit<'a>(images: impl IntoIterator<Item = &'a Image>) -> f64 {
    let pixels = images.into_iter().flat_map(|image| &image.pixels);
    let sizes = pixels.map(|&pixel| mean(pixel).abs());
    let mut sizes: Vec<f64> = sizes.filter(|&m| m.is_finite() && m > 0.0).collect();
    if sizes.is_empty() {
        return 1.0;
    }
    let index = (COVERED * (sizes.len() - 1) as f64).ceil() as usize;
    let (_, &mut size, _) = sizes.select_nth_unstable_by(index, f64::total_cmp);
    // Through text, so that the limit is the very number that is printed.
    let step = 10_f64.powi(size.log10().floor() as i32 - 1);
    let limit = format!("{:.1e}", (size / step).ceil() * step).parse();
    limit.unwrap_or(size)
}

/// How many pixels are infinite or NaN in some channel.
pub(super) fn non_finite_pixels(image: &Image) -> usize {
    image.pixels.iter().filter(|p| !p.is_finite()).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn photographic_tones() {
        assert_eq!(photographic(Rgb::new(0.0, 0.5, 2.0), 1.0), [0, 188, 255]);
        assert_eq!(photographic(Rgb::splat(0.25), 2.0), [188; 3]);
        assert_eq!(photographic(Rgb::splat(-1.0), 1.0), [0; 3]);
        assert_eq!(photographic(Rgb::new(0.0, f64::NAN, 0.0), 1.0), NON_FINITE);
    }

    #[test]
    fn diverging_is_symmetric_and_ends_at_its_limits() {
        assert_eq!(diverging(0.0, 2.0), [247; 3]);
        assert_eq!(diverging(-2.0, 2.0), DIVERGING[0]);
        assert_eq!(diverging(2.0, 2.0), DIVERGING[10]);
        assert_eq!(diverging(7.0, 2.0), DIVERGING[10]);
        assert_eq!(diverging(f64::INFINITY, 2.0), NON_FINITE);
        // Positive is red, negative is blue.
        let (red, blue) = (diverging(1.0, 2.0), diverging(-1.0, 2.0));
        assert!(red[0] > red[2] && blue[2] > blue[0]);
    }

    #[test]
    fn limits_ignore_outliers_and_zeros() {
        let mut image = Image::new(100, 100);
        assert_eq!(robust_limit([&image]), 1.0);
        for (i, pixel) in image.pixels[..1000].iter_mut().enumerate() {
            *pixel = Rgb::splat(-0.001 * (i as f64 + 1.0));
        }
        image.pixels[0] = Rgb::splat(1e9);
        image.pixels[1] = Rgb::splat(f64::NAN);
        // 99 % of 0.003 to 1 and 1e9 lie below 0.993.
        assert_eq!(robust_limit([&image]), 1.0);
        image.pixels.truncate(400);
        assert_eq!(robust_limit([&image]), 0.4);
        let tiny = Image {
            width: 1,
            height: 1,
            pixels: vec![Rgb::splat(1.234e-7)],
        };
        assert_eq!(robust_limit([&tiny]), 1.3e-7);
    }
}
