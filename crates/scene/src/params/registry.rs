//! The names of all parameters, and what each of them refers to.

use std::collections::HashSet;

use capwalk_math::Rgb;

use super::{Parameter, ParameterKind};
use crate::bsdf::Bsdf;
use crate::emitter::Emitter;
use crate::scene::{BsdfId, EmitterId, Scene, ShapeId};

/// What a name refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Target {
    Translate(ShapeId, usize),
    Rotate(ShapeId, usize),
    Scale(ShapeId),
    Radiance(EmitterId, Channel),
    Reflectance(BsdfId, Channel),
    TranslateSensor(usize),
    RotateSensor(usize),
}

/// Which channels of a colour change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channel {
    All,
    One(usize),
}

impl Channel {
    const EACH: [Self; 4] = [Self::All, Self::One(0), Self::One(1), Self::One(2)];

    /// The colour that changes by one in these channels.
    pub(super) fn unit(self) -> Rgb {
        match self {
            Self::All => Rgb::splat(1.0),
            Self::One(channel) => {
                Rgb::from([0, 1, 2].map(|i| if i == channel { 1.0 } else { 0.0 }))
            }
        }
    }

    fn suffix(self) -> &'static str {
        match self {
            Self::All => "",
            Self::One(channel) => [".r", ".g", ".b"][channel],
        }
    }

    fn value(self, colour: Rgb) -> Vec<f64> {
        match self {
            Self::All => colour.to_array().to_vec(),
            Self::One(channel) => vec![colour[channel]],
        }
    }

    fn of(self, what: &str) -> String {
        match self {
            Self::All => format!("{what}, all channels together"),
            Self::One(channel) => format!("{what}, {} channel", ["red", "green", "blue"][channel]),
        }
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// A name and what it refers to.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub name: String,
    /// `None` for the reflectance of a material whose two sides differ: that
    /// is not one number.
    pub target: Option<Target>,
    pub alias_of: Option<String>,
}

/// All names, in the order of [`super::list`]. A name appears twice only if
/// the scene uses one id for two things.
pub(super) fn entries(scene: &Scene) -> Vec<Entry> {
    let mut entries = Vec::new();
    for (i, shape) in scene.shapes.iter().enumerate() {
        let id = ShapeId(i as u32);
        let name = &shape.id;
        let mut add = |name: String, target| entries.push(Entry::new(name, target));
        for (axis, letter) in AXES.iter().enumerate() {
            add(
                format!("{name}.translate.{letter}"),
                Target::Translate(id, axis),
            );
        }
        for (axis, letter) in AXES.iter().enumerate() {
            add(format!("{name}.rotate.{letter}"), Target::Rotate(id, axis));
        }
        add(format!("{name}.scale"), Target::Scale(id));
    }
    for (i, emitter) in scene.emitters.iter().enumerate() {
        let name = emitter.parameter_name(scene);
        for channel in Channel::EACH {
            let target = Target::Radiance(EmitterId(i as u32), channel);
            entries.push(Entry::new(format!("{name}{}", channel.suffix()), target));
        }
    }
    for i in 0..scene.materials.len() {
        add_material(scene, BsdfId(i as u32), &mut entries);
    }
    add_sensor(scene, &mut entries);
    entries
}

/// The names of a diffuse material: its own, then those of two-sided materials
/// that show it on both sides, then those of the shapes that have any of them.
fn add_material(scene: &Scene, id: BsdfId, entries: &mut Vec<Entry>) {
    let material = scene.material(id);
    let shown = shown_material(scene, id);
    if let Some(shown) = shown
        && shown != id
    {
        return; // listed with the material it shows
    }
    let shows_it = |other: BsdfId| other == id || shown_material(scene, other) == Some(id);
    let others = (0..scene.materials.len() as u32).map(BsdfId);
    let mut names = vec![material.id.clone()];
    for other in others.filter(|&other| other != id && shows_it(other)) {
        names.push(scene.material(other).id.clone());
    }
    for shape in scene.shapes.iter().filter(|shape| shows_it(shape.bsdf)) {
        names.push(format!("{}.bsdf", shape.id));
    }
    // `floor.bsdf` is often both the material's id and the shape's path.
    let mut seen = HashSet::new();
    names.retain(|name| seen.insert(name.clone()));
    for channel in Channel::EACH {
        let target = shown.map(|id| Target::Reflectance(id, channel));
        let full = |name: &String| format!("{name}.reflectance.value{}", channel.suffix());
        let first = full(&names[0]);
        for (i, name) in names.iter().map(full).enumerate() {
            let alias_of = (i > 0).then(|| first.clone());
            entries.push(Entry {
                name,
                target,
                alias_of,
            });
        }
    }
}

/// The diffuse material that a material shows on all sides it shows, or `None`
/// if its two sides differ.
fn shown_material(scene: &Scene, id: BsdfId) -> Option<BsdfId> {
    match scene.material(id).bsdf {
        Bsdf::Diffuse(_) => Some(id),
        Bsdf::TwoSided { front, back } => (front == back).then_some(front),
    }
}

fn add_sensor(scene: &Scene, entries: &mut Vec<Entry>) {
    let own = &scene.sensor.id;
    let motions = [
        ("translate", Target::TranslateSensor as fn(usize) -> Target),
        ("rotate", Target::RotateSensor),
    ];
    for (verb, target) in motions {
        for (axis, letter) in AXES.iter().enumerate() {
            let name = format!("sensor.{verb}.{letter}");
            entries.push(Entry::new(name.clone(), target(axis)));
            if own != "sensor" {
                entries.push(Entry {
                    name: format!("{own}.{verb}.{letter}"),
                    target: Some(target(axis)),
                    alias_of: Some(name),
                });
            }
        }
    }
}

impl Entry {
    fn new(name: String, target: Target) -> Self {
        Self {
            name,
            target: Some(target),
            alias_of: None,
        }
    }

    /// What a user reads about it; `None` if it is not a parameter.
    pub(super) fn describe(self, scene: &Scene) -> Option<Parameter> {
        use ParameterKind::*;
        let shape = |id: ShapeId| &scene.shape(id).id;
        let (kind, value, unit, description) = match self.target? {
            Target::Translate(id, axis) => {
                let what = format!("moves {} along world {}", shape(id), AXES[axis]);
                (Translation, vec![0.0], "world units", what)
            }
            Target::Rotate(id, axis) => {
                let what = format!("turns {} about its centre, world {}", shape(id), AXES[axis]);
                (Rotation, vec![0.0], "radians", what)
            }
            Target::Scale(id) => {
                let what = format!("scales {} about its centre", shape(id));
                (Scale, vec![1.0], "times its size", what)
            }
            Target::Radiance(id, channel) => {
                let emitter = scene.emitter(id);
                let what = match emitter {
                    Emitter::Area { shape: id, .. } => format!("radiance of {}", shape(*id)),
                    Emitter::Constant { id, .. } => format!("radiance of {id}"),
                };
                let value = channel.value(emitter.radiance());
                (Radiance, value, "radiance", channel.of(&what))
            }
            Target::Reflectance(id, channel) => {
                let Bsdf::Diffuse(diffuse) = &scene.material(id).bsdf else {
                    return None;
                };
                let what = format!("reflectance of {}", users(scene, id));
                let value = channel.value(diffuse.reflectance);
                (Reflectance, value, "fraction reflected", channel.of(&what))
            }
            Target::TranslateSensor(axis) => {
                let what = format!("moves the sensor along world {}", AXES[axis]);
                (SensorTranslation, vec![0.0], "world units", what)
            }
            Target::RotateSensor(axis) => {
                let what = format!("turns the sensor about its origin, world {}", AXES[axis]);
                (SensorRotation, vec![0.0], "radians", what)
            }
        };
        Some(Parameter {
            name: self.name,
            kind,
            value,
            unit,
            moves_discontinuities: !matches!(kind, Radiance | Reflectance),
            description,
            alias_of: self.alias_of,
        })
    }
}

/// The shapes whose look a diffuse material decides, or its own id if none.
fn users(scene: &Scene, id: BsdfId) -> String {
    let uses = |bsdf: BsdfId| match scene.material(bsdf).bsdf {
        Bsdf::Diffuse(_) => bsdf == id,
        Bsdf::TwoSided { front, back } => front == id || back == id,
    };
    let shapes = scene.shapes.iter().filter(|shape| uses(shape.bsdf));
    let names: Vec<&str> = shapes.map(|shape| shape.id.as_str()).collect();
    match names.len() {
        0 => format!("{} (unused)", scene.material(id).id),
        1..=3 => names.join(", "),
        n => format!("{} and {} more", names[..2].join(", "), n - 2),
    }
}
