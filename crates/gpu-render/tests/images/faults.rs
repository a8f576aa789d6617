//! Interruption, and devices that fail.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use capwalk_diff::{GradientOptions, Wanted};
use capwalk_geometry::Mesh;
use capwalk_gpu::{Gpu, GpuError, GpuOptions, Precision};
use capwalk_gpu_render::{DeviceError, DeviceScene};
use capwalk_math::Vec3;
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, Watch};
use capwalk_scene::{ShadingNormals, Shape};

use crate::derivatives::{adjoint, all_texels};
use crate::motion::everything;
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

/// Where memory is scarce parts are smaller, with the same bits; without memory for a small one there is an
/// error.
#[test]
fn scarce_memory_makes_parts_smaller() {
    if device::open(Precision::Double).is_none() {
        return;
    }
    let gpu = Arc::new(Gpu::new(&GpuOptions::default()).expect("a device"));
    let mut scene = scenes::scene("parity/bitmap_box.xml");
    scene.film.resize([20, 15]);
    let (wanted, adjoint) = (Wanted::by(&all_texels(&scene)), adjoint(&scene));
    let prepared = PreparedScene::new(scene);
    let on_device = DeviceScene::new(&gpu, &prepared).expect("supported");
    let options = RenderOptions::new(4, 1);
    let image = || on_device.render(&options, &Unwatched);
    let gradient = || {
        let options = GradientOptions::new(options);
        on_device.backward(&adjoint, &wanted, &options, &Unwatched)
    };
    let both = || {
        let gradient = gradient().expect("enough memory");
        (
            image().expect("enough memory").value,
            gradient.gradient().clone(),
        )
    };
    let whole = both();
    gpu.pretend_memory(1 << 17);
    assert!(both() == whole);
    gpu.pretend_memory(100);
    let no_room = |error: Option<DeviceError>| {
        matches!(error, Some(DeviceError::Gpu(GpuError::OutOfMemory { .. })))
    };
    assert!(no_room(image().err()) && no_room(gradient().err()));
    // Before anything is done, so that the CPU can do it.
    let moving = everything(prepared.scene());
    let error = on_device.gradient(&moving, &GradientOptions::new(options), &Unwatched);
    match error.err() {
        Some(DeviceError::Unsupported(found)) => {
            assert!(found.what.contains("cannot hold"), "{found}");
        }
        other => panic!("{other:?}"),
    }
}

/// A scene that does not fit in a buffer is an error that says so.
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

/// Software that ends loops early, without a word, is found out: rays pass the boxes of very many
/// slivers and hit none of them.
#[test]
fn loops_that_are_cut_short_are_noticed() {
    let Some(gpu) = device::open(Precision::Double) else {
        return;
    };
    if !gpu.is_software() {
        return;
    }
    let mut scene = scenes::scene("parity/bitmap.xml");
    scene.film.resize([8, 6]);
    for (count, is_cut) in [(1_000, false), (100_000, true)] {
        scene.shapes[0] = Arc::new(Shape {
            mesh: slivers(count),
            normals: ShadingNormals::Face,
            uvs: None,
            ..Shape::clone(&scene.shapes[0])
        });
        let prepared = PreparedScene::new(scene.clone());
        let on_device = DeviceScene::new(gpu, &prepared).expect("supported");
        let rendered = on_device.render(&RenderOptions::new(1, 1), &Unwatched);
        let error = rendered.err();
        let noticed = matches!(
            error,
            Some(DeviceError::Gpu(GpuError::CutShort { threads: 1.., .. }))
        );
        assert_eq!(noticed, is_cut, "{count}: {error:?}");
    }
}

/// Diagonals of squares one behind the other.
fn slivers(count: u32) -> Mesh {
    let corners = |k: u32| {
        let z = f64::from(k) / f64::from(count);
        [[-2.0, -2.0, z], [2.0, 2.0, z], [2.0, 2.0, z + 1e-7]].map(Vec3::from)
    };
    Mesh {
        positions: (0..count).flat_map(corners).collect(),
        faces: (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
    }
}
