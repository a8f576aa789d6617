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

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_diff::Unwatched;
    use capwalk_scene::builtin;

    /// A GPU that is asked for is an error that says how to build it; where any device will do, it
    /// is the CPU, in every mode.
    #[test]
    fn there_is_no_gpu() {
        let prepared = PreparedScene::new(builtin::scene("leaf").expect("built in"));
        let scene = prepared.scene();
        let still = Tangent::zero(scene);
        let (wanted, adjoint) = (Wanted::by(&still), Image::new(1, 1));
        let (sampling, options) = (RenderOptions::default(), GradientOptions::default());
        let found = |device| {
            [
                image(&prepared, device, &sampling, &Unwatched).map(is_left_to_cpu),
                gradient(&prepared, device, &still, &options, &Unwatched).map(is_left_to_cpu),
                backward(&prepared, device, (&adjoint, &wanted), &options, &Unwatched)
                    .map(is_left_to_cpu),
            ]
        };
        for device in [Device::Auto, Device::Cpu] {
            assert!(found(device).iter().all(|found| matches!(found, Ok(true))));
        }
        for found in found(Device::Gpu) {
            let text = found.expect_err("there is none").to_string();
            for words in ["built without the GPU", "--features gpu", "--device cpu"] {
                assert!(text.contains(words), "no \"{words}\" in: {text}");
            }
        }
    }

    fn is_left_to_cpu<T>(found: Found<T>) -> bool {
        matches!(found, Found::Cpu { remark: None })
    }
}
