//! The readers as functions of bytes, any bytes: each reads or refuses them, and
//! what it reads is usable. They return true if they could read. Tests damage files for them, and so do the fuzz
//! targets in `fuzz/`, which share this file.

use std::path::Path;

use capwalk_math::Vec3;
use capwalk_scene_io::mesh::{
    GltfChoice, MeshFile, MeshFileError, read_gltf, read_obj, read_ply, read_serialized,
};
use capwalk_scene_io::{Loaded, load_scene_str};

pub fn obj(bytes: &[u8]) -> bool {
    with_and_without_normals(|want_normals| read_obj(bytes, want_normals))
}

pub fn ply(bytes: &[u8]) -> bool {
    with_and_without_normals(|want_normals| read_ply(bytes, want_normals))
}

/// The first mesh and the second.
pub fn serialized(bytes: &[u8]) -> bool {
    let read = |index| {
        with_and_without_normals(|want_normals| read_serialized(bytes, index, want_normals))
    };
    [read(0), read(1)].contains(&true)
}

/// Whatever is there if it is one, and the first primitive of the first mesh.
pub fn gltf(bytes: &[u8]) -> bool {
    let beside = |_: &str| Ok(vec![0; 64]);
    let first = GltfChoice {
        primitive: Some(0),
        ..GltfChoice::default()
    };
    let read = |choice| {
        with_and_without_normals(|want_normals| read_gltf(bytes, choice, want_normals, &beside))
    };
    [read(&GltfChoice::default()), read(&first)].contains(&true)
}

/// A scene in a folder with the files that it may name.
pub fn scene_in(folder: &Path, bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    match load_scene_str(&text, folder, "scene.xml", &[]) {
        Ok(Loaded { scene, .. }) => {
            scene.check().expect("what is read is usable");
            for shape in &scene.shapes {
                unit(shape.normals.per_vertex().unwrap_or_default());
            }
            true
        }
        Err(error) => {
            let message = error.to_string();
            assert!(message.contains(".xml:"), "{message}");
            if let Some(position) = error.position() {
                let span = &position.span;
                assert!(span.start <= span.end, "{message}");
            }
            false
        }
    }
}

fn with_and_without_normals(read: impl Fn(bool) -> Result<MeshFile, MeshFileError>) -> bool {
    [read(false), read(true)].map(usable).contains(&true)
}

/// True if there is a mesh; then all its parts must fit each other.
fn usable(read: Result<MeshFile, MeshFileError>) -> bool {
    let file = match read {
        Ok(file) => file,
        Err(error) => {
            let fault = error.fault();
            assert!(
                !fault.message.is_empty() && !fault.help.is_empty(),
                "{error}"
            );
            return false;
        }
    };
    let mesh = &file.mesh;
    mesh.check().expect("what is read is usable");
    let vertices = mesh.positions.len();
    unit(file.normals.as_deref().unwrap_or_default());
    for uv in file.uvs.iter().flatten() {
        assert!(uv.iter().all(|x| x.is_finite()), "{uv:?}");
    }
    assert!(file.normals.is_none_or(|normals| normals.len() == vertices));
    assert!(file.uvs.is_none_or(|uvs| uvs.len() == vertices));
    for attribute in &file.attributes {
        let rows = match attribute.name.starts_with("face_") {
            true => mesh.faces.len(),
            false => vertices,
        };
        assert_eq!(attribute.data.len(), rows * attribute.channels);
    }
    true
}

fn unit(normals: &[Vec3]) {
    for normal in normals {
        assert!((normal.length() - 1.0).abs() < 1e-12, "{normal:?}");
    }
}
