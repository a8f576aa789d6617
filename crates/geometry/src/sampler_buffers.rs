//! A tree for sampling edges as flat arrays, for devices with a memory of their own, and what
//! is asked of it. `EdgeSampler` of `capwalk-boundary` fills the arrays, and answers the same
//! on the CPU.
//!
//! # Nodes
//!
//! The tree is binary. Node 0 is the root, halves come after what they are halves of. A node
//! is chosen among two in proportion to its importance, which is zero where certainly none of
//! its edges counts as seen from the apex, or none meets the cone, and else
//!
//! ```text
//! length · share / max(|offset|², radius²),   offset = centre - apex
//! ```
//!
//! where the share is 1 up to the distance `reach` from the centre, and beyond it that of the
//! direction: `8 axis + 4 [vᵢ < 0] + 2 [vᵢ₊₁ < 0] + [vᵢ₊₂ < 0]` for `v = -offset`, `i` being
//! the first of its largest axes. No edge counts if only silhouettes do and `|axis · offset| >
//! sine |offset| + k + clear`, with [`NormalCone::view_margin`](crate::NormalCone::view_margin)
//! `k` for a radius and a height that are larger by `clear`: a part of the size of all
//! coordinates that is more than what rounding adds up to.
//!
//! # Edges
//!
//! In a leaf, edges have the weight `factor · length / (|a|² + |b|²)`, with the ends as seen
//! from the apex; zero for those that do not meet the cone. The factor is the first one if the
//! edge is a silhouette, and else the second.
//!
//! # Random numbers
//!
//! The first number chooses the leaf. In double precision it is rescaled at each step within the
//! half that it chose, so that it is uniform again. In single precision there are not enough
//! digits, and its 64 bits are hashed for each step. The second number chooses an edge in the
//! same way: one after the other, each is taken instead of those before it by its share of the
//! sum so far.

use std::f64::consts::PI;

use capwalk_math::Vec3;

use crate::local_frame::LocalFrame;
use crate::query::buffers::local_edge;

pub use crate::query::buffers::{EDGE, NONE};

/// Words of a node.
pub const NODE: usize = 4;
/// Numbers of its bounds.
pub const BOUNDS: usize = 12 + DIRECTIONS;
/// Factors of an edge.
pub const FACTORS: usize = 2;
/// Directions of which shares are known.
pub const DIRECTIONS: usize = 24;

/// What rounding adds up to less than, per unit of the size of coordinates, in double precision:
/// ten times the tolerance within which a viewpoint counts as lying in a plane.
pub const CLEAR: f64 = 1e-10;

/// The tree.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplerBuffers {
    /// Coordinates between -1 and 1, for devices without double precision.
    pub frame: LocalFrame,
    /// True if other edges than silhouettes count as well.
    pub all_edges: bool,
    /// [`NODE`] words each: both halves ([`NONE`] in a leaf), the first edge and the one after
    /// the last.
    pub nodes: Vec<u32>,
    /// [`BOUNDS`] numbers each: the centre of a ball around the edges and its radius, the axis
    /// of the cone of normals, its sine (2 if there is none) and cosine, the distance within
    /// which planes of faces pass the centre, length, reach, and shares. World coordinates.
    pub bounds: Vec<f64>,
    /// The number of each edge.
    pub edges: Vec<u32>,
    /// [`EDGE`] numbers each, as in
    /// [`SilhouetteBuffers`](crate::buffers::SilhouetteBuffers::ends_and_normals).
    pub ends_and_normals: Vec<f64>,
    /// [`FACTORS`] each: as a silhouette, and where it is none.
    pub factors: Vec<f64>,
}

impl SamplerBuffers {
    /// True if all numbers name what is there, and halves come after what they are halves of.
    pub fn is_whole(&self) -> bool {
        let (nodes, edges) = (self.nodes.as_chunks::<NODE>().0, self.edges.len());
        let is_right = |(i, &[first, second, start, end]): (usize, &[u32; NODE])| {
            let is_behind = |half: u32| (i + 1..nodes.len()).contains(&(half as usize));
            let has_halves = is_behind(first) && is_behind(second);
            (has_halves || [first, second] == [NONE; 2]) && start <= end && end as usize <= edges
        };
        nodes.iter().enumerate().all(is_right)
            && self.nodes.len() == NODE * nodes.len()
            && self.bounds.len() == BOUNDS * nodes.len()
            && self.ends_and_normals.len() == EDGE * edges
            && self.factors.len() == FACTORS * edges
    }

    /// The bounds in the frame's coordinates.
    pub fn local_bounds(&self) -> Vec<f32> {
        let nodes = self.bounds.as_chunks::<BOUNDS>().0.iter();
        let local = nodes.flat_map(|&bounds| {
            let mut local = bounds;
            let [x, y, z, ..] = bounds;
            let centre = self.frame.local_from_world(Vec3::new(x, y, z));
            local[..3].copy_from_slice(&centre.to_array());
            for length in [3, 9, 10, 11] {
                local[length] *= self.frame.inverse_scale;
            }
            local
        });
        local.map(|number| number as f32).collect()
    }

    /// The edges in the frame's coordinates, as
    /// [`local_edges`](crate::buffers::SilhouetteBuffers::local_edges).
    pub fn local_edges(&self) -> Vec<f32> {
        let edges = self.ends_and_normals.as_chunks::<EDGE>().0;
        let local = edges.iter().map(|edge| local_edge(&self.frame, edge));
        local.flatten().collect()
    }
}

/// A cone in which an edge is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeCone {
    /// The viewpoint, world units.
    pub apex: Vec3,
    /// Unit vector.
    pub axis: Vec3,
    /// Half-angle, radians; all directions from π on, none unless above 0.
    pub max_angle: f64,
    /// Uniform in `[0, 1)`: what chooses the leaf, and the edge in it.
    pub numbers: [f64; 2],
}

impl EdgeCone {
    /// Sine and cosine of the half-angle, or of π if that is less.
    pub fn sin_cos(&self) -> [f64; 2] {
        match self.max_angle >= PI {
            true => [0.0, -1.0],
            false => self.max_angle.sin_cos().into(),
        }
    }
}

/// An edge sampled in a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnEdge {
    /// Its number.
    pub edge: u32,
    /// With which probability the numbers choose it; above 0.
    pub probability: f64,
}
