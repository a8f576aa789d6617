//! glTF 2.0, `.gltf` and `.glb`: one primitive of one mesh, where a node of the
//! scene places it.

use capwalk_geometry::Mesh;
use capwalk_math::{Affine, Vec3};

use super::checked::{FileAttribute, MeshFile, fan, finish, finite_position, unit_normal};
use super::error::MeshFileError;
use super::gltf_accessor::{self, Numbers};
use super::gltf_buffer::{Buffers, OpenFile, split};
use super::gltf_json::Item;
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

/// The primitive that `choice` picks from the bytes of a glTF file, in the
/// coordinates of the file's scene. Normals are read if `want_normals`. `open`
/// opens the files that its buffers name.
pub fn read_gltf(
    bytes: &[u8],
    choice: &GltfChoice,
    want_normals: bool,
    open: &OpenFile,
) -> Result<MeshFile, MeshFileError> {
    let (json, binary) = split(bytes)?;
    let root = Item::root(&json);
    let asset = root.required("asset")?;
    let version = asset.required("version")?;
    if !version.as_text()?.starts_with("2.") {
        let message = format!("it is \"{}\"", version.as_text()?);
        return Err(version.unsupported(message, "expected a glTF 2.0 file"));
    }
    required_extensions(&root)?;
    let placed = gltf_node::choose(&root, choice)?;
    let buffers = Buffers::new(root.clone(), binary, open);
    let primitive = Primitive {
        root,
        item: placed.primitive,
        buffers,
    };
    let name = placed.name;
    primitive.read(name, placed.to_scene, want_normals)
}

/// Refuses files that cannot be understood without an extension, but for those
/// about what is not read anyway: materials, textures and lights.
fn required_extensions(root: &Item) -> Result<(), MeshFileError> {
    let is_harmless = |name: &str| {
        let about = [
            "KHR_materials_",
            "KHR_texture_",
            "EXT_texture_",
            "KHR_lights_",
        ];
        about.iter().any(|about| name.starts_with(about)) || name == "KHR_mesh_quantization"
    };
    let names = root.texts("extensionsRequired")?;
    match names.iter().position(|name| !is_harmless(name)) {
        None => Ok(()),
        Some(index) => {
            let message = format!("the extension \"{}\" is not read", names[index]);
            let help = "export the mesh without it";
            Err(root
                .entry("extensionsRequired", index)?
                .unsupported(message, help))
        }
    }
}

/// One primitive and what its numbers are read from.
struct Primitive<'a> {
    root: Item<'a>,
    item: Item<'a>,
    buffers: Buffers<'a>,
}

impl<'a> Primitive<'a> {
    fn read(
        mut self,
        name: Option<String>,
        to_scene: Affine,
        want_normals: bool,
    ) -> Result<MeshFile, MeshFileError> {
        self.refuse_what_is_not_read()?;
        let (position_item, positions) =
            self.attribute("POSITION", &["VEC3"], None)?
                .ok_or_else(|| {
                    let help = "expected the attribute POSITION; is the mesh compressed?";
                    self.item.damaged("the vertices have no positions", help)
                })?;
        let positions = vectors(&positions).enumerate().map(|(vertex, p)| {
            let p = finite_position(p, vertex, &|| position_item.place())?;
            // A finite point may still be moved out of range.
            finite_position(to_scene.point(p), vertex, &|| position_item.place())
        });
        let positions: Vec<Vec3> = positions.collect::<Result<_, _>>()?;
        let count = positions.len();

        let mut normals = None;
        if want_normals
            && let Some((item, given)) = self.attribute("NORMAL", &["VEC3"], Some(count))?
        {
            let given = vectors(&given).enumerate().map(|(vertex, n)| {
                unit_normal(n, vertex, &|| item.place())?;
                unit_normal(to_scene.normal(n), vertex, &|| item.place())
            });
            normals = Some(given.collect::<Result<_, _>>()?);
        }
        let mut uvs = None;
        if let Some((item, given)) = self.attribute("TEXCOORD_0", &["VEC2"], Some(count))? {
            all_finite(&item, &given)?;
            uvs = Some(given.values.as_chunks().0.to_vec());
        }
        let mut attributes = Vec::new();
        let kinds = ["VEC3", "VEC4"];
        if let Some((item, given)) = self.attribute("COLOR_0", &kinds, Some(count))? {
            all_finite(&item, &given)?;
            // A fourth number is the opacity.
            let colours = given.values.chunks_exact(given.width);
            attributes.push(FileAttribute {
                name: "vertex_color".to_owned(),
                channels: 3,
                data: colours.flat_map(|colour| &colour[..3]).copied().collect(),
                is_integer: given.is_integer,
            });
        }
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
        if let Some(targets) = self.item.get("targets") {
            let help = "export the mesh as it is to be seen, without morph targets";
            return Err(targets.unsupported("morph targets are not read", help));
        }
        let extensions = self.item.get("extensions");
        let mut names = extensions.iter().flat_map(Item::keys);
        // Variants of materials are no other shape.
        match names.find(|name| *name != "KHR_materials_variants") {
            None => Ok(()),
            Some(name) => {
                let message = format!("the extension \"{name}\" is not read");
                let help = match name {
                    "KHR_draco_mesh_compression" => "export the mesh without Draco compression",
                    _ => "export the mesh without it",
                };
                Err(self.item.unsupported(message, help))
            }
        }
    }

    fn warnings(&self) -> Vec<String> {
        let attributes = self.item.get("attributes");
        let names = attributes.iter().flat_map(Item::keys);
        let others: Vec<&str> = names.filter(|n| !KNOWN_ATTRIBUTES.contains(n)).collect();
        match others[..] {
            [] => Vec::new(),
            _ => vec![format!("has {}, which are not read", others.join(", "))],
        }
    }

    /// The accessor of an attribute and its numbers, if the primitive has it:
    /// one element for each of `count` vertices.
    fn attribute(
        &mut self,
        name: &str,
        types: &[&str],
        count: Option<usize>,
    ) -> Result<Option<(Item<'a>, Numbers)>, MeshFileError> {
        let Some(index) = self.item.get("attributes").and_then(|a| a.get(name)) else {
            return Ok(None);
        };
        let accessor = self.root.entry("accessors", index.as_index()?)?;
        let numbers = gltf_accessor::read(&accessor, &self.root, &mut self.buffers, types)?;
        let elements = numbers.values.len() / numbers.width;
        if let Some(count) = count.filter(|&count| count != elements) {
            return Err(accessor.invalid(
                format!("it has {elements} elements, but there are {count} vertices"),
                "expected one for each vertex",
            ));
        }
        Ok(Some((accessor, numbers)))
    }

    /// Triangles of a primitive with so many vertices.
    fn faces(&mut self, vertices: usize) -> Result<Vec<[u32; 3]>, MeshFileError> {
        let (item, corners) = match self.item.get("indices") {
            None => {
                let all = u32::try_from(vertices).map(|count| (0..count).collect());
                let all = all.map_err(|_| {
                    self.item
                        .unsupported("it has too many vertices", "expected less than 2^32")
                })?;
                (self.item.clone(), all)
            }
            Some(index) => {
                let accessor = self.root.entry("accessors", index.as_index()?)?;
                let corners = self.indices(&accessor, vertices)?;
                (accessor, corners)
            }
        };
        let mode = self.item.get("mode");
        let mode = mode.map_or(Ok(4), |mode| mode.as_index())?;
        triangles(mode, &corners).map_err(|(message, help)| item.invalid(message, help))
    }

    fn indices(&mut self, accessor: &Item, vertices: usize) -> Result<Vec<u32>, MeshFileError> {
        let numbers = gltf_accessor::read(accessor, &self.root, &mut self.buffers, &["SCALAR"])?;
        if !numbers.is_integer {
            let help = "expected componentType 5121, 5123 or 5125, not normalized";
            return Err(accessor.invalid("indices are whole numbers", help));
        }
        let is_bad = |&i: &f64| !(0.0..vertices as f64).contains(&i);
        match numbers.values.iter().position(is_bad) {
            None => Ok(numbers.values.into_iter().map(|i| i as u32).collect()),
            Some(at) => Err(accessor.invalid(
                format!("index {at} refers to vertex {}", numbers.values[at]),
                &format!("there are {vertices} vertices (counted from 0)"),
            )),
        }
    }
}

/// Corners put together as triangles, strips or fans (glTF's modes 4, 5 and 6).
/// Strips repeat corners to be continued elsewhere; what has no third corner is
/// left out.
fn triangles(mode: usize, corners: &[u32]) -> Result<Vec<[u32; 3]>, (String, &'static str)> {
    let others = ["points", "lines", "line loops", "line strips"];
    if let Some(what) = others.get(mode) {
        let help = "expected triangles, triangle strips or triangle fans";
        return Err((format!("the primitive consists of {what}"), help));
    }
    let fewest = "expected three corners and more";
    let count = corners.len();
    if mode == 4 {
        let help = "expected three for each triangle";
        return match corners.as_chunks() {
            (faces, []) => Ok(faces.to_vec()),
            _ => Err((format!("its triangles have {count} corners together"), help)),
        };
    }
    if count < 3 {
        return Err((format!("there are {count} corners"), fewest));
    }
    let faces: Vec<[u32; 3]> = match mode {
        5 => {
            let strip = corners.windows(3).enumerate();
            let face = |(i, w): (usize, &[u32])| match i % 2 {
                0 => [w[0], w[1], w[2]],
                _ => [w[0], w[2], w[1]],
            };
            strip.map(face).collect()
        }
        6 => fan(corners).collect(),
        _ => return Err((format!("its mode is {mode}"), "expected 4, 5 or 6")),
    };
    let has_three = |&[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    Ok(faces.into_iter().filter(has_three).collect())
}

fn vectors(numbers: &Numbers) -> impl Iterator<Item = Vec3> + '_ {
    let vectors = numbers.values.as_chunks::<3>().0.iter();
    vectors.map(|&v| Vec3::from(v))
}

fn all_finite(item: &Item, numbers: &Numbers) -> Result<(), MeshFileError> {
    match numbers.values.iter().position(|x| !x.is_finite()) {
        None => Ok(()),
        Some(at) => Err(item.invalid(
            format!(
                "element {} has the number {}",
                at / numbers.width,
                numbers.values[at]
            ),
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
        assert_eq!(faces(4, &[3, 1, 2, 5, 5, 4]), [[3, 1, 2], [5, 5, 4]]);
        // Every second triangle of a strip is wound against the order.
        assert_eq!(
            faces(5, &[0, 1, 2, 3, 4]),
            [[0, 1, 2], [1, 3, 2], [2, 3, 4]]
        );
        // Two strips in one.
        assert_eq!(faces(5, &[0, 1, 2, 2, 7, 7, 8, 9]), [[0, 1, 2], [7, 9, 8]]);
        assert_eq!(faces(6, &[9, 1, 2, 3]), [[9, 1, 2], [9, 2, 3]]);
        let message = |mode, corners: &[u32]| triangles(mode, corners).expect_err("bad").0;
        assert_eq!(message(3, &[0, 1]), "the primitive consists of line strips");
        assert_eq!(message(4, &[0, 1]), "its triangles have 2 corners together");
        assert_eq!(message(6, &[0, 1]), "there are 2 corners");
        assert_eq!(message(7, &[0, 1, 2]), "its mode is 7");
    }
}
