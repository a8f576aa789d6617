//! What the device's renderer does not have.

use std::sync::Arc;

use capwalk_boundary::{Accel, Field, MAX_EVENTS, may_be_specular};
use capwalk_diff::{Chosen, Gathers, GradientOptions, Method, Wanted};
use capwalk_render::{MotionFacts, Plan, PreparedScene, RenderOptions, Tracer};
use capwalk_scene::{
    Bsdf, BsdfId, Emitter, Integrator, Quantity, SamplerKind, Scene, ShapeId, Slot, TextureId,
};
use capwalk_walk::Estimator;

use crate::edge_paths::LAST_VERTEX;
use crate::lobe_records::kind;

/// So many segments after roulette began no path is left.
const AFTER_ROULETTE: u32 = 1000;

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

/// Why a device cannot render with these options, if it cannot.
pub fn unsupported_options(options: &RenderOptions) -> Option<Unsupported> {
    options.adaptive.then(|| Unsupported {
        what: "samples go where the image is noisy (adaptive sampling)".to_owned(),
    })
}

/// The first thing of a derivative that the device's renderer does not have, by a method. It has those
/// with respect to the numbers of materials, but for rough coats, to what emitters send, and by edges to
/// what moves, unless rays are parallel, a mirror is curved or may show another one many times, mirrors are
/// too many, paths too long, or the film alone changes. Directions towards surfaces walk where edges there
/// cannot be gathered or are not to be, in the usual way.
pub fn unsupported_derivative(
    prepared: &PreparedScene,
    wanted: &Wanted,
    options: &GradientOptions,
) -> Option<Unsupported> {
    let in_motion = || in_motion(prepared, wanted, options);
    let what = wanted.moves().then(in_motion).flatten();
    let what = what.or_else(|| other_number(prepared, wanted))?;
    Some(Unsupported {
        what: format!("{what}, and derivatives with respect to that are asked for"),
    })
}

/// The method by which the device takes boundary terms: by edges, wherever that can be done and no other
/// one is asked for. Of edges that surfaces see in mirrors it has none, and walks there.
pub fn by_edges(method: &Method, accel: &Accel) -> Method {
    let gathers = match method {
        Method::Edges(gathers) => *gathers,
        _ => Gathers::ALL,
    };
    Method::Edges(Gathers {
        indirect: gathers.indirect && !accel.has_flat_events(),
        ..gathers
    })
}

/// The options with the method that the device takes for them. Where nothing moves all methods are one,
/// and the choice of the CPU is the walk.
pub fn settled(options: &GradientOptions, wanted: &Wanted) -> Chosen {
    let method = match options.method {
        Method::Auto if wanted.moves() => Method::EDGES,
        Method::Auto => Method::Walk,
        method => method,
    };
    GradientOptions { method, ..*options }.into()
}

/// The first thing that moves.
fn what_moves(scene: &Scene, wanted: &Wanted) -> String {
    let mut shapes = scene.shapes.iter().enumerate();
    let shape = shapes.find(|&(i, _)| wanted.shapes[i] || wanted.normals[i]);
    match shape {
        Some((_, shape)) => format!("shape \"{}\" moves", shape.id),
        None => "the sensor or an emitter moves".to_owned(),
    }
}

/// The first thing that the kernels do not have where something moves.
fn in_motion(
    prepared: &PreparedScene,
    wanted: &Wanted,
    options: &GradientOptions,
) -> Option<String> {
    let (scene, accel) = (prepared.scene(), prepared.accel());
    let view = &accel.view;
    let parallel = view
        .is_parallel()
        .then(|| "the sensor's rays are parallel".to_owned());
    // No field has the edges that are seen there.
    let curved = || {
        let mut shapes = (0..).zip(&scene.shapes);
        let (_, shape) = shapes.find(|&(i, shape)| {
            may_be_specular(scene, shape.bsdf) && !accel.is_flat_mirror(ShapeId(i))
        })?;
        let id = &shape.id;
        Some(format!("shape \"{id}\" is a curved mirror"))
    };
    let repeated = || {
        let Some(planes) = accel.mirror_planes() else {
            return Some("there are too many flat mirrors".to_owned());
        };
        let is_long = Plan::new(scene).reaches(MAX_EVENTS + 2);
        let what = format!("mirrors may show each other more than {MAX_EVENTS} times");
        (planes.count() > 1 && is_long).then_some(what)
    };
    let long = || {
        let plan = Plan::new(scene);
        // Roulette ends one path in twenty at each vertex, or more.
        let by_roulette = plan.rr_depth.saturating_add(AFTER_ROULETTE);
        let longest = plan.max_depth.unwrap_or(u32::MAX);
        (longest.min(by_roulette) > LAST_VERTEX)
            .then(|| format!("paths may have more than {LAST_VERTEX} segments"))
    };
    // There the film moves under rays that stay, and its points with it.
    let film = || {
        let is_alone = wanted.film && !wanted.geometry();
        is_alone.then(|| {
            "the field of view or the focus distance changes, and nothing moves".to_owned()
        })
    };
    let walks = || {
        let direct = Gathers {
            indirect: false,
            ..Gathers::ALL
        };
        let has_them = match options.method {
            Method::Auto => true,
            Method::Edges(gathers) => {
                let points = [gathers.points, gathers.camera_points];
                direct.without(gathers).is_nowhere()
                    && points == [Gathers::POINTS, Gathers::CAMERA_POINTS]
            }
            _ => false,
        };
        (!has_them).then(|| match options.method {
            Method::Edges(_) => "`edges` gathers fewer edges or other numbers of points".to_owned(),
            other => format!("the method is `{}`", other.name()),
        })
    };
    let steps = || {
        let field = Field::new(
            accel,
            prepared.boundaries_if(false),
            by_edges(&options.method, accel),
        );
        let facts = Arc::new(MotionFacts::of(scene, true));
        let tracer = Tracer::moving(prepared, field, options.walk, &facts);
        let walk = tracer.surface_walks()?.settings;
        let is_usual = walk.steps == 1 && walk.estimator == Estimator::Anchored;
        let what = "walks are not of one anchored step";
        (!is_usual || walk.antithetic).then(|| what.to_owned())
    };
    let what = parallel.or_else(curved).or_else(repeated);
    let what = what.or_else(walks).or_else(steps).or_else(long);
    match what {
        Some(what) => Some(format!("{what}, {}", what_moves(scene, wanted))),
        None => film(),
    }
}

/// The first number that is wanted and of which the kernels have no derivative: those of coats that
/// are rough, through which light passes by a table.
fn other_number(prepared: &PreparedScene, wanted: &Wanted) -> Option<String> {
    let (scene, resolver) = (prepared.scene(), &prepared.accel().resolver);
    let is_other = |slot: &Slot| slot.quantity != Quantity::Reflectance;
    let is_wanted = |id: TextureId| wanted.textures[id.0 as usize];
    scene.shapes.iter().find_map(|shape| {
        let coats = scene.materials_below(shape.bsdf).into_iter();
        let coats = coats.filter(|&id| resolver.coat(id).is_some());
        let mut slots = coats
            .flat_map(|id| scene.material(id).bsdf.slots())
            .filter(is_other);
        let slot = slots.find(|slot| is_wanted(scene.numbers_of(slot.texture, shape)))?;
        Some(format!(
            "\"{}\" of the material of shape \"{}\" changes",
            slot.name, shape.id
        ))
    })
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
            let plugin = of_material(scene, shape.bsdf)?;
            Some(format!(
                "the material of shape \"{}\" is of the type {plugin}",
                shape.id
            ))
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

/// The plugin in a material that the kernels have no lobe of.
fn of_material(scene: &Scene, id: BsdfId) -> Option<&'static str> {
    match &scene.material(id).bsdf {
        Bsdf::TwoSided { front, back } => {
            of_material(scene, *front).or_else(|| of_material(scene, *back))
        }
        bsdf => kind(bsdf).is_none().then(|| bsdf.plugin()),
    }
}
