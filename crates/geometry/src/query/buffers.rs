//! Both trees as flat arrays, for devices with a memory of their own.
//!
//! # What is in them
//!
//! A tree is a list of nodes with eight children each. Node 0 is the root, children come
//! after their parents, and slots in use come first. A child is one word ([`NONE`], or
//! [`LEAF`] and the number of a leaf, or the number of a node); leaf `i` has the
//! primitives `leaf_starts[i]..leaf_starts[i + 1]`. Without primitives there are no nodes.
//! What is below a child is consecutive: slot `s` of node `n` has the primitives
//! `below[i]..below[i + 1]` with `i = 2 (8 n + s)`, none if it is empty.
//!
//! Bounds are in single precision and in the coordinates of the tree's frame: `(p -
//! frame.centre) * frame.inverse_scale`, all between -1 and 1. They are rounded outward,
//! so they contain what is below them exactly, but whoever tests them in single precision
//! needs margins for the rounding of the query and of the test itself.
//!
//! Primitives are in double precision and in world coordinates: the numbers that brute
//! force reads. The functions that decide what is found are
//! [`intersect_triangle`](crate::ray::intersect_triangle),
//! [`separates`](crate::edge::separates) and
//! [`closest_direction`](crate::edge::closest_direction); done operation by operation with
//! these numbers, tests of triangles and edges are exactly those of the CPU. For devices
//! without double precision, [`local_triangles`](RayBuffers::local_triangles) and
//! [`local_edges`](SilhouetteBuffers::local_edges) give them in the frame's coordinates,
//! rounded once: a corner, an end and a vector are off by at most 2⁻²⁴ per axis.
//!
//! A tree that was refitted has new bounds in `nodes`, new coordinates in `triangles` or
//! `ends_and_normals`, and a new frame; all else stays. So whoever has the vertices of the
//! primitives can refit the arrays by itself: the frame is [`LocalFrame::around`] the corners
//! of the triangles or the ends of the edges, and bounds may be looser than a tree's own.

use capwalk_math::Vec3;

use super::cone_node::{ConeNode, SIN_STEP};
use super::oriented_box::{FIRST_SCALE, SECOND_SCALE};
use super::ray_tree::RayTree;
use super::silhouette_tree::SilhouetteTree;
use crate::bvh::{Child, Hierarchy, MAX_DEPTH, WIDTH, child_leaves};
use crate::edge::{Edge, Sides};
use crate::local_frame::LocalFrame;

/// An empty slot of a node.
pub const NONE: u32 = u32::MAX;
/// The bit of children that are leaves; the others hold the leaf's number.
pub const LEAF: u32 = 1 << 31;

/// Ways from the root to a leaf pass no more nodes than this.
pub const LEVELS: usize = MAX_DEPTH;
/// Words per node of [`RayBuffers::nodes`].
pub const RAY_NODE: usize = 7 * WIDTH;
/// Numbers per triangle.
pub const TRIANGLE: usize = 9;
/// Words per node of [`SilhouetteBuffers::nodes`].
pub const CONE_NODE: usize = CONE_CHILD * WIDTH;
/// Words per child there.
const CONE_CHILD: usize = 16;
/// Numbers per edge.
pub const EDGE: usize = 14;
/// The bit of an edge's second face whose normal counts reversed.
pub const FLIPPED: u32 = 1 << 31;

/// The tree of triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct RayBuffers {
    /// The coordinates of the nodes.
    pub frame: LocalFrame,
    /// [`RAY_NODE`] words per node: bits of `f32`, eight low x, eight low y, low z, high x,
    /// high y, high z, then eight children. Empty slots have infinite bounds, low > high.
    pub nodes: Vec<u32>,
    /// Where the primitives of each leaf start, and at last where they all end.
    pub leaf_starts: Vec<u32>,
    /// What is below each child: two words each, the first primitive and the one after the
    /// last.
    pub below: Vec<u32>,
    /// The number of each triangle in the mesh.
    pub faces: Vec<u32>,
    /// [`TRIANGLE`] numbers each: three corners, in world coordinates.
    pub triangles: Vec<f64>,
}

impl RayBuffers {
    /// The triangles in the frame's coordinates. Equal corners stay equal, so that
    /// neighbours still share their edges.
    pub fn local_triangles(&self) -> Vec<f32> {
        let corners = self.triangles.as_chunks::<3>().0;
        let local = corners.iter().map(|&p| local(&self.frame, p));
        local.flat_map(single).collect()
    }
}

impl RayTree {
    /// The tree as flat arrays. After a refit they have the same order, unless they were not asked for
    /// before.
    pub fn buffers(&self) -> RayBuffers {
        let Self {
            flat, hierarchy, ..
        } = self.without_spheres();
        let nodes = flat.nodes.iter().flat_map(|node| {
            let planes = node.planes.iter().flatten().flatten();
            let planes = planes.map(|plane| plane.to_bits());
            planes.chain(children(&node.children))
        });
        let leaves = flat.leaves.iter().enumerate();
        let triangles = leaves.flat_map(|(leaf, block)| {
            let lanes = 0..hierarchy.leaf(leaf).len();
            lanes.flat_map(|lane| block.corners_of(lane))
        });
        RayBuffers {
            frame: flat.frame,
            nodes: nodes.collect(),
            leaf_starts: hierarchy.leaf_starts.clone(),
            below: below(hierarchy),
            faces: hierarchy.order.clone(),
            triangles: triangles.flat_map(Vec3::to_array).collect(),
        }
    }
}

/// The tree of edges.
#[derive(Clone, Debug, PartialEq)]
pub struct SilhouetteBuffers {
    /// The coordinates of the nodes.
    pub frame: LocalFrame,
    /// [`CONE_NODE`] words per node: the first row of each of eight children, then the second
    /// row of each, and so on. A child has four rows of four words, bits of `f32` but for the
    /// last two:
    ///
    /// ```text
    /// centre x y z   sine of the cone of normals around the first axis
    /// first axis     half the extent along it
    /// second axis    half the extent along it
    /// view margin    half the extent along first × second   child   groups
    /// ```
    ///
    /// The box of a child is `centre + Σ xᵢ axisᵢ` with `|xᵢ|` at most the extents, for the
    /// axes as they are, which are orthogonal and of unit length only to within 1 %. From a
    /// viewpoint at `v` from the centre, no edge below the child is a silhouette if
    /// `|first · v| - view margin > sine |v|`; a sine above 1 stands for no such cone. An
    /// edge has groups of which the child has all.
    pub nodes: Vec<u32>,
    /// Where the primitives of each leaf start, and at last where they all end.
    pub leaf_starts: Vec<u32>,
    /// What is below each child: two words each, the first primitive and the one after the
    /// last.
    pub below: Vec<u32>,
    /// Two words per edge: its number in the list that the tree was built with, and its
    /// groups.
    pub edges: Vec<u32>,
    /// Four words per edge: the vertices at its ends and the faces on its sides, numbers in
    /// the mesh. The second face has the bit [`FLIPPED`] if its normal counts reversed; open
    /// edges have [`NONE`] twice.
    pub sides: Vec<u32>,
    /// [`EDGE`] numbers each: both ends in world coordinates, `Mesh::face_cross` of the two
    /// faces, towards the same side of the surface, and the lengths of these. The normals
    /// of open edges are zero, which `separates` takes for edges that are silhouettes
    /// whatever the view.
    pub ends_and_normals: Vec<f64>,
}

impl SilhouetteBuffers {
    /// The edges in the frame's coordinates: an end, the vector to the other one, unit
    /// normals (zero for open edges) and their lengths. As two ends, edges would lose their
    /// direction where they are short.
    pub fn local_edges(&self) -> Vec<f32> {
        let edges = self.ends_and_normals.as_chunks::<EDGE>().0;
        edges
            .iter()
            .flat_map(|edge| local_edge(&self.frame, edge))
            .collect()
    }
}

impl SilhouetteTree {
    /// The tree as flat arrays.
    pub fn buffers(&self) -> SilhouetteBuffers {
        let rows = |node: &ConeNode| {
            let slots: [_; WIDTH] = std::array::from_fn(|slot| cone_child(node, slot));
            (0..4).flat_map(move |row| slots.map(|child| child.as_chunks::<4>().0[row]))
        };
        let edges = self.edges.iter().zip(&self.sources);
        let numbers = self.edges.iter().flat_map(|edge| {
            let [first, second] = edge.outward_crosses();
            let [a, b] = edge.ends;
            let vectors = [a, b, first, second].map(Vec3::to_array);
            let lengths = [first.length(), second.length()];
            vectors.into_iter().flatten().chain(lengths)
        });
        SilhouetteBuffers {
            frame: self.frame,
            nodes: self.nodes.iter().flat_map(rows).flatten().collect(),
            leaf_starts: self.hierarchy.leaf_starts.clone(),
            below: below(&self.hierarchy),
            edges: edges
                .flat_map(|(edge, source)| [edge.id, u32::from(source.groups)])
                .collect(),
            sides: self.sources.iter().flat_map(sides_of).collect(),
            ends_and_normals: numbers.collect(),
        }
    }
}

/// The words of a child, as [`SilhouetteBuffers::nodes`] has them.
fn cone_child(node: &ConeNode, slot: usize) -> [u32; CONE_CHILD] {
    let child = children(&[node.children[slot]])[0];
    if child == NONE {
        let mut empty = [0; CONE_CHILD];
        empty[14] = NONE;
        return empty;
    }
    let step = f64::from(node.step);
    let [centre, half] =
        [&node.centre, &node.half].map(|v| v.map(|axis| f64::from(axis[slot]) * step));
    // All these are products of two numbers of 16 bits or so and `step`: rounding them once
    // more is what kernels have margins for.
    let first = node.first.map(|axis| f32::from(axis[slot]) / FIRST_SCALE);
    let second = node.second.map(|axis| f32::from(axis[slot]) / SECOND_SCALE);
    let centre = [0, 1, 2].map(|i| (f64::from(node.origin[i]) + centre[i]) as f32);
    let half = half.map(|v| v as f32);
    let sin = f32::from(node.sin[slot]) * SIN_STEP;
    let view_margin = (f64::from(node.view_margin[slot]) * step) as f32;
    let rows = [
        [centre[0], centre[1], centre[2], sin],
        [first[0], first[1], first[2], half[0]],
        [second[0], second[1], second[2], half[1]],
    ];
    let mut words = [0; CONE_CHILD];
    for (word, number) in words.iter_mut().zip(rows.into_iter().flatten()) {
        *word = number.to_bits();
    }
    words[12..].copy_from_slice(&[
        view_margin.to_bits(),
        half[2].to_bits(),
        child,
        u32::from(node.groups[slot]),
    ]);
    words
}

/// The numbers of an edge in the frame's coordinates.
fn local_edge(frame: &LocalFrame, edge: &[f64; EDGE]) -> [f32; EDGE] {
    let vector = |at: usize| Vec3::new(edge[at], edge[at + 1], edge[at + 2]);
    let [a, b, first, second] = [0, 3, 6, 9].map(vector);
    let along = (b - a) * frame.inverse_scale;
    let normals = [first, second].map(|cross| {
        let normal = cross.normalized();
        if normal.is_finite() {
            normal
        } else {
            Vec3::zero()
        }
    });
    let parts = [frame.local_from_world(a), along, normals[0], normals[1]];
    let mut numbers = [0.0; EDGE];
    for (numbers, part) in numbers.chunks_exact_mut(3).zip(parts) {
        numbers.copy_from_slice(&single(part));
    }
    for (length, normal) in numbers[12..].iter_mut().zip(normals) {
        *length = if normal == Vec3::zero() { 0.0 } else { 1.0 };
    }
    numbers
}

/// The words of an edge in [`SilhouetteBuffers::sides`].
fn sides_of(edge: &Edge) -> [u32; 4] {
    let [a, b] = edge.vertices;
    match edge.sides {
        Sides::Open => [a, b, NONE, NONE],
        Sides::Between { faces, flipped } => {
            let [first, second] = faces;
            [a, b, first, second | if flipped { FLIPPED } else { 0 }]
        }
    }
}

/// The primitives below each child.
fn below(hierarchy: &Hierarchy) -> Vec<u32> {
    let leaves = child_leaves(hierarchy).into_iter().flatten();
    let starts = leaves.flat_map(|leaves| [leaves.start, leaves.end]);
    starts
        .map(|leaf| hierarchy.leaf_starts[leaf as usize])
        .collect()
}

/// Children as words.
fn children<const N: usize>(children: &[Child; N]) -> [u32; N] {
    children.map(Child::bits)
}

fn local(frame: &LocalFrame, [x, y, z]: [f64; 3]) -> Vec3 {
    frame.local_from_world(Vec3::new(x, y, z))
}

fn single(v: Vec3) -> [f32; 3] {
    v.to_array().map(|v| v as f32)
}
