//! Room on the device for a part of the samples, and the stages that they go through.

use capwalk_gpu::{CompiledKernel, DeviceArray, Gpu, GpuError};
use capwalk_render::Watch;

use crate::device_edges::{COLUMNS, DeviceEdges};
use crate::layout::fault::{SUMS, THREADS_CUT_SHORT};
use crate::layout::sample::SAMPLE_WORDS;
use crate::render_kernels::{GO_BACK, PathKernels, WALK, WALK_BACK};

/// Room for so many paths in a scene.
#[derive(Debug)]
pub struct Paths<'a> {
    pub(crate) gpu: &'a Gpu,
    /// The five arrays of the scene.
    scene: [&'a DeviceArray; 5],
    kernels: &'static PathKernels,
    capacity: usize,
    /// The edges that paths cross, if the scene moves.
    edges: Option<&'a DeviceEdges>,
    /// How many vertices of each path can be kept.
    levels: usize,
    /// What paths begin with, and then the list of those that go on; behind it what changes.
    pub(crate) input: DeviceArray,
    /// What is known of each.
    pub(crate) state: DeviceArray,
    /// Counts of faults, and behind them sums over all paths, or the weights of the camera's rays in
    /// their pixels.
    pub(crate) results: DeviceArray,
}

/// How far paths were followed.
#[derive(Debug)]
pub enum Followed {
    /// To their ends. Of each vertex the paths that get to it, in order.
    ToTheEnd(Vec<Vec<u32>>),
    /// Until the watch stopped it.
    Stopped,
    /// Until no further vertex could be kept.
    NoLevel,
}

impl<'a> Paths<'a> {
    /// Room for so many paths, of each of which so many vertices can be kept if the kernels keep any,
    /// with these words that tell what changes, and with so many words of faults and sums if they do.
    pub fn new(
        gpu: &'a Gpu,
        scene: [&'a DeviceArray; 5],
        kernels: &'static PathKernels,
        [capacity, levels]: [usize; 2],
        changes: &[u32],
        sums: usize,
        edges: Option<&'a DeviceEdges>,
    ) -> Result<Self, GpuError> {
        // What tells the samples that paths begin with takes the place of the list.
        let capacity = capacity.max(SAMPLE_WORDS);
        // Behind the counts of faults are sums, or the weights of samples.
        let results = match kernels.keeps() {
            true => sums.max(SUMS),
            false => SUMS + capacity,
        };
        let columns = columns(capacity, edges);
        let array = |words: usize| gpu.array(4 * words as u64);
        let mut words = vec![0; kernels.input * columns];
        words.extend(changes);
        let input = array(words.len())?;
        gpu.write(&input, bytemuck::cast_slice(&words))?;
        let paths = Self {
            gpu,
            scene,
            kernels,
            capacity,
            edges,
            levels,
            input,
            state: array(kernels.words(levels) * columns)?,
            results: array(results)?,
        };
        paths.clear_sums(results)?;
        Ok(paths)
    }

    /// How many fit.
    pub fn capacity(&self) -> usize {
        self.capacity
    }

    /// Follows so many paths, given what they begin with.
    pub fn follow(
        &self,
        count: usize,
        beginning: &[u32],
        watch: &dyn Watch,
    ) -> Result<Followed, GpuError> {
        self.gpu
            .write(&self.input, bytemuck::cast_slice(beginning))?;
        self.launch(&self.kernels.begin, count, 0)?;
        let mut lists = Vec::new();
        let mut list = self.listed(count)?;
        loop {
            if list.is_empty() {
                self.counts()?;
                return Ok(Followed::ToTheEnd(lists));
            }
            if watch.should_stop() {
                return Ok(Followed::Stopped);
            }
            if self.kernels.keeps() && lists.len() == self.levels {
                return Ok(Followed::NoLevel);
            }
            // Boundary terms are taken at the vertices where paths are, or of those that are kept.
            let cross = |keeps| match self.edges.filter(|_| keeps == self.keeps_vertices()) {
                Some(edges) => self.cross_edges(edges, &list, lists.len(), watch),
                None => Ok(true),
            };
            if !cross(false)? {
                return Ok(Followed::Stopped);
            }
            self.write_list(&list)?;
            if !self.keeps_vertices() {
                self.walk(&WALK, list.len(), lists.len())?;
            }
            self.launch(&self.kernels.go_on, list.len(), lists.len())?;
            let next = self.listed(list.len())?;
            if !cross(true)? {
                return Ok(Followed::Stopped);
            }
            lists.push(list);
            list = next;
        }
    }

    /// The first numbers of each path: its light and what comes with it.
    pub fn numbers<const N: usize>(&self, count: usize) -> Result<Vec<[f32; N]>, GpuError> {
        // Behind the list.
        self.numbers_from(1, count)
    }

    /// The numbers of each path from one of its words on.
    pub fn numbers_from<const N: usize>(
        &self,
        first: usize,
        count: usize,
    ) -> Result<Vec<[f32; N]>, GpuError> {
        // One array for each word, as long as paths fit.
        let columns = self.columns();
        let mut arrays = vec![0_f32; (first + N - 1) * columns + count];
        self.gpu
            .read(&self.state, bytemuck::cast_slice_mut(&mut arrays))?;
        let of_path =
            |path: usize| std::array::from_fn(|word| arrays[(first + word) * columns + path]);
        Ok((0..count).map(of_path).collect())
    }

    /// Takes the light that arrives behind vertices back to the camera, given the paths that got to
    /// each; false if the watch stopped it.
    pub fn go_back(&self, lists: &[Vec<u32>], watch: &dyn Watch) -> Result<bool, GpuError> {
        assert!(lists.len() <= self.levels, "all vertices were kept");
        for (depth, list) in lists.iter().enumerate().rev() {
            if watch.should_stop() {
                return Ok(false);
            }
            self.write_list(list)?;
            self.launch(&GO_BACK, list.len(), depth)?;
            self.walk(&WALK_BACK, list.len(), depth)?;
        }
        self.counts()?;
        Ok(true)
    }

    /// The weights of the camera's rays in their pixels.
    pub fn weights(&self, count: usize) -> Result<Vec<f32>, GpuError> {
        let words = self.sums(SUMS + count)?;
        let weights = words[SUMS..].iter().copied().map(f32::from_bits);
        Ok(weights.collect())
    }

    /// Begins sums anew.
    pub fn clear_sums(&self, sums: usize) -> Result<(), GpuError> {
        self.gpu.write(&self.results, &vec![0; 4 * sums])
    }

    /// What the launches so far say (`faults.slang`); an error if any thread of theirs did not run its loops
    /// to their ends.
    pub(crate) fn counts(&self) -> Result<Vec<u32>, GpuError> {
        let counts = self.sums(SUMS)?;
        match counts[THREADS_CUT_SHORT] {
            0 => Ok(counts),
            threads => Err(self.gpu.loops_cut_short(threads)),
        }
    }

    /// The words of the sums.
    pub fn sums(&self, sums: usize) -> Result<Vec<u32>, GpuError> {
        let mut words = vec![0_u32; sums];
        self.gpu
            .read(&self.results, bytemuck::cast_slice_mut(&mut words))?;
        Ok(words)
    }

    /// Walks at the vertices, of this number, that so many listed paths are at, if directions to surfaces
    /// walk there.
    fn walk(&self, kernel: &CompiledKernel, count: usize, depth: usize) -> Result<(), GpuError> {
        if !self.edges.is_some_and(|edges| edges.crosses.walks(depth)) {
            return Ok(());
        }
        self.launch(kernel, count, depth)
    }

    /// True if the vertices of paths are kept.
    pub(crate) fn keeps_vertices(&self) -> bool {
        self.kernels.keeps()
    }

    /// How many paths fit, with those that go on to both sides of edges.
    fn columns(&self) -> usize {
        columns(self.capacity, self.edges)
    }

    pub(crate) fn launch(
        &self,
        kernel: &CompiledKernel,
        count: usize,
        depth: usize,
    ) -> Result<(), GpuError> {
        assert!(count <= self.columns(), "so many paths do not fit");
        let [nodes, leaf_starts, primitives, faces, records] = self.scene;
        let arrays = [
            nodes,
            leaf_starts,
            primitives,
            faces,
            records,
            &self.input,
            &self.state,
            &self.results,
        ];
        let words = [self.columns() as u32, depth as u32];
        // SAFETY: the arrays of a scene are those that its records were made with, which refer to
        // nothing behind their ends; what is behind the list refers to texels and pixels that the
        // records have, to edges that are there and to sums that fit; and the others
        // have the capacity for all paths, with their weights if they have no sums, and for as many vertices
        // of each as there are levels.
        #[allow(unsafe_code)]
        unsafe {
            self.gpu.launch(kernel, arrays, count as u32, words)
        }
    }
}

/// Paths that the arrays hold, if so many start at the camera.
fn columns(capacity: usize, edges: Option<&DeviceEdges>) -> usize {
    capacity * edges.map_or(1, |_| COLUMNS)
}
