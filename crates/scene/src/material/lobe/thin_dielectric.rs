//! The clear pane.

use capwalk_math::{Real, Rgb, Vec3};

use super::event::{Drawn, Event};
use super::fresnel::fresnel_dielectric;
use super::local;

/// A pane of glass without thickness: light that is not reflected, after any
/// number of reflections inside, goes straight on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinDielectric<R = f64> {
    /// Refractive index of the glass relative to what is around it.
    pub eta: R,
    /// Factor on what is reflected.
    pub specular_reflectance: Rgb<R>,
    /// Factor on what passes.
    pub specular_transmittance: Rgb<R>,
}

impl<R: Real> ThinDielectric<R> {
    /// All that comes back, `r + t r t + t r³ t + ... = 2 r / (1 + r)`.
    #[inline]
    fn reflectance(&self, wi: Vec3<R>) -> R {
        let once = fresnel_dielectric(wi.z.abs(), self.eta);
        once * R::constant(2.0) / (R::constant(1.0) + once)
    }

    #[inline]
    pub(super) fn reflect(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        (
            local::reflected(wi),
            self.specular_reflectance * self.reflectance(wi),
        )
    }

    #[inline]
    pub(super) fn pass(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let transmittance = R::constant(1.0) - self.reflectance(wi);
        (-wi, self.specular_transmittance * transmittance)
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> ThinDielectric<S> {
        ThinDielectric {
            eta: f(self.eta),
            specular_reflectance: self.specular_reflectance.map(&mut *f),
            specular_transmittance: self.specular_transmittance.map(&mut *f),
        }
    }
}

impl ThinDielectric {
    #[inline]
    pub(super) fn sample(&self, wi: Vec3, choice: f64, _u: [f64; 2]) -> Option<Drawn> {
        let reflected = self.reflectance(wi);
        Some(if choice < reflected {
            Drawn::Specular(Event::Reflect, reflected)
        } else {
            Drawn::Specular(Event::Pass, 1.0 - reflected)
        })
    }
}
