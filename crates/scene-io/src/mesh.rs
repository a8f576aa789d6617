//! Mesh files: OBJ, PLY, Mitsuba's `.serialized`, and glTF; and files of curves. [`read_mesh`] takes the
//! reader that a file's ending asks for; [`write_mesh`] writes PLY.

mod checked;
mod curves;
mod error;
mod gltf;
mod gltf_bytes;
mod gltf_file;
mod gltf_node;
mod named;
mod obj;
mod ply;
mod ply_attribute;
mod ply_header;
mod ply_writer;
mod serialized;

pub(crate) use checked::direction;
pub use checked::{FileAttribute, MeshFile};
pub use curves::read_curves;
pub use error::{MeshFault, MeshFileError, MeshPlace};
pub use gltf::read_gltf;
pub use gltf_bytes::OpenFile;
pub(crate) use gltf_file::{GltfFile, unsupported};
pub(crate) use gltf_node::shown_name;
pub use gltf_node::{GltfChoice, GltfName};
pub use named::{MeshChoice, NamedMeshError, read_mesh, write_mesh};
pub use obj::read_obj;
pub use ply::read_ply;
pub use ply_writer::write_ply;
pub use serialized::read_serialized;
