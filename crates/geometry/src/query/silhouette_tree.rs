//! Closest silhouettes, Algorithm 5.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use capwalk_math::Vec3;
use rayon::prelude::*;

use super::cone_kernel::{self, ConeNode, EdgeBlock, LocalCone, LocalEdge};
use crate::aabb::{Aabb, LocalFrame};
use crate::bvh::validate::{self, TreeError};
use crate::bvh::{Child, ChildKind, Topology, build, refit, traverse::Stack};
use crate::cone::NormalCone;
use crate::edge::{Edge, FacePlane, Sides, closest_direction};
use crate::mesh::Mesh;
use crate::simd::{Instructions, Job, Simd};

/// Edges per leaf: as many as are tested at a time.
const LEAF_SIZE: usize = cone_kernel::LANES;

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
    topology: Topology,
    frame: LocalFrame,
    nodes: Vec<ConeNode>,
    leaves: Vec<EdgeBlock>,
    /// The edges in the order of the leaves.
    edges: Vec<TreeEdge>,
    /// The planes of all faces of the mesh.
    planes: Vec<FacePlane>,
    instructions: Instructions,
}

/// An edge as the tree keeps it.
#[derive(Clone, Copy, Debug)]
struct TreeEdge {
    ends: [Vec3; 2],
    id: u32,
    edge: Edge,
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
        let in_leaf_order = |&id: &u32| TreeEdge {
            ends: [Vec3::zero(); 2],
            id,
            edge: edges[id as usize],
        };
        let mut tree = Self {
            edges: topology.order.iter().map(in_leaf_order).collect(),
            topology,
            frame,
            nodes: Vec::new(),
            leaves: Vec::new(),
            planes: Vec::new(),
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
        for edge in &mut self.edges {
            edge.ends = edge.edge.vertices.map(|i| mesh.positions[i as usize]);
        }
        self.frame = LocalFrame::around(self.edges.iter().flat_map(|edge| edge.ends));
        self.planes = (0..mesh.faces.len() as u32)
            .into_par_iter()
            .with_min_len(1024)
            .map(|face| FacePlane::new(mesh, face))
            .collect();
        // The tolerance of faces_eye also depends on the faces' corners.
        let sum = |p: Vec3| p.x.abs() + p.y.abs() + p.z.abs();
        let corners = self.edges.iter().flat_map(|edge| edge.edge.faces());
        self.frame.reach = corners
            .map(|face| sum(self.planes[face as usize].point))
            .fold(self.frame.reach, f64::max);

        let local: Vec<LocalEdge> = self
            .edges
            .par_iter()
            .with_min_len(1024)
            .map(|edge| self.local_edge(edge))
            .collect();
        let topology = &self.topology;
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
                    let cone = NormalCone::around(|| edges.iter().flat_map(normals));
                    let groups = edges.iter().fold(0, |groups, edge| groups | edge.groups);
                    node.set(slot, child, &bounds[index][slot], &cone, groups);
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
        for leaf in 0..topology.leaf_count() {
            let start = topology.leaf_starts[leaf] as usize;
            let kept = &self.edges[start..start + topology.leaf(leaf).len()];
            for (kept, &id) in kept.iter().zip(topology.leaf(leaf)) {
                let edge = edges[id as usize];
                let ends = edge.vertices.map(|i| mesh.positions[i as usize]);
                if (kept.id, kept.edge, kept.ends) != (id, edge, ends) {
                    let primitive = id as usize;
                    return Err(TreeError::LeafContent { leaf, primitive });
                }
            }
            let local: Vec<_> = kept.iter().map(|edge| self.local_edge(edge)).collect();
            if self.leaves[leaf] != EdgeBlock::new(&local) {
                let primitive = kept[0].id as usize;
                return Err(TreeError::LeafContent { leaf, primitive });
            }
        }
        let place_of = |id: usize| {
            let edge = edges[id];
            let ends = edge.vertices.map(|i| mesh.positions[i as usize]);
            self.local_edge(&TreeEdge {
                ends,
                id: id as u32,
                edge,
            })
        };
        validate::for_each_below(topology, |node, slot, edge| {
            let local = place_of(edge);
            let child = &self.nodes[node];
            if !local.ends.iter().all(|&p| child.contains_point(slot, p)) {
                let primitive = edge;
                return Err(TreeError::Bounds {
                    node,
                    slot,
                    primitive,
                });
            }
            if !normals(&local).all(|normal| child.covers_normal(slot, normal)) {
                return Err(TreeError::NormalCone { node, slot, edge });
            }
            if child.groups(slot) & local.groups != local.groups {
                return Err(TreeError::Groups { node, slot, edge });
            }
            Ok(())
        })
    }

    /// The edge in local coordinates.
    fn local_edge(&self, edge: &TreeEdge) -> LocalEdge {
        let normals = match edge.edge.sides {
            Sides::Open => None,
            Sides::Between { faces, flipped } => {
                let [first, second] = faces.map(|face| self.usable_normal(face, edge.ends));
                let second = second.map(|n| if flipped { -n } else { n });
                first.zip(second).map(|(first, second)| [first, second])
            }
        };
        LocalEdge {
            ends: edge.ends.map(|p| self.frame.local_from_world(p)),
            normals,
            groups: edge.edge.groups,
        }
    }

    /// The unit normal of a face; `None` if the face is degenerate, or so thin
    /// that rounding tilts its normal against its edge: the orientation towards
    /// an eye then depends on where on the face it is measured.
    fn usable_normal(&self, face: u32, ends: [Vec3; 2]) -> Option<Vec3> {
        let plane = &self.planes[face as usize];
        let normal = plane.cross / plane.length;
        let height = |p: Vec3| (p - plane.point).dot(normal).abs() * self.frame.inverse_scale;
        // Written so that NaN is not usable.
        let lies_in_plane = ends.iter().all(|&p| height(p) <= EDGE_TILT);
        lies_in_plane.then_some(normal)
    }

    /// The point of an edge closest to the axis, if the edge is a boundary and
    /// the point nearer than `max_angle`, or as near and `best` a later edge.
    fn closest_on(
        &self,
        edge: &TreeEdge,
        query: &ConeQuery,
        best: Option<&SilhouettePoint>,
    ) -> Option<SilhouettePoint> {
        let is_silhouette = match edge.edge.sides {
            _ if query.edges == EdgeSelection::All => true,
            Sides::Open => true,
            Sides::Between { faces, flipped } => {
                let [first, second] = faces.map(|face| &self.planes[face as usize]);
                first.faces_eye(false, query.eye) != second.faces_eye(flipped, query.eye)
            }
        };
        if !is_silhouette
            || query
                .in_front_of
                .is_some_and(|plane| plane.hides(edge.ends))
        {
            return None;
        }
        let [a, b] = edge.ends.map(|p| p - query.eye);
        let closest = closest_direction(a, b, query.axis)?;
        let is_nearer = match best {
            Some(best) => (closest.angle, edge.id) < (best.angle, best.edge),
            None => closest.angle < query.max_angle,
        };
        is_nearer.then_some(SilhouettePoint {
            edge: edge.id,
            t: closest.t,
            direction: closest.direction,
            distance: closest.distance,
            angle: closest.angle,
        })
    }
}

/// Faces whose computed plane misses their edge by more than this, in local
/// units, are too thin for their normals to be used. Part of the margin of
/// positions.
const EDGE_TILT: f64 = 1.0 / (1 << 24) as f64;

/// The normals of an edge; one `None` if it may be a silhouette whatever the
/// view.
fn normals(edge: &LocalEdge) -> impl Iterator<Item = Option<Vec3>> {
    let [first, second] = match edge.normals {
        Some([first, second]) => [Some(first), Some(second)],
        None => [None, None],
    };
    [first, second].into_iter()
}

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
                    stack.push_sorted(mask, &bounds, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    let (mut mask, bounds) = cone.edges(simd, &tree.leaves[leaf], limit);
                    let start = tree.topology.leaf_starts[leaf] as usize;
                    while mask != 0 {
                        let lane = mask.trailing_zeros() as usize % LEAF_SIZE;
                        mask &= mask - 1;
                        if bounds[lane] > limit {
                            continue;
                        }
                        let edge = &tree.edges[start + lane];
                        if let Some(point) = tree.closest_on(edge, query, best.as_ref()) {
                            let sin = query.axis.cross(point.direction).length();
                            let cos = query.axis.dot(point.direction);
                            limit = cone_kernel::pseudo_angle_limit(sin, cos);
                            best = Some(point);
                        }
                    }
                }
                None => {}
            }
        }
        best
    }
}

/// Best first instead of depth first: what was rejected must not be what
/// decides where to look next, and a depth-first search would look through
/// everything hidden in a subtree before it turned to its neighbour.
struct ClosestWhere<'a, F> {
    tree: &'a SilhouetteTree,
    query: &'a ConeQuery,
    counts: F,
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
                        let edge = &tree.edges[start + lane];
                        if let Some(point) = tree.closest_on(edge, query, None) {
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
