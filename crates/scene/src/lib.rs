//! What the world is, and how it answers locally: shapes, materials, emitters,
//! the sensor and its film, and which numbers of it can be differentiated.
//!
//! A [`Scene`] never changes while it is rendered. Nothing here opens a file,
//! knows an integrator, or casts a ray.

pub mod builtin;
pub mod emitter;
pub mod film;
pub mod filter;
pub mod image;
pub mod material;
pub mod motion;
pub mod params;
pub mod primitive;
pub mod quantity;
pub mod scene;
pub mod sensor;
pub mod settings;
pub mod shape;
pub mod texture;

pub use emitter::Emitter;
pub use film::Film;
pub use filter::Filter;
pub use image::Image;
pub use material::{Bsdf, Material, Resolved, Resolver, bsdf, lobe, resolve};
pub use motion::{Motion, SensorMotion, ShapeMotion};
pub use quantity::Quantity;
pub use scene::{BsdfId, EmitterId, Scene, SceneError, ShapeId};
pub use sensor::{Optic, Sensor, SensorModel};
pub use settings::{Integrator, Layer, SamplerKind, Settings};
pub use shape::{Attribute, ShadingNormals, Shape, corner_normals, normal_sums, vertex_normals};
pub use texture::{Pattern, SurfacePoint, Texture, TextureId};
