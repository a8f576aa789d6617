//! `cargo xtask kernels`: compiles the kernels of `capwalk-gpu` and `capwalk-gpu-render`, whose
//! results are checked in. Tests of the crates fail where they are not those of the source.

use std::fs::File;
use std::process::Command;

use anyhow::{Context, Result};

use crate::shell::{cargo, root, start, target};
use crate::virtual_environment::environment;

/// The packages that have the compilers in them: Slang's, and NVIDIA's of PTX, in a release that
/// drivers since 2023 understand. The results depend on them.
const COMPILERS: [&str; 2] = ["slangpy==0.43.1", "nvidia-cuda-nvrtc-cu12==12.1.105"];

/// Compiles all of them, by `kernels.py`.
pub fn run() -> Result<()> {
    let python = environment(
        &target().join("kernels"),
        "slangpy, nvidia.cuda_nvrtc",
        &COMPILERS,
    )?;
    // The crates include their packs, so there must be files even where no pack was written yet.
    let folders = ["crates/gpu/src/kernels", "crates/gpu-render/src/kernels"];
    for folder in folders {
        let pack = root().join(folder).join("compiled.lzma");
        File::options()
            .append(true)
            .create(true)
            .open(&pack)
            .with_context(|| format!("{}: cannot be written", pack.display()))?;
    }
    // The constants that the kernels share with Rust.
    let made = target().join("kernels/made");
    let mut layout = cargo(&["run", "--quiet", "--package", "capwalk-gpu-render"]);
    layout.args(["--example", "layout", "--"]).arg(&made);
    start("layout", layout)?;
    for folder in folders {
        let mut compile = Command::new(&python);
        compile.args(["xtask/kernels.py", folder]).arg(&made);
        compile.current_dir(root());
        start("kernels", compile)?;
    }
    Ok(())
}
