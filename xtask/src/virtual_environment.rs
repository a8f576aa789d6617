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
        // uv takes half the CPU time of pip, but does not know what pip is configured for.
        let uv = ["-m", "uv", "pip", "install", "--quiet", "--python"];
        let by_uv = install(&python, &["uv"]).and_then(|()| {
            let mut install = Command::new(&python);
            install.args(uv).arg(&python).args(packages);
            start("packages of PyPI", install)
        });
        if by_uv.is_err() {
            install(&python, packages).context("needs PyPI")?;
        }
    }
    Ok(python)
}

/// Installs packages by pip.
fn install(python: &Path, packages: &[&str]) -> Result<()> {
    let mut install = Command::new(python);
    install.args([
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ]);
    install.args(packages);
    start(&format!("{} by pip", packages.join(", ")), install)
}
