//! The nodes of a glTF scene: what they place where, and which of it is meant.

use capwalk_math::{Affine, Vec3};

use super::error::MeshFileError;
use super::gltf_json::Item;

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
    fn is(&self, index: usize, item: &Item) -> bool {
        match self {
            Self::Index(wanted) => *wanted as usize == index,
            Self::Name(wanted) => name(item) == Some(wanted),
        }
    }
}

/// A primitive that was chosen.
pub(super) struct Placed<'a> {
    pub primitive: Item<'a>,
    /// From its coordinates to the scene's; can be inverted.
    pub to_scene: Affine,
    /// What the node or the mesh is called.
    pub name: Option<String>,
}

/// The name of an object, if it has one that can be shown.
fn name<'a>(item: &Item<'a>) -> Option<&'a str> {
    let name = item.get("name")?.as_text().ok()?;
    (!name.is_empty() && !name.chars().any(char::is_control)).then_some(name)
}

/// A mesh and the node that places it.
struct Candidate<'a> {
    node: Option<(usize, Item<'a>)>,
    to_scene: Affine,
    mesh: (usize, Item<'a>),
    primitive: usize,
}

impl Candidate<'_> {
    /// As it is listed: `node 3 "Lid", mesh 1 "Disk", primitive 0`.
    fn title(&self) -> String {
        let title = |kind: &str, (index, item): &(usize, Item)| match name(item) {
            Some(name) => format!("{kind} {index} \"{name}\", "),
            None => format!("{kind} {index}, "),
        };
        let node = self
            .node
            .as_ref()
            .map_or(String::new(), |n| title("node", n));
        let mesh = title("mesh", &self.mesh);
        format!("{node}{mesh}primitive {}", self.primitive)
    }
}

/// The one primitive that the choice leaves.
pub(super) fn choose<'a>(
    root: &Item<'a>,
    choice: &GltfChoice,
) -> Result<Placed<'a>, MeshFileError> {
    let mut candidates = candidates(root, choice)?;
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
    let mut name_of = name(&chosen.mesh.1);
    if let Some((_, node)) = &chosen.node {
        name_of = name(node).or(name_of);
        if let Some(skin) = node.get("skin") {
            let help = "export the mesh as it is to be seen, without a skin";
            return Err(skin.unsupported("skinned meshes are not read", help));
        }
        let instancing = "EXT_mesh_gpu_instancing";
        if node
            .get("extensions")
            .is_some_and(|e| e.get(instancing).is_some())
        {
            let message = format!("the extension \"{instancing}\" is not read");
            return Err(node.unsupported(message, "export each copy as a node"));
        }
        let determinant = chosen.to_scene.determinant();
        if determinant == 0.0 || !determinant.is_finite() {
            let help = "scale by finite numbers other than 0";
            return Err(node.invalid("its transform cannot be inverted", help));
        }
    }
    Ok(Placed {
        primitive: chosen.mesh.1.entry("primitives", chosen.primitive)?,
        to_scene: chosen.to_scene,
        name: name_of.map(str::to_owned),
    })
}

/// What the choice leaves of the file's scene, at most one more than a message
/// lists. A file without scenes holds meshes in their own coordinates.
fn candidates<'a>(
    root: &Item<'a>,
    choice: &GltfChoice,
) -> Result<Vec<Candidate<'a>>, MeshFileError> {
    let mut found = Vec::new();
    let mut add = |node: Option<(usize, Item<'a>)>, to_scene: Affine, mesh: usize| {
        let mesh = (mesh, root.entry("meshes", mesh)?);
        if choice
            .mesh
            .as_ref()
            .is_some_and(|wanted| !wanted.is(mesh.0, &mesh.1))
        {
            return Ok(true);
        }
        let count = mesh.1.count("primitives")?;
        let range = match choice.primitive {
            None => 0..count,
            Some(index) => index as usize..count.min(index as usize + 1),
        };
        for primitive in range {
            let (node, mesh) = (node.clone(), mesh.clone());
            found.push(Candidate {
                node,
                to_scene,
                mesh,
                primitive,
            });
            if found.len() > LISTED {
                return Ok(false);
            }
        }
        Ok::<bool, MeshFileError>(true)
    };
    let scenes = root.count("scenes")?;
    if scenes == 0 && choice.node.is_none() {
        for mesh in 0..root.count("meshes")? {
            if !add(None, Affine::IDENTITY, mesh)? {
                break;
            }
        }
        return Ok(found);
    }
    let scene = root.get("scene").map_or(Ok(0), |scene| scene.as_index())?;
    let scene = root.entry("scenes", scene)?;
    let mut seen = vec![false; root.count("nodes")?];
    let mut waiting: Vec<(usize, Affine)> = Vec::new();
    let wait = |waiting: &mut Vec<_>, item: &Item, list: &str, to_scene: Affine| {
        let nodes = item.indices(list)?;
        waiting.extend(nodes.into_iter().rev().map(|node| (node, to_scene)));
        Ok::<(), MeshFileError>(())
    };
    wait(&mut waiting, &scene, "nodes", Affine::IDENTITY)?;
    while let Some((index, parent)) = waiting.pop() {
        let node = root.entry("nodes", index)?;
        if std::mem::replace(&mut seen[index], true) {
            let help = "expected a tree: each node with one parent";
            return Err(node.invalid("several nodes have it as a child", help));
        }
        let to_scene = parent * transform(&node)?;
        let is_wanted = choice
            .node
            .as_ref()
            .is_none_or(|wanted| wanted.is(index, &node));
        if is_wanted && let Some(mesh) = node.get("mesh") {
            let node = Some((index, node.clone()));
            if !add(node, to_scene, mesh.as_index()?)? {
                break;
            }
        }
        wait(&mut waiting, &node, "children", to_scene)?;
    }
    Ok(found)
}

/// From a node's coordinates to its parent's.
fn transform(node: &Item) -> Result<Affine, MeshFileError> {
    if let Some(item) = node.get("matrix") {
        // Column after column.
        let m = item.as_numbers::<16>()?;
        if [m[3], m[7], m[11], m[15]] != [0.0, 0.0, 0.0, 1.0] {
            let help = "expected 0, 0, 0, 1 in its last row";
            return Err(item.invalid("the matrix is not affine", help));
        }
        return Ok(Affine {
            rows: [0, 1, 2].map(|row| Vec3::new(m[row], m[row + 4], m[row + 8])),
            translation: Vec3::new(m[12], m[13], m[14]),
        });
    }
    let vector = |key: &str, default: f64| match node.get(key) {
        Some(item) => item.as_numbers().map(Vec3::from),
        None => Ok(Vec3::splat(default)),
    };
    let rotation = match node.get("rotation") {
        Some(item) => rotation(&item)?,
        None => Affine::IDENTITY,
    };
    let scale = Affine::scale(vector("scale", 1.0)?);
    Ok(Affine::translate(vector("translation", 0.0)?) * rotation * scale)
}

/// The rotation of a quaternion x, y, z, w.
fn rotation(item: &Item) -> Result<Affine, MeshFileError> {
    let given: [f64; 4] = item.as_numbers()?;
    let length = given.iter().map(|x| x * x).sum::<f64>().sqrt();
    if (length - 1.0).abs() >= UNIT {
        let message = format!("the quaternion has the length {length}");
        return Err(item.invalid(message, "expected one of length 1"));
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
