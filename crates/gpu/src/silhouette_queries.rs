//! Closest silhouettes, and all in a cone, in batches.

use std::sync::Arc;

use capwalk_geometry::buffers::{EDGE, NONE};
use capwalk_geometry::{ConeQuery, LocalFrame, SilhouettePoint, SilhouetteTree};
use capwalk_math::{Vec3, sphere};
use rayon::prelude::*;

use crate::batch::{self, Shape};
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::kernels::Kernel;
use crate::local_cone::{self, CONE};
use crate::precision::Precision;
use crate::resident::{Arrays, Resident};

/// A [`SilhouetteTree`] on the device.
#[derive(Debug)]
pub struct DeviceSilhouetteTree {
    gpu: Arc<Gpu>,
    frame: LocalFrame,
    tree: Option<Resident>,
    edges: usize,
}

/// Which edges meet each cone of a batch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gathered {
    starts: Vec<usize>,
    edges: Vec<u32>,
    overflowed: usize,
}

impl Gathered {
    /// The edges that meet the cone with this number, in an order that depends on the
    /// tree alone.
    pub fn of(&self, query: usize) -> &[u32] {
        &self.edges[self.starts[query]..self.starts[query + 1]]
    }

    /// How many cones met more edges than there was room for, and were asked a second
    /// time with room for all: many of them make a larger capacity worth while.
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
        })
    }

    /// Follows a tree that was refitted: its arrays are uploaded anew.
    pub fn refit(&mut self, tree: &SilhouetteTree) -> Result<(), GpuError> {
        *self = Self::new(&self.gpu, tree)?;
        Ok(())
    }

    /// The boundary point under the smallest angle to each axis, Algorithm 5; of equally
    /// near ones that of the lowest edge.
    pub fn closest(&self, queries: &[ConeQuery]) -> Result<Vec<Option<SilhouettePoint>>, GpuError> {
        let shape = Shape {
            kernel: Kernel::Closest,
            numbers: CONE,
            answers: 1,
            values: 4,
        };
        let mut points = Vec::with_capacity(queries.len());
        self.run(shape, queries, |queries, edges, values| {
            let values = values.as_chunks::<4>().0;
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

    /// All boundary edges that meet each cone (METHOD 8). The device has room for
    /// `capacity` edges of each; what finds no more room is counted, and those cones are
    /// asked again with room for all.
    pub fn gather(&self, queries: &[ConeQuery], capacity: usize) -> Result<Gathered, GpuError> {
        let mut found: Vec<Vec<u32>> = vec![Vec::new(); queries.len()];
        let mut again: Vec<(usize, ConeQuery)> = Vec::new();
        let mut largest = 0;
        let numbered: Vec<(usize, ConeQuery)> = queries.iter().copied().enumerate().collect();
        self.gather_once(&numbered, capacity, |number, count, edges| {
            if count > edges.len() {
                again.push((number, queries[number]));
                largest = largest.max(count);
            } else {
                found[number] = edges.to_vec();
            }
        })?;
        self.gather_once(&again, largest, |number, _, edges| {
            found[number] = edges.to_vec()
        })?;
        let mut gathered = Gathered {
            starts: vec![0],
            edges: Vec::new(),
            overflowed: again.len(),
        };
        for edges in found {
            gathered.edges.extend(edges);
            gathered.starts.push(gathered.edges.len());
        }
        Ok(gathered)
    }

    /// Calls `visit` with each query's number, how many edges it has, and as many of them
    /// as there was room for.
    fn gather_once(
        &self,
        queries: &[(usize, ConeQuery)],
        capacity: usize,
        mut visit: impl FnMut(usize, usize, &[u32]),
    ) -> Result<(), GpuError> {
        // No cone meets more edges than there are.
        let capacity = capacity.min(self.edges);
        let shape = Shape {
            kernel: Kernel::Gather,
            numbers: CONE,
            answers: capacity + 1,
            values: 0,
        };
        self.run_numbered(shape, queries, |queries, answers, _| {
            for (&(number, _), answer) in queries.iter().zip(answers.chunks_exact(capacity + 1)) {
                let (count, edges) = (answer[0] as usize, &answer[1..]);
                visit(number, count, &edges[..count.min(capacity)]);
            }
        })
    }

    fn run(
        &self,
        shape: Shape,
        queries: &[ConeQuery],
        finish: impl FnMut(&[ConeQuery], &[u32], &[f64]),
    ) -> Result<(), GpuError> {
        self.launch(shape, queries, |query| query, finish)
    }

    fn run_numbered(
        &self,
        shape: Shape,
        queries: &[(usize, ConeQuery)],
        finish: impl FnMut(&[(usize, ConeQuery)], &[u32], &[f64]),
    ) -> Result<(), GpuError> {
        self.launch(shape, queries, |(_, query)| query, finish)
    }

    /// Nothing comes back from a tree without edges.
    fn launch<Q: Sync>(
        &self,
        shape: Shape,
        queries: &[Q],
        cone: impl Fn(&Q) -> &ConeQuery + Sync,
        finish: impl FnMut(&[Q], &[u32], &[f64]),
    ) -> Result<(), GpuError> {
        self.gpu.check()?;
        let Some(tree) = &self.tree else {
            return Ok(());
        };
        let precision = self.gpu.precision();
        let prepare = |query: &Q, view: &mut [u32], numbers: &mut [f64]| {
            local_cone::write(&self.frame, cone(query), precision, view, numbers);
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
