//! A mesh as a binary PLY file in double precision.

use std::io::{self, Write};

use super::checked::{FileAttribute, MeshFile};

/// Writes what [`read_ply`](super::read_ply) reads as this mesh: positions and faces, and normals,
/// texture coordinates and attributes if there are any. A PLY file has no place for a name.
pub fn write_ply(mesh: &MeshFile, file: &mut impl Write) -> io::Result<()> {
    let (positions, faces) = (&mesh.mesh.positions, &mesh.mesh.faces);
    let (of_faces, of_vertices): (Vec<_>, Vec<_>) = mesh
        .attributes
        .iter()
        .partition(|attribute| attribute.name.starts_with("face_"));

    writeln!(file, "ply\nformat binary_little_endian 1.0")?;
    writeln!(file, "comment capwalk {}", env!("CARGO_PKG_VERSION"))?;
    writeln!(file, "element vertex {}", positions.len())?;
    let mut names: Vec<String> = ["x", "y", "z"].map(String::from).to_vec();
    if mesh.normals.is_some() {
        names.extend(["nx", "ny", "nz"].map(String::from));
    }
    if mesh.uvs.is_some() {
        names.extend(["u", "v"].map(String::from));
    }
    names.extend(
        of_vertices
            .iter()
            .flat_map(|attribute| properties(attribute)),
    );
    for name in names {
        writeln!(file, "property double {name}")?;
    }
    writeln!(file, "element face {}", faces.len())?;
    writeln!(file, "property list uchar int vertex_indices")?;
    for name in of_faces.iter().flat_map(|attribute| properties(attribute)) {
        writeln!(file, "property double {name}")?;
    }
    writeln!(file, "end_header")?;

    let write = |file: &mut dyn Write, numbers: &[f64]| {
        let mut numbers = numbers.iter();
        numbers.try_for_each(|x| file.write_all(&x.to_le_bytes()))
    };
    for (vertex, position) in positions.iter().enumerate() {
        write(file, &position.to_array())?;
        if let Some(normals) = &mesh.normals {
            write(file, &normals[vertex].to_array())?;
        }
        if let Some(uvs) = &mesh.uvs {
            write(file, &uvs[vertex])?;
        }
        for attribute in &of_vertices {
            write(file, element(attribute, vertex))?;
        }
    }
    for (i, face) in faces.iter().enumerate() {
        // The number of corners is in front of each face.
        file.write_all(&[3])?;
        for index in face {
            file.write_all(&index.to_le_bytes())?;
        }
        for attribute in &of_faces {
            write(file, element(attribute, i))?;
        }
    }
    Ok(())
}

/// The numbers of a vertex or a face.
fn element(attribute: &FileAttribute, index: usize) -> &[f64] {
    &attribute.data[index * attribute.channels..][..attribute.channels]
}

/// The names of properties that are read as an attribute with this name.
fn properties(attribute: &FileAttribute) -> Vec<String> {
    let name = attribute.name.as_str();
    let (_, rest) = name.split_once('_').unwrap_or(("", name));
    let with = |prefix: &str, endings: [&str; 3]| endings.map(|e| format!("{prefix}{e}")).to_vec();
    if attribute.channels == 1 {
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
