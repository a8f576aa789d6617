//! Lobes: the ways in which a surface scatters light, as pure arithmetic. To
//! add one: write its struct in a file of its own under `lobe/`, add a variant
//! to [`Lobe`], follow the compiler, and add it to the table of
//! `tests/lobes/table.rs`, which tests it.
//!
//! Formulas are those of Mitsuba 3's plugins of the same names. They differ in
//! four places: shadowing of Beckmann's facets is the integral and not a fit
//! to it (up to 0.35 % for each direction); refraction by facets that stand
//! upright fades out and does not jump (0.05 % of what a GGX surface of
//! roughness 0.3 transmits); the transmittance of rough coats is integrated
//! more exactly (0.1 %, for `eta` below 1 0.3 %); sheen is also on a
//! [`Principled`] of nothing but glass, as in Mitsuba's vectorised variants.
//!
//! A lobe has its numbers in it and knows nothing of textures, frames or faces.
//! All directions are unit vectors in the shading frame, normal `+z`, and point
//! away from the surface: `wi` to where the path comes from (the viewer), `wo`
//! to where it goes on (the light).
//!
//! ```
//! use capwalk_math::{Rgb, Vec3};
//! use capwalk_scene::lobe::{Bsdf, Diffuse, Lobe};
//! let mut bsdf = Bsdf::default();
//! bsdf.push(1.0, Lobe::Diffuse(Diffuse { reflectance: Rgb::splat(0.5) }));
//! let wi = Vec3::new(0.0, 0.6, 0.8);
//! let sample = bsdf.sample(wi, 0.3, [0.1, 0.7]).expect("a diffuse surface reflects everywhere");
//! let throughput = bsdf.eval(wi, sample.wo) / sample.pdf;
//! assert!((throughput.x - 0.5).abs() < 1e-12);
//! ```
//!
//! # Sides
//!
//! One-sided lobes (everything but [`Dielectric`], [`RoughDielectric`],
//! [`ThinDielectric`], [`Null`], and a [`Principled`] that transmits) are seen
//! from the front: whether the face shows its front is for the caller to
//! decide, by [`Bsdf::seen_from`] or by not asking. Interpolated normals can
//! turn away from a face that is seen. Then `wi.z <= 0`, and one-sided lobes
//! answer for the direction mirrored at the surface, `(wi.x, wi.y, |wi.z|)`,
//! which is continuous where a black back would be a jump that no edge carries.
//! [`Diffuse`] does not look at `wi`. They reflect to `wo.z > 0` only.
//!
//! Two-sided lobes take `wi.z < 0` for the inside, unless [`Bsdf::seen_from`]
//! says otherwise.
//!
//! # Derivatives
//!
//! `eval` and `specular` are continuous in directions and numbers, and smooth
//! but for these:
//!
//! * where total reflection begins, Fresnel's equations have an infinite slope,
//!   seen from the denser side. It can be integrated; its square, the variance,
//!   only just not;
//! * [`RoughPlastic`] interpolates a table linearly in the cosine: kinks;
//! * a lobe of weight zero is only sampled with [`Bsdf::explored`], and parts of a
//!   [`Principled`] that it has none of only if they are
//!   [explored](Principled::explored).

mod bsdf;
mod conductor;
mod dielectric;
mod diffuse;
mod fresnel;
mod local;
mod microfacets;
mod null;
mod plastic;
mod principled;
mod rough_conductor;
mod rough_dielectric;
mod rough_plastic;
mod rough_transmittance;
mod thin_dielectric;
mod tilt;
mod visible_facets;

pub use bsdf::{Bsdf, BsdfSample, Event, Side, Specular};
pub use conductor::Conductor;
pub use dielectric::Dielectric;
pub use diffuse::Diffuse;
pub use fresnel::{fresnel_conductor, fresnel_dielectric, fresnel_diffuse};
pub use local::{cosine_pdf, sample_cosine};
pub use microfacets::{Distribution, Microfacets};
pub use null::Null;
pub use plastic::Plastic;
pub use principled::{Explored, Principled};
pub use rough_conductor::RoughConductor;
pub use rough_dielectric::RoughDielectric;
pub use rough_plastic::RoughPlastic;
pub use rough_transmittance::RoughTransmittance;
pub use thin_dielectric::ThinDielectric;
pub use tilt::Tilt;

use capwalk_math::{Real, Rgb, Vec3};

/// One way in which a surface scatters light, with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Lobe<R = f64> {
    /// The same radiance in all directions.
    Diffuse(Diffuse<R>),
    /// A metal mirror.
    Conductor(Conductor<R>),
    /// A metal of microfacets.
    RoughConductor(RoughConductor<R>),
    /// The surface of a clear body.
    Dielectric(Dielectric<R>),
    /// The surface of a clear body, of microfacets.
    RoughDielectric(RoughDielectric<R>),
    /// A clear pane without thickness.
    ThinDielectric(ThinDielectric<R>),
    /// A clear coat over a diffuse base.
    Plastic(Plastic<R>),
    /// A rough clear coat over a diffuse base.
    RoughPlastic(RoughPlastic<R>),
    /// Many looks from few numbers.
    Principled(Principled<R>),
    /// Nothing: light passes.
    Null(Null),
}

/// What a lobe drew.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Drawn {
    /// A direction with a density.
    Smooth(Vec3),
    /// A perfectly specular event and its probability.
    Specular(Event, f64),
}

/// The same expression for whichever lobe it is.
macro_rules! each {
    ($lobe:expr, $it:ident => $value:expr) => {
        match $lobe {
            Lobe::Diffuse($it) => $value,
            Lobe::Conductor($it) => $value,
            Lobe::RoughConductor($it) => $value,
            Lobe::Dielectric($it) => $value,
            Lobe::RoughDielectric($it) => $value,
            Lobe::ThinDielectric($it) => $value,
            Lobe::Plastic($it) => $value,
            Lobe::RoughPlastic($it) => $value,
            Lobe::Principled($it) => $value,
            Lobe::Null($it) => $value,
        }
    };
}

impl<R: Real> Lobe<R> {
    /// Scattered radiance per incident radiance and solid angle, the cosine
    /// with `wo` included: `f(wi, wo) |cos wo|`. Zero for the perfectly
    /// specular parts.
    #[inline]
    pub fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
        match self {
            Lobe::Diffuse(lobe) => lobe.eval(wo),
            Lobe::RoughConductor(lobe) => lobe.eval(wi, wo),
            Lobe::RoughDielectric(lobe) => lobe.eval(wi, wo),
            Lobe::Plastic(lobe) => lobe.eval(wi, wo),
            Lobe::RoughPlastic(lobe) => lobe.eval(wi, wo),
            Lobe::Principled(lobe) => lobe.eval(wi, wo),
            Lobe::Conductor(_) | Lobe::Dielectric(_) | Lobe::ThinDielectric(_) | Lobe::Null(_) => {
                Rgb::zero()
            }
        }
    }

    /// Where a perfectly specular event sends `wi`, and how much radiance
    /// comes back from there (Fresnel, tint, and the scaling of radiance by
    /// refraction), as smooth functions. `event.lobe` is not looked at.
    ///
    /// # Panics
    ///
    /// If the lobe has no such event; [`Bsdf::sample`] never returns one.
    #[inline]
    pub fn specular(&self, event: Specular, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        match (self, event.event) {
            (Lobe::Conductor(lobe), Event::Reflect) => lobe.reflect(wi),
            (Lobe::Dielectric(lobe), Event::Reflect) => lobe.reflect(wi),
            (Lobe::Dielectric(lobe), Event::Transmit) => lobe.transmit(wi),
            (Lobe::ThinDielectric(lobe), Event::Reflect) => lobe.reflect(wi),
            (Lobe::ThinDielectric(lobe), Event::Pass) => lobe.pass(wi),
            (Lobe::Plastic(lobe), Event::Reflect) => lobe.reflect(wi),
            (Lobe::Null(_), Event::Pass) => (-wi, Rgb::splat(R::constant(1.0))),
            (lobe, event) => unreachable!("{event:?} is no event of {lobe:?}"),
        }
    }

    /// The lobe with `f` of each of its numbers, in the order of their fields.
    pub fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> Lobe<S> {
        match self {
            Lobe::Diffuse(lobe) => Lobe::Diffuse(lobe.map(f)),
            Lobe::Conductor(lobe) => Lobe::Conductor(lobe.map(f)),
            Lobe::RoughConductor(lobe) => Lobe::RoughConductor(lobe.map(f)),
            Lobe::Dielectric(lobe) => Lobe::Dielectric(lobe.map(f)),
            Lobe::RoughDielectric(lobe) => Lobe::RoughDielectric(lobe.map(f)),
            Lobe::ThinDielectric(lobe) => Lobe::ThinDielectric(lobe.map(f)),
            Lobe::Plastic(lobe) => Lobe::Plastic(lobe.map(f)),
            Lobe::RoughPlastic(lobe) => Lobe::RoughPlastic(lobe.map(f)),
            Lobe::Principled(lobe) => Lobe::Principled(lobe.map(f)),
            Lobe::Null(lobe) => Lobe::Null(*lobe),
        }
    }

    /// The lobe at rest: without derivatives.
    pub fn value(&self) -> Lobe {
        self.map(&mut R::value)
    }

    /// True if it has parts that are not perfectly specular: worth sampling lamps.
    pub fn has_smooth(&self) -> bool {
        match self {
            Lobe::Diffuse(_)
            | Lobe::RoughConductor(_)
            | Lobe::RoughDielectric(_)
            | Lobe::Plastic(_)
            | Lobe::RoughPlastic(_)
            | Lobe::Principled(_) => true,
            Lobe::Conductor(_) | Lobe::Dielectric(_) | Lobe::ThinDielectric(_) | Lobe::Null(_) => {
                false
            }
        }
    }

    /// True if it has something to show to both sides.
    pub fn is_two_sided(&self) -> bool {
        match self {
            Lobe::Dielectric(_)
            | Lobe::RoughDielectric(_)
            | Lobe::ThinDielectric(_)
            | Lobe::Null(_) => true,
            Lobe::Principled(lobe) => lobe.is_two_sided(),
            Lobe::Diffuse(_)
            | Lobe::Conductor(_)
            | Lobe::RoughConductor(_)
            | Lobe::Plastic(_)
            | Lobe::RoughPlastic(_) => false,
        }
    }
}

impl Lobe {
    /// Density per solid angle of the smooth directions that [`Bsdf::sample`]
    /// draws from this lobe, including the probability that it draws one.
    #[inline]
    pub fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        match self {
            Lobe::Diffuse(lobe) => lobe.pdf(wo),
            Lobe::RoughConductor(lobe) => lobe.pdf(wi, wo),
            Lobe::RoughDielectric(lobe) => lobe.pdf(wi, wo),
            Lobe::Plastic(lobe) => lobe.pdf(wi, wo),
            Lobe::RoughPlastic(lobe) => lobe.pdf(wi, wo),
            Lobe::Principled(lobe) => lobe.pdf(wi, wo),
            Lobe::Conductor(_) | Lobe::Dielectric(_) | Lobe::ThinDielectric(_) | Lobe::Null(_) => {
                0.0
            }
        }
    }

    /// Draws a direction or an event; `None` if the light ends here. `choice`
    /// and `u` are uniform in `[0, 1)`.
    #[inline]
    pub(crate) fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        each!(self, lobe => lobe.sample(wi, choice, u))
    }
}
