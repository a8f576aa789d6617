//! A view cone against the eight children of a node, and against the eight
//! edges of a leaf: which can contain a boundary, and no nearer than where.
//!
//! Angles are compared by a number that is cheaper, and as precise near zero:
//! for a point at height `z` along the axis and at distance `ρ` from it,
//!
//!   ρ / (ρ + z) in front of the eye, 1 + |z| / (ρ + |z|) behind it,
//!
//! which grows with the angle, from 0 over 1 at a right angle to 2 at π.

use capwalk_math::{Frame, Vec3};

use super::cone_node::{ConeNode, EdgeBlock, NORMAL_ERROR, NORMAL_SCALE};
use super::silhouette_tree::{ConeQuery, EdgeSelection};
use crate::aabb::{LocalFrame, round_up};
use crate::bvh::WIDTH;
use crate::edge::ON_PLANE;
use crate::simd::{ESTIMATE_ERROR, F32x8, Lanes, Simd};

/// Edges in a leaf.
pub const LANES: usize = 8;

/// The number that stands for an angle in comparisons, rounded up by more than
/// the rounding of both. `sin` and `cos` of the angle.
#[inline]
pub fn pseudo_angle_limit(sin: f64, cos: f64) -> f32 {
    let total = sin + cos.abs();
    let pseudo = if cos >= 0.0 {
        sin / total
    } else {
        1.0 - cos / total
    };
    // Bounds are compared with `>` after rounding down by as much.
    round_up(pseudo)
}

/// A plane in local coordinates, unit normal `n`: in front is `n·p >= offset`.
#[derive(Clone, Copy)]
struct LocalPlane {
    normal: [f32; 3],
    /// `offset`, less a margin for rounding.
    offset: f32,
}

/// Error of positions in local coordinates, and of what is computed from them,
/// per local unit of distance from the eye. The numbers compared are sums of
/// some thirty terms of at most that size, each rounded by at most 2⁻²⁴.
const POSITION_MARGIN: f64 = 1.0 / (1 << 19) as f64;

/// Margins of positions aside, a bound of an angle is off by at most the errors
/// of two estimates, and a few roundings that are much smaller.
const BOUND_SHRINK: f32 = 1.0 - 2.5 * ESTIMATE_ERROR;

/// Error of the difference of two squares of components of a vector, relative
/// to its squared length: some ten roundings.
const SQUARES_MARGIN: f32 = 1.0 / (1 << 19) as f32;

/// A view cone in the coordinates of a tree.
pub struct LocalCone<S: Simd> {
    eye: [S::F32x8; 3],
    axis: [S::F32x8; 3],
    /// Two unit vectors that complete the axis to a frame.
    across: [[S::F32x8; 3]; 2],
    /// Error of positions.
    margin: S::F32x8,
    /// Distance from a face's plane below which the eye may count as in it.
    plane_margin: S::F32x8,
    /// Whether all edges count, silhouettes or not.
    all_edges: bool,
    groups: u8,
    in_front_of: Option<LocalPlane>,
}

impl<S: Simd> LocalCone<S> {
    /// The cone of a query.
    #[inline(always)]
    pub fn new(simd: S, frame: &LocalFrame, query: &ConeQuery) -> Self {
        let sum = |p: Vec3| p.x.abs() + p.y.abs() + p.z.abs();
        let eye = frame.local_from_world(query.eye);
        // Everything in the tree is nearer to the eye than this.
        let range = sum(eye) + 3.0;
        let margin = POSITION_MARGIN * range;
        let on_plane = ON_PLANE * (sum(query.eye) + frame.reach) * frame.inverse_scale;
        let axis = query.axis;
        let Frame { s, t, .. } = Frame::from_normal(axis);
        let in_front_of = query.in_front_of.map(|plane| {
            let normal = plane.normal.normalized();
            let offset = frame.local_from_world(plane.point).dot(normal);
            LocalPlane {
                normal: [normal.x as f32, normal.y as f32, normal.z as f32],
                offset: (offset - POSITION_MARGIN * (offset.abs() + 3.0)) as f32,
            }
        });
        Self {
            eye: splat(simd, [eye.x as f32, eye.y as f32, eye.z as f32]),
            axis: splat(simd, [axis.x as f32, axis.y as f32, axis.z as f32]),
            across: [
                splat(simd, [s.x as f32, s.y as f32, s.z as f32]),
                splat(simd, [t.x as f32, t.y as f32, t.z as f32]),
            ],
            margin: simd.splat(round_up(margin)),
            // Twice: the test in double precision rounds, too.
            plane_margin: simd.splat(round_up(margin + 2.0 * on_plane)),
            all_edges: query.edges == EdgeSelection::All,
            groups: query.groups,
            in_front_of,
        }
    }

    /// Which children may contain a boundary at a pseudo-angle up to `limit`,
    /// and lower bounds of their pseudo-angles.
    #[inline(always)]
    pub fn children(&self, simd: S, node: &ConeNode, limit: f32) -> (u32, [f32; WIDTH]) {
        let mut mask = groups_mask(&node.groups, self.groups);
        let centre = load(simd, &node.centre);
        let half = load(simd, &node.half);
        let view = sub(centre, self.eye);
        let z = dot(self.axis, view);
        let radial = reject(view, self.axis, z);
        let radial_squared = dot(radial, radial);
        // The box reaches this far from its centre along the axis, and away
        // from the axis (times the distance).
        let z_reach = dot(abs(self.axis), half);
        let normal = load(simd, &node.axis);
        let radial_reach = {
            let by_box = dot(abs(radial), half);
            // Thin along the normal, and within a sphere: the reach along both
            // parts of the radial direction, the larger one rounded up.
            let along = dot(normal, radial);
            let across_squared = radial_squared * simd.splat(1.0 + SQUARES_MARGIN) - along * along;
            let across_squared = across_squared.max(simd.splat(f32::MIN_POSITIVE));
            let across = across_squared * across_squared.rsqrt_estimate();
            let by_slab = along.abs() * simd.load(&node.thickness);
            by_box.min(across.mul_add(simd.load(&node.radius), by_slab))
        };
        let reach = half[0] + half[1] + half[2];
        let bound = pseudo_angle(
            simd,
            self.margin,
            z,
            radial_squared,
            z_reach,
            radial_reach,
            reach,
        );
        mask &= bound.le(simd.splat(limit));
        if !self.all_edges {
            // No silhouettes if |axis·v| > sin |v| + k (NormalCone).
            let towards = dot(normal, view).abs();
            let clearance = towards - simd.load(&node.view_margin) - self.plane_margin;
            let distance_squared = dot(view, view);
            let sin_squared = simd.load(&node.sin_squared);
            let is_clear = simd.splat(0.0).lt(clearance)
                & (sin_squared * distance_squared).lt(clearance * clearance);
            mask &= !is_clear;
        }
        if let Some(plane) = self.in_front_of {
            let normal = splat(simd, plane.normal);
            let nearest = dot(normal, centre) + dot(abs(normal), half);
            mask &= !nearest.lt(simd.splat(plane.offset));
        }
        (mask, bound.to_array())
    }

    /// Which edges may be boundaries at a pseudo-angle up to `limit`, and lower
    /// bounds of their pseudo-angles.
    #[inline(always)]
    pub fn edges(&self, simd: S, block: &EdgeBlock, limit: f32) -> (u32, [f32; LANES]) {
        let mut mask = groups_mask(&block.groups, self.groups);
        let step = simd.splat(block.step);
        let base = sub(splat(simd, block.origin), self.eye);
        let middle = load_i16(simd, &block.middle);
        let view = [
            middle[0].mul_add(step, base[0]),
            middle[1].mul_add(step, base[1]),
            middle[2].mul_add(step, base[2]),
        ];
        // Both ends are rounded by a step on each axis.
        let margin = self.margin + simd.splat(2.0) * step;
        if !self.all_edges {
            let first = dot(load_i16(simd, &block.normals[0]), view);
            let second = dot(load_i16(simd, &block.normals[1]), view);
            // No silhouette if both faces are seen from the same side, whatever
            // the rounding of normals and ends.
            let size = view[0].abs() + view[1].abs() + view[2].abs();
            let heights = (self.plane_margin + margin) * simd.splat(NORMAL_SCALE);
            let clearance = size.mul_add(simd.splat(NORMAL_ERROR), heights);
            let behind = clearance.lt(first.min(second));
            let front = first.max(second).lt(simd.splat(0.0) - clearance);
            mask &= !(behind | front);
            if mask == 0 {
                return (0, [0.0; LANES]);
            }
        }
        let half = load_i16(simd, &block.half);
        let half = [half[0] * step, half[1] * step, half[2] * step];
        let z = dot(self.axis, view);
        let z_half = dot(self.axis, half);
        let least_z = z - z_half.abs();
        // Edges wholly in front of the eye are projected; the others, too close
        // or behind, are bounded like boxes.
        let in_front = margin.lt(least_z);
        let mut bound = self.projected_pseudo_angle(simd, margin, view, half, z, z_half);
        if mask & !in_front != 0 {
            let radial = reject(view, self.axis, z);
            let radial_squared = dot(radial, radial);
            let radial_reach = dot(radial, half).abs();
            let reach = half[0].abs() + half[1].abs() + half[2].abs();
            let rough = pseudo_angle(
                simd,
                margin,
                z,
                radial_squared,
                z_half.abs(),
                radial_reach,
                reach,
            );
            bound = (margin - least_z).select_by_sign(bound, rough);
        }
        mask &= bound.le(simd.splat(limit));
        (mask, bound.to_array())
    }

    /// Lower bound of the pseudo-angles of segments in front of the eye.
    ///
    /// Projected on the plane at height 1, a segment stays a segment, and its
    /// point nearest to the axis stays the nearest, at the tangent of the
    /// angle. The margins: a point projected at `p` is off by at most
    /// `margin / z (1 + |p|)`, and the nearest point, along the segment, by
    /// less than that.
    #[inline(always)]
    fn projected_pseudo_angle(
        &self,
        simd: S,
        margin: S::F32x8,
        view: [S::F32x8; 3],
        half: [S::F32x8; 3],
        z: S::F32x8,
        z_half: S::F32x8,
    ) -> S::F32x8 {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let (x, x_half) = (dot(self.across[0], view), dot(self.across[0], half));
        let (y, y_half) = (dot(self.across[1], view), dot(self.across[1], half));
        let from_scale = recip(simd, z - z_half);
        let to_scale = recip(simd, z + z_half);
        let (from_x, from_y) = ((x - x_half) * from_scale, (y - y_half) * from_scale);
        let (to_x, to_y) = ((x + x_half) * to_scale, (y + y_half) * to_scale);
        let (along_x, along_y) = (to_x - from_x, to_y - from_y);
        let length_squared = along_x.mul_add(along_x, along_y * along_y);
        let towards = zero - from_x.mul_add(along_x, from_y * along_y);
        // A segment seen end-on has 0/0 here, which the maximum makes 0.
        let t = (towards * recip(simd, length_squared)).max(zero).min(one);
        let nearest_x = t.mul_add(along_x, from_x);
        let nearest_y = t.mul_add(along_y, from_y);
        let squared = nearest_x.mul_add(nearest_x, nearest_y * nearest_y);
        // Estimates treat subnormal numbers as zero: none of those.
        let squared = squared.max(simd.splat(f32::MIN_POSITIVE));
        let tangent = squared * squared.rsqrt_estimate();
        let size = from_x.abs() + from_y.abs() + to_x.abs() + to_y.abs() + one;
        let error = margin * from_scale.max(to_scale) * size;
        let tangent = (tangent * simd.splat(BOUND_SHRINK) - error).max(zero);
        tangent * (one + tangent).recip_estimate() * simd.splat(BOUND_SHRINK)
    }
}

/// Lower bound of the pseudo-angles of points around a centre at height
/// `z` and distance `ρ = √radial_squared` from the axis, that reach at most
/// `z_reach` along the axis, `radial_reach / ρ` in the radial direction,
/// and `reach` in any.
#[inline(always)]
fn pseudo_angle<S: Simd>(
    simd: S,
    margin: S::F32x8,
    z: S::F32x8,
    radial_squared: S::F32x8,
    z_reach: S::F32x8,
    radial_reach: S::F32x8,
    reach: S::F32x8,
) -> S::F32x8 {
    let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
    let radial = radial_squared * radial_squared.rsqrt_estimate();
    let highest = z + z_reach + margin;
    // In front: least ρ over largest z. Both times the centre's ρ. The
    // radial direction is only orthogonal to the axis up to rounding
    // (margin / ρ), so the reach along the axis leaks into it.
    let near = radial_squared - radial_reach - margin * (radial + reach);
    let near = near.max(zero);
    let front_sum = highest.mul_add(radial, near);
    // All behind: least |z| over largest ρ.
    let behind_sum = radial + reach + margin - highest;
    let numerator = highest.select_by_sign(zero - highest, near);
    let denominator = highest.select_by_sign(behind_sum, front_sum);
    let base = highest.select_by_sign(one, zero);
    // On the axis there are infinities and 0/0: the maximum makes NaN zero.
    let ratio = numerator * denominator.recip_estimate();
    let bound = (ratio + base) * simd.splat(BOUND_SHRINK);
    bound.max(zero)
}

/// One bit for each entry that shares a group with `selected`.
#[inline(always)]
fn groups_mask(groups: &[u8; 8], selected: u8) -> u32 {
    const LOW_BITS: u64 = 0x7f7f_7f7f_7f7f_7f7f;
    let shared = u64::from_le_bytes(*groups) & u64::from_le_bytes([selected; 8]);
    // The top bit of each byte that is not zero; no byte carries to the next.
    let top_bits = (((shared & LOW_BITS) + LOW_BITS) | shared) & !LOW_BITS;
    // The product gathers the eight bits in the top byte.
    ((top_bits >> 7).wrapping_mul(0x0102_0408_1020_4080) >> 56) as u32
}

// No closures over vectors: they would not be compiled with the instructions.

#[inline(always)]
fn splat<S: Simd>(simd: S, v: [f32; 3]) -> [S::F32x8; 3] {
    [simd.splat(v[0]), simd.splat(v[1]), simd.splat(v[2])]
}

#[inline(always)]
fn load<S: Simd>(simd: S, v: &[[f32; 8]; 3]) -> [S::F32x8; 3] {
    [simd.load(&v[0]), simd.load(&v[1]), simd.load(&v[2])]
}

#[inline(always)]
fn load_i16<S: Simd>(simd: S, v: &[[i16; 8]; 3]) -> [S::F32x8; 3] {
    [
        simd.load_i16(&v[0]),
        simd.load_i16(&v[1]),
        simd.load_i16(&v[2]),
    ]
}

#[inline(always)]
fn abs<F: F32x8>(v: [F; 3]) -> [F; 3] {
    [v[0].abs(), v[1].abs(), v[2].abs()]
}

#[inline(always)]
fn sub<F: F32x8>(a: [F; 3], b: [F; 3]) -> [F; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn dot<F: F32x8>(a: [F; 3], b: [F; 3]) -> F {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// One over each number, to almost full precision: an estimate and one step of
/// Newton's method.
#[inline(always)]
fn recip<S: Simd>(simd: S, v: S::F32x8) -> S::F32x8 {
    let estimate = v.recip_estimate();
    estimate * (simd.splat(2.0) - v * estimate)
}

/// `v - axis z`.
#[inline(always)]
fn reject<F: F32x8>(v: [F; 3], axis: [F; 3], z: F) -> [F; 3] {
    [v[0] - axis[0] * z, v[1] - axis[1] * z, v[2] - axis[2] * z]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bit tricks do what the loop does.
    #[test]
    fn mask_of_groups() {
        let mut groups = [0, 1, 2, 3, 128, 255, 64, 0];
        for selected in 0..=255 {
            groups.rotate_left(1);
            let expected = (0..8).filter(|&i| groups[i] & selected != 0);
            let expected = expected.fold(0, |mask, i| mask | 1 << i);
            assert_eq!(
                groups_mask(&groups, selected),
                expected,
                "{groups:?} {selected}"
            );
        }
    }

    /// The stand-in for angles grows with them, from 0 to 2.
    #[test]
    fn pseudo_angle_grows() {
        let pseudo = |angle: f64| pseudo_angle_limit(angle.sin(), angle.cos());
        let angles = (0..=100).map(|i| 0.01 * f64::from(i) * std::f64::consts::PI);
        let values: Vec<f32> = angles.map(pseudo).collect();
        assert!(values.is_sorted());
        assert_eq!((values[0], values[50], values[100]), (0.0, 1.0, 2.0));
        assert!((pseudo(1e-9) / 1e-9 - 1.0).abs() < 1e-6);
    }
}
