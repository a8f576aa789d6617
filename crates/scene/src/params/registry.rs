//! The names of all parameters, and what each of them refers to.

use std::collections::HashSet;
use std::sync::Arc;

use super::{Parameter, ParameterKind};
use crate::emitter::Emitter;
use crate::quantity::Quantity;
use crate::scene::{BsdfId, Scene, ShapeId};
use crate::sensor::Optic;
use crate::shape::Shape;
use crate::texture::{Part, TextureId};

/// What a name refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Target {
    Translate(ShapeId, usize),
    Rotate(ShapeId, usize),
    Scale(ShapeId),
    /// Some texels of a texture together.
    Texels(TextureId, Part, Quantity, Channel),
    TranslateSensor(usize),
    RotateSensor(usize),
    SensorOptic(Optic),
}

/// Which channels of a colour change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channel {
    All,
    One(usize),
}

impl Channel {
    const EACH: [Self; 4] = [Self::All, Self::One(0), Self::One(1), Self::One(2)];

    /// The ones that a texture has.
    fn of_texture(channels: usize) -> &'static [Self] {
        match channels {
            1 => &Self::EACH[..1],
            _ => &Self::EACH,
        }
    }

    /// True if this channel is among them.
    pub(super) fn contains(self, channel: usize) -> bool {
        matches!(self, Self::All) || self == Self::One(channel)
    }

    fn suffix(self) -> &'static str {
        match self {
            Self::All => "",
            Self::One(channel) => [".r", ".g", ".b"][channel],
        }
    }

    fn values(self, texel: &[f64]) -> Vec<f64> {
        match self {
            Self::All => texel.to_vec(),
            Self::One(channel) => vec![texel[channel]],
        }
    }

    fn of(self, what: &str, channels: usize) -> String {
        match self {
            Self::All if channels == 1 => what.to_owned(),
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
        for attribute in &shape.attributes {
            add_texture(scene, attribute.texture, Quantity::Attribute, &mut entries);
        }
    }
    let mut listed = HashSet::new();
    for emitter in &scene.emitters {
        for slot in emitter.slots() {
            if listed.insert(slot.texture) {
                add_texture(scene, slot.texture, slot.quantity, &mut entries);
            }
        }
    }
    for (i, material) in scene.materials.iter().enumerate() {
        for slot in material.bsdf.slots() {
            if listed.insert(slot.texture) {
                add_texture(scene, slot.texture, slot.quantity, &mut entries);
            }
        }
        add_contradiction(scene, BsdfId(i as u32), &mut entries);
    }
    add_sensor(scene, &mut entries);
    entries
}

/// The names of a texture: its own, then those by the emitters and materials
/// that it stands in.
fn add_texture(scene: &Scene, id: TextureId, quantity: Quantity, entries: &mut Vec<Entry>) {
    let texture = scene.texture(id);
    let mut names = vec![texture.id.clone()];
    for emitter in &scene.emitters {
        for slot in emitter.slots().iter().filter(|s| s.texture == id) {
            names.push(match slot.name {
                "" => emitter.name(scene),
                slot => format!("{}.{slot}", emitter.name(scene)),
            });
        }
    }
    for (i, material) in scene.materials.iter().enumerate() {
        for slot in material.bsdf.slots().iter().filter(|s| s.texture == id) {
            for name in material_names(scene, BsdfId(i as u32)) {
                names.push(format!("{name}.{}", slot.name));
            }
        }
    }
    // `floor.bsdf` is often both the material's id and the shape's path.
    let mut seen = HashSet::new();
    names.retain(|name| seen.insert(name.clone()));
    for part in texture.parts() {
        for &channel in Channel::of_texture(texture.channels) {
            let suffix = channel.suffix();
            let full = |name: &String| match part.name {
                "" => format!("{name}{suffix}"),
                part => format!("{name}.{part}{suffix}"),
            };
            let first = full(&names[0]);
            let mut names: Vec<String> = names
                .iter()
                .flat_map(|name| {
                    // A single number is called by the name of its slot, too.
                    let short = texture.channels == 1 && part.name == "value";
                    std::iter::once(full(name)).chain(short.then(|| name.clone()))
                })
                .collect();
            for (i, name) in names.drain(..).enumerate() {
                entries.push(Entry {
                    name,
                    target: Some(Target::Texels(id, part, quantity, channel)),
                    alias_of: (i > 0).then(|| first.clone()),
                });
            }
        }
    }
}

/// What a material is called: its own name, then those of materials that show
/// it on all sides they show, then those by the shapes that have any of them.
fn material_names(scene: &Scene, id: BsdfId) -> Vec<String> {
    let shows_it = |other: BsdfId| {
        let parts = |id: &BsdfId| scene.material(*id).bsdf.shown_part();
        std::iter::successors(Some(other), parts).any(|part| part == id)
    };
    let others = (0..scene.materials.len() as u32).map(BsdfId);
    let mut names = vec![scene.material(id).id.clone()];
    for other in others.filter(|&other| other != id && shows_it(other)) {
        names.push(scene.material(other).id.clone());
    }
    for shape in scene.shapes.iter().filter(|shape| shows_it(shape.bsdf)) {
        names.push(format!("{}.bsdf", shape.id));
    }
    names
}

/// The names that a material made of several would have if they were one. They
/// refer to nothing, but the message can say why.
fn add_contradiction(scene: &Scene, id: BsdfId, entries: &mut Vec<Entry>) {
    let bsdf = &scene.material(id).bsdf;
    if bsdf.parts().is_empty() || bsdf.shown_part().is_some() {
        return;
    }
    let own: Vec<&str> = bsdf.slots().iter().map(|slot| slot.name).collect();
    let slots = scene.slots_below(id);
    let mut slots: Vec<&str> = slots.iter().map(|slot| slot.name).collect();
    slots.retain(|slot| !own.contains(slot));
    slots.sort_unstable();
    slots.dedup();
    for name in material_names(scene, id) {
        for slot in &slots {
            for channel in Channel::EACH {
                entries.push(Entry {
                    name: format!("{name}.{slot}.value{}", channel.suffix()),
                    target: None,
                    alias_of: None,
                });
            }
        }
    }
}

fn add_sensor(scene: &Scene, entries: &mut Vec<Entry>) {
    let own = &scene.sensor.id;
    let mut add = |number: String, target| {
        let name = format!("sensor.{number}");
        entries.push(Entry::new(name.clone(), target));
        if own != "sensor" {
            entries.push(Entry {
                name: format!("{own}.{number}"),
                target: Some(target),
                alias_of: Some(name),
            });
        }
    };
    let motions = [
        ("translate", Target::TranslateSensor as fn(usize) -> Target),
        ("rotate", Target::RotateSensor),
    ];
    for (verb, target) in motions {
        for (axis, letter) in AXES.iter().enumerate() {
            add(format!("{verb}.{letter}"), target(axis));
        }
    }
    for optic in Optic::ALL {
        if scene.sensor.model.optic(optic).is_some() {
            add(optic.name().into(), Target::SensorOptic(optic));
        }
    }
}

/// The sort, the unit and a description of a number of the sensor.
pub(super) fn optic_text(optic: Optic) -> (ParameterKind, &'static str, &'static str) {
    use ParameterKind::*;
    match optic {
        Optic::FovX => (
            FieldOfView,
            "degrees",
            "horizontal field of view of the film",
        ),
        Optic::ApertureRadius => (ApertureRadius, "world units", "radius of the lens"),
        Optic::FocusDistance => (FocusDistance, "world units", "depth that is sharp"),
    }
}

/// How much the sensor's own number changes for a unit of the parameter: users
/// have fields of view in degrees.
pub(super) fn optic_scale(optic: Optic) -> f64 {
    match optic {
        Optic::FovX => 1.0_f64.to_radians(),
        Optic::ApertureRadius | Optic::FocusDistance => 1.0,
    }
}

/// What a number of the sensor is now, in the parameter's unit.
pub(super) fn optic_value(scene: &Scene, optic: Optic) -> f64 {
    let number = scene.sensor.model.optic(optic);
    number.unwrap_or(0.0) / optic_scale(optic)
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
        let moves_discontinuities = match self.target? {
            Target::Texels(_, _, quantity, _) => quantity.moves_edges(),
            _ => true,
        };
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
            Target::Texels(id, part, quantity, channel) => {
                let texture = scene.texture(id);
                let which = match part.count {
                    1 => String::new(),
                    n => format!(", all {n} texels together"),
                };
                let what = format!("{} of {}{which}", quantity.name(), users(scene, id));
                let what = channel.of(&what, texture.channels);
                let values = match part.count {
                    1 => {
                        let first = part.first * texture.channels;
                        channel.values(&texture.data[first..first + texture.channels])
                    }
                    _ => Vec::new(),
                };
                (quantity.into(), values, quantity.unit(), what)
            }
            Target::TranslateSensor(axis) => {
                let what = format!("moves the sensor along world {}", AXES[axis]);
                (SensorTranslation, vec![0.0], "world units", what)
            }
            Target::RotateSensor(axis) => {
                let what = format!("turns the sensor about its origin, world {}", AXES[axis]);
                (SensorRotation, vec![0.0], "radians", what)
            }
            Target::SensorOptic(optic) => {
                let (kind, unit, what) = optic_text(optic);
                (kind, vec![optic_value(scene, optic)], unit, what.to_owned())
            }
        };
        Some(Parameter {
            name: self.name,
            kind,
            value,
            unit,
            moves_discontinuities,
            description,
            alias_of: self.alias_of,
        })
    }
}

impl From<Quantity> for ParameterKind {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::Radiance => Self::Radiance,
            Quantity::Intensity => Self::Intensity,
            Quantity::Irradiance => Self::Irradiance,
            Quantity::Factor | Quantity::SignedFactor => Self::Factor,
            Quantity::Reflectance => Self::Reflectance,
            Quantity::Attribute => Self::Attribute,
            Quantity::Transmittance => Self::Transmittance,
            Quantity::Roughness => Self::Roughness,
            Quantity::RefractiveIndex { .. } | Quantity::MetalIndex => Self::RefractiveIndex,
            Quantity::Extinction => Self::Extinction,
            Quantity::Fraction => Self::Fraction,
            Quantity::Angle => Self::Angle,
            Quantity::Normal => Self::Normal,
            Quantity::Height => Self::Height,
        }
    }
}

/// The shapes whose look a texture decides, and environments; or its own id if
/// there are none.
pub(super) fn users(scene: &Scene, id: TextureId) -> String {
    let shows = |bsdf: BsdfId| {
        let mut slots = scene.slots_below(bsdf).into_iter();
        slots.any(|slot| slot.texture == id)
    };
    let emits = |shape: &Shape| {
        let emitter = shape.emitter.map(|emitter| scene.emitter(emitter));
        emitter.is_some_and(|emitter| emitter.radiance() == id)
    };
    let has = |shape: &Shape| shape.attributes.iter().any(|a| a.texture == id);
    let uses = |shape: &&Arc<Shape>| shows(shape.bsdf) || emits(shape) || has(shape);
    let shapes = scene.shapes.iter().filter(uses);
    let elsewhere = scene.emitters.iter().filter(|emitter| {
        let is_area = matches!(emitter, Emitter::Area { .. });
        !is_area && emitter.slots().iter().any(|slot| slot.texture == id)
    });
    let elsewhere: Vec<String> = elsewhere.map(|emitter| emitter.name(scene)).collect();
    let names: Vec<&str> = shapes
        .map(|shape| &shape.id)
        .chain(&elsewhere)
        .map(String::as_str)
        .collect();
    match names.len() {
        0 => format!("{} (unused)", scene.texture(id).id),
        1..=3 => names.join(", "),
        n => format!("{} and {} more", names[..2].join(", "), n - 2),
    }
}
