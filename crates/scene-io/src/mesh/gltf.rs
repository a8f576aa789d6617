//! glTF 2.0, `.gltf` and `.glb`: one primitive of one mesh, where a node of the
//! scene places it.

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};
use gltf::Primitive;
use gltf::accessor::{Accessor, DataType, Dimensions, Item};
use gltf::mesh::{Mode, Semantic};

use super::checked::{FileAttribute, MeshFile, fan, finish, finite_position, unit_normal};
use super::error::{MeshFileError, MeshPlace};
use super::gltf_bytes::OpenFile;
use super::gltf_file::{GltfFile, at, unsupported};
use super::gltf_node::{self, GltfChoice};

/// Attributes of vertices that are read, or that a mesh without skin and texture
/// tangents does not need.
const KNOWN_ATTRIBUTES: [&str; 7] = [
    "POSITION",
    "NORMAL",
    "TEXCOORD_0",
    "COLOR_0",
    "TANGENT",
    "JOINTS_0",
    "WEIGHTS_0",
];

/// Where an attribute stands, and its numbers.
type Elements<const N: usize> = (MeshPlace, Vec<[f64; N]>);

/// The primitive that `choice` picks from the bytes of a glTF file, in the
/// coordinates of the file's scene. Normals are read if `want_normals`. `open`
/// opens the files that its buffers name.
pub fn read_gltf(
    bytes: &[u8],
    choice: &GltfChoice,
    want_normals: bool,
    open: &OpenFile,
) -> Result<MeshFile, MeshFileError> {
    GltfFile::parse(bytes)?.primitive(choice, want_normals, open)
}

impl GltfFile {
    /// The primitive that `choice` picks, see [`read_gltf`].
    pub fn primitive(
        &self,
        choice: &GltfChoice,
        want_normals: bool,
        open: &OpenFile,
    ) -> Result<MeshFile, MeshFileError> {
        self.refuse_required_extensions()?;
        let placed = gltf_node::choose(self, choice)?;
        let reader = Reader {
            file: self,
            primitive: placed.primitive,
            place: placed.place,
            open,
        };
        reader.read(placed.name, placed.to_scene, want_normals)
    }

    /// Refuses files that cannot be understood without an extension, but for those
    /// about materials, textures and lights: what they change is none of a mesh's business, and
    /// is read or refused where it stands.
    pub fn refuse_required_extensions(&self) -> Result<(), MeshFileError> {
        let is_harmless = |name: &str| {
            let about = [
                "KHR_materials_",
                "KHR_texture_",
                "EXT_texture_",
                "KHR_lights_",
            ];
            about.iter().any(|about| name.starts_with(about)) || name == "KHR_mesh_quantization"
        };
        let mut names = self.document.extensions_required().enumerate();
        match names.find(|(_, name)| !is_harmless(name)) {
            None => Ok(()),
            Some((index, name)) => {
                let place = format!("extensionsRequired[{index}]");
                let message = format!("the extension \"{name}\" is not read");
                Err(unsupported(&place, message, "export the file without it"))
            }
        }
    }
}

/// Reads one primitive.
struct Reader<'a> {
    file: &'a GltfFile,
    primitive: Primitive<'a>,
    place: String,
    open: &'a OpenFile<'a>,
}

impl<'a> Reader<'a> {
    fn read(
        &self,
        name: Option<String>,
        to_scene: Affine,
        want_normals: bool,
    ) -> Result<MeshFile, MeshFileError> {
        self.refuse_what_is_not_read()?;
        let Some((place, positions)) = self.attribute::<3>(&Semantic::Positions, None)? else {
            return Err(MeshFileError::damaged(
                at(&self.place),
                "the vertices have no positions",
                "expected the attribute POSITION; is the mesh compressed?",
            ));
        };
        let positions = positions.into_iter().map(Vec3::from).enumerate();
        let positions = positions.map(|(vertex, p)| {
            let p = finite_position(p, vertex, &|| place.clone())?;
            // A finite point may still be moved out of range.
            finite_position(to_scene.point(p), vertex, &|| place.clone())
        });
        let positions: Vec<Vec3> = positions.collect::<Result<_, _>>()?;
        let count = positions.len();

        let mut normals = None;
        if want_normals
            && let Some((place, given)) = self.attribute::<3>(&Semantic::Normals, Some(count))?
        {
            let given = given.into_iter().map(Vec3::from).enumerate();
            let given = given.map(|(vertex, n)| {
                unit_normal(n, vertex, &|| place.clone())?;
                unit_normal(to_scene.normal(n), vertex, &|| place.clone())
            });
            normals = Some(given.collect::<Result<_, _>>()?);
        }
        let mut uvs = None;
        if let Some((place, given)) = self.attribute::<2>(&Semantic::TexCoords(0), Some(count))? {
            all_finite(&place, given.as_flattened(), 2)?;
            uvs = Some(given);
        }
        let attributes = self.colours(count)?.into_iter().collect();
        let mut faces = self.faces(count)?;
        // A node that mirrors turns its triangles, too, so that their front
        // stays where it was.
        if to_scene.determinant() < 0.0 {
            faces.iter_mut().for_each(|face| face.swap(1, 2));
        }
        finish(MeshFile {
            name,
            mesh: Mesh { positions, faces },
            normals,
            uvs,
            attributes,
            warnings: self.warnings(),
        })
    }

    /// What would be another shape if it were read.
    fn refuse_what_is_not_read(&self) -> Result<(), MeshFileError> {
        if self.primitive.morph_targets().next().is_some() {
            let help = "export the mesh as it is to be seen, without morph targets";
            let place = format!("{}.targets", self.place);
            return Err(unsupported(&place, "morph targets are not read", help));
        }
        let extensions = format!("{}.extensions", self.place);
        let mut names = self.file.keys(&extensions);
        // Variants of materials are no other shape.
        match names.find(|name| *name != "KHR_materials_variants") {
            None => Ok(()),
            Some(name) => {
                let message = format!("the extension \"{name}\" is not read");
                let help = match name {
                    "KHR_draco_mesh_compression" => "export the mesh without Draco compression",
                    _ => "export the mesh without it",
                };
                Err(unsupported(&self.place, message, help))
            }
        }
    }

    fn warnings(&self) -> Vec<String> {
        let attributes = format!("{}.attributes", self.place);
        let names = self.file.keys(&attributes);
        let others: Vec<&str> = names.filter(|n| !KNOWN_ATTRIBUTES.contains(n)).collect();
        match others[..] {
            [] => Vec::new(),
            _ => vec![format!("has {}, which are not read", others.join(", "))],
        }
    }

    /// The vertices' colours, and whether these are whole numbers. A fourth number is the
    /// opacity, which is left out.
    fn colours(&self, count: usize) -> Result<Option<FileAttribute>, MeshFileError> {
        let semantic = Semantic::Colors(0);
        let Some(accessor) = self.primitive.get(&semantic) else {
            return Ok(None);
        };
        let data: Vec<f64> = match accessor.dimensions() {
            Dimensions::Vec4 => {
                let colours = self.attribute::<4>(&semantic, Some(count))?.into_iter();
                let colours = colours.flat_map(|(_, colours)| colours);
                colours.flat_map(|[r, g, b, _]| [r, g, b]).collect()
            }
            _ => {
                let colours = self.attribute::<3>(&semantic, Some(count))?.into_iter();
                colours.flat_map(|(_, colours)| colours).flatten().collect()
            }
        };
        all_finite(&at(&format!("accessors[{}]", accessor.index())), &data, 3)?;
        Ok(Some(FileAttribute {
            name: "vertex_color".to_owned(),
            channels: 3,
            data,
            is_integer: accessor.data_type() != DataType::F32 && !accessor.normalized(),
        }))
    }

    /// An attribute's place and numbers, if the primitive has it: one element for each of
    /// `count` vertices. Normalised numbers are fractions of the largest.
    fn attribute<const N: usize>(
        &self,
        semantic: &Semantic,
        count: Option<usize>,
    ) -> Result<Option<Elements<N>>, MeshFileError>
    where
        [i8; N]: Item,
        [u8; N]: Item,
        [i16; N]: Item,
        [u16; N]: Item,
        [f32; N]: Item,
    {
        let Some(accessor) = self.primitive.get(semantic) else {
            return Ok(None);
        };
        let place = at(&format!("accessors[{}]", accessor.index()));
        let invalid = |message: String, help: &str| {
            let place = place.clone();
            Err(MeshFileError::invalid(place, message, help))
        };
        let components = accessor.dimensions().multiplicity();
        if components != N {
            let message = format!("its elements have {components} numbers");
            return invalid(message, &format!("expected VEC{N}, {N} numbers each"));
        }
        let numbers = match accessor.data_type() {
            DataType::I8 => self.fractions::<i8, N>(&accessor, 127.0)?,
            DataType::U8 => self.fractions::<u8, N>(&accessor, 255.0)?,
            DataType::I16 => self.fractions::<i16, N>(&accessor, 32767.0)?,
            DataType::U16 => self.fractions::<u16, N>(&accessor, 65535.0)?,
            DataType::F32 => self.fractions::<f32, N>(&accessor, 1.0)?,
            DataType::U32 => {
                let help = "expected componentType 5120, 5121, 5122, 5123 or 5126";
                return invalid("its componentType is 5125".into(), help);
            }
        };
        let elements = numbers.len();
        match count.filter(|&count| count != elements) {
            None => Ok(Some((place, numbers))),
            Some(count) => invalid(
                format!("it has {elements} elements, but there are {count} vertices"),
                "expected one for each vertex",
            ),
        }
    }

    /// The numbers of an accessor of this type, as fractions of `one` if they are normalised.
    fn fractions<T: Copy + Into<f64>, const N: usize>(
        &self,
        accessor: &Accessor<'a>,
        one: f64,
    ) -> Result<Vec<[f64; N]>, MeshFileError>
    where
        [T; N]: Item,
    {
        let is_normalized = accessor.normalized() && one != 1.0;
        let fraction = |number: T| match is_normalized {
            true => (number.into() / one).max(-1.0),
            false => number.into(),
        };
        let elements = self.file.elements::<[T; N]>(accessor, self.open)?;
        Ok(elements.map(|element| element.map(fraction)).collect())
    }

    /// Triangles of a primitive with so many vertices.
    fn faces(&self, vertices: usize) -> Result<Vec<[u32; 3]>, MeshFileError> {
        let (place, corners) = match self.primitive.indices() {
            // Files are smaller than so many vertices would take.
            None => (at(&self.place), (0..vertices as u32).collect()),
            Some(accessor) => {
                let place = at(&format!("accessors[{}]", accessor.index()));
                (place.clone(), self.indices(&accessor, place, vertices)?)
            }
        };
        triangles(self.primitive.mode(), &corners)
            .map_err(|(message, help)| MeshFileError::invalid(place, message, help))
    }

    /// The numbers of an accessor as those of vertices.
    fn indices(
        &self,
        accessor: &Accessor<'a>,
        place: MeshPlace,
        vertices: usize,
    ) -> Result<Vec<u32>, MeshFileError> {
        let (file, open) = (self.file, self.open);
        let components = accessor.dimensions().multiplicity();
        if components != 1 || accessor.normalized() {
            let message = format!("its elements have {components} numbers, or are normalized");
            let help = "expected SCALAR, an index each";
            return Err(MeshFileError::invalid(place, message, help));
        }
        let indices: Vec<u32> = match accessor.data_type() {
            DataType::U8 => file
                .elements::<u8>(accessor, open)?
                .map(u32::from)
                .collect(),
            DataType::U16 => file
                .elements::<u16>(accessor, open)?
                .map(u32::from)
                .collect(),
            DataType::U32 => file.elements::<u32>(accessor, open)?.collect(),
            DataType::I8 | DataType::I16 | DataType::F32 => {
                let (message, help) = (
                    "indices are whole numbers",
                    "expected componentType 5121, 5123 or 5125",
                );
                return Err(MeshFileError::invalid(place, message, help));
            }
        };
        match indices.iter().position(|&index| index as usize >= vertices) {
            None => Ok(indices),
            Some(at) => Err(MeshFileError::invalid(
                place,
                format!("index {at} refers to vertex {}", indices[at]),
                format!("there are {vertices} vertices (counted from 0)"),
            )),
        }
    }
}

/// Corners put together as triangles, strips or fans. Strips repeat corners to be
/// continued elsewhere; what has no third corner is left out.
fn triangles(mode: Mode, corners: &[u32]) -> Result<Vec<[u32; 3]>, (String, &'static str)> {
    let count = corners.len();
    let few = || {
        (
            format!("there are {count} corners"),
            "expected three corners and more",
        )
    };
    let faces: Vec<[u32; 3]> = match mode {
        Mode::Triangles => {
            let help = "expected three for each triangle";
            return match corners.as_chunks() {
                (faces, []) => Ok(faces.to_vec()),
                _ => Err((format!("its triangles have {count} corners together"), help)),
            };
        }
        Mode::TriangleStrip | Mode::TriangleFan if count < 3 => return Err(few()),
        Mode::TriangleStrip => {
            let strip = corners.windows(3).enumerate();
            let face = |(i, w): (usize, &[u32])| match i % 2 {
                0 => [w[0], w[1], w[2]],
                _ => [w[0], w[2], w[1]],
            };
            strip.map(face).collect()
        }
        Mode::TriangleFan => fan(corners).collect(),
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => {
            let what = match mode {
                Mode::Points => "points",
                Mode::Lines => "lines",
                Mode::LineLoop => "line loops",
                _ => "line strips",
            };
            let help = "expected triangles, triangle strips or triangle fans";
            return Err((format!("the primitive consists of {what}"), help));
        }
    };
    let has_three = |&[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    Ok(faces.into_iter().filter(has_three).collect())
}

/// An error if a number is not finite; `width` of them belong to one element.
fn all_finite(place: &MeshPlace, numbers: &[f64], width: usize) -> Result<(), MeshFileError> {
    match numbers.iter().position(|x| !x.is_finite()) {
        None => Ok(()),
        Some(at) => Err(MeshFileError::invalid(
            place.clone(),
            format!("element {} has the number {}", at / width, numbers[at]),
            "expected finite numbers",
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_and_fans() {
        let faces = |mode, corners: &[u32]| triangles(mode, corners).expect("triangles");
        assert_eq!(
            faces(Mode::Triangles, &[3, 1, 2, 5, 5, 4]),
            [[3, 1, 2], [5, 5, 4]]
        );
        // Every second triangle of a strip is wound against the order.
        assert_eq!(
            faces(Mode::TriangleStrip, &[0, 1, 2, 3, 4]),
            [[0, 1, 2], [1, 3, 2], [2, 3, 4]]
        );
        // Two strips in one.
        assert_eq!(
            faces(Mode::TriangleStrip, &[0, 1, 2, 2, 7, 7, 8, 9]),
            [[0, 1, 2], [7, 9, 8]]
        );
        assert_eq!(
            faces(Mode::TriangleFan, &[9, 1, 2, 3]),
            [[9, 1, 2], [9, 2, 3]]
        );
        let message = |mode, corners: &[u32]| triangles(mode, corners).expect_err("bad").0;
        assert_eq!(
            message(Mode::LineStrip, &[0, 1]),
            "the primitive consists of line strips"
        );
        assert_eq!(
            message(Mode::Triangles, &[0, 1]),
            "its triangles have 2 corners together"
        );
        assert_eq!(message(Mode::TriangleFan, &[0, 1]), "there are 2 corners");
    }
}
