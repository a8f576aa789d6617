//! Room on the device for a part of the samples, and the stages that they go through.

use capwalk_geometry::buffers::NONE;
use capwalk_gpu::{DeviceArray, Gpu, GpuError};
use capwalk_render::Watch;

use crate::render_kernels::{BEGIN_PATHS, CAMERA_RAY, GO_ON, GO_ON_DIFFUSE, PATH};

/// Room for so many paths.
#[derive(Debug)]
pub struct Paths {
    room: usize,
    /// The camera's rays, and then the list of the paths that go on.
    input: DeviceArray,
    /// What is known of each.
    state: DeviceArray,
    /// Those of the list that go on after it.
    going_on: DeviceArray,
}

impl Paths {
    /// Bytes of the largest array, per path.
    pub const BYTES: usize = 4 * PATH;

    /// How many there is room for.
    pub fn room(&self) -> usize {
        self.room
    }

    /// Room for so many paths.
    pub fn new(gpu: &Gpu, room: usize) -> Result<Self, GpuError> {
        let array = |words: usize| gpu.array((4 * words * room) as u64);
        Ok(Self {
            room,
            input: array(CAMERA_RAY)?,
            state: array(PATH)?,
            going_on: array(1)?,
        })
    }

    /// Follows paths to their ends, given their camera rays, and returns the light that each one
    /// carries; `None` if the watch stopped it. `scene` are the five arrays of a scene, and
    /// `only_diffuse` what [`only_diffuse`](crate::lobe_records::only_diffuse) says of it.
    pub fn light(
        &self,
        gpu: &Gpu,
        scene: [&DeviceArray; 5],
        only_diffuse: bool,
        rays: &[u32],
        watch: &dyn Watch,
    ) -> Result<Option<Vec<[f32; 3]>>, GpuError> {
        let count = rays.len() / CAMERA_RAY;
        let [nodes, leaf_starts, primitives, faces, records] = scene;
        let (input, state, going_on) = (&self.input, &self.state, &self.going_on);
        let arrays = [
            nodes,
            leaf_starts,
            primitives,
            faces,
            records,
            input,
            state,
            going_on,
        ];
        gpu.write(input, bytemuck::cast_slice(rays))?;
        let launch = |kernel, count: usize, depth: u32| {
            assert!(count <= self.room, "there is no room for so many paths");
            // SAFETY: the arrays of a scene are those that its records were made with, which refer to
            // nothing behind their ends, and the others have room for all paths.
            #[allow(unsafe_code)]
            unsafe {
                gpu.launch(kernel, arrays, count as u32, [self.room as u32, depth])
            }
        };
        let go_on = if only_diffuse { &GO_ON_DIFFUSE } else { &GO_ON };
        launch(&BEGIN_PATHS, count, 0)?;
        let mut list = vec![0_u32; count];
        for depth in 0.. {
            // In the order of the paths, whichever thread was first.
            gpu.read(going_on, bytemuck::cast_slice_mut(&mut list))?;
            list.retain(|&path| path != NONE);
            if list.is_empty() {
                break;
            }
            if watch.should_stop() {
                return Ok(None);
            }
            gpu.write(input, bytemuck::cast_slice(&list))?;
            launch(go_on, list.len(), depth)?;
        }
        // One array for each channel, as long as there is room for paths.
        let mut channels = vec![0_f32; 2 * self.room + count];
        gpu.read(state, bytemuck::cast_slice_mut(&mut channels))?;
        let light = |path: usize| [0, 1, 2].map(|channel| channels[channel * self.room + path]);
        Ok(Some((0..count).map(light).collect()))
    }
}
