//! What all readers of mesh files give back, and the checks they share.

use capwalk_geometry::Mesh;
use capwalk_geometry::mesh::{LARGEST_COORDINATE, is_within_reach};
use capwalk_math::Vec3;

use super::error::{MeshFileError, MeshPlace};

/// A mesh as its file gives it, in its own coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// The name that the file gives the mesh.
    pub name: Option<String>,
    /// Finite positions, and triangles whose indices are in range.
    pub mesh: Mesh,
    /// One unit vector per vertex, if the file has normals and they were wanted.
    pub normals: Option<Vec<Vec3>>,
    /// Texture coordinates `(u, v)` per vertex, if all vertices have them.
    pub uvs: Option<Vec<[f64; 2]>>,
    /// Further numbers per vertex and per triangle.
    pub attributes: Vec<FileAttribute>,
    /// Warnings about the file, each the end of a sentence that begins with its
    /// name: "has 2 elements "edge", which are not read".
    pub warnings: Vec<String>,
}

/// Numbers per vertex or per triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct FileAttribute {
    /// Begins with `vertex_` or `face_`, which says what the numbers belong to.
    pub name: String,
    /// How many numbers each vertex or triangle has: 1 or 3.
    pub channels: usize,
    /// Shape `(vertices or triangles, channels)`.
    pub data: Vec<f64>,
    /// True if the file stores integers.
    pub is_integer: bool,
}

/// The finished mesh; an error if it has no faces.
pub(super) fn finish(file: MeshFile) -> Result<MeshFile, MeshFileError> {
    if file.mesh.faces.is_empty() {
        return Err(MeshFileError::invalid(
            MeshPlace::File,
            "the file has no faces",
            "expected a mesh with at least one triangle",
        ));
    }
    Ok(file)
}

/// A polygon as triangles around its first corner, as in Mitsuba.
pub(super) fn fan(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    let pairs = corners[1..].windows(2);
    pairs.map(|pair| [corners[0], pair[0], pair[1]])
}

/// The position itself if it is finite and not too large. `place` says where
/// the vertex stands.
pub(super) fn finite_position(
    p: Vec3,
    vertex: usize,
    place: &dyn Fn() -> MeshPlace,
) -> Result<Vec3, MeshFileError> {
    let help = match p.is_finite() {
        true if is_within_reach(p) => return Ok(p),
        true => format!("expected coordinates up to {LARGEST_COORDINATE:e}"),
        false => "expected finite coordinates".to_owned(),
    };
    let message = format!(
        "vertex {vertex} has the position ({}, {}, {})",
        p.x, p.y, p.z
    );
    Err(MeshFileError::invalid(place(), message, help))
}

/// The unit vector along `v`; not finite if `v` is zero or not finite.
pub(crate) fn direction(v: Vec3) -> Vec3 {
    // The square of the length may overflow or underflow. A scale that is a
    // power of two prevents that without rounding.
    let largest = v.x.abs().max(v.y.abs()).max(v.z.abs());
    (v * (-largest.log2().floor()).exp2()).normalized()
}

/// The unit vector along a normal. `place` says where the normal stands.
pub(super) fn unit_normal(
    n: Vec3,
    vertex: usize,
    place: &dyn Fn() -> MeshPlace,
) -> Result<Vec3, MeshFileError> {
    let unit = direction(n);
    match unit.is_finite() {
        true => Ok(unit),
        false => Err(MeshFileError::invalid(
            place(),
            format!("normal {vertex} is ({}, {}, {})", n.x, n.y, n.z),
            "expected a finite vector that is not zero; face_normals does without normals",
        )),
    }
}
