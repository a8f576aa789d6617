//! A tree in the device's memory.

use crate::driver::Memory;
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::precision::Precision;

/// What a tree is, whichever it is.
pub struct Arrays<'a> {
    /// Words of the nodes.
    pub nodes: &'a [u32],
    pub leaf_starts: &'a [u32],
    /// Primitives in world coordinates.
    pub exact: &'a [f64],
    /// In the frame's.
    pub local: &'a [f32],
    /// What is read of primitives before they are tested: of triangles their numbers, of
    /// edges four rows of four words each, the first rows of all edges, then the second ones,
    /// and so on.
    pub rough: &'a [u32],
    pub primitives: usize,
}

/// The arrays of a tree.
#[derive(Debug)]
pub struct Resident {
    arrays: [Memory; 4],
    primitives: usize,
}

impl Resident {
    /// Uploads a tree; `None` for one without primitives.
    pub fn new(gpu: &Gpu, arrays: &Arrays) -> Result<Option<Self>, GpuError> {
        gpu.check()?;
        if arrays.nodes.is_empty() {
            return Ok(None);
        }
        let primitives: &[u8] = match gpu.precision() {
            Precision::Single => bytemuck::cast_slice(arrays.local),
            Precision::Double => bytemuck::cast_slice(arrays.exact),
        };
        // Kernels read four words at a time.
        let mut rough = arrays.rough.to_vec();
        rough.resize(rough.len().next_multiple_of(4), 0);
        let contents = [
            bytemuck::cast_slice(arrays.nodes),
            bytemuck::cast_slice(arrays.leaf_starts),
            primitives,
            bytemuck::cast_slice(&rough),
        ];
        let limit = gpu.largest_buffer();
        let largest = contents.map(|bytes| bytes.len() as u64).into_iter().max();
        if let Some(bytes) = largest.filter(|&bytes| bytes > limit) {
            return Err(GpuError::TreeTooLarge {
                adapter: gpu.name().to_owned(),
                bytes,
                limit,
            });
        }
        let upload = |bytes: &[u8]| -> Result<Memory, GpuError> {
            let memory = gpu.allocate(bytes.len() as u64)?;
            gpu.upload(&memory, bytes)?;
            Ok(memory)
        };
        let [nodes, leaf_starts, exact, rough] = contents.map(upload);
        Ok(Some(Self {
            arrays: [nodes?, leaf_starts?, exact?, rough?],
            primitives: arrays.primitives,
        }))
    }

    /// Nodes, starts of leaves, primitives, and what is read of them before.
    pub fn arrays(&self) -> [&Memory; 4] {
        self.arrays.each_ref()
    }

    /// How many primitives there are.
    pub fn primitives(&self) -> usize {
        self.primitives
    }
}
