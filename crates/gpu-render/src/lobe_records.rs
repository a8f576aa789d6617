//! Materials as the kernels read them: `layout.rs` says which word is what.

use capwalk_boundary::Accel;
use capwalk_geometry::buffers::NONE;
use capwalk_scene::fields::{FieldChoice, FieldList};
use capwalk_scene::lobe::{Distribution, Lobe, RoughTransmittance};
use capwalk_scene::{Bsdf, BsdfId, Emitter, Scene, Shape, TextureId};

use crate::layout::coat::COAT_NUMBERS;
use crate::layout::distribution::*;
use crate::layout::lobe::*;
use crate::layout::{kind_of_plugin, places_of_name, record};
use crate::texture_records::{TextureRecords, float};

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
    let bsdf = &accel.scene.material(id).bsdf;
    let Some(kind) = kind(bsdf) else {
        unreachable!("scenes with other materials are refused");
    };
    let FieldList { slots, choices } = bsdf.list();
    let mut at_places: Vec<Option<TextureId>> = Vec::new();
    for slot in &slots {
        for &place in places_of_name(slot.name) {
            at_places.resize(at_places.len().max(place + 1), None);
            at_places[place] = Some(slot.texture);
        }
    }
    let mut add = |id| textures.add(&accel.scene, id, Some(shape), words);
    let at_places = at_places.into_iter();
    let slots: Vec<u32> = at_places.map(|id| id.map_or(NONE, &mut add)).collect();
    let coat = accel
        .resolver
        .coat(id)
        .map_or(NONE, |coat| add_coat(coat, words));
    let is_chosen = |choice| choices.iter().any(|&(_, chosen)| chosen == choice);
    let is_ggx = is_chosen(FieldChoice::Word(Distribution::Ggx.name()));
    let at = words.len() as u32;
    let head: [u32; FIRST_SLOT] = record(&[
        (0, kind as u32),
        (DISTRIBUTION, if is_ggx { GGX } else { BECKMANN } as u32),
        (IS_NONLINEAR, is_chosen(FieldChoice::Flag(true)).into()),
        (COAT, coat),
        (SLOTS, slots.len() as u32),
    ]);
    words.extend(head);
    words.extend(slots);
    at
}

/// Where the record of what passes a rough coat starts, which is appended.
fn add_coat(coat: &RoughTransmittance, words: &mut Vec<u32>) -> u32 {
    let at = words.len() as u32;
    words.extend(coat.nodes().map(float));
    let internal = coat.internal_reflectance(coat.alpha(), coat.eta());
    words.push(float(internal));
    debug_assert_eq!(words.len(), at as usize + COAT_NUMBERS);
    at
}

/// The kind of lobe that a material is to the kernels; `None` if they have no such lobe.
pub fn kind(bsdf: &Bsdf) -> Option<usize> {
    match bsdf {
        Bsdf::Plain(lobe) => kind_of_plugin(lobe.plugin()),
        _ => None,
    }
}

/// True if all surfaces are diffuse and light comes from no map: kernels of their own are for such
/// scenes.
pub fn only_diffuse(scene: &Scene) -> bool {
    let is_map = |emitter: &Emitter| matches!(emitter, Emitter::EnvironmentMap { .. });
    let is_diffuse = |id| matches!(scene.material(id).bsdf, Bsdf::Plain(Lobe::Diffuse(_)));
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
