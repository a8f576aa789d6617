//! Reconstruction filters: what a pixel weighs the light around it with.

use capwalk_math::Real;
use serde::{Deserialize, Serialize};

use crate::scene_error::SceneError;

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
}

impl Filter {
    /// Half the width of the support, pixels.
    pub fn radius(&self) -> f64 {
        match *self {
            Self::Box => 0.5,
            Self::Tent { radius } => radius,
            Self::Gaussian { stddev } => 4.0 * stddev,
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
                (x * x * scale).exp() - R::constant((-8.0_f64).exp())
            }
        }
    }

    pub(crate) fn check(&self) -> Result<(), SceneError> {
        let (name, value) = match *self {
            Self::Box => return Ok(()),
            Self::Tent { radius } => ("rfilter.radius", radius),
            Self::Gaussian { stddev } => ("rfilter.stddev", stddev),
        };
        if value > 0.0 && value < 100.0 {
            return Ok(());
        }
        Err(SceneError::BadNumber {
            name: name.into(),
            value: value.to_string(),
            expected: "a number of pixels above 0 and below 100",
        })
    }
}
