//! Sample by sample beside the processor, with the same random numbers.

use capwalk_gpu::Precision;
use capwalk_gpu_render::{DeviceScene, unsupported};
use capwalk_render::{PreparedScene, RenderOptions, Unwatched, render};
use capwalk_scene::{Scene, builtin};

use crate::device;

fn compare(scene: Scene, precision: Precision, spp: u32) -> Option<[f64; 2]> {
    let (gpu, _turn) = device::open(precision)?;
    let prepared = PreparedScene::new(scene);
    if let Some(x) = unsupported(&prepared) { println!("    {x}"); return None; }
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
    println!("    {share:.6} {sums:?} {took:?}");
    Some([share, sums[0] / sums[1] - 1.0])
}

#[test]
fn survey() {
    for name in builtin::names() {
        println!("{name}");
        let scene = builtin::scene(name).expect("built in");
        compare(scene, Precision::Double, 1);
    }
    let root = format!("{}/../../tests", env!("CARGO_MANIFEST_DIR"));
    let mut files: Vec<_> = std::fs::read_dir(format!("{root}/parity")).unwrap().map(|f| f.unwrap().path()).filter(|p| p.extension().is_some_and(|e| e == "xml")).collect();
    files.extend(std::fs::read_dir(format!("{root}/scenes")).unwrap().map(|f| f.unwrap().path().join("scene.xml")).filter(|p| p.exists()));
    files.sort();
    for f in files {
        println!("{}", f.display());
        match capwalk_scene_io::load_scene(&f, &[]) { Ok(l) => { compare(l.scene, Precision::Double, 1); } Err(e) => println!("{e}") }
    }
}
