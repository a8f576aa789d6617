//! The average of the samples of each pixel, taken by a device.

use capwalk_boundary::pool;
use capwalk_gpu::GpuError;
use capwalk_render::SamplePlace;
use capwalk_render::tiles::Averages;
use capwalk_render::{
    CameraEdge, RenderOptions, SampleRange, TooManyImages, UsedDevice, Watch, average_on_device,
};

use crate::camera_edges::CameraEdges;
use crate::camera_records::sample_words;
use crate::device_edges::{COLUMNS, DeviceEdges};
use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::part_size::PartSize;
use crate::paths::{Followed, Paths};
use crate::render_kernels::PathKernels;
use crate::unsupported::unsupported_options;

/// Most samples that are on the device at a time: enough for a GPU to be busy.
pub const MOST_PATHS: usize = 1 << 18;

/// Draws the edge that the camera sees in a sample, with the derivative of its flow.
pub type DrawEdge<'a> =
    dyn Fn(&SamplePlace) -> Result<Option<CameraEdge<f64>>, TooManyImages> + Sync + 'a;

/// What takes samples, and how many at a time at most.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    pub kernels: &'static PathKernels,
    /// What changes.
    pub changes: &'a [u32],
    /// The edges that the camera sees, which are added to the last three numbers, and how the flow
    /// across that of a sample changes.
    pub edges: Option<(&'a CameraEdges<'a>, &'a DrawEdge<'a>)>,
    /// The edges that paths cross, if the scene moves.
    pub crossed: Option<&'a DeviceEdges>,
    pub most: usize,
}

impl DeviceScene<'_> {
    /// The averages of the first `N` numbers of samples.
    pub(crate) fn average<const N: usize>(
        &self,
        task: Task,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<Averages, DeviceError> {
        if let Some(unsupported) = unsupported_options(options) {
            return Err(unsupported.into());
        }
        pool::install(|| self.average_in_pool::<N>(task, options, watch))
    }

    fn average_in_pool<const N: usize>(
        &self,
        task: Task,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<Averages, DeviceError> {
        let most_words = (self.gpu.largest_buffer() / 4) as usize;
        let by_input = most_words.saturating_sub(task.changes.len()) / task.kernels.input;
        let by_state = most_words / task.kernels.path;
        let by_array = by_input.min(by_state) / task.crossed.map_or(1, |_| COLUMNS);
        let size = PartSize::new(task.most.min(by_array));
        let mut paths = None;
        let take = |samples: &SampleRange| {
            let mut taken = Vec::with_capacity(samples.len());
            while taken.len() < samples.len() {
                let end = samples.len().min(taken.len() + size.get());
                let some = &samples.part(taken.len()..end);
                let before = self.gpu.busy();
                match self.take::<N>(some, size.get(), task, &mut paths, watch) {
                    Ok(Some(samples)) => taken.extend(samples),
                    Ok(None) => return Ok(None),
                    Err(DeviceError::Gpu(GpuError::OutOfMemory { .. })) if size.halve() => {
                        paths = None;
                        continue;
                    }
                    Err(error) => return Err(error),
                }
                size.follow(self.gpu.busy().saturating_sub(before), some.len());
            }
            Ok(Some(taken))
        };
        let scene = self.prepared.scene();
        let mut averages = average_on_device(scene, options, || size.get(), watch, take)?;
        averages.statistics.device = UsedDevice::gpu(self.gpu.name());
        Ok(averages)
    }

    /// The numbers of some samples; `None` if the watch stopped the work.
    fn take<'p, const N: usize>(
        &'p self,
        samples: &SampleRange,
        capacity: usize,
        task: Task<'p>,
        paths: &mut Option<Paths<'p>>,
        watch: &dyn Watch,
    ) -> Result<Option<Vec<[f64; N]>>, DeviceError> {
        let paths = match paths {
            Some(paths) if paths.capacity() >= capacity => paths,
            other => {
                *other = None;
                let (kernels, changes) = (task.kernels, task.changes);
                other.insert(self.paths(kernels, [capacity, 0], changes, 0, task.crossed)?)
            }
        };
        let (count, beginning) = (samples.len(), sample_words(samples));
        let Followed::ToTheEnd(_) = paths.follow(count, &beginning, watch)? else {
            return Ok(None);
        };
        let numbers = paths.numbers(count)?.into_iter();
        let weighted =
            |(numbers, weight): ([f32; N], f32)| numbers.map(|x| f64::from(x) * f64::from(weight));
        let numbers = numbers.zip(paths.weights(count)?).map(weighted);
        let mut taken: Vec<[f64; N]> = numbers.collect();
        if let Some((edges, draw)) = task.edges {
            let Some(drawn) = edges.of(self, samples, draw, capacity, watch)? else {
                return Ok(None);
            };
            for edge in drawn {
                let term = (edge.discontinuity * edge.flow).to_array();
                let derivative = taken[edge.sample][N - 3..].iter_mut().zip(term);
                derivative.for_each(|(number, term)| *number += term);
            }
        }
        Ok(Some(taken))
    }
}
