//! Damaged files are read or refused: nothing panics, nothing hangs, and nothing
//! reserves memory that the file does not pay for.

use serde_json::Value;

use crate::common::*;
use crate::damage::{Original, survive};
use crate::serialized::{file_of, triangle_and_square, written};
use crate::{gltf_file, readers};

fn read_scene(bytes: &[u8]) -> bool {
    readers::scene_in(&folder(), bytes)
}

#[test]
fn damaged_scenes() {
    let original = scene(
        "<path value=\".\"/>\
         <include filename=\"one_material.xml\"/><alias id=\"grey\" as=\"gray\"/>\
         <bsdf type=\"twosided\" id=\"m\"><bsdf type=\"diffuse\"><rgb name=\"reflectance\" \
         value=\"#ff8000\"/></bsdf><ref id=\"gray\"/></bsdf>\
         <shape type=\"obj\" id=\"s\"><string name=\"filename\" value=\"square.obj\"/>\
         <transform name=\"to_world\"><lookat origin=\"1 2 3\" target=\"0 0 0\" up=\"0 1 0\"/>\
         <rotate x=\"1\" angle=\"$w\"/><matrix value=\"1 0 0 0 1 0 0 0 1\"/></transform>\
         <ref id=\"m\"/><emitter type=\"area\"><spectrum name=\"radiance\" value=\"3\"/></emitter>\
         </shape><shape type=\"cube\"><boolean name=\"flip_normals\" value=\"true\"/></shape>",
    )
    .replace(
        "version=\"3.0.0\">",
        "version=\"3.0.0\"><default name=\"w\" value=\"16\"/>",
    )
    .replace(
        "\"perspective\"/>",
        "\"perspective\"><float name=\"fov\" value=\"40\"/><film type=\"hdrfilm\"><integer \
         name=\"width\" value=\"$w\"/><rfilter type=\"tent\"/></film><sampler \
         type=\"independent\"/></sensor>",
    );
    // The damage is of the interesting kind: some survive it, most do not.
    let others = scene(
        "<shape type=\"ply\"><string name=\"filename\" value=\"given_normals.ply\"/>\
         <transform name=\"to_world\"><scale x=\"2\" y=\"-1.5\" z=\"0.5\"/><translate y=\"1\"/>\
         </transform></shape><shape type=\"serialized\"><string name=\"filename\" \
         value=\"two.serialized\"/><integer name=\"shape_index\" value=\"0\"/><boolean \
         name=\"face_normals\" value=\"true\"/><bsdf type=\"principled\"><texture \
         name=\"base_color\" type=\"mesh_attribute\"><string name=\"name\" \
         value=\"vertex_color\"/></texture><float name=\"roughness\" value=\"0.3\"/></bsdf>\
         </shape><shape type=\"rectangle\"><boolean name=\"flip_normals\" value=\"true\"/>\
         <bsdf type=\"blendbsdf\"><float name=\"weight\" \
         value=\"0.25\"/><bsdf type=\"roughconductor\"><string name=\"material\" value=\"Au\"/>\
         <float name=\"alpha_u\" value=\"0.2\"/><float name=\"alpha_v\" value=\"0.3\"/></bsdf>\
         <bsdf type=\"plastic\"><string name=\"int_ior\" value=\"water\"/></bsdf></bsdf></shape>\
         <emitter type=\"spot\"><float name=\"cutoff_angle\" value=\"30\"/></emitter>",
    );
    let originals = [original, others];
    originals.iter().for_each(|text| drop(load(text)));
    let originals = originals.map(|text| Original::new(text, read_scene));
    let share = survive("scene.xml", originals.into(), 4000);
    assert!((0.003..0.5).contains(&share), "{share}");
}

#[test]
fn damaged_obj_meshes() {
    let originals = [
        "# mesh\no a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvn 0 0 1\n\
         f 1/1/1 2/1/1 3/1/1 4/1/1\nf -1/1/1 -2/1/1 -3/1/1\ns off\n",
        "v 0 0 0 1\r\nv 1\t0 0\nv 1 1 0 0.5 0.5 0.5\ng a b\nusemtl x\nvt 0.5\nvn 0 1 2\n\
         f -3//1 \\\n -2//1 3//-1\nf 1//1 2//1 3//1\n",
    ];
    let originals = originals.map(|text| Original::new(text, readers::obj));
    let share = survive("mesh.obj", originals.into(), 20_000);
    assert!((0.03..0.9).contains(&share), "{share}");
}

#[test]
fn damaged_ply_meshes() {
    let header = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\ncomment x\nelement vertex 3\nproperty float x\n\
             property float y\nproperty float z\nproperty list uchar uchar extra\n\
             property uchar a_r\nelement face 1\nproperty list uchar int vertex_indices\n\
             property double heat_x\nend_header\n"
        )
    };
    let text = format!(
        "{}0 0 0 0 1\n1 0 0 1 7 2\n0 1 0 0 3\n3 0 1 2 4\n",
        header("ascii")
    );
    let mut originals = vec![Original::new(text, readers::ply)];
    for format in ["binary_little_endian", "binary_big_endian"] {
        let is_big = format == "binary_big_endian";
        let order = |mut bytes: Vec<u8>| {
            if is_big {
                bytes.reverse();
            }
            bytes
        };
        let mut binary = header(format).into_bytes();
        for p in [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
            for x in p {
                binary.extend(order(x.to_le_bytes().to_vec()));
            }
            binary.extend([1, 9, 200]);
        }
        binary.push(3);
        for i in 0..3_i32 {
            binary.extend(order(i.to_le_bytes().to_vec()));
        }
        binary.extend(order(4.0_f64.to_le_bytes().to_vec()));
        originals.push(Original::new(binary, readers::ply));
    }
    let share = survive("mesh.ply", originals, 20_000);
    assert!((0.01..0.95).contains(&share), "{share}");
}

/// As files, and inside the deflated data, which a checksum guards.
#[test]
fn damaged_serialized_meshes() {
    let mut originals = Vec::new();
    for version in [3, 4] {
        let file = written(&triangle_and_square(), version);
        originals.push(Original::new(file, readers::serialized));
    }
    for mesh in triangle_and_square() {
        originals.push(Original {
            bytes: mesh.unpacked(4),
            wrap: |data| file_of(&[data.to_vec()], 4),
            read: readers::serialized,
        });
    }
    let share = survive("mesh.serialized", originals, 20_000);
    assert!((0.01..0.95).contains(&share), "{share}");
}

/// As files, the text with the buffer as it was, and the buffer with the text
/// as it was.
#[test]
fn damaged_gltf_meshes() {
    let (document, json) = gltf_file::bent();
    let originals = vec![
        Original::new(document.embedded(json.clone()), readers::gltf),
        Original::new(document.binary(&json), readers::gltf),
        Original {
            bytes: json.to_string().into_bytes(),
            wrap: |text| gltf_file::bent().0.binary_with(text),
            read: readers::gltf,
        },
        Original {
            bytes: document.buffer,
            wrap: |buffer| {
                let (mut document, json): (_, Value) = gltf_file::bent();
                document.buffer = buffer.to_vec();
                document.binary(&json)
            },
            read: readers::gltf,
        },
    ];
    let share = survive("mesh.gltf", originals, 20_000);
    assert!((0.01..0.95).contains(&share), "{share}");
}

/// Neither the parser of XML nor what comes after it may run out of stack.
#[test]
fn deep_nesting_is_refused() {
    let deep = format!("{HEAD}{}", "<bsdf type=\"twosided\">".repeat(100_000));
    assert!(try_load(&deep, &[]).is_err());
    let closed = format!("{deep}{}</scene>", "</bsdf>".repeat(100_000));
    assert!(try_load(&closed, &[]).is_err());
}

/// A chain of references is followed without recursion.
#[test]
fn long_chains_of_references() {
    let mut objects = String::new();
    for i in 0..20_000 {
        let next = i + 1;
        objects += &format!("<bsdf type=\"twosided\" id=\"b{i}\"><ref id=\"b{next}\"/></bsdf>");
    }
    objects += "<bsdf type=\"diffuse\" id=\"b20000\"/>";
    let error = message(&scene(&objects), &[]);
    assert!(error.contains("twosided"), "{error}");
}

/// Parameters that stand for others, and files that are none.
#[test]
fn damaged_parameters() {
    let parameters = scene(
        "<default name=\"a\" value=\"0.5\"/><default name=\"ab\" value=\"$a $a\"/>\
         <default name=\"file\" value=\"/dev/zero\"/><default name=\"abc\" value=\"$ab$ab$ab\"/>\
         <shape type=\"sphere\" id=\"$abc\"><float name=\"radius\" value=\"$a\"/>\
         <bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"$ab $a\"/></bsdf></shape>\
         <bsdf type=\"diffuse\" id=\"$file\"/>",
    );
    let device = parameters.replace(
        "<bsdf type=\"diffuse\" id=\"$file\"/>",
        "<bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\">\
         <string name=\"filename\" value=\"$file\"/></texture></bsdf>",
    );
    assert!(message(&device, &[]).contains("/dev/zero"));
    // The other one is no good file, but is to be damaged as well.
    let read_device = |bytes: &[u8]| {
        read_scene(bytes);
        true
    };
    let originals = vec![
        Original::new(parameters, read_scene),
        Original::new(device, read_device),
    ];
    survive("parameters.xml", originals, 4000);
}

/// Arrays of NumPy, whose header is a line of Python.
#[test]
fn damaged_arrays() {
    let plain = |descr: &str, shape: &str, bytes: usize| {
        let header = format!(
            "{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}          \n"
        );
        let mut file = b"\x93NUMPY\x01\x00".to_vec();
        file.extend((header.len() as u16).to_le_bytes());
        file.extend(header.bytes());
        file.resize(file.len() + bytes, 0);
        Original::new(file, read_array)
    };
    let originals = vec![plain("<f8", "(2, 3)", 48), plain("<f4", "(4, 3)", 48)];
    let share = survive("array.npy", originals, 4000);
    assert!((0.003..0.9).contains(&share), "{share}");
}

fn read_array(bytes: &[u8]) -> bool {
    let name = format!("capwalk-array-{}.npy", std::process::id());
    let path = std::env::temp_dir().join(name);
    std::fs::write(&path, bytes).expect("a folder for temporary files");
    capwalk_scene_io::read_velocities(&path).is_ok()
}
