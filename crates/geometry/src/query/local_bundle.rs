//! A bundle of rays in a tree's coordinates.

use super::bundle::{BUNDLE, Bundle, Numbers, vector};
use super::ray_kernel::{LocalRay, Within, inverse_speed, slab};
use crate::local_frame::LocalFrame;
use crate::ray::{ORIGIN_MARGIN, PLANE_MARGIN, RayShear};
use crate::simd::Simd;

/// A number of each ray, in single precision.
pub type Singles = [f32; BUNDLE];

/// The rays of a bundle in the world, with one that is asked for in the place of each that is not.
pub struct Filled {
    origin: [Numbers; 3],
    direction: [Numbers; 3],
    range: [Numbers; 2],
}

/// The rays of a bundle, see [`LocalRay`]. Numbers of rays without a bit in the mask mean nothing.
pub struct LocalBundle<'a> {
    /// The rays in the world, all of which are some that are asked for.
    pub rays: Bundle<'a>,
    /// Those that pass through the tree.
    pub mask: u32,
    /// True if no number of any ray is infinite or NaN, but for ends.
    pub is_finite: bool,
    /// Those that are fastest along each axis.
    pub fastest: [u32; 3],
    pub shears: [Numbers; 2],
    pub inverse_z: Numbers,
    /// Where they enter the tree, and distance per movement along each axis.
    pub start: [Numbers; 3],
    pub inverse: [Numbers; 3],
    enter: Numbers,
    exit: Numbers,
    local_per_world: Numbers,
    pub margin: Numbers,
}

impl Filled {
    /// The rays of a bundle, for which there is room where not all are asked for.
    #[inline(always)]
    pub fn all<'a>(room: &'a mut Option<Self>, rays: &Bundle<'a>) -> Bundle<'a> {
        if rays.mask == u32::MAX >> (32 - BUNDLE) {
            return *rays;
        }
        let filled = room.insert(Self {
            origin: *rays.origin,
            direction: *rays.direction,
            range: [*rays.range[0], *rays.range[1]],
        });
        filled.fill(rays.mask);
        Bundle {
            origin: &filled.origin,
            direction: &filled.direction,
            range: filled.range.each_ref(),
            mask: rays.mask,
        }
    }

    #[inline(always)]
    fn fill(&mut self, mask: u32) {
        let first = mask.trailing_zeros() as usize % BUNDLE;
        let mut is_asked = [0_u64; BUNDLE];
        for (ray, is_asked) in is_asked.iter_mut().enumerate() {
            *is_asked = u64::from(mask >> ray & 1);
        }
        let Self {
            origin: [ox, oy, oz],
            direction: [dx, dy, dz],
            range: [near, far],
        } = self;
        for numbers in [ox, oy, oz, dx, dy, dz, near, far] {
            let of_first = numbers[first];
            for ray in 0..BUNDLE {
                numbers[ray] = select(is_asked[ray] != 0, numbers[ray], of_first);
            }
        }
    }
}

impl<'a> LocalBundle<'a> {
    /// The rays in the coordinates of a tree: [`LocalRay::new`] for all, where they are [`Filled::all`].
    #[inline(always)]
    pub fn new(frame: &LocalFrame, rays: &Bundle<'a>) -> Self {
        let mut local = Self {
            rays: *rays,
            mask: rays.mask,
            is_finite: false,
            fastest: [0; 3],
            shears: [[0.0; BUNDLE]; 2],
            inverse_z: [0.0; BUNDLE],
            start: [[0.0; BUNDLE]; 3],
            inverse: [[0.0; BUNDLE]; 3],
            enter: [0.0; BUNDLE],
            exit: [0.0; BUNDLE],
            local_per_world: [0.0; BUNDLE],
            margin: [0.0; BUNDLE],
        };
        let centre = frame.centre.to_array();
        let [dx, dy, dz] = rays.direction;
        let mut from = [[0.0; BUNDLE]; 3];
        let mut speeds = [0.0; BUNDLE];
        for (axis, from) in from.iter_mut().enumerate() {
            for (ray, from) in from.iter_mut().enumerate() {
                *from = (rays.origin[axis][ray] - centre[axis]) * frame.inverse_scale;
            }
        }
        // The axes of `RayShear`.
        for ray in 0..BUNDLE {
            let (x, y, z) = (dx[ray], dy[ray], dz[ray]);
            let is_x = (x.abs() >= y.abs()) & (x.abs() >= z.abs());
            let is_y = !is_x & (y.abs() >= z.abs());
            let speed = select(is_x, x, select(is_y, y, z));
            local.inverse_z[ray] = 1.0 / speed;
            local.shears[0][ray] = select(is_x, y, select(is_y, z, x)) / speed;
            local.shears[1][ray] = select(is_x, z, select(is_y, x, y)) / speed;
            speeds[ray] = speed.abs();
        }
        let mut usable = 0;
        for ray in 0..BUNDLE {
            let (x, y, z) = (dx[ray].abs(), dy[ray].abs(), dz[ray].abs());
            let is_x = (x >= y) & (x >= z);
            let is_y = !is_x & (y >= z);
            local.fastest[0] |= u32::from(is_x) << ray;
            local.fastest[1] |= u32::from(is_y) << ray;
            // NaN if any is.
            let origin = from[0][ray].abs() + from[1][ray].abs() + from[2][ray].abs();
            let all = origin + (x + y + z) + local.inverse_z[ray].abs();
            usable |= u32::from(all < f64::INFINITY) << ray;
        }
        local.is_finite = usable & rays.mask == rays.mask;
        local.fastest[2] = !(local.fastest[0] | local.fastest[1]);
        for ray in 0..BUNDLE {
            let farthest = larger(from[0][ray].abs(), from[1][ray].abs());
            let farthest = larger(farthest, from[2][ray].abs());
            local.margin[ray] = PLANE_MARGIN + ORIGIN_MARGIN * farthest;
            local.local_per_world[ray] = frame.inverse_scale * speeds[ray];
            local.enter[ray] = rays.range[0][ray] * local.local_per_world[ray];
            local.exit[ray] = rays.range[1][ray] * local.local_per_world[ray];
        }
        // The parts of the rays within the tree.
        for (axis, from) in from.iter().enumerate() {
            for (ray, &from) in from.iter().enumerate() {
                let inverse = inverse_speed(rays.direction[axis][ray], speeds[ray]);
                let side = (1.0 + local.margin[ray]).copysign(inverse);
                let (first, last) = ((-side - from) * inverse, (side - from) * inverse);
                local.enter[ray] = larger(local.enter[ray], first);
                local.exit[ray] = smaller(local.exit[ray], last);
                local.inverse[axis][ray] = inverse;
            }
        }
        for (axis, from) in from.iter().enumerate() {
            for (ray, &from) in from.iter().enumerate() {
                let direction = rays.direction[axis][ray] * local.inverse_z[ray].abs();
                local.start[axis][ray] = from + direction * local.enter[ray];
            }
        }
        for ray in 0..BUNDLE {
            let [x, y, z] = &local.start;
            let start = x[ray].abs() + y[ray].abs() + z[ray].abs();
            // False for NaN.
            local.is_finite &= (rays.mask >> ray & 1 == 0) | (start < f64::from(f32::MAX));
        }
        let mut reached = 0;
        for ray in 0..BUNDLE {
            // False for NaN.
            reached |= u32::from(local.enter[ray] <= local.exit[ray]) << ray;
        }
        local.mask &= usable & reached;
        local
    }

    /// The axis along which a ray is fastest.
    #[inline(always)]
    pub fn fastest_axis(&self, ray: usize) -> usize {
        match [self.fastest[0], self.fastest[1]].map(|rays| rays >> ray & 1) {
            [1, _] => 0,
            [_, 1] => 1,
            _ => 2,
        }
    }

    /// The shear of a ray.
    #[inline(always)]
    pub fn shear(&self, ray: usize) -> RayShear {
        RayShear {
            axes: axes_to(self.fastest_axis(ray)),
            shear: [self.shears[0][ray], self.shears[1][ray]],
            inverse_z: self.inverse_z[ray],
        }
    }

    /// A ray in the tree's coordinates.
    #[inline(always)]
    pub fn local_ray<S: Simd>(&self, simd: S, ray: usize) -> LocalRay<S> {
        let (start, inverse) = (vector(&self.start, ray), vector(&self.inverse, ray));
        let margin = self.margin[ray];
        let within = Within {
            slabs: [
                slab(start.x, inverse.x, margin),
                slab(start.y, inverse.y, margin),
                slab(start.z, inverse.z, margin),
            ],
            ends: [self.enter[ray], self.exit[ray]],
            local_per_world: self.local_per_world[ray],
            margin,
        };
        LocalRay::within(
            simd,
            self.shear(ray),
            vector(self.rays.origin, ray),
            &within,
        )
    }

    /// [`LocalRay::limit`] of a ray.
    #[inline(always)]
    pub fn limit(&self, ray: usize, t: f64) -> f32 {
        let end = smaller(self.exit[ray], t * self.local_per_world[ray]);
        let limit = (end - self.enter[ray] + self.margin[ray]) as f32;
        limit + limit.abs() * f32::EPSILON
    }
}

/// The axes of [`RayShear`] of which the last is the given one.
#[inline(always)]
pub fn axes_to(fastest: usize) -> [usize; 3] {
    [(fastest + 1) % 3, (fastest + 2) % 3, fastest]
}

#[inline(always)]
fn select(condition: bool, one: f64, other: f64) -> f64 {
    if condition { one } else { other }
}

/// The larger number; the first if the second is NaN.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    select(b > a, b, a)
}

/// The smaller number; the first if the second is NaN.
#[inline(always)]
fn smaller(a: f64, b: f64) -> f64 {
    select(b < a, b, a)
}
