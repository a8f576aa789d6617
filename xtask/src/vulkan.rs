//! Software Vulkan in CI, so that the tests of the GPU have something to run on.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

/// Debian's package of software Vulkan.
const PACKAGE: &str = "mesa-vulkan-drivers";

/// Where drivers say that they are there.
const FOLDERS: [&str; 3] = [
    "/usr/share/vulkan/icd.d",
    "/usr/local/share/vulkan/icd.d",
    "/etc/vulkan/icd.d",
];

/// Variables that name drivers elsewhere.
const VARIABLES: [&str; 2] = ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"];

/// What those files' names start with that belong to software Vulkan.
const SOFTWARE: &str = "lvp";

/// Seconds after which an installation is given up.
const PATIENCE: &str = "300";

/// Found once: an installation is tried once.
static FOR_TESTS: LazyLock<Vec<(&'static str, PathBuf)>> = LazyLock::new(find_for_tests);

/// Variables for the tests. In CI they demand an adapter where software Vulkan is there,
/// which is installed before if there is no driver at all; where that fails it says so, and
/// the tests of the GPU are skipped.
pub fn for_tests() -> Vec<(&'static str, PathBuf)> {
    FOR_TESTS.clone()
}

/// Variables that hide all drivers, for tests that shall take none.
pub fn none() -> [(&'static str, &'static str); 1] {
    [(VARIABLES[0], "/dev/null")]
}

fn find_for_tests() -> Vec<(&'static str, PathBuf)> {
    let mut variables = quiet();
    if std::env::var_os("CI").is_none() {
        return variables;
    }
    if drivers().is_empty()
        && VARIABLES
            .iter()
            .all(|name| std::env::var_os(name).is_none())
    {
        install();
    }
    let is_software = |driver: &PathBuf| {
        let name = driver.file_name().unwrap_or_default();
        name.to_string_lossy().starts_with(SOFTWARE)
    };
    if drivers().iter().any(is_software) {
        variables.push(("CAPWALK_GPU_TESTS", "require".into()));
    } else {
        println!("--- vulkan\n    SKIPPED: no {PACKAGE}, the tests of the GPU take what they find");
    }
    variables
}

/// Where nobody is logged in, Mesa complains about a folder that it has no use for.
pub fn quiet() -> Vec<(&'static str, PathBuf)> {
    match std::env::var_os("XDG_RUNTIME_DIR") {
        Some(_) => Vec::new(),
        None => vec![("XDG_RUNTIME_DIR", std::env::temp_dir())],
    }
}

/// The files by which drivers say that they are there.
fn drivers() -> Vec<PathBuf> {
    let entries = FOLDERS
        .iter()
        .flat_map(|folder| fs::read_dir(folder).into_iter().flatten());
    let files = entries.flatten().map(|entry| entry.path());
    files
        .filter(|path| path.extension() == Some(OsStr::new("json")))
        .collect()
}

/// Installs software Vulkan where that is allowed. Whether it worked is asked afterwards.
fn install() {
    if !Path::new("/usr/bin/apt-get").exists() {
        return;
    }
    println!("--- vulkan: {PACKAGE}");
    let apt = |arguments: &[&str]| {
        let mut command = Command::new("timeout");
        command.args([
            PATIENCE,
            "apt-get",
            "-qq",
            "-o",
            "Acquire::http::Timeout=20",
        ]);
        command
            .args(arguments)
            .env("DEBIAN_FRONTEND", "noninteractive");
        command
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    let package = ["install", "--yes", "--no-install-recommends", PACKAGE];
    // The lists of packages may not be there, or old.
    if !apt(&package) && apt(&["update"]) {
        apt(&package);
    }
}
