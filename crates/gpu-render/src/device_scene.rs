//! A scene on the device.

use std::sync::Arc;

use capwalk_boundary::Boundaries;
use capwalk_diff::Wanted;
use capwalk_geometry::LocalFrame;
use capwalk_gpu::{DeviceArray, Gpu, GpuError, Precision};
use capwalk_math::Real;
use capwalk_render::{PreparedScene, SceneEval, Tracer};

use crate::camera_records::CameraRecords;
use crate::device_edges::DeviceEdges;
use crate::device_error::DeviceError;
use crate::edge_paths::MOST_PARTS;
use crate::edge_records::{EdgeMotion, EdgeRecords};
use crate::lobe_records::only_diffuse;
use crate::paths::Paths;
use crate::render_kernels::{DIFFUSE_IMAGE, IMAGE, PathKernels};
use crate::scene_records::{SceneRecords, exact_numbers};
use crate::texture_records::Shown;
use crate::unsupported::{Unsupported, unsupported};
use crate::upload::{upload_numbers, upload_words};

/// Of how many leaves before an emitter a thread looks at the edges, and how many points it takes on them
/// at most. Software Vulkan allows few rounds of loops; and where threads work for long, a launch of few
/// paths does, too.
const AT_ONCE_IN_SOFTWARE: [u32; 2] = [1, 16];
const AT_ONCE_ON_HARDWARE: [u32; 2] = [64, 64];

/// A scene in a device's memory.
#[derive(Debug)]
pub struct DeviceScene<'a> {
    pub(crate) gpu: Arc<Gpu>,
    pub(crate) prepared: &'a PreparedScene,
    pub(crate) frame: LocalFrame,
    /// Nodes, starts of leaves, triangles, their numbers, and records.
    arrays: [DeviceArray; 5],
    /// The number of each triangle's face.
    pub(crate) faces: Vec<u32>,
    /// The textures, by their numbers.
    pub(crate) textures: Vec<Shown>,
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
            faces,
            primitives,
            words: records,
            textures,
        } = SceneRecords::new(prepared, gpu.precision());
        // Kernels read four at a time.
        let mut padded = faces.clone();
        padded.resize(faces.len().next_multiple_of(4), 0);
        let arrays = [
            upload_words(gpu, &nodes)?,
            upload_words(gpu, &leaf_starts)?,
            upload_numbers(gpu, &primitives)?,
            upload_words(gpu, &padded)?,
            upload_words(gpu, &records)?,
        ];
        Ok(Self {
            gpu: gpu.clone(),
            prepared,
            frame,
            arrays,
            faces,
            textures,
        })
    }

    /// An error if so many words of derivatives leave no memory in a buffer for anything else.
    pub(crate) fn check_room_of_numbers(&self, words: usize) -> Result<(), Unsupported> {
        match 8 * words as u64 > self.gpu.largest_buffer() {
            true => Err(Unsupported {
                what: format!(
                    "derivatives, and those of the loss, take {words} words, more than half of a buffer of {}",
                    self.gpu.name()
                ),
            }),
            false => Ok(()),
        }
    }

    /// An error if something moves and the device has no double precision for the rays beside edges.
    pub(crate) fn check_precision(&self, wanted: &Wanted) -> Result<(), Unsupported> {
        match wanted.moves() && self.gpu.precision() == Precision::Single {
            true => Err(Unsupported {
                what: "the device has single precision alone, and something moves".to_owned(),
            }),
            false => Ok(()),
        }
    }

    /// Room for paths in this scene, see [`Paths::new`].
    pub(crate) fn paths<'p>(
        &'p self,
        kernels: &'static PathKernels,
        room_and_levels: [usize; 2],
        changes: &[u32],
        sums: usize,
        edges: Option<&'p DeviceEdges>,
    ) -> Result<Paths<'p>, GpuError> {
        let mut scene = self.arrays.each_ref();
        if let Some(edges) = edges {
            scene[2] = &edges.primitives;
        }
        Paths::new(
            &self.gpu,
            scene,
            kernels,
            room_and_levels,
            changes,
            sums,
            edges,
        )
    }

    /// Uploads the edges that paths cross where the scene moves, given what is known of its motion; an error
    /// if they do not fit.
    pub(crate) fn edges<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        tracer: &Tracer,
        boundaries: &Boundaries,
        motion: &EdgeMotion,
    ) -> Result<DeviceEdges, DeviceError> {
        let accel = self.prepared.accel();
        let camera = CameraRecords::new(accel, &self.frame);
        let numbers = exact_numbers(accel, &camera, self.gpu.precision());
        let at_once = match self.gpu.is_software() {
            true => AT_ONCE_IN_SOFTWARE,
            false => AT_ONCE_ON_HARDWARE,
        };
        let records = EdgeRecords::new(tracer, boundaries, eval, motion, &self.frame, at_once);
        let no_room = || {
            let (count, name) = (boundaries.edges().len(), self.gpu.name());
            let what = format!("{name} cannot hold {count} edges, and something moves");
            DeviceError::from(Unsupported { what })
        };
        if records.leaves_before_areas.div_ceil(at_once[0] as usize) > MOST_PARTS {
            return Err(no_room());
        }
        let image = match only_diffuse(self.prepared.scene()) {
            true => &DIFFUSE_IMAGE,
            false => &IMAGE,
        };
        DeviceEdges::new(&self.gpu, numbers, records, image).map_err(|error| match error {
            GpuError::TreeTooLarge { .. } | GpuError::OutOfMemory { .. } => no_room(),
            error => error.into(),
        })
    }
}
