//! Edges sampled in cones, in batches.

use std::sync::Arc;

use capwalk_geometry::buffers::{EDGE, NONE};
use capwalk_geometry::sampler_buffers::{
    CLEAR, DrawnEdge, EdgeCone, FACTORS, NODE, SamplerBuffers,
};
use capwalk_geometry::{ConeQuery, EdgeSelection, LocalFrame};

use crate::batch::{self, Shape};
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::kernels::SAMPLE_EDGES;
use crate::layout::cone::{CONE, CONE_LIMIT, CONE_SIZE};
use crate::layout::sampled::*;
use crate::local_cone::{self, SINGLE_ERROR};
use crate::precision::Precision;
use crate::resident::{Arrays, Resident};

/// In single precision, what rounding adds up to less than, per unit of the size of coordinates.
const SINGLE_CLEAR: f64 = 4.0 * SINGLE_ERROR;

/// 2⁶⁴.
const ALL_BITS: f64 = 18_446_744_073_709_551_616.0;

/// A tree for sampling edges on the device. It does not follow moved vertices: what it knows of
/// visibility is of where they were, so it is built anew.
#[derive(Debug)]
pub struct DeviceEdgeSampler {
    gpu: Arc<Gpu>,
    frame: LocalFrame,
    all_edges: bool,
    tree: Option<Resident>,
}

impl DeviceEdgeSampler {
    /// Uploads the tree.
    ///
    /// # Panics
    ///
    /// If its arrays are not [whole](SamplerBuffers::is_whole).
    pub fn new(gpu: &Arc<Gpu>, buffers: &SamplerBuffers) -> Result<Self, GpuError> {
        assert!(buffers.is_whole(), "arrays of a tree are whole");
        // Bounds first, and then edges with their factors.
        let (mut exact, mut local) = (Vec::new(), Vec::new());
        match gpu.precision() {
            Precision::Double => {
                exact.extend(&buffers.bounds);
                add_edges(&mut exact, &buffers.ends_and_normals, &buffers.factors);
            }
            Precision::Single => {
                let factors: Vec<f32> = buffers.factors.iter().map(|&v| v as f32).collect();
                local = buffers.local_bounds();
                add_edges(&mut local, &buffers.local_edges(), &factors);
            }
        }
        let tree = Resident::new(
            gpu,
            &Arrays {
                nodes: &buffers.nodes,
                leaf_starts: &buffers.edges,
                exact: &exact,
                local: &local,
                rough: &[0; 4],
                primitives: buffers.nodes.len() / NODE,
            },
        )?;
        Ok(Self {
            gpu: gpu.clone(),
            frame: buffers.frame,
            all_edges: buffers.all_edges,
            tree,
        })
    }

    /// An edge for each cone, chosen by the cone's random numbers among those that count and meet
    /// it (METHOD 8), and its probability; `None` where the numbers lead to none, which has a
    /// probability as well. The mean over random numbers of `f(edge) / probability` is the sum of
    /// `f` over all edges that count and meet the cone, those without length left out.
    ///
    /// In double precision, edges and probabilities are those of the CPU for the same
    /// numbers, up to rounding, which also decides whether an edge counts that ends on the border
    /// of the cone. In single precision numbers are hashed, so they lead to other edges, and even
    /// spacing of them does not help; a half of a node that is chosen less than once in 2³² times
    /// never is.
    pub fn sample(&self, cones: &[EdgeCone]) -> Result<Vec<Option<DrawnEdge>>, GpuError> {
        self.gpu.check()?;
        let Some(tree) = &self.tree else {
            return Ok(vec![None; cones.len()]);
        };
        let shape = Shape {
            kernel: &SAMPLE_EDGES,
            numbers: SAMPLED,
            answers: 1,
            values: 1,
        };
        let mut sampled = Vec::with_capacity(cones.len());
        let prepare = |cone: &EdgeCone, view: &mut [u32], numbers: &mut [f64]| {
            self.write(cone, view, numbers);
        };
        let finish = |_: &[EdgeCone], edges: &[u32], probabilities: &[f64]| {
            let answers = edges.iter().zip(probabilities);
            sampled.extend(answers.map(|(&edge, &probability)| {
                let is_found = edge != NONE;
                is_found.then_some(DrawnEdge { edge, probability })
            }));
        };
        batch::ask(&self.gpu, tree, shape, cones, prepare, finish)?;
        Ok(sampled)
    }

    /// Writes what the kernel reads of a cone.
    fn write(&self, cone: &EdgeCone, view: &mut [u32], numbers: &mut [f64]) {
        let precision = self.gpu.precision();
        let query = ConeQuery {
            apex: cone.apex,
            axis: cone.axis,
            max_angle: cone.max_angle,
            edges: EdgeSelection::All,
            groups: u8::MAX,
            in_front_of: None,
        };
        local_cone::write(&self.frame, &query, precision, view, &mut numbers[..CONE]);
        // No test of angles follows.
        numbers[CONE_LIMIT] = local_cone::pseudo_limit(cone.max_angle);
        view[0] = u32::from(self.all_edges);
        for (words, number) in view[8..].chunks_exact_mut(2).zip(cone.numbers) {
            let bits = (number * ALL_BITS) as u64;
            words.copy_from_slice(&[(bits >> 32) as u32, bits as u32]);
        }
        // The size of the apex, and of what is in the tree.
        let (clear, size) = match precision {
            Precision::Double => (CLEAR, numbers[CONE_SIZE]),
            Precision::Single => (SINGLE_CLEAR, numbers[CONE_SIZE] + 3.0),
        };
        numbers[SAMPLED_ANGLE..SAMPLED_CLEAR].copy_from_slice(&cone.sin_cos());
        numbers[SAMPLED_CLEAR] = clear;
        numbers[SAMPLED_SIZE] = size;
        numbers[SAMPLED_RANDOM..].copy_from_slice(&cone.numbers);
    }
}

/// Adds edges, each with its factors.
fn add_edges<T: Copy>(to: &mut Vec<T>, edges: &[T], factors: &[T]) {
    let factors = factors.as_chunks::<FACTORS>().0;
    for (edge, factors) in edges.as_chunks::<EDGE>().0.iter().zip(factors) {
        to.extend(edge);
        to.extend(factors);
    }
}
