//! Time limits and Ctrl-C: what is done is written, with its real counts. Nothing here
//! depends on how fast the machine is: the work would take hours, and Ctrl-C comes when
//! the command has said that it begins.

use crate::{Capwalk, assert_has};

/// Hours of work.
const LONG: &str = "--size 64x48 --spp 100000000";

#[test]
fn a_time_limit_keeps_what_is_done() {
    let capwalk = Capwalk::new("time_limit");
    let finished = capwalk.run(&format!("render leaf {LONG} --time-limit 0.001s --json"));
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stderr, &["partial", "samples per pixel"]);
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    let statistics = &json["statistics"];
    assert_eq!(statistics["complete"], false);
    let samples = statistics["samples"].as_u64().expect("a count");
    assert!(samples < 64 * 48 * 100_000_000);
    capwalk.bytes("leaf.exr");
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_cleanly() {
    let capwalk = Capwalk::new("ctrl_c");
    let command = format!("gradient leaf -p leaf.translate.x {LONG} --json -o partial.npz -v");
    let finished = capwalk.interrupt(&command, "3 shapes", || {});
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
