//! Reconstruction filters: what a pixel weighs the light around it with.

use capwalk_math::{Real, elementary};
use serde::{Deserialize, Serialize};

use crate::scene_error::SceneError;
use capwalk_geometry::shown;

/// A separable filter, in pixels around the pixel's centre.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Filter {
    /// One within the pixel, zero outside. Discontinuous at its border.
    Box,
    /// `1 - |x| / radius`.
    Tent {
        /// Where it reaches zero, pixels.
        radius: f64,
    },
    /// `exp(-x² / 2σ²)`, lowered to reach zero at `4σ`.
    Gaussian {
        /// Standard deviation σ, pixels.
        stddev: f64,
    },
    /// Cubic pieces on `[0, 1]` and `[1, 2]`, negative in the second (Mitchell and
    /// Netravali 1988); `B = 0`, `C = 1/2` is [`Filter::CATMULL_ROM`].
    Mitchell {
        /// Their `B`.
        b: f64,
        /// Their `C`.
        c: f64,
    },
    /// `sinc(x) sinc(x / lobes)`, with as many lobes on each side.
    Lanczos {
        /// Where it ends, pixels.
        lobes: u32,
    },
}

/// The exponent of a Gaussian filter where it ends, at `4σ`.
const LEAST_GAUSSIAN: f64 = -8.0;

impl Filter {
    /// Catmull and Rom's cubic spline.
    pub const CATMULL_ROM: Self = Self::Mitchell { b: 0.0, c: 0.5 };

    /// Half the width of the support, pixels.
    pub fn radius(&self) -> f64 {
        match *self {
            Self::Box => 0.5,
            Self::Tent { radius } => radius,
            Self::Gaussian { stddev } => 4.0 * stddev,
            Self::Mitchell { .. } => 2.0,
            Self::Lanczos { lobes } => f64::from(lobes),
        }
    }

    /// True if it is negative somewhere.
    pub fn changes_sign(&self) -> bool {
        match self {
            Self::Box | Self::Tent { .. } | Self::Gaussian { .. } => false,
            Self::Mitchell { .. } | Self::Lanczos { .. } => true,
        }
    }

    /// The weight at a distance `x` from the centre along one axis, not
    /// normalised; zero outside the support.
    #[inline]
    pub fn eval<R: Real>(&self, x: R) -> R {
        let zero = R::constant(0.0);
        if x.value().abs() > self.radius() {
            return zero;
        }
        match *self {
            Self::Box => R::constant(1.0),
            Self::Tent { radius } => {
                let distance = if x.value() < 0.0 { -x } else { x };
                R::constant(1.0) - distance * R::constant(1.0 / radius)
            }
            Self::Gaussian { stddev } => {
                let scale = R::constant(-0.5 / (stddev * stddev));
                (x * x * scale).exp() - R::constant(LEAST_GAUSSIAN.exp())
            }
            Self::Mitchell { b, c } => {
                let x = if x.value() < 0.0 { -x } else { x };
                // Coefficients of 1, x, x² and x³.
                let six = match x.value() < 1.0 {
                    true => [
                        6.0 - 2.0 * b,
                        0.0,
                        -18.0 + 12.0 * b + 6.0 * c,
                        12.0 - 9.0 * b - 6.0 * c,
                    ],
                    false => [
                        8.0 * b + 24.0 * c,
                        -12.0 * b - 48.0 * c,
                        6.0 * b + 30.0 * c,
                        -b - 6.0 * c,
                    ],
                };
                let [k0, k1, k2, k3] = six.map(|k| R::constant(k / 6.0));
                ((k3 * x + k2) * x + k1) * x + k0
            }
            Self::Lanczos { lobes } => {
                let stretched = x * R::constant(f64::from(lobes).recip());
                sinc(x) * sinc(stretched)
            }
        }
    }

    /// [`Self::eval`] of each number, to units in the last place, within the support; in loops without a
    /// branch, of which the compiler makes vectors, for the filters that are used most.
    #[inline(always)]
    pub fn eval_each(&self, numbers: &mut [f64]) {
        match *self {
            Self::Gaussian { stddev } => {
                let (scale, least) = (-0.5 / (stddev * stddev), LEAST_GAUSSIAN.exp());
                for x in numbers {
                    *x = elementary::exp(*x * *x * scale) - least;
                }
            }
            Self::Tent { radius } => {
                let scale = 1.0 / radius;
                for x in numbers {
                    *x = 1.0 - x.abs() * scale;
                }
            }
            _ => {
                for x in numbers {
                    *x = self.eval(*x);
                }
            }
        }
    }

    pub(crate) fn check(&self) -> Result<(), SceneError> {
        let (name, value) = match *self {
            Self::Box => return Ok(()),
            Self::Tent { radius } => ("rfilter.radius", radius),
            Self::Gaussian { stddev } => ("rfilter.stddev", stddev),
            Self::Lanczos { lobes } => ("rfilter.lobes", f64::from(lobes)),
            Self::Mitchell { b, c } => {
                let outside = [("rfilter.B", b), ("rfilter.C", c)]
                    .into_iter()
                    .find(|(_, value)| !(0.0..=1.0).contains(value));
                return match outside {
                    None => Ok(()),
                    Some((name, value)) => Err(SceneError::BadNumber {
                        name: name.into(),
                        value: shown(value),
                        expected: "a number from 0 to 1",
                    }),
                };
            }
        };
        if value > 0.0 && value < 100.0 {
            return Ok(());
        }
        Err(SceneError::BadNumber {
            name: name.into(),
            value: shown(value),
            expected: "a number of pixels above 0 and below 100",
        })
    }
}

/// `sin(πx) / πx`.
fn sinc<R: Real>(x: R) -> R {
    /// Below this its square is 1 to all digits, and the quotient 0/0 is near.
    const SMALL: f64 = 1e-4;
    let angle = x * R::constant(std::f64::consts::PI);
    match angle.value().abs() < SMALL {
        true => R::constant(1.0) - angle * angle * R::constant(1.0 / 6.0),
        false => angle.sin_cos().0 / angle,
    }
}

#[cfg(test)]
mod tests {
    use capwalk_math::Dual;

    use super::*;

    const FILTERS: [Filter; 5] = [
        Filter::Tent { radius: 1.3 },
        Filter::Gaussian { stddev: 0.5 },
        Filter::Mitchell {
            b: 1.0 / 3.0,
            c: 1.0 / 3.0,
        },
        Filter::CATMULL_ROM,
        Filter::Lanczos { lobes: 3 },
    ];

    /// Values of Mitsuba 3.9.1's plugins.
    #[test]
    fn filters_are_those_of_mitsuba() {
        let [_, _, mitchell, catmull_rom, lanczos] = FILTERS;
        for (filter, x, expected) in [
            (mitchell, 0.0, 8.0 / 9.0),
            (mitchell, 0.4, 0.643_556),
            (mitchell, -1.5, -0.034_722_2),
            (catmull_rom, 0.4, 0.696),
            (catmull_rom, 1.0, 0.0),
            (catmull_rom, 1.5, -0.0625),
            (lanczos, 0.0, 1.0),
            (lanczos, -0.4, 0.734_888),
            (lanczos, 1.5, -0.135_095),
        ] {
            let value: f64 = filter.eval(x);
            assert!(
                (value - expected).abs() < 2e-6,
                "{filter:?} at {x}: {value}"
            );
        }
    }

    /// Continuous, zero at the end and outside, with the derivatives of differences.
    #[test]
    fn filters_are_continuous_and_differentiate() {
        for filter in FILTERS {
            let radius = filter.radius();
            assert!(filter.eval(radius).abs() < 1e-12 && filter.eval(1.001 * radius) == 0.0);
            for i in -40..40 {
                let x = (f64::from(i) + 0.37) / 40.0 * radius;
                let h = 1e-6;
                let difference = (filter.eval(x + h) - filter.eval(x - h)) / (2.0 * h);
                let moving: Dual<1> = filter.eval(Dual::variable(x, 0));
                assert!(
                    (moving.tangent[0] - difference).abs() < 1e-7,
                    "{filter:?} at {x}"
                );
            }
        }
    }
}
