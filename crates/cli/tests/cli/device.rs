//! `--device` of `render`, `gradient` and `backward` with the feature `gpu`.

use crate::{Capwalk, assert_has};

/// On software Vulkan, if that is all there is; skipped where there is nothing.
#[test]
fn images_come_from_the_device_that_is_asked_for() {
    let capwalk = Capwalk::new("device");
    let render = "render leaf --spp 4 --size 16x12 --json";
    let cpu = capwalk.json(&format!("{render} -o cpu.exr"));
    assert_eq!(cpu["device"], "cpu");
    let gpu = capwalk.run(&format!("{render} --device gpu -o gpu.exr"));
    if gpu.status != 0 && gpu.stderr.contains("no GPU") {
        let is_required = std::env::var("CAPWALK_GPU_TESTS").is_ok_and(|value| value == "require");
        assert!(!is_required, "{}", gpu.stderr);
        return;
    }
    let gpu: serde_json::Value = serde_json::from_str(&gpu.stdout).expect("JSON");
    assert_ne!(gpu["device"], "cpu");
    assert_eq!(gpu["statistics"]["samples"], cpu["statistics"]["samples"]);
    for channel in 0..3 {
        let [a, b] = [&gpu, &cpu].map(|json| json["mean"][channel].as_f64().expect("a number"));
        assert!((a - b).abs() < 1e-4 * b, "{a} {b}");
    }
    // What has no record is named, and nothing is written.
    let scene = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/parity/dielectric.xml"
    );
    let message = capwalk.error(&format!("render {scene} --spp 1 --device gpu -o glass.exr"));
    assert_has(
        &message,
        &["shape \"block\" is of the type dielectric", "--device cpu"],
    );
    assert!(!capwalk.folder.join("glass.exr").exists());
}

/// Derivatives with respect to colours, to what emitters send, and to what moves.
#[test]
fn derivatives_come_from_the_device_that_is_asked_for() {
    let capwalk = Capwalk::new("device_derivatives");
    let gradient = "gradient leaf --spp 4 --size 16x12 --json -p";
    let colour = "floor.bsdf.reflectance.value";
    let cpu = capwalk.json(&format!("{gradient} 1*{colour} -o cpu.exr"));
    assert_eq!(cpu["device"], "cpu");
    let gpu = capwalk.run(&format!("{gradient} 1*{colour} --device gpu -o gpu.exr"));
    if gpu.status != 0 && gpu.stderr.contains("no GPU") {
        let is_required = std::env::var("CAPWALK_GPU_TESTS").is_ok_and(|value| value == "require");
        assert!(!is_required, "{}", gpu.stderr);
        return;
    }
    let gpu: serde_json::Value = serde_json::from_str(&gpu.stdout).expect("JSON");
    assert_ne!(gpu["device"], "cpu");
    for what in ["mean", "mean_gradient"] {
        for channel in 0..3 {
            let [a, b] = [&gpu, &cpu].map(|json| json[what][channel].as_f64().expect("a number"));
            assert!((a - b).abs() <= 1e-4 * b.abs(), "{what}: {a} {b}");
        }
    }
    // Where nothing moves, all methods are one.
    assert_eq!(gpu["method"], "walk");
    let backward = "backward leaf --spp 4 --size 16x12 --json --loss l2 --target cpu.exr";
    let [cpu, gpu] = ["cpu", "gpu"].map(|device| {
        capwalk.json(&format!(
            "{backward} -p {colour} lamp.emitter.radiance.value --device {device} -o {device}.npz"
        ))
    });
    assert_eq!(gpu["statistics"]["samples"], cpu["statistics"]["samples"]);
    for parameter in 0..2 {
        let [a, b] = [&gpu, &cpu].map(|json| {
            let size = &json["parameters"][parameter]["norm"];
            size.as_f64().expect("a number")
        });
        assert!((a - b).abs() <= 1e-4 * b, "{a} {b}");
    }
    // What moves, by edges.
    let moving = "gradient leaf --spp 64 --size 16x12 --json --method edges -p leaf.translate.x";
    let [cpu, gpu] = ["cpu", "gpu"]
        .map(|device| capwalk.json(&format!("{moving} --device {device} -o moving.exr")));
    // Where all methods are open, a GPU has edges.
    let open = moving
        .replace("--spp 64", "--spp 1")
        .replace("--method edges ", "");
    let open = capwalk.json(&format!("{open} --device gpu -o open.exr"));
    assert_eq!(open["method"], "edges");
    assert_eq!(open["choice"]["trials"], serde_json::json!([]));
    // Variances are those of a pixel, the means those of 192 pixels.
    let variance = [&gpu, &cpu].map(|json| json["variance_per_sample"].as_f64().expect("one"));
    let error = (variance.iter().sum::<f64>() / (64.0 * 192.0)).sqrt();
    for channel in 0..3 {
        let [a, b] = [&gpu, &cpu].map(|json| json["mean_gradient"][channel].as_f64().expect("one"));
        assert!((a - b).abs() < 5.0 * error && a < -0.01, "{a} {b} {error}");
    }
    let vertices = backward.replace("--spp 4", "--spp 64 --method edges -p leaf.positions");
    let [cpu, gpu] = ["cpu", "gpu"]
        .map(|device| capwalk.json(&format!("{vertices} --device {device} -o v.npz")));
    let [a, b] = [&gpu, &cpu].map(|json| {
        let size = &json["parameters"][0]["norm"];
        size.as_f64().expect("a number")
    });
    assert!((a / b - 1.0).abs() < 0.3, "{a} {b}");
    // Of everything, where no name is given.
    let all = backward.replace("--spp 4", "--spp 1 --method edges");
    let all = capwalk.json(&format!("{all} --device gpu -o all.npz"));
    let names = all["parameters"].as_array().expect("a list");
    let has = |name: &str| names.iter().any(|parameter| parameter["name"] == name);
    assert!(has("leaf.positions") && has(colour), "{names:?}");
    let walks = moving.replace("edges", "walk");
    assert_has(
        &capwalk.error(&format!("{walks} --device gpu")),
        &["walk", "not on the GPU", "--device cpu"],
    );
}
