//! Queries in the device's memory, and room for their answers.

use rayon::prelude::*;

use crate::driver::{Launch, Memory};
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::kernels::{GROUP, Kernel};
use crate::precision::Precision;
use crate::resident::Resident;

/// Words of a query for the bounds.
pub const VIEW: usize = 12;

/// No buffer of a batch is larger than this, bytes: more would not make it faster.
const LARGEST: u64 = 1 << 28;

/// Queries that are prepared by one thread.
const CHUNK: usize = 256;

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
    /// Bytes per query: of views, numbers, answers and values.
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

/// Asks the queries, as many at once as there is memory for. `prepare` writes a query's
/// words and numbers, `finish` gets the answers and values of one batch after the other.
pub fn ask<Q: Sync>(
    gpu: &Gpu,
    tree: &Resident,
    shape: Shape,
    queries: &[Q],
    prepare: impl Fn(&Q, &mut [u32], &mut [f64]) + Sync,
    mut finish: impl FnMut(&[Q], &[u32], &[f64]),
) -> Result<(), GpuError> {
    let largest = shape.sizes(gpu.precision()).into_iter().max().unwrap_or(1) as u64;
    let mut most = gpu.largest_buffer().min(LARGEST.max(largest)) / largest;
    if most == 0 {
        return Err(GpuError::OutOfMemory {
            adapter: gpu.name().to_owned(),
            bytes: largest,
        });
    }
    let mut rest = queries;
    while !rest.is_empty() {
        let (now, later) = rest.split_at(rest.len().min(most as usize));
        let answered = Batch::new(gpu, shape, now, &prepare).and_then(|batch| {
            batch.ask(gpu, tree)?;
            batch.read(gpu)
        });
        match answered {
            Ok((answers, values)) => finish(now, &answers, &values),
            Err(GpuError::OutOfMemory { .. }) if now.len() > GROUP => {
                most = now.len() as u64 / 2;
                continue;
            }
            Err(error) => return Err(error),
        }
        rest = later;
    }
    Ok(())
}

/// Queries prepared for one tree.
struct Batch {
    shape: Shape,
    count: usize,
    views: Memory,
    numbers: Memory,
    answers: Memory,
    values: Memory,
}

impl Batch {
    /// Prepares the queries, on all threads, and uploads them.
    fn new<Q: Sync>(
        gpu: &Gpu,
        shape: Shape,
        queries: &[Q],
        prepare: &(impl Fn(&Q, &mut [u32], &mut [f64]) + Sync),
    ) -> Result<Self, GpuError> {
        let bytes = shape
            .sizes(gpu.precision())
            .map(|size| (size * queries.len()) as u64);
        let [views, numbers, answers, values] = bytes.map(|bytes| gpu.allocate(bytes));
        let batch = Self {
            shape,
            count: queries.len(),
            views: views?,
            numbers: numbers?,
            answers: answers?,
            values: values?,
        };
        let mut views = vec![0_u32; VIEW * queries.len()];
        let mut numbers = vec![0.0; shape.numbers * queries.len()];
        (
            queries,
            views.par_chunks_exact_mut(VIEW),
            numbers.par_chunks_exact_mut(shape.numbers),
        )
            .into_par_iter()
            .with_min_len(CHUNK)
            .for_each(|(query, views, numbers)| prepare(query, views, numbers));
        gpu.upload(&batch.views, bytemuck::cast_slice(&views))?;
        match gpu.precision() {
            Precision::Double => gpu.upload(&batch.numbers, bytemuck::cast_slice(&numbers))?,
            Precision::Single => {
                let single: Vec<f32> = numbers.par_iter().map(|&number| number as f32).collect();
                gpu.upload(&batch.numbers, bytemuck::cast_slice(&single))?;
            }
        }
        Ok(batch)
    }

    /// Runs the kernel for all of them.
    fn ask(&self, gpu: &Gpu, tree: &Resident) -> Result<(), GpuError> {
        let [nodes, leaf_starts, primitives, rough] = tree.arrays();
        let own = [&self.views, &self.numbers, &self.answers, &self.values];
        let [views, numbers, answers, values] = own;
        let arrays = [
            nodes,
            leaf_starts,
            primitives,
            rough,
            views,
            numbers,
            answers,
            values,
        ];
        let capacity = self.shape.answers - 1;
        let whole = Launch {
            first: 0,
            end: self.count as u32,
            capacity: capacity as u32,
            primitives: tree.primitives() as u32,
        };
        gpu.run(self.shape.kernel, arrays, whole)
    }

    /// Answers and values of all of them.
    fn read(&self, gpu: &Gpu) -> Result<(Vec<u32>, Vec<f64>), GpuError> {
        let [_, _, answers, values] = self
            .shape
            .sizes(gpu.precision())
            .map(|size| (size * self.count) as u64);
        let answers = bytemuck::pod_collect_to_vec(&gpu.download(&self.answers, answers)?);
        if self.shape.values == 0 {
            return Ok((answers, Vec::new()));
        }
        let values = gpu.download(&self.values, values)?;
        let values = match gpu.precision() {
            Precision::Double => bytemuck::pod_collect_to_vec(&values),
            Precision::Single => {
                let values: Vec<f32> = bytemuck::pod_collect_to_vec(&values);
                values.into_iter().map(f64::from).collect()
            }
        };
        Ok((answers, values))
    }
}
