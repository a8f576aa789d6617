//! The Python package: its module built, its types and tests checked in an environment of
//! its own.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use std::{fs, thread};

use anyhow::{Context, Result, bail};

use crate::shell::{EVERYTHING, cargo, root, start, target};
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
    "nbclient>=0.10",
    "ipykernel>=6",
    "matplotlib>=3.8",
    "sphinx>=8",
    "myst-nb>=1.4",
    "furo>=2025",
];
const MODULES_OF_FRAMEWORKS: &str =
    "torch, jax, mitsuba, ray, nbclient, ipykernel, matplotlib, sphinx, myst_nb, furo";

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

/// Builds the module as the tests of Rust are built, and runs the tests of the package with
/// it. Where there is no python3 or PyPI cannot be reached it says so. Where the variable `CI`
/// is set it fails then, and the frameworks are installed as well. The thorough tier compares the
/// stored outputs of tutorials with a run.
pub fn test(tier: Tier) -> Result<()> {
    let folder = target().join("python");
    let python = match &*PYTHON {
        Ok(python) => python,
        Err(reason) if is_ci() => bail!("{reason}"),
        Err(reason) => {
            println!("--- python\n    SKIPPED: {reason}");
            return Ok(());
        }
    };
    // Together with the tests of Rust, which are there already: built without them, libraries would
    // have fewer features, and nearly all would be built twice.
    let mut build = cargo(&["build", "--lib", "--bins", "--tests"]);
    build.args(EVERYTHING);
    start("python: module", build)?;
    let site = folder.join("site");
    install(&site)?;
    let run = |arguments: &[&str]| {
        let mut command = Command::new(python);
        command.args(arguments).current_dir(root());
        command.env("PYTHONPATH", &site);
        command
    };
    let sources = ["-m", "mypy", "--strict", "python/capwalk", "python/tests"];
    start("python: types", run(&sources))?;
    let mut tests = run(&[
        "-m",
        "pytest",
        "-q",
        "-rs",
        "--durations=10",
        "python/tests",
    ]);
    tests.envs(vulkan::for_tests());
    if tier == Tier::Thorough {
        tests.env("CAPWALK_THOROUGH", "1");
    }
    start("python: tests", tests)?;
    // Examples in docstrings, but of what is not installed.
    let examples = ["--doctest-modules", "--doctest-ignore-import-errors"];
    let mut doctest = run(&["-m", "pytest", "-q", "--pyargs", "capwalk"]);
    doctest.args(examples).current_dir(&folder);
    start("python: examples in docstrings", doctest)?;
    if !is_ci() {
        return Ok(());
    }
    let build = [
        "-m",
        "sphinx",
        "-q",
        "-W",
        "--keep-going",
        "-c",
        "docs/site",
        "docs",
    ];
    let mut site = run(&build);
    site.arg(target().join("site"));
    start("python: documentation", site)
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
