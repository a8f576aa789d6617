//! A ray against the eight children of a node, and against the four triangles
//! of a leaf.

use crate::aabb::{Aabb, LocalFrame, round_up};
use crate::bvh::{Child, WIDTH};
use crate::mesh::Mesh;
use crate::ray::{EDGE_ON, Hit, Ray, RayShear};
use crate::simd::{F32x8, F64x4, Lanes, Simd};

/// Triangles in a leaf.
pub const LANES: usize = 4;

/// The boxes of eight children, in local coordinates.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub struct RayNode {
    /// Low x, y, z, then high x, y, z, of each child. Empty slots have
    /// `low > high`.
    planes: [[f32; WIDTH]; 6],
    /// The children.
    pub children: [Child; WIDTH],
}

impl RayNode {
    /// The node with these children and boxes.
    pub fn new(bounds: &[Aabb; WIDTH], children: [Child; WIDTH]) -> Self {
        let planes = std::array::from_fn(|plane| {
            bounds.map(|child| match plane {
                0..3 => child.low[plane],
                _ => child.high[plane - 3],
            })
        });
        Self { planes, children }
    }

    /// The box of one child.
    pub fn child_bounds(&self, slot: usize) -> Aabb {
        Aabb {
            low: std::array::from_fn(|axis| self.planes[axis][slot]),
            high: std::array::from_fn(|axis| self.planes[axis + 3][slot]),
        }
    }
}

/// Up to four triangles, corner by corner and axis by axis. Empty lanes hold a
/// triangle without area, which nothing hits.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(32))]
pub struct TriangleBlock {
    corners: [[[f64; LANES]; 3]; 3],
    faces: [u32; LANES],
}

impl TriangleBlock {
    /// The block of these faces.
    pub fn new(mesh: &Mesh, faces: &[u32]) -> Self {
        let mut block = Self {
            corners: [[[0.0; LANES]; 3]; 3],
            faces: [u32::MAX; LANES],
        };
        for (lane, &face) in faces.iter().enumerate() {
            block.faces[lane] = face;
            for (corner, p) in mesh.corners(face as usize).into_iter().enumerate() {
                for axis in 0..3 {
                    block.corners[corner][axis][lane] = p[axis];
                }
            }
        }
        block
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
        let [ax, ay, az] = local.shear_corner(simd, &self.corners[0]);
        let [bx, by, bz] = local.shear_corner(simd, &self.corners[1]);
        let [cx, cy, cz] = local.shear_corner(simd, &self.corners[2]);
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let zero = simd.splat_f64(0.0);
        let (least, largest) = (u.min(v).min(w), u.max(v).max(w));
        let (positive, negative) = (zero.le(least), largest.le(zero));
        if positive | negative == 0 {
            return;
        }
        let determinant = u + v + w;
        let on_edge = least.le(zero) & zero.le(largest);
        let mut inside = positive | negative;
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
        let inverse_z = simd.splat_f64(local.shear.inverse_z);
        let t = (u * az + v * bz + w * cz) / determinant * inverse_z;
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

/// What single precision may add up to between a plane of a box and the
/// distance at which the ray crosses it, as a displacement of the plane in
/// local units. All coordinates are below 1 or so, and there are eight
/// roundings of at most 2⁻²⁴: of the start, its product with the inverse
/// direction, the inverse (twice its share, for distances up to 2), the
/// product, and the sums.
const PLANE_MARGIN: f64 = 1.0 / (1 << 20) as f64;

/// The same for double precision, per local unit between the tree and the
/// ray's origin.
const ORIGIN_MARGIN: f64 = 1.0 / (1_u64 << 46) as f64;

/// Slower components of the direction (relative to the fastest) are rounded
/// to this, which moves no point of the ray within the tree by more than twice
/// as much. Keeps their inverses finite.
const SLOWEST: f64 = 1.0 / (1_u64 << 60) as f64;

/// A ray in the coordinates of a tree. It starts where it enters the tree, so
/// that all numbers are about 1 however far its origin is, and its distances
/// are measured along its fastest axis, in local units.
pub struct LocalRay<S: Simd> {
    /// For triangles: the map of the ray, and its origin, the axes permuted.
    shear: RayShear,
    origin: [S::F64x4; 3],
    shears: [S::F64x4; 2],
    /// For boxes: which plane of each axis comes first (an index to
    /// `RayNode::planes`) and which last.
    first: [usize; 3],
    last: [usize; 3],
    inverse: [S::F32x8; 3],
    /// `start / direction`, with the margin that makes planes nearer, or
    /// farther.
    offset_first: [S::F32x8; 3],
    offset_last: [S::F32x8; 3],
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
        let speed = shear.inverse_z.abs();
        let direction = ray.direction * speed;
        let local_per_world = frame.inverse_scale / speed;
        let origin = frame.local_from_world(ray.origin);
        let margin = PLANE_MARGIN + ORIGIN_MARGIN * origin.map(f64::abs).max_component();

        // The part of the ray within the tree: it lies between -1 and 1.
        let mut enter = ray.t_min * local_per_world;
        let mut exit = ray.t_max * local_per_world;
        for axis in 0..3 {
            let (from, d) = (origin[axis], direction[axis]);
            let reach = 1.0 + margin;
            if d == 0.0 {
                if from.abs() > reach {
                    return None;
                }
            } else {
                let side = reach.copysign(d);
                enter = enter.max((-side - from) / d);
                exit = exit.min((side - from) / d);
            }
        }
        let is_in_reach = enter <= exit; // false for NaN
        if !is_in_reach {
            return None;
        }
        let start = origin + direction * enter;
        let inverse = direction.map(|d| {
            let d = if d.abs() < SLOWEST {
                SLOWEST.copysign(d)
            } else {
                d
            };
            d.recip()
        });
        let offset = |sign: f64, axis: usize| {
            let inverse: f64 = inverse[axis];
            simd.splat((start[axis] * inverse + sign * margin * inverse.abs()) as f32)
        };
        let is_negative = |axis: usize| usize::from(inverse[axis] < 0.0);
        Some(Self {
            origin: shear.axes.map(|axis| simd.splat_f64(ray.origin[axis])),
            shears: shear.shear.map(|s| simd.splat_f64(s)),
            shear,
            first: [0, 1, 2].map(|axis| axis + 3 * is_negative(axis)),
            last: [0, 1, 2].map(|axis| axis + 3 - 3 * is_negative(axis)),
            inverse: inverse.to_array().map(|v| simd.splat(v as f32)),
            offset_first: [0, 1, 2].map(|axis| offset(1.0, axis)),
            offset_last: [0, 1, 2].map(|axis| offset(-1.0, axis)),
            enter,
            exit,
            local_per_world,
            margin,
        })
    }

    /// The local distance beyond which boxes cannot contain anything nearer
    /// than the world distance `t`.
    #[inline(always)]
    pub fn limit(&self, t: f64) -> f32 {
        round_up((t * self.local_per_world).min(self.exit) - self.enter + self.margin)
    }

    /// Which children the ray may enter before `limit`, and no later than
    /// where.
    #[inline(always)]
    pub fn children(&self, simd: S, node: &RayNode, limit: f32) -> (u32, [f32; WIDTH]) {
        let crossing = |planes: &[usize; 3], offset: &[S::F32x8; 3], axis: usize| {
            let plane = simd.load(&node.planes[planes[axis]]);
            plane.mul_sub(self.inverse[axis], offset[axis])
        };
        let [x, y, z] = [0, 1, 2].map(|axis| crossing(&self.first, &self.offset_first, axis));
        let near = x.max(y).max(z.max(simd.splat(0.0)));
        let [x, y, z] = [0, 1, 2].map(|axis| crossing(&self.last, &self.offset_last, axis));
        let far = x.min(y).min(z.min(simd.splat(limit)));
        (near.le(far), near.to_array())
    }

    /// A corner of four triangles, relative to the ray and sheared.
    #[inline(always)]
    fn shear_corner(&self, simd: S, corner: &[[f64; LANES]; 3]) -> [S::F64x4; 3] {
        let axes = &self.shear.axes;
        let [x, y, z] = [0, 1, 2].map(|i| simd.load_f64(&corner[axes[i]]) - self.origin[i]);
        [x - self.shears[0] * z, y - self.shears[1] * z, z]
    }
}
