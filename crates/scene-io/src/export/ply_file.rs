//! A shape as a binary PLY file in double precision.

use std::collections::HashMap;
use std::io::{self, Write};

use capwalk_scene::{Pattern, Scene, ShadingNormals, Shape, Texture};

/// Writes positions and faces, normals if they were given with the mesh,
/// texture coordinates and attributes. Computed normals are computed again by
/// whoever loads the file.
///
/// A vertex to which faces give different texture coordinates is written once
/// for each of them.
pub(super) fn write(scene: &Scene, shape: &Shape, file: &mut impl Write) -> io::Result<()> {
    let mesh = &shape.mesh;
    let normals = match &shape.normals {
        ShadingNormals::Given(normals) => Some(normals),
        ShadingNormals::Face | ShadingNormals::Computed(_) => None,
    };
    let (vertices, faces) = split(shape);
    let attributes = shape.attributes.iter().map(|attribute| {
        let texture = scene.texture(attribute.texture);
        (attribute.name.as_str(), texture)
    });
    let (of_vertices, of_faces): (Vec<_>, Vec<_>) =
        attributes.partition(|(_, texture)| texture.pattern == Pattern::PerVertex);

    writeln!(file, "ply\nformat binary_little_endian 1.0")?;
    writeln!(file, "comment capwalk {}", env!("CARGO_PKG_VERSION"))?;
    writeln!(file, "element vertex {}", vertices.len())?;
    let mut names: Vec<String> = ["x", "y", "z"].map(String::from).to_vec();
    if normals.is_some() {
        names.extend(["nx", "ny", "nz"].map(String::from));
    }
    if shape.uvs.is_some() {
        names.extend(["u", "v"].map(String::from));
    }
    names.extend(of_vertices.iter().flat_map(|(name, t)| properties(name, t)));
    for name in names {
        writeln!(file, "property double {name}")?;
    }
    writeln!(file, "element face {}", mesh.faces.len())?;
    writeln!(file, "property list uchar int vertex_indices")?;
    for name in of_faces.iter().flat_map(|(name, t)| properties(name, t)) {
        writeln!(file, "property double {name}")?;
    }
    writeln!(file, "end_header")?;

    let mut numbers = |numbers: &[f64]| {
        let mut numbers = numbers.iter();
        numbers.try_for_each(|x| file.write_all(&x.to_le_bytes()))
    };
    for &(vertex, uv) in &vertices {
        let vertex = vertex as usize;
        numbers(&mesh.positions[vertex].to_array())?;
        if let Some(normals) = normals {
            numbers(&normals[vertex].to_array())?;
        }
        if let Some(uv) = uv {
            numbers(&uv)?;
        }
        for (_, texture) in &of_vertices {
            numbers(texel(texture, vertex))?;
        }
    }
    for (i, face) in faces.iter().enumerate() {
        file.write_all(&[3])?;
        for index in face {
            file.write_all(&index.to_le_bytes())?;
        }
        for (_, texture) in &of_faces {
            for x in texel(texture, i) {
                file.write_all(&x.to_le_bytes())?;
            }
        }
    }
    Ok(())
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

/// The names of properties that are read as an attribute with this name.
fn properties(name: &str, texture: &Texture) -> Vec<String> {
    let (_, rest) = name.split_once('_').unwrap_or(("", name));
    let with = |prefix: &str, endings: [&str; 3]| endings.map(|e| format!("{prefix}{e}")).to_vec();
    if texture.channels == 1 {
        return match rest.strip_suffix("_color") {
            Some(prefix) => vec![format!("{prefix}_r")],
            None => vec![format!("{rest}_0")],
        };
    }
    match rest.strip_suffix("_color") {
        Some(prefix) => with(&format!("{prefix}_"), ["r", "g", "b"]),
        None if rest == "color" => with("", ["r", "g", "b"]),
        None => with(&format!("{rest}_"), ["x", "y", "z"]),
    }
}
