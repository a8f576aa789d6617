//! The scene description: shapes, materials, textures, emitters, the sensor and its film, and which
//! of their numbers are parameters. It answers local queries, such as evaluating and sampling a
//! BSDF, but does not trace rays.
//!
//! A [`Scene`] never changes while it is rendered. The crate opens no file and does not depend on
//! integrators.

pub mod builtin;
mod bytes;
pub mod emitter;
pub mod film;
pub mod filter;
pub mod ids;
pub mod image;
pub mod material;
pub mod memory;
pub mod params;
pub mod primitive;
pub mod quantity;
pub mod scene;
mod scene_error;
mod scene_vector;
pub mod sensor;
pub mod settings;
pub mod shape;
pub mod slot;
mod surface_point;
pub mod texture;

// What appears in the signatures here.
pub use capwalk_geometry::topology::weld;
pub use capwalk_geometry::{Mesh, MeshError, shown};

pub use bytes::{BytesError, fingerprint, pack, unpack};
pub use emitter::delta::DeltaLight;
pub use emitter::{Emitter, EmitterExtent, EmitterTraits};
pub use film::Film;
pub use filter::Filter;
pub use ids::{BsdfId, EmitterId, ShapeId, TextureId};
pub use image::Image;
pub use material::{
    Bsdf, Material, Resolved, Resolver, bsdf, fields, lobe, number, plain, resolve,
};
pub use quantity::Quantity;
pub use scene::Scene;
pub use scene_error::SceneError;
pub use scene_vector::{
    EmitterVectors, Gradient, SceneVector, SensorVectors, ShapeVectors, Tangent,
};
pub use sensor::{Optic, Sensor, SensorModel};
pub use settings::{Aov, Integrator, SamplerKind, Settings};
pub use shape::{
    Attribute, ShadingNormals, Shape, corner_normals, normal_sums, outside, vertex_normals,
};
pub use slot::Slot;
pub use surface_point::SurfacePoint;
pub use texture::{Pattern, Texture};
