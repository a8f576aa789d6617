//! `gpu_work.rs` where the feature `gpu` was not built.

use capwalk_diff::{
    Backward, GradientImage, GradientOptions, PreparedScene, RenderOptions, Rendering, Wanted,
    Watch,
};
use capwalk_scene::{Image, Tangent};

use crate::device::{Device, DeviceFailure, Found};
use crate::error::Error;

/// The CPU, unless a GPU is asked for.
pub fn image(
    _: &PreparedScene,
    device: Device,
    _: &RenderOptions,
    _: &dyn Watch,
) -> Result<Found<Rendering>, Error> {
    found(device)
}

/// The CPU, unless a GPU is asked for, which is an error.
pub fn gradient(
    _: &PreparedScene,
    device: Device,
    _: &Tangent,
    _: &GradientOptions,
    _: &dyn Watch,
) -> Result<Found<GradientImage>, Error> {
    found(device)
}

/// The CPU, unless a GPU is asked for, which is an error.
pub fn backward(
    _: &PreparedScene,
    device: Device,
    _: (&Image, &Wanted),
    _: &GradientOptions,
    _: &dyn Watch,
) -> Result<Found<Backward>, Error> {
    found(device)
}

fn found<T>(device: Device) -> Result<Found<T>, Error> {
    match device {
        Device::Gpu => Err(DeviceFailure::NotBuilt.into()),
        Device::Auto | Device::Cpu => Ok(Found::Cpu { remark: None }),
    }
}
