//! The nodes of a glTF scene: what they place where, and which of it is meant.

use capwalk_math::{Affine, Vec3};

use super::error::MeshFileError;
use super::gltf_file::{GltfFile, at, unsupported};

/// How far the length of a rotation's quaternion may be from 1: writers round
/// to single precision.
const UNIT: f64 = 1e-3;

/// How many primitives a message lists.
const LISTED: usize = 8;

/// Which primitive of a file is meant. Without a choice there must be one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GltfChoice {
    /// The node that places it.
    pub node: Option<GltfName>,
    /// The mesh that it belongs to.
    pub mesh: Option<GltfName>,
    /// The index of the primitive within the mesh, counted from 0.
    pub primitive: Option<u32>,
}

/// How a node or a mesh is picked out of the file's list.
#[derive(Clone, Debug, PartialEq)]
pub enum GltfName {
    /// By its index, counted from 0.
    Index(u32),
    /// By its name.
    Name(String),
}

impl GltfName {
    fn is(&self, index: usize, name: Option<&str>) -> bool {
        match self {
            Self::Index(wanted) => *wanted as usize == index,
            Self::Name(wanted) => shown_name(name) == Some(wanted),
        }
    }
}

/// A primitive that was chosen.
pub(super) struct Placed<'a> {
    pub primitive: gltf::Primitive<'a>,
    /// Where it stands in the file.
    pub place: String,
    /// From its coordinates to the scene's; can be inverted.
    pub to_scene: Affine,
    /// What the node or the mesh is called.
    pub name: Option<String>,
}

/// A name that can be shown, and in which names of files and parameters begin.
pub(crate) fn shown_name(name: Option<&str>) -> Option<&str> {
    const LONGEST: usize = 1000;
    let is_fine = |name: &&str| (1..=LONGEST).contains(&name.len());
    name.filter(is_fine)
        .filter(|name| !name.chars().any(char::is_control))
}

/// A primitive of a mesh and the node that places it.
struct Candidate<'a> {
    node: Option<gltf::Node<'a>>,
    to_scene: Affine,
    mesh: gltf::Mesh<'a>,
    primitive: gltf::Primitive<'a>,
}

impl Candidate<'_> {
    /// As it is listed: `node 3 "Lid", mesh 1 "Disk", primitive 0`.
    fn title(&self) -> String {
        let title = |kind: &str, index: usize, name: Option<&str>| match shown_name(name) {
            Some(name) => format!("{kind} {index} \"{name}\", "),
            None => format!("{kind} {index}, "),
        };
        let node = self.node.as_ref();
        let node = node.map_or(String::new(), |n| title("node", n.index(), n.name()));
        let mesh = title("mesh", self.mesh.index(), self.mesh.name());
        format!("{node}{mesh}primitive {}", self.primitive.index())
    }
}

/// The one primitive that the choice leaves.
pub(super) fn choose<'a>(
    file: &'a GltfFile,
    choice: &GltfChoice,
) -> Result<Placed<'a>, MeshFileError> {
    let mut candidates: Vec<Candidate> = candidates(file, choice)?.take(LISTED + 1).collect();
    let is_free = choice == &GltfChoice::default();
    if candidates.len() > 1 {
        let listed = candidates.iter().take(LISTED).map(Candidate::title);
        let titles = listed.collect::<Vec<_>>().join("; ");
        let which = match is_free {
            true => "it holds several meshes",
            false => "several of its meshes are meant",
        };
        let rest = if candidates.len() > LISTED {
            "; ..."
        } else {
            ""
        };
        return Err(MeshFileError::choice(
            format!("{which}: {titles}{rest}"),
            "choose one by \"node\", \"mesh\" and \"primitive\", for example <string \
             name=\"node\" value=\"NAME\"/> or <integer name=\"primitive\" value=\"0\"/>",
        ));
    }
    let Some(chosen) = candidates.pop() else {
        let message = match is_free {
            true => "its scene shows no mesh",
            false => "its scene shows no such mesh",
        };
        let help = "expected a mesh, placed by a node, with this name or index";
        return Err(MeshFileError::choice(message, help));
    };
    let mut name = shown_name(chosen.mesh.name());
    if let Some(node) = &chosen.node {
        name = shown_name(node.name()).or(name);
        let place = format!("nodes[{}]", node.index());
        if node.skin().is_some() {
            let help = "export the mesh as it is to be seen, without a skin";
            let place = format!("{place}.skin");
            return Err(unsupported(&place, "skinned meshes are not read", help));
        }
        let instancing = "EXT_mesh_gpu_instancing";
        if file
            .keys(&format!("{place}.extensions"))
            .any(|name| name == instancing)
        {
            let message = format!("the extension \"{instancing}\" is not read");
            return Err(unsupported(&place, message, "export each copy as a node"));
        }
        let determinant = chosen.to_scene.determinant();
        if determinant == 0.0 || !determinant.is_finite() {
            let help = "scale by finite numbers other than 0";
            let message = "its transform cannot be inverted";
            return Err(MeshFileError::invalid(at(&place), message, help));
        }
    }
    let (mesh, primitive) = (chosen.mesh.index(), chosen.primitive.index());
    Ok(Placed {
        primitive: chosen.primitive,
        place: format!("meshes[{mesh}].primitives[{primitive}]"),
        to_scene: chosen.to_scene,
        name: name.map(str::to_owned),
    })
}

/// What the choice leaves of the file's scene. A file without scenes holds meshes in
/// their own coordinates.
fn candidates<'a>(
    file: &'a GltfFile,
    choice: &GltfChoice,
) -> Result<impl Iterator<Item = Candidate<'a>>, MeshFileError> {
    let document = &file.document;
    let is_wanted = |wanted: &Option<GltfName>, index: usize, name: Option<&str>| {
        wanted.as_ref().is_none_or(|wanted| wanted.is(index, name))
    };
    let nodes = file.nodes()?.iter().filter_map(move |&(index, to_scene)| {
        let node = document.nodes().nth(index)?;
        let mesh = node
            .mesh()
            .filter(|_| is_wanted(&choice.node, index, node.name()))?;
        Some((Some(node), to_scene, mesh))
    });
    let is_bare = document.as_json().scenes.is_empty() && choice.node.is_none();
    let bare = document.meshes().filter(move |_| is_bare);
    let meshes = nodes.chain(bare.map(|mesh| (None, Affine::IDENTITY, mesh)));
    let meshes =
        meshes.filter(move |(_, _, mesh)| is_wanted(&choice.mesh, mesh.index(), mesh.name()));
    Ok(meshes.flat_map(move |(node, to_scene, mesh)| {
        let primitives = mesh.primitives().filter(|primitive| {
            let wanted = choice.primitive.map(|index| index as usize);
            wanted.is_none_or(|wanted| wanted == primitive.index())
        });
        let candidate = |primitive| Candidate {
            node: node.clone(),
            to_scene,
            mesh: mesh.clone(),
            primitive,
        };
        primitives.map(candidate).collect::<Vec<_>>()
    }))
}

impl GltfFile {
    /// The nodes that the file's scene shows, parents before children, and from the coordinates of
    /// each to the scene's. A file without scenes shows none.
    pub fn nodes(&self) -> Result<&[(usize, Affine)], MeshFileError> {
        if let Some(nodes) = self.nodes.get() {
            return Ok(nodes);
        }
        let root = self.document.as_json();
        let scene = root.scene.map_or(0, |scene| scene.value());
        let roots = root.scenes.get(scene).map_or(&[][..], |scene| &scene.nodes);
        let mut seen = vec![false; root.nodes.len()];
        let waiting = roots.iter().rev();
        let mut waiting: Vec<(usize, Affine)> = waiting
            .map(|node| (node.value(), Affine::IDENTITY))
            .collect();
        let mut found = Vec::new();
        while let Some((index, parent)) = waiting.pop() {
            if std::mem::replace(&mut seen[index], true) {
                let help = "expected a tree: each node with one parent";
                let place = at(&format!("nodes[{index}]"));
                let message = "several nodes have it as a child";
                return Err(MeshFileError::invalid(place, message, help));
            }
            let to_scene = parent * transform(self, index)?;
            found.push((index, to_scene));
            let children = root.nodes[index].children.iter().flatten().rev();
            waiting.extend(children.map(|child| (child.value(), to_scene)));
        }
        Ok(self.nodes.get_or_init(|| found))
    }
}

/// From a node's coordinates to its parent's.
fn transform(file: &GltfFile, index: usize) -> Result<Affine, MeshFileError> {
    let node = &file.document.as_json().nodes[index];
    let place = |key: &str| format!("nodes[{index}].{key}");
    if node.matrix.is_some() {
        // Column after column.
        let m = file.numbers(&place("matrix"), [0.0; 16])?;
        if [m[3], m[7], m[11], m[15]] != [0.0, 0.0, 0.0, 1.0] {
            let help = "expected 0, 0, 0, 1 in its last row";
            let message = "the matrix is not affine";
            return Err(MeshFileError::invalid(at(&place("matrix")), message, help));
        }
        return Ok(Affine {
            rows: [0, 1, 2].map(|row| Vec3::new(m[row], m[row + 4], m[row + 8])),
            translation: Vec3::new(m[12], m[13], m[14]),
        });
    }
    let quaternion = file.numbers(&place("rotation"), [0.0, 0.0, 0.0, 1.0])?;
    let rotation = rotation(quaternion, &place("rotation"))?;
    let scale = Affine::scale(file.numbers(&place("scale"), [1.0; 3])?.into());
    let translation = file.numbers(&place("translation"), [0.0; 3])?.into();
    Ok(Affine::translate(translation) * rotation * scale)
}

/// The rotation of a quaternion x, y, z, w, which stands at a place.
fn rotation(given: [f64; 4], place: &str) -> Result<Affine, MeshFileError> {
    let length = given.iter().map(|x| x * x).sum::<f64>().sqrt();
    if (length - 1.0).abs() >= UNIT {
        let message = format!("the quaternion has the length {length}");
        return Err(MeshFileError::invalid(
            at(place),
            message,
            "expected one of length 1",
        ));
    }
    let [x, y, z, w] = given.map(|number| number / length);
    let rows = [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - z * w),
            2.0 * (x * z + y * w),
        ],
        [
            2.0 * (x * y + z * w),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - x * w),
        ],
        [
            2.0 * (x * z - y * w),
            2.0 * (y * z + x * w),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ];
    Ok(Affine {
        rows: rows.map(Vec3::from),
        translation: Vec3::zero(),
    })
}
