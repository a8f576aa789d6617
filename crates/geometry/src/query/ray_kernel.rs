//! A ray against the eight children of a node, and against the four triangles
//! of a leaf.

use capwalk_math::Vec3;

use crate::aabb::Aabb;
use crate::bvh::{Child, WIDTH};
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;
use crate::ray::{EDGE_ON, Hit, ORIGIN_MARGIN, PLANE_MARGIN, Ray, RayShear, SLOWEST};
use crate::simd::{F32x8, F64x4, Lanes, Simd};

/// Triangles in a leaf.
pub const LANES: usize = 4;

/// The boxes of eight children, in local coordinates.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub struct RayNode {
    /// Low x, y, z, then high x, y, z, of each child. Empty slots have
    /// `low > high`.
    pub(super) planes: [[[f32; WIDTH]; 3]; 2],
    /// In the order of the boxes.
    pub children: [Child; WIDTH],
}

impl RayNode {
    /// The node with these children and boxes.
    pub fn new(bounds: &[Aabb; WIDTH], children: [Child; WIDTH]) -> Self {
        let low = std::array::from_fn(|axis| bounds.map(|child| child.low[axis]));
        let high = std::array::from_fn(|axis| bounds.map(|child| child.high[axis]));
        Self {
            planes: [low, high],
            children,
        }
    }

    /// The middle of the box of one child, and half of its extents.
    pub fn child_box(&self, slot: usize) -> [Vec3; 2] {
        let corner = |planes: [[f32; WIDTH]; 3]| Vec3::from(planes.map(|own| f64::from(own[slot])));
        let [low, high] = self.planes.map(corner);
        [(low + high) * 0.5, (high - low) * 0.5]
    }

    /// The box of one child.
    #[cfg(test)]
    pub fn child_bounds(&self, slot: usize) -> Aabb {
        Aabb {
            low: self.planes[0].map(|plane| plane[slot]),
            high: self.planes[1].map(|plane| plane[slot]),
        }
    }
}

/// The number in an empty lane.
const NO_FACE: u32 = u32::MAX;

/// Up to four triangles, corner by corner and axis by axis. Empty lanes hold a
/// triangle without area, which nothing hits.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(32))]
pub struct TriangleBlock {
    pub(super) corners: [[[f64; LANES]; 3]; 3],
    pub(super) faces: [u32; LANES],
}

impl TriangleBlock {
    /// The block of none.
    pub const EMPTY: Self = Self {
        corners: [[[0.0; LANES]; 3]; 3],
        faces: [NO_FACE; LANES],
    };

    /// The block of these faces.
    pub fn new(mesh: &Mesh, faces: &[u32]) -> Self {
        let mut block = Self::EMPTY;
        for (lane, &face) in faces.iter().enumerate() {
            block.set(lane, face, mesh.corners(face as usize));
        }
        block
    }

    /// Puts a triangle in a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, face: u32, corners: [Vec3; 3]) {
        self.faces[lane] = face;
        for (own, p) in self.corners.iter_mut().zip(corners) {
            for (axis, own) in own.iter_mut().enumerate() {
                own[lane] = p[axis];
            }
        }
    }

    /// The numbers of the triangles.
    pub fn faces(&self) -> impl Iterator<Item = u32> {
        let is_used = |&face: &u32| face != NO_FACE;
        self.faces.into_iter().take_while(is_used)
    }

    /// The corners of the triangle in a lane.
    pub fn corners_of(&self, lane: usize) -> [Vec3; 3] {
        self.corners
            .map(|corner| Vec3::from(corner.map(|axis| axis[lane])))
    }

    /// Calls `found` for each triangle that the ray hits within the bounds, the
    /// least and the largest distance: exactly
    /// [`intersect_triangle`](crate::ray::intersect_triangle), operation by
    /// operation.
    #[inline(always)]
    pub fn intersect<S: Simd>(
        &self,
        simd: S,
        local: &LocalRay<S>,
        [t_min, t_max]: [f64; 2],
        mut found: impl FnMut(Hit),
    ) {
        let corners = [
            local.shear_corner(simd, &self.corners[0]),
            local.shear_corner(simd, &self.corners[1]),
            local.shear_corner(simd, &self.corners[2]),
        ];
        let inverse_z = simd.splat_f64(local.shear.inverse_z);
        let Some(crossing) = crossing(simd, corners, inverse_z, (1 << LANES) - 1) else {
            return;
        };
        let Crossing {
            inside,
            t,
            v,
            w,
            determinant,
        } = crossing;
        let in_bounds = simd.splat_f64(t_min).le(t) & t.le(simd.splat_f64(t_max));
        let mut mask = inside & in_bounds;
        if mask == 0 {
            return;
        }
        let t = t.to_array();
        let v = (v / determinant).to_array();
        let w = (w / determinant).to_array();
        while mask != 0 {
            let lane = mask.trailing_zeros() as usize % LANES;
            mask &= mask - 1;
            found(Hit {
                face: self.faces[lane],
                t: t[lane],
                barycentric: [v[lane], w[lane]],
            });
        }
    }
}

/// Where rays cross the planes of triangles, pair by pair.
pub struct Crossing<S: Simd> {
    /// One bit for each that is inside of its triangle.
    pub inside: u32,
    /// The distance.
    pub t: S::F64x4,
    /// The weights of the second and the third corner, times the determinant.
    pub v: S::F64x4,
    pub w: S::F64x4,
    pub determinant: S::F64x4,
}

/// [`intersect_triangle`](crate::ray::intersect_triangle), operation by operation, for those pairs that
/// are asked for; `None` if none is inside. The corners are relative to the rays, and sheared.
#[inline(always)]
pub fn crossing<S: Simd>(
    simd: S,
    [[ax, ay, az], [bx, by, bz], [cx, cy, cz]]: [[S::F64x4; 3]; 3],
    inverse_z: S::F64x4,
    asked: u32,
) -> Option<Crossing<S>> {
    // No closures over vectors here and above: they would not be compiled
    // with the instructions.
    let u = cx * by - cy * bx;
    let v = ax * cy - ay * cx;
    let w = bx * ay - by * ax;
    let zero = simd.splat_f64(0.0);
    let (least, largest) = (u.min(v).min(w), u.max(v).max(w));
    let mut inside = asked & (zero.le(least) | largest.le(zero));
    if inside == 0 {
        return None;
    }
    let determinant = u + v + w;
    let on_edge = least.le(zero) & zero.le(largest);
    if inside & on_edge != 0 {
        let products = (cx * by).abs()
            + (cy * bx).abs()
            + (ax * cy).abs()
            + (ay * cx).abs()
            + (bx * ay).abs()
            + (by * ax).abs();
        let edge_on = determinant.abs().le(simd.splat_f64(EDGE_ON) * products);
        inside &= !(on_edge & edge_on);
    }
    let t = (u * az + v * bz + w * cz) / determinant * inverse_z;
    Some(Crossing {
        inside,
        t,
        v,
        w,
        determinant,
    })
}

/// A ray in the coordinates of a tree. It starts where it enters the tree, so
/// that all numbers are about 1 however far its origin is, and its distances
/// are measured along its fastest axis, in local units.
pub struct LocalRay<S: Simd> {
    /// For triangles: the map of the ray, and its origin, the axes permuted.
    shear: RayShear,
    origin: [S::F64x4; 3],
    shears: [S::F64x4; 2],
    /// For boxes.
    slabs: [Slab<S>; 3],
    /// Local distance at which the ray enters the tree, and leaves it.
    enter: f64,
    exit: f64,
    /// Local distance per world distance.
    local_per_world: f64,
    /// Error of a local distance.
    margin: f64,
}

impl<S: Simd> LocalRay<S> {
    /// The ray in the tree's coordinates; `None` if it misses the tree.
    #[inline(always)]
    pub fn new(simd: S, frame: &LocalFrame, ray: &Ray) -> Option<Self> {
        let shear = RayShear::new(ray.direction)?;
        let direction = ray.direction * shear.inverse_z.abs();
        let fastest = ray.direction[shear.axes[2]].abs();
        let local_per_world = frame.inverse_scale * fastest;
        let origin = frame.local_from_world(ray.origin);
        let margin = PLANE_MARGIN + ORIGIN_MARGIN * origin.map(f64::abs).max_component();
        let inverse = ray.direction.map(|speed| inverse_speed(speed, fastest));

        // The part of the ray within the tree: it lies between -1 and 1.
        let mut enter = ray.t_min * local_per_world;
        let mut exit = ray.t_max * local_per_world;
        for axis in 0..3 {
            let (from, inverse) = (origin[axis], inverse[axis]);
            let side = (1.0 + margin).copysign(inverse);
            let (first, last) = ((-side - from) * inverse, (side - from) * inverse);
            enter = if first > enter { first } else { enter };
            exit = if last < exit { last } else { exit };
        }
        let is_in_reach = enter <= exit; // false for NaN
        if !is_in_reach {
            return None;
        }
        let start = origin + direction * enter;
        let within = Within {
            slabs: [
                slab(start.x, inverse.x, margin),
                slab(start.y, inverse.y, margin),
                slab(start.z, inverse.z, margin),
            ],
            ends: [enter, exit],
            local_per_world,
            margin,
        };
        Some(Self::within(simd, shear, ray.origin, &within))
    }

    /// The ray with an origin in the world and the map to its direction, and its part in the tree.
    #[inline(always)]
    pub fn within(simd: S, shear: RayShear, origin: Vec3, within: &Within) -> Self {
        let &Within {
            slabs: [x, y, z],
            ends: [enter, exit],
            local_per_world,
            margin,
        } = within;
        let [i, j, k] = shear.axes;
        Self {
            origin: [
                simd.splat_f64(origin[i]),
                simd.splat_f64(origin[j]),
                simd.splat_f64(origin[k]),
            ],
            shears: [
                simd.splat_f64(shear.shear[0]),
                simd.splat_f64(shear.shear[1]),
            ],
            shear,
            slabs: [Slab::new(simd, x), Slab::new(simd, y), Slab::new(simd, z)],
            enter,
            exit,
            local_per_world,
            margin,
        }
    }

    /// The local distance beyond which boxes cannot contain anything nearer
    /// than the world distance `t`.
    #[inline(always)]
    pub fn limit(&self, t: f64) -> f32 {
        let end = t * self.local_per_world;
        let end = if end < self.exit { end } else { self.exit };
        let limit = (end - self.enter + self.margin) as f32;
        // No nearer than before rounding.
        limit + limit.abs() * f32::EPSILON
    }

    /// Which children the ray may enter before `limit`, and no later than
    /// where.
    #[inline(always)]
    pub fn children(&self, simd: S, node: &RayNode, limit: f32) -> (u32, [f32; WIDTH]) {
        let [x, y, z] = &self.slabs;
        let (x_near, x_far) = x.crossings(simd, node, 0);
        let (y_near, y_far) = y.crossings(simd, node, 1);
        let (z_near, z_far) = z.crossings(simd, node, 2);
        let near = x_near.max(y_near).max(z_near.max(simd.splat(0.0)));
        let far = x_far.min(y_far).min(z_far.min(simd.splat(limit)));
        (near.le(far), near.to_array())
    }

    /// A corner of four triangles, relative to the ray and sheared.
    #[inline(always)]
    fn shear_corner(&self, simd: S, corner: &[[f64; LANES]; 3]) -> [S::F64x4; 3] {
        let [i, j, k] = self.shear.axes;
        let z = simd.load_f64(&corner[k]) - self.origin[2];
        let x = simd.load_f64(&corner[i]) - self.origin[0];
        let y = simd.load_f64(&corner[j]) - self.origin[1];
        [x - self.shears[0] * z, y - self.shears[1] * z, z]
    }
}

/// The part of a ray in a tree, in the tree's coordinates.
pub struct Within {
    /// What [`slab`] gives for each axis.
    pub slabs: [[f32; 3]; 3],
    /// The distances at which it enters and leaves.
    pub ends: [f64; 2],
    pub local_per_world: f64,
    pub margin: f64,
}

/// One over a component of a ray's direction, relative to the fastest; finite.
#[inline(always)]
pub fn inverse_speed(speed: f64, fastest: f64) -> f64 {
    const LARGEST: f64 = 1.0 / SLOWEST;
    let inverse = fastest / speed.abs();
    let is_slow = inverse > LARGEST;
    (if is_slow { LARGEST } else { inverse }).copysign(speed)
}

/// The motion along one axis of a ray that starts in this place, with one over its speed: the
/// numbers of [`Slab`].
#[inline(always)]
pub fn slab(start: f64, inverse: f64, margin: f64) -> [f32; 3] {
    let (offset, margin) = (start * inverse, margin * inverse.abs());
    [
        inverse as f32,
        (offset + margin) as f32,
        (offset - margin) as f32,
    ]
}

/// A ray's motion along one axis.
struct Slab<S: Simd> {
    /// Distance per movement along the axis.
    inverse: S::F32x8,
    /// `start / direction`, with the margin that makes planes nearer, or
    /// farther.
    offset_near: S::F32x8,
    offset_far: S::F32x8,
    is_reversed: bool,
}

impl<S: Simd> Slab<S> {
    /// With the numbers of [`slab`].
    #[inline(always)]
    fn new(simd: S, [inverse, near, far]: [f32; 3]) -> Self {
        Self {
            inverse: simd.splat(inverse),
            offset_near: simd.splat(near),
            offset_far: simd.splat(far),
            is_reversed: inverse < 0.0,
        }
    }

    /// Where the ray enters and leaves eight boxes, as far as this axis goes.
    #[inline(always)]
    fn crossings(&self, simd: S, node: &RayNode, axis: usize) -> (S::F32x8, S::F32x8) {
        // An address instead of a choice.
        let first = &node.planes[usize::from(self.is_reversed)][axis];
        let last = &node.planes[usize::from(!self.is_reversed)][axis];
        let near = simd.load(first).mul_sub(self.inverse, self.offset_near);
        let far = simd.load(last).mul_sub(self.inverse, self.offset_far);
        (near, far)
    }
}
