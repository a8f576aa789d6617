//! Closest silhouettes, Algorithm 5.

use capwalk_math::Vec3;
use rayon::prelude::*;

use super::best_first::ClosestWhere;
use super::cone_kernel::{self, LocalCone};
use super::cone_node::{ConeNode, EdgeBlock, LocalEdge};
use crate::aabb::{Aabb, LocalFrame};
use crate::bvh::traverse::{Stack, for_each_sorted};
use crate::bvh::validate::{self, TreeError};
use crate::bvh::{ChildKind, Topology, build, refit};
use crate::edge::{Edge, Sides, closest_direction, separates};
use crate::mesh::Mesh;
use crate::simd::{Instructions, Job, Simd};

/// Edges per leaf: as many as are tested at a time.
pub(super) const LEAF_SIZE: usize = cone_kernel::LANES;

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
    instructions: Instructions,
}

/// What queries need of an edge, in two cache lines.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(super) struct TreeEdge {
    ends: [Vec3; 2],
    /// `Mesh::face_cross` of its two faces; zero if it is open.
    crosses: [Vec3; 2],
    id: u32,
    kind: EdgeKind,
}

/// [`Sides`] without the faces.
#[derive(Clone, Copy, Debug, PartialEq)]
enum EdgeKind {
    Open,
    Between { flipped: bool },
}

impl TreeEdge {
    fn new(mesh: &Mesh, id: u32, edge: &Edge) -> Self {
        let (kind, crosses) = match edge.sides {
            Sides::Open => (EdgeKind::Open, [Vec3::zero(); 2]),
            Sides::Between { faces, flipped } => {
                let crosses = faces.map(|face| mesh.face_cross(face as usize));
                (EdgeKind::Between { flipped }, crosses)
            }
        };
        Self {
            ends: edge.vertices.map(|i| mesh.positions[i as usize]),
            crosses,
            id,
            kind,
        }
    }

    /// As [`Edge::is_silhouette`].
    #[inline(always)]
    fn is_silhouette(&self, eye: Vec3) -> bool {
        match self.kind {
            EdgeKind::Open => true,
            EdgeKind::Between { flipped } => separates(self.crosses, self.ends[0], flipped, eye),
        }
    }

    /// The edge in local coordinates.
    fn local(&self, frame: &LocalFrame, groups: u8) -> LocalEdge {
        let normals = match self.kind {
            EdgeKind::Open => None,
            EdgeKind::Between { flipped } => {
                let [first, second] = self.crosses.map(|cross| self.usable_normal(frame, cross));
                let second = second.map(|n| if flipped { -n } else { n });
                first.zip(second).map(|(first, second)| [first, second])
            }
        };
        LocalEdge {
            ends: self.ends.map(|p| frame.local_from_world(p)),
            normals,
            groups,
        }
    }

    /// The unit normal of a face; `None` if the face is degenerate, or so thin
    /// that rounding tilts its normal against the edge: the orientation towards
    /// an eye then depends on where along the edge it is measured.
    fn usable_normal(&self, frame: &LocalFrame, cross: Vec3) -> Option<Vec3> {
        let normal = cross.normalized();
        let [a, b] = self.ends;
        let tilt = (b - a).dot(normal).abs() * frame.inverse_scale;
        (tilt <= EDGE_TILT).then_some(normal) // not for NaN
    }

    /// The point of the edge closest to the axis, if the edge is a boundary and
    /// the point nearer than `max_angle`, or as near as `best` and the edge
    /// before it.
    #[inline(always)]
    pub(super) fn closest(
        &self,
        query: &ConeQuery,
        best: Option<&SilhouettePoint>,
    ) -> Option<SilhouettePoint> {
        let counts = query.edges == EdgeSelection::All || self.is_silhouette(query.eye);
        if !counts
            || query
                .in_front_of
                .is_some_and(|plane| plane.hides(self.ends))
        {
            return None;
        }
        let [a, b] = self.ends.map(|p| p - query.eye);
        let closest = closest_direction(a, b, query.axis)?;
        let is_nearer = match best {
            Some(best) => (closest.angle, self.id) < (best.angle, best.edge),
            None => closest.angle < query.max_angle,
        };
        is_nearer.then_some(SilhouettePoint {
            edge: self.id,
            t: closest.t,
            direction: closest.direction,
            distance: closest.distance,
            angle: closest.angle,
        })
    }
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
            instructions: Instructions::detect(),
        };
        tree.refit(mesh);
        tree
    }

    /// Follows moved vertices; faces and edges must be those it was built with.
    ///
    /// Answers stay exact for these edges however far vertices move. But
    /// [`topology::edges`](crate::topology::edges) leaves out edges between
    /// coplanar faces: if a motion can bend such a pair, list the edges again
    /// and build a new tree.
    pub fn refit(&mut self, mesh: &Mesh) {
        let topology = &self.topology;
        self.edges = (&topology.order, &self.sources)
            .into_par_iter()
            .with_min_len(1024)
            .map(|(&id, edge)| TreeEdge::new(mesh, id, edge))
            .collect();
        self.frame = LocalFrame::around(self.edges.iter().flat_map(|edge| edge.ends));
        let local: Vec<LocalEdge> = (&self.edges, &self.sources)
            .into_par_iter()
            .with_min_len(1024)
            .map(|(edge, source)| edge.local(&self.frame, source.groups))
            .collect();
        let edges_of_leaf = |leaf: usize| {
            let [start, end] = [leaf, leaf + 1].map(|i| topology.leaf_starts[i] as usize);
            &local[start..end]
        };
        let (leaves, leaf_bounds): (Vec<_>, Vec<_>) = (0..topology.leaf_count())
            .into_par_iter()
            .with_min_len(256)
            .map(|leaf| {
                let edges = edges_of_leaf(leaf);
                let bounds = Aabb::around(edges.iter().flat_map(|edge| edge.ends));
                (EdgeBlock::new(edges), bounds)
            })
            .unzip();
        let bounds = refit::child_bounds(topology, &leaf_bounds);
        let below = refit::child_leaves(topology);
        self.nodes = (0..topology.nodes.len())
            .into_par_iter()
            .map(|index| {
                let mut node = ConeNode::EMPTY;
                for (slot, &child) in topology.nodes[index].iter().enumerate() {
                    if child.kind().is_none() {
                        continue;
                    }
                    let [start, end] = [below[index][slot].start, below[index][slot].end]
                        .map(|leaf| topology.leaf_starts[leaf as usize] as usize);
                    let edges = &local[start..end];
                    node.set(slot, child, &bounds[index][slot], edges);
                }
                node
            })
            .collect();
        self.leaves = leaves;
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
        self.instructions.run(ClosestWhere {
            tree: self,
            query,
            counts,
        })
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
            if self.leaves[leaf] != EdgeBlock::new(&local) {
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

/// Faces whose computed plane misses their edge by more than this, in local
/// units, are too thin for their normals to be used. Part of the margin of
/// positions.
const EDGE_TILT: f64 = 1.0 / (1 << 24) as f64;

fn frame_of(mesh: &Mesh, edges: &[Edge]) -> LocalFrame {
    let ends = edges.iter().flat_map(|edge| edge.vertices);
    LocalFrame::around(ends.map(|i| mesh.positions[i as usize]))
}

struct Closest<'a> {
    tree: &'a SilhouetteTree,
    query: &'a ConeQuery,
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
        let mut limit = {
            let (sin, cos) = query.max_angle.min(std::f64::consts::PI).sin_cos();
            cone_kernel::pseudo_angle_limit(sin.abs(), cos)
        };
        let mut best: Option<SilhouettePoint> = None;
        let mut stack = Stack::with_root();
        while let Some((bound, child)) = stack.pop() {
            if bound > limit {
                continue;
            }
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, bounds) = cone.children(simd, node, limit);
                    let mut rest = mask;
                    while rest != 0 {
                        let i = rest.trailing_zeros() as usize % 8;
                        rest &= rest - 1;
                        match node.children[i].kind() {
                            Some(ChildKind::Node(index)) => simd.prefetch(&tree.nodes[index]),
                            Some(ChildKind::Leaf(index)) => simd.prefetch(&tree.leaves[index]),
                            None => {}
                        }
                    }
                    stack.push_sorted(mask, &bounds, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    let (mask, bounds) = cone.edges(simd, &tree.leaves[leaf], limit);
                    let start = tree.topology.leaf_starts[leaf] as usize;
                    let mut rest = mask;
                    while rest != 0 {
                        simd.prefetch(
                            &tree.edges[start + rest.trailing_zeros() as usize % LEAF_SIZE],
                        );
                        rest &= rest - 1;
                    }
                    for_each_sorted(mask, &bounds, |lane, bound| {
                        if bound > limit {
                            return;
                        }
                        if let Some(point) = tree.edges[start + lane].closest(query, best.as_ref())
                        {
                            let sin = query.axis.cross(point.direction).length();
                            let cos = query.axis.dot(point.direction);
                            limit = cone_kernel::pseudo_angle_limit(sin, cos);
                            best = Some(point);
                        }
                    });
                }
                None => {}
            }
        }
        best
    }
}
