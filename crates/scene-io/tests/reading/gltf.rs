//! glTF meshes, as bytes and in scenes.

use std::path::PathBuf;

use capwalk_math::{Affine, Vec3};
use capwalk_scene::{ShadingNormals, Shape};
use capwalk_scene_io::mesh::{GltfChoice, GltfName, read_gltf, read_obj};
use serde_json::json;

use crate::common::*;
use crate::gltf_file::*;

/// The sheet as OBJ, without colours.
fn bent_as_obj() -> String {
    let mut text = String::new();
    for ([p, n], uv) in POSITIONS
        .into_iter()
        .zip(NORMALS)
        .map(|(p, n)| [p, n])
        .zip(UVS)
    {
        text += &format!(
            "v {} {} {}\nvn {} {} {}\n",
            p[0], p[1], p[2], n[0], n[1], n[2]
        );
        text += &format!("vt {} {}\n", uv[0], uv[1]);
    }
    text + "f 1/1/1 2/2/2 3/3/3 4/4/4\n"
}

/// Writes a file for one test, and the shape that a scene makes of it.
fn shape_of(name: &str, bytes: &[u8], properties: &str) -> Shape {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).expect("a folder for temporary files");
    let plugin = if name.ends_with("obj") { "obj" } else { "gltf" };
    let scene = load(&scene(&format!(
        "<shape type=\"{plugin}\" id=\"s\"><string name=\"filename\" value=\"{}\"/>{properties}\
         </shape>",
        path.display()
    )));
    Shape::clone(&scene.shapes[0])
}

/// What must be equal where numbers were multiplied in another order.
fn assert_same(a: &Shape, b: &Shape) {
    assert_eq!(a.mesh.faces, b.mesh.faces);
    assert_eq!(a.uvs, b.uvs);
    let near = |a: &[Vec3], b: &[Vec3]| {
        assert_eq!(a.len(), b.len());
        let apart = a.iter().zip(b).map(|(a, b)| (*a - *b).length());
        assert!(apart.into_iter().all(|d| d < 1e-14), "{a:?} {b:?}");
    };
    near(&a.mesh.positions, &b.mesh.positions);
    match (&a.normals, &b.normals) {
        (ShadingNormals::Given(a), ShadingNormals::Given(b)) => near(a, b),
        (ShadingNormals::Face, ShadingNormals::Face) => {}
        other => panic!("{other:?}"),
    }
}

/// One mesh as OBJ under a `to_world`, and as glTF under nodes: the same shape,
/// in all three forms of glTF.
#[test]
fn the_same_mesh_as_obj_and_as_gltf() {
    // 2 acos(0.8), about x.
    let to_world = "<boolean name=\"flip_tex_coords\" value=\"false\"/><transform \
        name=\"to_world\"><scale x=\"2\" z=\"-0.5\"/><rotate x=\"1\" \
        angle=\"73.739795291688042\"/><translate x=\"0.5\" y=\"1\" z=\"-2\"/></transform>";
    let (document, json) = bent();
    let obj = shape_of("bent.obj", bent_as_obj().as_bytes(), to_world);
    let mut split = json.clone();
    split["buffers"][0]["uri"] = "bent%20sheet.bin".into();
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(folder.join("bent sheet.bin"), &document.buffer).expect("written");
    for (name, bytes) in [
        ("embedded.gltf", document.embedded(json.clone())),
        ("bent.glb", document.binary(&json)),
        ("split.gltf", split.to_string().into_bytes()),
    ] {
        let gltf = shape_of(name, &bytes, "");
        assert_same(&gltf, &obj);
        let [colours] = &gltf.attributes[..] else {
            panic!("one attribute")
        };
        assert_eq!(colours.name, "vertex_color");
    }
    // Without normals glTF is flat, and a node that mirrors keeps the front.
    let mut without = json.clone();
    let attributes = &mut without["meshes"][0]["primitives"][0]["attributes"];
    attributes
        .as_object_mut()
        .expect("an object")
        .remove("NORMAL");
    let gltf = shape_of("flat.gltf", &document.embedded(without), "");
    let flat = format!("{to_world}<boolean name=\"face_normals\" value=\"true\"/>");
    let mirrored = "<boolean name=\"flip_normals\" value=\"true\"/>";
    assert_same(
        &gltf,
        &shape_of("flat.obj", bent_as_obj().as_bytes(), &(flat + mirrored)),
    );
}

#[test]
fn what_a_file_holds() {
    let (document, json) = bent();
    let file = any(&document.embedded(json));
    assert_eq!(file.name.as_deref(), Some("leaf"));
    assert_eq!(file.warnings, Vec::<String>::new());
    assert_eq!(file.uvs.expect("they are there"), UVS);
    let colours = COLOURS.map(|[r, g, b, _]| [r, g, b]);
    assert_eq!(file.attributes[0].data, colours.as_flattened());
    assert!(!file.attributes[0].is_integer);
    // A quarter turn and a half: as a matrix, column after column.
    let matrix = Affine::translate(Vec3::new(1.0, 2.0, 3.0))
        * Affine::rotate(Vec3::new(0.0, 0.0, 1.0), 0.3)
        * Affine::scale(Vec3::new(2.0, 1.0, 1.0));
    let mut numbers = Vec::new();
    for column in 0..3 {
        numbers.extend(matrix.rows.map(|row| [row.x, row.y, row.z][column]));
        numbers.push(0.0);
    }
    numbers.extend(matrix.translation.to_array());
    numbers.push(1.0);
    let (document, mut json) = bent();
    json["nodes"] = json!([{"mesh": 0, "matrix": numbers}]);
    json["scenes"] = json!([{"nodes": [0]}]);
    let file = any(&document.embedded(json));
    assert_eq!(file.name.as_deref(), Some("sheet"));
    for (read, given) in file.mesh.positions.iter().zip(POSITIONS) {
        assert!((*read - matrix.point(Vec3::from(given))).length() < 1e-14);
    }
    // Without scenes a mesh is where it is.
    let (document, mut json) = bent();
    json.as_object_mut().expect("an object").remove("scenes");
    let file = any(&document.embedded(json));
    let as_given = POSITIONS.map(Vec3::from);
    assert_eq!(file.mesh.positions, as_given);
    let obj = read_obj(bent_as_obj().as_bytes(), true).expect("it is good");
    assert_eq!(file.normals, obj.normals);
}

/// Numbers in other types, interleaved, as strips and without indices.
#[test]
fn other_ways_to_say_it() {
    let mut document = Document::default();
    // A position (normalised to 32767) and a colour (bytes) take turns.
    let mut bytes = Vec::new();
    for [x, y, z] in [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, 1.0, -1.0],
    ] {
        for number in [x, y, z] {
            bytes.extend(((number * 32767.0) as i16).to_le_bytes());
        }
        bytes.extend([0, 0, 255, 51, 0, 255]);
    }
    let positions = document.accessor("VEC3", 5122, 4, &bytes);
    let colours = document.accessor("VEC3", 5121, 4, &[]);
    let mut json = document.json(
        json!([{"primitives": [{
            "attributes": {"POSITION": positions, "COLOR_0": colours, "_HEAT": 0, "TEXCOORD_1": 0},
            "mode": 5
        }]}]),
        json!([{"mesh": 0}]),
    );
    json["bufferViews"][0]["byteStride"] = 12.into();
    for (index, offset) in [(0, 0), (1, 8)] {
        let accessor = &mut json["accessors"][index];
        accessor["bufferView"] = 0.into();
        accessor["byteOffset"] = offset.into();
        accessor["normalized"] = true.into();
    }
    let file = any(&document.binary(&json));
    assert_eq!(file.mesh.positions[3], Vec3::new(1.0, 1.0, -1.0));
    assert_eq!(file.mesh.faces, [[0, 1, 2], [1, 3, 2]]);
    assert_eq!(file.attributes[0].data[..3], [1.0, 0.2, 0.0]);
    assert_eq!(file.warnings, ["has TEXCOORD_1, _HEAT, which are not read"]);
    assert_eq!((file.name, file.normals), (None, None));
}

/// An accessor that takes one of its elements from elsewhere, and wrong ones.
#[test]
fn sparse_accessors() {
    let with = |index: u8, count: usize| {
        let (mut document, mut json) = bent();
        let moved = [7.0_f32, 8.0, 9.0].map(f32::to_le_bytes);
        let (indices, values) = (document.view(&[index]), document.view(moved.as_flattened()));
        document.complete(&mut json);
        json["accessors"][0]["sparse"] = json!({
            "count": count,
            "indices": {"bufferView": indices, "componentType": 5121},
            "values": {"bufferView": values}
        });
        json["nodes"] = json!([{"mesh": 0}]);
        json["scenes"] = json!([{"nodes": [0]}]);
        document.embedded(json)
    };
    let positions = any(&with(2, 1)).mesh.positions;
    let mut expected = POSITIONS.map(Vec3::from);
    assert_ne!(positions, expected);
    expected[2] = Vec3::new(7.0, 8.0, 9.0);
    assert_eq!(positions, expected);
    for (count, expected) in [
        (0, "accessors[0].sparse: it replaces 0 elements of 4; "),
        (
            2,
            "accessors[0].sparse: 2 elements of 1 bytes, 1 apart from byte 0 on, are announced",
        ),
        (5, "accessors[0].sparse: it replaces 5 elements of 4; "),
    ] {
        let message = refused(&with(2, count), &GltfChoice::default());
        assert!(message.starts_with(expected), "{message}");
    }
}

#[test]
fn one_of_several() {
    let mut document = Document::default();
    let positions = document.vectors(&POSITIONS);
    let triangle = |corners: [u16; 3], document: &mut Document| {
        let indices = document.indices(&corners);
        json!({"attributes": {"POSITION": positions}, "indices": indices})
    };
    let [a, b, c] = [[0, 1, 2], [0, 2, 3], [1, 2, 3]].map(|f| triangle(f, &mut document));
    let json = document.json(
        json!([{"name": "two", "primitives": [a, b]}, {"primitives": [c]}]),
        json!([
            {"name": "left", "mesh": 0},
            {"mesh": 1},
            {"name": "right", "mesh": 0, "translation": [1.0, 0.0, 0.0]},
        ]),
    );
    let bytes = document.embedded(json);
    let choose = |node: Option<GltfName>, mesh: Option<GltfName>, primitive| GltfChoice {
        node,
        mesh,
        primitive,
    };
    let by_name = |name: &str| Some(GltfName::Name(name.into()));
    let by_index = |index| Some(GltfName::Index(index));
    let help = "choose one by \"node\", \"mesh\" and \"primitive\", for example <string \
                name=\"node\" value=\"NAME\"/> or <integer name=\"primitive\" value=\"0\"/>";
    assert_eq!(
        refused(&bytes, &GltfChoice::default()),
        format!(
            "it holds several meshes: node 0 \"left\", mesh 0 \"two\", primitive 0; node 0 \
             \"left\", mesh 0 \"two\", primitive 1; node 1, mesh 1, primitive 0; node 2 \
             \"right\", mesh 0 \"two\", primitive 0; node 2 \"right\", mesh 0 \"two\", primitive \
             1; {help}"
        )
    );
    assert_eq!(
        refused(&bytes, &choose(by_name("right"), None, None)),
        format!(
            "several of its meshes are meant: node 2 \"right\", mesh 0 \"two\", primitive 0; node \
             2 \"right\", mesh 0 \"two\", primitive 1; {help}"
        )
    );
    for missing in [
        choose(by_name("middle"), None, None),
        choose(None, by_index(2), None),
        choose(by_index(1), None, Some(1)),
    ] {
        assert_eq!(
            refused(&bytes, &missing),
            "its scene shows no such mesh; expected a mesh, placed by a node, with this name or \
             index"
        );
    }
    let faces = |choice: GltfChoice| {
        let file = read_gltf(&bytes, &choice, true, &nothing);
        let file = file.unwrap_or_else(|error| panic!("{error}"));
        (file.mesh.faces[0], file.mesh.positions[0].x)
    };
    assert_eq!(
        faces(choose(by_name("right"), None, Some(1))),
        ([0, 2, 3], 1.0)
    );
    assert_eq!(faces(choose(by_index(0), None, Some(0))), ([0, 1, 2], 0.0));
    assert_eq!(faces(choose(None, by_index(1), None)), ([1, 2, 3], 0.0));
    // In a scene.
    let properties = "<string name=\"node\" value=\"right\"/><integer name=\"primitive\" \
                      value=\"1\"/>";
    let shape = shape_of("several.gltf", &bytes, properties);
    assert_eq!(shape.mesh.faces, [[0, 2, 3]]);
    let properties = "<integer name=\"mesh\" value=\"1\"/>";
    assert_eq!(
        shape_of("mesh.gltf", &bytes, properties).mesh.faces,
        [[1, 2, 3]]
    );
}
