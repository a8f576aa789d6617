//! `cargo xtask layout`: no files of a crate import each other in a circle, and
//! no name means two things. Takes 0.3 s for all crates.
//!
//! Why not `cargo modules dependencies --acyclic` (0.27): whatever its options leave
//! out, it stops at the first type and its own method (`Vec3` and `Vec3::new`) and
//! calls them a circle, where files are meant here. Its installation took nine
//! minutes of CPU time, each crate two to eight seconds.

mod circles;
mod imports;
mod names;
mod source;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::shell::{packages, root};
use circles::circles;
use imports::imports;
use source::Crate;

/// A crate of the workspace.
struct Member {
    /// Its folder's name.
    name: String,
    /// True if other people's crates may depend on it.
    published: bool,
    /// Its modules.
    krate: Crate,
}

/// Checks all crates, or those of these names (`geometry`, `scene-io`), and prints what
/// is wrong. An error if anything is.
pub fn run(wanted: &[String]) -> Result<()> {
    let mut members = members()?;
    for name in wanted {
        let known = members.iter().any(|member| member.name == *name);
        ensure!(known, "no crate is called \"{name}\"");
    }
    members.retain(|member| wanted.is_empty() || wanted.contains(&member.name));
    println!("--- layout of {} crates", members.len());
    let found = findings(&members);
    for (name, details) in &found {
        println!("    {name}\n{details}");
    }
    ensure!(found.is_empty(), "the layout is not as it must be");
    Ok(())
}

/// All that is wrong: a name for it, and the lines that say where.
fn findings(members: &[Member]) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    let mut add_places = |what: &str, places: names::Places| {
        for (name, files) in places {
            let lines: Vec<_> = files
                .iter()
                .map(|file| format!("        {}", shown(file)))
                .collect();
            found.insert(format!("{what} {name}"), lines.join("\n"));
        }
    };
    let published = members.iter().filter(|member| member.published);
    let exported = names::exported_types(published.map(|member| &member.krate));
    add_places("exported twice:", exported);
    for Member { name, krate, .. } in members {
        add_places(&format!("{name}, type defined twice:"), names::types(krate));
        add_places(
            &format!("{name}, file name used twice:"),
            names::files(krate),
        );
    }
    for Member { name, krate, .. } in members {
        let details = describe_circles(krate);
        if !details.is_empty() {
            found.insert(format!("{name}, circle"), details);
        }
    }
    found
}

/// The files of each circle, and which names each needs from which others in it.
fn describe_circles(krate: &Crate) -> String {
    let imports = imports(krate);
    let mut text = String::new();
    let mut line = |indent: usize, words: String| {
        writeln!(text, "{:indent$}{words}", "").expect("a string can be written to");
    };
    for circle in circles(&imports) {
        line(8, format!("{} files import each other:", circle.len()));
        for &file in &circle {
            line(12, shown(&krate.files[file]));
            for (other, names) in &imports[file] {
                if circle.contains(other) {
                    let names: Vec<&str> = names.iter().map(String::as_str).collect();
                    let from = shown(&krate.files[*other]);
                    line(16, format!("needs {} from {from}", names.join(", ")));
                }
            }
        }
    }
    text.trim_end().to_owned()
}

/// A file's path from the root of the workspace.
fn shown(file: &Path) -> String {
    let relative = file.strip_prefix(root()).unwrap_or(file);
    relative.display().to_string()
}

/// The libraries and programs of the workspace.
fn members() -> Result<Vec<Member>> {
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let mut members = Vec::new();
    for package in packages()? {
        for target in list(&package["targets"]) {
            let kinds = list(&target["kind"]);
            if !kinds
                .iter()
                .any(|kind| kind == "lib" || kind == "cdylib" || kind == "bin")
            {
                continue;
            }
            let path = |value: &Value| value.as_str().map(PathBuf::from);
            let manifest = path(&package["manifest_path"]).context("a package without a file")?;
            let root = path(&target["src_path"]).context("a crate without a file")?;
            let folder = manifest
                .parent()
                .and_then(Path::file_name)
                .unwrap_or_default();
            members.push(Member {
                name: folder.to_string_lossy().into_owned(),
                published: package["publish"].is_null(),
                krate: Crate::read(&root)?,
            });
        }
    }
    Ok(members)
}
