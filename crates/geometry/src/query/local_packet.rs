//! A packet of rays in a tree's coordinates.

use super::bundle::{BUNDLE, Bundle};
use super::packet_precision::BOX_MARGIN;
use super::ray_kernel::RayNode;
use crate::bvh::WIDTH;
use crate::local_frame::LocalFrame;
use crate::simd::{F32x16, Lanes, Simd};

/// Slower components of directions count as this.
const SLOWEST: f32 = 1e-12;

/// The same, before rays are cut, however far away they start.
const STILL: f64 = 1e-300;

/// Rays that start farther behind their origin are cut, too.
const FARTHEST: f64 = 4.0;

/// The tree lies between -1 and 1, with what boxes are larger by.
const SIDE: f64 = 1.0 + 2.0 * BOX_MARGIN as f64;

/// The rays of a packet, from where they start or enter the tree.
pub struct LocalPacket<S: Simd> {
    pub origin: [S::F32x16; 3],
    pub direction: [S::F32x16; 3],
    /// Distances from there at which they end; negative for those that are not asked for.
    pub end: S::F32x16,
    /// At which distances they start or enter the tree, in its units.
    enter: [f64; BUNDLE],
}

impl<S: Simd> LocalPacket<S> {
    #[inline(always)]
    pub fn new(simd: S, frame: &LocalFrame, packet: &Bundle<'_>) -> Self {
        let centre = frame.centre.to_array();
        let mut local = [[0.0; BUNDLE]; 3];
        let mut farthest: [f64; BUNDLE] = [0.0; BUNDLE];
        for axis in 0..3 {
            for ray in 0..BUNDLE {
                let from = (packet.origin[axis][ray] - centre[axis]) * frame.inverse_scale;
                local[axis][ray] = from;
                farthest[ray] = farthest[ray].max(from.abs());
            }
        }
        let (mut enter, mut exit) = ([0.0; BUNDLE], [0.0; BUNDLE]);
        let mut outside = 0;
        for ray in 0..BUNDLE {
            enter[ray] = packet.range[0][ray] * frame.inverse_scale;
            exit[ray] = packet.range[1][ray] * frame.inverse_scale;
            let is_outside = (farthest[ray] > SIDE) | (enter[ray] < -FARTHEST);
            outside |= u32::from(is_outside) << ray;
        }
        if outside & packet.mask != 0 {
            clip(outside, packet, &local, [&mut enter, &mut exit]);
        }
        let mut end = [0.0; BUNDLE];
        let (mut origin, mut direction) = ([[0.0; BUNDLE]; 3], [[0.0; BUNDLE]; 3]);
        for ray in 0..BUNDLE {
            let length = (exit[ray] - enter[ray]) as f32;
            // All false for NaN.
            let is_range = packet.range[0][ray] <= packet.range[1][ray];
            let is_asked = packet.mask >> ray & 1 == 1 && is_range && enter[ray] <= exit[ray];
            end[ray] = if is_asked && length >= 0.0 {
                length
            } else {
                -1.0
            };
        }
        for axis in 0..3 {
            for ray in 0..BUNDLE {
                let place = local[axis][ray] + packet.direction[axis][ray] * enter[ray];
                origin[axis][ray] = place as f32;
                direction[axis][ray] = packet.direction[axis][ray] as f32;
            }
        }
        Self {
            origin: load(simd, &origin),
            direction: load(simd, &direction),
            end: simd.load_16(&end),
            enter,
        }
    }

    /// A distance in the world beyond all whose [`Self::distance_in_tree`] is no larger than this.
    #[inline(always)]
    pub fn end_in_world(&self, frame: &LocalFrame, ray: usize, distance: f32) -> f64 {
        let distance = f64::from(distance.next_up());
        let rounding = 8.0 * f64::EPSILON * (distance + self.enter[ray].abs());
        (distance + self.enter[ray] + rounding) * frame.scale
    }

    /// The distance from there at one in the world.
    #[inline(always)]
    pub fn distance_in_tree(&self, frame: &LocalFrame, ray: usize, t: f64) -> f32 {
        (t * frame.inverse_scale - self.enter[ray]) as f32
    }

    /// The points at distances along the rays.
    #[inline(always)]
    pub fn at(&self, distance: S::F32x16) -> [S::F32x16; 3] {
        let ([ox, oy, oz], [dx, dy, dz]) = (self.origin, self.direction);
        [
            dx.fused(distance, ox),
            dy.fused(distance, oy),
            dz.fused(distance, oz),
        ]
    }
}

/// Cuts rays to what lies within the tree, distances in its units.
#[inline(always)]
fn clip(
    rays: u32,
    packet: &Bundle<'_>,
    local: &[[f64; BUNDLE]; 3],
    [enter, exit]: [&mut [f64; BUNDLE]; 2],
) {
    let is_wanted = |ray: usize| rays >> ray & 1 == 1;
    for (local, direction) in local.iter().zip(packet.direction) {
        for ray in 0..BUNDLE {
            let (from, speed) = (local[ray], direction[ray]);
            let is_slow = speed.abs() < STILL;
            let inverse = 1.0
                / if is_slow {
                    STILL.copysign(speed)
                } else {
                    speed
                };
            let [first, last] = [(-SIDE - from) * inverse, (SIDE - from) * inverse];
            let entry = enter[ray].max(first.min(last));
            let end = exit[ray].min(first.max(last));
            enter[ray] = if is_wanted(ray) { entry } else { enter[ray] };
            exit[ray] = if is_wanted(ray) { end } else { exit[ray] };
        }
    }
}

/// What boxes need of the rays: one over their directions, and their origins moved both ways.
pub struct Slabs<S: Simd> {
    inverse: [S::F32x16; 3],
    low_origin: [S::F32x16; 3],
    high_origin: [S::F32x16; 3],
}

impl<S: Simd> Slabs<S> {
    #[inline(always)]
    pub fn new(simd: S, rays: &LocalPacket<S>) -> Self {
        let margin = simd.splat_16(BOX_MARGIN);
        let mut slabs = Self {
            inverse: rays.direction,
            low_origin: rays.origin,
            high_origin: rays.origin,
        };
        for axis in 0..3 {
            let speed = rays.direction[axis];
            let is_slow = speed.abs().lt(simd.splat_16(SLOWEST));
            let slowest = speed.select_by_sign(simd.splat_16(-SLOWEST), simd.splat_16(SLOWEST));
            slabs.inverse[axis] = simd.splat_16(1.0) / speed.replaced(is_slow, slowest);
            slabs.low_origin[axis] = rays.origin[axis] - margin;
            slabs.high_origin[axis] = rays.origin[axis] + margin;
        }
        slabs
    }

    /// Which children any of the rays may enter before its end, and the least distance to where.
    #[inline(always)]
    pub fn children(&self, simd: S, node: &RayNode, end: S::F32x16) -> (u32, [f32; WIDTH]) {
        let mut found = 0;
        let mut nearest = [0.0; WIDTH];
        for (slot, nearest) in nearest.iter_mut().enumerate() {
            if node.children[slot].kind().is_none() {
                break;
            }
            let mut near = simd.splat_16(0.0);
            let mut far = end;
            for axis in 0..3 {
                let low = simd.splat_16(node.planes[0][axis][slot]) - self.high_origin[axis];
                let high = simd.splat_16(node.planes[1][axis][slot]) - self.low_origin[axis];
                let (first, last) = (low * self.inverse[axis], high * self.inverse[axis]);
                // Zero stays zero, without a sign.
                near = first.min(last).max(near);
                far = far.min(first.max(last));
            }
            let mask = near.le(far);
            if mask != 0 {
                found |= 1 << slot;
                // Of the rays that enter it.
                *nearest = near
                    .replaced(!mask, simd.splat_16(f32::INFINITY))
                    .smallest();
            }
        }
        (found, nearest)
    }
}

#[inline(always)]
fn load<S: Simd>(simd: S, numbers: &[[f32; BUNDLE]; 3]) -> [S::F32x16; 3] {
    let [x, y, z] = numbers;
    [simd.load_16(x), simd.load_16(y), simd.load_16(z)]
}
