//! First hits and occlusion, in batches.

use std::sync::Arc;

use capwalk_geometry::buffers::NONE;
use capwalk_geometry::{Hit, LocalFrame, Mesh, Ray, RayTree};
use rayon::prelude::*;

use crate::batch::{self, Shape};
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::kernels::{FIRST_HIT, OCCLUDED};
use crate::layout::ray::{HIT_NUMBERS, RAY};
use crate::local_ray::{LocalRay, write_miss};
use crate::refit::{Primitives, Refit};
use crate::resident::{Arrays, Resident};

/// A [`RayTree`] on the device.
#[derive(Debug)]
pub struct DeviceRayTree {
    gpu: Arc<Gpu>,
    frame: LocalFrame,
    tree: Option<Resident>,
    /// What is below each child, for the first refit.
    below: Vec<u32>,
    refit: Option<Refit>,
}

impl DeviceRayTree {
    /// Uploads the tree.
    pub fn new(gpu: &Arc<Gpu>, tree: &RayTree) -> Result<Self, GpuError> {
        let buffers = tree.buffers();
        let tree = Resident::new(
            gpu,
            &Arrays {
                nodes: &buffers.nodes,
                leaf_starts: &buffers.leaf_starts,
                exact: &buffers.triangles,
                local: &buffers.local_triangles(),
                rough: &buffers.faces,
                primitives: buffers.faces.len(),
            },
        )?;
        Ok(Self {
            gpu: gpu.clone(),
            frame: buffers.frame,
            tree,
            below: buffers.below,
            refit: None,
        })
    }

    /// Follows moved vertices, as [`RayTree::refit`] does on the CPU: the mesh must be the
    /// one that the tree was built from, with any other finite positions. Positions are uploaded,
    /// all else is done on the device; the first call also uploads the faces, and takes memory
    /// for a second copy of the tree. Answers are those of a new tree; they only take longer the
    /// less the mesh resembles the one that the tree was built for. To build anew, or to follow a
    /// tree that the CPU has refitted anyway, there is [`new`](Self::new).
    ///
    /// After an error the tree is what it was: [`GpuError::OtherMesh`] if vertices or faces are
    /// not as many as they were, as far as that is known, or a position is not finite. That faces
    /// have the same corners as before is not checked.
    pub fn refit(&mut self, mesh: &Mesh) -> Result<(), GpuError> {
        self.gpu.check()?;
        let Some(tree) = &mut self.tree else {
            return Ok(());
        };
        let what = (&Primitives::Triangles, &self.below[..]);
        self.frame = Refit::move_tree(&mut self.refit, &self.gpu, tree, what, mesh)?;
        Ok(())
    }

    /// The nearest intersection within each ray's bounds; of equally near ones that of the
    /// lowest face.
    pub fn first_hits(&self, rays: &[Ray]) -> Result<Vec<Option<Hit>>, GpuError> {
        let shape = Shape {
            kernel: &FIRST_HIT,
            numbers: RAY,
            answers: 1,
            values: HIT_NUMBERS,
        };
        let precision = self.gpu.precision();
        let mut hits = Vec::with_capacity(rays.len());
        self.run(shape, rays, |rays, faces, values| {
            let values = values.as_chunks::<HIT_NUMBERS>().0;
            let answers = rays.par_iter().zip(faces).zip(values);
            hits.par_extend(answers.map(|((ray, &face), &[t, v, w])| {
                let is_hit = face != NONE;
                let local = is_hit.then(|| LocalRay::new(&self.frame, ray, precision));
                local.flatten().map(|local| Hit {
                    face,
                    t: local.distance(t, precision),
                    barycentric: [v, w],
                })
            }));
        })?;
        hits.resize(rays.len(), None);
        Ok(hits)
    }

    /// True if anything lies within each ray's bounds.
    pub fn occluded(&self, rays: &[Ray]) -> Result<Vec<bool>, GpuError> {
        let shape = Shape {
            kernel: &OCCLUDED,
            numbers: RAY,
            answers: 1,
            values: 0,
        };
        let mut occluded = Vec::with_capacity(rays.len());
        self.run(shape, rays, |_, faces, _| {
            occluded.extend(faces.iter().map(|&face| face != NONE));
        })?;
        occluded.resize(rays.len(), false);
        Ok(occluded)
    }

    /// Nothing comes back from a tree without triangles.
    fn run(
        &self,
        shape: Shape,
        rays: &[Ray],
        finish: impl FnMut(&[Ray], &[u32], &[f64]),
    ) -> Result<(), GpuError> {
        self.gpu.check()?;
        let Some(tree) = &self.tree else {
            return Ok(());
        };
        let precision = self.gpu.precision();
        let prepare = |ray: &Ray, view: &mut [u32], numbers: &mut [f64]| match LocalRay::new(
            &self.frame,
            ray,
            precision,
        ) {
            Some(local) => local.write(ray, precision, view, numbers),
            None => write_miss(view),
        };
        batch::ask(&self.gpu, tree, shape, rays, prepare, finish)
    }
}
