//! From a material and its textures at a point of a surface to lobes.

use std::marker::PhantomData;
use std::sync::Arc;

use capwalk_math::{Real, Rgb, Vec3};

use super::bsdf::Bsdf;
use super::fields::FieldMap;
use super::lobe::{self, Lobe, Microfacets, Principled, RoughTransmittance, Side, Tilt};
use super::number::{Circumstances, Derived, Indices, PrincipledIndex};
use super::plain::RoughCoat;
use super::traits::Composition;
use crate::ids::{BsdfId, TextureId};
use crate::scene::Scene;

/// The textures at a point of a surface.
pub trait TexturesAt<R> {
    /// The value of one.
    fn value(&mut self, id: TextureId) -> Rgb<R>;
    /// How the value of a bitmap changes along the first two axes of the shading
    /// frame, per unit of length.
    fn gradient(&mut self, id: TextureId) -> [Rgb<R>; 2];
    /// True if derivatives by its texels may be asked for: also where there is
    /// none of something, its amount is a number that can change.
    fn may_change(&self, id: TextureId) -> bool;
}

/// Textures that are the same everywhere, by their first texel.
#[derive(Clone, Copy, Debug)]
pub struct Constants<'a>(pub &'a Scene);

impl TexturesAt<f64> for Constants<'_> {
    fn value(&mut self, id: TextureId) -> Rgb {
        self.0.texture(id).texel(0)
    }
    fn gradient(&mut self, _: TextureId) -> [Rgb; 2] {
        [Rgb::zero(); 2]
    }
    fn may_change(&self, _: TextureId) -> bool {
        false
    }
}

/// What resolving needs besides the scene: what takes long to find out.
#[derive(Clone, Debug, Default)]
pub struct Resolver {
    /// A table for each material with a rough coat.
    coats: Vec<Option<Arc<RoughTransmittance>>>,
    /// Which materials have a two-sided one in them.
    two_sided: Vec<bool>,
}

/// What a surface does to light at a point, to a viewer on one side.
#[derive(Clone, Debug)]
pub struct Resolved<R: Real> {
    /// The lobes, which know the side that is seen.
    pub bsdf: lobe::LocalBsdf<R>,
    /// True if the shading frame is to be turned over: the back of a two-sided
    /// material is the front of another.
    pub flipped: bool,
}

impl Resolver {
    /// The tables for a checked scene.
    pub fn new(scene: &Scene) -> Self {
        let mut resolver = Self::default();
        resolver.update(scene);
        resolver
    }

    /// Goes over to another checked scene. Tables for the same numbers stay: they take long to
    /// make.
    pub fn update(&mut self, scene: &Scene) {
        let known = std::mem::take(&mut self.coats).into_iter().flatten();
        let mut known: Vec<Arc<RoughTransmittance>> = known.collect();
        let mut table = |coat: RoughCoat| {
            let RoughCoat {
                distribution,
                alpha,
                eta,
            } = coat;
            let mut tables = known.iter();
            if let Some(same) = tables.find(|table| table.is_for(distribution, alpha, eta)) {
                return Arc::clone(same);
            }
            let new = Arc::new(RoughTransmittance::new(distribution, alpha, eta));
            known.push(Arc::clone(&new));
            new
        };
        let coats = scene.materials.iter().map(|material| match &material.bsdf {
            Bsdf::Plain(lobe) => lobe.rough_coat(&|id| scene.texture(id)).map(&mut table),
            _ => None,
        });
        let coats = coats.collect();
        let is_two_sided = |id| {
            let mut parts = scene.materials_below(id).into_iter();
            parts.any(|part| {
                let composition = scene.material(part).bsdf.traits().composition;
                matches!(composition, Composition::Sides { .. })
            })
        };
        let ids = (0..scene.materials.len() as u32).map(BsdfId);
        self.two_sided = ids.map(is_two_sided).collect();
        self.coats = coats;
    }

    /// What passes the rough coat of a material, if it has one.
    pub fn coat(&self, id: BsdfId) -> Option<&RoughTransmittance> {
        self.coats.get(id.0 as usize)?.as_deref()
    }

    /// What a material does to light at a point, to a viewer on the given side of
    /// the face.
    pub fn resolve<R: Real>(
        &self,
        scene: &Scene,
        id: BsdfId,
        side: Side,
        textures: &mut impl TexturesAt<R>,
    ) -> Resolved<R> {
        let mut bsdf = lobe::LocalBsdf::default();
        let flipped = self.resolve_into(scene, id, side, textures, &mut bsdf);
        Resolved { bsdf, flipped }
    }

    /// The same with the lobes written to `bsdf`, which has none: they are large, and copying
    /// them takes as long as finding them. Returns whether the frame is to be turned over.
    #[inline]
    pub fn resolve_into<R: Real>(
        &self,
        scene: &Scene,
        id: BsdfId,
        side: Side,
        textures: &mut impl TexturesAt<R>,
        bsdf: &mut lobe::LocalBsdf<R>,
    ) -> bool {
        let mut parts = Parts {
            bsdf,
            flipped: false,
            is_opaque: self.two_sided[id.0 as usize],
            tilt: None,
        };
        self.add(scene, id, side, R::constant(1.0), textures, &mut parts);
        let side = if parts.flipped { Side::Front } else { side };
        let flipped = parts.flipped;
        bsdf.see_from(side);
        flipped
    }

    fn add<R: Real>(
        &self,
        scene: &Scene,
        id: BsdfId,
        side: Side,
        weight: R,
        textures: &mut impl TexturesAt<R>,
        parts: &mut Parts<'_, R>,
    ) {
        let one = R::constant(1.0);
        match &scene.material(id).bsdf {
            Bsdf::TwoSided { front, .. } if side == Side::Front => {
                self.add(scene, *front, side, weight, textures, parts);
            }
            Bsdf::TwoSided { back, .. } => {
                parts.flipped = true;
                self.add(scene, *back, Side::Front, weight, textures, parts);
            }
            Bsdf::Mask { opacity, nested } => {
                let opacity = number(scene, *opacity, textures);
                self.add(scene, *nested, side, weight * opacity, textures, parts);
                parts.push(weight * (one - opacity), Lobe::Null(lobe::Null::default()));
            }
            Bsdf::Blend {
                weight: second,
                nested,
            } => {
                let second = number(scene, *second, textures);
                self.add(
                    scene,
                    nested[0],
                    side,
                    weight * (one - second),
                    textures,
                    parts,
                );
                self.add(scene, nested[1], side, weight * second, textures, parts);
            }
            Bsdf::NormalMap {
                normals,
                nested,
                limits,
            } => {
                let normal = textures.value(*normals) * R::constant(2.0) - Rgb::splat(one);
                let normal = self.in_shown_frame(Vec3::from(normal.to_array()), *nested, side);
                parts.tilt = Some(Tilt::new(normal, *limits));
                self.add(scene, *nested, side, weight, textures, parts);
                parts.tilt = None;
            }
            Bsdf::BumpMap {
                heights,
                scale,
                nested,
                limits,
            } => {
                let scale = number(scene, *scale, textures);
                let slopes = textures.gradient(*heights);
                let [x, y] = slopes.map(|slope| -scene.texture(*heights).as_number(slope) * scale);
                let normal = self.in_shown_frame(Vec3::new(x, y, one), *nested, side);
                parts.tilt = Some(Tilt::new(normal, *limits));
                self.add(scene, *nested, side, weight, textures, parts);
                parts.tilt = None;
            }
            Bsdf::Plain(lobe) => {
                let lobe = lobe.mapped(&mut AtPoint {
                    scene,
                    textures,
                    is_opaque: parts.is_opaque,
                    coat: self.coats.get(id.0 as usize).and_then(Option::as_ref),
                    number: PhantomData,
                });
                if side == Side::Front || lobe.is_two_sided() {
                    parts.push(weight, lobe);
                }
            }
        }
    }

    /// The normal of a map around a material, in the frame in which the material is seen.
    /// From behind, a two-sided one is seen in a frame whose normal is turned over and whose
    /// tangents are not: the map's normal `n` is turned over with it, to `-n`, which is
    /// `(-x, -y, z)` there.
    fn in_shown_frame<R: Real>(&self, normal: Vec3<R>, nested: BsdfId, side: Side) -> Vec3<R> {
        match side == Side::Back && self.two_sided[nested.0 as usize] {
            true => Vec3::new(-normal.x, -normal.y, normal.z),
            false => normal,
        }
    }
}

/// What has been put together so far.
struct Parts<'a, R: Real> {
    bsdf: &'a mut lobe::LocalBsdf<R>,
    flipped: bool,
    /// There is a two-sided material: nothing may transmit, whatever changes.
    is_opaque: bool,
    /// That of the map which is looked into.
    tilt: Option<Tilt<R>>,
}

impl<R: Real> Parts<'_, R> {
    fn push(&mut self, weight: R, lobe: Lobe<R>) {
        // What passes goes straight on, whatever the normal.
        let passes = matches!(lobe, Lobe::Null(_));
        let tilt = self.tilt.filter(|_| !passes);
        self.bsdf.push_tilted(weight, lobe, tilt);
    }
}

/// A texture as one number: the luminance if it is a colour.
fn number<R: Real>(scene: &Scene, id: TextureId, textures: &mut impl TexturesAt<R>) -> R {
    scene.texture(id).as_number(textures.value(id))
}

/// What is known of a material at a point: its textures have values there.
struct AtPoint<'a, R, T> {
    scene: &'a Scene,
    textures: &'a mut T,
    is_opaque: bool,
    coat: Option<&'a Arc<RoughTransmittance>>,
    number: PhantomData<R>,
}

impl<R: Real, T: TexturesAt<R>> FieldMap<TextureId, R> for AtPoint<'_, R, T> {
    #[inline]
    fn colour(&mut self, it: &TextureId) -> Rgb<R> {
        self.textures.value(*it)
    }

    #[inline]
    fn number(&mut self, it: &TextureId) -> R {
        number(self.scene, *it, self.textures)
    }

    /// What is rough alike in all directions has one texture, which is looked up once.
    #[inline]
    fn facets(&mut self, it: &Microfacets<TextureId>) -> Microfacets<R> {
        let alpha_u: R = self.number(&it.alpha_u);
        Microfacets {
            distribution: it.distribution,
            alpha_u,
            alpha_v: match it.alpha_v == it.alpha_u {
                true => alpha_u,
                false => self.number(&it.alpha_v),
            },
        }
    }

    #[inline]
    fn indices(&mut self, it: &Indices) -> R {
        let inside: R = self.number(&it.int_ior);
        inside / self.number(&it.ext_ior)
    }

    #[inline]
    fn index(&mut self, it: &PrincipledIndex) -> R {
        match it {
            PrincipledIndex::Eta(eta) => self.number(eta),
            PrincipledIndex::Specular(specular) => {
                Principled::eta_of_specular(self.number(specular))
            }
        }
    }

    #[inline]
    fn derived<D: Derived>(&mut self, material: &D::Of<TextureId>, _: &()) -> D {
        D::find(material, self)
    }
}

impl<R: Real, T: TexturesAt<R>> Circumstances for AtPoint<'_, R, T> {
    #[inline]
    fn may_change(&self, id: TextureId) -> bool {
        self.textures.may_change(id)
    }

    #[inline]
    fn is_opaque(&self) -> bool {
        self.is_opaque
    }

    #[inline]
    fn coat(&self) -> Option<&Arc<RoughTransmittance>> {
        self.coat
    }
}

#[cfg(test)]
mod tests;
