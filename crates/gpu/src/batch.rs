//! Queries in the device's memory, and memory for their answers.

use rayon::prelude::*;

use crate::compiled_kernel::{CompiledKernel, GROUP};
use crate::copies::{Copies, VIEW_WORDS};
use crate::driver::Memory;
use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::launch::Launch;
use crate::layout::mark::CUT_SHORT;
use crate::precision::Precision;
use crate::resident::Resident;

/// No buffer of a part is larger than this, bytes, unless one query needs more: enough for a GPU
/// to be busy, and little enough for the CPU's copies to stay in its caches, or nearly.
const LARGEST: u64 = 1 << 25;

/// What is asked of each query of a kernel: `numbers` for the exact tests, and so many
/// words and numbers come back.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    pub kernel: &'static CompiledKernel,
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
        [
            4 * VIEW_WORDS,
            self.numbers * number,
            4 * self.answers,
            values,
        ]
    }
}

/// Asks the queries, in parts of as many as there is memory for. `prepare` writes a query's
/// words and numbers, `finish` gets the answers and values of one part after the other.
pub fn ask<Q: Sync>(
    gpu: &Gpu,
    tree: &Resident,
    shape: Shape,
    queries: &[Q],
    prepare: impl Fn(&Q, &mut [u32], &mut [f64]) + Sync,
    finish: impl FnMut(&[Q], &[u32], &[f64]),
) -> Result<(), GpuError> {
    let mut copies = gpu.take_copies();
    let asked = ask_with(gpu, tree, shape, queries, prepare, finish, &mut copies);
    gpu.keep_copies(copies);
    asked
}

fn ask_with<Q: Sync>(
    gpu: &Gpu,
    tree: &Resident,
    shape: Shape,
    queries: &[Q],
    prepare: impl Fn(&Q, &mut [u32], &mut [f64]) + Sync,
    mut finish: impl FnMut(&[Q], &[u32], &[f64]),
    copies: &mut Copies,
) -> Result<(), GpuError> {
    let largest = shape.sizes(gpu.precision()).into_iter().max().unwrap_or(1) as u64;
    let most = gpu.largest_buffer().min(LARGEST.max(largest)) / largest;
    if most == 0 {
        return Err(GpuError::OutOfMemory {
            adapter: gpu.name().to_owned(),
            bytes: largest,
        });
    }
    let mut size = queries.len().min(most as usize);
    let mut rest = queries;
    while !rest.is_empty() {
        let part = match Part::new(gpu, shape, size) {
            Err(GpuError::OutOfMemory { .. }) if size > GROUP => {
                size /= 2;
                continue;
            }
            part => part?,
        };
        while !rest.is_empty() {
            let (now, later) = rest.split_at(size.min(rest.len()));
            copies.prepare(shape.numbers, now, &prepare);
            match part.answer(gpu, tree, now.len(), copies) {
                Err(GpuError::OutOfMemory { .. }) if size > GROUP => {
                    size /= 2;
                    break;
                }
                answered => answered?,
            }
            let firsts = copies.answers.iter().step_by(shape.answers);
            match firsts
                .filter(|&&answer| answer as usize == CUT_SHORT)
                .count()
            {
                0 => {}
                threads => return Err(gpu.loops_cut_short(threads as u32)),
            }
            finish(now, &copies.answers, &copies.values);
            rest = later;
        }
    }
    Ok(())
}

/// Room on the device for queries and their answers.
struct Part {
    shape: Shape,
    views: Memory,
    numbers: Memory,
    answers: Memory,
    values: Memory,
}

impl Part {
    fn new(gpu: &Gpu, shape: Shape, size: usize) -> Result<Self, GpuError> {
        let memory = shape
            .sizes(gpu.precision())
            .map(|bytes| gpu.allocate((bytes * size) as u64));
        let [views, numbers, answers, values] = memory;
        Ok(Self {
            shape,
            views: views?,
            numbers: numbers?,
            answers: answers?,
            values: values?,
        })
    }

    /// Uploads the prepared queries, runs the kernel, and fetches answers and values.
    fn answer(
        &self,
        gpu: &Gpu,
        tree: &Resident,
        count: usize,
        copies: &mut Copies,
    ) -> Result<(), GpuError> {
        gpu.upload(&self.views, bytemuck::cast_slice(&copies.views))?;
        match gpu.precision() {
            Precision::Double => {
                gpu.upload(&self.numbers, bytemuck::cast_slice(&copies.numbers))?;
            }
            Precision::Single => {
                let rounded = copies.numbers.par_iter().map(|&number| number as f32);
                rounded.collect_into_vec(&mut copies.single);
                gpu.upload(&self.numbers, bytemuck::cast_slice(&copies.single))?;
            }
        }
        let [nodes, leaf_starts, primitives, rough] = tree.arrays();
        let arrays = [
            nodes,
            leaf_starts,
            primitives,
            rough,
            &self.views,
            &self.numbers,
            &self.answers,
            &self.values,
        ];
        let whole = Launch {
            first: 0,
            end: count as u32,
            capacity: (self.shape.answers - 1) as u32,
            primitives: tree.primitives() as u32,
        };
        gpu.run(self.shape.kernel, arrays, whole)?;
        copies.answers.resize(self.shape.answers * count, 0);
        gpu.download(&self.answers, bytemuck::cast_slice_mut(&mut copies.answers))?;
        let values = self.shape.values * count;
        copies.values.resize(values, 0.0);
        match gpu.precision() {
            _ if values == 0 => {}
            Precision::Double => {
                gpu.download(&self.values, bytemuck::cast_slice_mut(&mut copies.values))?;
            }
            Precision::Single => {
                copies.single.resize(values, 0.0);
                gpu.download(&self.values, bytemuck::cast_slice_mut(&mut copies.single))?;
                let exact = copies.single.par_iter().map(|&value| f64::from(value));
                exact.collect_into_vec(&mut copies.values);
            }
        }
        Ok(())
    }
}
