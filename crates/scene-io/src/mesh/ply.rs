//! Stanford PLY, as text or binary: positions, normals, texture coordinates,
//! polygons, and attributes of vertices and faces.

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

use super::checked::{FileAttribute, MeshFile, fan, finish, finite_position, unit_normal};
use super::error::{MeshFileError, MeshPlace};
use super::ply_attribute::{self, Group};
use super::ply_header::{self, Encoding, PlyElement, Scalar};

/// Names of the list that holds the indices of a face.
const CORNER_LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// The mesh in the bytes of a PLY file. Normals are read if `want_normals`.
pub fn read_ply(bytes: &[u8], want_normals: bool) -> Result<MeshFile, MeshFileError> {
    let header = ply_header::parse(bytes)?;
    let mut body = Body {
        bytes,
        position: header.body,
        format: header.format,
        line: header.lines + 1,
    };
    let is_vertex = |element: &&PlyElement| element.name == "vertex";
    let vertex_count = header
        .elements
        .iter()
        .find(is_vertex)
        .map_or(0, |e| e.count);
    let (mut vertices, mut faces) = (None, None);
    let mut warnings = Vec::new();
    for element in &header.elements {
        body.announced(element)?;
        match element.name.as_str() {
            "vertex" => vertices = Some(read_vertices(&mut body, element, want_normals)?),
            "face" => faces = Some(read_faces(&mut body, element, vertex_count)?),
            "tristrips" => {
                return Err(MeshFileError::unsupported(
                    MeshPlace::File,
                    "the file has triangle strips",
                    "expected faces; convert the strips to triangles",
                ));
            }
            name => {
                let count = element.count;
                warnings.push(format!(
                    "has {count} elements \"{name}\", which are not read"
                ));
                skip(&mut body, element)?;
            }
        }
    }
    body.end()?;
    let missing = |what: &str, message: &str| {
        let help = format!("expected \"element {what} COUNT\" in the header");
        MeshFileError::invalid(MeshPlace::File, message, help)
    };
    let vertices = vertices.ok_or_else(|| missing("vertex", "the file has no vertices"))?;
    let faces = faces.ok_or_else(|| missing("face", "the file has no faces"))?;
    let mesh = Mesh {
        positions: vertices.positions,
        faces: faces.triangles,
    };
    let attributes = vertices.attributes.into_iter().chain(faces.attributes);
    finish(MeshFile {
        name: None,
        mesh,
        normals: vertices.normals,
        uvs: vertices.uvs,
        attributes: attributes.collect(),
        warnings,
    })
}

/// What is left of the file behind the header.
struct Body<'a> {
    bytes: &'a [u8],
    position: usize,
    format: Encoding,
    /// Line of the next word, in text.
    line: usize,
}

/// A number of the body; integers keep all their digits.
#[derive(Clone, Copy)]
enum Number {
    Integer(i128),
    Float(f64),
}

impl Number {
    fn as_f64(self) -> f64 {
        match self {
            Self::Integer(i) => i as f64,
            Self::Float(x) => x,
        }
    }
}

impl Body<'_> {
    fn remaining(&self) -> usize {
        self.bytes.len() - self.position
    }

    /// Where the next number stands.
    fn place(&self) -> MeshPlace {
        match self.format {
            Encoding::Ascii => MeshPlace::Line(self.line),
            _ => MeshPlace::Byte(self.position),
        }
    }

    /// Refuses a count that the rest of the file cannot hold, before anything
    /// is reserved for it.
    fn announced(&self, element: &PlyElement) -> Result<(), MeshFileError> {
        let least = element.least_size(self.format) as u128 * u128::from(element.count);
        // The last number of a text needs no separator.
        if least <= self.remaining() as u128 + 1 {
            return Ok(());
        }
        Err(MeshFileError::damaged(
            self.place(),
            format!(
                "the header announces {} elements \"{}\", which take at least {least} bytes, but \
                 {} bytes are left",
                element.count,
                element.name,
                self.remaining()
            ),
            "the file is cut off or its header is wrong",
        ))
    }

    /// The next number, or `None` if the file ends.
    fn number(&mut self, scalar: Scalar) -> Result<Option<Number>, MeshFileError> {
        match self.format {
            Encoding::Ascii => self.text_number(scalar),
            _ => Ok(self.binary_number(scalar)),
        }
    }

    fn binary_number(&mut self, scalar: Scalar) -> Option<Number> {
        let raw = self
            .bytes
            .get(self.position..self.position + scalar.size())?;
        self.position += scalar.size();
        let mut little = [0; 8];
        little[..raw.len()].copy_from_slice(raw);
        if self.format == Encoding::BigEndian {
            little[..raw.len()].reverse();
        }
        let bits = u64::from_le_bytes(little);
        Some(match scalar {
            Scalar::I8 => Number::Integer((bits as i8).into()),
            Scalar::U8 => Number::Integer((bits as u8).into()),
            Scalar::I16 => Number::Integer((bits as i16).into()),
            Scalar::U16 => Number::Integer((bits as u16).into()),
            Scalar::I32 => Number::Integer((bits as i32).into()),
            Scalar::U32 => Number::Integer((bits as u32).into()),
            Scalar::I64 => Number::Integer((bits as i64).into()),
            Scalar::U64 => Number::Integer(bits.into()),
            Scalar::F32 => Number::Float(f32::from_bits(bits as u32).into()),
            Scalar::F64 => Number::Float(f64::from_bits(bits)),
        })
    }

    fn text_number(&mut self, scalar: Scalar) -> Result<Option<Number>, MeshFileError> {
        self.pass_blanks();
        let rest = &self.bytes[self.position..];
        let length = rest.iter().position(u8::is_ascii_whitespace);
        let word = &rest[..length.unwrap_or(rest.len())];
        if word.is_empty() {
            return Ok(None);
        }
        let text = std::str::from_utf8(word).ok();
        let number = match scalar.is_integer() {
            true => text.and_then(|t| t.parse().ok()).map(Number::Integer),
            false => text.and_then(|t| t.parse().ok()).map(Number::Float),
        };
        let number = number.ok_or_else(|| {
            let kind = if scalar.is_integer() {
                "a whole number"
            } else {
                "a number"
            };
            MeshFileError::damaged(
                self.place(),
                format!("\"{}\" is not {kind}", String::from_utf8_lossy(word)),
                "expected what the header announces",
            )
        })?;
        self.position += word.len();
        Ok(Some(number))
    }

    fn pass_blanks(&mut self) {
        while let Some(byte) = self
            .bytes
            .get(self.position)
            .filter(|b| b.is_ascii_whitespace())
        {
            self.line += usize::from(*byte == b'\n');
            self.position += 1;
        }
    }

    /// Refuses anything behind the last element.
    fn end(&mut self) -> Result<(), MeshFileError> {
        if self.format == Encoding::Ascii {
            self.pass_blanks();
        }
        if self.remaining() == 0 {
            return Ok(());
        }
        Err(MeshFileError::damaged(
            self.place(),
            format!("{} bytes follow the last element", self.remaining()),
            "the header announces too few elements or the wrong types",
        ))
    }
}

/// Reads one element: calls `visit` with the index of the property and each of
/// its numbers. `name` and `index` say where the file ends if it does.
fn read_element(
    body: &mut Body,
    element: &PlyElement,
    index: u64,
    mut visit: impl FnMut(usize, Number),
) -> Result<(), MeshFileError> {
    let cut_off = |body: &Body| {
        MeshFileError::damaged(
            body.place(),
            format!(
                "the file ends within {} {index} of {}",
                element.name, element.count
            ),
            "the file is cut off or its header is wrong",
        )
    };
    for (i, property) in element.properties.iter().enumerate() {
        let mut length = 1;
        if let Some(scalar) = property.length {
            let place = body.place();
            let given = body.number(scalar)?.ok_or_else(|| cut_off(body))?;
            let Number::Integer(n @ 0..) = given else {
                return Err(MeshFileError::damaged(
                    place,
                    format!(
                        "the list \"{}\" of {} {index} has the length {}",
                        property.name,
                        element.name,
                        given.as_f64()
                    ),
                    "expected a length of at least 0",
                ));
            };
            length = n;
        }
        // A wrong length must not read on for ever: the file ends first.
        for _ in 0..length {
            let number = body.number(property.scalar)?;
            visit(i, number.ok_or_else(|| cut_off(body))?);
        }
    }
    Ok(())
}

fn skip(body: &mut Body, element: &PlyElement) -> Result<(), MeshFileError> {
    // Elements without properties take no bytes; there is nothing to pass over,
    // however many are announced.
    if element.properties.is_empty() {
        return Ok(());
    }
    (0..element.count).try_for_each(|index| read_element(body, element, index, |_, _| ()))
}

/// The element `vertex`; each list has one entry per vertex.
struct Vertices {
    positions: Vec<Vec3>,
    normals: Option<Vec<Vec3>>,
    uvs: Option<Vec<[f64; 2]>>,
    attributes: Vec<FileAttribute>,
}

/// What faces have, polygons cut into triangles.
struct Faces {
    triangles: Vec<[u32; 3]>,
    attributes: Vec<FileAttribute>,
}

/// Attributes without numbers yet.
fn empty_attributes(groups: &[Group]) -> Vec<FileAttribute> {
    let attributes = groups.iter().map(|group| FileAttribute {
        name: group.name.clone(),
        channels: group.properties.len(),
        data: Vec::new(),
        is_integer: group.is_integer,
    });
    attributes.collect()
}

/// Adds one vertex's or triangle's numbers to each attribute.
fn extend(attributes: &mut [FileAttribute], groups: &[Group], values: &[f64]) {
    for (attribute, group) in attributes.iter_mut().zip(groups) {
        attribute
            .data
            .extend(group.properties.iter().map(|&i| values[i]));
    }
}

/// The indices of properties with these names that are one number each.
fn numbers<const N: usize>(element: &PlyElement, names: [&str; N]) -> Option<[usize; N]> {
    let found = names.map(|name| {
        let index = element.position(name)?;
        element.properties[index].length.is_none().then_some(index)
    });
    found
        .iter()
        .all(Option::is_some)
        .then(|| found.map(|index| index.expect("all of them are there")))
}

/// Positions, attributes, and normals and texture coordinates if wanted and
/// there.
fn read_vertices(
    body: &mut Body,
    element: &PlyElement,
    want_normals: bool,
) -> Result<Vertices, MeshFileError> {
    let position_at = numbers(element, ["x", "y", "z"]).ok_or_else(|| {
        MeshFileError::invalid(
            MeshPlace::File,
            "the vertices have no positions",
            "expected the properties x, y and z in the header",
        )
    })?;
    let normal_at = numbers(element, ["nx", "ny", "nz"]).filter(|_| want_normals);
    let uv_names = [["u", "v"], ["texture_u", "texture_v"], ["s", "t"]];
    let uv_at = uv_names.iter().find_map(|&names| numbers(element, names));
    let groups = ply_attribute::groups(element, "vertex");
    let mut attributes = empty_attributes(&groups);
    let count = element.count as usize;
    let mut positions = Vec::with_capacity(count);
    let mut normals = normal_at.map(|_| Vec::with_capacity(count));
    let mut uvs = uv_at.map(|_| Vec::with_capacity(count));
    let mut values = vec![0.0; element.properties.len()];
    for index in 0..element.count {
        if body.format == Encoding::Ascii {
            body.pass_blanks();
        }
        let start = body.place();
        read_element(body, element, index, |i, number| {
            values[i] = number.as_f64()
        })?;
        let vector = |at: [usize; 3]| Vec3::from(at.map(|i| values[i]));
        let place = || start.clone();
        let vertex = index as usize;
        positions.push(finite_position(vector(position_at), vertex, &place)?);
        if let (Some(normals), Some(at)) = (&mut normals, normal_at) {
            normals.push(unit_normal(vector(at), vertex, &place)?);
        }
        if let (Some(uvs), Some([u, v])) = (&mut uvs, uv_at) {
            let uv = [values[u], values[v]];
            if !uv.iter().all(|x| x.is_finite()) {
                let message = format!("vertex {vertex} has the texture coordinates {uv:?}");
                return Err(MeshFileError::invalid(
                    place(),
                    message,
                    "expected finite ones",
                ));
            }
            uvs.push(uv);
        }
        extend(&mut attributes, &groups, &values);
    }
    Ok(Vertices {
        positions,
        normals,
        uvs,
        attributes,
    })
}

/// Triangles and their attributes; polygons become fans.
fn read_faces(
    body: &mut Body,
    element: &PlyElement,
    vertices: u64,
) -> Result<Faces, MeshFileError> {
    let list = CORNER_LISTS
        .iter()
        .find_map(|name| element.position(name))
        .filter(|&i| {
            let property = &element.properties[i];
            property.length.is_some() && property.scalar.is_integer()
        });
    let list = list.ok_or_else(|| {
        MeshFileError::invalid(
            MeshPlace::File,
            "the faces have no list of corners",
            "expected \"property list uchar int vertex_indices\" in the header",
        )
    })?;
    let mut triangles = Vec::with_capacity(element.count as usize);
    let mut polygon: Vec<u32> = Vec::new();
    let groups = ply_attribute::groups(element, "face");
    let mut attributes = empty_attributes(&groups);
    let mut values = vec![0.0; element.properties.len()];
    for index in 0..element.count {
        polygon.clear();
        let mut bad_corner = None;
        read_element(body, element, index, |i, number| {
            values[i] = number.as_f64();
            let Number::Integer(corner) = number else {
                return;
            };
            if i == list {
                match u32::try_from(corner) {
                    Ok(vertex) if u64::from(vertex) < vertices => polygon.push(vertex),
                    _ => bad_corner = bad_corner.or(Some(corner)),
                }
            }
        })?;
        if let Some(corner) = bad_corner {
            return Err(MeshFileError::invalid(
                MeshPlace::Face(index),
                format!("it refers to vertex {corner}"),
                format!("there are {vertices} vertices (counted from 0)"),
            ));
        }
        if polygon.len() < 3 {
            return Err(MeshFileError::invalid(
                MeshPlace::Face(index),
                format!("it has {} corners", polygon.len()),
                "expected at least 3",
            ));
        }
        for triangle in fan(&polygon) {
            triangles.push(triangle);
            extend(&mut attributes, &groups, &values);
        }
    }
    Ok(Faces {
        triangles,
        attributes,
    })
}
