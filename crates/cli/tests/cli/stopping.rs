//! Time limits and Ctrl-C: what is done is written, with its real counts.

use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::{Capwalk, Finished, assert_has};

/// Hours of work.
const LONG: &str = "--size 64x48 --spp 100000000";

#[test]
fn a_time_limit_keeps_what_is_done() {
    let capwalk = Capwalk::new("time_limit");
    let started = Instant::now();
    let finished = capwalk.run(&format!("render leaf {LONG} --time-limit 0.5s --json"));
    assert!(started.elapsed() < Duration::from_secs(30));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stderr, &["partial", "samples per pixel"]);
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    let statistics = &json["statistics"];
    assert_eq!(statistics["complete"], false);
    let samples = statistics["samples"].as_u64().expect("a count");
    assert!(samples > 0 && samples < 64 * 48 * 100_000_000);
    capwalk.bytes("leaf.exr");
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_cleanly() {
    let capwalk = Capwalk::new("ctrl_c");
    let mut command = capwalk.command(&format!(
        "gradient leaf -p leaf.translate.x {LONG} --json -o partial.npz"
    ));
    let child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let child = child.expect("it starts");
    std::thread::sleep(Duration::from_millis(1500));
    let interrupt = std::process::Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(interrupt.expect("kill exists").success());
    let finished = Finished::from(child.wait_with_output().expect("it ends"));
    assert_eq!(finished.status, 5, "{}", finished.stderr);
    assert_has(&finished.stderr, &["stopping", "partial"]);
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    assert_eq!(json["statistics"]["complete"], false);
    assert!(json["statistics"]["samples"].as_u64().expect("a count") > 0);
    let picture = capwalk_scene_io::image::read(&capwalk.path("partial.npz")).expect("readable");
    let complete = picture.metadata.iter().find(|(key, _)| key == "complete");
    assert_eq!(complete.expect("it is said").1, "false");
    let samples: u64 = picture
        .samples
        .expect("counts")
        .iter()
        .map(|&n| u64::from(n))
        .sum();
    assert_eq!(json["statistics"]["samples"], samples);
}

/// The gradient takes milliseconds of its two seconds, the reference would take
/// hours: the file is partial, and says which part of it.
#[test]
fn a_check_whose_reference_is_cut_short_says_so() {
    let capwalk = Capwalk::new("check_time_limit");
    let finished = capwalk.run(
        "check leaf -p leaf.translate.x --size 12x9 --spp 4 --reference-spp 100000000 \
         --time-limit 4s --json -o c.npz,c.exr,c.png",
    );
    assert_has(&finished.stderr, &["the reference is partial"]);
    assert!(!finished.stderr.contains("the gradient is partial"));
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    let (all, of_the_gradient) = (12 * 9 * 100_000_000, 12 * 9 * 4);
    let reference = &json["reference"]["samples"];
    let taken = reference.as_u64().expect("a count");
    assert!(0 < taken && taken < all, "{taken}");
    for file in ["c.npz", "c.exr"] {
        let picture = capwalk_scene_io::image::read(&capwalk.path(file)).expect("readable");
        let of = |key: &str| {
            let found = picture.metadata.iter().find(|(k, _)| k == key);
            found.expect(key).1.clone()
        };
        assert_eq!(of("complete"), "false", "{file}");
        assert_eq!(of("gradient_complete"), "true", "{file}");
        assert_eq!(of("reference_complete"), "false", "{file}");
        assert_eq!(of("gradient_samples"), of_the_gradient.to_string());
        assert_eq!(of("reference_samples"), reference.to_string());
        assert_eq!(of("samples"), (taken + of_the_gradient).to_string());
        assert_eq!(of("non_finite_samples"), "0", "{file}");
        let counts = picture.samples.expect("counts");
        let sum: u64 = counts.iter().map(|&n| u64::from(n)).sum();
        assert_eq!(sum, taken + of_the_gradient, "{file}");
    }
}
