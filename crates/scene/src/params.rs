//! Which numbers of a scene can be differentiated, what they are called, and
//! the [`Tangent`](crate::Tangent) that each of them means. A [`Registry`] knows all
//! names of a scene:
//!
//! ```
//! use capwalk_scene::{builtin, params::Registry};
//! let scene = builtin::scene("ball").expect("built in");
//! let registry = Registry::new(&scene);
//! let tangent = registry.tangent(&scene, "ball.translate.x - 2*ball.scale")?;
//! assert!(tangent.textures.iter().all(Option::is_none));
//! # Ok::<(), capwalk_scene::params::ParameterError>(())
//! ```
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
//! Arrays, whose numbers each may change by themselves ([`Registry::arrays`]):
//!
//! | name | shape | numbers |
//! |---|---|---|
//! | `<shape>.positions` | (V, 3) | vertices, world units |
//! | `<shape>.normals` | (V, 3) | shading normals, where they are given with the mesh |
//! | `<emitter>.radiance.value`, `<material>.reflectance.value` (…) | (3,) or (1,) | the channels |
//! | `<material>.reflectance.data` (…) | (H, W, 3) or (H, W, 1) | texels of a bitmap, from the top |
//! | `<shape>.vertex_color` (…) | (V, 3) or (F, 3) | an attribute of a mesh, or one channel |
//! | `<shape>.to_world` | (4, 4) | the matrix that puts the shape in the world, see below |
//! | `<shape>.translate` | (3,) | motion in world axes, from where the shape is |
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
mod array_names;
mod element;
mod error;
mod expression;
mod matrix;
mod missing;
mod names;
mod near;
mod optic;
mod parameter;
mod registry;
mod request;
mod scalar;
mod target;
mod users;
mod velocity;

pub use array::{ArrayParameter, shape_text};
pub use error::ParameterError;
pub use parameter::{Parameter, ParameterKind};
pub use registry::Registry;
pub use request::Request;
pub use velocity::vertex_tangent;

#[cfg(test)]
mod tests;
