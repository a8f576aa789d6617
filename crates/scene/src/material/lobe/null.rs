//! The surface that is not there.

use std::marker::PhantomData;

use capwalk_math::{Real, Rgb, Vec3};
use serde::{Deserialize, Serialize};

use super::event::{Drawn, Event};
use crate::ids::TextureId;
use crate::material::fields::{FieldList, FieldMap, FieldReader};
use crate::material::number::Number;
use crate::material::plain::{InScene, Plain, Samples, Scatters, TextureOf};

/// Lets all light pass straight on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Null<N: Number = f64> {
    /// It has none.
    pub numbers: PhantomData<N>,
}

impl<N: Number> Default for Null<N> {
    fn default() -> Self {
        Self {
            numbers: PhantomData,
        }
    }
}

impl Null<TextureId> {
    pub(in crate::material) fn read<R: FieldReader>(_: &mut R) -> Result<Self, R::Error> {
        Ok(Self::default())
    }

    pub(in crate::material) fn list(&self, _: &mut FieldList) {}
}

impl<A: Number> Null<A> {
    pub(in crate::material) fn mapped<B: Number>(&self, _: &mut impl FieldMap<A, B>) -> Null<B> {
        Null::default()
    }
}

impl<N: Number> Plain for Null<N> {
    const PLUGIN: &'static str = "null";
    const EVENTS: &'static [Event] = &[Event::Pass];
    const IS_TWO_SIDED: bool = true;
    const IS_GLOSSY: bool = false;
}

impl InScene for Null<TextureId> {
    /// Both sides are alike.
    fn has_inside(&self, _: TextureOf) -> bool {
        false
    }
}

impl<R: Real> Scatters<R> for Null<R> {
    #[inline]
    fn specular(&self, _: Event, wi: Vec3<R>) -> (Vec3<R>, Rgb<R>) {
        (-wi, Rgb::splat(R::constant(1.0)))
    }
}

impl Samples for Null {
    #[inline]
    fn sample(&self, _: Vec3, _: f64, _: [f64; 2]) -> Option<Drawn> {
        Some(Drawn::Specular(Event::Pass, 1.0))
    }
}
