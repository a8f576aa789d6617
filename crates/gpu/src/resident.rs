//! A tree in the device's memory.

use crate::device::Gpu;
use crate::error::GpuError;
use crate::precision::Precision;

/// What a tree is, whichever it is.
pub struct Arrays<'a> {
    /// Words of the nodes.
    pub nodes: &'a [u32],
    pub leaf_starts: &'a [u32],
    /// Numbers and groups of the primitives.
    pub tags: &'a [u32],
    /// In world coordinates.
    pub exact: &'a [f64],
    /// In the frame's.
    pub local: &'a [f32],
}

/// The buffers of a tree; `None` for one without primitives.
#[derive(Debug)]
pub struct Resident {
    buffers: [wgpu::Buffer; 4],
}

impl Resident {
    /// Uploads a tree.
    pub fn new(gpu: &Gpu, arrays: &Arrays) -> Result<Option<Self>, GpuError> {
        gpu.check()?;
        if arrays.nodes.is_empty() {
            return Ok(None);
        }
        let primitives = match gpu.precision() {
            Precision::Single => bytemuck::cast_slice(arrays.local),
            Precision::Double => bytemuck::cast_slice(arrays.exact),
        };
        let contents: [&[u8]; 4] = [
            bytemuck::cast_slice(arrays.nodes),
            bytemuck::cast_slice(arrays.leaf_starts),
            primitives,
            bytemuck::cast_slice(arrays.tags),
        ];
        let limit = gpu.largest_buffer();
        let largest = contents
            .iter()
            .map(|bytes| bytes.len() as u64)
            .max()
            .unwrap_or(0);
        if largest > limit {
            return Err(GpuError::TreeTooLarge {
                adapter: gpu.name().to_owned(),
                bytes: largest,
                limit,
            });
        }
        let total = contents.iter().map(|bytes| bytes.len() as u64).sum();
        let buffers = gpu.guarded("a tree", total, || {
            contents.map(|bytes| {
                let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("tree"),
                    size: bytes.len() as u64,
                    usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                });
                gpu.queue.write_buffer(&buffer, 0, bytes);
                buffer
            })
        })?;
        Ok(Some(Self { buffers }))
    }

    /// Nodes, starts of leaves, primitives, and their numbers.
    pub fn buffers(&self) -> &[wgpu::Buffer; 4] {
        &self.buffers
    }
}
