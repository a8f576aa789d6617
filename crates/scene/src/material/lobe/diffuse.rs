//! The ideally diffuse surface.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};

use super::event::Drawn;
use super::local;

/// Reflects the same radiance to all directions in front of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diffuse<R = f64> {
    /// Fraction of light reflected, per channel.
    pub reflectance: Rgb<R>,
}

impl<R: Real> Diffuse<R> {
    /// `reflectance / π · cos⁺`.
    #[inline]
    pub(super) fn eval(&self, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        self.reflectance * (wo.z * R::constant(FRAC_1_PI))
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> Diffuse<S> {
        Diffuse {
            reflectance: self.reflectance.map(&mut *f),
        }
    }
}

impl Diffuse {
    #[inline]
    pub(super) fn sample(&self, _wi: Vec3, _choice: f64, u: [f64; 2]) -> Option<Drawn> {
        Some(Drawn::Smooth(local::sample_cosine(u)))
    }

    #[inline]
    pub(super) fn pdf(&self, wo: Vec3) -> f64 {
        local::cosine_pdf(wo)
    }
}
