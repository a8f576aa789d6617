//! Trees of triangles, and the search for what a ray hits in one and in its parts.

use super::ray_kernel::{LocalRay, RayNode, TriangleBlock};
use crate::bvh::{Child, ChildKind, Stack};
use crate::local_frame::LocalFrame;
use crate::ray::{Hit, Ray};
use crate::simd::{Computation, Instructions, Simd};

/// A tree of triangles, of which parts are trees of their own.
#[derive(Clone, Debug)]
pub struct TriangleTree {
    /// The coordinates of its nodes.
    pub frame: LocalFrame,
    pub nodes: Vec<RayNode>,
    pub leaves: Vec<TriangleBlock>,
    /// Behind the numbers of the leaves come those of the parts.
    pub parts: Vec<Self>,
}

impl TriangleTree {
    /// The part with the number of a leaf, behind those of the leaves.
    pub fn part(&self, leaf: usize) -> &Self {
        &self.parts[leaf - self.leaves.len()]
    }
}

/// The nearest hit in a tree.
#[derive(Clone, Copy)]
pub struct FirstHit<'a> {
    pub tree: &'a TriangleTree,
    pub instructions: Instructions,
    pub ray: &'a Ray,
    /// One that is known already.
    pub before: Option<Hit>,
}

impl Computation for FirstHit<'_> {
    type Output = Option<Hit>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<Hit> {
        let tree = self.tree;
        if tree.nodes.is_empty() {
            return self.before;
        }
        let Some(local) = LocalRay::new(simd, &tree.frame, self.ray) else {
            return self.before;
        };
        self.below(simd, &local, Child::node(0))
    }
}

impl FirstHit<'_> {
    /// The nearest hit below a child of a node.
    #[inline(always)]
    pub fn below<S: Simd>(&self, simd: S, local: &LocalRay<S>, child: Child) -> Option<Hit> {
        let (tree, mut best) = (self.tree, self.before);
        // The part of the ray that can still have a nearer hit, in its own units, and
        // its end in those of the boxes. Every hit shortens both.
        let mut bounds = [self.ray.t_min, self.ray.t_max];
        let mut limit = local.limit(bounds[1]);
        let mut stack = Stack::with(child);
        // Past boxes that the ray enters behind a hit found since they were pushed.
        while let Some(child) = stack.pop(limit) {
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, near) = local.children(simd, node, limit);
                    stack.push_sorted(mask, &near, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => match tree.leaves.get(leaf) {
                    Some(leaf) => leaf.intersect(simd, local, bounds, |hit| {
                        // Of hits at one distance the lowest face counts, in whatever
                        // order the leaves come.
                        let is_nearer = |best: Hit| (hit.t, hit.face) < (best.t, best.face);
                        if best.is_none_or(is_nearer) {
                            best = Some(hit);
                            bounds[1] = hit.t;
                            limit = local.limit(hit.t);
                        }
                    }),
                    None => {
                        let ray = Ray {
                            t_max: bounds[1],
                            ..*self.ray
                        };
                        let part = FirstHit {
                            tree: tree.part(leaf),
                            instructions: self.instructions,
                            ray: &ray,
                            before: best,
                        };
                        best = part.run_apart();
                        bounds[1] = best.map_or(bounds[1], |hit| hit.t);
                        limit = local.limit(bounds[1]);
                    }
                },
                None => {}
            }
        }
        best
    }

    /// Runs it. Not inlined: a search would contain itself.
    #[cold]
    #[inline(never)]
    fn run_apart(self) -> Option<Hit> {
        self.instructions.run(self)
    }
}

/// True if anything in a tree is hit.
#[derive(Clone, Copy)]
pub struct Occluded<'a> {
    pub tree: &'a TriangleTree,
    pub instructions: Instructions,
    pub ray: &'a Ray,
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
        self.below(simd, &local, Child::node(0))
    }
}

impl Occluded<'_> {
    /// True if anything below a child of a node is hit.
    #[inline(always)]
    pub fn below<S: Simd>(&self, simd: S, local: &LocalRay<S>, child: Child) -> bool {
        let tree = self.tree;
        let bounds = [self.ray.t_min, self.ray.t_max];
        let limit = local.limit(bounds[1]);
        // Any hit will do. Near boxes still come first: they are the likelier ones.
        let mut stack = Stack::with(child);
        while let Some(child) = stack.pop(limit) {
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, near) = local.children(simd, node, limit);
                    stack.push_sorted(mask, &near, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    let mut found = false;
                    match tree.leaves.get(leaf) {
                        Some(leaf) => leaf.intersect(simd, local, bounds, |_| found = true),
                        None => {
                            let tree = tree.part(leaf);
                            found = Self { tree, ..*self }.run_apart();
                        }
                    }
                    if found {
                        return true;
                    }
                }
                None => {}
            }
        }
        false
    }

    /// Runs it. Not inlined: a search would contain itself.
    #[cold]
    #[inline(never)]
    fn run_apart(self) -> bool {
        self.instructions.run(self)
    }
}
