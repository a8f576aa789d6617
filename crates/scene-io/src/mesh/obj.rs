//! Wavefront OBJ: polygons with positions, normals and texture coordinates.
//!
//! Vertices are split as in Mitsuba 3.9: each combination of position, texture
//! coordinate and normal that a face uses becomes one vertex, numbered in the
//! order of first use. Numbers are read in double precision.

use std::collections::HashMap;

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;

use super::checked::{MeshFile, fan, finish, finite_position, unit_normal};
use super::error::{MeshFileError, MeshPlace};

/// Statements without effect on the surface: names, groups, materials, lines,
/// points and display attributes.
const WITHOUT_EFFECT: [&str; 15] = [
    "o", "g", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "l", "p", "vp", "bevel",
    "c_interp", "d_interp", "lod",
];

/// What has been read so far.
#[derive(Default)]
struct Reader {
    want_normals: bool,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    texture_coordinates: Vec<[f64; 2]>,
    /// The corners that became vertices, as indices into the lists above.
    corners: Vec<Corner>,
    vertex_of_corner: HashMap<Corner, u32>,
    faces: Vec<[u32; 3]>,
    /// The first line with a corner that has a normal, and one that has none.
    line_with_normal: Option<usize>,
    line_without_normal: Option<usize>,
}

/// A corner of a face: position, texture coordinate, normal.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Corner {
    position: usize,
    texture: Option<usize>,
    normal: Option<usize>,
}

/// The mesh in the bytes of an OBJ file. Normals are read if `want_normals`.
pub fn read_obj(bytes: &[u8], want_normals: bool) -> Result<MeshFile, MeshFileError> {
    let mut reader = Reader {
        want_normals,
        ..Reader::default()
    };
    let mut lines = bytes.split(|&b| b == b'\n').enumerate();
    while let Some((index, line)) = lines.next() {
        let mut statement = without_comment(line).to_vec();
        // A backslash at the end continues the statement on the next line.
        while let Some(rest) = statement.trim_ascii_end().strip_suffix(b"\\") {
            statement.truncate(rest.len());
            statement.push(b' ');
            let Some((_, next)) = lines.next() else { break };
            statement.extend_from_slice(without_comment(next));
        }
        reader.statement(&statement, index + 1)?;
    }
    reader.finish()
}

fn without_comment(line: &[u8]) -> &[u8] {
    let end = line.iter().position(|&b| b == b'#').unwrap_or(line.len());
    &line[..end]
}

/// A word of a file, readable even if it is not text.
fn word(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

impl Reader {
    fn statement(&mut self, statement: &[u8], line: usize) -> Result<(), MeshFileError> {
        let mut words = statement
            .split(u8::is_ascii_whitespace)
            .filter(|w| !w.is_empty());
        let Some(keyword) = words.next() else {
            return Ok(());
        };
        match keyword {
            b"v" => {
                let position = three_numbers(words, line, "a vertex")?;
                let place = &|| MeshPlace::Line(line);
                let position = finite_position(position, self.positions.len() + 1, place)?;
                self.positions.push(position);
            }
            b"vn" if self.want_normals => {
                let normal = three_numbers(words, line, "a normal")?;
                let place = &|| MeshPlace::Line(line);
                let normal = unit_normal(normal, self.normals.len() + 1, place)?;
                self.normals.push(normal);
            }
            b"vn" => {}
            b"vt" => self
                .texture_coordinates
                .push(one_or_two_numbers(words, line)?),
            b"f" => self.face(words, line)?,
            _ => {
                let keyword = word(keyword);
                if !WITHOUT_EFFECT.contains(&keyword.as_str()) {
                    return Err(MeshFileError::unsupported(
                        MeshPlace::Line(line),
                        format!("\"{keyword}\" is not an OBJ statement that is read"),
                        "expected vertices (v, vn, vt) and faces (f); free-form surfaces must be \
                         converted to polygons",
                    ));
                }
            }
        }
        Ok(())
    }

    fn face<'a>(
        &mut self,
        words: impl Iterator<Item = &'a [u8]>,
        line: usize,
    ) -> Result<(), MeshFileError> {
        let corners: Vec<Corner> = words
            .map(|word| self.corner(word, line))
            .collect::<Result<_, _>>()?;
        if corners.len() < 3 {
            return Err(MeshFileError::invalid(
                MeshPlace::Line(line),
                format!("the face has {} corners", corners.len()),
                "expected at least 3",
            ));
        }
        let form = |c: &Corner| (c.texture.is_some(), c.normal.is_some());
        if corners.iter().any(|c| form(c) != form(&corners[0])) {
            return Err(MeshFileError::damaged(
                MeshPlace::Line(line),
                "the corners of the face are written in different forms",
                "expected all of them as v, v/vt, v//vn or v/vt/vn",
            ));
        }
        let mut polygon = Vec::with_capacity(corners.len());
        for corner in corners {
            let seen = match corner.normal {
                Some(_) => &mut self.line_with_normal,
                None => &mut self.line_without_normal,
            };
            seen.get_or_insert(line);
            let next = self.corners.len();
            let vertex = match self.vertex_of_corner.get(&corner) {
                Some(&vertex) => vertex,
                None => {
                    let vertex = u32::try_from(next).map_err(|_| {
                        MeshFileError::unsupported(
                            MeshPlace::Line(line),
                            "the mesh has too many vertices",
                            "expected less than 2^32",
                        )
                    })?;
                    self.corners.push(corner);
                    self.vertex_of_corner.insert(corner, vertex);
                    vertex
                }
            };
            polygon.push(vertex);
        }
        self.faces.extend(fan(&polygon));
        Ok(())
    }

    /// `7`, `7/2`, `7//3` or `7/2/3`; negative numbers count back from the last.
    fn corner(&self, text: &[u8], line: usize) -> Result<Corner, MeshFileError> {
        let fields: Vec<&[u8]> = text.split(|&b| b == b'/').collect();
        let bad = || {
            MeshFileError::damaged(
                MeshPlace::Line(line),
                format!("\"{}\" is not a corner of a face", word(text)),
                "expected v, v/vt, v//vn or v/vt/vn",
            )
        };
        if fields.len() > 3 {
            return Err(bad());
        }
        let index = |field: Option<&&[u8]>, count: usize, what: &str| {
            let Some(&digits) = field.filter(|digits| !digits.is_empty()) else {
                return Ok(None);
            };
            let digits = std::str::from_utf8(digits).ok();
            let number: i64 = digits.and_then(|d| d.parse().ok()).ok_or_else(bad)?;
            let position = match number {
                1.. => usize::try_from(number - 1).ok(),
                _ => usize::try_from(number + count as i64).ok(),
            };
            match position.filter(|&i| number != 0 && i < count) {
                Some(i) => Ok(Some(i)),
                None => Err(MeshFileError::invalid(
                    MeshPlace::Line(line),
                    format!("the face refers to {what} {number}"),
                    format!("{count} come before it (counted from 1)"),
                )),
            }
        };
        let position = index(fields.first(), self.positions.len(), "vertex")?;
        let texture = fields.get(1);
        let normal = fields.get(2).filter(|_| self.want_normals);
        Ok(Corner {
            position: position.ok_or_else(bad)?,
            texture: index(
                texture,
                self.texture_coordinates.len(),
                "texture coordinate",
            )?,
            normal: index(normal, self.normals.len(), "normal")?,
        })
    }

    fn finish(self) -> Result<MeshFile, MeshFileError> {
        let mesh = Mesh {
            positions: self
                .corners
                .iter()
                .map(|c| self.positions[c.position])
                .collect(),
            faces: self.faces,
        };
        let normals = match (self.line_with_normal, self.line_without_normal) {
            (Some(_), Some(line)) => {
                return Err(MeshFileError::invalid(
                    MeshPlace::Line(line),
                    "the face has corners without normals, but others have them",
                    "give all corners normals or none; face_normals does without normals",
                ));
            }
            (Some(_), None) => {
                let indices = self.corners.iter().filter_map(|c| c.normal);
                Some(indices.map(|i| self.normals[i]).collect())
            }
            _ => None,
        };
        let uvs = self.corners.iter();
        let uvs = uvs.map(|c| Some(self.texture_coordinates[c.texture?]));
        finish(MeshFile {
            name: None,
            mesh,
            normals,
            uvs: uvs.collect(),
            attributes: Vec::new(),
            warnings: Vec::new(),
        })
    }
}

/// The first three words as numbers; a fourth coordinate or a colour may follow.
fn three_numbers<'a>(
    mut words: impl Iterator<Item = &'a [u8]>,
    line: usize,
    what: &str,
) -> Result<Vec3, MeshFileError> {
    let help = format!("expected three coordinates of {what}");
    let mut next = || number(words.next().unwrap_or(b""), line, &help);
    Ok(Vec3::new(next()?, next()?, next()?))
}

/// Texture coordinates: `u`, `u v` or `u v w`; `v` is 0 where it is missing.
fn one_or_two_numbers<'a>(
    mut words: impl Iterator<Item = &'a [u8]>,
    line: usize,
) -> Result<[f64; 2], MeshFileError> {
    let help = "expected finite texture coordinates";
    let u = number(words.next().unwrap_or(b""), line, help)?;
    let v = number(words.next().unwrap_or(b"0"), line, help)?;
    match u.is_finite() && v.is_finite() {
        true => Ok([u, v]),
        false => Err(MeshFileError::invalid(
            MeshPlace::Line(line),
            format!("the texture coordinates are ({u}, {v})"),
            help,
        )),
    }
}

fn number(text: &[u8], line: usize, help: &str) -> Result<f64, MeshFileError> {
    let number = std::str::from_utf8(text).ok().and_then(|t| t.parse().ok());
    number.ok_or_else(|| {
        MeshFileError::damaged(
            MeshPlace::Line(line),
            format!("\"{}\" is not a number", word(text)),
            help,
        )
    })
}
