//! The whole scene: flat lists that refer to each other by id.

use std::fmt;
use std::sync::Arc;

use capwalk_geometry::MeshError;

use crate::emitter::Emitter;
use crate::film::Film;
use crate::material::bsdf::{Material, Slot};
use crate::quantity::Quantity;
use crate::sensor::Sensor;
use crate::settings::Settings;
use crate::shape::Shape;
use crate::texture::{Pattern, Texture, TextureId};

/// Index into [`Scene::shapes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ShapeId(pub u32);
/// Index into [`Scene::materials`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BsdfId(pub u32);
/// Index into [`Scene::emitters`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EmitterId(pub u32);

/// A scene, in world coordinates.
///
/// Shapes and textures are shared: a clone costs no mesh, and a change copies only
/// what changes ([`Scene::shape_mut`], [`Scene::texture_mut`], [`Arc::make_mut`]).
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Shapes; their ids are unique.
    pub shapes: Vec<Arc<Shape>>,
    /// Materials that shapes refer to.
    pub materials: Vec<Material>,
    /// Light sources. At most one of them is an environment.
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

/// Why a scene cannot be rendered.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneError {
    /// A shape's mesh is unusable.
    Mesh {
        /// The shape.
        shape: String,
        /// What is wrong.
        error: MeshError,
    },
    /// A lamp has no area to emit from.
    ZeroAreaLamp {
        /// The shape.
        shape: String,
    },
    /// The picture has no pixels, or more than [`Film::MAX_PIXELS`].
    PictureSize {
        /// Width and height.
        size: [u32; 2],
    },
    /// Two shapes have the same id.
    DuplicateId {
        /// The id.
        id: String,
    },
    /// A number is infinite, NaN, or outside its range.
    BadNumber {
        /// Which number, for example `floor.bsdf.reflectance.value`.
        name: String,
        /// What it is.
        value: String,
        /// What it should be.
        expected: &'static str,
    },
    /// There is more than one environment emitter.
    SeveralEnvironments,
    /// A material contradicts itself.
    Material {
        /// The material.
        material: String,
        /// What is wrong, and what to do.
        problem: &'static str,
    },
    /// A texture needs texture coordinates that the shape does not have.
    NoTextureCoordinates {
        /// The shape.
        shape: String,
        /// The texture.
        texture: String,
    },
    /// A map of normals needs texture coordinates that the shape does not have.
    NoDirections {
        /// The shape.
        shape: String,
        /// The material with the map.
        material: String,
    },
    /// A texture asks for an attribute that the shape does not have.
    NoAttribute {
        /// The shape.
        shape: String,
        /// The texture.
        texture: String,
        /// The attribute.
        attribute: String,
        /// Those that the shape has.
        known: Vec<String>,
    },
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mesh { shape, error } => write!(f, "shape \"{shape}\": {error}"),
            Self::ZeroAreaLamp { shape } => write!(
                f,
                "the lamp \"{shape}\" has no area and cannot emit; give its mesh at least one \
                 triangle with area, or remove its emitter"
            ),
            Self::PictureSize { size: [w, h] } => write!(
                f,
                "the picture has {w} x {h} pixels; expected at least 1 x 1 and at most {} in all",
                Film::MAX_PIXELS
            ),
            Self::DuplicateId { id } => {
                write!(f, "two shapes have the id \"{id}\"; give each its own")
            }
            Self::BadNumber {
                name,
                value,
                expected,
            } => {
                write!(f, "{name} is {value}; expected {expected}")
            }
            Self::SeveralEnvironments => {
                write!(
                    f,
                    "there is more than one emitter around the scene (constant, envmap); keep one"
                )
            }
            Self::Material { material, problem } => {
                write!(
                    f,
                    "the material \"{material}\" cannot be rendered: {problem}"
                )
            }
            Self::NoTextureCoordinates { shape, texture } => write!(
                f,
                "the texture \"{texture}\" needs texture coordinates, but the mesh of \"{shape}\" \
                 has none; add them to all corners of the mesh, or give one colour"
            ),
            Self::NoDirections { shape, material } => write!(
                f,
                "the map of normals \"{material}\" needs texture coordinates to say in which \
                 directions they turn, but the mesh of \"{shape}\" has none; add them to all \
                 corners of the mesh, or use the material inside the map"
            ),
            Self::NoAttribute {
                shape,
                texture,
                attribute,
                known,
            } => {
                write!(
                    f,
                    "the texture \"{texture}\" asks for \"{attribute}\", but the mesh of \
                     \"{shape}\" "
                )?;
                match known[..] {
                    [] => write!(f, "has no attributes"),
                    _ => write!(f, "has only {}", known.join(", ")),
                }
            }
        }
    }
}

impl std::error::Error for SceneError {}

impl Scene {
    /// Checks everything that rendering relies on. Call it on every scene that
    /// did not come from [`Scene::moved`] of a checked one.
    pub fn check(&self) -> Result<(), SceneError> {
        self.film.check()?;
        self.sensor.check()?;
        let mut ids = std::collections::HashSet::new();
        for shape in &self.shapes {
            if !ids.insert(&shape.id) {
                return Err(SceneError::DuplicateId {
                    id: shape.id.clone(),
                });
            }
            shape.mesh.check().map_err(|error| SceneError::Mesh {
                shape: shape.id.clone(),
                error,
            })?;
            if shape.world_from_object.inverse().is_none() {
                return Err(SceneError::BadNumber {
                    name: format!("{}.to_world", shape.id),
                    value: format!("{:?}", shape.world_from_object),
                    expected: "a matrix of finite numbers that can be inverted",
                });
            }
            if shape.emitter.is_some() && shape.mesh.area() <= 0.0 {
                return Err(SceneError::ZeroAreaLamp {
                    shape: shape.id.clone(),
                });
            }
        }
        for texture in &self.textures {
            texture.check()?;
        }
        self.check_materials()?;
        self.check_slots()?;
        let environments = self.emitters.iter().filter(|e| e.is_environment());
        if environments.count() > 1 {
            return Err(SceneError::SeveralEnvironments);
        }
        Ok(())
    }

    /// Checks that numbers are in the range of what they mean, and that shapes
    /// have what their textures ask for.
    fn check_slots(&self) -> Result<(), SceneError> {
        for emitter in &self.emitters {
            for slot in emitter.slots() {
                self.check_range(slot.texture, slot.quantity)?;
            }
            if let Emitter::Spot {
                cutoff_angle,
                beam_width,
                ..
            } = emitter
            {
                let beam = self.texture(*beam_width);
                if beam.data[0] >= self.texture(*cutoff_angle).data[0] {
                    return Err(beam.bad_number(beam.parts()[0], 0, "less than the cutoff_angle"));
                }
            }
        }
        for slot in self.materials.iter().flat_map(|m| m.bsdf.slots()) {
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
        let texture = self.texture(id);
        for part in texture.parts() {
            for index in part.first..part.first + part.count {
                let value = texture.texel(index);
                if !value.to_array().iter().all(|&x| quantity.allows(x)) {
                    return Err(texture.bad_number(part, index, quantity.expected()));
                }
            }
        }
        Ok(())
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
}
