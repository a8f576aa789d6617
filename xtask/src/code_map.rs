//! Test: the code map of ARCHITECTURE.md names every source file, and nothing
//! that is not there.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::shell::root;

/// The heading above the map, and the next one.
const MAP: [&str; 2] = ["\n## Code map\n", "\n## "];

/// What the map leaves out, as it says itself: files that only name modules,
/// and tests.
const LEFT_OUT: [&str; 3] = ["lib.rs", "mod.rs", "tests.rs"];

/// Source files of a folder and those below it, relative to `src`.
fn sources(src: &Path, folder: &Path, found: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name == "tests" {
            continue;
        } else if path.is_dir() {
            sources(src, &path, found);
        } else if name.ends_with(".rs") && !LEFT_OUT.contains(&name.as_ref()) {
            let path = path.strip_prefix(src).expect("it is below");
            let parts = path.iter().map(|part| part.to_string_lossy());
            found.insert(parts.collect::<Vec<_>>().join("/"));
        }
    }
}

/// Source files that the paragraphs under a crate's bold name have in
/// backticks. A crate may have several.
fn named(map: &str, name: &str) -> BTreeSet<String> {
    let heading = format!("**`{name}`**");
    let paragraphs = map.split("\n\n").filter(|text| text.starts_with(&heading));
    paragraphs
        .flat_map(|text| text.split('`').skip(1).step_by(2))
        .filter(|name| name.ends_with(".rs"))
        .map(str::to_owned)
        .collect()
}

#[test]
fn the_code_map_names_every_file() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("the architecture");
    let start = text.find(MAP[0]).expect("a code map") + MAP[0].len();
    let length = text[start..].find(MAP[1]).expect("a section after it");
    let map = &text[start..start + length];

    let crates = ["crates", "tools"].into_iter().flat_map(|folder| {
        let entries = fs::read_dir(root().join(folder)).expect("a folder of crates");
        entries.map(move |entry| {
            let name = entry.expect("an entry").file_name();
            format!("{folder}/{}", name.to_string_lossy())
        })
    });
    let mut wrong = Vec::new();
    let mut files = 0;
    for name in crates.chain(["xtask".to_owned()]) {
        let src = root().join(&name).join("src");
        let mut there = BTreeSet::new();
        sources(&src, &src, &mut there);
        files += there.len();
        let named = named(map, &name);
        let missing = there.difference(&named);
        wrong.extend(missing.map(|file| format!("{name}: {file} is not named")));
        let gone = named.difference(&there);
        wrong.extend(gone.map(|file| format!("{name}: {file} is named, but not there")));
    }
    assert!(files > 100, "only {files} source files found");
    assert!(
        wrong.is_empty(),
        "the code map of ARCHITECTURE.md is not true:\n{}",
        wrong.join("\n")
    );
}
