//! The built command from outside: what it prints and writes, and what it refuses.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use capwalk_scene_io::load_scene;
use serde_json::Value;

/// An empty folder named after the test.
fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    // What an earlier run left.
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the build folder is writable");
    folder
}

/// Runs in a folder with arguments that are separated by spaces.
fn run(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_capwalk-paper"));
    command
        .args(arguments.split_whitespace())
        .current_dir(folder);
    command.output().expect("it starts")
}

/// The standard output of a run that succeeds.
fn output(folder: &Path, arguments: &str) -> String {
    let Output {
        status,
        stdout,
        stderr,
    } = run(folder, arguments);
    assert!(status.success(), "{}", String::from_utf8_lossy(&stderr));
    String::from_utf8(stdout).expect("text")
}

/// The error that bad input gives.
fn error(folder: &Path, arguments: &str) -> String {
    let output = run(folder, arguments);
    assert_eq!(output.status.code(), Some(3), "{arguments}");
    assert_eq!(output.stdout, b"", "{arguments}");
    let stderr = String::from_utf8(output.stderr).expect("text");
    assert!(stderr.starts_with("error: "), "{stderr}");
    stderr
}

/// Asserts that a text has all these parts.
#[track_caller]
fn assert_has(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "no \"{part}\" in:\n{text}");
    }
}

#[test]
fn figures_are_drawn_by_name() {
    let folder = folder("figures_by_name");
    let text = output(
        &folder,
        "figures variance fig03 --quality smoke --out out -t 2",
    );
    assert_has(
        &text,
        &["Figure 3", "paper: ", "here: ", "holds", "out/report.html"],
    );
    let page = fs::read_to_string(folder.join("out/report.html")).expect("it was written");
    assert_has(&page, &["id=\"fig03\"", "id=\"variance\"", "<svg"]);
    assert!(!page.contains("id=\"fig08\""), "it was not asked for");

    let json = output(
        &folder,
        "figures variance --quality smoke --json --out again",
    );
    let json: Value = serde_json::from_str(&json).expect("one JSON object");
    let claims = json["figures"][0]["claims"].as_array().expect("claims");
    assert_eq!(claims.len(), 6, "two for each domain");
    assert_eq!(claims[0]["verdict"], "holds");
    // The same numbers as text, in the table for other programs.
    let table = fs::read_to_string(folder.join("again/claims.csv")).expect("it was written");
    assert_has(&table, &[claims[0]["here"].as_str().expect("text")]);
}

#[test]
fn unknown_figures_and_meshes_are_errors() {
    let folder = folder("figures_errors");
    let write = |name: &str, text: &str| {
        fs::write(folder.join(name), text).expect("the folder is writable");
    };
    assert_has(&error(&folder, "figures fig99"), &["fig99", "fig03", "all"]);
    write("bunny.stl", "solid");
    let draw = "figures queries --quality smoke --out out --mesh";
    assert_has(
        &error(&folder, &format!("{draw} bunny.stl")),
        &["bunny.stl", ".ply"],
    );
    assert_has(
        &error(&folder, &format!("{draw} gone.ply")),
        &["cannot read gone.ply", "expected a mesh"],
    );
    write("empty.obj", "v 0 0 0\n");
    assert_has(
        &error(&folder, &format!("{draw} empty.obj")),
        &["empty.obj", "no faces"],
    );
    write("tetrahedron.obj", TETRAHEDRON);
    assert_has(
        &output(&folder, &format!("{draw} tetrahedron.obj")),
        &["4 triangles"],
    );
}

/// What the other command reads.
#[test]
fn the_bunny_is_a_scene_file() {
    let folder = folder("bunny_scene");
    assert_has(&output(&folder, "bunny bunny.xml"), &["bunny.xml"]);
    let loaded = load_scene(&folder.join("bunny.xml"), &[]).expect("readable");
    let ids: Vec<&str> = loaded.scene.shapes.iter().map(|s| s.id.as_str()).collect();
    assert_eq!(ids, ["floor", "lamp", "bunny"]);
}

const TETRAHEDRON: &str = "\
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
";
