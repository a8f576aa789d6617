//! `cargo xtask gpu`: the queries on the adapter that is found, as a table.

use anyhow::Result;

use crate::shell::{cargo, start};
use crate::vulkan;

/// Measures the queries and compares them with the processor's; further arguments choose
/// the adapter.
pub fn run(rest: &[String]) -> Result<()> {
    let table = ["--package", "capwalk-gpu", "--example", "gpu_table"];
    let mut build = cargo(&["build", "--release"]);
    build.args(table);
    start("build", build)?;
    let mut command = cargo(&["run", "--release", "--quiet"]);
    command
        .args(table)
        .envs(vulkan::quiet())
        .arg("--")
        .args(rest);
    start("queries", command)
}
