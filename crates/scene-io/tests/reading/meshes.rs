//! OBJ and PLY bytes to meshes.

use capwalk_math::Vec3;
use capwalk_scene::ShadingNormals;
use capwalk_scene_io::mesh::{MeshFile, read_obj, read_ply};

use crate::common::*;

fn obj(text: &str) -> MeshFile {
    read_obj(text.as_bytes(), true).unwrap_or_else(|error| panic!("{error}"))
}

fn obj_error(text: &str) -> String {
    read_obj(text.as_bytes(), true)
        .expect_err("bad")
        .to_string()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1.2 1 0.3\nv 0 1 0\nv 0.5 0.5 1\n";

/// Vertices are numbered and split as in Mitsuba 3.9.1, whose numbers these are.
#[test]
fn obj_vertices_are_split_where_texture_coordinates_are() {
    let file = obj(&format!(
        "{SQUARE}vt 0 0\nvt 1 1\nf 1 2 3 4\nf 1/1 5/2 2/1\nf 4/1 5/1 1/1\n"
    ));
    let faces = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [7, 8, 4]];
    assert_eq!(file.mesh.faces, faces);
    let p = Vec3::new;
    let positions = [
        p(0.0, 0.0, 0.0),
        p(1.0, 0.0, 0.0),
        p(1.2, 1.0, 0.3),
        p(0.0, 1.0, 0.0),
        p(0.0, 0.0, 0.0),
        p(0.5, 0.5, 1.0),
        p(1.0, 0.0, 0.0),
        p(0.0, 1.0, 0.0),
        p(0.5, 0.5, 1.0),
    ];
    assert_eq!(file.mesh.positions, positions);
    assert_eq!(file.normals, None);
}

#[test]
fn obj_statements_in_every_form() {
    let file = obj(
        "# comment\n\to thing\r\nv 0 0 0 1 # behind\r\nv 1\t0 0\nv 1 1 0 0.5 0.5 0.5\n\
         vn 0 0 2\ng a b\ns off\nusemtl x\nmtllib a.mtl\nl 1 2\np 1\nvt 0.5\n\
         f -3//1 \\\n -2//1 3//-1\n",
    );
    assert_eq!(file.mesh.faces, [[0, 1, 2]]);
    assert_eq!(file.mesh.positions[2], Vec3::new(1.0, 1.0, 0.0));
    let up = Vec3::new(0.0, 0.0, 1.0);
    assert_eq!(file.normals, Some(vec![up; 3]));
    let without = read_obj(
        b"v 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 0\nf 1//9 2 3//1\n",
        false,
    );
    assert_eq!(without.expect("normals are not wanted").normals, None);
}

/// However long or short, as long as it has a direction.
#[test]
fn obj_normals_of_any_length() {
    for size in ["e300", "e-300", ""] {
        let file = obj(&format!(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 3{size} 0 4{size}\nf 1//1 2//1 3//1\n"
        ));
        let normal = file.normals.expect("they are there")[0];
        assert!(
            (normal - Vec3::new(0.6, 0.0, 0.8)).length() < 1e-15,
            "{normal:?}"
        );
    }
}

/// Decimals are read in double precision, so that equal texts weld.
#[test]
fn obj_numbers_keep_their_digits() {
    let file = obj("v 0.1 1e-3 .5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(file.mesh.positions[0], Vec3::new(0.1, 1e-3, 0.5));
}

#[test]
fn bad_obj_statements() {
    let face = |f: &str| obj_error(&format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n{f}\n"));
    for (message, expected) in [
        (
            face("f 1 2 4"),
            "line 5: the face refers to vertex 4; 3 come before it (counted from 1)",
        ),
        (
            face("f 1 2 0"),
            "line 5: the face refers to vertex 0; 3 come before it (counted from 1)",
        ),
        (
            face("f 1 2 -4"),
            "line 5: the face refers to vertex -4; 3 come before it (counted from 1)",
        ),
        (
            face("f 1//1 2//1 3//2"),
            "line 5: the face refers to normal 2; 1 come before it (counted from 1)",
        ),
        (
            face("f 1/1 2/1 3/1"),
            "line 5: the face refers to texture coordinate 1; 0 come before it (counted from 1)",
        ),
        (
            face("f 1 2"),
            "line 5: the face has 2 corners; expected at least 3",
        ),
        (
            face("f 1 2 x"),
            "line 5: \"x\" is not a corner of a face; expected v, v/vt, v//vn or v/vt/vn",
        ),
        (
            face("f 1//1 2//1 3"),
            "line 5: the corners of the face are written in different forms; expected all of them \
             as v, v/vt, v//vn or v/vt/vn",
        ),
        (
            face("f 1//1 2//1 3//1\nf 1 2 3"),
            "line 6: the face has corners without normals, but others have them; give all corners \
             normals or none; face_normals does without normals",
        ),
        (
            obj_error("v 0 0\n"),
            "line 1: \"\" is not a number; expected three coordinates of a vertex",
        ),
        (
            obj_error("v 0 0 inf\n"),
            "line 1: vertex 1 has the position (0, 0, inf); expected finite coordinates",
        ),
        (
            obj_error("v 0 -2e30 0\n"),
            "line 1: vertex 1 has the position (0, -2000000000000000000000000000000, 0); expected \
             coordinates up to 1e30",
        ),
        (
            obj_error("vn 0 0 0\n"),
            "line 1: normal 1 is (0, 0, 0); expected a finite vector that is not zero; \
             face_normals does without normals",
        ),
        (
            obj_error("\n\nsurf 0 1\n"),
            "line 3: \"surf\" is not an OBJ statement that is read; expected vertices (v, vn, vt) \
             and faces (f); free-form surfaces must be converted to polygons",
        ),
        (
            obj_error(""),
            "the file has no faces; expected a mesh with at least one triangle",
        ),
    ] {
        assert_eq!(message, expected);
    }
}

/// Positions and normals of three vertices with a colour, a list, a quad and a
/// triangle, and an element of another kind in between.
fn ply_bytes(format: &str) -> Vec<u8> {
    let header = format!(
        "ply\nformat {format} 1.0\ncomment of any kind\nobj_info too\nelement vertex 4\n\
         property float x\nproperty double y\nproperty short z\nproperty uchar red\n\
         property list uchar ushort extra\nproperty float nx\nproperty float ny\n\
         property float nz\nelement edge 2\nproperty int a\nproperty list int double b\n\
         element face 2\nproperty char flag\nproperty list uchar uint vertex_index\nend_header\n"
    );
    let mut bytes = header.into_bytes();
    if format == "ascii" {
        bytes.extend_from_slice(
            b"0.5 0.1 -1 255 0 0 0 1\n1 0 0 7 2 500 501 0 0 2\n1 1 0 0 1 9 0 0 0.5 0 1 3\n9 0 0 0 1\
              \n5 0\n6 3 1.5 2.5 3.5\n-1 4 0 1 2 3\n\n-1 3 2 1 0",
        );
        return bytes;
    }
    let big = format == "binary_big_endian";
    let mut number = |little: &[u8]| {
        let mut raw = little.to_vec();
        if big {
            raw.reverse();
        }
        bytes.extend(raw);
    };
    let vertices: [([f64; 3], &[u16], f32); 4] = [
        ([0.5, 0.1, -1.0], &[], 1.0),
        ([1.0, 0.0, 0.0], &[500, 501], 2.0),
        ([1.0, 1.0, 0.0], &[9], 0.5),
        ([0.0, 1.0, 3.0], &[], 1.0),
    ];
    for ([x, y, z], extra, normal) in vertices {
        number(&(x as f32).to_le_bytes());
        number(&y.to_le_bytes());
        number(&(z as i16).to_le_bytes());
        number(&[0xff]);
        number(&[extra.len() as u8]);
        extra.iter().for_each(|e| number(&e.to_le_bytes()));
        [0.0, 0.0, normal]
            .iter()
            .for_each(|n: &f32| number(&n.to_le_bytes()));
    }
    for (a, b) in [(5_i32, &[][..]), (6, &[1.5_f64, 2.5, 3.5][..])] {
        number(&a.to_le_bytes());
        number(&(b.len() as i32).to_le_bytes());
        b.iter().for_each(|x| number(&x.to_le_bytes()));
    }
    for corners in [&[0_u32, 1, 2, 3][..], &[2, 1, 0][..]] {
        number(&[0xff]);
        number(&[corners.len() as u8]);
        corners.iter().for_each(|c| number(&c.to_le_bytes()));
    }
    bytes
}

#[test]
fn ply_in_every_format() {
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let file = read_ply(&ply_bytes(format), true).unwrap_or_else(|e| panic!("{format}: {e}"));
        let p = Vec3::new;
        let positions = [
            p(0.5, 0.1, -1.0),
            p(1.0, 0.0, 0.0),
            p(1.0, 1.0, 0.0),
            p(0.0, 1.0, 3.0),
        ];
        assert_eq!(file.mesh.positions, positions, "{format}");
        assert_eq!(
            file.mesh.faces,
            [[0, 1, 2], [0, 2, 3], [2, 1, 0]],
            "{format}"
        );
        assert_eq!(file.normals, Some(vec![p(0.0, 0.0, 1.0); 4]), "{format}");
        let warning = "has 2 elements \"edge\", which are not read";
        assert_eq!(file.warnings, [warning], "{format}");
        let without = read_ply(&ply_bytes(format), false).expect("the same without normals");
        assert_eq!(without.normals, None);
    }
}

/// Cut off anywhere, a file is an error, never a smaller mesh.
#[test]
fn ply_cut_off_anywhere_is_an_error() {
    for format in ["ascii", "binary_little_endian"] {
        let bytes = ply_bytes(format);
        for length in 0..bytes.len() {
            assert!(
                read_ply(&bytes[..length], true).is_err(),
                "{format} {length}"
            );
        }
    }
}

fn ply_error(header: &str, body: &[u8]) -> String {
    let mut bytes = format!("ply\n{header}\nend_header\n").into_bytes();
    bytes.extend_from_slice(body);
    read_ply(&bytes, true).expect_err("bad").to_string()
}

#[test]
fn bad_ply_files() {
    let xyz = "property float x\nproperty float y\nproperty float z";
    let list = "property list uchar int vertex_indices";
    let mesh = |format: &str, vertices: &str, faces: &str, body: &[u8]| {
        let header = format!(
            "format {format} 1.0\nelement vertex {vertices}\n{xyz}\nelement face {faces}\n{list}"
        );
        ply_error(&header, body)
    };
    for (message, expected) in [
        (
            mesh("ascii", "3", "1", b"0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
            "line 11: vertex 1 has the position (1, NaN, 0); expected finite coordinates",
        ),
        (
            mesh("ascii", "3", "1", b"0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
            "face 0: it refers to vertex -1; there are 3 vertices (counted from 0)",
        ),
        (
            mesh("ascii", "3", "1", b"0 0 0\n1 0 0\n0 1 0\n2 0 1\n"),
            "face 0: it has 2 corners; expected at least 3",
        ),
        (
            mesh("ascii", "3", "1", b"0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"),
            "line 11: \"x\" is not a number; expected what the header announces",
        ),
        (
            mesh("ascii", "3", "1", b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n7\n"),
            "line 14: 2 bytes follow the last element; the header announces too few elements or \
             the wrong types",
        ),
        (
            mesh("ascii", "3", "0", b"0 0 0\n1 0 0\n0 1 0\n"),
            "the file has no faces; expected a mesh with at least one triangle",
        ),
        (
            mesh("ascii", "3", "2", b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "line 14: the file ends within face 1 of 2; the file is cut off or its header is wrong",
        ),
        // Counts that would fill the memory are refused before it is reserved.
        (
            mesh("binary_little_endian", "1000000000000000000", "1", &[0; 40]),
            "byte 187: the header announces 1000000000000000000 elements \"vertex\", which take at \
             least 12000000000000000000 bytes, but 40 bytes are left; the file is cut off or its \
             header is wrong",
        ),
        (
            mesh("binary_little_endian", "0", "1", &[255, 0, 0, 0, 0]),
            "byte 174: the file ends within face 0 of 1; the file is cut off or its header is wrong",
        ),
        (
            ply_error(
                "format ascii 1.0\nelement vertex 1\nproperty float x",
                b"1\n",
            ),
            "the vertices have no positions; expected the properties x, y and z in the header",
        ),
        (
            ply_error(
                &format!("format ascii 1.0\nelement vertex 1\n{xyz}"),
                b"1 1 1\n",
            ),
            "the file has no faces; expected \"element face COUNT\" in the header",
        ),
        (
            ply_error("format ascii 1.0\nelement face 1\nproperty int a", b"1\n"),
            "the faces have no list of corners; expected \"property list uchar int \
             vertex_indices\" in the header",
        ),
        (
            ply_error("format ascii 1.0\nelement tristrips 0", b""),
            "the file has triangle strips; expected faces; convert the strips to triangles",
        ),
        (
            ply_error("element vertex 1", b""),
            "line 3: the header has \"end_header\"; expected a format before it",
        ),
        (
            ply_error("format ascii 2.0", b""),
            "line 2: the header has \"format ascii 2.0\"; expected one format, of version 1.0",
        ),
        (
            ply_error("format ascii 1.0\nelement vertex -1", b""),
            "line 3: the header has \"element vertex -1\"; expected a count",
        ),
        (
            ply_error("format ascii 1.0\nelement v 1\nproperty quad x", b""),
            "line 4: unknown type \"quad\"; expected char, uchar, short, ushort, int, uint, float \
             or double",
        ),
    ] {
        assert_eq!(message, expected);
    }
    assert_eq!(
        read_ply(b"solid cube\n", true)
            .expect_err("bad")
            .to_string(),
        "line 1: the file is not a PLY file; expected \"ply\" in the first line"
    );
}

/// Normals, flat and smooth, under transforms that mirror and flips, against
/// what Mitsuba 3.9.1 computes for the same square.
#[test]
fn mesh_normals_in_the_world() {
    let normals = |more: &str| {
        let scene = load(&scene(&format!(
            "<shape type=\"obj\"><string name=\"filename\" value=\"square.obj\"/>{more}</shape>"
        )));
        let shape = &scene.shapes[0];
        let face = shape.mesh.face_cross(0).normalized();
        (face, shape.normals.clone())
    };
    let mirror = "<transform name=\"to_world\"><scale x=\"-1\"/></transform>";
    let flip = "<boolean name=\"flip_normals\" value=\"true\"/>";
    let flat = "<boolean name=\"face_normals\" value=\"true\"/>";
    let up = Vec3::new(0.0, 0.0, 1.0);
    let smooth = |n: Vec3| ShadingNormals::Computed(vec![n; 4]);
    assert_eq!(normals(""), (up, smooth(up)));
    // Computed from the mirrored triangles, so a mirror turns the front.
    assert_eq!(normals(mirror), (-up, smooth(-up)));
    assert_eq!(normals(flip), (-up, smooth(-up)));
    assert_eq!(normals(flat), (up, ShadingNormals::Face));
    assert_eq!(
        normals(&format!("{flat}{flip}")),
        (-up, ShadingNormals::Face)
    );
}

/// Given normals decide which side is the front, whatever the winding.
#[test]
fn given_normals_decide_the_front() {
    for (plugin, file) in [("obj", "given_normals.obj"), ("ply", "given_normals.ply")] {
        for (more, side) in [
            ("", -1.0),
            // The normal is transformed as a normal: it stays on its side.
            (
                "<transform name=\"to_world\"><scale x=\"-1\"/></transform>",
                -1.0,
            ),
            (
                "<transform name=\"to_world\"><scale z=\"-1\"/></transform>",
                1.0,
            ),
            ("<boolean name=\"flip_normals\" value=\"true\"/>", 1.0),
        ] {
            let scene = load(&scene(&format!(
                "<shape type=\"{plugin}\"><string name=\"filename\" value=\"{file}\"/>{more}</shape>"
            )));
            let shape = &scene.shapes[0];
            let n = Vec3::new(0.0, 0.0, side);
            assert_eq!(
                shape.normals,
                ShadingNormals::Given(vec![n; 3]),
                "{file} {more}"
            );
            assert_eq!(shape.mesh.face_cross(0).normalized(), n, "{file} {more}");
        }
    }
}
