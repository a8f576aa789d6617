//! Triangle meshes as flat arrays.

use capwalk_math::Vec3;
use serde::{Deserialize, Serialize};

use crate::shown;

/// Triangles that share vertices; no topology beyond the indices.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mesh {
    /// One position for each vertex, world units.
    pub positions: Vec<Vec3>,
    /// Corner indices of each triangle, counter-clockwise seen from outside.
    pub faces: Vec<[u32; 3]>,
}

/// The largest coordinate that a vertex, a light or a sensor has, world units: squares of areas
/// must still be finite.
pub const LARGEST_COORDINATE: f64 = 1e30;

/// True for a point whose coordinates are finite, and no larger than [`LARGEST_COORDINATE`].
pub fn is_within_reach(p: Vec3) -> bool {
    p.to_array().iter().all(|x| x.abs() <= LARGEST_COORDINATE)
}

/// What makes a mesh unusable.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeshError {
    /// There are no triangles.
    Empty,
    /// A vertex position is infinite, NaN, or too large.
    BadPosition {
        /// Index of the first such vertex.
        vertex: usize,
        /// Where it is, world units; not [within reach](is_within_reach).
        position: Vec3,
    },
    /// A face names a vertex that does not exist.
    IndexOutOfRange {
        /// Index of the first such face.
        face: usize,
        /// The vertex it names.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
}

impl std::fmt::Display for MeshError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Empty => write!(f, "the mesh has no triangles; expected at least one"),
            Self::BadPosition {
                vertex,
                position: p,
            } => write!(
                f,
                "vertex {vertex} has the position ({}, {}, {}); expected finite coordinates up to \
                 {LARGEST_COORDINATE:e}",
                shown(p.x),
                shown(p.y),
                shown(p.z)
            ),
            Self::IndexOutOfRange {
                face,
                index,
                vertices,
            } => write!(
                f,
                "face {face} refers to vertex {index}, but there are {vertices} vertices \
                 (counted from 0)"
            ),
        }
    }
}

impl std::error::Error for MeshError {}

impl Mesh {
    /// Checks that there is a triangle, that positions are finite, and that
    /// indices are in range. Everything below relies on it.
    pub fn check(&self) -> Result<(), MeshError> {
        if self.faces.is_empty() {
            return Err(MeshError::Empty);
        }
        if let Some(vertex) = self.positions.iter().position(|&p| !is_within_reach(p)) {
            let position = self.positions[vertex];
            return Err(MeshError::BadPosition { vertex, position });
        }
        let vertices = self.positions.len();
        for (face, corners) in self.faces.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices) {
                return Err(MeshError::IndexOutOfRange {
                    face,
                    index,
                    vertices,
                });
            }
        }
        Ok(())
    }

    /// Positions of a face's corners in world units, in the order of its indices.
    #[inline]
    pub fn corners(&self, face: usize) -> [Vec3; 3] {
        self.faces[face].map(|i| self.positions[i as usize])
    }

    /// Twice the area times the unit normal of a face; zero if degenerate.
    #[inline]
    pub fn face_cross(&self, face: usize) -> Vec3 {
        let [a, b, c] = self.corners(face);
        (b - a).cross(c - a)
    }

    /// Barycentric weights of a point in the plane of a face, in the order of its corners; of a
    /// point beside the plane, those of its foot. Not finite if the face is degenerate.
    #[inline]
    pub fn weights_on_face(&self, face: usize, p: Vec3) -> [f64; 3] {
        let [a, b, c] = self.corners(face);
        let cross = self.face_cross(face);
        let square = cross.length_squared();
        let wb = (p - a).cross(c - a).dot(cross) / square;
        let wc = (b - a).cross(p - a).dot(cross) / square;
        [1.0 - wb - wc, wb, wc]
    }

    /// Total area of the faces, square world units; one-sided.
    pub fn area(&self) -> f64 {
        (0..self.faces.len())
            .map(|face| 0.5 * self.face_cross(face).length())
            .sum()
    }

    /// Smallest and largest coordinates of the vertices, world units, used by a face or
    /// not; infinite and reversed without vertices.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let start = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        self.positions
            .iter()
            .fold(start, |(low, high), &p| (low.min(p), high.max(p)))
    }

    /// Appends another mesh's vertices and faces; its indices are shifted to match.
    pub fn append(&mut self, other: &Mesh) {
        let offset = self.positions.len() as u32;
        self.positions.extend_from_slice(&other.positions);
        self.faces
            .extend(other.faces.iter().map(|f| f.map(|i| i + offset)));
    }
}
