//! Images from a device.

use capwalk_render::{RenderOptions, Rendering, Watch};

use crate::averages::{MOST_PATHS, Task};
use crate::device_error::DeviceError;
use crate::device_scene::DeviceScene;
use crate::lobe_records::only_diffuse;
use crate::render_kernels::{DIFFUSE_IMAGE, IMAGE};

impl DeviceScene<'_> {
    /// The image, with its standard errors. If `watch` stops the work, what was done is returned.
    pub fn render(
        &self,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<Rendering, DeviceError> {
        self.render_in_parts(options, MOST_PATHS, watch)
    }

    /// [`Self::render`] with so many samples on the device at a time at most, which changes no bit.
    pub fn render_in_parts(
        &self,
        options: &RenderOptions,
        most: usize,
        watch: &dyn Watch,
    ) -> Result<Rendering, DeviceError> {
        let kernels = match only_diffuse(self.prepared.scene()) {
            true => &DIFFUSE_IMAGE,
            false => &IMAGE,
        };
        let task = Task {
            kernels,
            changes: &[],
            edges: None,
            crossed: None,
            most,
        };
        let averages = self.average::<3>(task, options, watch)?;
        Ok(Rendering {
            value: averages.estimate(self.prepared.scene(), 0),
            statistics: averages.statistics,
        })
    }
}
