//! The scene as a whole: its integrator, its sensor, and everything else in turn.

use std::path::PathBuf;
use std::sync::Arc;

use capwalk_scene::memory::{OF_SKY_TEXEL, OF_TRIANGLE, OF_TRIANGLE_OF_SHAPE};
use capwalk_scene::{Emitter, Integrator, Quantity, Scene, Settings};

use super::integrator;
use super::lowering::Lowering;
use super::size::{Triangles, sphere_division};
use super::spectrum_plugin::depends_on_use;
use crate::fields::{Child, Context, Fields};
use crate::node::Kind;
use crate::problem::Problem;
use crate::sensor_choice::SensorChoice;
use crate::sensor_settings::SensorSettings;
use crate::texts::Span;

/// The scene that the nodes describe, seen by this sensor, and all its sensors.
pub(crate) fn lower(
    context: &Context,
    directories: Vec<PathBuf>,
    sensor: Option<&SensorChoice>,
) -> Result<(Scene, Vec<SensorSettings>), Problem> {
    let fields = Fields::new(context, context.graph.root);
    scene_settings(&fields);
    Lowering::new(context, directories).scene(&fields, sensor)
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
    /// Refuses what lies between surfaces, wherever it stands.
    fn refuse_media(&self) -> Result<(), Problem> {
        let mut nodes = self.context.graph.nodes.iter();
        match nodes.find(|node| node.kind == Kind::Medium) {
            None => Ok(()),
            Some(medium) => Err(Problem::unsupported(
                medium.span,
                "participating media are not rendered",
            )
            .help("light goes from surface to surface here; remove the <medium>")),
        }
    }

    /// Refuses what the machine has no memory to render, once all of it is read.
    fn refuse_beyond_memory(&self, span: Span) -> Result<(), Problem> {
        let mut triangles = Triangles::default();
        for shape in &self.shapes {
            let count = shape.mesh.faces.len() as u64;
            triangles.add(&shape.id, count, shape.emitter.is_some());
        }
        let skies = self.emitters.iter().map(|emitter| match emitter {
            Emitter::EnvironmentMap { map, .. } => {
                u64::from(map.width) * u64::from(map.height) * OF_SKY_TEXEL
            }
            _ => 0,
        });
        let bytes = OF_TRIANGLE - OF_TRIANGLE_OF_SHAPE;
        triangles.refuse_beyond_memory(bytes, skies.sum(), span)
    }

    fn scene(
        mut self,
        fields: &Fields,
        sensor: Option<&SensorChoice>,
    ) -> Result<(Scene, Vec<SensorSettings>), Problem> {
        let root = fields.node.span;
        let integrator = fields.child(Kind::Integrator)?.ok_or_else(|| {
            Problem::missing(root, "the scene has no integrator")
                .help("add for example <integrator type=\"path\"/>")
        })?;
        let integrator = integrator::lower(self.context, integrator.node)?;
        self.refuse_media()?;
        let sensors = fields.children(Kind::Sensor);
        let chosen = choose_sensor(self.context, root, &sensors, sensor)?;
        // The chosen one last: its places in the text count.
        let mut all_sensors = Vec::new();
        for other in (0..sensors.len()).filter(|&i| i != chosen).chain([chosen]) {
            let unnamed = unnamed_sensor(other, sensors.len());
            all_sensors.push((other, self.sensor(sensors[other].node, &unnamed)?));
        }
        // Whatever its id, the sensor that renders is called so too.
        self.shape_ids.reserve("sensor");
        all_sensors.sort_by_key(|&(i, _)| i);
        let all_sensors: Vec<SensorSettings> = all_sensors.into_iter().map(|(_, v)| v).collect();
        let SensorSettings {
            sensor,
            film,
            sampler,
            spp,
            seed,
        } = all_sensors[chosen].clone();
        // Parts of sensors may stand in the scene to be referred to.
        for part in [Kind::Film, Kind::Filter, Kind::Sampler] {
            fields.children(part);
        }
        // Colours that are not in an emitter reflect, as in Mitsuba; those of some spectra
        // depend on where they are used, so these come last.
        let textures = fields.children(Kind::Texture).into_iter().enumerate();
        let (last, first): (Vec<_>, Vec<_>) = textures
            .partition(|(_, child)| depends_on_use(&self.context.graph.node(child.node).plugin));
        for (i, texture) in first {
            self.texture(texture.node, &format!("texture_{i}"), Quantity::Reflectance)?;
        }
        for bsdf in fields.children(Kind::Bsdf) {
            self.bsdf(bsdf.node, &format!("bsdf_{}", self.materials.len()))?;
        }
        let shapes = fields.children(Kind::Shape);
        self.spheres = sphere_division(self.context);
        let triangles = Triangles::known(self.context, &shapes, self.spheres);
        triangles.refuse_beyond_memory(OF_TRIANGLE, 0, root)?;
        for shape in shapes {
            self.shape(shape)?;
        }
        for emitter in fields.children(Kind::Emitter) {
            self.scene_emitter(emitter)?;
        }
        for (i, texture) in last {
            if !self.texture_of_node.contains_key(&texture.node) {
                self.texture(texture.node, &format!("texture_{i}"), Quantity::Radiance)?;
            }
        }
        fields.finish()?;
        self.refuse_beyond_memory(root)?;
        let shows_light = !matches!(integrator, Integrator::Aov(_));
        if shows_light && self.emitters.is_empty() {
            let message = "the scene has no emitter; the image will be black";
            self.context.warn_about_light(root, message);
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
                spp,
                sampler,
                seed,
            },
        };
        match scene.check() {
            Ok(()) => {
                self.places.warn_of_clipping(self.context, &scene, root);
                Ok((scene, all_sensors))
            }
            Err(error) => Err(self.places.problem(&scene, root, error)),
        }
    }
}

/// What a sensor is called that has no id.
fn unnamed_sensor(number: usize, sensors: usize) -> String {
    match sensors {
        1 => "sensor".into(),
        _ => format!("sensor_{number}"),
    }
}

/// The sensor to render with.
fn choose_sensor(
    context: &Context,
    root: Span,
    sensors: &[Child],
    choice: Option<&SensorChoice>,
) -> Result<usize, Problem> {
    let count = sensors.len();
    if count == 0 {
        return Err(Problem::missing(root, "the scene has no sensor")
            .help("add <sensor type=\"perspective\"> ... </sensor>"));
    }
    let Some(choice) = choice else {
        if count > 1 {
            let message = format!("the scene has {count} sensors; rendering with the first");
            context.warn(sensors[1].span, &message);
        }
        return Ok(0);
    };
    let ids = sensors
        .iter()
        .map(|child| &context.graph.node(child.node).id);
    let named = |(number, id): (usize, &Option<String>)| {
        id.clone().unwrap_or_else(|| unnamed_sensor(number, count))
    };
    let names: Vec<String> = ids.enumerate().map(named).collect();
    choice.place(&names).ok_or_else(|| match choice {
        SensorChoice::Number(number) => {
            Problem::missing(root, format!("the scene has no sensor {number}"))
                .help(format!("its sensors are 0 to {}", count - 1))
        }
        SensorChoice::Name(name) => {
            Problem::missing(root, format!("there is no sensor \"{name}\""))
                .help(format!("there are {}", names.join(", ")))
        }
    })
}
