//! A shape as a binary PLY file in double precision.

use std::io::{self, Write};

use capwalk_math::Vec3;
use capwalk_scene::{ShadingNormals, Shape};

/// Writes positions and faces, and normals if they were given with the mesh;
/// computed ones are computed again by whoever loads the file.
pub(super) fn write(shape: &Shape, file: &mut impl Write) -> io::Result<()> {
    let mesh = &shape.mesh;
    let normals = match &shape.normals {
        ShadingNormals::Given(normals) => Some(normals),
        ShadingNormals::Face | ShadingNormals::Computed(_) => None,
    };
    writeln!(file, "ply\nformat binary_little_endian 1.0")?;
    writeln!(file, "comment capwalk {}", env!("CARGO_PKG_VERSION"))?;
    writeln!(file, "element vertex {}", mesh.positions.len())?;
    let names = match normals {
        None => &["x", "y", "z"][..],
        Some(_) => &["x", "y", "z", "nx", "ny", "nz"],
    };
    for name in names {
        writeln!(file, "property double {name}")?;
    }
    writeln!(file, "element face {}", mesh.faces.len())?;
    writeln!(file, "property list uchar int vertex_indices")?;
    writeln!(file, "end_header")?;
    let vector = |v: Vec3, file: &mut dyn Write| {
        let components = v.to_array();
        components
            .iter()
            .try_for_each(|c| file.write_all(&c.to_le_bytes()))
    };
    for (i, &position) in mesh.positions.iter().enumerate() {
        vector(position, file)?;
        if let Some(normals) = normals {
            vector(normals[i], file)?;
        }
    }
    for face in &mesh.faces {
        file.write_all(&[3])?;
        for index in face {
            file.write_all(&index.to_le_bytes())?;
        }
    }
    Ok(())
}
