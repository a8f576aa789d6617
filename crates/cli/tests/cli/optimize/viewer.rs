//! `--view`: what follows a run, and what is said if nothing can. A script takes the place of Python.

use std::fs;
use std::os::unix::fs::PermissionsExt;

use super::SMALL;
use crate::{Capwalk, Finished, assert_has};

/// Runs the small job with a script as the interpreter.
fn viewed(capwalk: &Capwalk, script: &str) -> Finished {
    capwalk.write(
        "job.toml",
        &SMALL.replace("iterations = 40", "iterations = 3"),
    );
    capwalk.write("python", script);
    let python = capwalk.path("python");
    fs::set_permissions(&python, fs::Permissions::from_mode(0o755)).expect("it is ours");
    let mut command = capwalk.command("optimize job.toml -o run --view");
    command.env("CAPWALK_PYTHON", python);
    Finished::from(command.output().expect("it starts"))
}

/// The folder is locked until all results are there, and the command waits for who waits for that.
#[test]
fn a_run_is_followed_to_its_end() {
    let capwalk = Capwalk::new("optimize_viewed");
    let finished = viewed(
        &capwalk,
        "#!/bin/sh\n\
         test \"$3\" = --help && exit\n\
         echo \"$@\" > arguments\n\
         flock --shared run/.lock true\n\
         sleep 0.2\n\
         ls run > seen\n",
    );
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert!(!finished.stderr.contains("slow"), "{}", finished.stderr);
    assert_eq!(
        capwalk.bytes("arguments"),
        b"-m capwalk.rerun run --follow --begun\n"
    );
    let seen = String::from_utf8(capwalk.bytes("seen")).expect("names");
    assert_has(&seen, &["parameters.npz"]);
}

/// Without the package nothing is rendered; a viewer that fails later costs nothing of the run.
#[test]
fn a_viewer_that_is_missing_or_fails() {
    let capwalk = Capwalk::new("optimize_not_viewed");
    let finished = viewed(
        &capwalk,
        "#!/bin/sh\necho No module named rerun >&2\nexit 1\n",
    );
    assert_eq!(finished.status, 3);
    assert_has(&finished.stderr, &["No module named rerun"]);
    assert_has(&finished.stderr, &["pip install 'capwalk[rerun]'"]);
    assert!(!capwalk.path("run").exists());

    let finished = viewed(&capwalk, "#!/bin/sh\ntest \"$3\" = --help\n");
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(&finished.stderr, &["the run was not shown"]);
    assert!(capwalk.path("run/parameters.npz").exists());
}
