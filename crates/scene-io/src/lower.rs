//! Nodes to a [`Scene`](capwalk_scene::Scene): what the plugins mean, one file
//! per family.

mod colour;
mod curve;
mod emitter;
mod film;
mod gltf_source;
mod gltf_texture;
mod instance;
mod integrator;
mod lowering;
mod material;
mod material_fields;
mod mesh_file;
mod metals;
mod placed_surface;
mod places;
mod polarization;
mod primitive_shape;
mod sampler;
mod scene;
mod sensor;
mod shape;
mod size;
mod spectrum_plugin;
mod sphere_division;
mod surface;
mod texture;

pub use material::bsdf_plugins;
pub(crate) use scene::lower;
