//! A room as Blender exports it, in one `.glb`: meshes that nodes place, textured and plain
//! metallic-roughness materials, emission, the lights of `KHR_lights_punctual`, and a camera.
//! `tests/parity/gltf_room.xml` is the same room for Mitsuba.

use std::path::Path;

use capwalk_scene_io::mesh::{MeshFile, read_ply};
use serde_json::{Value, json};

use crate::gltf_file::Document;

/// A turn about an axis by so many degrees, as a quaternion.
fn turn(axis: [f64; 3], degrees: f64) -> Value {
    let (sin, cos) = (0.5 * degrees.to_radians()).sin_cos();
    let [x, y, z] = axis.map(|component| component * sin);
    json!([x, y, z, cos])
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];

/// The square from -1 to 1 at z = 0, with its front towards +z and the image upright.
fn square(document: &mut Document) -> Value {
    let corners = [
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
    ];
    let uvs = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    json!({
        "attributes": {
            "POSITION": document.vectors(&corners),
            "NORMAL": document.vectors(&[[0.0, 0.0, 1.0]; 4]),
            "TEXCOORD_0": document.vectors(&uvs),
        },
        "indices": document.indices(&[0, 1, 2, 0, 2, 3]),
    })
}

/// A mesh of flat triangles.
fn flat(document: &mut Document, file: &MeshFile) -> Value {
    let positions: Vec<[f64; 3]> = file.mesh.positions.iter().map(|p| p.to_array()).collect();
    let corners = file.mesh.faces.as_flattened().iter();
    let indices: Vec<u16> = corners.map(|&corner| corner as u16).collect();
    json!({
        "attributes": {"POSITION": document.vectors(&positions)},
        "indices": document.indices(&indices),
    })
}

/// The room; `parity` is the folder of the files that Mitsuba's scene names.
pub fn room(parity: &Path) -> (Document, Value) {
    let read = |name: &str| std::fs::read(parity.join(name)).expect(name);
    let mut document = Document::default();
    let square = square(&mut document);
    let bowl = read_ply(&read("bowl.ply"), false).expect("a mesh");
    let bowl = flat(&mut document, &bowl);
    let with = |primitive: &Value, material: u32| {
        let mut primitive = primitive.clone();
        primitive["material"] = material.into();
        json!({"primitives": [primitive]})
    };
    let materials = json!([
        {"name": "Floor", "doubleSided": true, "pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 0.8}},
        {"name": "Panel", "doubleSided": true, "pbrMetallicRoughness": {
            "baseColorFactor": [0.8, 0.7, 0.6, 1.0], "metallicRoughnessTexture": {"index": 1}},
            "normalTexture": {"index": 2}},
        {"name": "Bowl", "doubleSided": true, "extensions": {"KHR_materials_ior": {"ior": 1.45}},
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.9, 0.6, 0.2, 1.0], "metallicFactor": 0.7, "roughnessFactor": 0.35}},
        {"name": "Screen", "doubleSided": true, "alphaMode": "BLEND", "pbrMetallicRoughness": {
            "baseColorFactor": [0.2, 0.5, 0.3, 0.6], "metallicFactor": 0, "roughnessFactor": 0.5}},
        {"name": "Lamp", "emissiveFactor": [1.0, 0.9, 0.75],
            "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 6.0}},
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.0, 0.0, 0.0, 1.0], "metallicFactor": 0}},
        {"name": "Sign", "emissiveFactor": [1.0, 1.0, 1.0], "emissiveTexture": {"index": 0},
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.1, 0.1, 0.1, 1.0], "metallicFactor": 0, "roughnessFactor": 1}},
    ]);
    let meshes: Vec<Value> = (0..6)
        .map(|material| with(if material == 2 { &bowl } else { &square }, material))
        .collect();
    let light = |index: u32| json!({"KHR_lights_punctual": {"light": index}});
    let nodes = json!([
        {"name": "Tripod", "translation": [0.2, 2.0, 4.8], "children": [1]},
        {"name": "Camera", "camera": 0, "rotation": turn(X, -18.0)},
        {"name": "Floor", "mesh": 0, "rotation": turn(X, -90.0), "scale": [3, 3, 3]},
        {"name": "Panel", "mesh": 1, "rotation": turn(Y, 25.0), "translation": [-0.9, 0.8, -1.0],
            "scale": [0.9, 0.8, 1]},
        {"name": "Bowl", "mesh": 2, "translation": [0.7, 0.55, 0.3], "rotation": turn(X, -40.0),
            "scale": [0.6, 0.5, 0.6]},
        {"name": "Screen", "mesh": 3, "rotation": turn(Y, -30.0), "translation": [0.3, 0.4, 1.4],
            "scale": [0.4, 0.4, 1]},
        {"name": "Lamp", "mesh": 4, "rotation": turn(X, 75.0), "translation": [-0.8, 3.0, 0.5],
            "scale": [0.8, 0.6, 1]},
        {"name": "Sign", "mesh": 5, "rotation": turn(Y, -50.0), "translation": [1.6, 0.9, -0.9],
            "scale": [0.5, 0.4, 1]},
        {"name": "Bulb", "translation": [-1.5, 1.2, 0.9], "extensions": light(0)},
        {"name": "Spot", "translation": [0.5, 3.0, 1.0], "rotation": turn(X, -100.0),
            "extensions": light(1)},
        {"name": "Sun", "rotation": turn(X, -50.0), "extensions": light(2)},
    ]);
    let mut json = document.json(meshes.into(), nodes);
    json["materials"] = materials;
    json["cameras"] = json!([{"type": "perspective", "perspective": {
        "yfov": 32_f64.to_radians(), "aspectRatio": 1.0, "znear": 0.1, "zfar": 100.0}}]);
    json["extensions"] = json!({"KHR_lights_punctual": {"lights": [
        {"type": "point", "color": [1.0, 0.5, 0.25], "intensity": 2.0},
        {"type": "spot", "intensity": 12.0, "spot": {
            "innerConeAngle": 8_f64.to_radians(), "outerConeAngle": 20_f64.to_radians()}},
        {"type": "directional", "color": [0.4, 0.5, 0.8], "intensity": 0.5},
    ]}});
    json["extensionsUsed"] = json!([
        "KHR_lights_punctual",
        "KHR_materials_emissive_strength",
        "KHR_materials_ior"
    ]);
    let views: Vec<usize> = ["colours.png", "rough.png", "normals.png"]
        .map(|name| document.view(&read(name)))
        .into();
    json["images"] = views
        .iter()
        .map(|view| json!({"bufferView": view, "mimeType": "image/png"}))
        .collect();
    json["textures"] = json!([{"source": 0}, {"source": 1}, {"source": 2}]);
    document.complete(&mut json);
    (document, json)
}
