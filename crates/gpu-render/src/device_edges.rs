//! The edges of a scene that moves, in a device's memory.

use capwalk_gpu::{DeviceArray, Gpu, GpuError};

use crate::edge_records::{Crosses, EdgeRecords};
use crate::layout::change::{EDGES_AT, WALKS};
use crate::render_kernels::PathKernels;
use crate::upload::upload_numbers;

/// For each path there is memory for two others, one on each side of an edge.
pub const COLUMNS: usize = 3;

/// The edges of a scene that moves, on the device.
#[derive(Debug)]
pub struct DeviceEdges {
    /// The numbers of the scene, with those of the edges behind them.
    pub primitives: DeviceArray,
    /// Everything else, which comes to the device with what changes.
    words: Vec<u32>,
    /// Where paths can cross them.
    pub crosses: Crosses,
    /// What follows the paths that go on to both sides.
    pub image: &'static PathKernels,
}

impl DeviceEdges {
    /// Uploads edges, behind the numbers of their scene.
    pub fn new(
        gpu: &Gpu,
        mut primitives: Vec<f64>,
        edges: EdgeRecords,
        image: &'static PathKernels,
    ) -> Result<Self, GpuError> {
        primitives.extend(&edges.numbers);
        Ok(Self {
            primitives: upload_numbers(gpu, &primitives)?,
            words: edges.words,
            crosses: edges.crosses,
            image,
        })
    }

    /// How many words there are.
    pub fn words(&self) -> usize {
        self.words.len()
    }

    /// Appends the words of the edges to those that tell what changes, see `changes.slang`.
    pub fn append(&self, changes: &mut Vec<u32>) {
        changes[EDGES_AT] = changes.len() as u32;
        changes[WALKS] = self.crosses.walks(0).into();
        changes.extend(&self.words);
    }
}
