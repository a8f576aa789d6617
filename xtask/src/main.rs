//! The tasks of the project, run as `cargo xtask <task>`: tests, checks of layout and packages,
//! benchmarks, comparisons with Mitsuba, soak tests, and the compilation of GPU kernels. It uses no
//! other crate of the workspace, only cargo and Python.
//!
//! | task | does |
//! |---|---|
//! | `test` | everything a change must pass: layout, format, lints, packages, documentation, all tests, Python's too; with `--quick` a part in three minutes, with `--thorough` what takes longer |
//! | `layout` | finds files that import each other in a circle, and names with two meanings |
//! | `package` | builds every crate from its package alone |
//! | `bench` | the benchmarks |
//! | `soak` | damaged files, commands that ask for too much memory, random and very wide scenes, for a minute each |
//! | `references` | finite differences that tests compare gradients with, made by long runs and kept |
//! | `verdicts` | the verdicts of `check` on many right gradients, and on some that are made wrong |
//! | `parity` | renders `tests/parity/*.xml` with Mitsuba too and compares, or makes golden images of them |
//! | `kernels` | compiles the kernels of the GPU; the result is checked in |
//! | `gpu` | queries, images and gradients on the GPU: how many per second, and whether they agree with the CPU |
//! | `peers` | measures capwalk and Mitsuba side by side: noise after a second of one thread |

mod deviation;
mod gpu;
#[cfg(test)]
mod heads;
mod kernels;
mod layout;
mod mitsuba;
mod package;
mod parity;
mod peers;
mod python;
mod references;
mod shell;
mod soak;
mod test;
mod tier;
mod verdicts;
mod virtual_environment;
mod vulkan;

use std::process::ExitCode;

use anyhow::Result;

use shell::{EVERYTHING, cargo, step};

const HELP: &str = "\
usage: cargo xtask <task>

tasks:
  test     layout, format, lints, packages, documentation, and all tests;
           Python's need python3 and PyPI, and are left out where these are not
           there; with --quick, in three minutes, only layout, format, lints, unit
           tests and a few phenomena; with --thorough also the stored outputs of
           tutorials and ten minutes of each test of `soak`
  layout   files that import each other in a circle, and names that mean two
           things (further arguments: crates, as `geometry`)
  package  pack every crate that may be published, and build it from its package
  bench    the benchmarks (further arguments go to them)
  soak     read damaged files, run commands that ask for too much, then render and
           differentiate random scenes and wide ones, for a minute each (further
           arguments: seconds of each, first seed)
  references
           make the finite differences again that tests compare gradients with
           (further arguments: parts of the names of tests)
  verdicts check 3000 gradients that are right, with few samples, and a quarter of
           them made wrong, too (further arguments: how many, the first, every which)
  parity   render tests/parity/*.xml with capwalk and with Mitsuba, and compare;
           with --golden, make the images of tests/parity/golden instead
           (needs python3 and PyPI; further arguments: scene names)
  kernels  compile the kernels of GPUs, which are checked in (needs python3 and
           PyPI)
  gpu      measure queries, images and gradients on the GPU, or on software Vulkan,
           and compare them with the CPU's; also Mitsuba's where cuda_ad_rgb
           runs (further argument: part of the adapter's name)
  peers    measure how much noise capwalk and Mitsuba leave after a second on one
           thread, in derivatives and images; with --quick, only see that it works;
           with --images, images alone; with --texels, gradients of textures and
           skies alone; with --tables, print again what was measured before; with
           --public FOLDER, also the public scenes in there: the clone
           mitsuba-tutorials, and living-room
           (needs python3, PyPI and LLVM; further arguments: scene names)
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (task, rest) = match arguments.split_first() {
        Some((task, rest)) => (task.as_str(), rest),
        None => ("help", &[][..]),
    };
    let result = match task {
        "test" => test::run(rest),
        "bench" => bench(rest),
        "layout" => layout::run(rest),
        "package" => package::run(true),
        "soak" => soak::run(rest),
        "references" => references::run(rest),
        "verdicts" => verdicts::run(rest),
        "parity" => parity::run(rest),
        "kernels" => kernels::run(),
        "gpu" => gpu::run(rest),
        "peers" => peers::run(rest),
        "help" | "--help" | "-h" => {
            print!("{HELP}");
            Ok(())
        }
        unknown => {
            eprint!("error: there is no task \"{unknown}\"\n\n{HELP}");
            return ExitCode::FAILURE;
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn bench(rest: &[String]) -> Result<()> {
    let mut command = cargo(&["bench"]);
    command.args(EVERYTHING).args(["--bench", "*"]);
    if !rest.is_empty() {
        command.arg("--").args(rest);
    }
    step("bench", command)
}
