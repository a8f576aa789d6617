//! The device's image beside the CPU's, sample by sample.

use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_math::Rgb;
use capwalk_render::{PreparedScene, RenderOptions, Rendering, Unwatched, render};
use capwalk_scene::Image;

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
    let (count, all) = different(&ours.value.mean, &theirs.value.mean, DIFFERENT);
    let is_good = count as f64 <= MOST_DIFFERENT * all as f64;
    Some(
        is_good
            .then_some(())
            .ok_or_else(|| format!("{count} of {all} samples differ")),
    )
}

/// How many pixels differ by more than this, relatively, and how many there are.
pub fn different(ours: &Image, theirs: &Image, tolerance: f64) -> (usize, usize) {
    let differs = |(&a, &b): (&Rgb, &Rgb)| {
        let [difference, size] = [a - b, b].map(|c| c.map(f64::abs).max_component());
        difference.is_nan() || difference > tolerance * size.max(1e-3)
    };
    let pairs = ours.pixels.iter().zip(&theirs.pixels);
    (
        pairs.filter(|&pair| differs(pair)).count(),
        ours.pixels.len(),
    )
}
