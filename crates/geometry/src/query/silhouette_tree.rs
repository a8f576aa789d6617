//! The tree of silhouettes: the closest one, Algorithm 5, and all in a cone.

use std::ops::Range;

use capwalk_math::Vec3;
use rayon::prelude::*;

use super::best_first::ClosestWhere;
use super::closest::Closest;
use super::cone_node::ConeNode;
use super::edge_block::{EdgeBlock, LocalEdge};
use super::edge_kernel;
use super::gather::Gather;
use super::tree_edge::TreeEdge;
use crate::aabb::{Aabb, LocalFrame};
use crate::bvh::cost::SurfaceCost;
use crate::bvh::validate::{self, TreeError};
use crate::bvh::{Topology, build, refit};
use crate::edge::Edge;
use crate::mesh::Mesh;
use crate::simd::Instructions;

/// Edges per leaf: as many as are tested at a time.
const LEAF_SIZE: usize = edge_kernel::LANES;

/// Which edges count as boundaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeSelection {
    /// Open edges, and edges with one face seen from the front and one from
    /// behind.
    Silhouettes,
    /// Every edge, creases too.
    All,
}

/// A plane; the side its normal points to is in front.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// A point on it.
    pub point: Vec3,
    /// Its normal, of any length.
    pub normal: Vec3,
}

impl Plane {
    /// True if both points lie behind.
    #[inline]
    pub fn hides(&self, ends: [Vec3; 2]) -> bool {
        let is_behind = |p: Vec3| (p - self.point).dot(self.normal) < 0.0;
        ends.into_iter().all(is_behind)
    }
}

/// A cone to search for boundaries.
#[derive(Clone, Copy, Debug)]
pub struct ConeQuery {
    /// Apex of the cone.
    pub eye: Vec3,
    /// Unit axis.
    pub axis: Vec3,
    /// Half-angle in radians: only points at smaller angles are found. At
    /// least π means no limit.
    pub max_angle: f64,
    /// Which edges count.
    pub edges: EdgeSelection,
    /// Only edges that share a bit with it count.
    pub groups: u8,
    /// Edges wholly behind this plane do not count (`domain = triangle`).
    pub in_front_of: Option<Plane>,
}

/// A point on a boundary edge, seen from the eye of the query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SilhouettePoint {
    /// The edge.
    pub edge: u32,
    /// Position along it: 0 at its first vertex, 1 at its second.
    pub t: f64,
    /// Unit direction from the eye.
    pub direction: Vec3,
    /// Distance from the eye, world units.
    pub distance: f64,
    /// Angle to the axis, radians.
    pub angle: f64,
}

/// A tree over the edges of a mesh, with cones of their faces' normals. It
/// keeps what it needs of the mesh.
///
/// Answers are bitwise those of
/// [`oracle::closest_silhouette`](crate::oracle::closest_silhouette), on every
/// processor: bounds only decide what need not be tested.
#[derive(Clone, Debug)]
pub struct SilhouetteTree {
    pub(super) topology: Topology,
    pub(super) frame: LocalFrame,
    pub(super) nodes: Vec<ConeNode>,
    pub(super) leaves: Vec<EdgeBlock>,
    /// The edges in the order of the leaves: what queries need, and the rest.
    pub(super) edges: Vec<TreeEdge>,
    sources: Vec<Edge>,
    cost: SurfaceCost,
    instructions: Instructions,
}

impl SilhouetteTree {
    /// Builds the tree. `edges` may come from several meshes as long as they
    /// index `mesh`.
    pub fn build(mesh: &Mesh, edges: &[Edge]) -> Self {
        let frame = frame_of(mesh, edges);
        let bounds: Vec<Aabb> = edges
            .par_iter()
            .with_min_len(1024)
            .map(|edge| {
                let ends = edge.vertices.map(|i| mesh.positions[i as usize]);
                Aabb::around(ends.map(|p| frame.local_from_world(p)))
            })
            .collect();
        let topology = build::build(&bounds, LEAF_SIZE);
        let mut tree = Self {
            sources: topology
                .order
                .iter()
                .map(|&id| edges[id as usize])
                .collect(),
            topology,
            frame,
            nodes: Vec::new(),
            leaves: Vec::new(),
            edges: Vec::new(),
            cost: SurfaceCost::default(),
            instructions: Instructions::detect(),
        };
        tree.refit(mesh);
        tree.cost.now_is_new();
        tree
    }

    /// Follows moved vertices; faces and edges must be those it was built with.
    /// Takes time in proportion to the number of edges and the depth of the
    /// tree, and memory for one copy of the edges.
    ///
    /// For these edges, answers stay exact however far vertices move: the closest
    /// silhouettes are bit for bit those of a new tree, and the same edges are
    /// gathered, in an order that may differ. They only take longer, see
    /// [`degradation`](Self::degradation). Whether these still are the edges of
    /// the mesh is another question, see [`topology`](crate::topology).
    pub fn refit(&mut self, mesh: &Mesh) {
        let topology = &self.topology;
        (&topology.order, &self.sources)
            .into_par_iter()
            .with_min_len(1024)
            .map(|(&id, edge)| TreeEdge::new(mesh, id, edge))
            .collect_into_vec(&mut self.edges);
        self.frame = LocalFrame::around(self.edges.iter().flat_map(|edge| edge.ends));
        let local: Vec<LocalEdge> = (&self.edges, &self.sources)
            .into_par_iter()
            .with_min_len(1024)
            .map(|(edge, source)| edge.local(&self.frame, source.groups))
            .collect();
        let below = |leaves: Range<u32>| {
            let [start, end] =
                [leaves.start, leaves.end].map(|leaf| topology.leaf_starts[leaf as usize] as usize);
            (start, &local[start..end])
        };
        let mut leaf_bounds = Vec::new();
        (0..topology.leaf_count() as u32)
            .into_par_iter()
            .with_min_len(256)
            .map(|leaf| {
                let (start, edges) = below(leaf..leaf + 1);
                let bounds = Aabb::around(edges.iter().flat_map(|edge| edge.ends));
                (EdgeBlock::new(start, edges), bounds)
            })
            .unzip_into_vecs(&mut self.leaves, &mut leaf_bounds);
        let leaves = refit::child_leaves(topology);
        (&topology.nodes, &leaves)
            .into_par_iter()
            .map(|(children, leaves)| ConeNode::new(children, |slot| below(leaves[slot].clone()).1))
            .collect_into_vec(&mut self.nodes);
        self.cost
            .update(&refit::child_bounds(topology, &leaf_bounds));
    }

    /// The surface-area cost of the tree over that when it was built: 1 for a new
    /// tree, and larger the less the mesh resembles the one it was built for.
    pub fn degradation(&self) -> f64 {
        self.cost.degradation()
    }

    /// Uses plain arithmetic from now on, whatever the processor can do: for
    /// tests and comparisons. The answers stay the same.
    pub fn without_simd(mut self) -> Self {
        self.instructions = Instructions::Scalar;
        self
    }

    /// The boundary point under the smallest angle to the axis, Algorithm 5; of
    /// equally near ones that of the lowest edge.
    #[inline]
    pub fn closest(&self, query: &ConeQuery) -> Option<SilhouettePoint> {
        self.instructions.run(Closest { tree: self, query })
    }

    /// The same, leaving out edges whose closest point `counts` rejects. It is
    /// asked about edges in the order of their angles until it accepts one.
    #[inline]
    pub fn closest_where(
        &self,
        query: &ConeQuery,
        counts: impl Fn(&SilhouettePoint) -> bool,
    ) -> Option<SilhouettePoint> {
        // Most closest points count, and the search for the closest of all is
        // several times faster: what it finds limits it.
        let closest = self.closest(query)?;
        if counts(&closest) {
            return Some(closest);
        }
        self.instructions.run(ClosestWhere {
            tree: self,
            query,
            rejected: closest,
            counts,
        })
    }

    /// Calls `visit` with every boundary edge that meets the cone and its ends, in
    /// an order that depends on the tree alone (METHOD 8).
    #[inline]
    pub fn gather(&self, query: &ConeQuery, visit: impl FnMut(u32, [Vec3; 2])) {
        self.instructions.run(Gather {
            tree: self,
            query,
            visit,
        });
    }

    /// Checks the tree against the mesh and edges it should represent.
    pub fn validate(&self, mesh: &Mesh, edges: &[Edge]) -> Result<(), TreeError> {
        let topology = &self.topology;
        validate::check_topology(topology, edges.len(), LEAF_SIZE)?;
        let expected = |id: u32| TreeEdge::new(mesh, id, &edges[id as usize]);
        for leaf in 0..topology.leaf_count() {
            let mut local = Vec::new();
            for (place, &id) in (topology.leaf_starts[leaf] as usize..).zip(topology.leaf(leaf)) {
                let edge = expected(id);
                if self.edges[place] != edge || self.sources[place] != edges[id as usize] {
                    let primitive = id as usize;
                    return Err(TreeError::LeafContent { leaf, primitive });
                }
                local.push(edge.local(&self.frame, edges[id as usize].groups));
            }
            let start = topology.leaf_starts[leaf] as usize;
            if self.leaves[leaf] != EdgeBlock::new(start, &local) {
                let primitive = topology.leaf(leaf)[0] as usize;
                return Err(TreeError::LeafContent { leaf, primitive });
            }
        }
        validate::for_each_below(topology, |node, slot, edge| {
            let local = expected(edge as u32).local(&self.frame, edges[edge].groups);
            let child = &self.nodes[node];
            if !child.contains(slot, &local) {
                let primitive = edge;
                return Err(TreeError::Bounds {
                    node,
                    slot,
                    primitive,
                });
            }
            if !child.covers(slot, &local) {
                return Err(TreeError::NormalCone { node, slot, edge });
            }
            if child.groups(slot) & local.groups != local.groups {
                return Err(TreeError::Groups { node, slot, edge });
            }
            Ok(())
        })
    }
}

fn frame_of(mesh: &Mesh, edges: &[Edge]) -> LocalFrame {
    let ends = edges.iter().flat_map(|edge| edge.vertices);
    LocalFrame::around(ends.map(|i| mesh.positions[i as usize]))
}
