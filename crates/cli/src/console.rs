//! The two streams of text: results on the standard output, remarks about them
//! on the standard error. Nothing else prints (`println!` panics on a closed
//! pipe).

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "this is the place for it"
)]

use std::io::{self, ErrorKind, Write};

use anyhow::{Context, Result};
use serde_json::Value;

/// Writes results to the standard output, all of them or with an error. A
/// reader who has seen enough (`| head`) is none: how the command ends is about
/// its work.
pub fn print(text: &str) -> Result<()> {
    delivered(write_all(io::stdout().lock(), text))
}

/// Writes one JSON document to the standard output, see [`print()`].
pub fn print_json(document: &Value) -> Result<()> {
    print(&format!("{document:#}\n"))
}

/// Writes to the standard error. If that fails there is nobody left to tell.
pub fn remark(text: &str) {
    let _ = write_all(io::stderr().lock(), text);
}

/// What became of a result, see [`print()`].
pub fn delivered(written: io::Result<()>) -> Result<()> {
    match written {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        other => other.context("cannot write to the standard output"),
    }
}

/// Everything up to the last byte, so that an error is seen now and not lost
/// at the end of the process.
fn write_all(mut to: impl Write, text: &str) -> io::Result<()> {
    to.write_all(text.as_bytes())?;
    to.flush()
}
