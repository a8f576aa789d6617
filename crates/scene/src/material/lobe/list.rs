//! All materials that are not made of others: the list, and what each is asked.

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::{Drawn, Event, Specular};
use super::rough_surface::RoughSurface;
use crate::ids::TextureId;
use crate::material::fields::{FieldList, FieldMap, FieldReader};
use crate::material::number::{Derived, Number};
use crate::material::plain::{
    Anisotropy, AskedNumbers, InScene, Plain, RoughCoat, Samples, Scatters, TextureOf,
};

/// The enum of all, and what each of them answers.
macro_rules! materials {
    ($($(#[doc = $doc:literal])* $file:ident::$name:ident,)*) => {
        $(pub use super::$file::$name;)*

        /// A material that is not made of others: with numbers, one way in which a surface scatters light;
        /// with textures, what stands in a scene.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Lobe<N: Number = f64> {
            $($(#[doc = $doc])* $name($name<N>),)*
        }

        /// How those of a scene are stored: a derive for all numbers would ask for those that nobody stores.
        #[derive(Serialize, Deserialize)]
        #[serde(remote = "Lobe<TextureId>")]
        pub(in crate::material) enum Stored {
            $($name($name<TextureId>),)*
        }

        $(impl<N: Number> From<$name<N>> for Lobe<N> {
            fn from(it: $name<N>) -> Self {
                Self::$name(it)
            }
        })*

        impl<N: Number> Lobe<N> {
            /// What scene files call it.
            pub fn plugin(&self) -> &'static str {
                match self { $(Self::$name(_) => $name::<N>::PLUGIN,)* }
            }

            /// The perfectly specular events that it has.
            pub fn events(&self) -> &'static [Event] {
                match self { $(Self::$name(_) => $name::<N>::EVENTS,)* }
            }

            /// True if it has parts that are not perfectly specular: worth sampling emitters.
            pub fn has_smooth(&self) -> bool {
                match self { $(Self::$name(_) => $name::<N>::HAS_SMOOTH,)* }
            }

            /// True if it looks different from different sides.
            pub fn is_glossy(&self) -> bool {
                match self { $(Self::$name(_) => $name::<N>::IS_GLOSSY,)* }
            }

            /// True if part of what it reflects is reflected by facets ([`Lobe::mirrored`]).
            pub fn has_facets(&self) -> bool {
                match self { $(Self::$name(_) => $name::<N>::HAS_FACETS,)* }
            }

            /// The material with what becomes of each of its numbers, in the order of their fields.
            #[inline]
            pub fn mapped<B: Number>(&self, map: &mut impl FieldMap<N, B>) -> Lobe<B> {
                match self { $(Self::$name(it) => Lobe::$name(it.mapped(map)),)* }
            }
        }

        impl Lobe<TextureId> {
            /// What scene files call them.
            pub const PLUGINS: &[&str] = &[$(<$name as Plain>::PLUGIN),*];

            /// The material of this plugin that a reader finds; `None` if there is no such plugin.
            pub fn read<R: FieldReader>(plugin: &str, reader: &mut R) -> Option<Result<Self, R::Error>> {
                Some(match plugin {
                    $(<$name as Plain>::PLUGIN => {
                        reader.without_effect(<$name as Plain>::WITHOUT_EFFECT);
                        $name::read(reader).map(Self::$name)
                    })*
                    _ => return None,
                })
            }

            /// What stands in it.
            pub fn list(&self) -> FieldList {
                let mut list = FieldList::default();
                match self { $(Self::$name(it) => it.list(&mut list),)* }
                list
            }

            /// Whether it matters how it is turned about the normal.
            pub fn anisotropy(&self) -> Anisotropy {
                match self { $(Self::$name(it) => it.anisotropy(),)* }
            }

            /// True if it shows something to both sides, but not alike.
            pub fn has_inside(&self, texture: TextureOf) -> bool {
                match self { $(Self::$name(it) => it.has_inside(texture),)* }
            }

            /// Checks what the range of each number alone does not say.
            pub fn check(&self, texture: TextureOf) -> Result<(), &'static str> {
                match self { $(Self::$name(it) => it.check(texture),)* }
            }

            /// What whoever wrote it should know.
            pub fn warning(&self, texture: TextureOf) -> Option<&'static str> {
                match self { $(Self::$name(it) => it.warning(texture),)* }
            }

            /// The rough coat through which light gets to it.
            pub fn rough_coat(&self, texture: TextureOf) -> Option<RoughCoat> {
                match self { $(Self::$name(it) => it.rough_coat(texture),)* }
            }

            /// A number that is asked for and has no finite derivative somewhere, and why.
            pub fn infinite_derivative(&self, numbers: &AskedNumbers) -> Option<(&'static str, &'static str)> {
                match self { $(Self::$name(it) => it.infinite_derivative(numbers),)* }
            }
        }

        impl<R: Real> Lobe<R> {
            /// Scattered radiance per incident radiance and solid angle, the cosine
            /// with `wo` included: `f(wi, wo) |cos wo|`. Zero for the perfectly
            /// specular parts.
            #[inline]
            pub fn eval(&self, wi: Vec3<R>, wo: Vec3<R>) -> Rgb<R> {
                match self { $(Self::$name(it) => it.eval(wi, wo),)* }
            }

            /// Calls `visit` with each part of [`Lobe::eval`] that facets reflect as mirrors, and the product
            /// of their roughnesses.
            #[inline]
            pub fn mirrored(&self, wi: Vec3<R>, wo: Vec3<R>, visit: &mut impl FnMut(Rgb<R>, R)) {
                match self { $(Self::$name(it) => it.mirrored(wi, wo, visit),)* }
            }

            /// Where a perfectly specular event sends `wi`, and how much radiance
            /// comes back from there (Fresnel, tint, and the scaling of radiance by
            /// refraction), as smooth functions. `event.lobe` is not looked at.
            ///
            /// # Panics
            ///
            /// If the lobe has no such event; [`LocalBsdf::sample`](super::LocalBsdf::sample) never returns one.
            #[inline]
            pub fn specular(&self, Specular { event, .. }: Specular, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
                assert!(self.events().contains(&event), "{event:?} is no event of {self:?}");
                match self { $(Self::$name(it) => it.specular(event, wi),)* }
            }

            /// True if it has something to show to both sides.
            #[inline]
            pub fn is_two_sided(&self) -> bool {
                match self { $(Self::$name(it) => it.is_two_sided(),)* }
            }
        }

        impl Lobe {
            /// Density per solid angle of the smooth directions that [`LocalBsdf::sample`](super::LocalBsdf::sample)
            /// draws from this lobe, including the probability that it draws one.
            #[inline]
            pub fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
                match self { $(Self::$name(it) => it.pdf(wi, wo),)* }
            }

            /// [`Lobe::eval`] and [`Lobe::pdf`], which some lobes find faster together.
            #[inline]
            pub fn eval_and_pdf(&self, wi: Vec3, wo: Vec3) -> (Rgb, f64) {
                match self { $(Self::$name(it) => it.eval_and_pdf(wi, wo),)* }
            }

            /// Draws a direction or an event; `None` if the light ends here. `choice`
            /// and `u` are uniform in `[0, 1)`.
            #[inline]
            pub(crate) fn sample(&self, wi: Vec3, choice: f64, u: [f64; 2]) -> Option<Drawn> {
                match self { $(Self::$name(it) => it.sample(wi, choice, u),)* }
            }

            /// The lobe with a weight, as plain numbers; `None` unless it is a rough metal or a rough plastic.
            pub(super) fn rough_surface(&self, weight: f64) -> Option<RoughSurface> {
                match self { $(Self::$name(it) => it.rough_surface(weight),)* }
            }
        }
    };
}
materials! {
    /// The same radiance in all directions.
    diffuse::Diffuse,
    /// A metal mirror.
    conductor::Conductor,
    /// A metal of microfacets.
    rough_conductor::RoughConductor,
    /// The surface of a clear body.
    dielectric::Dielectric,
    /// The surface of a clear body, of microfacets.
    rough_dielectric::RoughDielectric,
    /// A clear pane without thickness.
    thin_dielectric::ThinDielectric,
    /// A clear coat over a diffuse base.
    plastic::Plastic,
    /// A rough clear coat over a diffuse base.
    rough_plastic::RoughPlastic,
    /// Clear facets and a diffuse base, added.
    polarized_plastic::PolarizedPlastic,
    /// Many appearances from few numbers.
    principled::Principled,
    /// The same of a sheet.
    principled_thin::PrincipledThin,
    /// Nothing: light passes.
    null::Null,
    /// Diffuse on both sides: a sheet of paper.
    diffuse_transmitter::DiffuseTransmitter,
}

impl<R: Real> Lobe<R> {
    /// The lobe with `f` of each of its numbers, in the order of their fields.
    pub fn map<S: Real>(&self, f: &mut impl FnMut(R) -> S) -> Lobe<S> {
        self.mapped(&mut EachNumber(f))
    }

    /// The primal lobe: without derivatives.
    pub fn value(&self) -> Lobe {
        self.map(&mut R::value)
    }
}

/// A function of each number.
struct EachNumber<'a, F>(&'a mut F);

impl<R: Real, S: Real, F: FnMut(R) -> S> FieldMap<R, S> for EachNumber<'_, F> {
    fn colour(&mut self, it: &Rgb<R>) -> Rgb<S> {
        it.map(&mut *self.0)
    }
    fn number(&mut self, it: &R) -> S {
        (self.0)(*it)
    }
    fn indices(&mut self, it: &R) -> S {
        (self.0)(*it)
    }
    fn index(&mut self, it: &R) -> S {
        (self.0)(*it)
    }
    fn derived<T: Derived>(&mut self, _: &T::Of<R>, it: &T) -> T {
        it.clone()
    }
}
