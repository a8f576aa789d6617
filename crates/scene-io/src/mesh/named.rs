//! Mesh files by their names, whose endings say which format they have.

use std::fmt;
use std::path::{Path, PathBuf};

use super::checked::MeshFile;
use super::error::MeshFileError;
use super::gltf::read_gltf;
use super::gltf_node::GltfChoice;
use super::obj::read_obj;
use super::ply::read_ply;
use super::ply_writer::write_ply;
use super::serialized::read_serialized;
use crate::atomic;
use crate::files::read_file;

/// Which mesh of a file is meant. By default there must be one in a glTF file, and it is the first of a `.serialized` one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshChoice {
    /// Of a glTF file.
    pub gltf: GltfChoice,
    /// Of a `.serialized` file, counted from 0.
    pub shape_index: Option<u32>,
}

/// Why the mesh in a file of some name cannot be read or written.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NamedMeshError {
    /// The name does not end in that of a format.
    UnknownEnding {
        /// The name that was given.
        path: PathBuf,
        /// The endings that would be accepted.
        known: &'static str,
    },
    /// A mesh was chosen of a file whose format has one.
    NothingToChoose {
        /// The file.
        path: PathBuf,
    },
    /// The file cannot be read or written.
    Access {
        /// "read" or "write".
        what: &'static str,
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        reason: String,
    },
    /// The contents of the file.
    Contents {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        error: MeshFileError,
    },
}

/// The mesh in a `.ply`, `.obj`, `.gltf`, `.glb` or `.serialized` file, in its own coordinates. Rows of
/// bitmaps begin at v = 0, in all formats.
pub fn read_mesh(path: &Path, choice: &MeshChoice) -> Result<MeshFile, NamedMeshError> {
    let read = |path: &Path| {
        read_file(path).map_err(|error| NamedMeshError::Access {
            what: "read",
            path: path.into(),
            reason: error.to_string(),
        })
    };
    let ending = ending(path);
    let (has_gltf, has_index) = match ending.as_str() {
        "gltf" | "glb" => (true, false),
        "serialized" => (false, true),
        "ply" | "obj" => (false, false),
        _ => {
            return Err(NamedMeshError::UnknownEnding {
                path: path.into(),
                known: ".ply, .obj, .gltf, .glb, .serialized",
            });
        }
    };
    let asks_gltf = choice.gltf != GltfChoice::default();
    if asks_gltf && !has_gltf || choice.shape_index.is_some() && !has_index {
        return Err(NamedMeshError::NothingToChoose { path: path.into() });
    }
    let bytes = read(path)?;
    let mesh = match ending.as_str() {
        "ply" => read_ply(&bytes, true),
        "obj" => read_obj(&bytes, true).map(|mut mesh| {
            // There v points up.
            for [_, v] in mesh.uvs.iter_mut().flatten() {
                *v = 1.0 - *v;
            }
            mesh
        }),
        "serialized" => read_serialized(&bytes, choice.shape_index.unwrap_or(0), true),
        _ => {
            let folder = path.parent().unwrap_or(Path::new(""));
            let open =
                |name: &str| read_file(&folder.join(name)).map_err(|error| error.to_string());
            read_gltf(&bytes, &choice.gltf, true, &open)
        }
    };
    mesh.map_err(|error| NamedMeshError::Contents {
        path: path.into(),
        error,
    })
}

/// Writes a mesh to a `.ply` file, whole or not at all.
pub fn write_mesh(path: &Path, mesh: &MeshFile) -> Result<(), NamedMeshError> {
    if ending(path) != "ply" {
        return Err(NamedMeshError::UnknownEnding {
            path: path.into(),
            known: ".ply",
        });
    }
    let written = atomic::write_one_of_many(path, |file| write_ply(mesh, file));
    written.map_err(|error| NamedMeshError::Access {
        what: "write",
        path: path.into(),
        reason: error.to_string(),
    })
}

fn ending(path: &Path) -> String {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    ending.to_ascii_lowercase()
}

impl fmt::Display for NamedMeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownEnding { path, known } => write!(
                f,
                "the name {} does not tell a format of meshes; known endings: {known}",
                path.display()
            ),
            Self::NothingToChoose { path } => write!(
                f,
                "{} has one mesh; node, mesh and primitive choose one of a .gltf or .glb file, \
                 shape_index one of a .serialized file",
                path.display()
            ),
            Self::Access { what, path, reason } => {
                write!(f, "cannot {what} {}: {reason}", path.display())
            }
            Self::Contents { path, error } => write!(f, "cannot read {}: {error}", path.display()),
        }
    }
}

impl std::error::Error for NamedMeshError {}
