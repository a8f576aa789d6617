//! Time limits and Ctrl-C: what is done is written, with its real counts. The work would take
//! hours; within three seconds there are some samples on any machine.

use std::time::Duration;

use crate::{Capwalk, assert_has};

/// Hours of work.
const LONG: &str = "--size 64x48 --spp 100000000";

#[test]
fn a_time_limit_keeps_what_is_done() {
    let capwalk = Capwalk::new("time_limit");
    let finished = capwalk.run(&format!("render leaf {LONG} --time-limit 3s --json"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stderr, &["partial", "samples per pixel"]);
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    let statistics = &json["statistics"];
    assert_eq!(statistics["complete"], false);
    let samples = statistics["samples"].as_u64().expect("a count");
    assert!(samples > 0 && samples < 64 * 48 * 100_000_000);
    capwalk.bytes("leaf.exr");
}

#[test]
fn what_has_no_samples_is_not_written() {
    let capwalk = Capwalk::new("no_samples");
    for command in ["render leaf", "gradient leaf -p leaf.translate.x"] {
        let finished = capwalk.run(&format!("{command} {LONG} --time-limit 0.000001s"));
        assert_eq!(finished.status, 3, "{command}");
        assert_has(&finished.stderr, &["time limit", "nothing was written"]);
    }
    for file in ["leaf.exr", "leaf.png", "leaf-gradient.exr"] {
        assert!(!capwalk.path(file).exists(), "{file}");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_cleanly() {
    let capwalk = Capwalk::new("ctrl_c");
    let command =
        format!("gradient leaf -p leaf.translate.x --method edges {LONG} --json -o partial.npz -v");
    // Until there are samples.
    let wait = || std::thread::sleep(Duration::from_secs(3));
    let finished = capwalk.interrupt(&command, "3 shapes", wait);
    assert_eq!(finished.status, 5, "{}", finished.stderr);
    assert_has(&finished.stderr, &["stopping", "partial"]);
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    assert_eq!(json["statistics"]["complete"], false);
    let image = capwalk_scene_io::image::read(&capwalk.path("partial.npz")).expect("readable");
    let complete = image.metadata.iter().find(|(key, _)| key == "complete");
    assert_eq!(complete.expect("it is said").1, "false");
    let samples: u64 = image
        .samples
        .expect("counts")
        .iter()
        .map(|&n| u64::from(n))
        .sum();
    assert_eq!(json["statistics"]["samples"], samples);
}
