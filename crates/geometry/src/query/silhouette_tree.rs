//! Closest silhouettes, Algorithm 5.

use capwalk_math::Vec3;

use crate::edge::Edge;
use crate::mesh::Mesh;
use crate::oracle;

/// Which edges count as boundaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeSelection {
    /// Open edges, and edges with one face seen from the front and one from
    /// behind.
    Silhouettes,
    /// Every edge, creases too.
    All,
}

/// A plane; the side its normal points to is in front.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// A point on it.
    pub point: Vec3,
    /// Its normal, of any length.
    pub normal: Vec3,
}

/// A cone to search for boundaries.
#[derive(Clone, Copy, Debug)]
pub struct ConeQuery {
    /// Apex of the cone.
    pub eye: Vec3,
    /// Unit axis.
    pub axis: Vec3,
    /// Half-angle in radians: only points at smaller angles are found. At
    /// least π means no limit.
    pub max_angle: f64,
    /// Which edges count.
    pub edges: EdgeSelection,
    /// Only edges that share a bit with it count.
    pub groups: u8,
    /// Edges wholly behind this plane do not count (`domain = triangle`).
    pub in_front_of: Option<Plane>,
}

/// A point on a boundary edge, seen from the eye of the query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SilhouettePoint {
    /// The edge.
    pub edge: u32,
    /// Position along it: 0 at its first vertex, 1 at its second.
    pub t: f64,
    /// Unit direction from the eye.
    pub direction: Vec3,
    /// Distance from the eye, world units.
    pub distance: f64,
    /// Angle to the axis, radians.
    pub angle: f64,
}

/// A tree over the edges of a mesh, with cones of their faces' normals. It
/// keeps what it needs of the mesh.
#[derive(Clone, Debug)]
pub struct SilhouetteTree {
    mesh: Mesh,
    edges: Vec<Edge>,
}

impl SilhouetteTree {
    /// Builds the tree. `edges` may come from several meshes as long as they
    /// index `mesh`.
    pub fn build(mesh: &Mesh, edges: &[Edge]) -> Self {
        Self {
            mesh: mesh.clone(),
            edges: edges.to_vec(),
        }
    }

    /// Follows moved vertices; faces and edges must be those it was built with.
    pub fn refit(&mut self, mesh: &Mesh) {
        self.mesh = mesh.clone();
    }

    /// The boundary point under the smallest angle to the axis, Algorithm 5.
    pub fn closest(&self, query: &ConeQuery) -> Option<SilhouettePoint> {
        oracle::closest_silhouette(&self.mesh, &self.edges, query)
    }
}
