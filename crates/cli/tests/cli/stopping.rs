//! Time limits, Ctrl-C and SIGTERM: what is done is written, with its real counts. The work would take
//! hours; within three seconds there are some samples on any machine.

use std::time::{Duration, Instant};

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

/// Ctrl-C, and the signal by which clusters stop jobs.
#[cfg(unix)]
#[test]
fn signals_stop_cleanly() {
    for signal in ["-INT", "-TERM"] {
        let capwalk = Capwalk::new(&format!("signal{signal}"));
        let command = format!(
            "gradient leaf -p leaf.translate.x --method edges {LONG} --json -o partial.npz -v"
        );
        // Until there are samples.
        let wait = || std::thread::sleep(Duration::from_secs(3));
        let finished = capwalk.interrupt(signal, &command, "3 shapes", wait);
        assert_eq!(finished.status, 5, "{signal}: {}", finished.stderr);
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
}

/// A scene of spheres, 60,500 triangles each: seconds to read, and more to prepare.
fn spheres(count: usize) -> String {
    let sphere = |i: usize| {
        let x = 3 * i;
        format!(
            "<shape type=\"sphere\" id=\"s{i}\"><point name=\"center\" x=\"{x}\" y=\"0\" z=\"0\"/></shape>"
        )
    };
    let spheres: String = (0..count).map(sphere).collect();
    format!(
        "<scene version=\"3.0.0\"><integrator type=\"path\"/><emitter type=\"constant\"/>\
         <sensor type=\"perspective\"><film type=\"hdrfilm\"/></sensor>{spheres}</scene>"
    )
}

/// How long a process may take to end that has nothing to write: less than a second on a machine
/// that is not busy.
const SOON: Duration = Duration::from_secs(5);

/// The time counts from the start: it ends the reading of a scene that takes half a minute.
#[test]
fn a_time_limit_ends_the_preparation() {
    let capwalk = Capwalk::new("limit_while_reading");
    capwalk.write("scene.xml", &spheres(68));
    let started = Instant::now();
    let finished = capwalk.run("gradient scene.xml -p s0.translate.x --time-limit 0.5s");
    assert_eq!(finished.status, 3, "{}", finished.stderr);
    assert_has(&finished.stderr, &["time limit", "nothing was written"]);
    assert!(started.elapsed() < SOON, "{:?}", started.elapsed());
}

/// What comes before the first sample of a check is taken from both of its halves: with most of the
/// time for the preparation, the gradient still has samples. And nothing is compared with nothing.
#[test]
fn a_check_shares_what_preparation_leaves() {
    let capwalk = Capwalk::new("limit_of_check");
    capwalk.write("scene.xml", &spheres(8));
    let motion = "scene.xml -p s0.translate.x --size 8x6 --method walk";
    let started = Instant::now();
    assert_eq!(capwalk.run(&format!("gradient {motion} --spp 1")).status, 0);
    let prepared = started.elapsed().as_secs_f64();
    let check = format!("check {motion} --spp 100000000 --json -o check.npz --time-limit");
    // The longest is for a machine that became busy.
    let finished = [1.7, 4.0, 8.0].iter().find_map(|times| {
        let finished = capwalk.run(&format!("{check} {}s", times * prepared));
        let is_written = capwalk.path("check.npz").exists();
        assert_eq!(finished.status == 3, !is_written, "{}", finished.stderr);
        is_written.then_some((times, finished))
    });
    let (times, finished) = finished.expect("in so much time there is a sample");
    let json: serde_json::Value = serde_json::from_str(&finished.stdout).expect("JSON");
    for side in ["gradient", "reference"] {
        let samples = json[side]["samples"].as_u64().expect("a count");
        assert!(samples > 0, "{side}, {times} times the preparation");
    }
}

/// Ctrl-C while the boundaries of a scene are listed, which takes ten seconds.
#[cfg(unix)]
#[test]
fn ctrl_c_ends_the_preparation() {
    let capwalk = Capwalk::new("ctrl_c_while_preparing");
    capwalk.write("scene.xml", &spheres(8));
    let mut pressed = None;
    let command = "gradient scene.xml -p s0.translate.x -v";
    let finished = capwalk.interrupt("-INT", command, "8 shapes", || {
        std::thread::sleep(Duration::from_millis(300));
        pressed = Some(Instant::now());
    });
    assert_eq!(finished.status, 5, "{}", finished.stderr);
    assert_has(&finished.stderr, &["stopped before", "nothing was written"]);
    let taken = pressed.expect("it was pressed").elapsed();
    assert!(taken < SOON, "{taken:?}");
}
