//! The `[method]` of a job.

use std::collections::HashMap;

use super::SMALL;
use crate::{Capwalk, assert_has};

/// Methods that are there with the feature `paper`.
const OF_THE_PAPER: [&str; 7] = [
    "domain = \"triangle\"",
    "domain = \"explicit\"",
    "domain = \"explicit\"\nsteps = 2\nestimator = \"literal\"",
    "type = \"was\"",
    "type = \"was\"\nboundary = \"normals\"",
    "type = \"psdr-was\"",
    "type = \"psdr-was\"\nrays = 4\nantithetic = false",
];

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
    let mut methods = vec![
        "type = \"walk\"",
        "max_angle = 2\nantithetic = true",
        "type = \"edges\"",
    ];
    if cfg!(feature = "paper") {
        methods.extend(OF_THE_PAPER);
    }
    let mut records = HashMap::new();
    for method in methods {
        let (record, stderr) = run(&format!("[method]\n{method}"));
        let is_baseline = method.contains("was");
        assert_eq!(
            stderr.matches("is a baseline and biased").count(),
            usize::from(is_baseline),
            "{stderr}"
        );
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
        ("[method]\ntype = \"walk\"\ndomain = \"sphere\"", walk),
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
        "domain = \"cube\"",
        &["job.toml:31:10", "one of \"sphere\""],
    );
    bad(
        "type = \"edges\"\ndomain = \"sphere\"",
        &[
            "job.toml:32:1",
            "unknown key `domain` in [method] of type \"edges\"",
            "one of: allow_missing, antithetic, estimator, max_angle, steps, type",
        ],
    );
    bad(
        "kappa = 10",
        &["unknown key `kappa` in [method] of type \"auto\""],
    );
    bad(
        "steps = 2\nkappa = 10",
        &[
            "unknown key `kappa` in [method] of type \"walk\"",
            "one of: allow_missing, antithetic, domain, estimator, max_angle, steps, type",
        ],
    );
}

#[cfg(feature = "paper")]
#[test]
fn baselines_have_keys_of_their_own() {
    let capwalk = Capwalk::new("optimize_baseline_keys");
    let bad = |method: &str, parts: &[&str]| assert_bad(&capwalk, method, parts);
    bad("type = \"wall\"", &["\"was\", \"psdr-was\"\n"]);
    bad("domain = \"cube\"", &["\"triangle\", \"explicit\""]);
    bad(
        "type = \"psdr-was\"\nsteps = 2",
        &[
            "unknown key `steps` in [method] of type \"psdr-was\"",
            "one of: allow_missing, antithetic, boundary, debias, kappa, rays, type",
        ],
    );
    bad("type = \"psdr-was\"\nrays = 0", &["from 1 to 65536"]);
}
