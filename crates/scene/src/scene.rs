//! The whole scene: flat lists that refer to each other by id.

use std::fmt;

use capwalk_geometry::MeshError;

use crate::bsdf::Material;
use crate::emitter::Emitter;
use crate::film::Film;
use crate::sensor::Perspective;
use crate::settings::Settings;
use crate::shape::Shape;
use crate::texture::Texture;

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
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Shapes; their ids are unique.
    pub shapes: Vec<Shape>,
    /// Materials that shapes refer to.
    pub materials: Vec<Material>,
    /// Light sources. At most one of them is an environment.
    pub emitters: Vec<Emitter>,
    /// The numbers of materials and emitters.
    pub textures: Vec<Texture>,
    /// The camera.
    pub sensor: Perspective,
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
                write!(f, "there is more than one constant emitter; keep one")
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
            if shape.emitter.is_some() && shape.mesh.area() <= 0.0 {
                return Err(SceneError::ZeroAreaLamp {
                    shape: shape.id.clone(),
                });
            }
        }
        for texture in &self.textures {
            texture.check()?;
        }
        let environments = self.emitters.iter().filter(|e| e.is_environment());
        if environments.count() > 1 {
            return Err(SceneError::SeveralEnvironments);
        }
        Ok(())
    }

    /// The shape with this id.
    pub fn shape(&self, id: ShapeId) -> &Shape {
        &self.shapes[id.0 as usize]
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
