//! Meshes in files as arrays, and back.

use std::path::PathBuf;

use capwalk::Vec3;
use capwalk::scene::Mesh;
use capwalk::scene_io::mesh::{
    FileAttribute, GltfChoice, GltfName, MeshChoice, MeshFile, read_mesh as read,
    write_mesh as write,
};
use numpy::{
    IntoPyArray, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyReadonlyArrayDyn,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::watched::{detached, interruptible};
use crate::{arrays, errors};

/// A node or a mesh of a glTF file.
#[derive(FromPyObject)]
pub enum Name {
    Index(u32),
    Name(String),
}

impl From<Name> for GltfName {
    fn from(name: Name) -> Self {
        match name {
            Name::Index(index) => Self::Index(index),
            Name::Name(name) => Self::Name(name),
        }
    }
}

/// The arrays of a mesh by their names in dictionaries, its faces, and warnings.
type Read<'py> = (
    Vec<(String, Bound<'py, PyArrayDyn<f64>>)>,
    Bound<'py, PyArray2<u32>>,
    Vec<String>,
);

/// The mesh in a file.
#[pyfunction]
pub fn read_mesh(
    py: Python<'_>,
    path: PathBuf,
    node: Option<Name>,
    mesh: Option<Name>,
    primitive: Option<u32>,
    shape_index: Option<u32>,
) -> PyResult<Read<'_>> {
    let choice = MeshChoice {
        gltf: GltfChoice {
            node: node.map(Into::into),
            mesh: mesh.map(Into::into),
            primitive,
        },
        shape_index,
    };
    let found = interruptible(py, move || read(&path, &choice))?;
    let MeshFile {
        mesh: Mesh { positions, faces },
        normals,
        uvs,
        attributes,
        mut warnings,
        ..
    } = found.map_err(|error| errors::mesh(py, &error))?;
    let vectors = |vectors: &[Vec3]| vectors.iter().flat_map(|v| v.to_array()).collect();
    let mut read = vec![("positions".to_owned(), 3, vectors(&positions))];
    if let Some(normals) = normals {
        read.push(("normals".into(), 3, vectors(&normals)));
    }
    if let Some(uvs) = uvs {
        read.push(("uvs".into(), 2, uvs.into_flattened()));
    }
    for attribute in attributes {
        if attribute.is_integer {
            warnings.push(format!(
                "has whole numbers as \"{}\", which are taken as they are; colours are expected to \
                 be from 0 to 1",
                attribute.name
            ));
        }
        read.push((attribute.name, attribute.channels, attribute.data));
    }
    let made = read.into_iter().map(|(name, width, numbers)| {
        let shape = [numbers.len() / width, width];
        Ok((name, arrays::from_numbers(py, &shape, numbers)?))
    });
    let shape = [faces.len(), 3];
    let faces = faces.into_flattened().into_pyarray(py).reshape(shape)?;
    Ok((made.collect::<PyResult<_>>()?, faces, warnings))
}

/// Writes a mesh to a file. Its arrays are named as in dictionaries and have as many rows as they
/// must.
#[pyfunction]
pub fn write_mesh(
    py: Python<'_>,
    path: PathBuf,
    given: Vec<(String, PyReadonlyArrayDyn<'_, f64>)>,
    faces: PyReadonlyArray2<'_, u32>,
) -> PyResult<()> {
    let faces = faces.as_array();
    let mut file = MeshFile {
        name: None,
        mesh: Mesh {
            positions: Vec::new(),
            faces: faces
                .rows()
                .into_iter()
                .map(|f| [f[0], f[1], f[2]])
                .collect(),
        },
        normals: None,
        uvs: None,
        attributes: Vec::new(),
        warnings: Vec::new(),
    };
    for (name, array) in given {
        let numbers = arrays::to_numbers(&array);
        let vectors = || {
            let rows = numbers.as_chunks().0.iter();
            rows.map(|&row: &[f64; 3]| Vec3::from(row)).collect()
        };
        match name.as_str() {
            "positions" => file.mesh.positions = vectors(),
            "normals" => file.normals = Some(vectors()),
            "uvs" => file.uvs = Some(numbers.as_chunks().0.to_vec()),
            _ => file.attributes.push(FileAttribute {
                name,
                channels: array.shape()[1],
                data: numbers,
                is_integer: false,
            }),
        }
    }
    let written = detached(py, || write(&path, &file))?;
    written.map_err(|error| errors::mesh(py, &error))
}
