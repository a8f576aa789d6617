//! Images from a GPU.

use std::sync::Arc;

use capwalk_diff::{PreparedScene, RenderOptions, Watch};
use capwalk_gpu::{Gpu, GpuError, GpuOptions, Precision};
use capwalk_gpu_render::{DeviceError, DeviceScene, unsupported};

use crate::device::{Device, DeviceFailure, Found};

/// The image of a scene from the GPU that is found. The processor, for [`Device::Auto`], where
/// there is none, or where it has not all that the scene needs.
pub fn image(
    prepared: &PreparedScene,
    device: Device,
    options: &RenderOptions,
    watch: &dyn Watch,
) -> Result<Found, DeviceFailure> {
    let may_fall_back = device == Device::Auto;
    let on_processor = |remark: Option<String>| Ok(Found::Processor { remark });
    // Whether there is a GPU or not.
    if let Some(missing) = unsupported(prepared).filter(|_| !may_fall_back) {
        return Err(DeviceError::from(missing).into());
    }
    let gpu = match Gpu::new(&GpuOptions::default()) {
        Ok(gpu) if may_fall_back && gpu.is_software() => return on_processor(None),
        Ok(gpu) => Arc::new(gpu),
        Err(GpuError::NoAdapter { .. }) if may_fall_back => return on_processor(None),
        Err(error) if may_fall_back => return on_processor(Some(remark(&error))),
        Err(error) => return Err(DeviceError::Gpu(error).into()),
    };
    // Shadows of what touches have gaps in single precision.
    if may_fall_back && gpu.precision() == Precision::Single {
        return on_processor(Some(remark(&"it has no double precision")));
    }
    let scene = match DeviceScene::new(&gpu, prepared) {
        Ok(scene) => scene,
        Err(DeviceError::Unsupported(missing)) if may_fall_back => {
            return on_processor(Some(remark(&missing.what)));
        }
        Err(error) if may_fall_back => return on_processor(Some(remark(&error))),
        Err(error) => return Err(error.into()),
    };
    match scene.render(options, watch) {
        Ok(rendering) => Ok(Found::Image {
            rendering,
            adapter: gpu.name().to_owned(),
        }),
        Err(DeviceError::Unsupported(missing)) if may_fall_back => {
            on_processor(Some(remark(&missing.what)))
        }
        Err(error) => Err(error.into()),
    }
}

fn remark(why: &dyn std::fmt::Display) -> String {
    format!("rendered on the CPU, not on the GPU: {why}")
}
