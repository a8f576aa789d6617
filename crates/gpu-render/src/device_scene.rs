//! A scene on the device, and its image.

use std::cell::Cell;
use std::sync::Arc;
use std::time::Duration;

use capwalk_boundary::pool;
use capwalk_geometry::LocalFrame;
use capwalk_gpu::{DeviceArray, Gpu, GpuError, Precision};
use capwalk_render::tiles::SamplePlace;
use capwalk_render::{PreparedScene, RenderOptions, Rendering, Tracer, Watch, average_elsewhere};
use rayon::prelude::*;

use crate::camera_rays::write_camera_ray;
use crate::device_error::DeviceError;
use crate::lobe_records::only_diffuse;
use crate::paths::Paths;
use crate::render_kernels::CAMERA_RAY;
use crate::scene_records::SceneRecords;
use crate::unsupported::{unsupported, unsupported_options};

/// Most samples that are on the device at a time: enough for a GPU to be busy.
const MOST_PATHS: usize = 1 << 18;

/// Samples of the first part, when it is not known yet how long they take.
const FIRST_PATHS: usize = 1 << 14;

/// Kernels should take about this long for a part: progress is seen after each, and what of one is
/// done when the work is stopped is lost.
const PART: Duration = Duration::from_millis(500);

/// With no room for so many paths, there is none for the image.
const FEWEST_PATHS: usize = 64;

/// A scene in a device's memory.
#[derive(Debug)]
pub struct DeviceScene<'a> {
    gpu: Arc<Gpu>,
    prepared: &'a PreparedScene,
    frame: LocalFrame,
    /// Nodes, starts of leaves, triangles, their numbers, and records.
    arrays: [DeviceArray; 5],
    only_diffuse: bool,
}

impl<'a> DeviceScene<'a> {
    /// Uploads a scene; an error if it has something that the device's renderer has not.
    pub fn new(gpu: &Arc<Gpu>, prepared: &'a PreparedScene) -> Result<Self, DeviceError> {
        if let Some(unsupported) = unsupported(prepared) {
            return Err(unsupported.into());
        }
        gpu.check()?;
        let SceneRecords {
            frame,
            nodes,
            leaf_starts,
            mut faces,
            primitives,
            words: records,
        } = SceneRecords::new(prepared, gpu.precision());
        // Kernels read four at a time.
        faces.resize(faces.len().next_multiple_of(4), 0);
        let single: Vec<f32>;
        let primitives: &[u8] = match gpu.precision() {
            Precision::Double => bytemuck::cast_slice(&primitives),
            Precision::Single => {
                single = primitives.iter().map(|&x| x as f32).collect();
                bytemuck::cast_slice(&single)
            }
        };
        let upload = |bytes: &[u8]| -> Result<DeviceArray, GpuError> {
            let (bytes_needed, limit) = (bytes.len() as u64, gpu.largest_buffer());
            if bytes_needed > limit {
                return Err(GpuError::TreeTooLarge {
                    adapter: gpu.name().to_owned(),
                    bytes: bytes_needed,
                    limit,
                });
            }
            let array = gpu.array(bytes_needed)?;
            gpu.write(&array, bytes)?;
            Ok(array)
        };
        let words = |words: &[u32]| upload(bytemuck::cast_slice(words));
        let arrays = [
            words(&nodes)?,
            words(&leaf_starts)?,
            upload(primitives)?,
            words(&faces)?,
            words(&records)?,
        ];
        Ok(Self {
            gpu: gpu.clone(),
            prepared,
            frame,
            arrays,
            only_diffuse: only_diffuse(&prepared.accel().scene),
        })
    }

    /// The image, with its standard errors. If `watch` stops the work, what was done is returned.
    pub fn render(
        &self,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<Rendering, DeviceError> {
        self.render_in_parts(options, MOST_PATHS, watch)
    }

    /// The same with so many samples on the device at a time at most, which changes no bit.
    pub fn render_in_parts(
        &self,
        options: &RenderOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<Rendering, DeviceError> {
        if let Some(unsupported) = unsupported_options(options) {
            return Err(unsupported.into());
        }
        pool::install(|| self.average(options, most, watch))
    }

    fn average(
        &self,
        options: &RenderOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<Rendering, DeviceError> {
        let tracer = Tracer::primal(self.prepared);
        let allowed = self.gpu.largest_buffer() / Paths::BYTES as u64;
        let most = Cell::new(most.min(allowed as usize).max(1));
        let size = Cell::new(most.get().min(FIRST_PATHS));
        let mut paths = None;
        let take = |places: &[SamplePlace]| {
            let mut taken = Vec::with_capacity(places.len());
            while taken.len() < places.len() {
                let rest = &places[taken.len()..];
                let some = &rest[..rest.len().min(size.get())];
                let before = self.gpu.busy();
                match self.take(&tracer, some, size.get(), &mut paths, watch) {
                    Ok(Some(samples)) => taken.extend(samples),
                    Ok(None) => return Ok(None),
                    Err(GpuError::OutOfMemory { .. }) if size.get() > FEWEST_PATHS => {
                        most.set(size.get() / 2);
                        size.set(most.get());
                        paths = None;
                        continue;
                    }
                    Err(error) => return Err(error.into()),
                }
                let took = self.gpu.busy().saturating_sub(before);
                if took > PART {
                    size.set((size.get() / 2).max(FEWEST_PATHS.min(most.get())));
                } else if 3 * took < PART && some.len() == size.get() {
                    size.set((2 * size.get()).min(most.get()));
                }
            }
            Ok(Some(taken))
        };
        average_elsewhere(self.prepared.scene(), options, || size.get(), watch, take)
    }

    /// The colours of some samples; `None` if the watch stopped the work.
    fn take(
        &self,
        tracer: &Tracer,
        places: &[SamplePlace],
        room: usize,
        paths: &mut Option<Paths>,
        watch: &dyn Watch,
    ) -> Result<Option<Vec<[f64; 3]>>, GpuError> {
        let paths = match paths {
            Some(paths) if paths.room() >= room => paths,
            other => {
                *other = None;
                other.insert(Paths::new(&self.gpu, room)?)
            }
        };
        let mut rays = vec![0; CAMERA_RAY * places.len()];
        let weights = (places, rays.par_chunks_exact_mut(CAMERA_RAY))
            .into_par_iter()
            .map(|(place, words)| write_camera_ray(tracer, &self.frame, place, words));
        let weights: Vec<f64> = weights.collect();
        let (arrays, only_diffuse) = (self.arrays.each_ref(), self.only_diffuse);
        let light = paths.light(&self.gpu, arrays, only_diffuse, &rays, watch)?;
        let weighted = |(light, weight): ([f32; 3], f64)| light.map(|x| f64::from(x) * weight);
        Ok(light.map(|light| light.into_iter().zip(weights).map(weighted).collect()))
    }
}
