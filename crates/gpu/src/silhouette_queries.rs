//! Closest silhouettes, and all in a cone, in batches.

use std::sync::Arc;

use capwalk_geometry::buffers::{EDGE, NONE};
use capwalk_geometry::{ConeQuery, LocalFrame, Mesh, SilhouettePoint, SilhouetteTree};
use capwalk_math::{Vec3, sphere};
use rayon::prelude::*;

use crate::batch::{self, Shape};
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::kernels::{CLOSEST, GATHER};
use crate::layout::cone::{CONE, NEAREST_NUMBERS};
use crate::local_cone;
use crate::precision::Precision;
use crate::refit::{Primitives, Refit};
use crate::resident::{Arrays, Resident};

/// A [`SilhouetteTree`] on the device.
#[derive(Debug)]
pub struct DeviceSilhouetteTree {
    gpu: Arc<Gpu>,
    frame: LocalFrame,
    tree: Option<Resident>,
    edges: usize,
    /// What is below each child, and what edges are of, for the first refit.
    below: Vec<u32>,
    primitives: Primitives,
    refit: Option<Refit>,
}

/// Which edges meet each cone of a batch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gathered {
    starts: Vec<usize>,
    edges: Vec<u32>,
    overflowed: usize,
}

impl Gathered {
    /// The edges that meet the cone with this number, in an order that depends on the tree,
    /// the cone and the device.
    pub fn of(&self, query: usize) -> &[u32] {
        &self.edges[self.starts[query]..self.starts[query + 1]]
    }

    /// How many cones met more edges than the capacity, and were asked a second
    /// time with capacity for all: many of them make a larger capacity worth while.
    pub fn overflowed(&self) -> usize {
        self.overflowed
    }
}

impl DeviceSilhouetteTree {
    /// Uploads the tree.
    pub fn new(gpu: &Arc<Gpu>, tree: &SilhouetteTree) -> Result<Self, GpuError> {
        let buffers = tree.buffers();
        let local = buffers.local_edges();
        let tree = Resident::new(
            gpu,
            &Arrays {
                nodes: &buffers.nodes,
                leaf_starts: &buffers.leaf_starts,
                exact: &buffers.ends_and_normals,
                local: &local,
                rough: &rough(&local, &buffers.edges),
                primitives: buffers.edges.len() / 2,
            },
        )?;
        Ok(Self {
            gpu: gpu.clone(),
            frame: buffers.frame,
            tree,
            edges: buffers.edges.len() / 2,
            below: buffers.below,
            primitives: Primitives::Edges(buffers.sides),
            refit: None,
        })
    }

    /// Follows moved vertices, as [`SilhouetteTree::refit`] does on the CPU: the mesh must
    /// be the one that the tree was built from, with any other finite positions. Positions are
    /// uploaded, all else is done on the device (but for the normals of faces in single
    /// precision); the first call also uploads the faces, and takes memory for a second copy of
    /// the tree. Answers are those of a new tree over the same edges, in single
    /// precision with a rounding more in edges' directions; they only take longer the
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
        let what = (&self.primitives, &self.below[..]);
        self.frame = Refit::move_tree(&mut self.refit, &self.gpu, tree, what, mesh)?;
        Ok(())
    }

    /// The boundary point under the smallest angle to each axis, Algorithm 5; of equally
    /// near ones that of the lowest edge.
    pub fn closest(&self, queries: &[ConeQuery]) -> Result<Vec<Option<SilhouettePoint>>, GpuError> {
        let shape = Shape {
            kernel: &CLOSEST,
            numbers: CONE,
            answers: 1,
            values: NEAREST_NUMBERS,
        };
        let mut points = Vec::with_capacity(queries.len());
        self.run(shape, queries, |queries, edges, values| {
            let values = values.as_chunks::<NEAREST_NUMBERS>().0;
            let answers = queries.par_iter().zip(edges).zip(values);
            points.par_extend(answers.map(|((query, &edge), &[t, x, y, z])| {
                let is_found = edge != NONE;
                is_found
                    .then(|| self.point(query, edge, t, Vec3::new(x, y, z)))
                    .flatten()
            }));
        })?;
        points.resize(queries.len(), None);
        Ok(points)
    }

    /// The point of an edge at this position from the apex; `None` if it lies outside the
    /// cone.
    fn point(
        &self,
        query: &ConeQuery,
        edge: u32,
        t: f64,
        position: Vec3,
    ) -> Option<SilhouettePoint> {
        let world = match self.gpu.precision() {
            Precision::Double => position,
            Precision::Single => position * self.frame.scale,
        };
        let distance = world.length();
        let direction = world / distance;
        let angle = sphere::angle_between(query.axis, direction);
        (angle < query.max_angle).then_some(SilhouettePoint {
            edge,
            t,
            direction,
            distance,
            angle,
        })
    }

    /// All boundary edges that meet each cone (METHOD 8). The device has memory for
    /// `capacity` edges of each; what exceeds it is counted, and those cones are
    /// asked again with capacity for all.
    pub fn gather(&self, queries: &[ConeQuery], capacity: usize) -> Result<Gathered, GpuError> {
        // No cone meets more edges than there are.
        let capacity = capacity.min(self.edges);
        let (counts, first) = self.gather_once(queries, capacity)?;
        let has_more = |&query: &usize| counts[query] > capacity;
        let again: Vec<_> = (0..queries.len()).filter(has_more).collect();
        let largest = again.iter().map(|&query| counts[query]).max().unwrap_or(0);
        let cones: Vec<_> = again.iter().map(|&query| queries[query]).collect();
        let (_, second) = self.gather_once(&cones, largest)?;
        let mut gathered = Gathered {
            starts: vec![0],
            edges: Vec::with_capacity(counts.iter().sum()),
            overflowed: again.len(),
        };
        let (mut first, mut second) = (&first[..], &second[..]);
        for count in counts {
            let (taken, later) = first.split_at(count.min(capacity));
            first = later;
            if count > capacity {
                let (all, later) = second.split_at(count);
                second = later;
                gathered.edges.extend(all);
            } else {
                gathered.edges.extend(taken);
            }
            gathered.starts.push(gathered.edges.len());
        }
        Ok(gathered)
    }

    /// How many edges each cone meets, and the first `capacity` of each, one cone after the
    /// other.
    fn gather_once(
        &self,
        queries: &[ConeQuery],
        capacity: usize,
    ) -> Result<(Vec<usize>, Vec<u32>), GpuError> {
        let shape = Shape {
            kernel: &GATHER,
            numbers: CONE,
            answers: capacity + 1,
            values: 0,
        };
        let (mut counts, mut edges) = (Vec::with_capacity(queries.len()), Vec::new());
        self.run(shape, queries, |_, answers, _| {
            for answer in answers.chunks_exact(capacity + 1) {
                let count = answer[0] as usize;
                counts.push(count);
                edges.extend(&answer[1..=count.min(capacity)]);
            }
        })?;
        counts.resize(queries.len(), 0);
        Ok((counts, edges))
    }

    /// Nothing comes back from a tree without edges.
    fn run(
        &self,
        shape: Shape,
        queries: &[ConeQuery],
        finish: impl FnMut(&[ConeQuery], &[u32], &[f64]),
    ) -> Result<(), GpuError> {
        self.gpu.check()?;
        let Some(tree) = &self.tree else {
            return Ok(());
        };
        let precision = self.gpu.precision();
        let prepare = |cone: &ConeQuery, view: &mut [u32], numbers: &mut [f64]| {
            local_cone::write(&self.frame, cone, precision, view, numbers);
        };
        batch::ask(&self.gpu, tree, shape, queries, prepare, finish)
    }
}

/// What kernels read of edges before they test them: an end and the groups, the vector to the
/// other end and the edge's number, and both normals.
fn rough(local: &[f32], tags: &[u32]) -> Vec<u32> {
    let edges = local
        .as_chunks::<EDGE>()
        .0
        .iter()
        .zip(tags.as_chunks::<2>().0);
    let row = |row: usize| {
        edges.clone().flat_map(move |(edge, &[number, groups])| {
            let [x, y, z] = [0, 1, 2].map(|axis| edge[3 * row + axis].to_bits());
            [x, y, z, [groups, number, 0, 0][row]]
        })
    };
    (0..4).flat_map(row).collect()
}
