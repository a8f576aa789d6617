//! The smooth surface of a clear body.

use capwalk_math::{Real, Rgb, Vec3};

use super::event::{Drawn, Event};
use super::fresnel::cos_refracted;
use super::fresnel::fresnel_dielectric;
use super::local;

/// Reflects and refracts at one surface; `+z` points out of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric<R = f64> {
    /// Refractive index of the inside relative to the outside, `int_ior / ext_ior`.
    pub eta: R,
    /// Factor on what is reflected.
    pub specular_reflectance: Rgb<R>,
    /// Factor on what is transmitted.
    pub specular_transmittance: Rgb<R>,
}

impl<R: Real> Dielectric<R> {
    /// The refractive index of the far side relative to the near one.
    #[inline]
    fn far_over_near(&self, wi: Vec3<R>) -> R {
        if wi.z.value() < 0.0 {
            R::constant(1.0) / self.eta
        } else {
            self.eta
        }
    }

    #[inline]
    pub(super) fn reflect(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let reflectance = fresnel_dielectric(wi.z.abs(), self.far_over_near(wi));
        (
            local::reflected(wi),
            self.specular_reflectance * reflectance,
        )
    }

    /// Radiance shrinks by `1 / eta²` when it leaves the denser side, because
    /// its cone widens. Black where everything is reflected.
    #[inline]
    pub(super) fn transmit(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let eta = self.far_over_near(wi);
        let Some(cos_t) = cos_refracted(wi.z.abs(), eta) else {
            return (-wi, Rgb::zero());
        };
        let cos_t = if wi.z.value() < 0.0 { cos_t } else { -cos_t };
        let transmittance = R::constant(1.0) - fresnel_dielectric(wi.z.abs(), eta);
        (
            Vec3::new(-wi.x / eta, -wi.y / eta, cos_t),
            self.specular_transmittance * (transmittance / eta.squared()),
        )
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> Dielectric<S> {
        Dielectric {
            eta: f(self.eta),
            specular_reflectance: self.specular_reflectance.map(&mut *f),
            specular_transmittance: self.specular_transmittance.map(&mut *f),
        }
    }
}

impl Dielectric {
    /// Reflects with the probability that Fresnel's equations give.
    #[inline]
    pub(super) fn sample(&self, wi: Vec3, choice: f64, _u: [f64; 2]) -> Option<Drawn> {
        let reflected = fresnel_dielectric(wi.z.abs(), self.far_over_near(wi));
        Some(if choice < reflected {
            Drawn::Specular(Event::Reflect, reflected)
        } else {
            Drawn::Specular(Event::Transmit, 1.0 - reflected)
        })
    }
}
