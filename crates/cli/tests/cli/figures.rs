//! `figures`, small: what it prints and writes, and what it refuses.

use crate::{Capwalk, assert_has};

#[test]
fn figures_are_drawn_by_name() {
    let capwalk = Capwalk::new("figures_by_name");
    let finished = capwalk.run("figures variance fig03 --quality smoke --out out");
    assert_eq!(finished.status, 0, "{}", finished.stderr);
    assert_has(
        &finished.stdout,
        &["Figure 3", "paper: ", "here: ", "holds", "out/report.html"],
    );
    let page = String::from_utf8(capwalk.bytes("out/report.html")).expect("text");
    assert_has(&page, &["id=\"fig03\"", "id=\"variance\"", "<svg"]);
    assert!(!page.contains("id=\"fig08\""), "it was not asked for");

    let json = capwalk.json("figures variance --quality smoke --json --out again");
    let claims = json["figures"][0]["claims"].as_array().expect("claims");
    assert_eq!(claims.len(), 6, "two for each domain");
    assert_eq!(claims[0]["verdict"], "holds");
    // The same numbers as text, in the table for other programs.
    let table = String::from_utf8(capwalk.bytes("again/claims.csv")).expect("text");
    assert_has(&table, &[claims[0]["here"].as_str().expect("text")]);
}

#[test]
fn unknown_figures_and_meshes_are_errors() {
    let capwalk = Capwalk::new("figures_errors");
    assert_has(&capwalk.error("figures fig99"), &["fig99", "fig03", "all"]);
    capwalk.write("bunny.stl", "solid");
    let draw = "figures queries --quality smoke --out out --mesh";
    assert_has(
        &capwalk.error(&format!("{draw} bunny.stl")),
        &["bunny.stl", ".ply"],
    );
    assert_has(
        &capwalk.error(&format!("{draw} gone.ply")),
        &["cannot read gone.ply", "expected a mesh"],
    );
    capwalk.write("empty.obj", "v 0 0 0\n");
    assert_has(
        &capwalk.error(&format!("{draw} empty.obj")),
        &["empty.obj", "no faces"],
    );
    capwalk.write("tetrahedron.obj", TETRAHEDRON);
    let finished = capwalk.run(&format!("{draw} tetrahedron.obj"));
    assert_has(&finished.stdout, &["4 triangles"]);
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
