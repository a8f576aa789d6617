//! Bundles of rays against triangles, in single precision.
//!
//! In the tree's own coordinates, which are at most 1, a triangle is three linear functions of a
//! point: the height above its plane, and the weights of its second and third corner; so are two
//! that make a parallelogram. All of it is products added to sums in a fixed order, each rounded
//! once (by slow code of the library on old CPUs): the bits are the same on every CPU,
//! and those of one ray do not depend on the others.
//!
//! What single precision cannot resolve is decided once: points within [`IN_PLANE`] of a plane lie
//! in it. Rays do not meet the planes in which they start, nor segments those in which they end,
//! and triangles are larger by as much, so that nothing shines through between neighbours. That is for
//! scenes in which so much is nothing: [`PacketTree::resolves`].
//!
//! Spheres are to packets what they are to single rays: their faces are met in double precision, also
//! by rays that start or end on them.

use capwalk_math::Vec3;

use super::bundle::{BUNDLE, Bundle, NO_FACE};
use super::local_packet::{LocalPacket, Slabs};
use super::packet_face::PacketFace;
use super::packet_precision::{IN_PLANE, MOST_OUT};
use super::ray_kernel::RayNode;
use super::ray_search;
use super::ray_tree::RayTree;
use super::sphere::MeshSphere;
use super::sphere_bundle::RaysToSphere;
use super::triangle_tree::{Part, SpherePart};
use crate::bvh::{Child, ChildKind, Stack};
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;
use crate::ray::{Hit, RayShear};
use crate::simd::{Computation, F32x16, Instructions, Lanes, Simd};

/// How many times [`IN_PLANE`] the altitudes of triangles must be.
const LEAST_ALTITUDE: f64 = 1000.0;

/// Surfaces that are nearly parallel must be so many times [`IN_PLANE`] apart, or in one plane, which
/// is a part of it.
const APART: f64 = 16.0;
const IN_ONE_PLANE: f64 = 1e-3;

/// Sine of the angle between planes that are nearly parallel.
const NEARLY_PARALLEL: f64 = 0.01;

/// So many faces and spheres are asked one after the other, without boxes.
const FEW_PIECES: usize = 24;

/// Faces are numbered in single precision.
const MOST_FACES: usize = 1 << 24;

/// A tree of triangles for packets of rays.
#[derive(Clone, Debug)]
pub struct PacketTree {
    frame: LocalFrame,
    /// None if the faces are few.
    nodes: Vec<RayNode>,
    faces: Vec<PacketFace>,
    /// Where the faces of each leaf start, and at last where they all end.
    leaf_starts: Vec<u32>,
    /// They have the numbers of leaves behind those.
    spheres: Vec<SpherePart>,
    instructions: Instructions,
}

impl PacketTree {
    /// The tree of a mesh, from that for its rays.
    pub fn new(rays: &RayTree, mesh: &Mesh) -> Self {
        let frame = tight(&rays.flat.frame, mesh);
        let (faces, numbers) = PacketFace::all(mesh, &rays.single_faces(), &frame);
        let parts = rays.flat.parts.iter();
        let spheres = parts.filter_map(|part| match part {
            Part::Sphere(sphere) => Some(sphere.clone()),
            Part::Tree(_) => None,
        });
        let spheres: Vec<_> = spheres.collect();
        let is_small = faces.len() + spheres.len() <= FEW_PIECES;
        let tree = Self {
            frame,
            nodes: Vec::new(),
            leaf_starts: vec![0],
            faces,
            spheres,
            instructions: Instructions::detect(),
        };
        match is_small {
            true => tree,
            false => tree.with_nodes(rays, &numbers),
        }
    }

    /// This tree with the nodes of a tree for rays. A parallelogram is in the leaves of both its
    /// triangles, each of whose boxes has its own.
    fn with_nodes(mut self, rays: &RayTree, numbers: &[Option<u32>]) -> Self {
        let all = std::mem::take(&mut self.faces);
        for leaf in 0..rays.hierarchy.leaf_count() {
            // A sphere's leaf has the number of its first face, which is none of the others.
            let faces = rays.hierarchy.leaf(leaf).iter();
            let mut own: Vec<u32> = faces.filter_map(|&face| numbers[face as usize]).collect();
            own.sort_unstable();
            own.dedup();
            self.faces
                .extend(own.iter().map(|&number| all[number as usize]));
            self.leaf_starts.push(self.faces.len() as u32);
        }
        let larger = (rays.flat.frame.scale / self.frame.scale) as f32;
        self.nodes = rays.flat.nodes.clone();
        for planes in self.nodes.iter_mut().flat_map(|node| &mut node.planes) {
            // Boxes are larger by much more than is rounded here.
            planes
                .as_flattened_mut()
                .iter_mut()
                .for_each(|plane| *plane *= larger);
        }
        self
    }

    /// True if single precision resolves the mesh from which the tree was made, whose spheres need none. No
    /// other triangle is thin beside what lies in a plane, or has a very sharp corner; no two that are
    /// nearly parallel are nearly, but not quite, in one plane where their boxes meet; and no face of a
    /// sphere is nearly in the plane of one. Takes time in proportion to the square of their number.
    pub fn resolves(&self, rays: &RayTree, mesh: &Mesh) -> bool {
        let single = rays.single_faces();
        let corners = single.iter().map(|&face| mesh.corners(face as usize));
        let corners: Vec<[Vec3; 3]> = corners.collect();
        let crosses = single.iter().map(|&face| mesh.face_cross(face as usize));
        let normals: Vec<Vec3> = crosses.map(Vec3::normalized).collect();
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
        // From the face of a sphere that lies in a plane, rays would not meet what is there.
        let lies_in_plane = |sphere: &MeshSphere| {
            let mut planes = corners.iter().zip(&normals);
            planes.any(|(&[a, ..], &normal)| sphere.lies_in_plane([a, normal], APART * in_plane))
        };
        mesh.faces.len() <= MOST_FACES
            && !(self.spheres.iter()).any(|part| lies_in_plane(&part.sphere))
            && corners.iter().all(is_thick)
            && (0..corners.len()).all(|i| (0..i).all(|k| are_apart(i, k) && are_apart(k, i)))
    }

    /// True if rays need ranges that tell whether they meet again the spheres on which they start or
    /// end.
    pub fn has_spheres(&self) -> bool {
        !self.spheres.is_empty()
    }

    /// Which instructions it runs on.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// Distance up to which points lie in a plane, world units.
    pub fn in_plane(&self) -> f64 {
        f64::from(IN_PLANE) * self.frame.scale
    }

    /// The nearest face that each ray meets, of those that are asked for; `u32::MAX` is none. Of
    /// equally near ones the lowest of spheres, else the lowest. Directions must have about unit length.
    pub fn first_hits(&self, packet: &Bundle<'_>) -> [u32; BUNDLE] {
        self.instructions.run(FirstHits { tree: self, packet })
    }

    /// One bit for each ray that meets something.
    pub fn occluded(&self, packet: &Bundle<'_>) -> u32 {
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

    /// The tree with boxes however few the faces are, and without however many they are.
    #[cfg(test)]
    pub fn deep_and_flat(&self, rays: &RayTree, mesh: &Mesh) -> [Self; 2] {
        let (faces, numbers) = PacketFace::all(mesh, &rays.single_faces(), &self.frame);
        let flat = Self {
            nodes: Vec::new(),
            leaf_starts: vec![0],
            faces,
            ..self.clone()
        };
        [flat.clone().with_nodes(rays, &numbers), flat]
    }

    #[inline(always)]
    fn leaf(&self, leaf: usize) -> Leaf<'_> {
        match self.leaf_starts.get(leaf + 1) {
            Some(&end) => Leaf::Faces(&self.faces[self.leaf_starts[leaf] as usize..end as usize]),
            None => Leaf::Sphere(&self.spheres[leaf + 1 - self.leaf_starts.len()]),
        }
    }
}

/// What a leaf has.
enum Leaf<'a> {
    Faces(&'a [PacketFace]),
    Sphere(&'a SpherePart),
}

/// The rays of a packet, for spheres.
#[inline(always)]
fn to_sphere<'a>(packet: &'a Bundle<'_>) -> RaysToSphere<'a, impl Fn(usize) -> RayShear> {
    RaysToSphere {
        rays: packet,
        shear: |ray| RayShear::new(packet.direction_of(ray)).expect("it passes the sphere"),
    }
}

/// The coordinates of a tree for rays, scaled until the mesh reaches -1 or 1: what single precision does
/// not resolve of the world is up to half as large.
fn tight(frame: &LocalFrame, mesh: &Mesh) -> LocalFrame {
    let corners = (0..mesh.faces.len()).flat_map(|face| mesh.corners(face));
    let reach = |p| frame.local_from_world(p).map(f64::abs).max_component();
    // The other's power of two is at most twice too large, but where the mesh has no extent.
    let scale = frame.scale * corners.map(reach).fold(0.5, f64::max);
    LocalFrame {
        scale,
        inverse_scale: 1.0 / scale,
        ..*frame
    }
}

/// The nearest faces so far. Of equally near ones, as far as single precision tells, faces of spheres
/// count before others, and then the lowest, so that the order does not matter in which they are asked.
struct Nearest<S: Simd> {
    distance: S::F32x16,
    /// Their numbers, infinite where there is none, and [`of_sphere`] for those of spheres.
    face: S::F32x16,
    /// Where rays end in the world, or hit the nearest face of a sphere.
    t: [f64; BUNDLE],
}

/// Marks the number of a sphere's face, so that it is less than any other; the same again takes the mark
/// off.
#[inline(always)]
fn of_sphere(number: f32) -> f32 {
    -1.0 - number
}

impl<S: Simd> Nearest<S> {
    /// Asks a face; true if it is nearer for any ray. Without a branch: CPUs rarely
    /// foresee whether any ray meets it.
    #[inline(always)]
    fn ask(&mut self, simd: S, rays: &LocalPacket<S>, face: &PacketFace) -> bool {
        let met = face.plane(simd, rays);
        let (number, is_inside) = face.at(simd, rays, met.distance);
        let is_lower = met.distance.le(self.distance) & number.lt(self.face);
        let is_before = met.distance.lt(self.distance) | is_lower;
        let mask = met.mask & is_inside & is_before;
        self.distance = self.distance.replaced(mask, met.distance);
        self.face = self.face.replaced(mask, number);
        mask != 0
    }

    /// Asks a sphere; true if it is nearer for any ray.
    #[inline(always)]
    fn ask_sphere(
        &mut self,
        simd: S,
        rays: &LocalPacket<S>,
        search: &FirstHits<'_>,
        part: &SpherePart,
    ) -> bool {
        let frame = &search.tree.frame;
        let (mut distance, mut numbers) = (self.distance.to_array(), self.face.to_array());
        let mut t_max = self.t;
        let mut faces = [NO_FACE; BUNDLE];
        for ray in 0..BUNDLE {
            if numbers[ray] < 0.0 {
                faces[ray] = of_sphere(numbers[ray]) as u32;
            } else if numbers[ray] < f32::INFINITY {
                let end = rays.end_in_world(frame, ray, distance[ray]);
                t_max[ray] = t_max[ray].min(end);
            }
        }
        let asked = simd.splat_16(0.0).le(rays.end);
        let to_sphere = to_sphere(search.packet);
        let [mut hit, mut unknown] =
            to_sphere.first_hits(simd, &part.sphere, asked, &mut t_max, &mut faces);
        while unknown != 0 {
            let ray = unknown.trailing_zeros() as usize % BUNDLE;
            unknown &= unknown - 1;
            if let Some(found) = search.alone(part, ray, t_max[ray])
                && (found.t, found.face) < (t_max[ray], faces[ray])
            {
                (t_max[ray], faces[ray]) = (found.t, found.face);
                hit |= 1 << ray;
            }
        }
        let mut nearer = 0;
        while hit != 0 {
            let ray = hit.trailing_zeros() as usize % BUNDLE;
            hit &= hit - 1;
            let at = rays.distance_in_tree(frame, ray, t_max[ray]);
            if at <= distance[ray] {
                self.t[ray] = t_max[ray];
                distance[ray] = at;
                numbers[ray] = of_sphere(faces[ray] as f32);
                nearer |= 1 << ray;
            }
        }
        if nearer != 0 {
            self.distance = simd.load_16(&distance);
            self.face = simd.load_16(&numbers);
        }
        nearer != 0
    }
}

struct FirstHits<'a> {
    tree: &'a PacketTree,
    packet: &'a Bundle<'a>,
}

impl FirstHits<'_> {
    /// The nearest hit of one ray on a sphere.
    #[cold]
    fn alone(&self, part: &SpherePart, ray: usize, t_max: f64) -> Option<Hit> {
        let instructions = self.tree.instructions;
        instructions.run(ray_search::FirstHit {
            tree: part.tree(),
            instructions,
            ray: &self.packet.ray(ray, t_max),
            before: None,
        })
    }
}

impl Computation for FirstHits<'_> {
    type Output = [u32; BUNDLE];
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [u32; BUNDLE] {
        let tree = self.tree;
        let rays = LocalPacket::new(simd, &tree.frame, self.packet);
        let mut nearest = Nearest {
            distance: rays.end,
            face: simd.splat_16(f32::INFINITY),
            t: *self.packet.range[1],
        };
        if tree.nodes.is_empty() {
            for face in &tree.faces {
                nearest.ask(simd, &rays, face);
            }
            for part in &tree.spheres {
                nearest.ask_sphere(simd, &rays, &self, part);
            }
        } else {
            let slabs = Slabs::new(simd, &rays);
            let mut farthest = rays.end.largest();
            let mut stack = Stack::with(Child::node(0));
            while let Some(child) = stack.pop(farthest) {
                match child.kind() {
                    Some(ChildKind::Node(node)) => {
                        let node = &tree.nodes[node];
                        let (mask, near) = slabs.children(simd, node, nearest.distance);
                        stack.push_sorted(mask, &near, &node.children);
                    }
                    Some(ChildKind::Leaf(leaf)) => {
                        let is_nearer = match tree.leaf(leaf) {
                            Leaf::Faces(faces) => faces.iter().fold(false, |is_nearer, face| {
                                nearest.ask(simd, &rays, face) | is_nearer
                            }),
                            Leaf::Sphere(part) => nearest.ask_sphere(simd, &rays, &self, part),
                        };
                        if is_nearer {
                            farthest = nearest.distance.largest();
                        }
                    }
                    None => {}
                }
            }
        }
        let number_of = |number: f32| match number < 0.0 {
            true => of_sphere(number),
            false => number,
        };
        // What is infinite becomes the largest integer.
        (nearest.face.to_array()).map(|number| number_of(number) as u32)
    }
}

/// Rays that met nothing so far.
struct Unhidden<S: Simd> {
    /// Where they end; negative for those that met something.
    end: S::F32x16,
    mask: u32,
}

impl<S: Simd> Unhidden<S> {
    /// Asks a sphere.
    #[inline(always)]
    fn ask_sphere(&mut self, simd: S, search: &Occluded<'_>, part: &SpherePart) {
        let packet = search.packet;
        let [mut hit, mut unknown] =
            to_sphere(packet).occluded(simd, &part.sphere, self.mask, packet.range[1]);
        while unknown != 0 {
            let ray = unknown.trailing_zeros() as usize % BUNDLE;
            unknown &= unknown - 1;
            hit |= u32::from(search.alone(part, ray)) << ray;
        }
        self.mask &= !hit;
        self.end = self.end.replaced(hit, simd.splat_16(-1.0));
    }

    /// Asks a face.
    #[inline(always)]
    fn ask(&mut self, simd: S, rays: &LocalPacket<S>, face: &PacketFace) {
        let met = face.plane(simd, rays);
        let is_before = met.mask & met.distance.lt(self.end);
        if is_before == 0 {
            return;
        }
        let at_end = met.rise.fused(self.end, met.height);
        let ends_off = simd.splat_16(IN_PLANE).lt(at_end.abs());
        let hit = is_before & ends_off & face.at(simd, rays, met.distance).1;
        if hit != 0 {
            self.mask &= !hit;
            self.end = self.end.replaced(hit, simd.splat_16(-1.0));
        }
    }
}

struct Occluded<'a> {
    tree: &'a PacketTree,
    packet: &'a Bundle<'a>,
}

impl Occluded<'_> {
    /// True if one ray hits a sphere.
    #[cold]
    fn alone(&self, part: &SpherePart, ray: usize) -> bool {
        let instructions = self.tree.instructions;
        instructions.run(ray_search::Occluded {
            tree: part.tree(),
            instructions,
            ray: &self.packet.ray(ray, self.packet.range[1][ray]),
        })
    }
}

impl Computation for Occluded<'_> {
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> u32 {
        let tree = self.tree;
        let rays = LocalPacket::new(simd, &tree.frame, self.packet);
        let asked = simd.splat_16(0.0).le(rays.end);
        let mut unhidden = Unhidden {
            end: rays.end,
            mask: asked,
        };
        if tree.nodes.is_empty() {
            for face in &tree.faces {
                if unhidden.mask == 0 {
                    break;
                }
                unhidden.ask(simd, &rays, face);
            }
            for part in &tree.spheres {
                if unhidden.mask == 0 {
                    break;
                }
                unhidden.ask_sphere(simd, &self, part);
            }
            return asked & !unhidden.mask;
        }
        let slabs = Slabs::new(simd, &rays);
        let mut stack = Stack::with(Child::node(0));
        while unhidden.mask != 0
            && let Some(child) = stack.pop(f32::INFINITY)
        {
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (mask, near) = slabs.children(simd, node, unhidden.end);
                    stack.push_sorted(mask, &near, &node.children);
                }
                Some(ChildKind::Leaf(leaf)) => match tree.leaf(leaf) {
                    Leaf::Faces(faces) => {
                        for face in faces {
                            unhidden.ask(simd, &rays, face);
                        }
                    }
                    Leaf::Sphere(part) => unhidden.ask_sphere(simd, &self, part),
                },
                None => {}
            }
        }
        asked & !unhidden.mask
    }
}
