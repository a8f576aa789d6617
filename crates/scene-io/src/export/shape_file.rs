//! A shape as the mesh of a file.

use std::collections::HashMap;

use capwalk_geometry::Mesh;
use capwalk_scene::{Scene, ShadingNormals, Shape, Texture};

use crate::mesh::{FileAttribute, MeshFile};

/// The mesh with its attributes; with its normals if they were given with the mesh, computed ones
/// are computed again by whoever loads the file.
///
/// A vertex to which faces give different texture coordinates is there once for each of them.
pub(super) fn mesh_file(scene: &Scene, shape: &Shape) -> MeshFile {
    let (vertices, faces) = split(shape);
    let of_vertices = || vertices.iter().map(|&(vertex, _)| vertex as usize);
    let positions = &shape.mesh.positions;
    let attributes = shape.attributes.iter().map(|attribute| {
        let texture = scene.texture(attribute.texture);
        FileAttribute {
            name: attribute.name.clone(),
            channels: texture.channels,
            data: match attribute.name.starts_with("face_") {
                true => texture.data.clone(),
                false => of_vertices()
                    .flat_map(|vertex| texel(texture, vertex).iter().copied())
                    .collect(),
            },
            is_integer: false,
        }
    });
    MeshFile {
        name: None,
        normals: match &shape.normals {
            ShadingNormals::Given(normals) => Some(of_vertices().map(|i| normals[i]).collect()),
            ShadingNormals::Face | ShadingNormals::Computed(_) => None,
        },
        uvs: vertices.iter().map(|&(_, uv)| uv).collect(),
        attributes: attributes.collect(),
        mesh: Mesh {
            positions: of_vertices().map(|i| positions[i]).collect(),
            faces,
        },
        warnings: Vec::new(),
    }
}

fn texel(texture: &Texture, index: usize) -> &[f64] {
    &texture.data[index * texture.channels..][..texture.channels]
}

/// A vertex of the file: one of the mesh, with texture coordinates if there
/// are any.
type Vertex = (u32, Option<[f64; 2]>);

/// The vertices and the faces of the file. Vertices keep their places; further
/// texture coordinates of a vertex come behind all of them.
fn split(shape: &Shape) -> (Vec<Vertex>, Vec<[u32; 3]>) {
    let count = shape.mesh.positions.len();
    let mut vertices: Vec<Vertex> = (0..count as u32).map(|vertex| (vertex, None)).collect();
    let mut faces = shape.mesh.faces.clone();
    let Some(uvs) = &shape.uvs else {
        return (vertices, faces);
    };
    let mut further: HashMap<(u32, [u64; 2]), u32> = HashMap::new();
    for (face, corners) in faces.iter_mut().zip(uvs) {
        for (index, &uv) in face.iter_mut().zip(corners) {
            let vertex = *index;
            match vertices[vertex as usize].1 {
                None => vertices[vertex as usize].1 = Some(uv),
                Some(first) if first == uv => {}
                Some(_) => {
                    let key = (vertex, uv.map(f64::to_bits));
                    *index = *further.entry(key).or_insert_with(|| {
                        vertices.push((vertex, Some(uv)));
                        vertices.len() as u32 - 1
                    });
                }
            }
        }
    }
    // Vertices that no face uses.
    for (_, uv) in &mut vertices {
        uv.get_or_insert([0.0; 2]);
    }
    (vertices, faces)
}
