//! Virtual environments of Python with packages of PyPI.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result};

use crate::shell::start;

/// The system's Python.
pub const SYSTEM: &str = match cfg!(windows) {
    true => "python",
    false => "python3",
};

/// Where the Python of an environment in `folder` is.
pub fn python_in(folder: &Path) -> PathBuf {
    folder.join(match cfg!(windows) {
        true => "Scripts/python.exe",
        false => "bin/python",
    })
}

/// The Python of an environment in `folder` that can import `modules`; made, and given the
/// `packages`, where there is none.
pub fn environment(folder: &Path, modules: &str, packages: &[&str]) -> Result<PathBuf> {
    let python = python_in(folder);
    let mut import = Command::new(&python);
    import.args(["-c", &format!("import {modules}")]);
    let has_all = import.stderr(Stdio::null()).status();
    if !has_all.is_ok_and(|status| status.success()) {
        let mut create = Command::new(SYSTEM);
        create.args(["-m", "venv"]).arg(folder);
        start("virtual environment", create).context("needs python3 with its module venv")?;
        let mut install = Command::new(&python);
        install.args([
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
        ]);
        install.args(packages);
        start("packages of PyPI", install).context("needs PyPI")?;
    }
    Ok(python)
}
