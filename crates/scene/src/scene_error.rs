//! What can be wrong with a scene.

use std::fmt;

use capwalk_geometry::MeshError;

/// Why a scene cannot be rendered.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// A shape's mesh is unusable.
    Mesh {
        /// The shape.
        shape: String,
        /// What is wrong.
        error: MeshError,
    },
    /// A shape that emits has no area.
    ZeroAreaEmitter {
        /// The shape.
        shape: String,
    },
    /// A shape is so much smaller than the scene that rays miss what is near it.
    TooSmall {
        /// The shape.
        shape: String,
        /// Its width, world units.
        size: f64,
        /// Up to which distance rays from surfaces meet nothing, world units.
        nearest: f64,
    },
    /// The image has no pixels, or too many.
    ImageSize {
        /// Width and height.
        size: [u32; 2],
        /// How many pixels there may be.
        most: u64,
    },
    /// Two shapes or sensors have the same id, or a shape is called `sensor`.
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
    /// A texture has too few numbers, or too many.
    TextureLength {
        /// The texture.
        texture: String,
        /// How many it has.
        numbers: usize,
        /// How many it should have: channels times texels.
        expected: usize,
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
            Self::ZeroAreaEmitter { shape } => write!(
                f,
                "the emitter \"{shape}\" has no area and cannot emit; give its mesh at least one \
                 triangle with area, or remove its emitter"
            ),
            Self::ImageSize { size: [w, h], most } => write!(
                f,
                "the image has {w} x {h} pixels; expected at least 1 x 1 and at most {most} in all"
            ),
            Self::TooSmall {
                shape,
                size,
                nearest,
            } => {
                // Three digits.
                let [size, nearest] = [size, nearest].map(|x| format!("{x:.2e}").parse::<f64>());
                let [size, nearest] = [size, nearest].map(|x| x.unwrap_or(f64::NAN));
                write!(
                    f,
                    "\"{shape}\" is only {size} wide, where rays from surfaces miss what is nearer than \
                     {nearest}, 1e-10 of the scene's largest coordinate: light would leak around it; \
                     make smaller what is so large, or bring shapes and camera nearer to the origin"
                )
            }
            Self::DuplicateId { id } => {
                write!(
                    f,
                    "two shapes or sensors have the id \"{id}\"; give each its own"
                )
            }
            Self::BadNumber {
                name,
                value,
                expected,
            } => {
                write!(f, "{name} is {value}; expected {expected}")
            }
            Self::TextureLength {
                texture,
                numbers,
                expected,
            } => write!(
                f,
                "the texture \"{texture}\" has {numbers} numbers; expected {expected}, its channels \
                 times its texels"
            ),
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
