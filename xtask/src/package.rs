//! `cargo xtask package`: what would be published is complete.

use std::path::Path;

use anyhow::{Context, Result, ensure};

use crate::shell::{cargo, packages, root, start, target};

/// Files of the workspace that every crate's folder has a link to.
const LICENCES: [&str; 2] = ["LICENSE-MIT", "LICENSE-APACHE"];

/// Packs every crate that may be published, and demands a description, the readme,
/// the licences, and one version for all of them. With `verify`, also builds each from its package alone, which
/// takes as long as building everything.
pub fn run(verify: bool) -> Result<()> {
    let published = packages()?;
    let published = published
        .iter()
        .filter(|package| package["publish"].is_null());
    let mut arguments = vec!["package", "--allow-dirty", "--offline", "--quiet"];
    let mut wanting = Vec::new();
    for package in published {
        let name = package["name"]
            .as_str()
            .context("a package without a name")?;
        arguments.extend(["--package", name]);
        for key in ["description", "readme"] {
            if package[key].is_null() {
                wanting.push(format!("{name} has no {key} in its Cargo.toml"));
            }
        }
        let version = format!("^{}", package["version"].as_str().unwrap_or_default());
        let dependencies = package["dependencies"].as_array().into_iter().flatten();
        for dependency in dependencies.filter(|dependency| !dependency["path"].is_null()) {
            if dependency["req"] != version.as_str() {
                let (other, asked) = (&dependency["name"], &dependency["req"]);
                wanting.push(format!("{name} asks for {other} {asked}, not {version}"));
            }
        }
        let manifest = package["manifest_path"].as_str();
        let manifest = Path::new(manifest.context("a package without a file")?);
        for licence in LICENCES {
            let link = manifest.with_file_name(licence);
            if !link.exists() {
                let link = link.strip_prefix(root()).unwrap_or(&link).display();
                wanting.push(format!("{link} is missing: `ln -s ../../{licence} {link}`"));
            }
        }
    }
    ensure!(
        wanting.is_empty(),
        "packages are incomplete:\n{}",
        wanting.join("\n")
    );
    if !verify {
        arguments.push("--no-verify");
        return start("packages", cargo(&arguments));
    }
    // Cargo knows an unpacked crate by its version and this folder's path alone: in a
    // folder used before it would build the sources of that time.
    let fresh = target().join(format!("packages-{}", std::process::id()));
    let mut command = cargo(&arguments);
    command.arg("--target-dir").arg(&fresh);
    let outcome = start("packages", command);
    let removed = std::fs::remove_dir_all(&fresh);
    outcome.and(removed.with_context(|| format!("cannot remove {}", fresh.display())))
}
