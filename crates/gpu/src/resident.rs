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
    /// Their sizes, bytes.
    sizes: [u64; 4],
    primitives: usize,
}

/// Uploads an array, which one buffer must hold.
pub fn uploaded(gpu: &Gpu, bytes: &[u8]) -> Result<Memory, GpuError> {
    let memory = reserved(gpu, bytes.len() as u64)?;
    gpu.upload(&memory, bytes)?;
    Ok(memory)
}

/// Memory for an array, which one buffer must hold.
pub fn reserved(gpu: &Gpu, bytes: u64) -> Result<Memory, GpuError> {
    let limit = gpu.largest_buffer();
    if bytes > limit {
        return Err(GpuError::TreeTooLarge {
            adapter: gpu.name().to_owned(),
            bytes,
            limit,
        });
    }
    // A buffer of no bytes cannot be bound.
    gpu.allocate(bytes.max(16))
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
        let sizes = contents.map(|bytes| bytes.len() as u64);
        let [nodes, leaf_starts, exact, rough] = contents.map(|bytes| uploaded(gpu, bytes));
        Ok(Some(Self {
            arrays: [nodes?, leaf_starts?, exact?, rough?],
            sizes,
            primitives: arrays.primitives,
        }))
    }

    /// Nodes, starts of leaves, primitives, and what is read of them before.
    pub fn arrays(&self) -> [&Memory; 4] {
        self.arrays.each_ref()
    }

    /// Room for nodes, primitives, and what is read of them before: a second copy of each.
    pub fn spare(&self, gpu: &Gpu) -> Result<[Memory; 3], GpuError> {
        let [nodes, _, primitives, rough] = self.sizes;
        let [nodes, primitives, rough] =
            [nodes, primitives, rough].map(|bytes| reserved(gpu, bytes));
        Ok([nodes?, primitives?, rough?])
    }

    /// Exchanges nodes, primitives, and what is read of them before unless that stays.
    pub fn exchange(&mut self, [nodes, primitives, rough]: &mut [Memory; 3], rough_stays: bool) {
        std::mem::swap(&mut self.arrays[0], nodes);
        std::mem::swap(&mut self.arrays[2], primitives);
        if !rough_stays {
            std::mem::swap(&mut self.arrays[3], rough);
        }
    }

    /// How many primitives there are.
    pub fn primitives(&self) -> usize {
        self.primitives
    }
}
