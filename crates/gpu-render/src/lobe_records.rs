//! Materials as the kernels read them: `layout.rs` says which word is what.

use capwalk_boundary::Accel;
use capwalk_geometry::buffers::NONE;
use capwalk_scene::bsdf::{Coat, Metal};
use capwalk_scene::lobe::{Distribution, RoughTransmittance};
use capwalk_scene::{Bsdf, BsdfId, Emitter, Scene, Shape, TextureId};

use crate::layout::distribution::*;
use crate::layout::lobe::*;
use crate::layout::lobe_kind::*;
use crate::layout::record;
use crate::texture_records::{TextureRecords, float};

/// A lobe of the kernels.
struct LobeRecord<'a> {
    kind: usize,
    distribution: Distribution,
    nonlinear: bool,
    coat: Option<&'a RoughTransmittance>,
    /// In the order of the kernels' slots; the last ones may be left out.
    textures: Vec<Option<TextureId>>,
}

/// Where the record of a side of a shape's material starts, which is appended; [`NONE`] if that side
/// reflects nothing.
pub fn add_lobe(
    accel: &Accel,
    shape: &Shape,
    is_front: bool,
    textures: &mut TextureRecords,
    words: &mut Vec<u32>,
) -> u32 {
    let Some(id) = shown(&accel.scene, shape.bsdf, is_front) else {
        return NONE;
    };
    let Some(lobe) = lobe_record(accel, id) else {
        unreachable!("scenes with other materials are refused");
    };
    let slots: Vec<u32> = lobe
        .textures
        .iter()
        .map(|slot| {
            slot.map_or(NONE, |id| {
                textures.add(&accel.scene, id, Some(shape), words)
            })
        })
        .collect();
    let coat = lobe.coat.map_or(NONE, |coat| {
        let at = words.len() as u32;
        words.extend(coat.nodes().map(float));
        let internal = coat.internal_reflectance(coat.alpha(), coat.eta());
        words.push(float(internal));
        at
    });
    let distribution = match lobe.distribution {
        Distribution::Beckmann => BECKMANN,
        Distribution::Ggx => GGX,
    };
    let at = words.len() as u32;
    let head: [u32; FIRST_SLOT] = record(&[
        (0, lobe.kind as u32),
        (DISTRIBUTION, distribution as u32),
        (IS_NONLINEAR, lobe.nonlinear.into()),
        (COAT, coat),
        (SLOTS, slots.len() as u32),
    ]);
    words.extend(head);
    words.extend(slots);
    at
}

/// True if all surfaces are diffuse and light comes from no map: kernels of their own are for such
/// scenes.
pub fn only_diffuse(scene: &Scene) -> bool {
    let is_map = |emitter: &Emitter| matches!(emitter, Emitter::EnvironmentMap { .. });
    let is_diffuse = |id| matches!(scene.material(id).bsdf, Bsdf::Diffuse { .. });
    let shown = |shape: &Shape| [true, false].map(|is_front| shown(scene, shape.bsdf, is_front));
    let mut sides = scene.shapes.iter().flat_map(|shape| shown(shape));
    !scene.emitters.iter().any(is_map) && sides.all(|side| side.is_none_or(is_diffuse))
}

/// The material that is seen on a side of another one, if any: those of one lobe are one-sided.
fn shown(scene: &Scene, id: BsdfId, is_front: bool) -> Option<BsdfId> {
    match scene.material(id).bsdf {
        Bsdf::TwoSided { front, .. } if is_front => shown(scene, front, true),
        // The back is the front of another material.
        Bsdf::TwoSided { back, .. } => shown(scene, back, true),
        _ => is_front.then_some(id),
    }
}

/// The lobe of a material; `None` if the kernels have no such lobe.
fn lobe_record(accel: &Accel, id: BsdfId) -> Option<LobeRecord<'_>> {
    let plain = |kind, textures| LobeRecord {
        kind,
        distribution: Distribution::Beckmann,
        nonlinear: false,
        coat: None,
        textures,
    };
    Some(match &accel.scene.material(id).bsdf {
        Bsdf::Diffuse { reflectance } => plain(DIFFUSE, vec![Some(*reflectance)]),
        Bsdf::Conductor(metal) => plain(CONDUCTOR, of_metal(metal)),
        Bsdf::RoughConductor(metal, facets) => LobeRecord {
            distribution: facets.distribution,
            ..plain(
                ROUGH_CONDUCTOR,
                [of_metal(metal), facets.alpha.map(Some).into()].concat(),
            )
        },
        Bsdf::Plastic(coat) => LobeRecord {
            nonlinear: coat.nonlinear,
            ..plain(PLASTIC, of_coat(coat))
        },
        Bsdf::RoughPlastic {
            coat,
            distribution,
            alpha,
        } => LobeRecord {
            distribution: *distribution,
            nonlinear: coat.nonlinear,
            coat: accel.resolver.coat(id),
            ..plain(
                ROUGH_PLASTIC,
                [of_coat(coat), vec![Some(*alpha); 2]].concat(),
            )
        },
        _ => return None,
    })
}

/// Colours of base and mirror, real and imaginary part of the refractive index.
fn of_metal(metal: &Metal) -> Vec<Option<TextureId>> {
    let mirror = [metal.specular_reflectance, metal.eta, metal.k];
    [None].into_iter().chain(mirror.map(Some)).collect()
}

/// Colours of base and mirror, refractive indices inside and outside.
fn of_coat(coat: &Coat) -> Vec<Option<TextureId>> {
    let colours = [coat.diffuse_reflectance, coat.specular_reflectance];
    [colours, [coat.int_ior, coat.ext_ior]]
        .concat()
        .into_iter()
        .map(Some)
        .collect()
}
