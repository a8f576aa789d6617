//! All boundaries in a cone, or whether there is one: the silhouette tree's second question, METHOD 8.
//!
//! Nothing that is found limits the search, so it goes depth first, with the same
//! tests of nodes and leaves as the closest silhouette and a limit that stays.

use std::ops::ControlFlow;

use capwalk_math::Vec3;

use super::cone_query::ConeQuery;
use super::edge_block::LANES;
use super::edge_subset::EdgeSubset;
use super::local_cone::LocalCone;
use super::pseudo_angle::Limit;
use super::silhouette_tree::SilhouetteTree;
use crate::bvh::{Child, ChildKind, MAX_DEPTH, WIDTH};
use crate::effort::{CLOSEST, FOUND, add_effort, add_effort_of};
use crate::simd::{Computation, Simd};

impl SilhouetteTree {
    /// Calls `visit` with every boundary edge that meets the cone and its ends, in
    /// an order that depends on the tree alone (METHOD 8), until it has enough; only with those in a
    /// subset, if one is given.
    #[inline]
    pub fn gather(
        &self,
        query: &ConeQuery,
        among: Option<&EdgeSubset>,
        visit: impl FnMut(u32, [Vec3; 2]) -> ControlFlow<()>,
    ) {
        add_effort_of(CLOSEST, self.edges.len());
        self.instructions.run(Gather {
            tree: self,
            query,
            among,
            visit,
        });
    }

    /// True if a boundary edge of a subset meets the cone.
    pub fn meets(&self, query: &ConeQuery, among: &EdgeSubset) -> bool {
        let mut is_met = false;
        self.gather(query, Some(among), |_, _| {
            is_met = true;
            ControlFlow::Break(())
        });
        is_met
    }
}

/// The search as a job for whichever instructions the CPU has.
struct Gather<'a, F> {
    tree: &'a SilhouetteTree,
    query: &'a ConeQuery,
    /// Where it searches, if not everywhere.
    among: Option<&'a EdgeSubset>,
    /// Gets each edge and its ends, and says whether it wants more.
    visit: F,
}

/// A node on the way down leaves at most `WIDTH - 1` siblings behind; the last
/// one pushes all its children.
const STACK_SIZE: usize = MAX_DEPTH * (WIDTH - 1) + WIDTH;

/// Fraction of a pseudo-angle by which an edge must be nearer than the limit to be
/// taken without the exact test: more than the rounding of the limit itself.
const CERTAINLY_WITHIN: f32 = 1.0 - 8.0 * f32::EPSILON;

impl<F: FnMut(u32, [Vec3; 2]) -> ControlFlow<()>> Computation for Gather<'_, F> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(mut self, simd: S) {
        let Self {
            tree, query, among, ..
        } = self;
        // A cone of no angle, or of an angle that is not a number, contains nothing.
        let is_open = query.max_angle > 0.0;
        if tree.nodes.is_empty() || !is_open {
            return;
        }
        let cone = LocalCone::new(simd, &tree.frame, query);
        let limit = Limit::of_angle(query.max_angle);
        let certainly = limit.pseudo * CERTAINLY_WITHIN;
        let mut stack = [Child::node(0); STACK_SIZE];
        let mut len = 1;
        while len > 0 {
            len -= 1;
            match stack[len].kind() {
                Some(ChildKind::Node(index)) => {
                    let node = &tree.nodes[index];
                    let (mut mask, _) = cone.children(simd, node, &limit);
                    if let Some(among) = among {
                        mask &= u32::from(among.children[index]);
                    }
                    // Pushed in reverse, children are visited in their order.
                    for i in (0..WIDTH).rev().filter(|i| mask >> i & 1 != 0) {
                        stack[len] = node.children[i];
                        len += 1;
                    }
                }
                Some(ChildKind::Leaf(leaf)) => {
                    let block = &tree.leaves[leaf];
                    let bounds = cone.edges(simd, block, limit.pseudo);
                    let mut mask = bounds.mask;
                    if let Some(among) = among {
                        mask &= u32::from(among.edges[leaf]);
                    }
                    while mask != 0 {
                        let lane = mask.trailing_zeros() as usize % LANES;
                        mask &= mask - 1;
                        // Certainly a boundary, and certainly inside the cone? Else
                        // the exact test decides, as brute force would.
                        let edge = &tree.edges[block.start as usize + lane];
                        let is_certain =
                            bounds.certain >> lane & 1 != 0 && bounds.most[lane] < certainly;
                        if is_certain || edge.closest(query, None).is_some() {
                            add_effort(FOUND);
                            if (self.visit)(edge.id, edge.ends).is_break() {
                                return;
                            }
                        }
                    }
                }
                None => {}
            }
        }
    }
}
