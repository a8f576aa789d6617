//! Mitsuba 3 from PyPI, in a virtual environment of its own, and the LLVM that its
//! vectorised variants need.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Result;

use crate::shell::root;
use crate::virtual_environment;

/// The release compared with.
pub const MITSUBA: &str = "mitsuba==3.9.1";

/// The Python of a virtual environment with Mitsuba, made if there is none.
pub fn environment() -> Result<PathBuf> {
    virtual_environment::environment(&folder(), "mitsuba, numpy", &[MITSUBA, "numpy"])
}

/// The Python of that environment if it was made, else the system's, which may have Mitsuba or not.
pub fn python() -> PathBuf {
    let own = virtual_environment::python_in(&folder());
    match own.exists() {
        true => own,
        false => virtual_environment::SYSTEM.into(),
    }
}

fn folder() -> PathBuf {
    root().join("target/parity/venv")
}

/// The variable by which Mitsuba is told where LLVM is.
pub const LLVM_VARIABLE: &str = "DRJIT_LIBLLVM_PATH";

/// The oldest LLVM that compiles everything: 15 has no `maximum` of single numbers
/// for CPUs with AVX-512, and ends the program.
const OLDEST_LLVM: u32 = 16;

/// What to do where there is no LLVM.
pub const WITHOUT_LLVM: &str = "\
no shared library of LLVM 16 or later was found, which Mitsuba needs for llvm_ad_rgb.
Install it (Debian: apt install libllvm19), or say where it is in DRJIT_LIBLLVM_PATH.
Without it only images are compared, with scalar_rgb";

/// LLVM's shared library: that of the environment variable, else the newest one
/// where Debian and its descendants put them.
pub fn llvm() -> Option<PathBuf> {
    if let Some(given) = std::env::var_os(LLVM_VARIABLE) {
        return Some(given.into());
    }
    let folders = ["x86_64", "aarch64"].map(|cpu| format!("/usr/lib/{cpu}-linux-gnu"));
    let entries = folders
        .iter()
        .filter_map(|folder| fs::read_dir(folder).ok());
    let files = entries
        .flatten()
        .filter_map(|entry| Some(entry.ok()?.path()));
    let versions = files.filter_map(|file| Some((llvm_version(&file)?, file)));
    let newest = versions.max()?;
    (newest.0 >= OLDEST_LLVM).then_some(newest.1)
}

/// The major version in names like `libLLVM-16.so.1` and `libLLVM.so.19.1`.
fn llvm_version(file: &Path) -> Option<u32> {
    let name = file.file_name()?.to_str()?;
    let rest = name.strip_prefix("libLLVM")?;
    let digits = rest.strip_prefix('-').or(rest.strip_prefix(".so."))?;
    let end = digits.find('.').unwrap_or(digits.len());
    digits[..end].parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_in_names() {
        for (name, version) in [
            ("libLLVM-14.0.6.so.1", Some(14)),
            ("libLLVM-16.so.1", Some(16)),
            ("libLLVM.so.19.1", Some(19)),
            ("libLLVM.so", None),
            ("libLLVMSPIRVLib.so.15", None),
            ("libLTO.so.16", None),
        ] {
            let file = Path::new("/usr/lib/x86_64-linux-gnu").join(name);
            assert_eq!(llvm_version(&file), version, "{name}");
        }
    }
}
