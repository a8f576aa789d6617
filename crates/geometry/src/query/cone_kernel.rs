//! A view cone against the eight children of a node: which can contain a
//! boundary, and no nearer than where.

use super::cone_node::{ConeNode, SIN_STEP};
use super::lanes::{cross, dot, groups_mask, load_i8, load_i16, reject, splat, sub};
use super::local_cone::{LocalCone, LocalPlane};
use super::oriented_box::{FIRST_SCALE, SECOND_SCALE};
use super::pseudo_angle::{BOUND_SHRINK, Limit};
use crate::bvh::WIDTH;
use crate::simd::{F32x8, Lanes, Simd};

/// The axes of boxes are longer than unit vectors by less than this.
const AXIS_LENGTH: f32 = 1.01;

impl<S: Simd> LocalCone<S> {
    /// Which children may contain a boundary at a pseudo-angle up to the limit,
    /// and lower bounds of their pseudo-angles.
    ///
    /// With the radial unit vector `r` from the axis `q` towards the centre of
    /// a box, everything in the box has
    ///
    ///   (r - τ q) · v >= f(τ),
    ///
    /// the value at the centre less the reach of the box along `r - τ q`. Where
    /// `f(τ) >= 0`, all of the box is at an angle of at least `atan τ`. Patches
    /// along a silhouette are thin just that way, so this is much tighter than
    /// the least `r · v` over the greatest `q · v`. The reach is a convex
    /// function of `τ`, so `f` is concave: it is not below its chord from 0 to
    /// the limit (or, if that is nearer, to the centre), whose zero therefore is
    /// a bound.
    #[inline(always)]
    pub fn children(&self, simd: S, node: &ConeNode, limit: &Limit) -> (u32, [f32; WIDTH]) {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let mut mask = groups_mask(&node.groups, self.groups);
        let step = simd.splat(node.step);
        let half = load_i16(simd, &node.half);
        let view = self.view(simd, node);
        let tight = Boxes::new(simd, node, half);
        let first = tight.axes[0];
        // In any direction.
        let reach = (half[0] + half[1] + half[2]) * simd.splat(AXIS_LENGTH * node.step);

        // All times the centre's distance ρ from the axis: `radial` is ρ r, and
        // `slope` is ρ τ.
        let z = dot(self.axis, view);
        let radial = reject(view, self.axis, z);
        // Estimates treat subnormal numbers as zero: none of those.
        let squared = dot(radial, radial).max(simd.splat(f32::MIN_POSITIVE));
        let distance = squared * squared.rsqrt_estimate();
        let limit_slope = distance * simd.splat(limit.tangent);
        // A maximum or minimum with NaN is the second number.
        let centre_slope = z.select_by_sign(limit_slope, squared * z.recip_estimate());
        let slope = centre_slope.min(limit_slope);
        let tilted = [
            radial[0] - self.axis[0] * slope,
            radial[1] - self.axis[1] * slope,
            radial[2] - self.axis[2] * slope,
        ];
        // The centre is off by the margin, along both vectors; and the radial
        // vector is off by as much of its length, so the reach leaks into it.
        let at_zero = squared - tight.reach(radial) - self.margin * (distance + reach);
        let at_slope =
            squared - slope * z - tight.reach(tilted) - self.margin * (distance + slope + reach);
        let is_beyond = zero.lt(at_slope) & limit_slope.le(slope) & limit.has_tangent;
        mask &= !is_beyond;
        // The zero of the chord as tangent, `slope near / (distance drop)`, and
        // from that the pseudo-angle.
        let near = at_zero.max(zero);
        let drop = near - at_slope.min(zero);
        let in_front = slope * near;
        let front_sum = distance.mul_add(drop, in_front);
        // All behind: least |z| over largest ρ.
        let highest = z + reach + self.margin;
        let behind = zero - highest;
        let behind_sum = distance + reach + self.margin + behind;
        let numerator = highest.select_by_sign(behind, in_front);
        let denominator = highest.select_by_sign(behind_sum, front_sum);
        let right_angle = highest.select_by_sign(one, zero);
        // On the axis there are infinities and 0/0: the maximum makes NaN zero.
        let ratio = numerator * denominator.recip_estimate();
        let bound = ((ratio + right_angle) * simd.splat(BOUND_SHRINK)).max(zero);
        mask &= bound.le(simd.splat(limit.pseudo));

        if !self.all_edges {
            // No silhouettes if |axis·v| > sin |v| + k (NormalCone).
            let towards = dot(first, view).abs() * simd.splat(1.0 / FIRST_SCALE);
            let view_margin = simd.load_i16(&node.view_margin) * step;
            let clearance = towards - view_margin - self.plane_margin;
            let distance_squared = dot(view, view);
            let sin = simd.load_i16(&node.sin) * simd.splat(SIN_STEP);
            let is_clear =
                zero.lt(clearance) & (sin * sin * distance_squared).lt(clearance * clearance);
            mask &= !is_clear;
        }
        if let Some(plane) = self.in_front_of {
            let normal = splat(simd, plane.normal);
            let farthest = dot(normal, view) + tight.reach(normal);
            mask &= !farthest.lt(simd.splat(plane.offset - plane.margin));
        }
        (mask, bound.to_array())
    }

    /// Which children are wholly in front of all of these planes.
    #[inline(always)]
    pub fn in_front_of_all(&self, simd: S, node: &ConeNode, planes: &[LocalPlane]) -> u32 {
        let view = self.view(simd, node);
        let boxes = Boxes::new(simd, node, load_i16(simd, &node.half));
        let mut mask = u32::MAX;
        for plane in planes {
            let normal = splat(simd, plane.normal);
            let nearest = dot(normal, view) - boxes.reach(normal);
            mask &= simd.splat(plane.offset + plane.margin).lt(nearest);
        }
        mask
    }

    /// The centres of a node's boxes, seen from the apex.
    #[inline(always)]
    fn view(&self, simd: S, node: &ConeNode) -> [S::F32x8; 3] {
        let step = simd.splat(node.step);
        let base = sub(splat(simd, node.origin), self.apex);
        let centre = load_i16(simd, &node.centre);
        [
            centre[0].mul_add(step, base[0]),
            centre[1].mul_add(step, base[1]),
            centre[2].mul_add(step, base[2]),
        ]
    }
}

/// Eight boxes: their axes in units of what is stored, and half their extents,
/// each over the unit of its axis.
struct Boxes<F> {
    axes: [[F; 3]; 3],
    half: [F; 3],
}

impl<F: F32x8> Boxes<F> {
    /// The boxes of a node, half whose extents are these.
    #[inline(always)]
    fn new<S: Simd<F32x8 = F>>(simd: S, node: &ConeNode, half: [F; 3]) -> Self {
        let first = load_i16(simd, &node.first);
        let second = load_i8(simd, &node.second);
        Self {
            axes: [first, second, cross(first, second)],
            half: [
                half[0] * simd.splat(node.step / FIRST_SCALE),
                half[1] * simd.splat(node.step / SECOND_SCALE),
                half[2] * simd.splat(node.step / (FIRST_SCALE * SECOND_SCALE)),
            ],
        }
    }

    /// How far the boxes reach from their centres along vectors, times the
    /// vectors' lengths.
    #[inline(always)]
    fn reach(&self, v: [F; 3]) -> F {
        let [a, b, c] = self.half;
        let along_c = dot(self.axes[2], v).abs() * c;
        let along_b = dot(self.axes[1], v).abs().mul_add(b, along_c);
        dot(self.axes[0], v).abs().mul_add(a, along_b)
    }
}
