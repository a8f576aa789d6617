//! `cargo xtask soak`: the randomised tests, for longer than tests may take.

use std::process::Command;

use anyhow::Result;

use crate::shell::{cargo, number, root, step};

/// Address space of the readers, in KiB: what a damaged file of a few kilobytes
/// makes a reader reserve beyond that is a fault of the reader.
const ADDRESS_SPACE: u32 = 3 << 20;

/// Damaged files, commands that ask for too much, random scenes, then wide ones, for some seconds each from
/// some seed on.
pub fn run(rest: &[String]) -> Result<()> {
    let (seconds, seed) = (number(rest, 0, 60)?, number(rest, 1, 1)?);
    let run = |name: &str, package: &str, target: &str, filter: &str| {
        let test = ["test", "--release", "--package", package, "--test", target];
        let mut build = cargo(&test);
        build.arg("--no-run");
        step(&format!("{name}, build"), build)?;
        let mut command = match name {
            "damaged files" => limited(cargo(&test)),
            _ => cargo(&test),
        };
        command
            .args(["--", "--nocapture", filter])
            .env("CAPWALK_SOAK_SECONDS", seconds.to_string())
            .env("CAPWALK_SOAK_SEED", seed.to_string());
        step(name, command)
    };
    run("damaged files", "capwalk-scene-io", "reading", "damaged")?;
    run("hostile commands", "capwalk-cli", "cli", "hostile")?;
    run(
        "random scenes",
        "capwalk-diff",
        "gradients",
        "random_scenes",
    )?;
    run("wide scenes", "capwalk-diff", "gradients", "wide_scenes")
}

/// The command with little memory, where a shell can say so.
fn limited(command: Command) -> Command {
    if !cfg!(unix) {
        return command;
    }
    let mut limited = Command::new("sh");
    limited
        .arg("-c")
        .arg(format!("ulimit -v {ADDRESS_SPACE} && exec \"$0\" \"$@\""))
        .arg(command.get_program())
        .args(command.get_args())
        .current_dir(root());
    limited
}
