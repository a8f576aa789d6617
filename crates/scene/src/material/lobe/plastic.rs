//! Plastic: a clear coat over a diffuse base.

use std::f64::consts::FRAC_1_PI;

use capwalk_math::{Real, Rgb, Vec3};

use super::event::{Drawn, Event};
use super::fresnel::{fresnel_dielectric, fresnel_diffuse};
use super::local;

/// A smooth dielectric over a diffuse base: a mirror image, and light that
/// enters, is scattered below any number of times, and leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic<R = f64> {
    /// Refractive index of the coat relative to the outside, `int_ior / ext_ior`.
    pub eta: R,
    /// Fraction of light reflected by the base, per channel.
    pub diffuse_reflectance: Rgb<R>,
    /// Factor on the mirror image.
    pub specular_reflectance: Rgb<R>,
    /// True if light that is thrown back by the coat from inside takes the
    /// colour of the base again, each time: colours get more saturated.
    pub nonlinear: bool,
}

/// What the base sends up through a coat, per light that gets to it:
/// `diffuse / (1 - what goes round once)`.
#[inline]
pub(super) fn base<R: Real>(diffuse: Rgb<R>, internal_reflectance: R, nonlinear: bool) -> Rgb<R> {
    let one = R::constant(1.0);
    match nonlinear {
        true => diffuse.map(|diffuse| diffuse / (one - diffuse * internal_reflectance)),
        false => diffuse * (one / (one - internal_reflectance)),
    }
}

/// Base and coat are chosen in proportion to these, times what passes the coat and what does not.
#[inline]
pub(super) fn base_chances(diffuse: Rgb, specular: Rgb) -> [f64; 2] {
    // What is black may have a derivative: it is sampled a little.
    const LEAST_CHANCE: f64 = 0.05;
    [diffuse, specular].map(|colour| local::mean(colour).max(LEAST_CHANCE))
}

/// Probability of choosing the base and not the coat, which lets the fraction `transmittance` pass.
#[inline(always)]
pub fn base_probability(transmittance: f64, chances: [f64; 2]) -> f64 {
    let base = transmittance * chances[0];
    let coat = (1.0 - transmittance) * chances[1];
    base / (base + coat)
}

impl<R: Real> Plastic<R> {
    #[inline]
    pub(super) fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        if wo.z.value() <= 0.0 {
            return Rgb::zero();
        }
        let one = R::constant(1.0);
        let enters = one - fresnel_dielectric(local::raised(wi).z, self.eta);
        let leaves = one - fresnel_dielectric(wo.z, self.eta);
        let internal = fresnel_diffuse(one / self.eta);
        // Radiance shrinks by `1 / eta²` on the way out.
        let scale = enters * leaves * wo.z * R::constant(FRAC_1_PI) / self.eta.squared();
        base(self.diffuse_reflectance, internal, self.nonlinear) * scale
    }

    #[inline]
    pub(super) fn reflect(&self, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        let wi = local::raised(wi);
        let reflectance = fresnel_dielectric(wi.z, self.eta);
        (
            local::reflected(wi),
            self.specular_reflectance * reflectance,
        )
    }

    pub(super) fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> Plastic<S> {
        Plastic {
            eta: f(self.eta),
            diffuse_reflectance: self.diffuse_reflectance.map(&mut *f),
            specular_reflectance: self.specular_reflectance.map(&mut *f),
            nonlinear: self.nonlinear,
        }
    }
}

impl Plastic {
    #[inline]
    fn base_probability(&self, wi: Vec3) -> f64 {
        let transmittance = 1.0 - fresnel_dielectric(wi.z.abs(), self.eta);
        let chances = base_chances(self.diffuse_reflectance, self.specular_reflectance);
        base_probability(transmittance, chances)
    }

    /// The mirror image or a direction by the cosine.
    #[inline]
    pub(super) fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        let base = self.base_probability(wi);
        Some(if choice < base {
            Drawn::Smooth(local::sample_cosine(u))
        } else {
            Drawn::Specular(Event::Reflect, 1.0 - base)
        })
    }

    #[inline]
    pub(super) fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        self.base_probability(wi) * local::cosine_pdf(wo)
    }
}
