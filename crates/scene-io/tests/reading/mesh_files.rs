//! Bad mesh files, as a scene names them.

use crate::common::*;

fn mesh(plugin: &str, file: &str, more: &str) -> String {
    scene(&format!(
        "<shape type=\"{plugin}\"><string name=\"filename\" value=\"{file}\"/>{more}</shape>"
    ))
}

#[test]
fn nan_vertex() {
    check(
        &mesh("obj", "nan.obj", ""),
        &[
            "scene.xml:5:52: \"FOLDER/nan.obj\", line 2: vertex 2 has the position (1, 0, NaN)",
            "  expected finite coordinates",
        ],
    );
}

#[test]
fn face_index_out_of_range() {
    check(
        &mesh("ply", "out_of_range.ply", ""),
        &[
            "scene.xml:5:52: \"FOLDER/out_of_range.ply\", face 1: it refers to vertex 3",
            "  there are 3 vertices (counted from 0)",
        ],
    );
}

#[test]
fn empty_mesh() {
    check(
        &mesh("obj", "empty.obj", ""),
        &[
            "scene.xml:5:52: \"FOLDER/empty.obj\": the file has no faces",
            "  expected a mesh with at least one triangle",
        ],
    );
}

#[test]
fn emitter_without_area() {
    check(
        &mesh("obj", "line.obj", "<emitter type=\"area\"/>"),
        &[
            "scene.xml:5:63: the emitter \"line\" has no area and cannot emit; give its mesh at \
             least one triangle with area, or remove its emitter",
        ],
    );
}

#[test]
fn folder_instead_of_a_mesh() {
    check(
        &mesh("obj", "folder.obj", ""),
        &[
            "scene.xml:5:52: cannot read \"FOLDER/folder.obj\": it is a folder; expected a file",
            "  give a file that can be read",
        ],
    );
}

#[test]
fn not_what_the_ending_says() {
    check(
        &mesh("ply", "materials.xml", ""),
        &[
            "scene.xml:5:52: \"FOLDER/materials.xml\", line 1: the file is not a PLY file",
            "  expected \"ply\" in the first line",
        ],
    );
    check(
        &mesh("obj", "materials.xml", ""),
        &[
            "scene.xml:5:52: \"FOLDER/materials.xml\", line 1: \"<scene\" is not an OBJ statement \
             that is read",
            "  expected vertices (v, vn, vt) and faces (f); free-form surfaces must be converted \
             to polygons",
        ],
    );
}

#[test]
fn empty_file_name() {
    check(
        &mesh("obj", "", ""),
        &[
            "scene.xml:5:52: the file name is empty",
            "  give the file relative to the scene file",
        ],
    );
}
