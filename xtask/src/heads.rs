//! Test: every source file begins with a line that says what its idea is.

use std::fs;
use std::path::{Path, PathBuf};

use crate::shell::root;

/// Source files of a folder and those below it, but for tests.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name == "tests" || name == "target" {
            continue;
        } else if path.is_dir() {
            sources(&path, found);
        } else if name.ends_with(".rs") && name != "tests.rs" {
            found.push(path);
        }
    }
}

#[test]
fn every_file_says_what_its_idea_is() {
    let mut files = Vec::new();
    for folder in ["crates", "tools", "xtask"] {
        sources(&root().join(folder), &mut files);
    }
    assert!(files.len() > 400, "{} files", files.len());
    let has_none = |path: &&PathBuf| {
        let text = fs::read_to_string(path).expect("text");
        !text.starts_with("//! ")
    };
    let without: Vec<_> = files.iter().filter(has_none).collect();
    assert!(
        without.is_empty(),
        "no `//!` in the first line: {without:?}"
    );
}
