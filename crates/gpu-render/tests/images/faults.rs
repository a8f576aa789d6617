//! Interruption, and devices that fail.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use capwalk_gpu::{Gpu, GpuError, GpuOptions, Precision};
use capwalk_gpu_render::{DeviceError, DeviceScene};
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, Watch};

use crate::{device, scenes};

/// Stops the work after some calls that ask for it.
pub struct Impatient {
    asked: AtomicU64,
    until: u64,
    done: AtomicU64,
}

impl Impatient {
    /// Stops it at the call behind so many.
    pub fn new(until: u64) -> Self {
        Self {
            asked: AtomicU64::new(0),
            until,
            done: AtomicU64::new(0),
        }
    }
}

impl Watch for Impatient {
    fn progress(&self, done: u64, _total: u64) {
        self.done.store(done, Ordering::Relaxed);
    }
    fn should_stop(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.until
    }
}

/// Work that is stopped gives what was done, in whole samples, and says how much that is.
#[test]
fn work_can_be_stopped() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    let prepared = PreparedScene::new(scenes::scene("parity/bitmap.xml"));
    let options = RenderOptions::new(16, 1);
    let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
    for (until, has_samples) in [(0, false), (1, false), (9, true)] {
        let watch = Impatient::new(until);
        let rendering = on_device.render(&options, &watch).expect("no error");
        let statistics = rendering.statistics;
        assert!(!statistics.complete);
        assert_eq!(statistics.samples, watch.done.into_inner());
        assert_eq!(statistics.samples > 0, has_samples, "{until}");
        assert!(
            rendering
                .value
                .mean
                .pixels
                .iter()
                .all(|pixel| pixel.is_finite())
        );
    }
}

/// A device that is lost gives errors, before and after the scene is there.
#[test]
fn lost_devices_are_errors() {
    if device::open(Precision::Double).is_none() {
        return;
    }
    let gpu = Arc::new(Gpu::new(&GpuOptions::default()).expect("a device"));
    let prepared = PreparedScene::new(scenes::scene("parity/bitmap.xml"));
    let on_device = DeviceScene::new(&gpu, &prepared).expect("supported");
    gpu.destroy();
    let is_lost = |error: Option<DeviceError>| {
        matches!(error, Some(DeviceError::Gpu(GpuError::DeviceLost { .. })))
    };
    let options = RenderOptions::new(1, 1);
    assert!(is_lost(on_device.render(&options, &Unwatched).err()));
    assert!(is_lost(DeviceScene::new(&gpu, &prepared).err()));
}

/// A scene that has no room in a buffer is an error that says so.
#[test]
fn scenes_that_are_too_large_are_errors() {
    if device::open(Precision::Double).is_none() {
        return;
    }
    let mut options = GpuOptions::default();
    options.largest_buffer = Some(1000);
    let gpu = Arc::new(Gpu::new(&options).expect("a device"));
    let prepared = PreparedScene::new(scenes::scene("parity/bitmap_ball.xml"));
    let error = DeviceScene::new(&gpu, &prepared).err();
    assert!(matches!(
        error,
        Some(DeviceError::Gpu(GpuError::TreeTooLarge { .. }))
    ));
}
