//! Any lobe, and what all of them answer.

use capwalk_math::{Real, Rgb, Vec3};

use super::conductor::Conductor;
use super::dielectric::Dielectric;
use super::diffuse::Diffuse;
use super::event::{Drawn, Event, Specular};
use super::null::Null;
use super::plastic::Plastic;
use super::polarized_plastic::PolarizedPlastic;
use super::principled::Principled;
use super::principled_thin::PrincipledThin;
use super::rough_conductor::RoughConductor;
use super::rough_dielectric::RoughDielectric;
use super::rough_plastic::RoughPlastic;
use super::rough_surface::RoughSurface;
use super::thin_dielectric::ThinDielectric;

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
    /// Clear facets and a diffuse base, added.
    PolarizedPlastic(PolarizedPlastic<R>),
    /// Many looks from few numbers.
    Principled(Principled<R>),
    /// The same of a sheet.
    PrincipledThin(PrincipledThin<R>),
    /// Nothing: light passes.
    Null(Null),
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
            Lobe::PolarizedPlastic($it) => $value,
            Lobe::Principled($it) => $value,
            Lobe::PrincipledThin($it) => $value,
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
            Lobe::PolarizedPlastic(lobe) => lobe.eval(wi, wo),
            Lobe::Principled(lobe) => lobe.eval(wi, wo),
            Lobe::PrincipledThin(lobe) => lobe.eval(wi, wo),
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
    /// If the lobe has no such event; [`LocalBsdf::sample`](super::LocalBsdf::sample) never returns one.
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

    /// The perfectly specular events that it has.
    pub fn events(&self) -> &'static [Event] {
        match self {
            Lobe::Conductor(_) | Lobe::Plastic(_) => &[Event::Reflect],
            Lobe::Dielectric(_) => &[Event::Reflect, Event::Transmit],
            Lobe::ThinDielectric(_) => &[Event::Reflect, Event::Pass],
            Lobe::Null(_) => &[Event::Pass],
            Lobe::Diffuse(_)
            | Lobe::RoughConductor(_)
            | Lobe::RoughDielectric(_)
            | Lobe::RoughPlastic(_)
            | Lobe::PolarizedPlastic(_)
            | Lobe::Principled(_)
            | Lobe::PrincipledThin(_) => &[],
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
            Lobe::PolarizedPlastic(lobe) => Lobe::PolarizedPlastic(lobe.map(f)),
            Lobe::Principled(lobe) => Lobe::Principled(lobe.map(f)),
            Lobe::PrincipledThin(lobe) => Lobe::PrincipledThin(lobe.map(f)),
            Lobe::Null(lobe) => Lobe::Null(*lobe),
        }
    }

    /// The primal lobe: without derivatives.
    pub fn value(&self) -> Lobe {
        self.map(&mut R::value)
    }

    /// True if it has parts that are not perfectly specular: worth sampling emitters.
    pub fn has_smooth(&self) -> bool {
        match self {
            Lobe::Diffuse(_)
            | Lobe::RoughConductor(_)
            | Lobe::RoughDielectric(_)
            | Lobe::Plastic(_)
            | Lobe::RoughPlastic(_)
            | Lobe::PolarizedPlastic(_)
            | Lobe::Principled(_)
            | Lobe::PrincipledThin(_) => true,
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
            | Lobe::PrincipledThin(_)
            | Lobe::Null(_) => true,
            Lobe::Principled(lobe) => lobe.is_two_sided(),
            Lobe::Diffuse(_)
            | Lobe::Conductor(_)
            | Lobe::RoughConductor(_)
            | Lobe::Plastic(_)
            | Lobe::RoughPlastic(_)
            | Lobe::PolarizedPlastic(_) => false,
        }
    }
}

impl Lobe {
    /// Density per solid angle of the smooth directions that [`LocalBsdf::sample`](super::LocalBsdf::sample)
    /// draws from this lobe, including the probability that it draws one.
    #[inline]
    pub fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        match self {
            Lobe::Diffuse(lobe) => lobe.pdf(wo),
            Lobe::RoughConductor(lobe) => lobe.pdf(wi, wo),
            Lobe::RoughDielectric(lobe) => lobe.pdf(wi, wo),
            Lobe::Plastic(lobe) => lobe.pdf(wi, wo),
            Lobe::RoughPlastic(lobe) => lobe.pdf(wi, wo),
            Lobe::PolarizedPlastic(lobe) => lobe.pdf(wi, wo),
            Lobe::Principled(lobe) => lobe.pdf(wi, wo),
            Lobe::PrincipledThin(lobe) => lobe.pdf(wi, wo),
            Lobe::Conductor(_) | Lobe::Dielectric(_) | Lobe::ThinDielectric(_) | Lobe::Null(_) => {
                0.0
            }
        }
    }

    /// [`Lobe::eval`] and [`Lobe::pdf`], which some lobes find faster together.
    #[inline]
    pub fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
        match self {
            Lobe::RoughConductor(lobe) => lobe.eval_and_pdf(wi, wo),
            Lobe::RoughPlastic(lobe) => lobe.eval_and_pdf(wi, wo),
            Lobe::Diffuse(_)
            | Lobe::Conductor(_)
            | Lobe::Dielectric(_)
            | Lobe::RoughDielectric(_)
            | Lobe::ThinDielectric(_)
            | Lobe::Plastic(_)
            | Lobe::PolarizedPlastic(_)
            | Lobe::Principled(_)
            | Lobe::PrincipledThin(_)
            | Lobe::Null(_) => (self.eval(wi, wo), self.pdf(wi, wo)),
        }
    }

    /// The lobe with a weight, as plain numbers; `None` unless it is a rough metal or a rough plastic.
    pub(super) fn rough_surface(&self, weight: f64) -> Option<RoughSurface> {
        match self {
            Lobe::RoughConductor(lobe) => Some(RoughSurface::metal_of(weight, lobe)),
            Lobe::RoughPlastic(lobe) => Some(RoughSurface::plastic_of(weight, lobe)),
            _ => None,
        }
    }

    /// Draws a direction or an event; `None` if the light ends here. `choice`
    /// and `u` are uniform in `[0, 1)`.
    #[inline]
    pub(crate) fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
        each!(self, lobe => lobe.sample(wi, choice, u))
    }
}
