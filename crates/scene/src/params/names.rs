//! The names of all scalar parameters, and what each of them refers to.

use std::collections::HashSet;
use std::iter;
use std::sync::Arc;

use super::target::{AXES, Channel, Target};
use crate::emitter::Emitter;
use crate::ids::{BsdfId, EmitterId, ShapeId, TextureId};
use crate::quantity::Quantity;
use crate::scene::Scene;
use crate::sensor::Optic;

/// All names, shape by shape, then emitters, materials and the sensor; other names
/// directly behind the one they stand for. A name appears twice only if the scene
/// uses one id for two things.
#[derive(Clone, Debug)]
pub(super) struct Names(Vec<Entry>);

/// A name and what it refers to.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub name: Arc<str>,
    /// `None` for the reflectance of a material whose two sides differ: that
    /// is not one number.
    pub target: Option<Target>,
    /// Where the entry is that is listed first for the same target, if this has only
    /// another name.
    first: Option<u32>,
}

impl Names {
    /// The names in a scene, in time linear in its size and in their number.
    pub fn new(scene: &Scene) -> Self {
        let mut names = Self(Vec::new());
        let of_materials = material_names(scene);
        let of_textures = texture_names(scene, &of_materials);
        let texture = |names: &mut Self, id: TextureId, quantity| {
            names.add_texture(scene, id, &of_textures[id.0 as usize], quantity);
        };
        for (i, shape) in scene.shapes.iter().enumerate() {
            names.add_shape(ShapeId(i as u32), &shape.id);
            for attribute in &shape.attributes {
                texture(&mut names, attribute.texture, Quantity::Attribute);
            }
        }
        for (i, emitter) in scene.emitters.iter().enumerate() {
            names.add_light(scene, EmitterId(i as u32), emitter);
        }
        let mut listed = HashSet::new();
        for slot in scene.emitters.iter().flat_map(|emitter| emitter.slots()) {
            if listed.insert(slot.texture) {
                texture(&mut names, slot.texture, slot.quantity);
            }
        }
        for (i, material) in scene.materials.iter().enumerate() {
            for slot in material.bsdf.slots() {
                if listed.insert(slot.texture) {
                    texture(&mut names, slot.texture, slot.quantity);
                }
            }
            names.add_contradiction(scene, BsdfId(i as u32), &of_materials[i]);
        }
        names.add_sensor(scene);
        names
    }

    /// The entries, in order.
    pub fn iter(&self) -> impl Iterator<Item = &Entry> {
        self.0.iter()
    }

    /// The entry at a place in the order.
    pub fn get(&self, place: u32) -> &Entry {
        &self.0[place as usize]
    }

    /// The name that is listed first for what an entry refers to, if that is another one.
    pub fn alias_of(&self, entry: &Entry) -> Option<&str> {
        entry.first.map(|first| &*self.0[first as usize].name)
    }

    /// Adds a name, and says where.
    fn add(&mut self, name: String, target: Option<Target>, first: Option<u32>) -> u32 {
        self.0.push(Entry {
            name: name.into(),
            target,
            first,
        });
        self.0.len() as u32 - 1
    }

    fn add_shape(&mut self, id: ShapeId, name: &str) {
        for (axis, letter) in AXES.iter().enumerate() {
            let target = Target::Translate(id, axis);
            self.add(format!("{name}.translate.{letter}"), Some(target), None);
        }
        for (axis, letter) in AXES.iter().enumerate() {
            let target = Target::Rotate(id, axis);
            self.add(format!("{name}.rotate.{letter}"), Some(target), None);
        }
        self.add(format!("{name}.scale"), Some(Target::Scale(id)), None);
    }

    /// Adds how a light without extent moves and turns; what has no place, or is the same
    /// from all sides, does not.
    fn add_light(&mut self, scene: &Scene, id: EmitterId, emitter: &Emitter) {
        let name = emitter.name(scene);
        let points = emitter.anchors().len();
        let is_point = |i: usize| emitter.anchor_is_point(i);
        if (0..points).any(is_point) {
            for (axis, letter) in AXES.iter().enumerate() {
                let target = Target::TranslateLight(id, axis);
                self.add(format!("{name}.translate.{letter}"), Some(target), None);
            }
        }
        if !(0..points).all(is_point) {
            for (axis, letter) in AXES.iter().enumerate() {
                let target = Target::RotateLight(id, axis);
                self.add(format!("{name}.rotate.{letter}"), Some(target), None);
            }
        }
    }

    /// Adds the numbers of a texture under all of its names.
    fn add_texture(&mut self, scene: &Scene, id: TextureId, names: &[String], quantity: Quantity) {
        let texture = scene.texture(id);
        for part in texture.parts() {
            for &channel in Channel::of_texture(texture.channels) {
                let suffix = channel.suffix();
                let target = Some(Target::Texels(id, part, quantity, channel));
                let mut first = None;
                for name in names {
                    let full = match part.name {
                        "" => format!("{name}{suffix}"),
                        part => format!("{name}.{part}{suffix}"),
                    };
                    // A single number is called by the name of its slot, too.
                    let short = texture.channels == 1 && part.name == "value";
                    for name in iter::once(full).chain(short.then(|| name.clone())) {
                        let added = self.add(name, target, first);
                        first.get_or_insert(added);
                    }
                }
            }
        }
    }

    /// The names that a material made of several would have if they were one. They
    /// refer to nothing, but the message can say why.
    fn add_contradiction(&mut self, scene: &Scene, id: BsdfId, names: &[String]) {
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
        for name in names {
            for slot in &slots {
                for channel in Channel::EACH {
                    let name = format!("{name}.{slot}.value{}", channel.suffix());
                    self.add(name, None, None);
                }
            }
        }
    }

    fn add_sensor(&mut self, scene: &Scene) {
        let own = &scene.sensor.id;
        let mut add = |number: String, target| {
            let first = self.add(format!("sensor.{number}"), Some(target), None);
            if own != "sensor" {
                self.add(format!("{own}.{number}"), Some(target), Some(first));
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
}

/// What each material is called: its own name, then those of materials that show
/// it on all sides they show, then those by the shapes that have any of them.
fn material_names(scene: &Scene) -> Vec<Vec<String>> {
    let shown = |id: BsdfId| {
        let part = |id: &BsdfId| scene.material(*id).bsdf.shown_part();
        iter::successors(Some(id), part)
    };
    let own = scene.materials.iter().map(|material| &material.id);
    let mut names: Vec<Vec<String>> = own.map(|id| vec![id.clone()]).collect();
    for (i, material) in scene.materials.iter().enumerate() {
        for part in shown(BsdfId(i as u32)).skip(1) {
            names[part.0 as usize].push(material.id.clone());
        }
    }
    for shape in &scene.shapes {
        for part in shown(shape.bsdf) {
            names[part.0 as usize].push(format!("{}.bsdf", shape.id));
        }
    }
    names
}

/// What each texture is called: its own name, then those by the emitters and the
/// materials that it stands in.
fn texture_names(scene: &Scene, of_materials: &[Vec<String>]) -> Vec<Vec<String>> {
    let own = scene.textures.iter().map(|texture| &texture.id);
    let mut names: Vec<Vec<String>> = own.map(|id| vec![id.clone()]).collect();
    for emitter in &scene.emitters {
        for slot in emitter.slots() {
            names[slot.texture.0 as usize].push(match slot.name {
                "" => emitter.name(scene),
                slot => format!("{}.{slot}", emitter.name(scene)),
            });
        }
    }
    for (material, of_material) in scene.materials.iter().zip(of_materials) {
        for slot in material.bsdf.slots() {
            let of_slot = of_material
                .iter()
                .map(|name| format!("{name}.{}", slot.name));
            names[slot.texture.0 as usize].extend(of_slot);
        }
    }
    for names in &mut names {
        // `floor.bsdf` is often both the material's id and the shape's path.
        let mut seen = HashSet::new();
        names.retain(|name| seen.insert(name.clone()));
    }
    names
}
