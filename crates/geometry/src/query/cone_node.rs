//! What the silhouette tree stores of its nodes and leaves: bounds of eight
//! children, and eight edges. How they are tested is in `cone_kernel.rs`.

use capwalk_math::Vec3;

use super::cone_kernel::LANES;
use crate::aabb::{Aabb, round_up};
use crate::bvh::{Child, WIDTH};
use crate::cone::NormalCone;
use crate::simd::ESTIMATE_ERROR;

/// What eight children contain, in local coordinates.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub struct ConeNode {
    /// Centres of their boxes.
    pub(super) centre: [[f32; WIDTH]; 3],
    /// Half their side lengths.
    pub(super) half: [[f32; WIDTH]; 3],
    /// Axes of their cones of normals.
    pub(super) axis: [[f32; WIDTH]; 3],
    /// How far the edges reach from the centres along those axes: patches of a
    /// smooth surface are thin that way.
    pub(super) thickness: [f32; WIDTH],
    /// How far they reach in any direction.
    pub(super) radius: [f32; WIDTH],
    /// Squared sines of those cones; infinite for children that can contain a
    /// silhouette whatever the view.
    pub(super) sin_squared: [f32; WIDTH],
    /// `NormalCone::view_margin` of the box.
    pub(super) view_margin: [f32; WIDTH],
    /// The children.
    pub children: [Child; WIDTH],
    /// All groups of the edges below each child; 0 for empty slots.
    pub(super) groups: [u8; WIDTH],
}

/// Relative error of what a node stores in single precision, such as a squared
/// sine: rounding it and what it is compared with.
const STORED_MARGIN: f64 = 1.0 / (1 << 20) as f64;

impl ConeNode {
    /// A node with empty slots only.
    pub const EMPTY: Self = Self {
        centre: [[0.0; WIDTH]; 3],
        half: [[0.0; WIDTH]; 3],
        axis: [[0.0; WIDTH]; 3],
        thickness: [0.0; WIDTH],
        radius: [0.0; WIDTH],
        sin_squared: [0.0; WIDTH],
        view_margin: [0.0; WIDTH],
        children: [Child::NONE; WIDTH],
        groups: [0; WIDTH],
    };

    /// Fills one slot with a child that contains the edges and has the box.
    pub fn set(&mut self, slot: usize, child: Child, bounds: &Aabb, edges: &[LocalEdge]) {
        let cone = NormalCone::around(|| edges.iter().flat_map(LocalEdge::usable_normals));
        for axis in 0..3 {
            let (low, high) = (f64::from(bounds.low[axis]), f64::from(bounds.high[axis]));
            let centre = (0.5 * (low + high)) as f32;
            let reach = (high - f64::from(centre)).max(f64::from(centre) - low);
            self.centre[axis][slot] = centre;
            self.half[axis][slot] = round_up(reach);
            self.axis[axis][slot] = cone.axis[axis] as f32;
        }
        self.sin_squared[slot] = round_up(cone.sin * cone.sin * (1.0 + STORED_MARGIN));
        let [thickness, radius] = self.reach(slot, edges);
        self.thickness[slot] = round_up(thickness);
        self.radius[slot] = round_up(radius * (1.0 + f64::from(ESTIMATE_ERROR)));
        let view_margin = self.view_margin(slot, edges);
        self.view_margin[slot] = round_up(view_margin * (1.0 + STORED_MARGIN));
        self.children[slot] = child;
        self.groups[slot] = edges.iter().fold(0, |groups, edge| groups | edge.groups);
    }

    /// How far the edges reach from the child's centre along the axis of its
    /// cone, and in any direction.
    fn reach(&self, slot: usize, edges: &[LocalEdge]) -> [f64; 2] {
        let at = |v: &[[f32; WIDTH]; 3]| Vec3::from([0, 1, 2].map(|i| f64::from(v[i][slot])));
        let (centre, axis) = (at(&self.centre), at(&self.axis));
        let mut reach = [0.0_f64; 2];
        for end in edges.iter().flat_map(|edge| edge.ends) {
            let around = end - centre;
            reach[0] = reach[0].max(around.dot(axis).abs());
            reach[1] = reach[1].max(around.length());
        }
        reach
    }

    /// `NormalCone::view_margin` of the child's edges around its centre.
    fn view_margin(&self, slot: usize, edges: &[LocalEdge]) -> f64 {
        let at = |v: &[[f32; WIDTH]; 3]| Vec3::from([0, 1, 2].map(|i| f64::from(v[i][slot])));
        let centre = at(&self.centre);
        let mut height = 0.0_f64;
        for edge in edges {
            for normal in edge.usable_normals().flatten() {
                height = height.max((edge.ends[0] - centre).dot(normal).abs());
            }
        }
        let cone = NormalCone {
            axis: at(&self.axis),
            sin: f64::from(self.sin_squared[slot]).sqrt(),
        };
        cone.view_margin(at(&self.half).length(), height)
    }

    /// True if no view is skipped for the child that can see a silhouette of
    /// the edge: the cone contains its normals, and its planes pass the centre
    /// near enough.
    pub fn covers(&self, slot: usize, edge: &LocalEdge) -> bool {
        let sin_squared = f64::from(self.sin_squared[slot]);
        if sin_squared.is_infinite() {
            return true;
        }
        let axis = Vec3::from([0, 1, 2].map(|i| f64::from(self.axis[i][slot])));
        let is_inside = |normal: Vec3| {
            let cross = axis.cross(normal).length() - AXIS_ROUNDING;
            axis.dot(normal) > 0.0 && (cross <= 0.0 || cross * cross <= sin_squared)
        };
        let needed = self.view_margin(slot, std::slice::from_ref(edge));
        let is_within = needed <= f64::from(self.view_margin[slot]);
        is_within
            && edge
                .usable_normals()
                .all(|normal| normal.is_some_and(is_inside))
    }

    /// True if the edge lies in the box of the child, and no farther from its
    /// centre than the child says.
    pub fn contains(&self, slot: usize, edge: &LocalEdge) -> bool {
        let is_inside = |p: &Vec3| {
            (0..3).all(|axis| {
                let (centre, half) = (self.centre[axis][slot], self.half[axis][slot]);
                (p[axis] - f64::from(centre)).abs() <= f64::from(half)
            })
        };
        let [thickness, radius] = self.reach(slot, std::slice::from_ref(edge));
        edge.ends.iter().all(is_inside)
            && thickness <= f64::from(self.thickness[slot])
            && radius <= f64::from(self.radius[slot])
    }

    /// All groups of the edges below a child.
    pub fn groups(&self, slot: usize) -> u8 {
        self.groups[slot]
    }
}

/// Error of a unit vector rounded to single precision.
const AXIS_ROUNDING: f64 = 1.0 / (1 << 23) as f64;

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
}

/// Length of the normals in a block.
pub(super) const NORMAL_SCALE: f32 = i16::MAX as f32;

/// Error of each component of the normals in a block: half a unit, and what
/// single precision adds.
pub(super) const NORMAL_ERROR: f32 = 0.5 + 1.0 / (1 << 6) as f32;

/// An edge as blocks and nodes see it, in local coordinates.
#[derive(Clone, Copy, Debug)]
pub struct LocalEdge {
    /// Its ends.
    pub ends: [Vec3; 2],
    /// Unit normals of its two faces, towards the same side of the surface;
    /// `None` if it may be a silhouette whatever the view.
    pub normals: Option<[Vec3; 2]>,
    /// Its groups.
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
    /// The block of these edges.
    pub fn new(edges: &[LocalEdge]) -> Self {
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
        }
        block
    }
}
