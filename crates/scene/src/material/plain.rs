//! What a material answers that is not made of others. Each stands in a file of its own under `lobe/`.

use capwalk_math::{Real, Rgb, Vec3};

use super::fields::WithoutEffect;
use super::lobe::event::{Drawn, Event};
use super::lobe::microfacets::{Distribution, Microfacets};
use super::lobe::rough_surface::RoughSurface;
use crate::ids::TextureId;
use crate::texture::Texture;

/// What is so whatever the numbers are.
pub trait Plain {
    /// What scene files call it.
    const PLUGIN: &'static str;
    /// Properties that are accepted without being read.
    const WITHOUT_EFFECT: WithoutEffect = WithoutEffect::NONE;
    /// The perfectly specular events that it has.
    const EVENTS: &'static [Event] = &[];
    /// True if it has parts that are not perfectly specular: worth sampling emitters.
    const HAS_SMOOTH: bool = Self::EVENTS.is_empty();
    /// True if it has something to show to both sides.
    const IS_TWO_SIDED: bool = false;
    /// Looks different from different sides.
    const IS_GLOSSY: bool = true;
    /// True if part of what it reflects is reflected by facets (`Scatters::mirrored`).
    const HAS_FACETS: bool = false;
}

/// What must be known of one that stands in a scene.
pub(super) trait InScene: Plain {
    /// Whether it matters how it is turned about the normal.
    fn anisotropy(&self) -> Anisotropy {
        Anisotropy::Isotropic
    }

    /// True if it shows something to both sides, but not alike.
    fn has_inside(&self, _texture: TextureOf) -> bool {
        Self::IS_TWO_SIDED
    }

    /// Checks what the range of each number alone does not say.
    fn check(&self, _texture: TextureOf) -> Result<(), &'static str> {
        Ok(())
    }

    /// What whoever wrote it should know.
    fn warning(&self, _texture: TextureOf) -> Option<&'static str> {
        None
    }

    /// The rough coat through which light gets to it: for such a table is made.
    fn rough_coat(&self, _texture: TextureOf) -> Option<RoughCoat> {
        None
    }

    /// A number that is asked for and has no finite derivative somewhere, and why.
    fn infinite_derivative(&self, _numbers: &AskedNumbers) -> Option<(&'static str, &'static str)> {
        None
    }
}

/// The textures of a scene.
pub type TextureOf<'a> = &'a dyn Fn(TextureId) -> &'a Texture;

/// Whether it matters how a material is turned about the normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anisotropy {
    /// It does not.
    Isotropic,
    /// It does.
    Anisotropic,
    /// It does where this texture is not zero; where it is, for derivatives with
    /// respect to the texture.
    By(TextureId),
}

impl Anisotropy {
    /// That of facets.
    pub(super) fn of(facets: &Microfacets<TextureId>) -> Self {
        match facets.alpha_u == facets.alpha_v {
            true => Self::Isotropic,
            false => Self::Anisotropic,
        }
    }
}

/// A coat of facets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughCoat {
    /// Their distribution.
    pub distribution: Distribution,
    /// Their roughness.
    pub alpha: f64,
    /// Refractive index relative to the outside.
    pub eta: f64,
}

/// The textures of a material as a shape has them, and which of them derivatives are asked for by.
pub struct AskedNumbers<'a> {
    /// The texture in the place of another one.
    pub texture: TextureOf<'a>,
    /// True if derivatives are asked for by what is in its place.
    pub is_asked_for: &'a dyn Fn(TextureId) -> bool,
}

impl AskedNumbers<'_> {
    /// True if some number of a texture is above zero.
    pub(super) fn has(&self, id: TextureId) -> bool {
        (self.texture)(id).data.iter().any(|&x| x > 0.0)
    }

    /// True if some number of a texture that is asked for is zero.
    pub(super) fn is_asked_for_at_zero(&self, id: TextureId) -> bool {
        (self.is_asked_for)(id) && (self.texture)(id).data.contains(&0.0)
    }
}

/// The arithmetic of one with numbers. Directions are those of a [lobe](super::lobe).
pub(super) trait Scatters<R: Real>: Plain {
    /// Scattered radiance per incident radiance and solid angle, the cosine
    /// with `wo` included: `f(wi, wo) |cos wo|`. Zero for the perfectly
    /// specular parts.
    #[inline]
    fn eval(&self, _wi: Vec3<R>, _wo: Vec3<R>) -> Rgb<R> {
        Rgb::zero()
    }

    /// Calls `visit` with each part of [`Scatters::eval`] that facets reflect as mirrors, and how rough they
    /// are ([`Microfacets::alpha2`]).
    #[inline]
    fn mirrored(&self, _wi: Vec3<R>, _wo: Vec3<R>, _visit: &mut impl FnMut(Rgb<R>, R)) {}

    /// Where a perfectly specular event sends `wi`, and how much radiance
    /// comes back from there (Fresnel, tint, and the scaling of radiance by
    /// refraction), as smooth functions.
    fn specular(&self, event: Event, _wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        unreachable!("{event:?} is no event of {}", Self::PLUGIN)
    }

    /// True if it has something to show to both sides.
    #[inline]
    fn is_two_sided(&self) -> bool {
        Self::IS_TWO_SIDED
    }
}

/// How directions are drawn.
pub(super) trait Samples: Scatters<f64> {
    /// Draws a direction or an event; `None` if the light ends here. `choice`
    /// and `u` are uniform in `[0, 1)`.
    fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn>;

    /// Density per solid angle of the smooth directions that are drawn,
    /// including the probability that one is.
    #[inline]
    fn pdf(&self, _wi: Vec3, _wo: Vec3) -> f64 {
        0.0
    }

    /// Both [`Scatters::eval`] and [`Samples::pdf`], where they are found faster together.
    #[inline]
    fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
        (self.eval(wi, wo), self.pdf(wi, wo))
    }

    /// The material with a weight as plain numbers, if its facets decide everything but a diffuse base.
    fn rough_surface(&self, _weight: f64) -> Option<RoughSurface> {
        None
    }
}
