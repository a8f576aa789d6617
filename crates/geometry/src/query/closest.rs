//! The closest silhouette, Algorithm 5.

use super::cone_node::ConeNode;
use super::cone_query::{ConeQuery, SilhouettePoint};
use super::edge_block::{EdgeBlock, LANES};
use super::local_cone::LocalCone;
use super::pseudo_angle::{Limit, pseudo_angle};
use super::silhouette_tree::SilhouetteTree;
use crate::bvh::{Buckets, ChildKind, WIDTH, for_each_sorted};
use crate::simd::{Job, Simd};

impl SilhouetteTree {
    /// The boundary point under the smallest angle to the axis, Algorithm 5; of
    /// equally near ones that of the lowest edge.
    #[inline]
    pub fn closest(&self, query: &ConeQuery) -> Option<SilhouettePoint> {
        self.instructions.run(Closest { tree: self, query })
    }
}

/// Nearest first. Bounds in single precision tell of most edges that they are
/// boundaries, and how near; that limits the search at once. Only the nearest
/// of those need the exact test, when the search is over.
struct Closest<'a> {
    /// The tree.
    tree: &'a SilhouetteTree,
    /// The cone.
    query: &'a ConeQuery,
}

/// Edges that wait for the exact test.
const WAITING: usize = 32;

/// The edges that may be the closest.
struct Search<'a> {
    tree: &'a SilhouetteTree,
    query: &'a ConeQuery,
    /// No edge beyond it is the closest.
    limit: Limit,
    /// The closest that was tested.
    best: Option<SilhouettePoint>,
    /// Edges to be tested, each with a lower bound of its pseudo-angle in the
    /// upper half: numbers compare like bounds, as these are not negative.
    waiting: [u64; WAITING],
    waiting_count: usize,
}

impl Search<'_> {
    /// Puts children of a node into the queue.
    #[inline(always)]
    fn push<S: Simd>(
        &self,
        simd: S,
        queue: &mut Buckets,
        node: &ConeNode,
        mut mask: u32,
        bounds: &[f32; WIDTH],
    ) {
        while mask != 0 {
            let i = mask.trailing_zeros() as usize % WIDTH;
            mask &= mask - 1;
            queue.push(bounds[i], node.children[i]);
            match node.children[i].kind() {
                Some(ChildKind::Node(index)) => simd.prefetch(&self.tree.nodes[index]),
                Some(ChildKind::Leaf(index)) => simd.prefetch(&self.tree.leaves[index]),
                None => {}
            }
        }
    }

    /// Finds how near the edges of a leaf are, as far as they are boundaries.
    #[inline(always)]
    fn visit_leaf<S: Simd>(&mut self, simd: S, cone: &LocalCone<S>, block: &EdgeBlock) {
        let bounds = cone.edges(simd, block, self.limit.pseudo);
        let start = block.start as usize;
        let mut certain = bounds.certain;
        while certain != 0 {
            let lane = certain.trailing_zeros() as usize % LANES;
            certain &= certain - 1;
            // Not if it is NaN.
            self.limit.lower_to(bounds.most[lane]);
            if bounds.least[lane] <= self.limit.pseudo {
                simd.prefetch(&self.tree.edges[start + lane]);
                self.wait(start + lane, bounds.least[lane]);
            }
        }
        // The others need the exact test to limit anything.
        let uncertain = bounds.mask & !bounds.certain;
        for_each_sorted(uncertain, &bounds.least, |lane, least| {
            if least <= self.limit.pseudo {
                self.test(start + lane);
            }
        });
    }

    /// Tests an edge exactly.
    #[inline(always)]
    fn test(&mut self, edge: usize) {
        let edge = &self.tree.edges[edge];
        if let Some(point) = edge.closest(self.query, self.best.as_ref()) {
            let sin = self.query.axis.cross(point.direction).length();
            let cos = self.query.axis.dot(point.direction);
            self.limit.lower_to(pseudo_angle(sin, cos));
            self.best = Some(point);
        }
    }

    /// Leaves an edge to be tested later.
    #[inline(always)]
    fn wait(&mut self, edge: usize, least: f32) {
        if self.waiting_count == WAITING {
            self.test_waiting();
        }
        self.waiting[self.waiting_count] = u64::from(least.to_bits()) << 32 | edge as u64;
        self.waiting_count += 1;
    }

    /// Tests those waiting that may be the closest, the nearest first.
    #[inline(always)]
    fn test_waiting(&mut self) {
        loop {
            let limit = self.limit.pseudo;
            let mut kept = 0;
            let mut nearest = u64::MAX;
            for i in 0..self.waiting_count {
                let entry = self.waiting[i];
                if f32::from_bits((entry >> 32) as u32) <= limit {
                    // All but the nearest stay.
                    let farther = entry.max(nearest);
                    nearest = entry.min(nearest);
                    if farther != u64::MAX {
                        self.waiting[kept] = farther;
                        kept += 1;
                    }
                }
            }
            self.waiting_count = kept;
            if nearest == u64::MAX {
                return;
            }
            self.test(nearest as u32 as usize);
        }
    }
}

impl Job for Closest<'_> {
    type Output = Option<SilhouettePoint>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<SilhouettePoint> {
        let Self { tree, query } = self;
        if tree.nodes.is_empty() {
            return None;
        }
        let cone = LocalCone::new(simd, &tree.frame, query);
        let mut search = Search {
            tree,
            query,
            limit: Limit::of_angle(query.max_angle),
            best: None,
            waiting: [0; WAITING],
            waiting_count: 0,
        };
        let mut queue = Buckets::with_root(search.limit.pseudo);
        let mut held = None; // a node that waits for another
        loop {
            let node = match queue.pop() {
                Some((bound, _)) if bound > search.limit.pseudo => continue,
                Some((_, child)) => match child.kind() {
                    Some(ChildKind::Node(node)) => node,
                    Some(ChildKind::Leaf(leaf)) => {
                        search.visit_leaf(simd, &cone, &tree.leaves[leaf]);
                        continue;
                    }
                    None => continue,
                },
                // The last one is its own partner.
                None => match held {
                    Some(node) => node,
                    None => break,
                },
            };
            let Some(other) = held.take() else {
                held = Some(node);
                continue;
            };
            // Two at a time: each by itself would mostly wait for its own
            // results.
            let [first, second] = [&tree.nodes[other], &tree.nodes[node]];
            let (first_mask, first_bounds) = cone.children(simd, first, &search.limit);
            let (second_mask, second_bounds) = cone.children(simd, second, &search.limit);
            search.push(simd, &mut queue, first, first_mask, &first_bounds);
            if other != node {
                search.push(simd, &mut queue, second, second_mask, &second_bounds);
            }
        }
        search.test_waiting();
        search.best
    }
}
