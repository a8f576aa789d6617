//! Eight rays at a time against triangles, in single precision.
//!
//! In the tree's own coordinates, which are at most 1, a triangle is three linear functions of a
//! point: the height above its plane, and the weights of its second and third corner. All of it is
//! sums of products in a fixed order: the bits are the same on every processor, and those of one
//! ray do not depend on the others.
//!
//! What single precision cannot resolve is decided once: points within [`IN_PLANE`] of a plane lie
//! in it. Rays do not meet the planes in which they start, nor segments those in which they end,
//! and triangles are larger by as much, so that nothing shines through between neighbours. That is for
//! scenes in which so much is nothing: [`PacketTree::resolves`].

use std::array;

use capwalk_math::Vec3;

use super::ray_kernel::RayNode;
use super::ray_tree::RayTree;
use crate::bvh::{ChildKind, Stack, WIDTH};
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;
use crate::simd::{Computation, F32x8, Instructions, Lanes, Simd};

/// Rays in a packet.
pub const RAYS: usize = 8;

/// Distance from a plane, in units of the tree's half size, up to which a point lies in it: several
/// times what heights of points are typically off by.
pub const IN_PLANE: f32 = 1.0 / (1 << 20) as f32;

/// By how much boxes are larger: corners of triangles that are larger by [`IN_PLANE`] at their
/// sides are farther out, the sharper they are.
const BOX_MARGIN: f32 = 64.0 * IN_PLANE;

/// How many times [`IN_PLANE`] the altitudes of triangles must be.
const LEAST_ALTITUDE: f64 = 1000.0;

/// Surfaces that are nearly parallel must be so many times [`IN_PLANE`] apart, or in one plane, which
/// is a part of it.
const APART: f64 = 16.0;
const IN_ONE_PLANE: f64 = 1e-3;

/// Sine of the angle between planes that are nearly parallel.
const NEARLY_PARALLEL: f64 = 0.01;

/// How far corners are moved out at most, over [`IN_PLANE`]: triangles with sharper ones are larger
/// by less.
const MOST_OUT: f64 = 60.0;

/// Slower components of directions count as this.
const SLOWEST: f64 = 1e-12;

/// A tree of triangles for packets of rays.
#[derive(Clone, Debug)]
pub struct PacketTree {
    frame: LocalFrame,
    nodes: Vec<RayNode>,
    triangles: Vec<Triangle>,
    /// Where the triangles of each leaf start, and at last where they all end.
    leaf_starts: Vec<u32>,
    instructions: Instructions,
}

/// A triangle as linear functions of a point: factors of its coordinates, and a constant.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    height: [f32; 4],
    /// The weights, plus what they may be off by.
    second: [f32; 4],
    third: [f32; 4],
    /// The largest sum of both.
    most: f32,
    face: u32,
}

/// Eight rays. Those without a bit in the mask are not asked for.
#[derive(Clone, Copy, Debug)]
pub struct Packet {
    /// World-space origins, coordinate by coordinate.
    pub origin: [[f64; RAYS]; 3],
    /// Unit directions.
    pub direction: [[f64; RAYS]; 3],
    /// Distances between which something is met.
    pub range: [[f64; RAYS]; 2],
    /// One bit for each ray.
    pub mask: u32,
}

impl Triangle {
    /// The triangle of a face; `None` if it has no area.
    fn new(mesh: &Mesh, frame: &LocalFrame, face: u32) -> Option<Self> {
        let [a, b, c] = mesh
            .corners(face as usize)
            .map(|p| frame.local_from_world(p));
        let (second, third) = (b - a, c - a);
        let cross = second.cross(third);
        let squared = cross.length_squared();
        let normal = cross / squared.sqrt();
        // The gradients of the weights: across the other side, in the plane.
        let along = [third.cross(cross) / squared, cross.cross(second) / squared];
        let has_area = along.iter().all(|gradient| gradient.is_finite()) && squared > 0.0;
        has_area.then(|| {
            let function = |gradient: Vec3, more: f64| {
                let [x, y, z] = gradient.to_array();
                [x, y, z, more - gradient.dot(a)].map(|number| number as f32)
            };
            let sides = [along[0], along[1], along[0] + along[1]];
            let [ab, bc, ca] = [b - a, c - b, a - c].map(Vec3::normalized);
            // Twice the sines of half of the angles.
            let sines = [ab + ca, bc + ab, ca + bc].map(Vec3::length);
            let sharpest = 0.5 * sines.into_iter().fold(2.0, f64::min);
            let out = f64::from(IN_PLANE) * (MOST_OUT * sharpest).min(1.0);
            let margins = sides.map(|gradient| out * gradient.length());
            Self {
                height: function(normal, 0.0),
                second: function(along[0], margins[0]),
                third: function(along[1], margins[1]),
                most: (1.0 + margins.iter().sum::<f64>()) as f32,
                face,
            }
        })
    }
}

impl PacketTree {
    /// The tree of a mesh, from that for its rays.
    pub fn new(rays: &RayTree, mesh: &Mesh) -> Self {
        let (mut triangles, mut leaf_starts) = (Vec::new(), vec![0]);
        for leaf in 0..rays.hierarchy.leaf_count() {
            let faces = rays.hierarchy.leaf(leaf).iter();
            triangles.extend(faces.filter_map(|&face| Triangle::new(mesh, &rays.frame, face)));
            leaf_starts.push(triangles.len() as u32);
        }
        Self {
            frame: rays.frame,
            nodes: rays.nodes.clone(),
            triangles,
            leaf_starts,
            instructions: Instructions::detect(),
        }
    }

    /// True if single precision resolves this mesh, from which the tree was made: no triangle is thin
    /// beside what lies in a plane or has a very sharp corner, and no two that are nearly parallel are nearly,
    /// but not quite, in one plane where their boxes meet. Takes time in proportion to the square of
    /// their number.
    pub fn resolves(&self, mesh: &Mesh) -> bool {
        let corners: Vec<[Vec3; 3]> = (0..mesh.faces.len()).map(|i| mesh.corners(i)).collect();
        let normals: Vec<Vec3> = (0..mesh.faces.len())
            .map(|i| mesh.face_cross(i).normalized())
            .collect();
        let in_plane = self.in_plane();
        let is_thick = |&[a, b, c]: &[Vec3; 3]| {
            let sides = [b - a, c - b, a - c];
            let longest = sides.map(Vec3::length).into_iter().fold(0.0, f64::max);
            let area = sides[0].cross(sides[2]).length();
            let units = sides.map(Vec3::normalized);
            let sines = [0, 1, 2].map(|i| 0.5 * (units[i] + units[(i + 2) % 3]).length());
            let sharpest = sines.into_iter().fold(1.0, f64::min);
            // False for NaN.
            area > LEAST_ALTITUDE * in_plane * longest && MOST_OUT * sharpest >= 1.0
        };
        let boxes: Vec<[Vec3; 2]> = corners
            .iter()
            .map(|&[a, b, c]| [a.min(b).min(c), a.max(b).max(c)])
            .collect();
        let margin = Vec3::splat(APART * in_plane);
        let are_apart = |i: usize, k: usize| {
            let low = boxes[i][0].max(boxes[k][0]) - margin;
            let high = boxes[i][1].min(boxes[k][1]) + margin;
            let meet = low.x <= high.x && low.y <= high.y && low.z <= high.z;
            if !meet || normals[i].cross(normals[k]).length() > NEARLY_PARALLEL {
                return true;
            }
            let heights = corners[k].map(|p| (p - corners[i][0]).dot(normals[i]).abs());
            let [least, most] = [
                heights.into_iter().fold(f64::INFINITY, f64::min),
                heights.into_iter().fold(0.0, f64::max),
            ];
            // Neighbours that fold only a little share two corners.
            let is_in_plane = |h: &&f64| **h < IN_ONE_PLANE * in_plane;
            let shared = heights.iter().filter(is_in_plane).count();
            most < IN_ONE_PLANE * in_plane || least > APART * in_plane || shared == 2
        };
        corners.iter().all(is_thick)
            && (0..corners.len()).all(|i| (0..i).all(|k| are_apart(i, k) && are_apart(k, i)))
    }

    /// Which instructions it runs on.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// Distance up to which points lie in a plane, world units.
    pub fn in_plane(&self) -> f64 {
        f64::from(IN_PLANE) * self.frame.scale
    }

    /// The nearest face that each ray meets, in those it is asked for; `u32::MAX` is none. Of
    /// equally near ones the lowest.
    pub fn first_hits(&self, packet: &Packet) -> [u32; RAYS] {
        self.instructions.run(FirstHits { tree: self, packet })
    }

    /// One bit for each ray that meets something.
    pub fn occluded(&self, packet: &Packet) -> u32 {
        self.instructions.run(Occluded { tree: self, packet })
    }

    /// Uses these instructions from now on. The answers stay the same.
    #[cfg(test)]
    pub fn with(self, instructions: Instructions) -> Self {
        Self {
            instructions,
            ..self
        }
    }

    /// The same by asking each triangle.
    #[cfg(test)]
    pub fn flat(mut self) -> Self {
        let triangles = std::mem::take(&mut self.triangles);
        let everywhere = crate::aabb::Aabb {
            low: [-2.0; 3],
            high: [2.0; 3],
        };
        let mut bounds = [crate::aabb::Aabb::EMPTY; WIDTH];
        bounds[0] = everywhere;
        let mut children = [crate::bvh::Child::NONE; WIDTH];
        children[0] = crate::bvh::Child::leaf(0);
        self.nodes = vec![RayNode::new(&bounds, children)];
        self.leaf_starts = vec![0, triangles.len() as u32];
        self.triangles = triangles;
        self
    }

    #[inline(always)]
    fn leaf(&self, leaf: usize) -> &[Triangle] {
        &self.triangles[self.leaf_starts[leaf] as usize..self.leaf_starts[leaf + 1] as usize]
    }
}

/// The rays of a packet in the tree's coordinates, from where they enter it.
struct LocalPacket<S: Simd> {
    origin: [S::F32x8; 3],
    direction: [S::F32x8; 3],
    /// For boxes: one over the direction, and the origin moved both ways.
    inverse: [S::F32x8; 3],
    low_origin: [S::F32x8; 3],
    high_origin: [S::F32x8; 3],
    /// Distances from there at which they end; negative for those that are not asked for.
    end: [f32; RAYS],
}

impl<S: Simd> LocalPacket<S> {
    #[inline(always)]
    fn new(simd: S, frame: &LocalFrame, packet: &Packet) -> Self {
        let centre = frame.centre.to_array();
        let (mut local, mut inverses) = ([[0.0; RAYS]; 3], [[0.0; RAYS]; 3]);
        let (mut enter, mut exit) = ([0.0; RAYS], [0.0; RAYS]);
        for ray in 0..RAYS {
            enter[ray] = packet.range[0][ray] * frame.inverse_scale;
            exit[ray] = packet.range[1][ray] * frame.inverse_scale;
        }
        // The part of each ray within the tree: it lies between -1 and 1.
        let side = 1.0 + 2.0 * f64::from(BOX_MARGIN);
        for axis in 0..3 {
            for ray in 0..RAYS {
                let from = (packet.origin[axis][ray] - centre[axis]) * frame.inverse_scale;
                let speed = packet.direction[axis][ray];
                let is_slow = speed.abs() < SLOWEST;
                let inverse = 1.0
                    / if is_slow {
                        SLOWEST.copysign(speed)
                    } else {
                        speed
                    };
                let [first, last] = [(-side - from) * inverse, (side - from) * inverse];
                local[axis][ray] = from;
                inverses[axis][ray] = inverse;
                enter[ray] = enter[ray].max(first.min(last));
                exit[ray] = exit[ray].min(first.max(last));
            }
        }
        let mut end = [0.0; RAYS];
        for ray in 0..RAYS {
            // False for NaN.
            let is_asked = packet.mask >> ray & 1 == 1 && enter[ray] <= exit[ray];
            let length = (exit[ray] - enter[ray]) as f32;
            end[ray] = if is_asked { length } else { -1.0 };
        }
        let (mut origin, mut direction) = ([[0.0; RAYS]; 3], [[0.0; RAYS]; 3]);
        let (mut inverse, mut low, mut high) =
            ([[0.0; RAYS]; 3], [[0.0; RAYS]; 3], [[0.0; RAYS]; 3]);
        for axis in 0..3 {
            for ray in 0..RAYS {
                let is_asked = end[ray] >= 0.0;
                let place = local[axis][ray] + packet.direction[axis][ray] * enter[ray];
                // What is not asked for stays where it is.
                let place = if is_asked { place as f32 } else { 0.0 };
                let speed = packet.direction[axis][ray] as f32;
                origin[axis][ray] = place;
                direction[axis][ray] = if is_asked { speed } else { 0.0 };
                inverse[axis][ray] = if is_asked {
                    inverses[axis][ray] as f32
                } else {
                    1.0
                };
                low[axis][ray] = place - BOX_MARGIN;
                high[axis][ray] = place + BOX_MARGIN;
            }
        }
        Self {
            origin: load(simd, &origin),
            direction: load(simd, &direction),
            inverse: load(simd, &inverse),
            low_origin: load(simd, &low),
            high_origin: load(simd, &high),
            end,
        }
    }

    /// Which children any of the rays may enter before its end, and the least distance to where.
    #[inline(always)]
    fn children(&self, simd: S, node: &RayNode, end: S::F32x8) -> (u32, [f32; WIDTH]) {
        let mut found = 0;
        let mut nearest = [0.0; WIDTH];
        for (slot, nearest) in nearest.iter_mut().enumerate() {
            if node.children[slot].kind().is_none() {
                break;
            }
            let mut near = simd.splat(0.0);
            let mut far = end;
            for axis in 0..3 {
                let low = simd.splat(node.planes[axis][slot]) - self.high_origin[axis];
                let high = simd.splat(node.planes[axis + 3][slot]) - self.low_origin[axis];
                let (first, last) = (low * self.inverse[axis], high * self.inverse[axis]);
                // Zero stays zero, without a sign.
                near = first.min(last).max(near);
                far = far.min(first.max(last));
            }
            let mask = near.le(far);
            if mask != 0 {
                found |= 1 << slot;
                // Of the rays that enter it.
                let near = near.replaced(!mask, simd.splat(f32::INFINITY)).to_array();
                *nearest = near
                    .iter()
                    .fold(f32::INFINITY, |a, &b| if b < a { b } else { a });
            }
        }
        (found, nearest)
    }

    /// A linear function at points.
    #[inline(always)]
    fn at(simd: S, function: &[f32; 4], [x, y, z]: [S::F32x8; 3]) -> S::F32x8 {
        Self::along(simd, function, [x, y, z]) + simd.splat(function[3])
    }

    /// How it grows along vectors.
    #[inline(always)]
    fn along(simd: S, function: &[f32; 4], [x, y, z]: [S::F32x8; 3]) -> S::F32x8 {
        simd.splat(function[0]) * x + simd.splat(function[1]) * y + simd.splat(function[2]) * z
    }

    /// Distances at which rays meet the plane of a triangle, the heights at which they start, and
    /// one bit for each that does not start in the plane.
    #[inline(always)]
    fn plane(&self, simd: S, triangle: &Triangle) -> (S::F32x8, [S::F32x8; 2], u32) {
        let height = Self::at(simd, &triangle.height, self.origin);
        let rise = Self::along(simd, &triangle.height, self.direction);
        let zero = simd.splat(0.0);
        let t = (zero - height) / rise;
        let is_off = simd.splat(IN_PLANE).lt(height.abs()) & zero.lt(t);
        (t, [height, rise], is_off)
    }

    /// One bit for each ray that is inside of a triangle at these distances.
    #[inline(always)]
    fn inside(&self, simd: S, triangle: &Triangle, t: S::F32x8) -> u32 {
        let [ox, oy, oz] = self.origin;
        let [dx, dy, dz] = self.direction;
        let place = [ox + dx * t, oy + dy * t, oz + dz * t];
        let second = Self::at(simd, &triangle.second, place);
        let third = Self::at(simd, &triangle.third, place);
        let zero = simd.splat(0.0);
        zero.le(second) & zero.le(third) & (second + third).le(simd.splat(triangle.most))
    }
}

#[inline(always)]
fn load<S: Simd>(simd: S, numbers: &[[f32; RAYS]; 3]) -> [S::F32x8; 3] {
    let [x, y, z] = numbers;
    [simd.load(x), simd.load(y), simd.load(z)]
}

struct FirstHits<'a> {
    tree: &'a PacketTree,
    packet: &'a Packet,
}

impl Computation for FirstHits<'_> {
    type Output = [u32; RAYS];
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [u32; RAYS] {
        let tree = self.tree;
        let mut faces = [u32::MAX; RAYS];
        if tree.nodes.is_empty() {
            return faces;
        }
        let rays = LocalPacket::new(simd, &tree.frame, self.packet);
        let mut end = simd.load(&rays.end);
        let mut farthest = largest(&rays.end);
        let mut stack = Stack::with_root();
        while let Some((near, child)) = stack.pop() {
            if near > farthest {
                continue;
            }
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, near) = rays.children(simd, node, end);
                    stack.push_sorted(mask, &near, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    for triangle in tree.leaf(leaf) {
                        let (t, _, is_off) = rays.plane(simd, triangle);
                        let is_near = is_off & t.le(end);
                        if is_near == 0 {
                            continue;
                        }
                        let mut mask = is_near & rays.inside(simd, triangle, t);
                        let is_nearer = t.lt(end);
                        let mut rest = mask;
                        while rest != 0 {
                            let ray = rest.trailing_zeros() as usize % RAYS;
                            rest &= rest - 1;
                            // Of equally near ones the lowest face counts.
                            let bit = 1 << ray;
                            match is_nearer & bit != 0 || triangle.face < faces[ray] {
                                true => faces[ray] = triangle.face,
                                false => mask &= !bit,
                            }
                        }
                        if mask != 0 {
                            end = end.replaced(mask, t);
                            farthest = largest(&end.to_array());
                        }
                    }
                }
                None => {}
            }
        }
        faces
    }
}

struct Occluded<'a> {
    tree: &'a PacketTree,
    packet: &'a Packet,
}

impl Computation for Occluded<'_> {
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> u32 {
        let tree = self.tree;
        if tree.nodes.is_empty() {
            return 0;
        }
        let rays = LocalPacket::new(simd, &tree.frame, self.packet);
        let mut end = simd.load(&rays.end);
        let mut wanted = simd.splat(0.0).le(end);
        let asked = wanted;
        let mut stack = Stack::with_root();
        while wanted != 0
            && let Some((_, child)) = stack.pop()
        {
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, near) = rays.children(simd, node, end);
                    stack.push_sorted(mask, &near, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    for triangle in tree.leaf(leaf) {
                        let (t, [height, rise], is_off) = rays.plane(simd, triangle);
                        let is_before = is_off & t.lt(end);
                        if is_before == 0 {
                            continue;
                        }
                        let at_end = height + rise * end;
                        let ends_off = simd.splat(IN_PLANE).lt(at_end.abs());
                        let hit = is_before & ends_off & rays.inside(simd, triangle, t);
                        if hit != 0 {
                            wanted &= !hit;
                            end = end.replaced(hit, simd.splat(-1.0));
                        }
                    }
                }
                None => {}
            }
        }
        asked & !wanted
    }
}

#[inline(always)]
fn largest(numbers: &[f32; RAYS]) -> f32 {
    let mut largest = -1.0;
    for &number in numbers {
        largest = if number > largest { number } else { largest };
    }
    largest
}

/// Makes a packet of rays.
impl Packet {
    /// None is asked for yet.
    pub const EMPTY: Self = Self {
        origin: [[0.0; RAYS]; 3],
        direction: [[0.0; RAYS]; 3],
        range: [[0.0; RAYS], [f64::INFINITY; RAYS]],
        mask: 0,
    };

    /// Asks for a ray.
    pub fn set(&mut self, ray: usize, origin: Vec3, direction: Vec3, [from, to]: [f64; 2]) {
        let (origin, direction) = (origin.to_array(), direction.to_array());
        let _: [(); 3] = array::from_fn(|axis| {
            self.origin[axis][ray] = origin[axis];
            self.direction[axis][ray] = direction[axis];
        });
        self.range[0][ray] = from;
        self.range[1][ray] = to;
        self.mask |= 1 << ray;
    }
}
