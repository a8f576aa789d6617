//! A view cone against the eight edges of a leaf: which may be boundaries, no
//! nearer than where; and how near one certainly is.

use super::edge_block::{EdgeBlock, LANES, NORMAL_ERROR, NORMAL_SCALE};
use super::lanes::{dot, groups_mask, load_i16, recip, reject, rsqrt, splat, sub};
use super::local_cone::LocalCone;
use super::pseudo_angle::BOUND_SHRINK;
use crate::simd::{F32x8, Lanes, Simd};

/// Edges are projected if they are farther in front of the viewpoint than this, times
/// the error of positions.
const TOO_CLOSE: f32 = 4.0;
/// For those, one over a distance less its error is at most this, times one over
/// the distance.
const CLOSE_GROW: f32 = TOO_CLOSE / (TOO_CLOSE - 1.0);

/// Relative error of a projected tangent and of the pseudo-angle from it, errors
/// of positions aside: the roundings of some ten operations, and twice what a
/// step of Newton's method leaves of an estimate's error (its square).
const ROUNDING: f32 = 1.0 / (1 << 20) as f32;

/// What is known of the edges of a leaf without testing them exactly.
pub struct EdgeBounds {
    /// A bit for each edge that may be a boundary up to the limit.
    pub mask: u32,
    /// Lower bounds of their pseudo-angles.
    pub least: [f32; LANES],
    /// A bit for each edge that certainly is a boundary in front of the viewpoint.
    pub certain: u32,
    /// Upper bounds of the pseudo-angles of those.
    pub most: [f32; LANES],
}

impl EdgeBounds {
    const NONE: Self = Self {
        mask: 0,
        least: [0.0; LANES],
        certain: 0,
        most: [0.0; LANES],
    };
}

impl<S: Simd> LocalCone<S> {
    /// Which edges may be boundaries at a pseudo-angle up to `limit`, and bounds
    /// of their pseudo-angles.
    #[inline(always)]
    pub fn edges(&self, simd: S, block: &EdgeBlock, limit: f32) -> EdgeBounds {
        let mut mask = groups_mask(&block.groups, self.groups);
        let zero = simd.splat(0.0);
        let step = simd.splat(block.step);
        let base = sub(splat(simd, block.origin), self.apex);
        let middle = load_i16(simd, &block.middle);
        let view = [
            middle[0].mul_add(step, base[0]),
            middle[1].mul_add(step, base[1]),
            middle[2].mul_add(step, base[2]),
        ];
        // Both ends are rounded by a step on each axis.
        let margin = self.margin + simd.splat(2.0) * step;
        let mut certain = u32::MAX;
        if !self.all_edges {
            let first = dot(load_i16(simd, &block.normals[0]), view);
            let second = dot(load_i16(simd, &block.normals[1]), view);
            // No silhouette if both faces are seen from the same side, whatever
            // the rounding of normals and ends.
            let size = view[0].abs() + view[1].abs() + view[2].abs();
            let heights = (self.plane_margin + margin) * simd.splat(NORMAL_SCALE);
            let clearance = size.mul_add(simd.splat(NORMAL_ERROR), heights);
            let behind = clearance.lt(first.min(second));
            let front = first.max(second).lt(zero - clearance);
            mask &= !(behind | front);
            if mask == 0 {
                return EdgeBounds::NONE;
            }
            // And certainly one if they are seen from different sides by as much.
            let below = zero - clearance;
            let rises = clearance.lt(second) & first.lt(below);
            let falls = clearance.lt(first) & second.lt(below);
            certain = u32::from(block.open) | rises | falls;
        }
        let half = load_i16(simd, &block.half);
        let half = [half[0] * step, half[1] * step, half[2] * step];
        let z = dot(self.axis, view);
        let z_half = dot(self.axis, half);
        let least_z = z - z_half.abs();
        // Edges wholly in front of the viewpoint are projected; the others, too close
        // or behind, are bounded like boxes.
        let too_close = simd.splat(TOO_CLOSE) * margin;
        let in_front = too_close.lt(least_z);
        let [mut least, most] = self.projected_pseudo_angle(simd, margin, view, half, z, z_half);
        if mask & !in_front != 0 {
            let radial = reject(view, self.axis, z);
            let radial_squared = dot(radial, radial);
            let radial_reach = dot(radial, half).abs();
            let reach = half[0].abs() + half[1].abs() + half[2].abs();
            let rough = rough_pseudo_angle(
                simd,
                margin,
                z,
                radial_squared,
                z_half.abs(),
                radial_reach,
                reach,
            );
            least = (too_close - least_z).select_by_sign(least, rough);
        }
        mask &= least.le(simd.splat(limit));
        if let Some(plane) = self.in_front_of {
            let normal = splat(simd, plane.normal);
            let height = dot(normal, view) + dot(normal, half).abs() - margin;
            certain &= simd.splat(plane.offset + plane.margin).lt(height);
        }
        EdgeBounds {
            mask,
            least: least.to_array(),
            certain: certain & mask & in_front,
            most: most.to_array(),
        }
    }

    /// Bounds of the pseudo-angles of segments in front of the viewpoint: the smallest
    /// and the largest that the nearest points can have.
    ///
    /// Projected on the plane at height 1, a segment stays a segment, and its
    /// point nearest to the axis stays the nearest, at the tangent of the
    /// angle. The margins: a point projected at `p` is off by at most
    /// `margin / (z - margin) (1 + |p|)`, and the nearest point, along the
    /// segment, by no more than the farther end.
    #[inline(always)]
    fn projected_pseudo_angle(
        &self,
        simd: S,
        margin: S::F32x8,
        view: [S::F32x8; 3],
        half: [S::F32x8; 3],
        z: S::F32x8,
        z_half: S::F32x8,
    ) -> [S::F32x8; 2] {
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
        let tangent = squared * rsqrt(simd, squared);
        let size = from_x.abs() + from_y.abs() + to_x.abs() + to_y.abs() + one;
        let error = margin * from_scale.max(to_scale) * size * simd.splat(CLOSE_GROW);
        let (shrink, grow) = (simd.splat(1.0 - ROUNDING), simd.splat(1.0 + ROUNDING));
        let least = tangent.mul_sub(shrink, error).max(zero);
        let most = tangent.mul_add(grow, error);
        [
            least * recip(simd, one + least) * shrink,
            most * recip(simd, one + most) * grow,
        ]
    }
}

/// Lower bound of the pseudo-angles of points around a centre at height
/// `z` and distance `ρ = √radial_squared` from the axis, that reach at most
/// `z_reach` along the axis, `radial_reach / ρ` in the radial direction,
/// and `reach` in any.
#[inline(always)]
fn rough_pseudo_angle<S: Simd>(
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
