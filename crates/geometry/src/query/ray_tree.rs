//! Rays against triangles.
//!
//! Boxes are tested in single precision and in the tree's own coordinates, with
//! margins for all rounding; triangles in double precision and in the world's
//! (Woop, Benthin and Wald 2013), exactly as brute force does it.

use rayon::prelude::*;

use super::ray_kernel::{self, LocalRay, RayNode, TriangleBlock};
use crate::aabb::Aabb;
use crate::bvh::{ChildKind, Hierarchy, Stack, SurfaceCost, build, child_bounds};
use crate::effort::{RAY, add_effort_of};
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;
use crate::ray::{Hit, Ray};
use crate::simd::{Computation, Instructions, Simd};

/// Triangles per leaf: as many as are tested at a time.
pub(super) const LEAF_SIZE: usize = ray_kernel::LANES;

/// A tree over the triangles of a mesh. It keeps what it needs of the mesh.
///
/// Answers are bitwise those of [`oracle::first_hit`](crate::oracle::first_hit),
/// on every processor: bounds only decide what need not be tested.
#[derive(Clone, Debug)]
pub struct RayTree {
    pub(super) hierarchy: Hierarchy,
    pub(super) frame: LocalFrame,
    pub(super) nodes: Vec<RayNode>,
    pub(super) leaves: Vec<TriangleBlock>,
    cost: SurfaceCost,
    instructions: Instructions,
}

impl RayTree {
    /// Builds the tree. The mesh must have passed [`Mesh::check`] or be empty.
    pub fn build(mesh: &Mesh) -> Self {
        let frame = frame_of(mesh);
        let bounds: Vec<Aabb> = (0..mesh.faces.len())
            .into_par_iter()
            .with_min_len(1024)
            .map(|face| face_bounds(mesh, &frame, face))
            .collect();
        let mut tree = Self {
            hierarchy: build(&bounds, LEAF_SIZE),
            frame,
            nodes: Vec::new(),
            leaves: Vec::new(),
            cost: SurfaceCost::default(),
            instructions: Instructions::detect(),
        };
        tree.refit(mesh);
        tree.cost.now_is_new();
        tree
    }

    /// Follows moved vertices; the faces must be those it was built with. Takes
    /// time in proportion to their number, and no memory but for the boxes.
    ///
    /// Answers stay exact however far vertices move, bit for bit those of a new
    /// tree; they only take longer, see [`degradation`](Self::degradation).
    pub fn refit(&mut self, mesh: &Mesh) {
        let hierarchy = &self.hierarchy;
        assert_eq!(
            hierarchy.order.len(),
            mesh.faces.len(),
            "a tree is refitted with the faces it was built with"
        );
        self.frame = frame_of(mesh);
        let frame = &self.frame;
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
            .unzip_into_vecs(&mut self.leaves, &mut leaf_bounds);
        let bounds = child_bounds(hierarchy, &leaf_bounds);
        self.nodes.clear();
        self.nodes.extend(
            bounds
                .iter()
                .zip(&hierarchy.nodes)
                .map(|(bounds, &children)| RayNode::new(bounds, children)),
        );
        self.cost.update(&bounds);
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
        self.instructions.run(FirstHit { tree: self, ray })
    }

    /// True if anything lies within the ray's bounds.
    #[inline]
    pub fn occluded(&self, ray: &Ray) -> bool {
        add_effort_of(RAY, self.hierarchy.order.len());
        self.instructions.run(Occluded { tree: self, ray })
    }
}

fn frame_of(mesh: &Mesh) -> LocalFrame {
    let corners = mesh.faces.iter().flatten();
    LocalFrame::around(corners.map(|&i| mesh.positions[i as usize]))
}

fn face_bounds(mesh: &Mesh, frame: &LocalFrame, face: usize) -> Aabb {
    Aabb::around(mesh.corners(face).map(|p| frame.local_from_world(p)))
}

struct FirstHit<'a> {
    tree: &'a RayTree,
    ray: &'a Ray,
}

impl Computation for FirstHit<'_> {
    type Output = Option<Hit>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<Hit> {
        let tree = self.tree;
        if tree.nodes.is_empty() {
            return None;
        }
        let local = LocalRay::new(simd, &tree.frame, self.ray)?;
        // The part of the ray that can still have a nearer hit, in its own units, and
        // its end in those of the boxes. Every hit shortens both.
        let mut bounds = [self.ray.t_min, self.ray.t_max];
        let mut limit = local.limit(bounds[1]);
        let mut best: Option<Hit> = None;
        let mut stack = Stack::with_root();
        while let Some((near, child)) = stack.pop() {
            // The ray enters this box behind a hit found since it was pushed.
            if near > limit {
                continue;
            }
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, near) = local.children(simd, node, limit);
                    stack.push_sorted(mask, &near, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    tree.leaves[leaf].intersect(simd, &local, bounds, |hit| {
                        // Of hits at one distance the lowest face counts, in whatever
                        // order the leaves come.
                        let is_nearer = |best: Hit| (hit.t, hit.face) < (best.t, best.face);
                        if best.is_none_or(is_nearer) {
                            best = Some(hit);
                            bounds[1] = hit.t;
                            limit = local.limit(hit.t);
                        }
                    });
                }
                None => {}
            }
        }
        best
    }
}

struct Occluded<'a> {
    tree: &'a RayTree,
    ray: &'a Ray,
}

impl Computation for Occluded<'_> {
    type Output = bool;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> bool {
        let tree = self.tree;
        if tree.nodes.is_empty() {
            return false;
        }
        let Some(local) = LocalRay::new(simd, &tree.frame, self.ray) else {
            return false;
        };
        let bounds = [self.ray.t_min, self.ray.t_max];
        let limit = local.limit(bounds[1]);
        // Any hit will do. Near boxes still come first: they are the likelier ones.
        let mut stack = Stack::with_root();
        while let Some((_, child)) = stack.pop() {
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, near) = local.children(simd, node, limit);
                    stack.push_sorted(mask, &near, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    let mut found = false;
                    tree.leaves[leaf].intersect(simd, &local, bounds, |_| found = true);
                    if found {
                        return true;
                    }
                }
                None => {}
            }
        }
        false
    }
}
