//! The smooth metal.

use capwalk_math::{Real, Rgb, Vec3};

use super::event::{Drawn, Event};
use super::fresnel::fresnel_conductor;
use super::local;

/// A mirror that reflects as much as a metal does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor<R = f64> {
    /// Real part of the refractive index, per channel; 0 with `k` = 1 reflects all.
    pub eta: Rgb<R>,
    /// Imaginary part of the refractive index, per channel.
    pub k: Rgb<R>,
    /// Factor on what is reflected.
    pub specular_reflectance: Rgb<R>,
}

impl<R: Real> Conductor<R> {
    #[inline]
    pub(super) fn reflect(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let wi = local::raised(wi);
        let reflectance = fresnel_conductor(wi.z, self.eta, self.k);
        (
            local::reflected(wi),
            reflectance * self.specular_reflectance,
        )
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> Conductor<S> {
        Conductor {
            eta: self.eta.map(&mut *f),
            k: self.k.map(&mut *f),
            specular_reflectance: self.specular_reflectance.map(&mut *f),
        }
    }
}

impl Conductor {
    #[inline]
    pub(super) fn sample(&self, _wi: Vec3, _choice: f64, _u: [f64; 2]) -> Option<Drawn> {
        Some(Drawn::Specular(Event::Reflect, 1.0))
    }
}
