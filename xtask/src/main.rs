//! Project tasks, run as `cargo xtask <task>`.
//!
//! | task | does |
//! |---|---|
//! | `test` | everything a change must pass: format, lints, documentation, all tests |
//! | `bench` | the benchmarks |
//! | `soak` | random scenes and damaged files, for a minute each |
//! | `parity` | renders `tests/parity/*.xml` with Mitsuba too and compares |

#[cfg(test)]
mod code_map;
mod deviation;
mod parity;
mod soak;
mod test;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use anyhow::{Context, Result, bail};

const HELP: &str = "\
usage: cargo xtask <task>

tasks:
  test     format, lints, documentation, and all tests
  bench    the benchmarks (further arguments go to them)
  soak     read damaged files for a minute, then render and differentiate random
           scenes for a minute (further arguments: seconds of each, first seed)
  parity   render tests/parity/*.xml with capwalk and with Mitsuba, and compare
           (needs python3 and PyPI; further arguments: scene names)
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (task, rest) = match arguments.split_first() {
        Some((task, rest)) => (task.as_str(), rest),
        None => ("help", &[][..]),
    };
    let result = match task {
        "test" => test::run(),
        "bench" => bench(rest),
        "soak" => soak::run(rest),
        "parity" => parity::run(rest),
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
    let mut command = cargo(&["bench", "--workspace", "--bench", "*"]);
    if !rest.is_empty() {
        command.arg("--").args(rest);
    }
    step("bench", command)
}

/// The root of the workspace.
fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent()
        .expect("xtask is a folder in the workspace")
        .to_owned()
}

/// A call of the cargo that runs this task, in the root of the workspace.
fn cargo(arguments: &[&str]) -> Command {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(arguments).current_dir(root());
    command
}

/// Runs a command under a heading, fails if it fails, and says how long it took.
fn step(name: &str, command: Command) -> Result<()> {
    let started = Instant::now();
    last_step(name, command)?;
    println!("    {name}: {:.0} s", started.elapsed().as_secs_f64());
    Ok(())
}

/// The same without a word behind it: the command's own summary ends the output.
fn last_step(name: &str, mut command: Command) -> Result<()> {
    println!("--- {name}");
    let status = command
        .status()
        .with_context(|| format!("cannot start {:?}", command.get_program()))?;
    if !status.success() {
        bail!("{name} failed ({status})");
    }
    Ok(())
}
