//! Rays of a bundle that go about the same way: against boxes all of them at a time in single
//! precision, with the margins of single rays, and against triangles exactly as single rays, operation
//! by operation.

use super::bundle::{BUNDLE, Numbers};
use super::local_bundle::{LocalBundle, Singles, axes_to};
use super::ray_kernel::{Crossing, RayNode, TriangleBlock, crossing};
use crate::bvh::{VisitOfRays, WIDTH};
use crate::ray::PLANE_MARGIN;
use crate::simd::{F32x8, F32x16, F64x4, Lanes, Simd};

/// Numbers in a vector of double precision.
const OF_F64: usize = 4;

/// Rays of a bundle that go about the same way, and are fastest along the same axis.
pub struct Beam<'a, S: Simd> {
    pub local: &'a LocalBundle<'a>,
    pub mask: u32,
    axes: [usize; 3],
    slabs: [SlabOfRays<S>; 3],
    margin: f32,
}

/// The motions of rays along an axis.
struct SlabOfRays<S: Simd> {
    inverse: S::F32x16,
    /// `start / direction`.
    offset: S::F32x16,
    all: Option<AllRays>,
}

/// What is common to rays that move the same way along an axis.
struct AllRays {
    is_reversed: bool,
    /// Where they start at least and at most, with the margin.
    start: [f32; 2],
    /// Distances per movement, without sign.
    inverse: [f32; 2],
}

/// Directions of a beam, which should have unit length, differ by no more than this from that of its first
/// ray along each axis.
const SPREAD: f32 = 0.25;

impl<'a, S: Simd> Beam<'a, S> {
    /// The first of some rays with those that go about its way; `None` if that is no more than a few.
    #[inline(always)]
    pub fn of_first(simd: S, local: &'a LocalBundle<'a>, rays: u32, few: u32) -> Option<Self> {
        if !local.is_finite || rays.count_ones() <= few {
            return None;
        }
        let first = rays.trailing_zeros() as usize % BUNDLE;
        let fastest = local.fastest_axis(first);
        let mut mask = rays & local.fastest[fastest];
        for axis in 0..3 {
            let directions = simd.round_16(&local.rays.direction[axis]);
            let apart = directions - simd.splat_16(local.rays.direction[axis][first] as f32);
            mask &= apart.abs().le(simd.splat_16(SPREAD));
        }
        if mask.count_ones() <= few {
            return None;
        }
        // Twice that of planes: middles and halves of boxes, places and products are rounded, too.
        let margin = simd.round_16(&local.margin).largest() + PLANE_MARGIN as f32;
        let slab = |axis: usize| (&local.start[axis], &local.inverse[axis]);
        Some(Self {
            local,
            mask,
            axes: axes_to(fastest),
            slabs: [
                SlabOfRays::new(simd, slab(0), (mask, first), margin),
                SlabOfRays::new(simd, slab(1), (mask, first), margin),
                SlabOfRays::new(simd, slab(2), (mask, first), margin),
            ],
            margin,
        })
    }

    /// Which children any of some rays may enter before its own limit, with those rays, and no
    /// later than where; `farthest` is the largest limit.
    #[inline(always)]
    pub fn children(
        &self,
        simd: S,
        node: &RayNode,
        rays: u32,
        limits: &Singles,
        farthest: f32,
    ) -> (u32, [f32; WIDTH], [VisitOfRays; WIDTH]) {
        let mut visits = node.children.map(|child| VisitOfRays { child, rays: 0 });
        // First what no ray can enter, all children at a time.
        let (mut near, mut far) = (simd.splat(0.0), simd.splat(farthest));
        let half = simd.splat(0.5);
        let margin = simd.splat(self.margin);
        let (mut centres, mut halves) = ([[0.0; WIDTH]; 3], [[0.0; WIDTH]; 3]);
        for axis in 0..3 {
            let low = simd.load(&node.planes[0][axis]);
            let high = simd.load(&node.planes[1][axis]);
            centres[axis] = ((high + low) * half).to_array();
            halves[axis] = ((high - low) * half + margin).to_array();
            if let Some(all) = &self.slabs[axis].all {
                let [least, most] = [simd.splat(all.start[0]), simd.splat(all.start[1])];
                let (to_near, to_far) = match all.is_reversed {
                    false => (low - most, high - least),
                    true => (least - high, most - low),
                };
                let [slow, fast] = [simd.splat(all.inverse[1]), simd.splat(all.inverse[0])];
                near = near.max((to_near * slow).min(to_near * fast));
                far = far.min((to_far * slow).max(to_far * fast));
            }
        }
        let mut found = 0;
        let mut candidates = near.le(far);
        while candidates != 0 {
            let slot = candidates.trailing_zeros() as usize % WIDTH;
            candidates &= candidates - 1;
            let centre = [centres[0][slot], centres[1][slot], centres[2][slot]];
            let half = [halves[0][slot], halves[1][slot], halves[2][slot]];
            let entering = rays & self.entering(simd, centre, half, limits);
            visits[slot].rays = entering;
            found |= u32::from(entering != 0) << slot;
        }
        (found, near.to_array(), visits)
    }

    /// One bit for each ray that may enter a box before its limit.
    #[inline(always)]
    fn entering(&self, simd: S, centre: [f32; 3], half: [f32; 3], limits: &Singles) -> u32 {
        let (mut near, mut far) = (simd.splat_16(0.0), simd.load_16(limits));
        for axis in 0..3 {
            let slab = &self.slabs[axis];
            let middle = simd
                .splat_16(centre[axis])
                .mul_sub(slab.inverse, slab.offset);
            let reach = simd.splat_16(half[axis]) * slab.inverse.abs();
            near = near.max(middle - reach);
            far = far.min(middle + reach);
        }
        near.le(far)
    }

    /// Calls `found` with each of some rays that hits a triangle of a block no farther than at its
    /// `t_max`, and the distance: exactly [`TriangleBlock::intersect`], operation by operation.
    #[inline(always)]
    pub fn intersect(
        &self,
        simd: S,
        block: &TriangleBlock,
        lane: usize,
        rays: u32,
        t_max: &mut Numbers,
        mut found: impl FnMut(usize, f64, &mut Numbers),
    ) {
        let [i, j, k] = self.axes;
        let [a, b, c] = &block.corners;
        let a = [a[i][lane], a[j][lane], a[k][lane]];
        let b = [b[i][lane], b[j][lane], b[k][lane]];
        let c = [c[i][lane], c[j][lane], c[k][lane]];
        for part in 0..BUNDLE / OF_F64 {
            let own = rays >> (OF_F64 * part) & ((1 << OF_F64) - 1);
            if own == 0 {
                continue;
            }
            let corners = [
                self.shear_corner(simd, a, part),
                self.shear_corner(simd, b, part),
                self.shear_corner(simd, c, part),
            ];
            let inverse_z = simd.load_f64(part_of(&self.local.inverse_z, part));
            let Some(Crossing { inside, t, .. }) = crossing(simd, corners, inverse_z, own) else {
                continue;
            };
            let t_min = simd.load_f64(part_of(self.local.rays.range[0], part));
            let before = t.le(simd.load_f64(part_of(t_max, part)));
            let mut hits = inside & t_min.le(t) & before;
            if hits == 0 {
                continue;
            }
            let t = t.to_array();
            while hits != 0 {
                let ray = hits.trailing_zeros() as usize % OF_F64;
                hits &= hits - 1;
                found(OF_F64 * part + ray, t[ray], t_max);
            }
        }
    }

    /// A corner of a triangle, relative to some rays and sheared.
    #[inline(always)]
    fn shear_corner(&self, simd: S, corner: [f64; 3], part: usize) -> [S::F64x4; 3] {
        let [i, j, k] = self.axes;
        let LocalBundle { rays, shears, .. } = self.local;
        let origin = rays.origin;
        let z = simd.splat_f64(corner[2]) - simd.load_f64(part_of(&origin[k], part));
        let x = simd.splat_f64(corner[0]) - simd.load_f64(part_of(&origin[i], part));
        let y = simd.splat_f64(corner[1]) - simd.load_f64(part_of(&origin[j], part));
        [
            x - simd.load_f64(part_of(&shears[0], part)) * z,
            y - simd.load_f64(part_of(&shears[1], part)) * z,
            z,
        ]
    }

    /// The limits of its rays, negative for others.
    #[inline(always)]
    pub fn limits(&self) -> Singles {
        let mut limits = [-1.0; BUNDLE];
        for (ray, limit) in limits.iter_mut().enumerate() {
            let own = self.local.limit(ray, self.local.rays.range[1][ray]);
            *limit = if self.mask >> ray & 1 == 1 { own } else { -1.0 };
        }
        limits
    }
}

impl<S: Simd> SlabOfRays<S> {
    /// For some rays, one of which is given, that start in these places, with distance per movement.
    #[inline(always)]
    fn new(
        simd: S,
        (start, inverse): (&Numbers, &Numbers),
        (mask, one): (u32, usize),
        margin: f32,
    ) -> Self {
        // In the place of others that one.
        let start = simd
            .round_16(start)
            .replaced(!mask, simd.splat_16(start[one] as f32));
        let inverse = simd
            .round_16(inverse)
            .replaced(!mask, simd.splat_16(inverse[one] as f32));
        let [least, most] = ends_of(inverse);
        let [low, high] = ends_of(start);
        let (is_reversed, is_forward) = (most < 0.0, least > 0.0);
        let all = AllRays {
            is_reversed,
            start: [low - margin, high + margin],
            inverse: match is_reversed {
                true => [-most, -least],
                false => [least, most],
            },
        };
        Self {
            inverse,
            offset: start * inverse,
            all: if is_reversed || is_forward {
                Some(all)
            } else {
                None
            },
        }
    }
}

/// The smallest and the largest of the numbers.
#[inline(always)]
fn ends_of<F: F32x16>(numbers: F) -> [f32; 2] {
    [numbers.smallest(), numbers.largest()]
}

/// A vector of numbers of a bundle.
#[inline(always)]
fn part_of(numbers: &Numbers, part: usize) -> &[f64; OF_F64] {
    &numbers.as_chunks().0[part]
}
