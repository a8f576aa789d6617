//! A tree for sampling edges as flat arrays, for devices with a memory of their own. `EdgeSampler` of
//! `capwalk-boundary` fills the arrays, and descends the same tree on the CPU (METHOD 8).
//!
//! The tree is binary. Node 0 is the root, halves come after what they are halves of. What a node knows of
//! visibility is shares of the edges' length by direction: `8 axis + 4 [vᵢ < 0] + 2 [vᵢ₊₁ < 0] + [vᵢ₊₂ < 0]`
//! for `v` from the centre to the viewpoint, `i` being the first of its largest axes.

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
