//! Mesh files: OBJ, PLY, Mitsuba's `.serialized`, and glTF.

mod gltf;
mod gltf_accessor;
mod gltf_buffer;
mod gltf_json;
mod gltf_node;
mod obj;
mod ply;
mod ply_attribute;
mod ply_header;
mod serialized;

pub use gltf::read_gltf;
pub use gltf_buffer::OpenFile;
pub use gltf_node::{GltfChoice, GltfName};
pub use obj::read_obj;
pub use ply::read_ply;
pub use serialized::read_serialized;

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

/// A mesh as its file gives it, in its own coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// What the file calls the mesh, if it does.
    pub name: Option<String>,
    /// Positions and triangles; checked.
    pub mesh: Mesh,
    /// Unit normals of the vertices, if the file has them and they were wanted.
    pub normals: Option<Vec<Vec3>>,
    /// Texture coordinates of the vertices, if the file has them for all.
    pub uvs: Option<Vec<[f64; 2]>>,
    /// Other numbers of vertices and triangles.
    pub attributes: Vec<FileAttribute>,
    /// What else is to be known about the file, each as the end of a sentence
    /// that begins with its name: "has 2 elements "edge", which are not read".
    pub warnings: Vec<String>,
}

/// Numbers of all vertices or of all triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct FileAttribute {
    /// Its name; it begins with `vertex_` or `face_`.
    pub name: String,
    /// 1 or 3.
    pub channels: usize,
    /// The numbers of one vertex or triangle after the other.
    pub data: Vec<f64>,
    /// True if the file has whole numbers.
    pub is_integer: bool,
}

/// Why a mesh file cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshFileError {
    /// Where in the file, for example `line 12`; empty for the file as a whole.
    pub place: String,
    /// What is wrong there.
    pub message: String,
    /// What was expected.
    pub help: String,
}

impl MeshFileError {
    fn new(place: impl Into<String>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            place: place.into(),
            message: message.into(),
            help: help.into(),
        }
    }
}

impl std::fmt::Display for MeshFileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if !self.place.is_empty() {
            write!(f, "{}: ", self.place)?;
        }
        write!(f, "{}; {}", self.message, self.help)
    }
}

impl std::error::Error for MeshFileError {}

/// The finished mesh, unless it is empty.
fn finish(file: MeshFile) -> Result<MeshFile, MeshFileError> {
    if file.mesh.faces.is_empty() {
        return Err(MeshFileError::new(
            "",
            "the file has no faces",
            "expected a mesh with at least one triangle",
        ));
    }
    Ok(file)
}

/// Cuts a polygon into triangles around its first corner, as Mitsuba does.
fn fan(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    let pairs = corners[1..].windows(2);
    pairs.map(|pair| [corners[0], pair[0], pair[1]])
}

/// Coordinates beyond this are no surface: what is computed from them, squares of
/// areas, must still be numbers.
pub(crate) const LARGEST_COORDINATE: f64 = 1e30;

/// A position, or what is wrong with it; `place` says where it stands.
fn finite_position(
    p: Vec3,
    vertex: usize,
    place: &dyn Fn() -> String,
) -> Result<Vec3, MeshFileError> {
    let largest = p.x.abs().max(p.y.abs()).max(p.z.abs());
    let help = match p.is_finite() {
        true if largest <= LARGEST_COORDINATE => return Ok(p),
        true => format!("expected coordinates up to {LARGEST_COORDINATE:e}"),
        false => "expected finite coordinates".to_owned(),
    };
    let message = format!(
        "vertex {vertex} has the position ({}, {}, {})",
        p.x, p.y, p.z
    );
    Err(MeshFileError::new(place(), message, help))
}

/// The unit vector in a direction, not finite if there is none. The square of the
/// vector's length may be too large or too small for a number; by powers of two
/// nothing is rounded.
pub(crate) fn direction(v: Vec3) -> Vec3 {
    let largest = v.x.abs().max(v.y.abs()).max(v.z.abs());
    (v * (-largest.log2().floor()).exp2()).normalized()
}

/// A normal of unit length, or what is wrong with it.
fn unit_normal(n: Vec3, vertex: usize, place: &dyn Fn() -> String) -> Result<Vec3, MeshFileError> {
    let unit = direction(n);
    match unit.is_finite() {
        true => Ok(unit),
        false => Err(MeshFileError::new(
            place(),
            format!("normal {vertex} is ({}, {}, {})", n.x, n.y, n.z),
            "expected a finite vector that is not zero; face_normals does without normals",
        )),
    }
}
