//! What the silhouette tree stores of its nodes: bounds of eight children. How
//! they are tested is in `cone_kernel.rs`.

use capwalk_math::Vec3;

use super::edge_block::LocalEdge;
use super::oriented_box::{Axes, OrientedBox};
use crate::aabb::round_up;
use crate::bvh::{Child, WIDTH};
use crate::cone::NormalCone;

/// What eight children contain, in local coordinates, rounded to fixed point:
/// four cache lines. Queries visit dozens of nodes, and wait for memory.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct ConeNode {
    /// Where the centres are measured from.
    pub(super) origin: [f32; 3],
    /// The unit of lengths below.
    pub(super) step: f32,
    /// Centres of the boxes, less `origin`.
    pub(super) centre: [[i16; WIDTH]; 3],
    /// Half the extents of the boxes along their axes.
    pub(super) half: [[i16; WIDTH]; 3],
    /// First axes of the boxes, as in [`Axes`]; those of the cones of normals
    /// where there are such cones: patches of a smooth surface are thin that
    /// way.
    pub(super) first: [[i16; WIDTH]; 3],
    /// Second axes.
    pub(super) second: [[i8; WIDTH]; 3],
    /// Sines of the cones in units of [`SIN_STEP`]; [`NO_CONE`] for children
    /// that can contain a silhouette whatever the view.
    pub(super) sin: [i16; WIDTH],
    /// `NormalCone::view_margin` of the box.
    pub(super) view_margin: [i16; WIDTH],
    /// In the order of the bounds.
    pub children: [Child; WIDTH],
    /// All groups of the edges below each child; 0 for empty slots.
    pub(super) groups: [u8; WIDTH],
}

/// Unit of sines in a node.
pub(super) const SIN_STEP: f32 = 1.0 / 32000.0;

/// A "sine" for children without a cone: 1.024. No view is clear of that,
/// whatever the rounding.
const NO_CONE: i16 = i16::MAX;

/// One child before rounding.
struct Bounds {
    tight: OrientedBox,
    /// Sine of the cone of normals around the first axis; `None` if there is no
    /// such cone.
    sin: Option<f64>,
}

impl Bounds {
    fn around(edges: &[LocalEdge]) -> Self {
        let cone = NormalCone::around(|| edges.iter().flat_map(LocalEdge::usable_normals));
        if cone == NormalCone::ALL {
            return Self {
                tight: OrientedBox::around(edges),
                sin: None,
            };
        }
        let tight = OrientedBox::along(cone.axis, edges);
        let axis = tight.axes.first().normalized();
        let mut normals = edges.iter().flat_map(LocalEdge::usable_normals).flatten();
        // `NormalCone::around` again, for the axis as it was rounded.
        let sin = normals.try_fold(0.0_f64, |sin, normal| {
            let is_within_right_angle = axis.dot(normal) > 0.0;
            is_within_right_angle.then(|| sin.max(axis.cross(normal).length()))
        });
        Self { tight, sin }
    }
}

impl ConeNode {
    /// A node with these children, of which each contains the edges `below` it.
    pub fn new<'a>(children: &[Child; WIDTH], below: impl Fn(usize) -> &'a [LocalEdge]) -> Self {
        let bounds: [Option<Bounds>; WIDTH] = std::array::from_fn(|slot| {
            let is_used = children[slot].kind().is_some();
            is_used.then(|| Bounds::around(below(slot)))
        });
        let used = || bounds.iter().flatten();
        let start = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        let (low, high) = used().fold(start, |(low, high), child| {
            (low.min(child.tight.centre), high.max(child.tight.centre))
        });
        let origin = ((low + high) * 0.5).to_array().map(|v| v as f32);
        let around = |centre: Vec3| centre - Vec3::from(origin.map(f64::from));
        let largest = used()
            .flat_map(|child| {
                let centre = around(child.tight.centre).map(f64::abs).max_component();
                let [x, y, z] = child.tight.half;
                [centre, x, y, z]
            })
            .fold(f64::from(f32::MIN_POSITIVE), f64::max);
        let mut node = Self {
            origin,
            // With a margin for what is added for the rounding of centres.
            step: round_up(largest / f64::from(i16::MAX - 8)),
            centre: [[0; WIDTH]; 3],
            half: [[0; WIDTH]; 3],
            first: [[0; WIDTH]; 3],
            second: [[0; WIDTH]; 3],
            sin: [0; WIDTH],
            view_margin: [0; WIDTH],
            children: *children,
            groups: [0; WIDTH],
        };
        for (slot, bounds) in bounds.iter().enumerate() {
            if let Some(bounds) = bounds {
                node.set(slot, bounds, around(bounds.tight.centre), below(slot));
            }
        }
        node
    }

    fn set(&mut self, slot: usize, bounds: &Bounds, centre: Vec3, edges: &[LocalEdge]) {
        let step = f64::from(self.step);
        // One step more than needed, for the rounding of all this.
        let up = |v: f64| (v / step).ceil() + 1.0;
        let rounded = centre.map(|v| (v / step).round());
        let shift = centre - rounded * step;
        let axes = &bounds.tight.axes;
        let duals = axes.duals();
        for i in 0..3 {
            let half = bounds.tight.half[i] + duals[i].dot(shift).abs();
            self.centre[i][slot] = rounded[i] as i16;
            self.half[i][slot] = up(half) as i16;
            self.first[i][slot] = axes.first[i];
            self.second[i][slot] = axes.second[i];
        }
        self.groups[slot] = edges.iter().fold(0, |groups, edge| groups | edge.groups);
        self.sin[slot] = match bounds.sin {
            Some(sin) => (sin / f64::from(SIN_STEP)).ceil() as i16 + 1,
            None => NO_CONE,
        };
        if self.cone(slot).is_some() {
            let view_margin = up(self.needed_view_margin(slot, edges));
            if view_margin <= f64::from(i16::MAX) {
                self.view_margin[slot] = view_margin as i16;
            } else {
                self.sin[slot] = NO_CONE;
            }
        }
    }

    fn centre(&self, slot: usize) -> Vec3 {
        let step = f64::from(self.step);
        let centre = |i: usize| f64::from(self.origin[i]) + f64::from(self.centre[i][slot]) * step;
        Vec3::from([0, 1, 2].map(centre))
    }

    fn axes(&self, slot: usize) -> Axes {
        Axes {
            first: [0, 1, 2].map(|i| self.first[i][slot]),
            second: [0, 1, 2].map(|i| self.second[i][slot]),
        }
    }

    /// The cone of normals as stored. Its axis is that of the test up to the
    /// length: a little shorter there, which errs to the side of caution.
    fn cone(&self, slot: usize) -> Option<NormalCone> {
        (self.sin[slot] != NO_CONE).then(|| NormalCone {
            axis: self.axes(slot).first().normalized(),
            sin: f64::from(self.sin[slot]) * f64::from(SIN_STEP),
        })
    }

    /// `NormalCone::view_margin` of the edges around the child's centre.
    fn needed_view_margin(&self, slot: usize, edges: &[LocalEdge]) -> f64 {
        let Some(cone) = self.cone(slot) else {
            return 0.0;
        };
        let centre = self.centre(slot);
        let (mut radius_squared, mut height) = (0.0_f64, 0.0_f64);
        for edge in edges {
            for end in edge.ends {
                radius_squared = radius_squared.max((end - centre).length_squared());
            }
            for normal in edge.usable_normals().flatten() {
                height = height.max((edge.ends[0] - centre).dot(normal).abs());
            }
        }
        cone.view_margin(radius_squared.sqrt(), height)
    }
}

/// What holds for every node.
#[cfg(test)]
impl ConeNode {
    /// True if no view is skipped for the child that can see a silhouette of
    /// the edge: the cone contains its normals, and its planes pass the centre
    /// near enough.
    pub fn covers(&self, slot: usize, edge: &LocalEdge) -> bool {
        let Some(cone) = self.cone(slot) else {
            return true;
        };
        let is_inside = |normal: Vec3| {
            cone.axis.dot(normal) > 0.0 && cone.axis.cross(normal).length() <= cone.sin
        };
        let needed = self.needed_view_margin(slot, std::slice::from_ref(edge));
        let is_within = needed <= f64::from(self.view_margin[slot]) * f64::from(self.step);
        is_within
            && edge
                .usable_normals()
                .all(|normal| normal.is_some_and(is_inside))
    }

    /// True if the edge lies in the box of the child.
    pub fn contains(&self, slot: usize, edge: &LocalEdge) -> bool {
        let (centre, duals) = (self.centre(slot), self.axes(slot).duals());
        edge.ends.iter().all(|&end| {
            (0..3).all(|i| {
                let half = f64::from(self.half[i][slot]) * f64::from(self.step);
                duals[i].dot(end - centre).abs() <= half
            })
        })
    }

    /// All groups of the edges below a child.
    pub fn groups(&self, slot: usize) -> u8 {
        self.groups[slot]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four cache lines: this is what the fixed point is for.
    #[test]
    fn size() {
        assert_eq!(size_of::<ConeNode>(), 256);
    }
}
