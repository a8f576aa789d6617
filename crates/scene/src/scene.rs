//! The whole scene: flat lists that refer to each other by id.

use std::collections::HashSet;
use std::sync::Arc;

use capwalk_geometry::Apex;
use capwalk_geometry::mesh::is_within_reach;
use serde::{Deserialize, Serialize};

use crate::emitter::{Emitter, EnvironmentMap};
use crate::film::Film;
use crate::ids::{BsdfId, EmitterId, ShapeId, TextureId};
use crate::material::bsdf::Material;
use crate::quantity::Quantity;
use crate::scene_error::SceneError;
use crate::sensor::Sensor;
use crate::settings::Settings;
use crate::shape::Shape;
use crate::slot::Slot;
use crate::texture::{Pattern, Texture};
use capwalk_geometry::shown;

/// A scene, in world coordinates.
///
/// Shapes and textures are shared: a clone costs no mesh, and a change copies only
/// what changes ([`Scene::shape_mut`], [`Scene::texture_mut`], [`Arc::make_mut`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// Shapes; their ids are unique.
    pub shapes: Vec<Arc<Shape>>,
    /// Materials that shapes refer to.
    pub materials: Vec<Material>,
    /// Emitters. At most one of them is an environment.
    pub emitters: Vec<Emitter>,
    /// The numbers of materials and emitters.
    pub textures: Vec<Arc<Texture>>,
    /// The camera.
    pub sensor: Sensor,
    /// Its film.
    pub film: Film,
    /// How to render it.
    pub settings: Settings,
}

/// True if two lists share what is at a place.
fn share<T>(first: &[Arc<T>], second: &[Arc<T>], place: usize) -> bool {
    let pair = first.get(place).zip(second.get(place));
    pair.is_some_and(|(first, second)| Arc::ptr_eq(first, second))
}

/// The surface a ray starts on is found again at distances around 1e-16 of the coordinates; grazing
/// rays find it up to 1e6 times farther. Relative to the largest coordinate.
const SELF_INTERSECTION: f64 = 1e-10;
/// So many times as wide as the distance within which rays miss surfaces a shape must be: what is
/// missed around it is a hundredth of it then, at most.
const SMALLEST_SHAPE: f64 = 100.0;

impl Scene {
    /// The distance from a surface up to which rays that start there meet nothing, world units: 1e-10
    /// of the largest coordinate of the meshes and the camera.
    pub fn nearest_hit(&self) -> f64 {
        let positions = self.shapes.iter().flat_map(|shape| &shape.mesh.positions);
        let sizes = positions.map(|p| p.x.abs().max(p.y.abs()).max(p.z.abs()));
        SELF_INTERSECTION * sizes.fold(self.sensor.origin().length(), f64::max)
    }

    /// Checks that rays meet what is near each shape.
    fn check_sizes(&self) -> Result<(), SceneError> {
        let nearest = self.nearest_hit();
        for shape in &self.shapes {
            // A strip is as wide as its faces have area for their length.
            let (low, high) = shape.mesh.bounds();
            let size = shape.mesh.area() / (high - low).length();
            // Shapes without faces, or without area, are not there.
            if size > 0.0 && size < SMALLEST_SHAPE * nearest {
                return Err(SceneError::TooSmall {
                    shape: shape.id.clone(),
                    size,
                    nearest,
                });
            }
        }
        Ok(())
    }

    /// Checks everything that rendering relies on. Call it on every scene that
    /// did not come from [`Scene::moved`] of a checked one.
    pub fn check(&self) -> Result<(), SceneError> {
        self.check_after(None)
    }

    /// [`Self::check`]. If another scene has passed it, textures and meshes that both share are not
    /// looked at again.
    pub fn check_after(&self, checked: Option<&Scene>) -> Result<(), SceneError> {
        self.film.check()?;
        self.sensor.check()?;
        self.settings.check()?;
        // Parameters go by these names; `sensor` is always that which renders.
        let mut ids = HashSet::from(["sensor", self.sensor.id.as_str()]);
        for (index, shape) in self.shapes.iter().enumerate() {
            if !ids.insert(shape.id.as_str()) {
                return Err(SceneError::DuplicateId {
                    id: shape.id.clone(),
                });
            }
            if !checked.is_some_and(|checked| share(&checked.shapes, &self.shapes, index)) {
                shape.mesh.check().map_err(|error| SceneError::Mesh {
                    shape: shape.id.clone(),
                    error,
                })?;
            }
            if shape.world_from_object.inverse().is_none() {
                return Err(SceneError::BadNumber {
                    name: format!("{}.to_world", shape.id),
                    value: shape.world_from_object.to_string(),
                    expected: "a matrix of finite numbers that can be inverted",
                });
            }
            if shape.emitter.is_some() && shape.mesh.area() <= 0.0 {
                return Err(SceneError::ZeroAreaEmitter {
                    shape: shape.id.clone(),
                });
            }
        }
        for emitter in &self.emitters {
            if let Some(Apex::Point(p)) = emitter.apex()
                && !is_within_reach(p)
            {
                return Err(SceneError::BadNumber {
                    name: format!("{}.position", emitter.name(self)),
                    value: format!("({}, {}, {})", shown(p.x), shown(p.y), shown(p.z)),
                    expected: "finite coordinates up to 1e30",
                });
            }
        }
        for (index, texture) in self.textures.iter().enumerate() {
            if !checked.is_some_and(|checked| share(&checked.textures, &self.textures, index)) {
                texture.check()?;
            }
        }
        self.check_sizes()?;
        self.check_attributes()?;
        self.check_materials()?;
        self.check_slots(checked)?;
        let environments = self.emitters.iter().filter(|e| e.is_environment());
        if environments.count() > 1 {
            return Err(SceneError::SeveralEnvironments);
        }
        Ok(())
    }

    /// Checks that attributes have a texel for each vertex, or for each face.
    fn check_attributes(&self) -> Result<(), SceneError> {
        for shape in &self.shapes {
            for attribute in &shape.attributes {
                let texture = self.texture(attribute.texture);
                match texture.pattern {
                    Pattern::PerVertex => texture.check_length(shape.mesh.positions.len())?,
                    Pattern::PerFace => texture.check_length(shape.mesh.faces.len())?,
                    Pattern::Constant
                    | Pattern::Bitmap(_)
                    | Pattern::Checkerboard { .. }
                    | Pattern::MeshAttribute { .. }
                    | Pattern::Environment => {}
                }
            }
        }
        Ok(())
    }

    /// Checks that numbers are in the range of what they mean, and that shapes
    /// have what their textures ask for.
    fn check_slots(&self, checked: Option<&Scene>) -> Result<(), SceneError> {
        // Where materials and emitters are others, numbers may mean something else.
        let same = checked.filter(|checked| {
            checked.materials == self.materials && checked.emitters == self.emitters
        });
        let is_good = |id: TextureId| {
            same.is_some_and(|same| share(&same.textures, &self.textures, id.0 as usize))
        };
        for emitter in &self.emitters {
            for slot in emitter
                .slots()
                .into_iter()
                .filter(|slot| !is_good(slot.texture))
            {
                self.check_range(slot.texture, slot.quantity)?;
            }
            if let Some((slot, image)) = emitter.projected_image() {
                self.check_projected_image(&format!("{}.{slot}", emitter.name(self)), image)?;
            }
            if let Emitter::Spot {
                cutoff_angle,
                beam_width,
                texture,
                ..
            } = emitter
            {
                let [beam, cutoff] = [*beam_width, *cutoff_angle].map(|id| self.texture(id));
                if beam.data[0] >= cutoff.data[0] {
                    return Err(beam.bad_number(beam.parts()[0], 0, "less than the cutoff_angle"));
                }
                if texture.is_some() && cutoff.data[0] >= 90.0 {
                    let expected = "less than 90 degrees, because the light throws an image";
                    return Err(cutoff.bad_number(cutoff.parts()[0], 0, expected));
                }
            }
        }
        let slots = self.materials.iter().flat_map(|m| m.bsdf.slots());
        for slot in slots.filter(|slot| !is_good(slot.texture)) {
            self.check_range(slot.texture, slot.quantity)?;
        }
        for shape in &self.shapes {
            let mut slots = self.slots_below(shape.bsdf);
            slots.extend(shape.emitter.map(|emitter| Slot {
                name: "radiance",
                texture: self.emitter(emitter).radiance(),
                quantity: Quantity::Radiance,
            }));
            for slot in slots {
                self.check_slot_on_shape(&slot, shape)?;
            }
            if let Some(map) = self.map_in(shape.bsdf).filter(|_| shape.uvs.is_none()) {
                return Err(SceneError::NoDirections {
                    shape: shape.id.clone(),
                    material: self.material(map).id.clone(),
                });
            }
        }
        Ok(())
    }

    /// Checks that a texture depends on texture coordinates at most.
    fn check_projected_image(&self, name: &str, image: TextureId) -> Result<(), SceneError> {
        let texture = self.texture(image);
        if texture.is_constant() || texture.needs_uv() {
            return Ok(());
        }
        Err(SceneError::BadNumber {
            name: name.into(),
            value: format!("\"{}\", which covers surfaces only", texture.id),
            expected: "a colour, a bitmap or a checkerboard",
        })
    }

    fn check_slot_on_shape(&self, slot: &Slot, shape: &Shape) -> Result<(), SceneError> {
        let texture = self.texture(slot.texture);
        if texture.needs_uv() && shape.uvs.is_none() {
            return Err(SceneError::NoTextureCoordinates {
                shape: shape.id.clone(),
                texture: texture.id.clone(),
            });
        }
        let Pattern::MeshAttribute { name, .. } = &texture.pattern else {
            return Ok(());
        };
        let Some(attribute) = shape.attribute(name) else {
            let known = shape.attributes.iter().map(|a| a.name.clone());
            return Err(SceneError::NoAttribute {
                shape: shape.id.clone(),
                texture: texture.id.clone(),
                attribute: name.clone(),
                known: known.collect(),
            });
        };
        self.check_range(attribute, slot.quantity)
    }

    fn check_range(&self, id: TextureId, quantity: Quantity) -> Result<(), SceneError> {
        (self.texture(id)).check_numbers(|x| quantity.allows(x), quantity.expected())
    }

    /// A material and all that it is made of.
    pub fn materials_below(&self, id: BsdfId) -> Vec<BsdfId> {
        let mut found = vec![id];
        for part in self.material(id).bsdf.parts() {
            found.extend(self.materials_below(part));
        }
        found
    }

    /// A map of normals or heights in a material, if there is one.
    pub fn map_in(&self, id: BsdfId) -> Option<BsdfId> {
        let is_map = |id: &BsdfId| self.material(*id).bsdf.normal_limits().is_some();
        self.materials_below(id).into_iter().find(is_map)
    }

    /// The textures in a material and in all that it is made of.
    pub fn slots_below(&self, id: BsdfId) -> Vec<Slot> {
        let materials = self.materials_below(id).into_iter();
        materials
            .flat_map(|id| self.material(id).bsdf.slots())
            .collect()
    }

    /// The shape with this id.
    pub fn shape(&self, id: ShapeId) -> &Shape {
        &self.shapes[id.0 as usize]
    }

    /// The shape with this id, to be changed; copied first if another scene has it, too.
    pub fn shape_mut(&mut self, id: ShapeId) -> &mut Shape {
        Arc::make_mut(&mut self.shapes[id.0 as usize])
    }

    /// All shapes, to be changed; each that another scene has, too, is copied first.
    pub fn shapes_mut(&mut self) -> impl Iterator<Item = &mut Shape> {
        self.shapes.iter_mut().map(Arc::make_mut)
    }

    /// Adds a shape, behind all others.
    pub fn add_shape(&mut self, shape: Shape) -> ShapeId {
        self.shapes.push(Arc::new(shape));
        ShapeId(self.shapes.len() as u32 - 1)
    }

    /// The material with this id.
    pub fn material(&self, id: BsdfId) -> &Material {
        &self.materials[id.0 as usize]
    }

    /// The emitter with this id.
    pub fn emitter(&self, id: EmitterId) -> &Emitter {
        &self.emitters[id.0 as usize]
    }

    /// The environment emitter, if there is one.
    pub fn environment(&self) -> Option<EmitterId> {
        let index = self.emitters.iter().position(Emitter::is_environment)?;
        Some(EmitterId(index as u32))
    }

    /// The texture with this id.
    #[inline]
    pub fn texture(&self, id: TextureId) -> &Texture {
        &self.textures[id.0 as usize]
    }

    /// The texture with this id, to be changed; copied first if another scene has it, too.
    pub fn texture_mut(&mut self, id: TextureId) -> &mut Texture {
        Arc::make_mut(&mut self.textures[id.0 as usize])
    }

    /// Adds a texture, behind all others.
    pub fn add_texture(&mut self, texture: Texture) -> TextureId {
        self.textures.push(Arc::new(texture));
        TextureId(self.textures.len() as u32 - 1)
    }

    /// The environment map that has these texels.
    pub fn environment_map_of(&self, texels: TextureId) -> Option<&EnvironmentMap> {
        self.emitters.iter().find_map(|emitter| match emitter {
            Emitter::EnvironmentMap { map, data, .. } if *data == texels => Some(map),
            _ => None,
        })
    }
}

impl Emitter {
    /// What users call it: `<shape>.emitter`, or its own id.
    pub fn name(&self, scene: &Scene) -> String {
        match self {
            Self::Area { shape, .. } => format!("{}.emitter", scene.shape(*shape).id),
            Self::Constant { id, .. }
            | Self::EnvironmentMap { id, .. }
            | Self::Point { id, .. }
            | Self::Spot { id, .. }
            | Self::Projector { id, .. }
            | Self::Directional { id, .. } => id.clone(),
        }
    }
}
