//! The `[method]` of a job.

use std::collections::HashMap;

use super::SMALL;
use crate::{Capwalk, assert_has};

/// Each takes steps of its own, and says of itself what it says elsewhere.
#[test]
fn every_method_runs() {
    let capwalk = Capwalk::new("optimize_methods");
    let job = SMALL.replace("iterations = 40", "iterations = 3");
    let run = |method: &str| {
        capwalk.write("job.toml", &format!("{job}\n{method}"));
        let _ = std::fs::remove_dir_all(capwalk.path("out"));
        let finished = capwalk.run("optimize job.toml");
        assert_eq!(finished.status, 0, "{method}: {}", finished.stderr);
        (capwalk.bytes("out/record.csv"), finished.stderr)
    };
    let methods = [
        "type = \"walk\"",
        "max_angle = 2\nantithetic = true",
        "steps = 2\nestimator = \"literal\"",
        "type = \"edges\"",
    ];
    let mut records = HashMap::new();
    for method in methods {
        let (record, stderr) = run(&format!("[method]\n{method}"));
        assert_eq!(
            stderr.matches("infinite variance").count(),
            usize::from(method.contains("literal")),
            "{stderr}"
        );
        if let Some(other) = records.insert(record, method) {
            panic!("{method} is the same as {other}");
        }
    }
    let walk = "type = \"walk\"";
    let same = [
        // What is chosen in this scene, where the camera sees no edges.
        ("", "type = \"edges\""),
        ("[method]\ntype = \"auto\"", "type = \"edges\""),
        ("[method]\nsteps = 1", walk),
        // Direct light through no mirror: it walks nowhere.
        (
            "[method]\ntype = \"edges\"\nmax_angle = 5",
            "type = \"edges\"",
        ),
    ];
    for (method, other) in same {
        assert_eq!(records.get(&run(method).0), Some(&other), "{method}");
    }
}

/// Asserts that a job with this `[method]` is an error with these parts.
#[track_caller]
fn assert_bad(capwalk: &Capwalk, method: &str, parts: &[&str]) {
    let job = format!("{SMALL}\n[method]\n{method}");
    capwalk.write("job.toml", &job);
    assert_has(&capwalk.error("optimize job.toml"), parts);
}

#[test]
fn keys_of_other_methods_are_errors() {
    let capwalk = Capwalk::new("optimize_method_keys");
    let bad = |method: &str, parts: &[&str]| assert_bad(&capwalk, method, parts);
    let methods = "one of \"auto\", \"walk\", \"edges\"";
    bad(
        "type = \"wall\"",
        &["job.toml:31:8", "`type` is \"wall\"", methods],
    );
    bad(
        "type = \"fd\"",
        &["job.toml:31:8", "`type` is \"fd\"", methods],
    );
    bad(
        "type = \"edges\"\ncutoff = 10",
        &[
            "job.toml:32:1",
            "unknown key `cutoff` in [method] of type \"edges\"",
            "one of: antithetic, estimator, max_angle, steps, type",
        ],
    );
    bad(
        "type = \"auto\"\nsteps = 2",
        &["unknown key `steps` in [method] of type \"auto\""],
    );
    bad(
        "cutoff = 10",
        &["unknown key `cutoff` in [method] of type \"auto\""],
    );
    bad(
        "steps = 2\ncutoff = 10",
        &[
            "unknown key `cutoff` in [method] of type \"walk\"",
            "one of: antithetic, estimator, max_angle, steps, type",
        ],
    );
}
