//! `gpu_images.rs` where the feature `gpu` was not built.

use capwalk_diff::{PreparedScene, RenderOptions, Watch};

use crate::device::{Device, DeviceFailure, Found};

/// The processor, unless a GPU is asked for.
pub fn image(
    _: &PreparedScene,
    device: Device,
    _: &RenderOptions,
    _: &dyn Watch,
) -> Result<Found, DeviceFailure> {
    match device {
        Device::Gpu => Err(DeviceFailure::NotBuilt),
        Device::Auto | Device::Cpu => Ok(Found::Processor { remark: None }),
    }
}
