//! Spectra to linear sRGB, as Mitsuba 3's `rgb` variants convert them when they load a
//! scene: by the colour matching functions, reflectances under daylight (D65).

use capwalk_math::Rgb;

use crate::cie::{VISIBLE, d65, observer};

/// Wavelengths at which a spectrum is evaluated, and by which sums are divided, as in
/// Mitsuba: evenly spaced, both ends included.
const STEPS: u32 = 1000;

/// Mitsuba's sum of the colour matching function y: a spectrum that is 1 has luminance 1.
const LUMINANCE_OF_ONE: f64 = 106.750_259_399_414_06;

/// What Mitsuba divides the table of D65 by: daylight has luminance 1.
const LUMINANCE_OF_D65: f64 = 98.997_417_518_762_55;

/// Linear sRGB of the tristimulus values X, Y and Z (ITU-R BT.709, with Mitsuba's digits).
const SRGB_OF_XYZ: [[f64; 3]; 3] = [
    [3.240479, -1.537150, -0.498535],
    [-0.969256, 1.875991, 0.041556],
    [0.055648, -0.204043, 1.057311],
];

/// Speed of light (m/s), Planck's (J s) and Boltzmann's (J/K) constants, as in Mitsuba.
const LIGHT: f64 = 2.997_924_58e8;
const PLANCK: f64 = 6.626_070_04e-34;
const BOLTZMANN: f64 = 1.380_648_52e-23;

/// Values at wavelengths, linear between them and zero beyond.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Samples {
    /// Nanometers, increasing; at least two.
    wavelengths: Vec<f64>,
    values: Vec<f64>,
}

impl Samples {
    /// Pairs of a wavelength and a value, or what is wrong with them.
    pub fn new(pairs: &[(f64, f64)]) -> Result<Self, String> {
        if pairs.len() < 2 {
            return Err(format!("the spectrum has {} wavelengths", pairs.len()));
        }
        if let Some(pair) = pairs.windows(2).find(|pair| pair[1].0 <= pair[0].0) {
            let ((before, _), (after, _)) = (pair[0], pair[1]);
            return Err(format!("the wavelength {after} stands behind {before}"));
        }
        let (wavelengths, values) = pairs.iter().copied().unzip();
        Ok(Self {
            wavelengths,
            values,
        })
    }

    /// The spectrum in a text with a wavelength and a value in each line; lines that begin
    /// with `#` are comments.
    pub fn parse_file(text: &str) -> Result<Self, String> {
        let mut pairs = Vec::new();
        for (i, line) in text.lines().enumerate() {
            if line.trim().is_empty() || line.starts_with('#') {
                continue;
            }
            let numbers: Vec<Option<f64>> = line.split_whitespace().map(finite).collect();
            let [Some(wavelength), Some(value)] = numbers[..] else {
                return Err(format!("line {} is \"{}\"", i + 1, line.trim()));
            };
            pairs.push((wavelength, value));
        }
        Self::new(&pairs)
    }

    fn at(&self, wavelength: f64) -> f64 {
        let (w, last) = (&self.wavelengths, self.wavelengths.len() - 1);
        if wavelength < w[0] || wavelength > w[last] {
            return 0.0;
        }
        let behind = w.partition_point(|&w| w <= wavelength).clamp(1, last);
        let (w0, w1) = (w[behind - 1], w[behind]);
        let fraction = (wavelength - w0) / (w1 - w0);
        (1.0 - fraction) * self.values[behind - 1] + fraction * self.values[behind]
    }

    /// Linear sRGB of light with this spectrum.
    pub fn colour_of_light(&self) -> Rgb {
        colour(|wavelength| self.at(wavelength))
    }

    /// Linear sRGB of a surface that reflects this part of daylight.
    pub fn colour_by_daylight(&self) -> Rgb {
        colour(|wavelength| self.at(wavelength) * d65(wavelength) / LUMINANCE_OF_D65)
    }
}

/// Linear sRGB of the light of a black body, from one wavelength (nm) to another: radiance
/// in W per m², sr and nm, at a temperature in kelvin (Planck's law).
pub(crate) fn black_body(temperature: f64, [first, last]: [f64; 2]) -> Rgb {
    colour(|wavelength| {
        if wavelength < first || wavelength > last {
            return 0.0;
        }
        let metres = wavelength * 1e-9;
        let exponent = PLANCK * LIGHT / (BOLTZMANN * metres * temperature);
        1e-9 * 2.0 * PLANCK * LIGHT * LIGHT / (metres.powi(5) * exponent.exp_m1())
    })
}

/// Linear sRGB of light that has the same power at all wavelengths, which is not white: the
/// white of sRGB is daylight.
pub(crate) fn equal_energy() -> Rgb {
    srgb_of_xyz([1.0; 3])
}

/// Linear sRGB of light with this power at each wavelength (nm).
fn colour(power: impl Fn(f64) -> f64) -> Rgb {
    let range = VISIBLE.end() - VISIBLE.start();
    let mut xyz = [0.0; 3];
    for i in 0..STEPS {
        let wavelength = VISIBLE.start() + f64::from(i) / f64::from(STEPS - 1) * range;
        let power = power(wavelength);
        for (total, response) in xyz.iter_mut().zip(observer(wavelength)) {
            *total += response * power;
        }
    }
    srgb_of_xyz(xyz.map(|total| total * range / (LUMINANCE_OF_ONE * f64::from(STEPS))))
}

fn srgb_of_xyz(xyz: [f64; 3]) -> Rgb {
    let [r, g, b] = SRGB_OF_XYZ.map(|row| row.iter().zip(xyz).map(|(m, x)| m * x).sum());
    Rgb::new(r, g, b)
}

/// The finite number that a word spells.
pub(crate) fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|x: &f64| x.is_finite())
}
