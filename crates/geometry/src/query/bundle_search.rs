//! The search for what the rays of a bundle hit.
//!
//! Rays that go the same way visit mostly the same nodes: they go down the tree together, and each
//! node is read once. Where few are left they go on one by one. Answers are those of single rays.

use super::beam::Beam;
use super::bundle::{BUNDLE, Bundle, NO_FACE};
use super::local_bundle::{Filled, LocalBundle};
use super::ray_kernel::TriangleBlock;
use super::ray_search::{FirstHit, Occluded};
use super::sphere_bundle::RaysToSphere;
use super::triangle_tree::TriangleTree;
use crate::bvh::{Child, ChildKind, Stack, VisitOfRays};
use crate::ray::{Hit, RayShear};
use crate::simd::{Computation, F32x16, Instructions, Simd};

/// So few rays are traced one by one.
const FEW: u32 = 3;

/// The nearest faces that rays hit in a tree.
pub struct FirstHits<'a> {
    pub tree: &'a TriangleTree,
    pub instructions: Instructions,
    pub rays: &'a Bundle<'a>,
}

impl Computation for FirstHits<'_> {
    type Output = [u32; BUNDLE];
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [u32; BUNDLE] {
        let mut best = Best {
            t: *self.rays.range[1],
            faces: [NO_FACE; BUNDLE],
        };
        if self.tree.nodes.is_empty() {
            return best.faces;
        }
        let mut room = None;
        let rays = Filled::all(&mut room, self.rays);
        let local = LocalBundle::new(&self.tree.frame, &rays);
        let mut rest = local.mask;
        while rest != 0 {
            if let Some(beam) = self.tree.beam(simd, &local, rest) {
                self.together(simd, &beam, &mut best);
                rest &= !beam.mask;
                continue;
            }
            let ray = rest.trailing_zeros() as usize % BUNDLE;
            rest &= rest - 1;
            self.alone(simd, &local, Child::node(0), ray, &mut best);
        }
        best.faces
    }
}

/// The nearest hits so far.
struct Best {
    /// Their distances, or where rays end.
    t: [f64; BUNDLE],
    faces: [u32; BUNDLE],
}

impl TriangleTree {
    /// Those of some rays that go through it together with the first.
    #[inline(always)]
    fn beam<'a, S: Simd>(
        &self,
        simd: S,
        local: &'a LocalBundle<'a>,
        rays: u32,
    ) -> Option<Beam<'a, S>> {
        match self.has_no_trees {
            true => Beam::of_first(simd, local, rays, FEW),
            false => None,
        }
    }
}

impl FirstHits<'_> {
    /// Searches for what rays hit that go down the tree together.
    #[inline(always)]
    fn together<S: Simd>(&self, simd: S, beam: &Beam<'_, S>, best: &mut Best) {
        let tree = self.tree;
        let mut limits = beam.limits();
        let mut farthest = simd.load_16(&limits).largest();
        let mut stack = Stack::with(VisitOfRays {
            child: Child::node(0),
            rays: beam.mask,
        });
        while let Some(VisitOfRays { child, mut rays }) = stack.pop(farthest) {
            if rays.count_ones() <= FEW {
                while rays != 0 {
                    let ray = rays.trailing_zeros() as usize % BUNDLE;
                    rays &= rays - 1;
                    self.alone(simd, beam.local, child, ray, best);
                    limits[ray] = beam.local.limit(ray, best.t[ray]);
                }
                farthest = simd.load_16(&limits).largest();
                continue;
            }
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (found, near, visits) = beam.children(simd, node, rays, &limits, farthest);
                    stack.push_sorted(found, &near, &visits);
                }
                Some(ChildKind::Leaf(leaf)) => {
                    match tree.leaves.get(leaf) {
                        Some(block) => self.leaf(simd, beam, block, rays, best, &mut limits),
                        None => self.sphere(simd, beam, child, rays, best, &mut limits),
                    }
                    farthest = simd.load_16(&limits).largest();
                }
                None => {}
            }
        }
    }

    #[inline(always)]
    fn leaf<S: Simd>(
        &self,
        simd: S,
        beam: &Beam<'_, S>,
        block: &TriangleBlock,
        rays: u32,
        best: &mut Best,
        limits: &mut [f32; BUNDLE],
    ) {
        for (lane, face) in block.faces().enumerate() {
            let faces = &mut best.faces;
            beam.intersect(simd, block, lane, rays, &mut best.t, |ray, t, t_max| {
                // Of hits at one distance the lowest face counts.
                if t < t_max[ray] || face < faces[ray] {
                    t_max[ray] = t;
                    faces[ray] = face;
                    limits[ray] = beam.local.limit(ray, t);
                }
            });
        }
    }

    #[inline(always)]
    fn sphere<S: Simd>(
        &self,
        simd: S,
        beam: &Beam<'_, S>,
        child: Child,
        rays: u32,
        best: &mut Best,
        limits: &mut [f32; BUNDLE],
    ) {
        let (sphere, local) = (self.tree.sphere(child), beam.local);
        let [mut hit, mut rest] =
            to_sphere(local).first_hits(simd, sphere, rays, &mut best.t, &mut best.faces);
        while hit != 0 {
            let ray = hit.trailing_zeros() as usize % BUNDLE;
            hit &= hit - 1;
            limits[ray] = local.limit(ray, best.t[ray]);
        }
        while rest != 0 {
            let ray = rest.trailing_zeros() as usize % BUNDLE;
            rest &= rest - 1;
            self.alone(simd, local, child, ray, best);
            limits[ray] = local.limit(ray, best.t[ray]);
        }
    }

    /// Searches for what one ray hits below a child of a node.
    #[inline(always)]
    fn alone<S: Simd>(
        &self,
        simd: S,
        local: &LocalBundle<'_>,
        child: Child,
        ray: usize,
        best: &mut Best,
    ) {
        let (t, face) = (best.t[ray], best.faces[ray]);
        let search = FirstHit {
            tree: self.tree,
            instructions: self.instructions,
            ray: &local.rays.ray(ray, t),
            before: (face != NO_FACE).then_some(Hit {
                t,
                face,
                barycentric: [0.0; 2],
            }),
        };
        if let Some(hit) = search.below(simd, &local.local_ray(simd, ray), child) {
            best.t[ray] = hit.t;
            best.faces[ray] = hit.face;
        }
    }
}

/// Which rays hit anything in a tree.
pub struct OccludedRays<'a> {
    pub tree: &'a TriangleTree,
    pub instructions: Instructions,
    pub rays: &'a Bundle<'a>,
}

impl Computation for OccludedRays<'_> {
    type Output = u32;
    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> u32 {
        if self.tree.nodes.is_empty() {
            return 0;
        }
        let mut room = None;
        let rays = Filled::all(&mut room, self.rays);
        let local = LocalBundle::new(&self.tree.frame, &rays);
        let (mut rest, mut occluded) = (local.mask, 0);
        while rest != 0 {
            if let Some(beam) = self.tree.beam(simd, &local, rest) {
                occluded |= self.together(simd, &beam);
                rest &= !beam.mask;
                continue;
            }
            let ray = rest.trailing_zeros() as usize % BUNDLE;
            rest &= rest - 1;
            let is_occluded = self.alone(simd, &local, Child::node(0), ray);
            occluded |= u32::from(is_occluded) << ray;
        }
        occluded
    }
}

impl OccludedRays<'_> {
    /// One bit for each ray that hits anything, where they go down the tree together.
    #[inline(always)]
    fn together<S: Simd>(&self, simd: S, beam: &Beam<'_, S>) -> u32 {
        let tree = self.tree;
        let mut t_max = *self.rays.range[1];
        let limits = beam.limits();
        let farthest = simd.load_16(&limits).largest();
        let mut free = beam.mask;
        let mut stack = Stack::with(VisitOfRays {
            child: Child::node(0),
            rays: beam.mask,
        });
        while free != 0
            && let Some(VisitOfRays { child, rays }) = stack.pop(farthest)
        {
            let mut rays = rays & free;
            if rays.count_ones() <= FEW {
                while rays != 0 {
                    let ray = rays.trailing_zeros() as usize % BUNDLE;
                    rays &= rays - 1;
                    let is_occluded = self.alone(simd, beam.local, child, ray);
                    free &= !(u32::from(is_occluded) << ray);
                }
                continue;
            }
            match child.kind() {
                Some(ChildKind::Node(node)) => {
                    let node = &tree.nodes[node];
                    let (found, near, visits) = beam.children(simd, node, rays, &limits, farthest);
                    stack.push_sorted(found, &near, &visits);
                }
                Some(ChildKind::Leaf(leaf)) => match tree.leaves.get(leaf) {
                    Some(block) => {
                        for lane in 0..block.faces().count() {
                            beam.intersect(
                                simd,
                                block,
                                lane,
                                rays & free,
                                &mut t_max,
                                |ray, _, _| {
                                    free &= !(1 << ray);
                                },
                            );
                        }
                    }
                    None => free &= !self.sphere(simd, beam, child, rays & free),
                },
                None => {}
            }
        }
        beam.mask & !free
    }

    /// One bit for each of some rays that hits a sphere.
    #[inline(always)]
    fn sphere<S: Simd>(&self, simd: S, beam: &Beam<'_, S>, child: Child, rays: u32) -> u32 {
        let (sphere, local) = (self.tree.sphere(child), beam.local);
        let [mut hit, mut rest] =
            to_sphere(local).occluded(simd, sphere, rays, local.rays.range[1]);
        while rest != 0 {
            let ray = rest.trailing_zeros() as usize % BUNDLE;
            rest &= rest - 1;
            hit |= u32::from(self.alone(simd, local, child, ray)) << ray;
        }
        hit
    }

    /// True if one ray hits anything below a child of a node.
    #[inline(always)]
    fn alone<S: Simd>(&self, simd: S, local: &LocalBundle<'_>, child: Child, ray: usize) -> bool {
        let search = Occluded {
            tree: self.tree,
            instructions: self.instructions,
            ray: &local.rays.ray(ray, self.rays.range[1][ray]),
        };
        search.below(simd, &local.local_ray(simd, ray), child)
    }
}

/// The rays, for spheres.
#[inline(always)]
fn to_sphere<'a>(local: &'a LocalBundle<'_>) -> RaysToSphere<'a, impl Fn(usize) -> RayShear> {
    RaysToSphere {
        rays: &local.rays,
        shear: |ray| local.shear(ray),
    }
}
