//! Writes glTF files for tests.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use capwalk_scene_io::mesh::{GltfChoice, MeshFile, read_gltf};
use serde_json::{Value, json};

/// A file under construction: what is put into its buffer, and where.
#[derive(Clone, Default)]
pub struct Document {
    pub buffer: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Document {
    /// Adds numbers of an accessor as they are in memory; its index.
    pub fn accessor(&mut self, kind: &str, component: u32, count: usize, bytes: &[u8]) -> usize {
        let view = self.view(bytes);
        self.accessors.push(json!({
            "bufferView": view, "componentType": component, "count": count, "type": kind
        }));
        self.accessors.len() - 1
    }

    /// Adds bytes of any kind; the index of their view.
    pub fn view(&mut self, bytes: &[u8]) -> usize {
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.buffer.len(), "byteLength": bytes.len()
        }));
        self.buffer.extend(bytes);
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        self.views.len() - 1
    }

    /// Brings what was added later into the JSON.
    pub fn complete(&self, json: &mut Value) {
        json["accessors"] = self.accessors.clone().into();
        json["bufferViews"] = self.views.clone().into();
        json["buffers"][0]["byteLength"] = self.buffer.len().into();
    }

    /// Adds vectors in single precision; the index of their accessor.
    pub fn vectors<const N: usize>(&mut self, vectors: &[[f64; N]]) -> usize {
        let numbers = vectors.as_flattened().iter();
        let bytes: Vec<u8> = numbers.flat_map(|&x| (x as f32).to_le_bytes()).collect();
        self.accessor(&format!("VEC{N}"), 5126, vectors.len(), &bytes)
    }

    pub fn indices(&mut self, indices: &[u16]) -> usize {
        let bytes: Vec<u8> = indices.iter().flat_map(|i| i.to_le_bytes()).collect();
        self.accessor("SCALAR", 5123, indices.len(), &bytes)
    }

    /// The JSON, with these meshes and nodes; each node without a parent is in
    /// the scene.
    pub fn json(&self, meshes: Value, nodes: Value) -> Value {
        let list = nodes.as_array().expect("a list");
        let children = list.iter().filter_map(|n| n.get("children")?.as_array());
        let children: Vec<u64> = children.flatten().filter_map(Value::as_u64).collect();
        let roots = (0..list.len() as u64).filter(|i| !children.contains(i));
        let roots: Vec<u64> = roots.collect();
        json!({
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": roots}],
            "nodes": nodes,
            "meshes": meshes,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": self.buffer.len()}],
        })
    }

    /// A text with the buffer as base64.
    pub fn embedded(&self, mut json: Value) -> Vec<u8> {
        let data = BASE64_STANDARD.encode(&self.buffer);
        json["buffers"][0]["uri"] = format!("data:application/octet-stream;base64,{data}").into();
        json.to_string().into_bytes()
    }

    /// A `.glb`.
    pub fn binary(&self, json: &Value) -> Vec<u8> {
        self.binary_with(json.to_string().as_bytes())
    }

    /// A `.glb` with any text in place of the JSON.
    pub fn binary_with(&self, text: &[u8]) -> Vec<u8> {
        let mut text = text.to_vec();
        text.resize(text.len().next_multiple_of(4), b' ');
        let chunks = [(b"JSON", &text), (b"BIN\0", &self.buffer)];
        let mut bytes = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
        for (kind, chunk) in chunks {
            bytes.extend((chunk.len() as u32).to_le_bytes());
            bytes.extend(kind);
            bytes.extend(chunk);
        }
        let length = (bytes.len() as u32).to_le_bytes();
        bytes[8..12].copy_from_slice(&length);
        bytes
    }
}

/// Two triangles that are bent along their common edge, with everything that is
/// read, under a node that moves, turns, scales and mirrors.
pub fn bent() -> (Document, Value) {
    let mut document = Document::default();
    let attributes = json!({
        "POSITION": document.vectors(&POSITIONS),
        "NORMAL": document.vectors(&NORMALS),
        "TEXCOORD_0": document.vectors(&UVS),
        "COLOR_0": document.vectors(&COLOURS),
    });
    let indices = document.indices(&[0, 1, 2, 0, 2, 3]);
    let meshes = json!([{"name": "sheet", "primitives": [
        {"attributes": attributes, "indices": indices}
    ]}]);
    let nodes = json!([
        {"name": "hinge", "translation": [0.5, 1.0, -2.0], "children": [1]},
        {"name": "leaf", "mesh": 0, "rotation": [0.6, 0.0, 0.0, 0.8], "scale": [2.0, 1.0, -0.5]},
    ]);
    let json = document.json(meshes, nodes);
    (document, json)
}

pub const POSITIONS: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.25, 1.0, 0.5],
    [0.0, 1.0, 0.25],
];
pub const NORMALS: [[f64; 3]; 4] = [
    [0.0, 0.0, 1.0],
    [0.0, 0.0, 2.0],
    [0.0, 3.0, 4.0],
    [-0.5, 0.0, 1.0],
];
pub const UVS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.75], [0.25, 1.0]];
pub const COLOURS: [[f64; 4]; 4] = [
    [0.0, 0.25, 0.5, 1.0],
    [1.0, 1.0, 1.0, 1.0],
    [0.75, 0.0, 0.0, 0.5],
    [0.5, 0.5, 0.0, 0.0],
];

pub fn nothing(_: &str) -> Result<Vec<u8>, String> {
    Err("no file is expected".into())
}

pub fn any(bytes: &[u8]) -> MeshFile {
    let read = read_gltf(bytes, &GltfChoice::default(), true, &nothing);
    read.unwrap_or_else(|error| panic!("{error}"))
}

pub fn refused(bytes: &[u8], choice: &GltfChoice) -> String {
    let error = read_gltf(bytes, choice, true, &nothing).expect_err("bad");
    error.to_string()
}
