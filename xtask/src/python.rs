//! The Python package: its module built, its types and tests checked in an environment of
//! its own.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use std::thread;
use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};

use crate::shell::{root, target};
use crate::tier::Tier;
use crate::virtual_environment::environment;
use crate::vulkan;

/// What the tests need of PyPI, and how it is imported.
const PACKAGES: &[&str] = &["numpy>=2", "pytest>=8", "mypy>=1.14"];
const MODULES: &str = "numpy, pytest, mypy";

/// What capwalk works with: gigabytes, most of them PyTorch's. Tests of what is not there are
/// skipped.
const FRAMEWORKS: &[&str] = &[
    "torch>=2",
    "jax[cpu]",
    "mitsuba==3.9.1",
    "ray>=2.40",
    "trimesh>=4",
    "rerun-sdk>=0.41",
    "gpytoolbox>=0.3.8",
    "nbclient>=0.10",
    "ipykernel>=6",
    "matplotlib>=3.8",
    "sphinx>=8",
    "sphinx-copybutton>=0.5",
    "myst-nb>=1.4",
    "furo>=2025",
];
const MODULES_OF_FRAMEWORKS: &str = "torch, jax, mitsuba, ray, trimesh, rerun, gpytoolbox, \
                                     nbclient, ipykernel, matplotlib, sphinx, sphinx_copybutton, \
                                     myst_nb, furo";

/// The Python of an environment with all that the tests need, or why there is none. Whoever
/// asks for it first makes it; the others wait.
static PYTHON: LazyLock<Result<PathBuf, String>> = LazyLock::new(|| {
    let (name, modules, packages) = match is_ci() {
        true => {
            let modules = format!("{MODULES}, {MODULES_OF_FRAMEWORKS}");
            ("frameworks", modules, [PACKAGES, FRAMEWORKS].concat())
        }
        false => ("environment", MODULES.to_owned(), PACKAGES.to_vec()),
    };
    let folder = target().join("python").join(name);
    environment(&folder, &modules, &packages).map_err(|error| format!("{error:#}"))
});

fn is_ci() -> bool {
    std::env::var_os("CI").is_some()
}

/// Where it takes minutes, in CI, fetches what the tests need while other steps compile.
pub fn fetch() {
    if is_ci() {
        thread::spawn(|| LazyLock::force(&PYTHON));
    }
}

/// Runs the tests of the package with the module that is built for the tests of Rust. What they print
/// goes to a file, and is shown as a whole at the end. Where there is no python3 or PyPI cannot be
/// reached it says so. Where the variable `CI` is set it fails then, and the frameworks are installed
/// as well. The thorough tier compares the stored outputs of tutorials with a run.
pub fn test(tier: Tier) -> Result<()> {
    let python = match &*PYTHON {
        Ok(python) => python,
        Err(reason) if is_ci() => bail!("{reason}"),
        Err(reason) => {
            println!("--- python\n    SKIPPED: {reason}");
            return Ok(());
        }
    };
    let folder = target().join("python");
    let log = folder.join("tests.log");
    let result = File::create(&log)
        .with_context(|| format!("cannot write {}", log.display()))
        .and_then(|file| checks(python, &folder, &file, tier));
    print!("{}", fs::read_to_string(&log).unwrap_or_default());
    result
}

/// Types, tests, examples in docstrings and the pages of documentation, with the time that each took.
fn checks(python: &Path, folder: &Path, mut log: &File, tier: Tier) -> Result<()> {
    let site = folder.join("site");
    install(&site)?;
    let mut check = |name: &str, folder: &Path, arguments: &[&str]| {
        let started = Instant::now();
        writeln!(log, "--- python: {name}")?;
        let mut command = Command::new(python);
        command.arg("-m").args(arguments).current_dir(folder);
        command.env("PYTHONPATH", &site).envs(vulkan::for_tests());
        if tier == Tier::Thorough {
            command.env("CAPWALK_THOROUGH", "1");
        }
        let status = command
            .stdout(log.try_clone()?)
            .stderr(log.try_clone()?)
            .status()
            .with_context(|| format!("cannot start {}", python.display()))?;
        writeln!(log, "    {:.0} s", started.elapsed().as_secs_f64())?;
        ensure!(status.success(), "python: {name} failed ({status})");
        Ok(())
    };
    let types = ["mypy", "--strict", "python/capwalk", "python/tests"];
    check("types", &root(), &types)?;
    let tests = ["pytest", "-q", "-rs", "--durations=10", "python/tests"];
    check("tests", &root(), &tests)?;
    // Examples in docstrings, but of what is not installed.
    let examples = [
        "pytest",
        "-q",
        "--pyargs",
        "capwalk",
        "--doctest-modules",
        "--doctest-ignore-import-errors",
    ];
    check("examples in docstrings", folder, &examples)?;
    if !is_ci() {
        return Ok(());
    }
    let pages = target().join("site");
    let pages = pages.to_string_lossy();
    let build = [
        "sphinx",
        "-q",
        "-W",
        "--keep-going",
        "-c",
        "docs/site",
        "docs",
        &*pages,
    ];
    check("documentation", &root(), &build)
}

/// The package and the module beside it, as an installation has them.
fn install(site: &Path) -> Result<()> {
    let package = site.join("capwalk");
    if package.exists() {
        fs::remove_dir_all(&package)?;
    }
    copy(&root().join("python/capwalk"), &package)?;
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

/// Copies the files of a folder and of those in it, but for what Python keeps there.
fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        if entry.file_name() == "__pycache__" {
            continue;
        }
        let target = to.join(entry.file_name());
        match entry.file_type()?.is_dir() {
            true => copy(&entry.path(), &target)?,
            false => {
                fs::copy(entry.path(), target)?;
            }
        }
    }
    Ok(())
}
