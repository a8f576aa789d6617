//! Readers who stop reading, and streams that cannot be written.

use std::process::{Command, Stdio};

use crate::{Capwalk, Finished, assert_has};

/// A command, and the status that its work has.
const COMMANDS: [(&str, i32); 10] = [
    ("--help", 0),
    ("info leaf", 0),
    ("info leaf --json", 0),
    ("scenes", 0),
    ("scenes --json", 0),
    ("render leaf --size 12x9 --spp 2", 0),
    ("gradient leaf -p leaf.translate.x --size 12x9 --spp 2", 0),
    ("compare leaf.exr leaf.exr", 0),
    // Could not tell.
    ("demo --size 4x3 --spp 1", 2),
    (
        "check leaf -p leaf.translate.x --size 12x9 --spp 1 --reference-spp 1",
        2,
    ),
];

/// Runs with these standard output and standard error.
fn run(mut command: Command, stdout: Stdio, stderr: Stdio) -> Finished {
    let child = command.stdout(stdout).stderr(stderr).spawn();
    let output = child.expect("it starts").wait_with_output();
    Finished::from(output.expect("it ends"))
}

/// The writing end of a pipe that nobody reads.
fn closed_pipe() -> Stdio {
    let (reader, writer) = std::io::pipe().expect("the system has pipes");
    drop(reader);
    writer.into()
}

/// As under `capwalk ... | head -0`: no word about it, and the status that the
/// work deserves.
#[test]
fn a_closed_pipe_ends_the_output_quietly() {
    let capwalk = Capwalk::new("closed_pipe");
    for (arguments, status) in COMMANDS {
        let finished = run(capwalk.command(arguments), closed_pipe(), Stdio::piped());
        assert_eq!(finished.status, status, "{arguments}: {}", finished.stderr);
        assert_eq!(finished.stderr, "", "{arguments}");
    }
    // What was asked for is there all the same.
    capwalk.bytes("leaf-gradient.exr");
    capwalk.bytes("leaf-check.png");
}

/// As under `capwalk ... 2>&1 | head -0`, with something to be said.
#[test]
fn nobody_has_to_read_the_remarks() {
    let capwalk = Capwalk::new("closed_stderr");
    let partial = "render leaf --size 12x9 --spp 100000000 --time-limit 3s";
    for (arguments, status) in [(partial, 0), ("info nothing", 3), ("frobnicate", 3)] {
        let finished = run(capwalk.command(arguments), closed_pipe(), closed_pipe());
        assert_eq!(finished.status, status, "{arguments}");
    }
}

/// A full disk is not a closed pipe: results that are lost are an error.
#[cfg(target_os = "linux")]
#[test]
fn results_that_cannot_be_written_are_an_error() {
    let capwalk = Capwalk::new("full_disk");
    for (arguments, _) in COMMANDS {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
        let full = full.expect("Linux has /dev/full");
        let finished = run(capwalk.command(arguments), full.into(), Stdio::piped());
        assert_eq!(finished.status, 3, "{arguments}: {}", finished.stderr);
        assert_has(
            &finished.stderr,
            &["error: cannot write to the standard output\n  because "],
        );
    }
}
