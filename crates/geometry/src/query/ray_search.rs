//! The search for what a ray hits in a tree of triangles and in its parts.

use super::ray_kernel::LocalRay;
use super::triangle_tree::{Part, SpherePart, TriangleTree};
use crate::bvh::{Child, ChildKind, Stack};
use crate::ray::{Hit, Ray};
use crate::simd::{Computation, Instructions, Simd};

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
                        best = match tree.part(leaf) {
                            Part::Tree(tree) => self.in_tree(tree, best),
                            Part::Sphere(sphere) => self.in_sphere(simd, local, sphere, best),
                        };
                        bounds[1] = best.map_or(bounds[1], |hit| hit.t);
                        limit = local.limit(bounds[1]);
                    }
                },
                None => {}
            }
        }
        best
    }

    /// The nearest hit in a tree of its own, or that before it. Not inlined: a search would
    /// contain itself.
    #[cold]
    #[inline(never)]
    fn in_tree(&self, tree: &TriangleTree, before: Option<Hit>) -> Option<Hit> {
        let ray = Ray {
            t_max: before.map_or(self.ray.t_max, |hit| hit.t),
            ..*self.ray
        };
        let search = FirstHit {
            tree,
            instructions: self.instructions,
            ray: &ray,
            before,
        };
        self.instructions.run(search)
    }

    /// The nearest hit of a sphere, or that before it.
    #[inline(always)]
    fn in_sphere<S: Simd>(
        &self,
        simd: S,
        local: &LocalRay<S>,
        part: &SpherePart,
        before: Option<Hit>,
    ) -> Option<Hit> {
        let mut best = before;
        let mut bounds = [self.ray.t_min, best.map_or(self.ray.t_max, |hit| hit.t)];
        let passage = part.sphere.passage(self.ray.origin, self.ray.direction);
        if !passage.is_known {
            return self.in_tree(part.tree(), before);
        }
        if passage.misses(bounds) {
            return before;
        }
        for way in passage.ways().into_iter().flatten() {
            let (sphere, left) = (&part.sphere, bounds);
            let found = |hit: Hit| {
                let is_nearer = |best: Hit| (hit.t, hit.face) < (best.t, best.face);
                if best.is_none_or(is_nearer) {
                    best = Some(hit);
                    bounds[1] = hit.t;
                }
            };
            if !sphere.intersect(simd, local, &passage, way, left, found) {
                return self.in_tree(part.tree(), best);
            }
        }
        best
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
                            found = match tree.part(leaf) {
                                Part::Tree(tree) => self.in_tree(tree),
                                Part::Sphere(sphere) => self.in_sphere(simd, local, sphere),
                            };
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

    /// True if anything in a tree of its own is hit. Not inlined: a search would contain itself.
    #[cold]
    #[inline(never)]
    fn in_tree(&self, tree: &TriangleTree) -> bool {
        let search = Occluded {
            tree,
            instructions: self.instructions,
            ray: self.ray,
        };
        self.instructions.run(search)
    }

    /// True if a sphere is hit.
    #[inline(always)]
    fn in_sphere<S: Simd>(&self, simd: S, local: &LocalRay<S>, part: &SpherePart) -> bool {
        let bounds = [self.ray.t_min, self.ray.t_max];
        let passage = part.sphere.passage(self.ray.origin, self.ray.direction);
        if !passage.is_known {
            return self.in_tree(part.tree());
        }
        if passage.misses(bounds) {
            return false;
        }
        if passage.surely_hits(bounds) {
            return true;
        }
        let mut is_hit = false;
        for way in passage.ways().into_iter().flatten() {
            let (sphere, found) = (&part.sphere, |_| is_hit = true);
            if !sphere.intersect(simd, local, &passage, way, bounds, found) {
                return self.in_tree(part.tree());
            }
            if is_hit {
                break;
            }
        }
        is_hit
    }
}
