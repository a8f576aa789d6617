//! Closest silhouettes among those that a caller accepts.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::cone_kernel::{self, LocalCone};
use super::silhouette_tree::{ConeQuery, LEAF_SIZE, SilhouettePoint, SilhouetteTree};
use crate::bvh::{Child, ChildKind};
use crate::simd::{Job, Simd};

/// Best first instead of depth first: what was rejected must not be what
/// decides where to look next, and a depth-first search would look through
/// everything hidden in a subtree before it turned to its neighbour.
pub(super) struct ClosestWhere<'a, F> {
    /// The tree.
    pub tree: &'a SilhouetteTree,
    /// The cone.
    pub query: &'a ConeQuery,
    /// Which closest points are accepted.
    pub counts: F,
}

/// Something to look at: a part of the tree, or the closest point of an edge.
#[derive(Clone, Copy)]
enum Candidate {
    Below(Child),
    Point(SilhouettePoint),
}

/// A candidate and the least pseudo-angle it may have; ordered so that a heap
/// gives the smallest first, of equal ones the parts of the tree, then the
/// lowest edge.
struct Queued(f32, Candidate);

impl Queued {
    fn key(&self) -> (u32, u32, f64, u32) {
        // The bits of non-negative floats compare like the floats.
        let bound = self.0.to_bits();
        match &self.1 {
            Candidate::Below(_) => (bound, 0, 0.0, 0),
            Candidate::Point(point) => (bound, 1, point.angle, point.edge),
        }
    }
}

impl PartialEq for Queued {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Queued {}
impl PartialOrd for Queued {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Queued {
    fn cmp(&self, other: &Self) -> Ordering {
        let (a, b) = (self.key(), other.key());
        let points = b.2.total_cmp(&a.2).then(b.3.cmp(&a.3));
        (b.0, b.1).cmp(&(a.0, a.1)).then(points)
    }
}

impl<F: Fn(&SilhouettePoint) -> bool> Job for ClosestWhere<'_, F> {
    type Output = Option<SilhouettePoint>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<SilhouettePoint> {
        let Self {
            tree,
            query,
            counts,
        } = self;
        if tree.nodes.is_empty() {
            return None;
        }
        let cone = LocalCone::new(simd, &tree.frame, query);
        let limit = {
            let (sin, cos) = query.max_angle.min(std::f64::consts::PI).sin_cos();
            cone_kernel::pseudo_angle_limit(sin.abs(), cos)
        };
        let mut queue = BinaryHeap::with_capacity(64);
        queue.push(Queued(0.0, Candidate::Below(Child::node(0))));
        while let Some(Queued(_, candidate)) = queue.pop() {
            let child = match candidate {
                Candidate::Point(point) if counts(&point) => return Some(point),
                Candidate::Point(_) => continue,
                Candidate::Below(child) => child,
            };
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mut mask, bounds) = cone.children(simd, node, limit);
                    while mask != 0 {
                        let i = mask.trailing_zeros() as usize % LEAF_SIZE;
                        mask &= mask - 1;
                        queue.push(Queued(bounds[i], Candidate::Below(node.children[i])));
                    }
                }
                Some(ChildKind::Leaf(leaf)) => {
                    let (mut mask, _) = cone.edges(simd, &tree.leaves[leaf], limit);
                    let start = tree.topology.leaf_starts[leaf] as usize;
                    while mask != 0 {
                        let lane = mask.trailing_zeros() as usize % LEAF_SIZE;
                        mask &= mask - 1;
                        if let Some(point) = tree.edges[start + lane].closest(query, None) {
                            // Rounded up: everything that may be nearer comes
                            // before it.
                            let sin = query.axis.cross(point.direction).length();
                            let cos = query.axis.dot(point.direction);
                            let bound = cone_kernel::pseudo_angle_limit(sin, cos);
                            queue.push(Queued(bound, Candidate::Point(point)));
                        }
                    }
                }
                None => {}
            }
        }
        None
    }
}
