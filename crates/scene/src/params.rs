//! Which numbers of a scene can be differentiated, what they are called, and
//! the [`Motion`] that each of them means.
//!
//! | name | unit change |
//! |---|---|
//! | `<shape>.translate.x` (`.y`, `.z`) | one world unit along the axis |
//! | `<shape>.rotate.x` (`.y`, `.z`) | one radian about the world axis through the shape's centre |
//! | `<shape>.scale` | size times two (`d/ds` at `s = 1`), about the shape's centre |
//! | `<shape>.emitter.radiance.value` (`.r`, `.g`, `.b`) | radiance by one, in all channels or in one |
//! | `<emitter>.radiance.value` (…) | the same for the constant emitter |
//! | `<spot>.cutoff_angle`, `<spot>.beam_width` | an angle of a spot light by one degree |
//! | `<material>.reflectance.value` (…) | reflectance by one |
//! | `<shape>.bsdf.reflectance.value` (…) | the same, of the shape's material |
//! | `<material>.reflectance.data` (…) | all texels of a bitmap by one |
//! | `<material>.reflectance.color0.value` (…), `color1` | a colour of a checkerboard by one |
//! | `<shape>.vertex_color` (…) | an attribute of a mesh by one, at all vertices or faces |
//! | `sensor.translate.x` (…), `sensor.rotate.x` (…) | as for shapes, about the sensor's origin |
//! | `sensor.x_fov` | horizontal field of view by one degree, if the sensor has one |
//! | `sensor.aperture_radius`, `sensor.focus_distance` | one world unit, if the sensor has a lens |
//!
//! A texture with an id is called by it: `<texture>.value`, `<texture>.data`.
//!
//! Arrays, whose numbers each may change by themselves ([`arrays`]):
//!
//! | name | shape | numbers |
//! |---|---|---|
//! | `<shape>.positions` | (V, 3) | vertices, world units |
//! | `<shape>.normals` | (V, 3) | shading normals, where they are given with the mesh |
//! | `<emitter>.radiance.value`, `<material>.reflectance.value` (…) | (3,) or (1,) | the channels |
//! | `<material>.reflectance.data` (…) | (H, W, 3) or (H, W, 1) | texels of a bitmap, from the top |
//! | `<shape>.vertex_color` (…) | (V, 3) or (F, 3) | an attribute of a mesh, or one channel |
//! | `<shape>.to_world` | (4, 4) | the matrix that puts the shape in the world, see below |
//! | `sensor.translate`, `sensor.rotate` | (3,) | motion and turn in world axes |
//! | `sensor.to_world` | (4, 4) | the matrix that puts the sensor in the world |
//! | `sensor.x_fov`, `sensor.aperture_radius`, `sensor.focus_distance` | (1,) | as above |
//!
//! Matrices are those of Mitsuba: each entry changes by itself, whatever comes of
//! it, a scale or a shear too, and the last row, `0 0 0 1`, stays. The vertices of
//! a shape go with it from the coordinates that its file gives them; a sphere's
//! matrix makes it of the unit sphere, and exported scenes and those made by code
//! have identities. Who moves a camera along its gradient and wants a rotation has
//! to make one of the new matrix: files give cameras with a field of view nothing
//! else.
//!
//! One number of an array, or all in a row together, by their indices from 0:
//! `<shape>.positions[12,0]`, `<material>.reflectance.data[3,1]`. Vertices at the
//! same place move with the one that is named.
//!
//! The sensor answers to its own id too. The centre is that of the bounding
//! box. Names joined by `+` or `-` move together, each with an optional
//! factor: `ball.translate.x + 0.5*lamp.translate.y - sensor.rotate.z`. Names
//! are matched whole and the longest wins, so ids may contain any of `.+-*`.

mod array;
mod element;
mod error;
mod expression;
mod matrix;
mod missing;
mod registry;
mod velocity;

pub use array::{ArrayParameter, arrays};
pub use error::ParameterError;
pub use velocity::vertex_motion;

use crate::motion::Motion;
use crate::scene::Scene;
use expression::Named;

/// A number of the scene, or three that change together.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// What it is called in expressions.
    pub name: String,
    /// What sort of change it is.
    pub kind: ParameterKind,
    /// What it is now: 0 for translations and rotations, 1 for scales, a
    /// colour (three numbers) or one channel of it. Empty for the texels of a
    /// bitmap and for attributes of meshes.
    pub value: Vec<f64>,
    /// Unit of the value, and of the derivative's denominator.
    pub unit: &'static str,
    /// True if edges move, seen from somewhere: the derivative then has a
    /// boundary part.
    pub moves_discontinuities: bool,
    /// What changes, in a few words.
    pub description: String,
    /// The name under which the same parameter is listed first, if this is
    /// only another name for it.
    pub alias_of: Option<String>,
}

/// Sorts of parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterKind {
    /// Position of a shape along a world axis.
    Translation,
    /// Angle of a shape about a world axis through its centre.
    Rotation,
    /// Size of a shape relative to what it is.
    Scale,
    /// What an emitter emits.
    Radiance,
    /// What a light without extent emits, per solid angle.
    Intensity,
    /// What parallel light brings, per area.
    Irradiance,
    /// A factor.
    Factor,
    /// How much a material reflects.
    Reflectance,
    /// Vertices of a shape.
    Positions,
    /// Shading normals given with a shape.
    Normals,
    /// Something that comes with a mesh, per vertex or per face.
    Attribute,
    /// How much a material transmits.
    Transmittance,
    /// How rough a surface is.
    Roughness,
    /// A refractive index, or the real part of one.
    RefractiveIndex,
    /// The imaginary part of a refractive index.
    Extinction,
    /// A number from 0 to 1: opacity, weight, metallic ...
    Fraction,
    /// An angle of a light.
    Angle,
    /// Normals from a texture.
    Normal,
    /// Heights from a texture.
    Height,
    /// Position of the sensor along a world axis.
    SensorTranslation,
    /// Angle of the sensor about a world axis through its origin.
    SensorRotation,
    /// The matrix that puts a shape in the world.
    ToWorld,
    /// The matrix that puts the sensor in the world.
    SensorToWorld,
    /// Horizontal field of view of the sensor.
    FieldOfView,
    /// Radius of the sensor's lens.
    ApertureRadius,
    /// Depth at which the sensor is sharp.
    FocusDistance,
}

/// Every parameter of the scene, shape by shape, then emitters, materials and
/// the sensor; other names directly behind the one they stand for.
pub fn list(scene: &Scene) -> Vec<Parameter> {
    registry::entries(scene)
        .into_iter()
        .filter_map(|entry| entry.describe(scene))
        .collect()
}

/// The motion that an expression means: a parameter's name, or several with
/// factors. See the module's table.
pub fn motion(scene: &Scene, expression: &str) -> Result<Motion, ParameterError> {
    let entries = registry::entries(scene);
    let mut motion = Motion::zero(scene);
    let terms = expression::parse(scene, &entries, expression).map_err(|error| match error {
        ParameterError::Unknown { name, .. } => unknown(scene, name),
        error => error,
    })?;
    for term in terms {
        match term.named {
            Named::Target(target) => {
                velocity::accumulate(scene, target, term.factor, &mut motion);
            }
            Named::Element(element) => {
                motion.add(&element.motion(scene).scaled(term.factor));
            }
        }
    }
    Ok(motion)
}

/// What a gradient can be asked for by one text.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// An array, by its name.
    Array(ArrayParameter),
    /// One number, by an expression.
    Motion(Motion),
}

/// What a text asks for. A name that is both means the array: `<id>.value` is
/// three numbers, `1*<id>.value` all of them together.
pub fn request(scene: &Scene, text: &str) -> Result<Request, ParameterError> {
    if let Some(array) = array::find(scene, text.trim())? {
        return Ok(Request::Array(array));
    }
    motion(scene, text).map(Request::Motion)
}

/// What is wrong with a name that is no scalar's.
fn unknown(scene: &Scene, name: String) -> ParameterError {
    let mut names: Vec<String> = arrays(scene).into_iter().map(|a| a.name).collect();
    if names.contains(&name) {
        return ParameterError::Array { name };
    }
    if let Some(reason) = missing::reason(scene, &name) {
        return ParameterError::NoParameter { name, reason };
    }
    let scalars = list(scene).into_iter().map(|parameter| parameter.name);
    let scalars: Vec<String> = scalars.filter(|name| !names.contains(name)).collect();
    names.extend(scalars);
    let near = error::near(&name, names.iter().map(String::as_str));
    ParameterError::Unknown { name, near }
}

#[cfg(test)]
mod tests;
