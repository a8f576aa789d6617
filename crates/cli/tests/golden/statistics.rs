//! Whether two noisy images are estimates of the same one.
//!
//! Differences are looked at pixel by pixel, which shows an edge in the wrong
//! place, and in sums over blocks of pixels, which show a brightness that is off
//! by less than the noise of a pixel. Every sum weighs a difference by the noise
//! that the reference has around that pixel, so no weight depends on the noise
//! that it weighs.

use std::fmt;

use capwalk_math::stats::{chi_squared_upper_tail, normal_upper_tail};

/// Share of the pixels that must pass, as in Mitsuba's own `test_renders.py`: a
/// pixel is not quite normally distributed.
const PASSING_PIXELS: f64 = 0.9975;
/// Probability that a pixel of equal images fails, after Šidák's correction for
/// the number of pixels.
const PIXELS_LEVEL: f64 = 0.01;
/// Sides of the blocks, pixels. The last contains a whole image.
const BLOCKS: [usize; 4] = [6, 12, 24, usize::MAX];
/// Tests of sums per image: the largest and the squares, at each size of block.
pub const TESTS: usize = 2 * BLOCKS.len();
/// Share of a pixel's reference variance that comes from everywhere, so that no
/// weight is infinite.
const FROM_EVERYWHERE: f64 = 0.01;
/// How far around a pixel its noise is looked up, pixels.
const REACH: isize = 2;
/// Rounding of single precision in a long computation, relative: noise that no
/// spread shows.
const SINGLE_PRECISION: f64 = 1e-4;

/// One number per pixel, row by row.
pub struct Grid {
    pub width: usize,
    pub height: usize,
    pub numbers: Vec<f64>,
}

/// An estimate by other means.
pub struct Reference {
    pub mean: Grid,
    /// Variance of that mean.
    pub variance: Grid,
    /// Samples per pixel that it took.
    pub spp: f64,
    /// Variance of a sum over a block in units of the sum of the variances.
    pub correlation: f64,
}

/// How an image and its reference differ.
pub struct Comparison {
    /// Differences in units of their standard deviation.
    pub z: Grid,
    /// Share of pixels that differ significantly.
    pub failing_pixels: f64,
    /// Relative difference of the mean brightness, either sign.
    pub brightness: f64,
    /// What equal images would not do; empty if they are equal.
    pub objections: Vec<String>,
}

/// Compares an image, its variance and its samples per pixel with a reference. Each
/// of the tests of sums fails with this probability if they are equal.
pub fn compare(
    mean: &Grid,
    variance: &Grid,
    spp: f64,
    reference: &Reference,
    level: f64,
) -> Comparison {
    let (width, height) = (mean.width, mean.height);
    let local = around(&reference.variance);
    let differences = mean.numbers.iter().zip(&reference.mean.numbers);
    let differences: Vec<f64> = differences.map(|(ours, theirs)| ours - theirs).collect();
    // An image in which a rare event was not met states too small a variance;
    // the reference knows better.
    let ours = |i: usize| {
        let rounding = SINGLE_PRECISION * reference.mean.numbers[i];
        let expected = local[i] * reference.spp / spp;
        variance.numbers[i].max(expected) + rounding * rounding
    };
    let theirs = |i: usize| reference.variance.numbers[i].max(local[i]);
    let in_deviations = |difference: f64, variance: f64| match difference {
        0.0 => 0.0,
        _ => difference / variance.sqrt(),
    };
    let z = |i: usize| in_deviations(differences[i], ours(i) + theirs(i));
    let z: Vec<f64> = (0..differences.len()).map(z).collect();

    let mut objections = Vec::new();
    let one_pixel = sidak(PIXELS_LEVEL, z.len());
    let failing = z.iter().filter(|&&z| two_sided(z) < one_pixel).count();
    let failing_pixels = failing as f64 / z.len() as f64;
    if failing_pixels > 1.0 - PASSING_PIXELS {
        let (share, most) = (100.0 * failing_pixels, 100.0 * (1.0 - PASSING_PIXELS));
        objections.push(format!(
            "{share:.2} % of the pixels differ significantly; at most {most:.2} % may"
        ));
    }

    for side in BLOCKS {
        let blocks = blocks(width, height, side);
        let sums = blocks.iter().map(|block| {
            let weight = |i: usize| local[i].max(f64::MIN_POSITIVE).sqrt().recip();
            let difference: f64 = block.pixels().map(|i| weight(i) * differences[i]).sum();
            let variances = block
                .pixels()
                .map(|i| weight(i).powi(2) * (ours(i) + reference.correlation * theirs(i)));
            in_deviations(difference, variances.sum())
        });
        let sums: Vec<f64> = sums.collect();
        let largest = (0..sums.len()).max_by(|&i, &j| sums[i].abs().total_cmp(&sums[j].abs()));
        let largest = largest.expect("an image has pixels");
        if two_sided(sums[largest]) < sidak(level, sums.len()) {
            let (block, z) = (&blocks[largest], sums[largest]);
            objections.push(format!("{block} differs by {z:+.1} standard deviations"));
        }
        let squares: f64 = sums.iter().map(|z| z * z).sum();
        if sums.len() > 1 && chi_squared_upper_tail(squares, sums.len() as f64) < level {
            let (mean, count) = (squares / sums.len() as f64, sums.len());
            objections.push(format!(
                "{count} blocks of {side} x {side} pixels differ by {mean:.2} variances each"
            ));
        }
    }
    let brightness: f64 = reference.mean.numbers.iter().sum();
    Comparison {
        z: Grid {
            width,
            height,
            numbers: z,
        },
        failing_pixels,
        brightness: differences.iter().sum::<f64>() / brightness,
        objections,
    }
}

/// Probability that a standard normal variable lies further from zero.
fn two_sided(z: f64) -> f64 {
    2.0 * normal_upper_tail(z.abs())
}

/// The level of each of so many tests, one of which fails with this probability.
fn sidak(level: f64, tests: usize) -> f64 {
    1.0 - (1.0 - level).powf(1.0 / tests as f64)
}

/// The mean around each pixel, its own number left out, and a little of all.
fn around(grid: &Grid) -> Vec<f64> {
    let all = grid.numbers.iter().sum::<f64>() / grid.numbers.len() as f64;
    let local = |x: usize, y: usize| {
        let (mut sum, mut count) = (0.0, 0.0);
        for (dx, dy) in (-REACH..=REACH).flat_map(|dx| (-REACH..=REACH).map(move |dy| (dx, dy))) {
            let at = [x.checked_add_signed(dx), y.checked_add_signed(dy)];
            if let [Some(x), Some(y)] = at
                && (dx, dy) != (0, 0)
                && x < grid.width
                && y < grid.height
            {
                sum += grid.numbers[y * grid.width + x];
                count += 1.0;
            }
        }
        (1.0 - FROM_EVERYWHERE) * sum / count + FROM_EVERYWHERE * all
    };
    let rows = 0..grid.height;
    rows.flat_map(|y| (0..grid.width).map(move |x| (x, y)))
        .map(|(x, y)| local(x, y))
        .collect()
}

/// A rectangle of pixels in an image.
struct Block {
    /// First and last but one column, and the same of rows.
    x: [usize; 2],
    y: [usize; 2],
    /// Pixels in a row of the image.
    width: usize,
}

impl Block {
    fn pixels(&self) -> impl Iterator<Item = usize> {
        let (columns, width) = (self.x, self.width);
        (self.y[0]..self.y[1])
            .flat_map(move |y| (columns[0]..columns[1]).map(move |x| y * width + x))
    }
}

impl fmt::Display for Block {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [[x0, x1], [y0, y1]] = [self.x, self.y];
        let (width, height) = (x1 - x0, y1 - y0);
        write!(f, "the block of {width} x {height} pixels at ({x0}, {y0})")
    }
}

/// Blocks with these sides that cover an image; those at its right and lower
/// borders may be smaller.
fn blocks(width: usize, height: usize, side: usize) -> Vec<Block> {
    let cuts = |length: usize| {
        let starts = (0..length).step_by(side);
        starts.map(move |start| [start, start.saturating_add(side).min(length)])
    };
    cuts(height)
        .flat_map(|y| cuts(width).map(move |x| Block { x, y, width }))
        .collect()
}

/// Normally distributed numbers and a reference of the same mean, sixteen times as
/// exact, pass; a brightness off by three tenths of a pixel's noise does not, nor does
/// one row of pixels off by six times that noise.
#[test]
fn a_small_shift_of_a_quarter_of_an_image_is_found() {
    let mut state = 1_u64;
    let mut normal = || {
        let mut uniform = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| uniform()).sum::<f64>() - 6.0
    };
    let mut grid = |mean: f64, deviation: f64| {
        let numbers = (0..48 * 40).map(|_| mean + deviation * normal());
        Grid {
            width: 48,
            height: 40,
            numbers: numbers.collect(),
        }
    };
    let reference = Reference {
        mean: grid(1.0, 0.01),
        variance: grid(1e-4, 0.0),
        spp: 4096.0,
        correlation: 1.0,
    };
    let (mean, variance) = (grid(1.0, 0.04), grid(16e-4, 0.0));
    let objections = |change: &dyn Fn(usize, usize) -> f64| {
        let numbers = mean.numbers.iter().enumerate();
        let changed = Grid {
            numbers: numbers.map(|(i, m)| m + change(i % 48, i / 48)).collect(),
            ..mean
        };
        let level = 0.01 / TESTS as f64;
        compare(&changed, &variance, 256.0, &reference, level).objections
    };
    assert_eq!(objections(&|_, _| 0.0), [""; 0]);
    let quarter = objections(&|x, y| if x < 24 && y < 20 { 0.012 } else { 0.0 });
    assert!(!quarter.is_empty());
    let row = objections(&|_, y| if y == 7 { 0.24 } else { 0.0 });
    assert!(
        row.iter().any(|text| text.contains("% of the pixels")),
        "{row:?}"
    );
}
