//! Sine, cosine, angles and exponentials without a branch: in a loop over several numbers, the
//! compiler computes as many at a time as registers hold. The bits are the same on every machine.
//!
//! For angles, polynomials of Cephes (Moshier 1989), whose errors are below a unit in the last place.

use std::f64::consts::{FRAC_2_PI, FRAC_2_SQRT_PI, FRAC_PI_2, FRAC_PI_4, LOG2_E, PI};

/// Added to a number and taken away again, it leaves the nearest integer, whose last bits are those
/// of the sum.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// What π/2 is in three parts, of which the first two have so few digits that small multiples are
/// exact.
const QUARTER_TURN: [f64; 3] = [
    1.570_796_251_296_997,
    7.549_789_415_861_596e-8,
    5.390_302_858_158_119e-15,
];

/// Sine and cosine of an angle of at most some thousand turns, radians.
#[inline(always)]
pub fn sin_cos(angle: f64) -> (f64, f64) {
    let sum = angle * FRAC_2_PI + TO_INTEGER;
    let (quarters, last_bits) = (sum - TO_INTEGER, sum.to_bits());
    let [a, b, c] = QUARTER_TURN.map(|part| quarters * part);
    let x = angle - a - b - c;
    let z = x * x;
    const SIN: [f64; 6] = [
        1.589_623_015_765_465_7e-10,
        -2.505_074_776_285_780_7e-8,
        2.755_731_362_138_572_5e-6,
        -1.984_126_982_958_954e-4,
        8.333_333_333_322_118e-3,
        -1.666_666_666_666_663e-1,
    ];
    const COS: [f64; 6] = [
        -1.135_853_652_138_768_2e-11,
        2.087_570_084_197_473e-9,
        -2.755_731_417_929_674e-7,
        2.480_158_728_885_170_5e-5,
        -1.388_888_888_887_305_6e-3,
        4.166_666_666_666_66e-2,
    ];
    let sin = x + x * z * polynomial(&SIN, z);
    let cos = 1.0 - 0.5 * z + z * z * polynomial(&COS, z);
    let is_odd = last_bits & 1 == 1;
    let (first, second) = if is_odd { (cos, sin) } else { (sin, cos) };
    // The sine is negative in the second half of a turn, the cosine in the second and third quarter.
    let half = (last_bits >> 1 & 1) << 63;
    let middle = ((last_bits >> 1 ^ last_bits) & 1) << 63;
    let flipped = |x: f64, sign: u64| f64::from_bits(x.to_bits() ^ sign);
    (flipped(first, half), flipped(second, middle))
}

/// Tangent of the angle above which those to the diagonal are computed.
const STEEP: f64 = 0.66;

/// The angle of a direction in the plane, from -π to π radians: `y.atan2(x)`, but for the signs of
/// zeros.
#[inline(always)]
pub fn angle_of([x, y]: [f64; 2]) -> f64 {
    let (ax, ay) = (x.abs(), y.abs());
    let (less, more) = if ay < ax { (ay, ax) } else { (ax, ay) };
    let is_steep = less > STEEP * more;
    let (above, below) = match is_steep {
        true => (less - more, less + more),
        false => (less, more),
    };
    // A direction without length has the angle zero.
    let t = above / if below > 0.0 { below } else { 1.0 };
    let z = t * t;
    const ABOVE: [f64; 5] = [
        -8.750_608_600_031_904e-1,
        -1.615_753_718_733_365e1,
        -7.500_855_792_314_705e1,
        -1.228_866_684_490_136_2e2,
        -6.485_021_904_942_025e1,
    ];
    const BELOW: [f64; 6] = [
        1.0,
        2.485_846_490_142_306_3e1,
        1.650_270_098_316_988_5e2,
        4.328_810_604_912_903e2,
        4.853_903_996_359_137e2,
        1.945_506_571_482_614e2,
    ];
    let to_axis = t + t * z * (polynomial(&ABOVE, z) / polynomial(&BELOW, z));
    let to_axis = to_axis + if is_steep { FRAC_PI_4 } else { 0.0 };
    let from_x = if ay < ax {
        to_axis
    } else {
        FRAC_PI_2 - to_axis
    };
    // Zero without a direction, and NaN for NaN.
    let from_x = if less + more > 0.0 {
        from_x
    } else {
        less + more
    };
    let from_x = if x < 0.0 { PI - from_x } else { from_x };
    if y < 0.0 { -from_x } else { from_x }
}

/// Numbers that are not below this are integers. Added to a smaller one and taken away again, it
/// leaves the nearest integer.
const INTEGERS: f64 = 4_503_599_627_370_496.0;

/// The largest integer that is not above `x`, without a call of the library where CPUs are
/// not known to have an instruction for it.
#[inline]
pub fn floor(x: f64) -> f64 {
    let nearest = ((x.abs() + INTEGERS) - INTEGERS).copysign(x);
    let below = if nearest > x { nearest - 1.0 } else { nearest };
    // False for NaN.
    if x.abs() < INTEGERS { below } else { x }
}

/// What ln 2 is in two parts, of which multiples of the first are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// Below, the exponential function counts as zero, and above as infinite: there its exponent is
/// not one of a normal number.
const LEAST_EXPONENT: f64 = -708.0;
const MOST_EXPONENT: f64 = 709.0;

/// The exponential function, up to units in the last place; zero where it is below 1e-307.
#[inline(always)]
pub fn exp(x: f64) -> f64 {
    // Half an octave around a power of two.
    let sum = x * LOG2_E + TO_INTEGER;
    let octaves = sum - TO_INTEGER;
    let [a, b] = LN_2.map(|part| octaves * part);
    let rest = x - a - b;
    let power = f64::from_bits((sum.to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
    // Taylor's series.
    const SERIES: [f64; 13] = [
        1.0 / 479_001_600.0,
        1.0 / 39_916_800.0,
        1.0 / 3_628_800.0,
        1.0 / 362_880.0,
        1.0 / 40_320.0,
        1.0 / 5_040.0,
        1.0 / 720.0,
        1.0 / 120.0,
        1.0 / 24.0,
        1.0 / 6.0,
        1.0 / 2.0,
        1.0,
        1.0,
    ];
    let value = power * long_polynomial(&SERIES, rest);
    let value = if x < LEAST_EXPONENT { 0.0 } else { value };
    if x > MOST_EXPONENT {
        f64::INFINITY
    } else {
        value
    }
}

/// `(1 + 2 x) exp(x²) erfc(x)` in powers of `(x - CENTRE) / (x + CENTRE)`, the highest first: the
/// form of Shepherd and Laframboise, "Chebyshev Approximation of (1 + 2x) exp(x²) erfc x in
/// 0 ≤ x < ∞" (1981).
const CENTRE: f64 = 3.75;
const COMPLEMENT: [f64; 23] = [
    -2.623_107_347_133_476e-9,
    -1.955_135_886_898_561_6e-9,
    3.197_926_671_666_804e-8,
    1.879_082_322_370_048e-8,
    -2.485_712_624_801_674_5e-7,
    -5.084_465_378_687_302e-8,
    1.741_982_158_622_481_6e-6,
    -9.792_625_707_303_523e-7,
    -1.143_804_803_334_689_4e-5,
    2.238_756_571_491_181_6e-5,
    5.164_652_974_177_416e-5,
    -2.901_553_524_607_765_5e-4,
    2.937_143_780_449_58e-4,
    1.755_626_165_197_065_2e-3,
    -9.746_579_683_265_262e-3,
    2.836_227_737_211_114e-2,
    -5.869_339_857_664_934e-2,
    9.230_432_116_428_125e-2,
    -1.088_039_301_424_446_2e-1,
    8.227_673_848_999_506e-2,
    3.585_415_485_479_025_7e-3,
    -1.402_405_985_855_452_5e-1,
    1.237_512_630_837_827_5,
];

/// Behind this number, the Gaussian of the error function is zero.
const FARTHEST: f64 = 27.0;

/// The error function and its derivative, as [`special::erf_and_derivative`] has them to 1e-15,
/// which is faster for one number alone.
///
/// [`special::erf_and_derivative`]: crate::special::erf_and_derivative
#[inline(always)]
pub fn erf_and_gaussian(x: f64) -> [f64; 2] {
    let y = x.abs();
    let gaussian = exp(-y * y);
    let y = if y > FARTHEST { FARTHEST } else { y };
    // Both quotients from one division.
    let (sum, growth) = (y + CENTRE, 1.0 + 2.0 * y);
    let inverse = 1.0 / (sum * growth);
    let place = (y - CENTRE) * growth * inverse;
    let complement = gaussian * long_polynomial(&COMPLEMENT, place) * (sum * inverse);
    [(1.0 - complement).copysign(x), FRAC_2_SQRT_PI * gaussian]
}

/// A polynomial from its factors, the highest power first.
#[inline(always)]
fn polynomial<const N: usize>(factors: &[f64; N], x: f64) -> f64 {
    let mut sum = factors[0];
    for factor in &factors[1..] {
        sum = sum * x + factor;
    }
    sum
}

/// The polynomial in four sums that do not wait for each other, each product fused with its sum. That is one
/// instruction where code is compiled for AVX2 or for AArch64, and elsewhere a call: only lanes use it.
#[inline(always)]
fn long_polynomial<const N: usize>(factors: &[f64; N], x: f64) -> f64 {
    let squared = x * x;
    let fourth = squared * squared;
    let mut sums = [0.0_f64; 4];
    for (place, factor) in factors.iter().enumerate() {
        let sum = &mut sums[(N - 1 - place) % 4];
        *sum = sum.mul_add(fourth, *factor);
    }
    let (high, low) = (sums[3].mul_add(x, sums[2]), sums[1].mul_add(x, sums[0]));
    high.mul_add(squared, low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special;

    /// Those of the standard library, to a few units in the last place, around the circle and
    /// beside all places where a branch would be.
    #[test]
    fn they_are_those_of_the_library() {
        let steps = (-4000..=4000).map(|i| f64::from(i) * 2e-3);
        let quarters =
            (-8..=8).flat_map(|i| [-1e-9, 0.0, 1e-9].map(|d| f64::from(i) * FRAC_PI_4 + d));
        for angle in steps.chain(quarters) {
            let (sin, cos) = sin_cos(angle);
            let expected = angle.sin_cos();
            let error = (sin - expected.0).abs().max((cos - expected.1).abs());
            assert!(error < 4e-16, "{angle}: {error:e}");
            // Also relative to what is nearly zero.
            for (found, expected) in [(sin, expected.0), (cos, expected.1)] {
                let error = (found - expected).abs();
                assert!(
                    error <= 1e-14 * expected.abs(),
                    "{angle}: {found:e} {expected:e}"
                );
            }
            for length in [1e-9, 1.0, 3e7] {
                let found = angle_of([cos * length, sin * length]);
                let expected = (sin * length).atan2(cos * length);
                let error = (found - expected).abs();
                assert!(
                    error < 1e-15 || (2.0 * PI - error).abs() < 1e-15,
                    "{angle}: {error:e}"
                );
            }
        }
        for [x, y] in [
            [0.0, 0.0],
            [1.0, 0.0],
            [0.0, 1.0],
            [-1.0, 0.0],
            [0.0, -2.0],
            [1.0, 1.0],
        ] {
            assert_eq!(angle_of([x, y]), y.atan2(x));
        }
        assert!(angle_of([f64::NAN, 1.0]).is_nan() && angle_of([1.0, f64::NAN]).is_nan());
        // Small angles keep their digits.
        let small = angle_of([1.0, 1e-200]);
        assert!((small / 1e-200 - 1.0).abs() < 1e-15);
    }

    /// To a few units in the last place, and at the ends of the range.
    #[test]
    fn exponentials_are_those_of_the_library() {
        for i in -70_000..=70_000 {
            let x = f64::from(i) * 1.01e-2;
            let (found, expected) = (exp(x), x.exp());
            assert!((found / expected - 1.0).abs() < 1e-15, "{x}: {found:e}");
        }
        assert_eq!(exp(0.0), 1.0);
        assert_eq!([-709.0, -1e300, f64::NEG_INFINITY].map(exp), [0.0; 3]);
        assert_eq!([710.0, f64::INFINITY].map(exp), [f64::INFINITY; 2]);
        assert!(exp(f64::NAN).is_nan());
    }

    #[test]
    fn integers_below_are_those_of_the_library() {
        let around = |x: f64| [x.next_down(), x, x.next_up(), x + 0.5];
        let small = (-2000..2000).map(|i| f64::from(i) * 0.25);
        let large = [1e15, 2.3e15, 4.4e15, INTEGERS, 1e16, 1e300].map(|x: f64| [x, -x]);
        for x in small.chain(large.into_iter().flatten()).flat_map(around) {
            assert_eq!(floor(x), x.floor(), "{x:e}");
        }
        assert!(floor(f64::NAN).is_nan());
    }

    /// Those for one number, on both sides of all its branches.
    #[test]
    fn error_functions_are_the_same() {
        for i in -30_000..=30_000 {
            let x = f64::from(i) * 1.0e-3;
            let (found, expected) = (erf_and_gaussian(x), special::erf_and_derivative(x));
            for (a, b) in found.into_iter().zip(expected) {
                assert!((a - b).abs() < 1e-15, "{x}: {a:e} {b:e}");
            }
        }
        let far = [f64::NEG_INFINITY, -1e9, 1e9, f64::INFINITY];
        assert_eq!(far.map(|x| erf_and_gaussian(x)[0]), [-1.0, -1.0, 1.0, 1.0]);
        assert!(erf_and_gaussian(f64::NAN)[0].is_nan());
    }
}
