//! Nodes to a [`Scene`]: what the plugins mean, one file per family.

mod bsdf;
mod colour;
mod emitter;
mod film;
mod integrator;
mod mesh_file;
mod metals;
mod sampler;
mod sensor;
mod shape;
mod texture;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use capwalk_math::Vec3;
use capwalk_scene::BsdfId;
use capwalk_scene::{
    Emitter, Integrator, Material, Quantity, Scene, SceneError, SensorModel, Settings, Shape,
    Texture, TextureId,
};

use crate::fields::{Child, Context, Fields};
use crate::node::{Kind, NodeId};
use crate::source::{Problem, Span};

/// The parts of the scene that grow while nodes are lowered.
struct Lowering<'a> {
    context: &'a Context<'a>,
    /// Where files are looked for, the nearest first.
    directories: Vec<PathBuf>,
    shapes: Vec<Shape>,
    materials: Vec<Material>,
    emitters: Vec<Emitter>,
    textures: Vec<Texture>,
    material_of_node: BTreeMap<NodeId, BsdfId>,
    texture_of_node: BTreeMap<NodeId, TextureId>,
    /// Area emitters that have their shape.
    attached: BTreeSet<NodeId>,
    /// How many materials the one being read stands in.
    bsdf_depth: usize,
    shape_ids: Names,
    material_ids: Names,
    emitter_ids: Names,
    places: Places,
}

/// Where the parts of the scene stand in the text, for errors found later.
#[derive(Default)]
struct Places {
    /// Of each shape.
    shapes: Vec<Span>,
    /// Of each emitter.
    emitters: Vec<Span>,
    /// Of each material.
    materials: Vec<Span>,
    /// Of numbers, by the names that [`SceneError::BadNumber`] uses.
    numbers: BTreeMap<String, Span>,
    film: Option<Span>,
}

/// Names that are taken.
#[derive(Default)]
struct Names(BTreeSet<String>);

impl Names {
    /// The name itself, or with `_2`, `_3` ... behind it if it is taken.
    fn make_unique(&mut self, name: &str) -> String {
        let numbered = (2..).map(|n: u64| format!("{name}_{n}"));
        let mut candidates = std::iter::once(name.to_owned()).chain(numbered);
        let unique = candidates
            .find(|candidate| !self.0.contains(candidate))
            .expect("numbers do not run out before names do");
        self.0.insert(unique.clone());
        unique
    }
}

/// The scene that the nodes describe, seen by the sensor with this index.
pub(crate) fn lower(
    context: &Context,
    directories: Vec<PathBuf>,
    sensor: usize,
) -> Result<Scene, Problem> {
    let mut lowering = Lowering {
        context,
        directories,
        shapes: Vec::new(),
        materials: Vec::new(),
        emitters: Vec::new(),
        textures: Vec::new(),
        material_of_node: BTreeMap::new(),
        texture_of_node: BTreeMap::new(),
        attached: BTreeSet::new(),
        bsdf_depth: 0,
        shape_ids: Names::default(),
        material_ids: Names::default(),
        emitter_ids: Names::default(),
        places: Places::default(),
    };
    // Names that the file gives are taken before any are made up.
    for node in &context.graph.nodes {
        let taken = match node.kind {
            Kind::Shape => &mut lowering.shape_ids,
            Kind::Bsdf => &mut lowering.material_ids,
            Kind::Emitter => &mut lowering.emitter_ids,
            _ => continue,
        };
        taken.0.extend(node.id.clone());
    }
    let fields = Fields::new(context, context.graph.root);
    scene_settings(&fields);
    lowering.scene(&fields, sensor)
}

/// Settings of Mitsuba's acceleration structures.
fn scene_settings(fields: &Fields) {
    let names = [
        "allow_thread_reordering",
        "compact_acceleration_structures",
        "embree_use_robust_intersections",
        "kd_intersection_cost",
        "kd_traversal_cost",
        "kd_empty_space_bonus",
        "kd_stop_prims",
        "kd_max_depth",
        "kd_min_max_bins",
        "kd_clip",
        "kd_retract_bad_splits",
        "kd_exact_primitive_threshold",
    ];
    fields.cosmetic(&names, "it tunes Mitsuba's ray tracing");
}

impl Lowering<'_> {
    fn scene(mut self, fields: &Fields, sensor: usize) -> Result<Scene, Problem> {
        let root = fields.node.span;
        let integrator = fields.child(Kind::Integrator)?.ok_or_else(|| {
            Problem::new(root, "the scene has no integrator")
                .help("add for example <integrator type=\"path\"/>")
        })?;
        let integrator = integrator::lower(&Fields::new(self.context, integrator.node))?;
        let sensors = fields.children(Kind::Sensor);
        let sensor = choose_sensor(self.context, root, &sensors, sensor)?;
        // The others are read for their mistakes, the chosen one last: its
        // places in the text count.
        for other in sensors.iter().filter(|other| other.node != sensor) {
            self.sensor(other.node)?;
        }
        let (sensor, film, sampler) = self.sensor(sensor)?;
        // Parts of sensors may stand in the scene to be referred to.
        for part in [Kind::Film, Kind::Filter, Kind::Sampler] {
            fields.children(part);
        }
        for (i, texture) in fields.children(Kind::Texture).into_iter().enumerate() {
            // Colours that are not in an emitter reflect, as in Mitsuba.
            let name = format!("texture_{i}");
            self.texture(texture.node, &name, Quantity::Reflectance)?;
        }
        for bsdf in fields.children(Kind::Bsdf) {
            self.bsdf(bsdf.node, &format!("bsdf_{}", self.materials.len()))?;
        }
        for shape in fields.children(Kind::Shape) {
            self.shape(shape)?;
        }
        for emitter in fields.children(Kind::Emitter) {
            self.scene_emitter(emitter)?;
        }
        fields.finish()?;
        let shows_light = !matches!(integrator, Integrator::Aov(_));
        if shows_light && self.emitters.is_empty() {
            let message = "the scene has no emitter; the picture will be black";
            self.context.warn(root, message);
        }
        let scene = Scene {
            shapes: self.shapes.into_iter().map(Arc::new).collect(),
            materials: self.materials,
            emitters: self.emitters,
            textures: self.textures.into_iter().map(Arc::new).collect(),
            sensor,
            film,
            settings: Settings {
                integrator,
                spp: sampler.spp,
                sampler: sampler.kind,
                seed: sampler.seed,
            },
        };
        match scene.check() {
            Ok(()) => {
                self.places.warn_of_clipping(self.context, &scene, root);
                Ok(scene)
            }
            Err(error) => Err(self.places.problem(&scene, root, error)),
        }
    }

    /// Adds a texture whose numbers stand at `span`.
    fn add_texture(&mut self, texture: Texture, span: Span) -> TextureId {
        for part in texture.parts() {
            self.places.numbers.insert(texture.part_name(part), span);
        }
        self.textures.push(texture);
        TextureId(self.textures.len() as u32 - 1)
    }

    /// The name of an object: its id, or a made up one that is free.
    fn shape_name(&mut self, id: Option<&str>, otherwise: &str) -> String {
        match id {
            Some(id) => id.to_owned(),
            None => self.shape_ids.make_unique(otherwise),
        }
    }

    fn material_name(&mut self, id: Option<&str>, otherwise: &str) -> String {
        match id {
            Some(id) => id.to_owned(),
            None => self.material_ids.make_unique(otherwise),
        }
    }
}

/// The sensor to render with.
fn choose_sensor(
    context: &Context,
    root: Span,
    sensors: &[Child],
    index: usize,
) -> Result<NodeId, Problem> {
    let Some(sensor) = sensors.get(index) else {
        let problem = match sensors.len() {
            0 => Problem::new(root, "the scene has no sensor")
                .help("add <sensor type=\"perspective\"> ... </sensor>"),
            n => Problem::new(root, format!("the scene has no sensor {index}"))
                .help(format!("its sensors are 0 to {}", n - 1)),
        };
        return Err(problem);
    };
    if sensors.len() > 1 && index == 0 {
        let message = format!(
            "the scene has {} sensors; rendering with the first",
            sensors.len()
        );
        context.warn(sensors[1].span, &message);
    }
    Ok(sensor.node)
}

impl Places {
    /// A warning if all shapes lie before or behind the sensor's clip planes.
    /// Sensors whose rays are parallel may scale depths, and are passed over.
    fn warn_of_clipping(&self, context: &Context, scene: &Scene, root: Span) {
        let sensor = &scene.sensor;
        if sensor.model == SensorModel::Orthographic {
            return;
        }
        let [a, b, c] = sensor.world_from_camera.rows;
        let forward = Vec3::new(a.z, b.z, c.z);
        let vertices = scene.shapes.iter().flat_map(|s| &s.mesh.positions);
        let depths = vertices.map(|&p| forward.dot(p - sensor.origin()));
        let (least, most) = depths.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| {
            (low.min(z), high.max(z))
        });
        let (near, far) = (sensor.near_clip, sensor.far_clip);
        let has_shapes = least <= most;
        if !has_shapes || (most > near && least < far) {
            return;
        }
        let number = self.numbers.get(&format!("{}.near_clip", sensor.id));
        let message = format!(
            "no surface is seen: seen from the sensor, all shapes lie at depths from {least:.4} \
             to {most:.4}, outside of near_clip {near} to far_clip {far}; set near_clip and \
             far_clip around them, or turn the sensor towards them (depths below 0 are behind it)"
        );
        context.warn(number.copied().unwrap_or(root), &message);
    }

    /// An error of the finished scene, at the place in the text it comes from.
    fn problem(&self, scene: &Scene, root: Span, error: SceneError) -> Problem {
        let shape_span = |id: &str| {
            let index = scene.shapes.iter().position(|s| s.id == id);
            index.map(|i| self.shapes[i])
        };
        let span = match &error {
            SceneError::Mesh { shape, .. }
            | SceneError::DuplicateId { id: shape }
            | SceneError::NoTextureCoordinates { shape, .. }
            | SceneError::NoDirections { shape, .. }
            | SceneError::NoAttribute { shape, .. } => shape_span(shape),
            SceneError::ZeroAreaEmitter { shape } => {
                let lamp = scene.shapes.iter().find(|s| s.id == *shape);
                let emitter = lamp.and_then(|s| s.emitter);
                emitter.map(|e| self.emitters[e.0 as usize])
            }
            SceneError::Material { material, .. } => {
                let index = scene.materials.iter().position(|m| m.id == *material);
                index.map(|i| self.materials[i])
            }
            SceneError::ImageSize { .. } => self.film,
            SceneError::BadNumber { name, .. } => {
                // `wood.data, texel 5` stands where `wood.data` does.
                let number = name.split(", texel ").next().unwrap_or(name);
                self.numbers.get(number).copied()
            }
            SceneError::SeveralEnvironments => {
                let emitters = scene.emitters.iter().zip(&self.emitters);
                let mut environments = emitters.filter(|(e, _)| e.is_environment());
                environments.nth(1).map(|(_, span)| *span)
            }
            _ => None,
        };
        Problem::new(span.unwrap_or(root), error.to_string())
    }
}
