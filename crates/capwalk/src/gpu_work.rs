//! Images and derivatives from a GPU.

use capwalk_diff::{
    Backward, Device, GradientImage, GradientOptions, PreparedScene, RenderOptions, Rendering,
    Wanted, Watch,
};
use capwalk_gpu::{GpuError, Precision};
use capwalk_gpu_render::{
    DeviceError, DeviceScene, Unsupported, unsupported, unsupported_derivative,
};
use capwalk_scene::{Image, Tangent};

use crate::device::{DeviceFailure, Found};
use crate::error::Error;
use crate::shared_gpu::{give_up, shared_gpu};

/// The image of a scene, see [`found`].
pub fn image(
    prepared: &PreparedScene,
    options: &RenderOptions,
    watch: &dyn Watch,
) -> Result<Found<Rendering>, Error> {
    let missing = || unsupported(prepared);
    found(prepared, options.device, missing, |scene| {
        scene.render(options, watch)
    })
}

/// The derivative of an image along a tangent, see [`found`].
pub fn gradient(
    prepared: &PreparedScene,
    tangent: &Tangent,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<Found<GradientImage>, Error> {
    let missing = || {
        let derivative = || unsupported_derivative(prepared, &Wanted::by(tangent), options);
        unsupported(prepared).or_else(derivative)
    };
    found(prepared, options.device, missing, |scene| {
        scene.gradient(tangent, options, watch)
    })
}

/// The gradient of `Σ adjoint · image` in what is wanted, see [`found`].
pub fn backward(
    prepared: &PreparedScene,
    adjoint: &Image,
    wanted: &Wanted,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<Found<Backward>, Error> {
    let missing = || {
        let derivative = || unsupported_derivative(prepared, wanted, options);
        unsupported(prepared).or_else(derivative)
    };
    found(prepared, options.device, missing, |scene| {
        scene.backward(adjoint, wanted, options, watch)
    })
}

/// What the GPU that is found computes, unless something is missing there. The CPU, for [`Device::Cpu`],
/// and for [`Device::Auto`] where there is none, or where it has not all that is needed.
fn found<T>(
    prepared: &PreparedScene,
    device: Device,
    missing: impl FnOnce() -> Option<Unsupported>,
    compute: impl FnOnce(&DeviceScene) -> Result<T, DeviceError>,
) -> Result<Found<T>, Error> {
    if device == Device::Cpu {
        return Ok(Found::OnCpu { remark: None });
    }
    let may_fall_back = device == Device::Auto;
    let on_cpu = |remark: Option<String>| Ok(Found::OnCpu { remark });
    // Whether there is a GPU or not.
    if let Some(missing) = missing() {
        return match (may_fall_back, shared_gpu()) {
            (false, _) => Err(failure(missing.into())),
            // Where there is software only, the CPU is what is meant.
            (true, Ok(gpu)) if !gpu.is_software() => on_cpu(Some(remark(&missing.what))),
            (true, _) => on_cpu(None),
        };
    }
    let gpu = match shared_gpu() {
        Ok(gpu) if may_fall_back && gpu.is_software() => return on_cpu(None),
        Ok(gpu) => gpu,
        Err(GpuError::NoAdapter { .. }) if may_fall_back => return on_cpu(None),
        Err(error) if may_fall_back => return on_cpu(Some(remark(&error))),
        Err(error) => return Err(failure(error.into())),
    };
    // Shadows of what touches have gaps in single precision.
    if may_fall_back && gpu.precision() == Precision::Single {
        return on_cpu(Some(remark(&"it has no double precision")));
    }
    let noted = |error: DeviceError| {
        if let DeviceError::Gpu(error) = &error {
            give_up(&gpu, error);
        }
        error
    };
    let scene = match DeviceScene::new(&gpu, prepared).map_err(noted) {
        Ok(scene) => scene,
        Err(error) if may_fall_back => return on_cpu(Some(remark(&error))),
        Err(error) => return Err(failure(error)),
    };
    match compute(&scene).map_err(noted) {
        Ok(result) => Ok(Found::OnGpu(result)),
        Err(DeviceError::Unsupported(missing)) if may_fall_back => {
            on_cpu(Some(remark(&missing.what)))
        }
        Err(error) => Err(failure(error)),
    }
}

/// What the CPU would refuse as well is no failure of the device.
fn failure(error: DeviceError) -> Error {
    match error {
        DeviceError::Refused(refusal) => refusal.into(),
        error => DeviceFailure::from(error).into(),
    }
}

fn remark(why: &dyn std::fmt::Display) -> String {
    format!("computed on the CPU, not on the GPU: {why}")
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use capwalk_diff::UsedDevice;
    use capwalk_gpu::Gpu;

    use super::*;
    use crate::shared_gpu::tests::device_alone;
    use crate::{Loader, Prepared, Unwatched};

    /// Loses the device when the image has begun.
    struct Unplugs(Arc<Gpu>);

    impl Watch for Unplugs {
        fn progress(&self, _: u64, _: u64) {}

        fn should_stop(&self) -> bool {
            self.0.destroy();
            false
        }
    }

    #[test]
    fn a_lost_device_is_an_error_and_the_next_image_has_another() {
        let Some((_alone, gpu)) = device_alone() else {
            return;
        };
        let scene = Loader::new("leaf").size([8, 6]).load().expect("built in");
        let prepared = Prepared::new(scene.scene).expect("a valid scene");
        let options = RenderOptions {
            device: Device::Gpu,
            ..RenderOptions::new(2, 1)
        };
        let image = |watch: &dyn Watch| prepared.render(&options, watch);
        let before = image(&Unwatched).expect("it has all that is needed");
        assert_eq!(before.statistics.device, UsedDevice::gpu(gpu.name()));
        let lost = image(&Unplugs(Arc::clone(&gpu))).expect_err("there is no device");
        assert!(matches!(
            lost,
            Error::Device(DeviceFailure::Failed(DeviceError::Gpu(
                GpuError::DeviceLost { .. }
            )))
        ));
        let after = image(&Unwatched).expect("it is opened again");
        assert_eq!(after.value, before.value);
        assert!(!Arc::ptr_eq(&gpu, &shared_gpu().expect("it is open")));
    }
}
