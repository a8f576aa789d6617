//! Sample by sample beside the processor, with the same random numbers.

use capwalk_gpu::Precision;
use capwalk_gpu_render::DeviceScene;
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, render};
use capwalk_scene::{Scene, builtin};

use crate::device;

fn file(name: &str) -> Scene {
    let path = format!("{}/../../tests/{name}", env!("CARGO_MANIFEST_DIR"));
    let loaded = capwalk_scene_io::load_scene(path.as_ref(), &[]).expect("a scene");
    loaded.scene
}

/// The share of samples of the two images that differ, and by how much their sums do, relatively.
fn compare(scene: Scene, precision: Precision, spp: u32) -> Option<[f64; 2]> {
    let (gpu, _turn) = device::open(precision)?;
    let prepared = PreparedScene::new(scene);
    let options = RenderOptions::new(spp, 7);
    let start = std::time::Instant::now();
    let ours = DeviceScene::new(gpu, &prepared)
        .expect("supported")
        .render(&options, &Unwatched)
        .expect("rendered");
    let took = start.elapsed();
    let theirs = render(&prepared, &options, &Unwatched);
    let pairs = || ours.value.mean.pixels.iter().zip(&theirs.value.mean.pixels);
    let differs = pairs().filter(|(a, b)| (**a - **b).map(f64::abs).max_component() > 2e-4 * b.max_component().max(1e-3));
    let share = differs.count() as f64 / ours.value.mean.pixels.len() as f64;
    let sums = pairs().fold([0.0; 2], |[a, b], (x, y)| [a + x.mean(), b + y.mean()]);
    println!("{share} {sums:?} {took:?}");
    Some([share, sums[0] / sums[1] - 1.0])
}

#[test]
fn colour_bleeding() {
    for precision in [Precision::Double, Precision::Single] {
        compare(file("parity/colour_bleeding.xml"), precision, 1);
    }
    for name in builtin::names() {
        println!("{name}");
        let scene = builtin::scene(name).expect("built in");
        if name != "x" {
            compare(scene, Precision::Double, 1);
        }
    }
}
