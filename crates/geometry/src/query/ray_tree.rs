//! Rays against triangles.
//!
//! Boxes are tested in single precision and in the tree's own coordinates, with
//! margins for all rounding; triangles in double precision and in the world's
//! (Woop, Benthin and Wald 2013), exactly as brute force does it.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use capwalk_math::Vec3;
use rayon::prelude::*;

use super::bundle::{BUNDLE, Bundle};
use super::bundle_search::{FirstHits, OccludedRays};
use super::fine_tree::{fine_tree, has_unresolved};
use super::pieces::Pieces;
use super::ray_kernel::{RayNode, TriangleBlock};
use super::ray_search::{FirstHit, Occluded};
use super::sphere::MeshSphere;
use super::triangle_tree::{Part, SpherePart, TriangleTree};
use crate::bvh::{Child, ChildKind, Hierarchy, SurfaceCost, child_bounds};
use crate::effort::{RAY, add_effort_of};
use crate::halt::{Halt, Halted};
use crate::mesh::Mesh;
use crate::ray::{Hit, Ray};
use crate::simd::Instructions;

/// A tree over the triangles of a mesh. It keeps what it needs of the mesh.
///
/// Answers are bitwise those of [`oracle::first_hit`](crate::oracle::first_hit),
/// on every CPU: bounds only decide what need not be tested. (Where a ray runs in the plane of a face,
/// rounding decides how far along the face it is hit; the tree may leave such a hit out if the ray
/// begins or ends on the same face.)
#[derive(Clone, Debug)]
pub struct RayTree {
    face_count: usize,
    /// Over the pieces of the mesh.
    pub(super) hierarchy: Hierarchy,
    pub(super) spheres: Vec<Arc<MeshSphere>>,
    /// All of it, with no parts but the spheres.
    pub(super) flat: TriangleTree,
    /// The tree that is searched in its place, if single precision does not tell the triangles of
    /// some small part from each other.
    fine: Option<Box<TriangleTree>>,
    /// The tree in which spheres are triangles, if it was asked for.
    triangles: OnceLock<Box<Self>>,
    cost: SurfaceCost,
    instructions: Instructions,
}

impl RayTree {
    /// Builds the tree. The mesh must have passed [`Mesh::check`] or be empty.
    pub fn build(mesh: &Mesh) -> Self {
        Self::try_build(mesh, &Halt::never()).expect("nobody gives it up")
    }

    /// [`Self::build`], unless the work is given up.
    pub fn try_build(mesh: &Mesh, halt: &Halt) -> Result<Self, Halted> {
        Self::with_spheres(mesh, MeshSphere::all(mesh, &[]), halt)
    }

    /// The tree of a mesh in which these are spheres.
    fn with_spheres(
        mesh: &Mesh,
        spheres: Vec<Arc<MeshSphere>>,
        halt: &Halt,
    ) -> Result<Self, Halted> {
        let pieces = Pieces {
            mesh,
            spheres: &spheres,
        };
        let all = pieces.all();
        let frame = pieces.frame(&all);
        let hierarchy = halt.unless_halted(pieces.hierarchy(all, &frame, halt))?;
        let mut tree = Self {
            face_count: mesh.faces.len(),
            hierarchy,
            spheres,
            flat: TriangleTree {
                frame,
                nodes: Vec::new(),
                leaves: Vec::new(),
                parts: Vec::new(),
                has_no_trees: true,
            },
            fine: None,
            triangles: OnceLock::new(),
            cost: SurfaceCost::default(),
            instructions: Instructions::detect(),
        };
        tree.follow(mesh, halt);
        tree.cost.now_is_new();
        halt.now();
        halt.unless_halted(tree)
    }

    /// Follows moved vertices; the faces must be those it was built with. Takes
    /// time in proportion to their number, and no memory but for the boxes and for the vertices of
    /// spheres. If something is no sphere any more, the tree is built anew.
    ///
    /// Answers stay exact however far vertices move, bit for bit those of a new
    /// tree; they only take longer, see [`degradation`](Self::degradation).
    pub fn refit(&mut self, mesh: &Mesh) {
        assert_eq!(
            self.face_count,
            mesh.faces.len(),
            "a tree is refitted with the faces it was built with"
        );
        if let Some(triangles) = self.triangles.get_mut() {
            triangles.refit(mesh);
        }
        let moved = self.spheres.par_iter().map(|sphere| sphere.moved(mesh));
        if let Some(spheres) = moved.map(|sphere| sphere.map(Arc::new)).collect() {
            self.spheres = spheres;
            self.follow(mesh, &Halt::never());
            return;
        }
        let spheres = MeshSphere::all(mesh, &self.spheres);
        let new = Self::with_spheres(mesh, spheres, &Halt::never());
        *self = Self {
            triangles: std::mem::take(&mut self.triangles),
            instructions: self.instructions,
            ..new.expect("nobody gives it up")
        };
    }

    fn follow(&mut self, mesh: &Mesh, halt: &Halt) {
        let hierarchy = &self.hierarchy;
        let pieces = Pieces {
            mesh,
            spheres: &self.spheres,
        };
        self.flat.frame = pieces.frame(&hierarchy.order);
        let frame = &self.flat.frame;
        let mut leaf_bounds = Vec::new();
        (0..hierarchy.leaf_count())
            .into_par_iter()
            .with_min_len(256)
            .map(|leaf| {
                let own = hierarchy.leaf(leaf);
                let block = match pieces.sphere_in(own) {
                    None => TriangleBlock::new(mesh, own),
                    Some(_) => TriangleBlock::EMPTY,
                };
                (block, pieces.leaf_bounds(frame, own))
            })
            .unzip_into_vecs(&mut self.flat.leaves, &mut leaf_bounds);
        let bounds = child_bounds(hierarchy, &leaf_bounds);
        let TriangleTree { nodes, parts, .. } = &mut self.flat;
        nodes.clear();
        parts.clear();
        for (bounds, children) in bounds.iter().zip(&hierarchy.nodes) {
            let children = children.map(|child| {
                let leaf = match child.kind() {
                    Some(ChildKind::Leaf(leaf)) => hierarchy.leaf(leaf),
                    _ => &[],
                };
                pieces.sphere_in(leaf).map_or(child, |sphere| {
                    parts.push(Part::Sphere(SpherePart::new(sphere.clone())));
                    Child::leaf(hierarchy.leaf_count() + parts.len() - 1)
                })
            });
            nodes.push(RayNode::new(bounds, children));
        }
        self.cost.update(&bounds);
        self.fine = has_unresolved(hierarchy, &bounds)
            .then(|| Box::new(fine_tree(pieces, pieces.all(), halt)));
    }

    /// This tree, with the triangles of spheres as all others: for devices. Made when first
    /// asked for, and refitted with this one.
    pub(super) fn without_spheres(&self) -> &Self {
        if self.spheres.is_empty() && self.triangles.get().is_none() {
            return self;
        }
        if self.triangles.get().is_none() {
            // No `get_or_init`: it is made by several threads, one of which could ask for it
            // meanwhile and wait for itself.
            let _ = self.triangles.set(Box::new(self.with_all_triangles()));
        }
        self.triangles.get().expect("it was made")
    }

    fn with_all_triangles(&self) -> Self {
        let blocks = self.flat.leaves.iter();
        let single = blocks.flat_map(|block| {
            let lanes = block.faces().enumerate();
            lanes.map(|(lane, face)| (face, block.corners_of(lane)))
        });
        let of_spheres = self.spheres.iter().flat_map(|sphere| {
            let faces = sphere.faces().enumerate();
            faces.map(|(own, face)| (face, sphere.corners_of(own as u32)))
        });
        let mut corners = vec![[Vec3::zero(); 3]; self.face_count];
        for (face, own) in single.chain(of_spheres) {
            corners[face as usize] = own;
        }
        let vertices = (0..3 * self.face_count as u32).collect::<Vec<_>>();
        let mesh = Mesh {
            positions: corners.into_flattened(),
            faces: vertices.as_chunks().0.to_vec(),
        };
        let tree = Self::with_spheres(&mesh, Vec::new(), &Halt::never());
        tree.expect("nobody gives it up")
    }

    /// What queries search.
    pub(super) fn searched(&self) -> &TriangleTree {
        self.fine.as_deref().unwrap_or(&self.flat)
    }

    /// The expected number of nodes and leaves that a random line visits (the
    /// surface-area cost), over that when the tree was built: 1 for a new tree,
    /// and larger the less the mesh resembles the one it was built for.
    pub fn degradation(&self) -> f64 {
        let of_triangles = self.triangles.get().map(|tree| tree.degradation());
        self.cost.degradation().max(of_triangles.unwrap_or(0.0))
    }

    /// The faces that are not of spheres, in order.
    pub fn single_faces(&self) -> Vec<u32> {
        let mut pieces = self.hierarchy.order.clone();
        // A sphere has the number of its first face.
        let first_face = |sphere: &Arc<MeshSphere>| sphere.faces().start;
        pieces.retain(|piece| {
            self.spheres
                .binary_search_by_key(piece, first_face)
                .is_err()
        });
        pieces.sort_unstable();
        pieces
    }

    /// How many things it has: spheres, and faces that are not of spheres.
    pub fn piece_count(&self) -> usize {
        self.hierarchy.order.len()
    }

    /// The sphere whose faces these are; `None` if they are not all those of one.
    pub fn sphere_of(&self, faces: Range<u32>) -> Option<&MeshSphere> {
        let mut spheres = self.spheres.iter();
        spheres
            .find(|sphere| sphere.faces() == faces)
            .map(|sphere| &**sphere)
    }

    /// How many things of the mesh are searched as spheres.
    #[cfg(test)]
    pub fn sphere_count(&self) -> usize {
        self.spheres.len()
    }

    /// Uses these instructions from now on. The answers stay the same.
    #[cfg(test)]
    pub fn with(self, instructions: Instructions) -> Self {
        Self {
            instructions,
            ..self
        }
    }

    /// The nearest intersection within the ray's bounds; of equally near ones
    /// that of the lowest face.
    #[inline]
    pub fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        add_effort_of(RAY, self.face_count);
        self.instructions.run(FirstHit {
            tree: self.searched(),
            instructions: self.instructions,
            ray,
            before: None,
        })
    }

    /// True if anything lies within the ray's bounds.
    #[inline]
    pub fn occluded(&self, ray: &Ray) -> bool {
        add_effort_of(RAY, self.face_count);
        self.instructions.run(Occluded {
            tree: self.searched(),
            instructions: self.instructions,
            ray,
        })
    }

    /// The face that each ray of a bundle hits first, as [`Self::first_hit`] finds it; `u32::MAX`
    /// is none.
    #[inline]
    pub fn first_hits(&self, rays: &Bundle<'_>) -> [u32; BUNDLE] {
        self.instructions.run(FirstHits {
            tree: self.searched(),
            instructions: self.instructions,
            rays,
        })
    }

    /// One bit for each ray of a bundle within whose bounds anything lies.
    #[inline]
    pub fn occluded_rays(&self, rays: &Bundle<'_>) -> u32 {
        self.instructions.run(OccludedRays {
            tree: self.searched(),
            instructions: self.instructions,
            rays,
        })
    }
}
