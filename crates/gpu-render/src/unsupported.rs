//! What the device's renderer does not have.

use capwalk_diff::Wanted;
use capwalk_gpu::{Gpu, Precision};
use capwalk_render::{PreparedScene, RenderOptions};
use capwalk_scene::{
    Bsdf, BsdfId, Emitter, Integrator, Quantity, SamplerKind, Scene, Slot, TextureId,
};

/// Something of a scene or of options that the device's renderer does not have.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}: not on the GPU yet; use the CPU (`--device cpu`)")]
pub struct Unsupported {
    /// What it is, and where.
    pub what: String,
}

/// The first thing of a scene that the device's renderer does not have; `None` if it has all. It
/// has diffuse surfaces, metals and plastics, smooth and rough, also two-sided ones, with any
/// texture; area emitters, light from everywhere and environment maps; every sensor and filter;
/// independent random numbers.
pub fn unsupported(prepared: &PreparedScene) -> Option<Unsupported> {
    let what = of_scene(prepared)?;
    Some(Unsupported { what })
}

/// The same of options.
pub fn unsupported_options(options: &RenderOptions) -> Option<Unsupported> {
    options.adaptive.then(|| Unsupported {
        what: "samples go where the image is noisy (adaptive sampling)".to_owned(),
    })
}

/// The first thing of a derivative that the device's renderer does not have. It has those with respect
/// to texels: the colours of materials, and what emitters send.
pub fn unsupported_derivative(prepared: &PreparedScene, wanted: &Wanted) -> Option<Unsupported> {
    let scene = prepared.scene();
    let moving = (0..scene.shapes.len()).find(|&i| wanted.shapes[i] || wanted.normals[i]);
    let moving = moving.map(|i| format!("shape \"{}\" moves", scene.shapes[i].id));
    let others = || {
        wanted
            .moves()
            .then(|| "the sensor or an emitter moves".to_owned())
    };
    let what = moving
        .or_else(others)
        .or_else(|| other_number(scene, wanted))?;
    Some(Unsupported {
        what: format!("{what}, and derivatives with respect to that are asked for"),
    })
}

/// The same in forward mode, where vertices may move on devices with double precision.
pub(crate) fn unsupported_motion(
    prepared: &PreparedScene,
    wanted: &Wanted,
    gpu: &Gpu,
) -> Option<Unsupported> {
    let rests = Wanted {
        shapes: vec![false; wanted.shapes.len()],
        ..wanted.clone()
    };
    if wanted.shapes.contains(&true) && gpu.precision() == Precision::Single {
        return Some(Unsupported {
            what: "shapes move, which needs double precision".to_owned(),
        });
    }
    unsupported_derivative(prepared, &rests)
}

/// The first number that is wanted and neither a colour of a material nor what an emitter sends.
fn other_number(scene: &Scene, wanted: &Wanted) -> Option<String> {
    let is_other =
        |slot: &Slot| !matches!(slot.quantity, Quantity::Reflectance | Quantity::Radiance);
    let is_wanted = |id: TextureId| wanted.textures[id.0 as usize];
    let material = scene.shapes.iter().find_map(|shape| {
        let mut slots = scene.slots_below(shape.bsdf).into_iter().filter(is_other);
        let slot = slots.find(|slot| is_wanted(scene.numbers_of(slot.texture, shape)))?;
        Some(format!(
            "\"{}\" of the material of shape \"{}\" changes",
            slot.name, shape.id
        ))
    });
    let emitter = || {
        let mut slots = scene
            .emitters
            .iter()
            .flat_map(Emitter::slots)
            .filter(is_other);
        let slot = slots.find(|slot| is_wanted(slot.texture))?;
        Some(format!("\"{}\" of an emitter changes", slot.name))
    };
    material.or_else(emitter)
}

fn of_scene(prepared: &PreparedScene) -> Option<String> {
    let scene = prepared.scene();
    if let Integrator::Aov(aov) = scene.settings.integrator {
        return Some(format!("the integrator renders {aov:?}, not light").to_lowercase());
    }
    if scene.settings.sampler != SamplerKind::Independent {
        return Some("the sampler takes Sobol points".to_owned());
    }
    if prepared.accel().has_flush_emitters() {
        return Some("an emitter is in the plane of another surface".to_owned());
    }
    let emitter = scene.emitters.iter().find_map(of_emitter);
    let material = || {
        scene.shapes.iter().find_map(|shape| {
            let kind = of_material(scene, shape.bsdf)?;
            Some(format!("the material of shape \"{}\" is {kind}", shape.id))
        })
    };
    emitter.or_else(material)
}

fn of_emitter(emitter: &Emitter) -> Option<String> {
    match emitter {
        Emitter::Area { .. } | Emitter::Constant { .. } | Emitter::EnvironmentMap { .. } => None,
        Emitter::Point { id, .. }
        | Emitter::Spot { id, .. }
        | Emitter::Projector { id, .. }
        | Emitter::Directional { id, .. } => Some(format!(
            "the emitter \"{id}\" is of the type {}",
            emitter.plugin()
        )),
    }
}

/// What a material has besides sides that the kernels have lobes of, with its article.
fn of_material(scene: &Scene, id: BsdfId) -> Option<&'static str> {
    match &scene.material(id).bsdf {
        Bsdf::Diffuse { .. }
        | Bsdf::Conductor(_)
        | Bsdf::RoughConductor(..)
        | Bsdf::Plastic(_)
        | Bsdf::RoughPlastic { .. } => None,
        Bsdf::TwoSided { front, back } => {
            of_material(scene, *front).or_else(|| of_material(scene, *back))
        }
        Bsdf::Dielectric(_) => Some("a dielectric"),
        Bsdf::RoughDielectric(..) => Some("a rough dielectric"),
        Bsdf::ThinDielectric(_) => Some("a thin dielectric"),
        Bsdf::PolarizedPlastic(..) => Some("a polarized plastic"),
        Bsdf::Principled(_) | Bsdf::PrincipledThin(_) => Some("a principled one"),
        Bsdf::Null => Some("a null one"),
        Bsdf::Mask { .. } => Some("a mask"),
        Bsdf::Blend { .. } => Some("a blend"),
        Bsdf::NormalMap { .. } => Some("a normal map"),
        Bsdf::BumpMap { .. } => Some("a bump map"),
    }
}
