//! The Python package: its module built, its types and tests checked in an environment of
//! its own.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result};

use crate::shell::{EVERYTHING, cargo, root, start, target};
use crate::virtual_environment::environment;

/// What the tests need of PyPI, and how it is imported.
const PACKAGES: [&str; 3] = ["numpy>=2", "pytest>=8", "mypy>=1.14"];
const MODULES: &str = "numpy, pytest, mypy";

/// Builds the module as the tests of Rust are built, and runs the tests of the package with
/// it. Where there is no python3 or PyPI cannot be reached it says so, and fails only where
/// the variable `CI` is set.
pub fn test() -> Result<()> {
    let folder = target().join("python");
    let python = match environment(&folder.join("environment"), MODULES, &PACKAGES) {
        Ok(python) => python,
        Err(error) if std::env::var_os("CI").is_some() => return Err(error),
        Err(error) => {
            println!("--- python\n    SKIPPED: {error:#}");
            return Ok(());
        }
    };
    // The same features as in the tests, so that nothing is built twice.
    let mut build = cargo(&[
        "build",
        "--package",
        "capwalk-python",
        "--package",
        "capwalk-cli",
    ]);
    build.args(&EVERYTHING[1..]);
    start("python: module", build)?;
    let site = folder.join("site");
    install(&site)?;
    let run = |arguments: &[&str]| {
        let mut command = Command::new(&python);
        command.args(arguments).current_dir(root());
        command.env("PYTHONPATH", &site);
        command
    };
    let sources = ["-m", "mypy", "--strict", "python/capwalk", "python/tests"];
    start("python: types", run(&sources))?;
    start(
        "python: tests",
        run(&["-m", "pytest", "-q", "python/tests"]),
    )
}

/// The package and the module beside it, as an installation has them.
fn install(site: &Path) -> Result<()> {
    let package = site.join("capwalk");
    if package.exists() {
        fs::remove_dir_all(&package)?;
    }
    fs::create_dir_all(&package)?;
    for entry in fs::read_dir(root().join("python/capwalk"))? {
        let file = entry?;
        if file.file_type()?.is_file() {
            fs::copy(file.path(), package.join(file.file_name()))?;
        }
    }
    let [built, installed] = match std::env::consts::OS {
        "windows" => ["_capwalk.dll", "_capwalk.pyd"],
        "macos" => ["lib_capwalk.dylib", "_capwalk.abi3.so"],
        _ => ["lib_capwalk.so", "_capwalk.abi3.so"],
    };
    let module = target().join("debug").join(built);
    fs::copy(&module, package.join(installed))
        .with_context(|| format!("cannot copy {}", module.display()))?;
    Ok(())
}
