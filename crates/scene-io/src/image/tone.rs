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

/// Which numbers the false colours stand for: `-limit` is blue, 0 white, and `limit` red; what is
/// beyond has the colour of the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The number at either end, above 0.
    pub limit: f64,
    /// Numbers up to about this size are spread evenly, larger ones by their logarithms; infinite if all
    /// are spread evenly.
    pub even: f64,
}

impl Scale {
    /// Colours that are spread evenly up to a limit.
    pub fn even(limit: f64) -> Self {
        Self {
            limit,
            even: f64::INFINITY,
        }
    }

    /// A scale for the false colours of some images: 99 % of their means that are not zero lie within its
    /// limit, which is rounded up to two digits (1 if there are none), and it is even up to the
    /// median of what is not zero where that is much less. Silhouettes are often a hundred times as strong
    /// as shadows, and both are to be seen.
    pub fn of<'a>(images: impl IntoIterator<Item = &'a Image>) -> Self {
        let mut sizes = sizes(images);
        let limit = limit_of(&mut sizes);
        let middle = sizes.len() / 2;
        if sizes.is_empty() {
            return Self::even(limit);
        }
        let (_, &mut median, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
        match limit > UNEVEN * median {
            true => Self {
                limit,
                even: median,
            },
            false => Self::even(limit),
        }
    }

    /// Where a number is on the colour bar: from -1 to 1, and beyond.
    pub(super) fn place(&self, value: f64) -> f64 {
        match self.even.is_finite() {
            true => (value / self.even).asinh() / (self.limit / self.even).asinh(),
            false => value / self.limit,
        }
    }

    /// The numbers that a colour bar is marked with, from large to small.
    pub(super) fn ticks(&self) -> Vec<f64> {
        let mut above = match self.even.is_finite() {
            true => {
                let decades = (0..).map(|i| self.limit * 0.1_f64.powi(i));
                decades.take_while(|&x| x > self.even).collect()
            }
            false => vec![self.limit, 0.5 * self.limit],
        };
        let below: Vec<f64> = above.iter().rev().map(|x| -x).collect();
        above.push(0.0);
        above.extend(below);
        above
    }
}

/// How many times the median the limit must be for a scale that is not even.
const UNEVEN: f64 = 10.0;

/// The colour at a place of the bar.
pub(super) fn diverging(place: f64) -> [u8; 3] {
    if !place.is_finite() {
        return NON_FINITE;
    }
    let last = DIVERGING.len() - 1;
    let x = (0.5 + 0.5 * place).clamp(0.0, 1.0) * last as f64;
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

/// The sizes of the finite means of pixels that are not zero.
fn sizes<'a>(images: impl IntoIterator<Item = &'a Image>) -> Vec<f64> {
    let pixels = images.into_iter().flat_map(|image| &image.pixels);
    let sizes = pixels.map(|&pixel| mean(pixel).abs());
    sizes.filter(|&m| m.is_finite() && m > 0.0).collect()
}

/// 99 % of these numbers lie within it, rounded up to two digits; 1 if there are none.
fn limit_of(sizes: &mut [f64]) -> f64 {
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
        for scale in [
            Scale::even(2.0),
            Scale {
                limit: 2.0,
                even: 0.1,
            },
        ] {
            let colour = |value| diverging(scale.place(value));
            assert_eq!(colour(0.0), [247; 3]);
            assert_eq!(colour(-2.0), DIVERGING[0]);
            assert_eq!(colour(2.0), DIVERGING[10]);
            assert_eq!(colour(7.0), DIVERGING[10]);
            assert_eq!(colour(f64::NAN), NON_FINITE);
            // Positive is red, negative is blue.
            let (red, blue) = (colour(1.0), colour(-1.0));
            assert!(red[0] > red[2] && blue[2] > blue[0]);
        }
    }

    #[test]
    fn scales_show_what_is_weak() {
        let image = |weak: f64| Image {
            width: 100,
            height: 1,
            pixels: (0..100)
                .map(|i| Rgb::splat(if i < 90 { weak } else { -7.0 }))
                .collect(),
        };
        assert_eq!(Scale::of([&image(0.0)]), Scale::even(7.0));
        assert_eq!(Scale::of([&image(1.0)]), Scale::even(7.0));
        let scale = Scale::of([&image(0.05)]);
        assert!(scale.limit == 7.0 && (scale.even - 0.05).abs() < 1e-12);
        assert!(scale.place(0.05) > 0.15 && scale.place(0.7) < 0.6);
        assert_eq!(scale.ticks().len(), 7);
        assert_eq!(Scale::even(4.0).ticks(), [4.0, 2.0, 0.0, -2.0, -4.0]);
    }

    #[test]
    fn limits_ignore_outliers_and_zeros() {
        let mut image = Image::new(100, 100);
        assert_eq!(Scale::of([&image]).limit, 1.0);
        for (i, pixel) in image.pixels[..1000].iter_mut().enumerate() {
            *pixel = Rgb::splat(-0.001 * (i as f64 + 1.0));
        }
        image.pixels[0] = Rgb::splat(1e9);
        image.pixels[1] = Rgb::splat(f64::NAN);
        // 99 % of 0.003 to 1 and 1e9 lie below 0.993.
        assert_eq!(Scale::of([&image]).limit, 1.0);
        image.pixels.truncate(400);
        assert_eq!(Scale::of([&image]).limit, 0.4);
        let tiny = Image {
            width: 1,
            height: 1,
            pixels: vec![Rgb::splat(1.234e-7)],
        };
        assert_eq!(Scale::of([&tiny]).limit, 1.3e-7);
    }
}
