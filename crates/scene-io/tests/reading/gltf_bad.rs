//! glTF files that cannot be read, and what is said about them.

use capwalk_scene_io::mesh::{GltfChoice, read_gltf};
use serde_json::{Value, json};

use crate::gltf_file::*;

#[test]
fn cut_off_anywhere_is_an_error() {
    let (document, json) = bent();
    for bytes in [document.embedded(json.clone()), document.binary(&json)] {
        any(&bytes);
        for length in 0..bytes.len() {
            let cut = read_gltf(&bytes[..length], &GltfChoice::default(), true, &nothing);
            assert!(cut.is_err(), "{length} bytes");
        }
    }
    // The same of the buffer alone.
    for length in 0..document.buffer.len() {
        let mut cut = document.clone();
        cut.buffer.truncate(length);
        let message = refused(&cut.embedded(json.clone()), &GltfChoice::default());
        assert!(message.starts_with("buffers[0]: it announces"), "{message}");
    }
}

#[test]
fn what_is_not_read_is_named() {
    let with = |change: &dyn Fn(&mut Value)| {
        let (document, mut json) = bent();
        change(&mut json);
        refused(&document.embedded(json), &GltfChoice::default())
    };
    let primitive = |key: &str, value: Value| {
        with(&|json| json["meshes"][0]["primitives"][0][key] = value.clone())
    };
    let node = |key: &str, value: Value| with(&|json| json["nodes"][1][key] = value.clone());
    let draco = "KHR_draco_mesh_compression";
    for (message, expected) in [
        (
            primitive("extensions", json!({draco: {"bufferView": 0}})),
            "meshes[0].primitives[0]: the extension \"KHR_draco_mesh_compression\" is not read; \
             export the mesh without Draco compression",
        ),
        (
            with(&|json| json["extensionsRequired"] = json!(["KHR_materials_unlit", draco])),
            "extensionsRequired[1]: the extension \"KHR_draco_mesh_compression\" is not read; \
             export the file without it",
        ),
        (
            primitive("targets", json!([{"POSITION": 0}])),
            "meshes[0].primitives[0].targets: morph targets are not read; export the mesh as it \
             is to be seen, without morph targets",
        ),
        (
            with(&|json| {
                json["skins"] = json!([{"joints": [0]}]);
                json["nodes"][1]["skin"] = 0.into();
            }),
            "nodes[1].skin: skinned meshes are not read; export the mesh as it is to be seen, \
             without a skin",
        ),
        (
            node("extensions", json!({"EXT_mesh_gpu_instancing": {}})),
            "nodes[1]: the extension \"EXT_mesh_gpu_instancing\" is not read; export each copy as \
             a node",
        ),
        (
            primitive("mode", 0.into()),
            "accessors[4]: the primitive consists of points; expected triangles, triangle strips \
             or triangle fans",
        ),
        (
            with(&|json| {
                json["bufferViews"][0]["extensions"] = json!({"EXT_meshopt_compression": {}});
            }),
            "bufferViews[0]: it has the extension \"EXT_meshopt_compression\", which is not read; \
             export the mesh without compression",
        ),
    ] {
        assert_eq!(message, expected);
    }
}

#[test]
fn bad_files() {
    let with = |change: &dyn Fn(&mut Document, &mut Value)| {
        let (mut document, mut json) = bent();
        change(&mut document, &mut json);
        refused(&document.embedded(json), &GltfChoice::default())
    };
    let at = |pointer: &str, value: Value| {
        with(&|_, json| *json.pointer_mut(pointer).expect(pointer) = value.clone())
    };
    let number = |vertex: usize, value: f32| {
        with(&|document, _| {
            document.buffer[vertex..][..4].copy_from_slice(&value.to_le_bytes());
        })
    };
    let glb = |change: &dyn Fn(&mut Vec<u8>)| {
        let (document, json) = bent();
        let mut bytes = document.binary(&json);
        change(&mut bytes);
        refused(&bytes, &GltfChoice::default())
    };
    let normals = POSITIONS.as_flattened().len() * 4;
    let uvs = 2 * normals;
    let damaged = "the file is cut off or damaged";
    let allowed = "expected what glTF 2.0 allows; the file is cut off or damaged";
    let (document, mut json) = bent();
    let length = document.binary(&json).len();
    for (message, expected) in [
        (
            refused(b"solid cube", &GltfChoice::default()),
            "line 1: it is not JSON: expected value at line 1 column 1; expected a glTF 2.0 file, \
             .gltf or .glb"
                .to_owned(),
        ),
        (
            at("/asset/version", "1.0".into()),
            "asset.version: it is \"1.0\"; expected a glTF 2.0 file".into(),
        ),
        (
            glb(&|bytes| bytes[4] = 1),
            format!("its chunks: unsupported version; {damaged}; expected glTF 2.0"),
        ),
        (
            glb(&|bytes| bytes.push(0)),
            format!(
                "byte 8: {length} bytes are announced, but {} are there; {damaged}; expected glTF \
                 2.0",
                length + 1
            ),
        ),
        (
            glb(&|bytes| bytes[15] = 0x7f),
            format!(
                "its chunks: JSON chunk length exceeds that of slice; {damaged}; expected glTF 2.0"
            ),
        ),
        (
            at("/nodes/1/mesh", 7.into()),
            format!("nodes[1].mesh: it is 7, but there is no such entry; {allowed}"),
        ),
        (
            at("/meshes/0/primitives/0/attributes/POSITION", 9.into()),
            format!(
                "meshes[0].primitives[0].attributes.POSITION: it is 9, but there is no such \
                 entry; {allowed}"
            ),
        ),
        (
            at("/nodes/1/mesh", 4294967296_u64.into()),
            "nodes[1].mesh: it is 4294967296; expected a number of 32 bits".into(),
        ),
        (
            at("/accessors/0/count", 0.into()),
            "accessors[0].count: it is 0; expected at least 1".into(),
        ),
        (
            at("/nodes/1/mesh", json!([1])),
            format!(
                "nodes[1].mesh: invalid type: sequence, expected index into child of root; {damaged}"
            ),
        ),
        (
            at("/nodes/0/children", json!([1, 1])),
            "nodes[1]: several nodes have it as a child; expected a tree: each node with one \
             parent"
                .into(),
        ),
        (
            at("/nodes/0/children", json!([0])),
            "nodes[0]: several nodes have it as a child; expected a tree: each node with one \
             parent"
                .into(),
        ),
        (
            at("/nodes/1/scale", json!([1, 0, 1])),
            "nodes[1]: its transform cannot be inverted; scale by finite numbers other than 0"
                .into(),
        ),
        (
            at("/nodes/1/scale", json!([1, 1])),
            format!("nodes[1].scale: invalid length 2, expected an array of length 3; {damaged}"),
        ),
        (
            at("/nodes/1/rotation", json!([0, 0, 0, 0])),
            "nodes[1].rotation: the quaternion has the length 0; expected one of length 1".into(),
        ),
        (
            at("/scenes/0/nodes", json!([])),
            "its scene shows no mesh; expected a mesh, placed by a node, with this name or index"
                .into(),
        ),
        (
            at("/meshes/0/primitives/0/attributes", json!({})),
            "meshes[0].primitives[0]: the vertices have no positions; expected the attribute \
             POSITION; is the mesh compressed?"
                .into(),
        ),
        (
            at("/accessors/0/count", 5.into()),
            format!(
                "accessors[0]: 5 elements of 12 bytes, 12 apart from byte 0 on, are announced, \
                 but the view has 48 bytes; {damaged}"
            ),
        ),
        (
            at("/accessors/0/count", u64::MAX.into()),
            format!(
                "accessors[0]: 18446744073709551615 elements of 12 bytes, 12 apart from byte 0 \
                 on, are announced, but the view has 48 bytes; {damaged}"
            ),
        ),
        (
            at("/accessors/1/count", 3.into()),
            "accessors[1]: it has 3 elements, but there are 4 vertices; expected one for each \
             vertex"
                .into(),
        ),
        (
            at("/accessors/0/type", "MAT4".into()),
            "accessors[0]: its elements have 16 numbers; expected VEC3, 3 numbers each".into(),
        ),
        (
            at("/accessors/0/componentType", 5124.into()),
            format!("accessors[0].componentType: it is 5124; {allowed}"),
        ),
        (
            at("/bufferViews/0/byteLength", u64::MAX.into()),
            format!(
                "bufferViews[0]: 18446744073709551615 bytes from byte 0 on are announced, but the \
                 buffer has 204; {damaged}"
            ),
        ),
        (
            with(&|_, json| json["bufferViews"][0]["byteStride"] = 8.into()),
            format!("bufferViews[0].byteStride: it is 8, but an element takes 12 bytes; {damaged}"),
        ),
        (
            with(&|_, json| {
                json["accessors"][0]
                    .as_object_mut()
                    .expect("one")
                    .remove("bufferView");
            }),
            "accessors[0]: it has no \"bufferView\"; its numbers are all zero or compressed; \
             export the mesh without compression"
                .into(),
        ),
        (
            at("/buffers/0/byteLength", 1_000_000_000_000_u64.into()),
            format!("buffers[0]: it announces 1000000000000 bytes, but 204 are there; {damaged}"),
        ),
        (
            number(16, f32::NAN),
            "accessors[0]: vertex 1 has the position (1, NaN, 0); expected finite coordinates"
                .into(),
        ),
        (
            number(normals + 8, 0.0),
            "accessors[1]: normal 0 is (0, 0, 0); expected a finite vector that is not zero; \
             face_normals does without normals"
                .into(),
        ),
        (
            number(uvs + 12, f32::INFINITY),
            "accessors[2]: element 1 has the number inf; expected finite numbers".into(),
        ),
        (
            with(&|document, _| *document.buffer.iter_mut().nth_back(1).expect("an index") = 4),
            "accessors[4]: index 5 refers to vertex 4; there are 4 vertices (counted from 0)"
                .into(),
        ),
        (
            at("/meshes/0/primitives/0/indices", 0.into()),
            "accessors[0]: its elements have 3 numbers, or are normalized; expected SCALAR, an \
             index each"
                .into(),
        ),
        (
            at("/accessors/4/count", 5.into()),
            "accessors[4]: its triangles have 5 corners together; expected three for each \
             triangle"
                .into(),
        ),
    ] {
        assert_eq!(message, expected);
    }
    for (uri, expected) in [
        (
            "/dev/zero",
            "\"/dev/zero\" cannot be opened; expected the path of a file",
        ),
        (
            "gone.bin",
            "cannot read \"gone.bin\": no file is expected; put the file beside",
        ),
        (
            "data:,abc",
            "the data are not encoded as base64; expected data:application",
        ),
        ("data:;base64,A", "the data are not base64: "),
    ] {
        json["buffers"][0]["uri"] = uri.into();
        let message = refused(json.to_string().as_bytes(), &GltfChoice::default());
        let expected = format!("buffers[0].uri: {expected}");
        assert!(message.starts_with(&expected), "{message}");
    }
}
