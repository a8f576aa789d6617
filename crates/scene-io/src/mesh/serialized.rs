//! Mitsuba's own binary meshes, versions 3 and 4: several of them in one file,
//! each deflated by itself, and behind the last one where each begins.
//!
//! Little endian throughout:
//!
//! ```text
//! once per mesh   u16 0x041C, u16 version, and deflated by zlib:
//!                 u32 flags, [version 4: name, 0], u64 vertices, u64 faces,
//!                 positions, [normals], [texture coordinates], [colours],
//!                 three u32 per face
//! end of file     where each mesh begins (version 3: u32, version 4: u64),
//!                 u32 number of meshes
//! ```

use std::io::{ErrorKind, Read};

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;
use flate2::bufread::ZlibDecoder;

use super::checked::{FileAttribute, MeshFile, finish, finite_position, unit_normal};
use super::error::{MeshFileError, MeshPlace};

const MAGIC: u16 = 0x041C;

/// Bits of the flags.
const NORMALS: u32 = 0x0001;
const TEXTURE_COORDINATES: u32 = 0x0002;
const COLOURS: u32 = 0x0008;
const FLAT: u32 = 0x0010;
const SINGLE: u32 = 0x1000;
const DOUBLE: u32 = 0x2000;
/// All that mean something; Mitsuba does not look at the others.
const KNOWN: u32 = NORMALS | TEXTURE_COORDINATES | COLOURS | FLAT | SINGLE | DOUBLE;

/// What one deflated byte holds at most: 258 bytes take two bits at least.
const MOST_PER_BYTE: u128 = 1032;

/// Numbers are unpacked in pieces of this many bytes.
const PIECE: usize = 1 << 16;

/// Bytes of a name; more are a sign of damage.
const LONGEST_NAME: usize = 4096;

const DAMAGED: &str = "the file is cut off or damaged";

/// Mesh `index` in the bytes of a `.serialized` file. Normals are read if
/// `want_normals`.
pub fn read_serialized(
    bytes: &[u8],
    index: u32,
    want_normals: bool,
) -> Result<MeshFile, MeshFileError> {
    let (version, deflated) = locate(bytes, index)?;
    let place = MeshPlace::Mesh(index);
    let mut body = Body {
        unpacked: ZlibDecoder::new(deflated),
        place: place.clone(),
    };
    let flags = body.flags()?;
    let name = match version {
        Version::Three => None,
        Version::Four => body.name()?,
    };
    let [vertices, faces] = [(); 2].map(|()| body.bytes("numbers of vertices and faces"));
    let [vertices, faces] = [vertices?, faces?].map(u64::from_le_bytes);
    body.announced(flags, vertices, faces, deflated.len())?;
    let vertices = vertices as usize;
    let has = |bit: u32| flags & bit != 0;
    let mut vectors = |size: usize, what: &str| body.numbers(vertices * size, flags, what);

    let positions = vectors(3, "positions")?;
    let positions = as_vectors(&positions).map(|(i, p)| finite_position(p, i, &|| place.clone()));
    let positions = positions.collect::<Result<_, _>>()?;
    let mut normals = None;
    if has(NORMALS) {
        let given = vectors(3, "normals")?;
        if want_normals {
            let given = as_vectors(&given).map(|(i, n)| unit_normal(n, i, &|| place.clone()));
            normals = Some(given.collect::<Result<_, _>>()?);
        }
    }
    let mut uvs = None;
    if has(TEXTURE_COORDINATES) {
        let given = vectors(2, "texture coordinates")?;
        all_finite(&given, 2, "texture coordinates", &place)?;
        uvs = Some(given.as_chunks().0.to_vec());
    }
    let mut attributes = Vec::new();
    if has(COLOURS) {
        let data = vectors(3, "colours")?;
        all_finite(&data, 3, "colour", &place)?;
        attributes.push(FileAttribute {
            name: "vertex_color".to_owned(),
            channels: 3,
            data,
            is_integer: false,
        });
    }
    let faces = body.faces(faces as usize, vertices)?;
    body.end()?;
    let mut warnings = Vec::new();
    if has(FLAT) && want_normals {
        warnings.push(
            "is marked as flat, which Mitsuba 3 does not heed; for flat faces add \
             <boolean name=\"face_normals\" value=\"true\"/>"
                .to_owned(),
        );
    }
    if flags & !KNOWN != 0 {
        warnings.push(format!(
            "has the flags {:#x}, which say nothing of what is in it; they have no effect, as in \
             Mitsuba 3",
            flags & !KNOWN
        ));
    }
    finish(MeshFile {
        name,
        mesh: Mesh { positions, faces },
        normals,
        uvs,
        attributes,
        warnings,
    })
}

/// What differs between files: names, and the size of offsets.
#[derive(Clone, Copy, PartialEq)]
enum Version {
    Three,
    Four,
}

impl Version {
    /// Bytes of an offset at the end of the file.
    fn offset_size(self) -> usize {
        match self {
            Self::Three => 4,
            Self::Four => 8,
        }
    }
}

/// The version of mesh `index`, and its deflated data with whatever follows them.
fn locate(bytes: &[u8], index: u32) -> Result<(Version, &[u8]), MeshFileError> {
    let (version, _) = header(bytes, 0)?;
    let bad =
        |place: MeshPlace, message: String| Err(MeshFileError::damaged(place, message, DAMAGED));
    let Some((before, last)) = bytes.split_last_chunk::<4>() else {
        return bad(MeshPlace::File, "the file ends within its header".into());
    };
    let count = u32::from_le_bytes(*last);
    let table = before
        .len()
        .checked_sub(count as usize * version.offset_size());
    let Some(table) = table.filter(|_| count > 0) else {
        return bad(
            MeshPlace::End,
            format!("{count} meshes are announced, which the file cannot hold"),
        );
    };
    if index >= count {
        return Err(MeshFileError::choice(
            format!("there is no mesh {index}"),
            match count {
                1 => "expected shape_index 0: the file has one mesh".to_owned(),
                _ => format!("expected a shape_index from 0 to {}", count - 1),
            },
        ));
    }
    let (meshes, offsets) = before.split_at(table);
    let raw = offsets.chunks_exact(version.offset_size());
    let raw = raw.into_iter().nth(index as usize);
    let mut little = [0; 8];
    little[..version.offset_size()].copy_from_slice(raw.expect("as many offsets as meshes"));
    let offset = u64::from_le_bytes(little);
    match usize::try_from(offset).ok().filter(|&o| o < meshes.len()) {
        Some(offset) => header(meshes, offset),
        None => bad(
            MeshPlace::End,
            format!(
                "mesh {index} is said to begin at byte {offset}, but the meshes end at byte {table}"
            ),
        ),
    }
}

/// The version of the mesh at an offset, and what follows its header.
fn header(bytes: &[u8], offset: usize) -> Result<(Version, &[u8]), MeshFileError> {
    let bad = |message: String, help: &str| {
        Err(MeshFileError::damaged(
            MeshPlace::Byte(offset),
            message,
            help,
        ))
    };
    let Some((&[m0, m1, v0, v1], rest)) = bytes[offset..].split_first_chunk() else {
        return bad("the file ends within the header of a mesh".into(), DAMAGED);
    };
    if u16::from_le_bytes([m0, m1]) != MAGIC {
        return bad(
            "there is no serialized mesh".into(),
            "expected a file as written by Mitsuba, which begins with the bytes 1c 04",
        );
    }
    match u16::from_le_bytes([v0, v1]) {
        3 => Ok((Version::Three, rest)),
        4 => Ok((Version::Four, rest)),
        version => bad(
            format!("the mesh is of version {version}"),
            "expected version 3 or 4; convert the mesh to .ply",
        ),
    }
}

/// The data of one mesh, as they are unpacked.
struct Body<'a> {
    unpacked: ZlibDecoder<&'a [u8]>,
    place: MeshPlace,
}

impl Body<'_> {
    fn damaged(&self, message: String, help: &str) -> MeshFileError {
        MeshFileError::damaged(self.place.clone(), message, help)
    }

    fn unreadable(&self, error: &std::io::Error, what: &str) -> MeshFileError {
        self.damaged(
            match error.kind() {
                ErrorKind::UnexpectedEof => format!("the data end within the {what}"),
                _ => format!("the {what} cannot be unpacked: {error}"),
            },
            DAMAGED,
        )
    }

    fn bytes<const N: usize>(&mut self, what: &str) -> Result<[u8; N], MeshFileError> {
        let mut bytes = [0; N];
        let read = self.unpacked.read_exact(&mut bytes);
        read.map_err(|error| self.unreadable(&error, what))?;
        Ok(bytes)
    }

    /// Which data the mesh has, and of which precision.
    fn flags(&mut self) -> Result<u32, MeshFileError> {
        let flags = u32::from_le_bytes(self.bytes("flags")?);
        if flags & SINGLE != 0 && flags & DOUBLE != 0 {
            return Err(self.damaged(
                format!("its flags are {flags:#06x}: both of single and double precision"),
                "expected one of 0x1000 and 0x2000",
            ));
        }
        Ok(flags)
    }

    /// The name, if there is one that can be shown.
    fn name(&mut self) -> Result<Option<String>, MeshFileError> {
        let mut name = Vec::new();
        loop {
            match self.bytes("name")? {
                [0] => break,
                _ if name.len() == LONGEST_NAME => {
                    let message = format!("its name has more than {LONGEST_NAME} bytes");
                    return Err(self.damaged(message, DAMAGED));
                }
                [byte] => name.push(byte),
            }
        }
        let name = String::from_utf8(name).ok();
        Ok(name.filter(|name| !name.is_empty() && !name.chars().any(char::is_control)))
    }

    /// Refuses counts that the deflated data cannot hold, before anything is
    /// reserved for them.
    fn announced(
        &self,
        flags: u32,
        vertices: u64,
        faces: u64,
        deflated: usize,
    ) -> Result<(), MeshFileError> {
        let per = |bit: u32, numbers: u128| if flags & bit != 0 { numbers } else { 0 };
        let numbers = 3 + per(NORMALS, 3) + per(TEXTURE_COORDINATES, 2) + per(COLOURS, 3);
        let size = number_size(flags) as u128;
        let least = u128::from(vertices) * numbers * size + u128::from(faces) * 12;
        let most = MOST_PER_BYTE * deflated as u128;
        if least <= most {
            return Ok(());
        }
        Err(self.damaged(
            format!(
                "{vertices} vertices and {faces} faces are announced, which take {least} bytes, \
                 but {deflated} deflated bytes hold at most {most}"
            ),
            DAMAGED,
        ))
    }

    /// The next numbers, of the precision that the flags say.
    fn numbers(&mut self, count: usize, flags: u32, what: &str) -> Result<Vec<f64>, MeshFileError> {
        let mut numbers = Vec::with_capacity(count);
        self.pieces(count * number_size(flags), what, |piece| {
            match flags & DOUBLE {
                0 => {
                    let singles = piece.as_chunks().0.iter();
                    numbers.extend(singles.map(|&b| f64::from(f32::from_le_bytes(b))));
                }
                _ => {
                    let doubles = piece.as_chunks().0.iter();
                    numbers.extend(doubles.map(|&b| f64::from_le_bytes(b)));
                }
            }
        })?;
        Ok(numbers)
    }

    fn faces(&mut self, count: usize, vertices: usize) -> Result<Vec<[u32; 3]>, MeshFileError> {
        let mut corners = Vec::with_capacity(3 * count);
        self.pieces(12 * count, "faces", |piece| {
            let indices = piece.as_chunks().0.iter();
            corners.extend(indices.map(|&b| u32::from_le_bytes(b)));
        })?;
        if let Some(at) = corners.iter().position(|&i| i as usize >= vertices) {
            return Err(MeshFileError::invalid(
                self.place.clone(),
                format!("face {} refers to vertex {}", at / 3, corners[at]),
                format!("there are {vertices} vertices (counted from 0)"),
            ));
        }
        Ok(corners.as_chunks().0.to_vec())
    }

    /// Shows the next bytes to `read`, in pieces of whole numbers.
    fn pieces(
        &mut self,
        size: usize,
        what: &str,
        mut read: impl FnMut(&[u8]),
    ) -> Result<(), MeshFileError> {
        let mut buffer = vec![0; PIECE.min(size)];
        let mut left = size;
        while left > 0 {
            let piece = &mut buffer[..PIECE.min(left)];
            let unpacked = self.unpacked.read_exact(piece);
            unpacked.map_err(|error| self.unreadable(&error, what))?;
            read(piece);
            left -= piece.len();
        }
        Ok(())
    }

    /// Refuses anything behind the faces, and data whose checksum is wrong.
    fn end(&mut self) -> Result<(), MeshFileError> {
        let more = self.unpacked.read(&mut [0]);
        match more.map_err(|error| self.unreadable(&error, "checksum"))? {
            0 => Ok(()),
            _ => Err(self.damaged("more data follow the faces".into(), DAMAGED)),
        }
    }
}

/// Size of a coordinate, bytes.
fn number_size(flags: u32) -> usize {
    match flags & DOUBLE {
        0 => 4,
        _ => 8,
    }
}

/// The vectors in a flat array, and their numbers.
fn as_vectors(numbers: &[f64]) -> impl Iterator<Item = (usize, Vec3)> + '_ {
    let vectors = numbers.as_chunks::<3>().0.iter();
    vectors.map(|&v| Vec3::from(v)).enumerate()
}

fn all_finite(
    numbers: &[f64],
    size: usize,
    what: &str,
    place: &MeshPlace,
) -> Result<(), MeshFileError> {
    let mut of_vertices = numbers.chunks_exact(size);
    match of_vertices.position(|of_vertex| !of_vertex.iter().all(|x| x.is_finite())) {
        None => Ok(()),
        Some(vertex) => {
            let of_vertex = &numbers[size * vertex..][..size];
            let message = format!("vertex {vertex} has the {what} {of_vertex:?}");
            Err(MeshFileError::invalid(
                place.clone(),
                message,
                "expected finite numbers",
            ))
        }
    }
}
