//! `cargo xtask kernels`: compiles the kernels of `capwalk-gpu`, whose results are checked
//! in. A test of the crate fails where they are not those of the source.

use std::process::Command;

use anyhow::Result;

use crate::shell::{root, start, target};
use crate::virtual_environment::environment;

/// The release of the package that has the Slang compiler in it; the results depend on it.
const SLANGPY: &str = "slangpy==0.43.1";

/// Compiles all of them, by `kernels.py`.
pub fn run() -> Result<()> {
    let python = environment(&target().join("kernels"), "slangpy", &[SLANGPY])?;
    let mut compile = Command::new(python);
    compile.args(["xtask/kernels.py", "crates/gpu/src/kernels"]);
    compile.current_dir(root());
    start("kernels", compile)
}
