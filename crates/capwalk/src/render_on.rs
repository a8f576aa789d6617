//! Images on a device.

use capwalk_diff::{RenderOptions, Watch};

use crate::device::{Device, DeviceRendering, Found};
use crate::error::Error;
use crate::gpu_images;
use crate::options::check_spp;
use crate::prepared::Prepared;

impl Prepared {
    /// [`Prepared::render`] on a device. A GPU takes the processor's samples, with its random
    /// numbers, and rounds differently: the same scene, seed, options and device give the same
    /// bits. The first image opens the device, and the process keeps it until it is lost. An error
    /// if it is asked for and there is none, if it has not all that the scene needs, or if it
    /// fails; the feature `gpu` must have been built.
    ///
    /// ```
    /// # use capwalk::{Device, Prepared, RenderOptions, Unwatched};
    /// # let scene = capwalk::Loader::new("leaf").size([8, 6]).load()?.scene;
    /// # let prepared = Prepared::new(scene)?;
    /// let image = prepared.render_on(Device::Auto, &RenderOptions::new(4, 1), &Unwatched)?;
    /// assert!(image.rendering.statistics.complete);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn render_on(
        &self,
        device: Device,
        options: &RenderOptions,
        watch: &dyn Watch,
    ) -> Result<DeviceRendering, Error> {
        check_spp("spp", options.spp)?;
        let found = match device {
            Device::Cpu => Found::Processor { remark: None },
            Device::Auto | Device::Gpu => {
                gpu_images::image(self.prepared_scene(), device, options, watch)?
            }
        };
        match found {
            Found::Image { rendering, adapter } => Ok(DeviceRendering {
                rendering,
                adapter: Some(adapter),
                remark: None,
            }),
            Found::Processor { remark } => Ok(DeviceRendering {
                rendering: self.render(options, watch)?,
                adapter: None,
                remark,
            }),
        }
    }
}
