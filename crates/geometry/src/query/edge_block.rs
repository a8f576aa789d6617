//! What the silhouette tree stores of its leaves: eight edges. How they are
//! tested is in `edge_kernel.rs`.

use capwalk_math::Vec3;

use crate::aabb::{Aabb, round_up};

/// Edges in a leaf.
pub const LANES: usize = 8;

/// Up to eight edges, rounded to fixed point: half the memory, which only costs
/// a little of the bounds' tightness.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct EdgeBlock {
    /// Midpoints, less `origin`, in units of `step`.
    pub(super) middle: [[i16; LANES]; 3],
    /// From the midpoints to the second ends, in units of `step`.
    pub(super) half: [[i16; LANES]; 3],
    /// Normals of the two faces, of length [`NORMAL_SCALE`]; zero for edges
    /// that may be silhouettes whatever the view.
    pub(super) normals: [[[i16; LANES]; 3]; 2],
    /// In local coordinates.
    pub(super) origin: [f32; 3],
    /// In local units. The ends are rounded by at most this much on each axis.
    pub(super) step: f32,
    /// Groups; 0 for empty lanes.
    pub(super) groups: [u8; LANES],
    /// The first edge, in the order of the leaves.
    pub(super) start: u32,
    /// A bit for each open edge.
    pub(super) open: u8,
}

/// Length of the normals in a block.
pub(super) const NORMAL_SCALE: f32 = i16::MAX as f32;

/// Error of each component of the normals in a block: half a unit, and what
/// single precision adds.
pub(super) const NORMAL_ERROR: f32 = 0.5 + 1.0 / (1 << 6) as f32;

/// An edge as blocks and nodes see it, in local coordinates.
#[derive(Clone, Copy, Debug)]
pub struct LocalEdge {
    pub ends: [Vec3; 2],
    /// Unit normals of its two faces, towards the same side of the surface;
    /// `None` if it may be a silhouette whatever the view.
    pub normals: Option<[Vec3; 2]>,
    /// True if it is a silhouette whatever the view.
    pub open: bool,
    pub groups: u8,
}

impl LocalEdge {
    /// Its normals; one `None` if it may be a silhouette whatever the view.
    pub fn usable_normals(&self) -> impl Iterator<Item = Option<Vec3>> + use<> {
        let [first, second] = match self.normals {
            Some([first, second]) => [Some(first), Some(second)],
            None => [None, None],
        };
        [first, second].into_iter()
    }
}

impl EdgeBlock {
    /// The block of these edges; `start` is the first one's place among all.
    pub fn new(start: usize, edges: &[LocalEdge]) -> Self {
        let middles = || edges.iter().map(|edge| (edge.ends[0] + edge.ends[1]) * 0.5);
        let bounds = Aabb::around(middles());
        let origin = [0, 1, 2].map(|axis| 0.5 * (bounds.low[axis] + bounds.high[axis]));
        let around = |middle: Vec3| middle - Vec3::from(origin.map(f64::from));
        let halves = edges.iter().map(|edge| (edge.ends[1] - edge.ends[0]) * 0.5);
        let largest = middles()
            .map(around)
            .chain(halves)
            .map(|v| v.map(f64::abs).max_component())
            .fold(f64::from(f32::MIN_POSITIVE), f64::max);
        let step = round_up(largest / f64::from(i16::MAX));
        let mut block = Self {
            middle: [[0; LANES]; 3],
            half: [[0; LANES]; 3],
            normals: [[[0; LANES]; 3]; 2],
            origin,
            step,
            groups: [0; LANES],
            start: start as u32,
            open: 0,
        };
        let fixed = |v: f64| (v / f64::from(step)).round() as i16;
        for (lane, edge) in edges.iter().enumerate() {
            let [a, b] = edge.ends;
            let (middle, half) = (around((a + b) * 0.5), (b - a) * 0.5);
            let normals = edge.normals.unwrap_or([Vec3::zero(); 2]);
            for axis in 0..3 {
                block.middle[axis][lane] = fixed(middle[axis]);
                block.half[axis][lane] = fixed(half[axis]);
                for (face, normal) in normals.iter().enumerate() {
                    let scaled = normal[axis] * f64::from(NORMAL_SCALE);
                    block.normals[face][axis][lane] = scaled.round() as i16;
                }
            }
            block.groups[lane] = edge.groups;
            block.open |= u8::from(edge.open) << lane;
        }
        block
    }
}
