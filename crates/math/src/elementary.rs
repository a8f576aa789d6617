//! Sine, cosine and angles without a branch: in a loop over several numbers, the compiler
//! computes as many at a time as registers hold. The bits are the same on every machine.
//!
//! Polynomials of Cephes (Moshier 1989), whose errors are below a unit in the last place.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI};

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

/// A polynomial from its factors, the highest power first.
#[inline(always)]
fn polynomial<const N: usize>(factors: &[f64; N], x: f64) -> f64 {
    let mut sum = factors[0];
    for factor in &factors[1..] {
        sum = sum * x + factor;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
