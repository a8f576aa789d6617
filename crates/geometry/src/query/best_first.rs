//! The closest silhouette among those that a caller accepts: usually those whose
//! closest point nothing hides.
//!
//! What was found cannot limit this search, since the caller may reject it. So the
//! search is strictly best first over nodes, leaves and edges alike: whatever has
//! the least lower bound is opened next, and a tested point is offered to the caller
//! once nothing unopened can be nearer. The caller is asked in the order of angles,
//! and no more often than necessary: each answer costs a ray. Behind a wall there are
//! thousands of hidden points. So the caller is asked for shadows, too, which hide whole
//! edges and nodes: around the first rejected point, the second, the fourth, the eighth and
//! so on, so that there are few of them.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use capwalk_math::Vec3;

use super::cone_node::ConeNode;
use super::cone_query::{ConeQuery, SilhouettePoint};
use super::edge_block::LANES;
use super::local_cone::{LocalCone, LocalPlane};
use super::pseudo_angle::{Limit, pseudo_angle};
use super::shadow::{Shadow, Sight};
use super::silhouette_tree::SilhouetteTree;
use crate::bvh::{Child, ChildKind, WIDTH};
use crate::effort::{CLOSEST, add_effort_of};
use crate::simd::{Computation, Simd};

impl SilhouetteTree {
    /// As [`closest`](Self::closest), among the edges whose closest point is seen.
    /// `sight` is asked about edges in the order of their angles, of equal ones
    /// in that of the edges, until it sees one; not about those that are wholly in a shadow
    /// which it told of before.
    #[inline]
    pub fn closest_where(&self, query: &ConeQuery, sight: &impl Sight) -> Option<SilhouettePoint> {
        // Most closest points count, and the search for the closest of all is
        // several times faster: what it finds limits it.
        let closest = self.closest(query)?;
        if sight.sees(&closest) {
            return Some(closest);
        }
        self.instructions.run(ClosestWhere {
            tree: self,
            query,
            rejected: closest,
            sight,
        })
    }
}

/// The search as a job for whichever instructions the CPU has.
struct ClosestWhere<'a, F> {
    tree: &'a SilhouetteTree,
    query: &'a ConeQuery,
    /// The closest point of all, which is not seen.
    rejected: SilhouettePoint,
    /// Which closest points are seen.
    sight: &'a F,
}

/// A part of the tree, or an edge, and the least pseudo-angle it may have.
/// Ordered so that a heap gives the least first.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Queued(Reverse<(u32, What)>);

#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum What {
    /// [`Child::bits`].
    Below(u32),
    /// The place of the edge.
    Edge(u32),
}

fn queued(least: f32, what: What) -> Queued {
    // The bits of floats that are not negative compare like the floats.
    Queued(Reverse((least.to_bits(), what)))
}

/// A tested edge. A heap gives the nearest first, of equal ones that of the
/// lowest edge.
struct Tested {
    point: SilhouettePoint,
    /// The place of the edge.
    place: u32,
    /// Whatever may be nearer has a lower bound that is not greater than this.
    bound: f32,
}

impl PartialEq for Tested {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Tested {}
impl PartialOrd for Tested {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Tested {
    fn cmp(&self, other: &Self) -> Ordering {
        let (a, b) = (&self.point, &other.point);
        b.angle.total_cmp(&a.angle).then(b.edge.cmp(&a.edge))
    }
}

/// Shadows in which no point counts.
struct Shadows<'a> {
    tree: &'a SilhouetteTree,
    /// Where they are seen from.
    apex: Vec3,
    /// How many points were rejected.
    rejected: u32,
    found: Vec<(Shadow, [LocalPlane; 5])>,
}

impl Shadows<'_> {
    /// Looks for another one around each point that is rejected, if there have been twice as many as the
    /// last time.
    fn reject(&mut self, point: &SilhouettePoint, sight: &impl Sight) {
        self.rejected += 1;
        if self.rejected.is_power_of_two()
            && let Some(shadow) = sight.shadow(point)
        {
            let local = |plane| LocalPlane::new(&self.tree.frame, self.apex, &plane);
            self.found.push((shadow, shadow.planes.map(local)));
        }
    }

    /// True if an edge is wholly in one of them.
    #[inline]
    fn have(&self, edge: u32) -> bool {
        let ends = self.tree.edges[edge as usize].ends;
        self.found.iter().any(|(shadow, _)| shadow.hides(ends))
    }

    /// Those children of a node that are not wholly in one of them.
    #[inline(always)]
    fn outside<S: Simd>(&self, simd: S, cone: &LocalCone<S>, node: &ConeNode, mask: u32) -> u32 {
        let mut left = mask;
        for (_, planes) in &self.found {
            if left != 0 {
                left &= !cone.in_front_of_all(simd, node, planes);
            }
        }
        left
    }
}

impl<F: Sight> Computation for ClosestWhere<'_, F> {
    type Output = Option<SilhouettePoint>;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<SilhouettePoint> {
        let Self {
            tree,
            query,
            rejected,
            sight,
        } = self;
        let mut shadows = Shadows {
            tree,
            apex: query.apex,
            rejected: 0,
            found: Vec::new(),
        };
        shadows.reject(&rejected, sight);
        let cone = LocalCone::new(simd, &tree.frame, query);
        let limit = Limit::of_angle(query.max_angle);
        // What is unopened, by the least pseudo-angle it may have.
        let mut queue = BinaryHeap::with_capacity(64);
        queue.push(queued(0.0, What::Below(Child::node(0).bits())));
        // Exact closest points that the caller has not been asked about.
        let mut tested: BinaryHeap<Tested> = BinaryHeap::new();
        loop {
            let next = queue
                .peek()
                .map(|Queued(Reverse((least, _)))| f32::from_bits(*least));
            // If all that is unopened is farther than the nearest tested point, that
            // is the nearest of all: it is the answer if the caller accepts it.
            if tested
                .peek()
                .is_some_and(|nearest| next.is_none_or(|least| nearest.bound < least))
            {
                let Tested { point, place, .. } = tested.pop()?;
                // Shadows that came after the test count, too: what is asked does not depend on the tree.
                if point.edge == rejected.edge || shadows.have(place) {
                    continue;
                }
                add_effort_of(CLOSEST, tree.edges.len());
                if sight.sees(&point) {
                    return Some(point);
                }
                shadows.reject(&point, sight);
                continue;
            }
            // Otherwise the nearest unopened thing is opened: an edge by its exact test,
            // Eq. (30), a node or leaf by the bounds of what it contains, unless it is in a shadow.
            let Queued(Reverse((_, what))) = queue.pop()?;
            let child = match what {
                What::Edge(edge) if shadows.have(edge) => continue,
                What::Edge(edge) => {
                    if let Some(point) = tree.edges[edge as usize].closest(query, None) {
                        let sin = query.axis.cross(point.direction).length();
                        let bound = pseudo_angle(sin, query.axis.dot(point.direction));
                        tested.push(Tested {
                            point,
                            place: edge,
                            bound,
                        });
                    }
                    continue;
                }
                What::Below(child) => Child::from_bits(child),
            };
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, bounds) = cone.children(simd, node, &limit);
                    let mut mask = shadows.outside(simd, &cone, node, mask);
                    while mask != 0 {
                        let i = mask.trailing_zeros() as usize % WIDTH;
                        mask &= mask - 1;
                        queue.push(queued(bounds[i], What::Below(node.children[i].bits())));
                    }
                }
                Some(ChildKind::Leaf(leaf)) => {
                    let block = &tree.leaves[leaf];
                    let bounds = cone.edges(simd, block, limit.pseudo);
                    let mut mask = bounds.mask;
                    while mask != 0 {
                        let lane = mask.trailing_zeros() as usize % LANES;
                        mask &= mask - 1;
                        let edge = block.start + lane as u32;
                        queue.push(queued(bounds.least[lane], What::Edge(edge)));
                    }
                }
                None => {}
            }
        }
    }
}
