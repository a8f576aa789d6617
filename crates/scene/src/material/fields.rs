//! The fields of a material, declared once: reading, listing and computing with them follow.

use super::lobe::microfacets::{Distribution, Microfacets};
use super::number::{Derived, Indices, Number, PrincipledIndex};
use crate::ids::TextureId;
use crate::quantity::Quantity;
use crate::slot::Slot;

/// Declares the fields of a material in the order in which they are read: `name: kind(..)`. Kinds are
/// the methods of [`FieldReader`], [`FieldList`] and [`FieldMap`]. Behind them stands what follows from
/// the rest.
macro_rules! fields {
    ($material:ident {
        $($field:ident: $kind:ident($($declared:expr),*),)*
        $(; $derived:ident: $type:ty)?
    }) => {
        impl $material<$crate::ids::TextureId> {
            /// The material that a reader finds.
            pub(in crate::material) fn read<R: $crate::material::fields::FieldReader>(
                reader: &mut R,
            ) -> Result<Self, R::Error> {
                use $crate::quantity::Quantity::*;
                Ok(Self {
                    $($field: reader.$kind(stringify!($field), $($declared),*)?,)*
                    $($derived: (),)?
                })
            }

            /// What stands in it.
            pub(in crate::material) fn list(
                &self,
                list: &mut $crate::material::fields::FieldList,
            ) {
                use $crate::quantity::Quantity::*;
                $(list.$kind(stringify!($field), $($declared,)* self.$field);)*
            }
        }

        impl<A: $crate::material::number::Number> $material<A> {
            /// The material with what becomes of each field, in order.
            #[inline]
            pub(in crate::material) fn mapped<B: $crate::material::number::Number>(
                &self,
                map: &mut impl $crate::material::fields::FieldMap<A, B>,
            ) -> $material<B> {
                $material {
                    $($field: map.$kind(&self.$field),)*
                    $($derived: map.derived::<$type>(self, &self.$derived),)?
                }
            }
        }
    };
}
pub(super) use fields;

/// Properties that are accepted, since files have them, and that change no image here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WithoutEffect {
    /// What files call them.
    pub names: &'static [&'static str],
    /// Why they have no effect.
    pub reason: &'static str,
}

impl WithoutEffect {
    pub(super) const NONE: Self = Self {
        names: &[],
        reason: "",
    };

    /// Of facets.
    pub(super) const SAMPLE_VISIBLE: Self = Self {
        names: &["sample_visible"],
        reason: "visible facets are always sampled",
    };
}

/// Finds what stands in the fields of a material, by their declarations.
pub trait FieldReader {
    /// What can go wrong.
    type Error;

    /// Takes note of properties that have no effect.
    fn without_effect(&mut self, properties: WithoutEffect);

    /// A number for each channel.
    fn colour(
        &mut self,
        name: &'static str,
        quantity: Quantity,
        default: f64,
    ) -> Result<TextureId, Self::Error>;

    /// A number.
    fn number(
        &mut self,
        name: &'static str,
        quantity: Quantity,
        default: f64,
    ) -> Result<TextureId, Self::Error>;

    /// `int_ior` and `ext_ior`, by default those of two substances.
    fn indices(
        &mut self,
        _: &'static str,
        quantity: Quantity,
        inside: &'static str,
        outside: &'static str,
    ) -> Result<Indices, Self::Error>;

    /// A refractive index, or by default `specular`.
    fn index(&mut self, name: &'static str, specular: f64) -> Result<PrincipledIndex, Self::Error>;

    /// `distribution`, and `alpha`, which has the default, or `alpha_u` and `alpha_v`.
    fn facets(
        &mut self,
        _: &'static str,
        alpha: f64,
    ) -> Result<Microfacets<TextureId>, Self::Error>;

    /// The distribution of facets.
    fn distribution(&mut self, name: &'static str) -> Result<Distribution, Self::Error>;

    /// Yes or no.
    fn flag(&mut self, name: &'static str, default: bool) -> Result<bool, Self::Error>;
}

/// What stands in a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FieldList {
    /// Its textures.
    pub slots: Vec<Slot>,
    /// What else is declared of it.
    pub choices: Vec<(&'static str, FieldChoice)>,
}

/// What stands in a material and is no number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldChoice {
    /// Yes or no.
    Flag(bool),
    /// One of several words.
    Word(&'static str),
}

impl FieldList {
    /// Adds a texture.
    pub fn slot(&mut self, name: &'static str, quantity: Quantity, texture: TextureId) {
        self.slots.push(Slot {
            name,
            texture,
            quantity,
        });
    }

    /// Adds what is no number.
    pub fn choice(&mut self, name: &'static str, it: FieldChoice) {
        self.choices.push((name, it));
    }

    pub(super) fn colour(&mut self, name: &'static str, quantity: Quantity, _: f64, it: TextureId) {
        self.slot(name, quantity, it);
    }

    pub(super) fn number(&mut self, name: &'static str, quantity: Quantity, _: f64, it: TextureId) {
        self.slot(name, quantity, it);
    }

    pub(super) fn indices(
        &mut self,
        _: &'static str,
        quantity: Quantity,
        _: &str,
        _: &str,
        it: Indices,
    ) {
        self.slot("int_ior", quantity, it.int_ior);
        self.slot("ext_ior", quantity, it.ext_ior);
    }

    pub(super) fn index(&mut self, name: &'static str, _: f64, it: PrincipledIndex) {
        match it {
            PrincipledIndex::Eta(eta) => {
                self.slot(name, Quantity::RefractiveIndex { bends: false }, eta);
            }
            PrincipledIndex::Specular(it) => self.slot("specular", Quantity::Fraction, it),
        }
    }

    pub(super) fn facets(&mut self, _: &'static str, _: f64, it: Microfacets<TextureId>) {
        self.distribution("distribution", it.distribution);
        if it.alpha_u == it.alpha_v {
            self.slot("alpha", Quantity::Roughness, it.alpha_u);
        } else {
            self.slot("alpha_u", Quantity::Roughness, it.alpha_u);
            self.slot("alpha_v", Quantity::Roughness, it.alpha_v);
        }
    }

    pub(super) fn distribution(&mut self, name: &'static str, it: Distribution) {
        self.choice(name, FieldChoice::Word(it.name()));
    }

    pub(super) fn flag(&mut self, name: &'static str, _: bool, it: bool) {
        self.choice(name, FieldChoice::Flag(it));
    }
}

/// What becomes of the numbers of a material, from one kind of numbers to another.
pub trait FieldMap<A: Number, B: Number> {
    /// Of a number for each channel.
    fn colour(&mut self, it: &A::Colour) -> B::Colour;

    /// Of a number.
    fn number(&mut self, it: &A) -> B;

    /// Of a refractive index relative to the outside.
    fn indices(&mut self, it: &A::Ratio) -> B::Ratio;

    /// Of the refractive index of a principled material.
    fn index(&mut self, it: &A::Index) -> B::Index;

    /// Of what follows from the rest of a material.
    fn derived<T: Derived>(&mut self, material: &T::Of<A>, it: &A::Derived<T>) -> B::Derived<T>;

    /// Of facets.
    #[inline]
    fn facets(&mut self, it: &Microfacets<A>) -> Microfacets<B> {
        Microfacets {
            distribution: it.distribution,
            alpha_u: self.number(&it.alpha_u),
            alpha_v: self.number(&it.alpha_v),
        }
    }

    /// Of a distribution.
    #[inline]
    fn distribution(&mut self, it: &Distribution) -> Distribution {
        *it
    }

    /// Of yes or no.
    #[inline]
    fn flag(&mut self, it: &bool) -> bool {
        *it
    }
}
