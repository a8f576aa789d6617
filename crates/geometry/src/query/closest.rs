//! The closest silhouette, Algorithm 5.
//!
//! The search goes down the tree nearest first. Of most edges in a leaf, bounds in
//! single precision already tell that they are boundaries, and between which two
//! angles their closest points lie: the upper one limits the search at once, and
//! the lower one says whether the edge is worth its exact test (Eq. 30 in double
//! precision), which is put off until the limit is as low as it gets. Bounds decide
//! what is tested, never what is found, so the answer is that of brute force.
//!
//! Angles are compared as pseudo-angles, see `pseudo_angle.rs`.

use super::cone_node::ConeNode;
use super::cone_query::{ConeQuery, SilhouettePoint};
use super::edge_block::{EdgeBlock, LANES};
use super::local_cone::LocalCone;
use super::pseudo_angle::{Limit, pseudo_angle};
use super::silhouette_tree::SilhouetteTree;
use crate::bvh::{Buckets, ChildKind, WIDTH, for_each_sorted};
use crate::effort::{CLOSEST, add_effort_of};
use crate::simd::{Computation, Simd};

impl SilhouetteTree {
    /// The boundary point under the smallest angle to the axis, Algorithm 5; of
    /// equally near ones that of the lowest edge.
    #[inline]
    pub fn closest(&self, query: &ConeQuery) -> Option<SilhouettePoint> {
        add_effort_of(CLOSEST, self.edges.len());
        self.instructions.run(Closest { tree: self, query })
    }
}

/// The search as a job for whichever instructions the CPU has.
struct Closest<'a> {
    tree: &'a SilhouetteTree,
    query: &'a ConeQuery,
}

/// So many edges wait for their exact test before one round of tests is made: more
/// than nearly every search has.
const WAITING: usize = 32;

/// The state of a search.
struct Search<'a> {
    tree: &'a SilhouetteTree,
    query: &'a ConeQuery,
    /// The closest point lies no farther from the axis than this.
    limit: Limit,
    /// The closest point among the edges tested.
    best: Option<SilhouettePoint>,
    /// Edges to be tested, each with a lower bound of its pseudo-angle in the
    /// upper half: numbers compare like bounds, as these are not negative.
    waiting: [u64; WAITING],
    waiting_count: usize,
}

impl Search<'_> {
    /// Puts the children whose bit is set into the queue, and fetches them: by the
    /// time their turn comes they are in the cache.
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

    /// Lowers the limit by what is known of a leaf's eight edges.
    #[inline(always)]
    fn visit_leaf<S: Simd>(&mut self, simd: S, cone: &LocalCone<S>, block: &EdgeBlock) {
        let bounds = cone.edges(simd, block, self.limit.pseudo);
        let start = block.start as usize;
        // A certain boundary lowers the limit to its upper bound without being
        // tested. The test is only needed if it turns out to be the closest.
        let mut certain = bounds.certain;
        while certain != 0 {
            let lane = certain.trailing_zeros() as usize % LANES;
            certain &= certain - 1;
            self.limit.lower_to(bounds.most[lane]);
            if bounds.least[lane] <= self.limit.pseudo {
                simd.prefetch(&self.tree.edges[start + lane]);
                self.wait(start + lane, bounds.least[lane]);
            }
        }
        // Where rounding might decide whether an edge is a boundary, only the exact
        // test may lower the limit. The nearest goes first: it may spare the others.
        let uncertain = bounds.mask & !bounds.certain;
        for_each_sorted(uncertain, &bounds.least, |lane, least| {
            if least <= self.limit.pseudo {
                self.test(start + lane);
            }
        });
    }

    /// Tests an edge exactly, Eq. (30), and keeps its closest point if that is
    /// nearer than the best; of equally near ones the lowest edge's.
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

    /// Puts an edge's test off; `least` is the lower bound of its pseudo-angle.
    #[inline(always)]
    fn wait(&mut self, edge: usize, least: f32) {
        if self.waiting_count == WAITING {
            self.test_waiting();
        }
        self.waiting[self.waiting_count] = u64::from(least.to_bits()) << 32 | edge as u64;
        self.waiting_count += 1;
    }

    /// Tests those that wait and may be the closest, the nearest first. Each test can
    /// lower the limit, which strikes out others.
    #[inline(always)]
    fn test_waiting(&mut self) {
        loop {
            let limit = self.limit.pseudo;
            let mut kept = 0;
            let mut nearest = u64::MAX;
            for i in 0..self.waiting_count {
                let entry = self.waiting[i];
                if f32::from_bits((entry >> 32) as u32) <= limit {
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

impl Computation for Closest<'_> {
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
        // Nodes and leaves still to visit, nearest first.
        let mut queue = Buckets::with_root(search.limit.pseudo);
        // A node that waits for a second one: two are tested at a time, since each
        // by itself would mostly wait for its own results.
        let mut held = None;
        loop {
            let node = match queue.pop() {
                // The limit has fallen below everything in there.
                Some((bound, _)) if bound > search.limit.pseudo => continue,
                Some((_, child)) => match child.kind() {
                    Some(ChildKind::Node(node)) => node,
                    Some(ChildKind::Leaf(leaf)) => {
                        search.visit_leaf(simd, &cone, &tree.leaves[leaf]);
                        continue;
                    }
                    None => continue,
                },
                // Nothing else to visit: the node held is its own partner.
                None => match held {
                    Some(node) => node,
                    None => break,
                },
            };
            let Some(other) = held.take() else {
                held = Some(node);
                continue;
            };
            // Of the children, those come into the queue whose normal cones allow a
            // silhouette and whose boxes reach within the limit.
            let [first, second] = [&tree.nodes[other], &tree.nodes[node]];
            let (first_mask, first_bounds) = cone.children(simd, first, &search.limit);
            let (second_mask, second_bounds) = cone.children(simd, second, &search.limit);
            search.push(simd, &mut queue, first, first_mask, &first_bounds);
            if other != node {
                search.push(simd, &mut queue, second, second_mask, &second_bounds);
            }
        }
        // Now that the limit is final, few of those waiting are left to be tested.
        search.test_waiting();
        search.best
    }
}
