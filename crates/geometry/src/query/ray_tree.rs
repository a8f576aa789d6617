//! Rays against triangles.
//!
//! Boxes are tested in single precision and in the tree's own coordinates, with
//! margins for all rounding; triangles in double precision and in the world's
//! (Woop, Benthin and Wald 2013), exactly as brute force does it.

use rayon::prelude::*;

use super::bundle::{BUNDLE, Bundle};
use super::bundle_search::{FirstHits, OccludedRays};
use super::fine_tree::{face_bounds, fine_tree, frame_of, has_unresolved};
use super::ray_kernel::{self, RayNode, TriangleBlock};
use super::ray_search::{FirstHit, Occluded, TriangleTree};
use crate::aabb::Aabb;
use crate::bvh::{Hierarchy, Splits, SurfaceCost, build, child_bounds};
use crate::effort::{RAY, add_effort_of};
use crate::halt::{Halt, Halted};
use crate::mesh::Mesh;
use crate::ray::{Hit, Ray};
use crate::simd::Instructions;

/// Triangles per leaf: as many as are tested at a time.
pub(super) const LEAF_SIZE: usize = ray_kernel::LANES;

/// A tree over the triangles of a mesh. It keeps what it needs of the mesh.
///
/// Answers are bitwise those of [`oracle::first_hit`](crate::oracle::first_hit),
/// on every CPU: bounds only decide what need not be tested.
#[derive(Clone, Debug)]
pub struct RayTree {
    pub(super) hierarchy: Hierarchy,
    /// All of it, without parts: what devices and packets of rays have.
    pub(super) flat: TriangleTree,
    /// The tree that is searched in its place, if single precision does not tell the triangles of
    /// some small part from each other.
    fine: Option<Box<TriangleTree>>,
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
        let frame = frame_of(mesh, 0..mesh.faces.len());
        let bounds: Vec<Aabb> = (0..mesh.faces.len())
            .into_par_iter()
            .with_min_len(1024)
            .map(|face| face_bounds(mesh, &frame, face))
            .collect();
        let hierarchy = halt.unless_halted(build(&bounds, LEAF_SIZE, Splits::Fine, halt))?;
        let mut tree = Self {
            hierarchy,
            flat: TriangleTree {
                frame,
                nodes: Vec::new(),
                leaves: Vec::new(),
                parts: Vec::new(),
            },
            fine: None,
            cost: SurfaceCost::default(),
            instructions: Instructions::detect(),
        };
        tree.follow(mesh, halt);
        tree.cost.now_is_new();
        halt.now();
        halt.unless_halted(tree)
    }

    /// Follows moved vertices; the faces must be those it was built with. Takes
    /// time in proportion to their number, and no memory but for the boxes.
    ///
    /// Answers stay exact however far vertices move, bit for bit those of a new
    /// tree; they only take longer, see [`degradation`](Self::degradation).
    pub fn refit(&mut self, mesh: &Mesh) {
        self.follow(mesh, &Halt::never());
    }

    fn follow(&mut self, mesh: &Mesh, halt: &Halt) {
        let hierarchy = &self.hierarchy;
        assert_eq!(
            hierarchy.order.len(),
            mesh.faces.len(),
            "a tree is refitted with the faces it was built with"
        );
        self.flat.frame = frame_of(mesh, 0..mesh.faces.len());
        let frame = &self.flat.frame;
        let mut leaf_bounds = Vec::new();
        (0..hierarchy.leaf_count())
            .into_par_iter()
            .with_min_len(256)
            .map(|leaf| {
                let faces = hierarchy.leaf(leaf);
                let bounds = faces.iter().fold(Aabb::EMPTY, |bounds, &face| {
                    bounds.union(&face_bounds(mesh, frame, face as usize))
                });
                (TriangleBlock::new(mesh, faces), bounds)
            })
            .unzip_into_vecs(&mut self.flat.leaves, &mut leaf_bounds);
        let bounds = child_bounds(hierarchy, &leaf_bounds);
        let nodes = &mut self.flat.nodes;
        nodes.clear();
        nodes.extend(
            bounds
                .iter()
                .zip(&hierarchy.nodes)
                .map(|(bounds, &children)| RayNode::new(bounds, children)),
        );
        self.cost.update(&bounds);
        self.fine = has_unresolved(hierarchy, &bounds).then(|| {
            let faces: Vec<u32> = (0..mesh.faces.len() as u32).collect();
            Box::new(fine_tree(mesh, &faces, halt))
        });
    }

    /// What queries search.
    pub(super) fn searched(&self) -> &TriangleTree {
        self.fine.as_deref().unwrap_or(&self.flat)
    }

    /// The expected number of nodes and leaves that a random line visits (the
    /// surface-area cost), over that when the tree was built: 1 for a new tree,
    /// and larger the less the mesh resembles the one it was built for.
    pub fn degradation(&self) -> f64 {
        self.cost.degradation()
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
        add_effort_of(RAY, self.hierarchy.order.len());
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
        add_effort_of(RAY, self.hierarchy.order.len());
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
