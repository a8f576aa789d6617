//! Batches cut into launches that fit the device's memory and take a bounded time.

use std::sync::mpsc;
use std::time::Instant;

use rayon::prelude::*;

use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernels::{GROUP, Kernel};
use crate::precision::Precision;
use crate::resident::Resident;

/// Words of a query for the bounds.
pub const VIEW: usize = 12;

/// Queries of the first launch, when it is not known yet how long they take.
const FIRST: usize = 1 << 12;

/// A launch has no more, so that groups can be counted in one dimension.
const MOST: usize = 1 << 21;

/// No buffer of a launch is larger than this, bytes: more would not make it faster.
const LARGEST: u64 = 1 << 28;

/// What is asked of each query of a kernel: `numbers` for the exact tests, and so many
/// words and numbers come back.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    pub kernel: Kernel,
    pub numbers: usize,
    pub answers: usize,
    pub values: usize,
}

impl Shape {
    /// Bytes per query: of views, queries, answers and values.
    fn sizes(&self, precision: Precision) -> [usize; 4] {
        let number = match precision {
            Precision::Single => 4,
            Precision::Double => 8,
        };
        // A buffer of no bytes cannot be bound.
        let values = self.values.max(1) * number;
        [4 * VIEW, self.numbers * number, 4 * self.answers, values]
    }
}

/// Runs the queries in launches. `prepare` writes a query's words and numbers, `finish`
/// gets the answers and values of one launch after the other.
pub fn run<Q: Sync>(
    gpu: &Gpu,
    tree: &Resident,
    shape: Shape,
    queries: &[Q],
    prepare: impl Fn(&Q, &mut [u32], &mut [f64]) + Sync,
    mut finish: impl FnMut(&[Q], &[u32], &[f64]),
) -> Result<(), GpuError> {
    let sizes = shape.sizes(gpu.precision());
    let largest = sizes.into_iter().max().unwrap_or(1) as u64;
    let fitting =
        usize::try_from(gpu.largest_buffer().min(LARGEST.max(largest)) / largest).unwrap_or(MOST);
    if fitting == 0 {
        return Err(GpuError::OutOfMemory {
            adapter: gpu.name().to_owned(),
            bytes: largest,
        });
    }
    let mut most = fitting.min(MOST);
    let mut size = FIRST.min(most);
    let mut rest = queries;
    let mut buffers: Option<Buffers> = None;
    while !rest.is_empty() {
        let (now, later) = rest.split_at(size.min(rest.len()));
        let started = Instant::now();
        let outcome = room_for(gpu, tree, sizes, now.len(), &mut buffers)
            .and_then(|buffers| launch(gpu, shape, buffers, now, &prepare));
        let (answers, values) = match outcome {
            Ok(results) => results,
            Err(GpuError::OutOfMemory { .. }) if now.len() > GROUP => {
                buffers = None;
                most = now.len() / 2;
                size = most;
                continue;
            }
            Err(error) => return Err(error),
        };
        let took = started.elapsed();
        finish(now, &answers, &values);
        rest = later;
        if took > gpu.options.launch {
            size = (size / 2).max(GROUP.min(most));
        } else if 3 * took < gpu.options.launch {
            size = (2 * size).min(most);
        }
    }
    Ok(())
}

/// The buffers, if they have room for so many queries, or else new ones.
fn room_for<'a>(
    gpu: &Gpu,
    tree: &Resident,
    sizes: [usize; 4],
    room: usize,
    buffers: &'a mut Option<Buffers>,
) -> Result<&'a Buffers, GpuError> {
    let kept = buffers.take().filter(|buffers| buffers.room >= room);
    let kept = match kept {
        Some(buffers) => buffers,
        None => Buffers::new(gpu, tree, sizes, room)?,
    };
    Ok(buffers.insert(kept))
}

/// What one launch reads and writes.
struct Buffers {
    /// How many queries have room.
    room: usize,
    views: wgpu::Buffer,
    queries: wgpu::Buffer,
    answers: wgpu::Buffer,
    values: wgpu::Buffer,
    batch: wgpu::Buffer,
    /// For answers and values on their way back.
    back: [wgpu::Buffer; 2],
    group: wgpu::BindGroup,
}

impl Buffers {
    fn new(gpu: &Gpu, tree: &Resident, sizes: [usize; 4], room: usize) -> Result<Self, GpuError> {
        use wgpu::BufferUsages as Use;
        let bytes = sizes.map(|size| (size * room) as u64);
        let total = bytes.iter().sum::<u64>() + bytes[2] + bytes[3];
        gpu.guarded("buffers of a batch", total, || {
            let buffer = |size: u64, usage| {
                gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("batch"),
                    size,
                    usage,
                    mapped_at_creation: false,
                })
            };
            let [views, queries] =
                [bytes[0], bytes[1]].map(|size| buffer(size, Use::STORAGE | Use::COPY_DST));
            let [answers, values] =
                [bytes[2], bytes[3]].map(|size| buffer(size, Use::STORAGE | Use::COPY_SRC));
            let back = [bytes[2], bytes[3]].map(|size| buffer(size, Use::MAP_READ | Use::COPY_DST));
            let batch = buffer(16, Use::UNIFORM | Use::COPY_DST);
            let own = [&views, &queries, &answers, &values, &batch];
            let entries: Vec<_> = tree
                .buffers()
                .iter()
                .chain(own)
                .enumerate()
                .map(|(binding, buffer)| wgpu::BindGroupEntry {
                    binding: binding as u32,
                    resource: buffer.as_entire_binding(),
                })
                .collect();
            let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("batch"),
                layout: &gpu.layout,
                entries: &entries,
            });
            Self {
                room,
                views,
                queries,
                answers,
                values,
                batch,
                back,
                group,
            }
        })
    }
}

/// Answers some queries at once.
fn launch<Q: Sync>(
    gpu: &Gpu,
    shape: Shape,
    buffers: &Buffers,
    queries: &[Q],
    prepare: &(impl Fn(&Q, &mut [u32], &mut [f64]) + Sync),
) -> Result<(Vec<u32>, Vec<f64>), GpuError> {
    let mut views = vec![0_u32; VIEW * queries.len()];
    let mut numbers = vec![0.0; shape.numbers * queries.len()];
    (
        queries,
        views.par_chunks_exact_mut(VIEW),
        numbers.par_chunks_exact_mut(shape.numbers),
    )
        .into_par_iter()
        .with_min_len(256)
        .for_each(|(query, views, numbers)| prepare(query, views, numbers));
    let single: Vec<f32>;
    let numbers: &[u8] = match gpu.precision() {
        Precision::Double => bytemuck::cast_slice(&numbers),
        Precision::Single => {
            single = numbers.iter().map(|&number| number as f32).collect();
            bytemuck::cast_slice(&single)
        }
    };
    let pipeline = gpu.pipeline(shape.kernel)?;
    let used = shape
        .sizes(gpu.precision())
        .map(|size| (size * queries.len()) as u64);
    let (sender, receiver) = mpsc::channel();
    gpu.guarded("a launch", used.iter().sum(), || {
        let capacity = (shape.answers - 1) as u32;
        let batch = [queries.len() as u32, capacity, 0, 0];
        gpu.queue
            .write_buffer(&buffers.views, 0, bytemuck::cast_slice(&views));
        gpu.queue.write_buffer(&buffers.queries, 0, numbers);
        gpu.queue
            .write_buffer(&buffers.batch, 0, bytemuck::cast_slice(&batch));
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &buffers.group, &[]);
            pass.dispatch_workgroups(queries.len().div_ceil(GROUP) as u32, 1, 1);
        }
        let results = [(&buffers.answers, used[2]), (&buffers.values, used[3])];
        for ((from, bytes), back) in results.into_iter().zip(&buffers.back) {
            encoder.copy_buffer_to_buffer(from, 0, back, 0, bytes);
        }
        gpu.queue.submit([encoder.finish()]);
        for (back, bytes) in buffers.back.iter().zip(&used[2..]) {
            let sender = sender.clone();
            back.map_async(wgpu::MapMode::Read, ..*bytes, move |mapped| {
                // Nobody listens any more if the launch failed meanwhile.
                let _ = sender.send(mapped.map_err(|error| error.to_string()));
            });
        }
    })?;
    wait(gpu, queries.len())?;
    for _ in &buffers.back {
        let mapped = receiver
            .recv()
            .unwrap_or_else(|error| Err(error.to_string()));
        mapped.map_err(|reason| refused(gpu, reason))?;
    }
    let read = |back: &wgpu::Buffer, bytes: u64| -> Result<Vec<u8>, GpuError> {
        let range = back
            .get_mapped_range(..bytes)
            .map_err(|error| refused(gpu, error.to_string()))?;
        let read = range.to_vec();
        drop(range);
        back.unmap();
        Ok(read)
    };
    let answers = bytemuck::pod_collect_to_vec(&read(&buffers.back[0], used[2])?);
    let values = read(&buffers.back[1], used[3])?;
    let values = match gpu.precision() {
        Precision::Double => bytemuck::pod_collect_to_vec(&values),
        Precision::Single => {
            let values: Vec<f32> = bytemuck::pod_collect_to_vec(&values);
            values.into_iter().map(f64::from).collect()
        }
    };
    Ok((answers, values))
}

/// Waits until all work is done.
fn wait(gpu: &Gpu, queries: usize) -> Result<(), GpuError> {
    let waited = gpu.device.poll(wgpu::PollType::Wait {
        submission_index: None,
        timeout: Some(gpu.options.timeout),
    });
    gpu.check()?;
    match waited {
        Ok(_) => Ok(()),
        Err(wgpu::PollError::Timeout) => Err(GpuError::Timeout {
            adapter: gpu.name().to_owned(),
            queries,
            allowed: gpu.options.timeout,
        }),
        Err(error) => Err(refused(gpu, error.to_string())),
    }
}

fn refused(gpu: &Gpu, reason: String) -> GpuError {
    match gpu.check() {
        Err(lost) => lost,
        Ok(()) => GpuError::Refused {
            adapter: gpu.name().to_owned(),
            what: "to give answers".to_owned(),
            reason,
        },
    }
}
