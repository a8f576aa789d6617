//! The device's image beside the processor's, sample by sample.

use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_math::Rgb;
use capwalk_render::{PreparedScene, RenderOptions, Rendering, Unwatched, render};

use crate::device;

/// Samples differ if they do by more than this, relatively: single precision of what a path
/// multiplies.
const DIFFERENT: f64 = 2e-4;

/// The share of samples that may: rays that pass an edge on its other side, roulette, and emitters
/// that are seen small.
const MOST_DIFFERENT: f64 = 0.01;

/// The image; `None` where there is no device.
pub fn on_device(
    prepared: &PreparedScene,
    options: &RenderOptions,
    precision: Precision,
) -> Option<Rendering> {
    let gpu = device::open(precision)?;
    let scene = DeviceScene::new(gpu, prepared).expect("supported");
    Some(
        scene
            .render(options, &Unwatched)
            .expect("a device that works"),
    )
}

/// An error, in words, if too many samples differ; `None` where there is no device.
pub fn compare(prepared: &PreparedScene, precision: Precision) -> Option<Result<(), String>> {
    let options = RenderOptions::new(1, 7);
    let ours = on_device(prepared, &options, precision)?;
    let theirs = render(prepared, &options, &Unwatched);
    let pairs = ours.value.mean.pixels.iter().zip(&theirs.value.mean.pixels);
    let differs = |(&a, &b): (&Rgb, &Rgb)| {
        let difference = (a - b).map(f64::abs).max_component();
        difference.is_nan() || difference > DIFFERENT * b.map(f64::abs).max_component().max(1e-3)
    };
    let (count, all) = (
        pairs.filter(|&pair| differs(pair)).count(),
        ours.value.mean.pixels.len(),
    );
    let is_good = count as f64 <= MOST_DIFFERENT * all as f64;
    Some(
        is_good
            .then_some(())
            .ok_or_else(|| format!("{count} of {all} samples differ")),
    )
}
