//! What happens where the device cannot.

use std::time::Duration;

use capwalk_geometry::{ConeQuery, EdgeSelection, Ray, RayTree, SilhouetteTree, topology};
use capwalk_gpu::{DeviceRayTree, DeviceSilhouetteTree, Gpu, GpuError, GpuOptions};
use capwalk_math::Vec3;

use super::adapter::{open, with};
use super::meshes::{self, Random};

fn rays(count: usize) -> Vec<Ray> {
    let mut random = Random(5);
    let ray = |_| Ray::new(random.point() * 2.0, random.direction());
    (0..count).map(ray).collect()
}

/// An adapter that is not there.
#[test]
fn unknown_adapter() {
    let error = Gpu::new(&with(|options| {
        options.adapter = Some("no such thing".into())
    }));
    let error = error.expect_err("there is none");
    assert!(matches!(error, GpuError::NoAdapter { .. }), "{error}");
    assert!(error.to_string().contains("mesa-vulkan-drivers"), "{error}");
}

/// A device that was lost answers nothing any more, and says so; it does not panic.
#[test]
fn lost_device() {
    let Some((gpu, _turn)) = open(&GpuOptions::default()) else {
        return;
    };
    let mesh = meshes::grid(12, 10, true, &mut Random(4));
    let tree = RayTree::build(&mesh);
    let mut device = DeviceRayTree::new(&gpu, &tree).expect("enough memory");
    assert_eq!(device.first_hits(&rays(100)).expect("answers").len(), 100);
    gpu.destroy();
    let lost = |error: GpuError| {
        assert!(matches!(error, GpuError::DeviceLost { .. }), "{error}");
    };
    lost(device.first_hits(&rays(100)).expect_err("it is lost"));
    lost(device.occluded(&[]).expect_err("it is lost"));
    lost(device.refit(&mesh).expect_err("it is lost"));
    lost(DeviceRayTree::new(&gpu, &tree).expect_err("it is lost"));
    let edges = topology::edges(&mesh);
    let tree = SilhouetteTree::build(&mesh, &edges);
    lost(DeviceSilhouetteTree::new(&gpu, &tree).expect_err("it is lost"));
}

/// Batches larger than a buffer are cut, with the same answers; trees cannot be.
#[test]
fn small_buffers() {
    let mesh = meshes::grid(12, 10, true, &mut Random(4));
    let tree = RayTree::build(&mesh);
    let many = rays(3001);
    let hits = |options: &GpuOptions| {
        let (gpu, _turn) = open(options)?;
        let device = DeviceRayTree::new(&gpu, &tree).expect("enough memory");
        Some(device.first_hits(&many).expect("answers"))
    };
    let Some(whole) = hits(&GpuOptions::default()) else {
        return;
    };
    assert_eq!(
        hits(&with(|options| options.largest_buffer = Some(20_000))),
        Some(whole)
    );
    let Some((gpu, _turn)) = open(&with(|options| options.largest_buffer = Some(1000))) else {
        return;
    };
    let error = DeviceRayTree::new(&gpu, &tree).expect_err("too large");
    assert!(
        matches!(error, GpuError::TreeTooLarge { limit: 1000, .. }),
        "{error}"
    );
}

/// Where memory is scarce, batches are cut with the same answers; less than a group of queries needs is an
/// error, and so is a tree that does not fit.
#[test]
fn scarce_memory() {
    let Some((gpu, _turn)) = open(&GpuOptions::default()) else {
        return;
    };
    let mesh = meshes::grid(12, 10, true, &mut Random(4));
    let tree = RayTree::build(&mesh);
    let device = DeviceRayTree::new(&gpu, &tree).expect("enough memory");
    let many = rays(3001);
    let hits = || device.first_hits(&many);
    let whole = hits().expect("enough memory");
    gpu.pretend_memory(20_000);
    assert_eq!(hits().expect("parts fit"), whole);
    gpu.pretend_memory(100);
    let out_of_memory = |error| matches!(error, GpuError::OutOfMemory { .. });
    assert!(out_of_memory(hits().expect_err("not even a group fits")));
    assert!(out_of_memory(
        DeviceRayTree::new(&gpu, &tree).expect_err("it does not fit")
    ));
    gpu.pretend_memory(u64::MAX);
    assert_eq!(hits().expect("enough memory again"), whole);
}

/// A launch that takes too long is an error, not a hang.
#[test]
fn timeout() {
    let Some((gpu, _turn)) = open(&with(|options| options.timeout = Duration::ZERO)) else {
        return;
    };
    if !gpu.is_software() {
        return; // It may be done already.
    }
    let mesh = meshes::grid(60, 50, true, &mut Random(4));
    let tree = RayTree::build(&mesh);
    let mut device = DeviceRayTree::new(&gpu, &tree).expect("enough memory");
    let errors = [
        device.first_hits(&rays(4096)).expect_err("no time"),
        device.refit(&mesh).expect_err("no time"),
    ];
    for error in errors {
        assert!(matches!(error, GpuError::Timeout { .. }), "{error}");
    }
}

/// Rays that are no rays hit nothing.
#[test]
fn degenerate_rays() {
    let Some((gpu, _turn)) = open(&GpuOptions::default()) else {
        return;
    };
    let mesh = meshes::grid(12, 10, true, &mut Random(4));
    let device = DeviceRayTree::new(&gpu, &RayTree::build(&mesh)).expect("enough memory");
    let directions = [0.0, f64::NAN, f64::INFINITY, 1e-320].map(|z| Vec3::new(0.0, 0.0, z));
    let bad = directions.map(|direction| Ray::new(Vec3::new(0.6, 0.0, -9.0), direction));
    assert_eq!(device.first_hits(&bad).expect("answers"), [None; 4]);
    assert_eq!(device.occluded(&bad).expect("answers"), [false; 4]);
}

/// Software that ends loops early, without a word, is found out: cones that gather everything, and
/// rays that pass the boxes of very many slivers.
#[test]
fn loops_that_are_cut_short() {
    let Some((gpu, _turn)) = open(&GpuOptions::default()) else {
        return;
    };
    if !gpu.is_software() {
        return;
    }
    for (count, is_cut) in [(1_000, false), (200_000, true)] {
        let mesh = meshes::slivers(count);
        let ray = Ray::new(Vec3::new(1.0, -1.0, -9.0), Vec3::new(0.0, 0.0, 1.0));
        let rays = DeviceRayTree::new(&gpu, &RayTree::build(&mesh)).expect("enough memory");
        let tree = SilhouetteTree::build(&mesh, &topology::edges(&mesh));
        let cones = DeviceSilhouetteTree::new(&gpu, &tree).expect("enough memory");
        let everything = ConeQuery {
            apex: Vec3::new(0.0, 0.0, -9.0),
            axis: Vec3::new(0.0, 0.0, 1.0),
            max_angle: 3.0,
            edges: EdgeSelection::All,
            groups: u8::MAX,
            in_front_of: None,
        };
        let errors = [
            rays.first_hits(&[ray]).err(),
            rays.occluded(&[ray]).err(),
            cones.gather(&[everything], 10).err(),
        ];
        for error in errors {
            let noticed = matches!(error, Some(GpuError::CutShort { .. }));
            assert_eq!(noticed, is_cut, "{count}: {error:?}");
        }
    }
}
