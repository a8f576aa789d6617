//! `gpu_work.rs` where the feature `gpu` was not built.

use capwalk_diff::{
    Backward, Device, GradientImage, GradientOptions, PreparedScene, RenderOptions, Rendering,
    Wanted, Watch,
};
use capwalk_scene::{Image, Tangent};

use crate::device::{DeviceFailure, Found};
use crate::error::Error;

/// The CPU, unless a GPU is asked for.
pub fn image(
    _: &PreparedScene,
    options: &RenderOptions,
    _: &dyn Watch,
) -> Result<Found<Rendering>, Error> {
    found(options.device)
}

/// The CPU, unless a GPU is asked for, which is an error.
pub fn gradient(
    _: &PreparedScene,
    _: &Tangent,
    options: &GradientOptions,
    _: &dyn Watch,
) -> Result<Found<GradientImage>, Error> {
    found(options.device)
}

/// The CPU, unless a GPU is asked for, which is an error.
pub fn backward(
    _: &PreparedScene,
    _: &Image,
    _: &Wanted,
    options: &GradientOptions,
    _: &dyn Watch,
) -> Result<Found<Backward>, Error> {
    found(options.device)
}

fn found<T>(device: Device) -> Result<Found<T>, Error> {
    match device {
        Device::Gpu => Err(DeviceFailure::NotBuilt.into()),
        Device::Auto | Device::Cpu => Ok(Found::OnCpu { remark: None }),
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
    fn without_a_gpu() {
        let prepared = PreparedScene::new(builtin::scene("leaf").expect("built in"));
        let scene = prepared.scene();
        let still = Tangent::zero(scene);
        let (wanted, adjoint) = (Wanted::by(&still), Image::new(1, 1));
        let found = |device| {
            let options = GradientOptions {
                device,
                ..GradientOptions::default()
            };
            let sampling = options.sampling();
            [
                image(&prepared, &sampling, &Unwatched).map(is_left_to_cpu),
                gradient(&prepared, &still, &options, &Unwatched).map(is_left_to_cpu),
                backward(&prepared, &adjoint, &wanted, &options, &Unwatched).map(is_left_to_cpu),
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
        matches!(found, Found::OnCpu { remark: None })
    }
}
