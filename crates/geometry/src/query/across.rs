//! The triangles that cross a wedge.

use super::ray_tree::RayTree;
use super::triangle_tree::{Part, TriangleTree};
use crate::bvh::{Child, ChildKind};
use crate::mesh::Mesh;
use crate::wedge::{Wedge, WedgePoint};

/// How far off boxes may be, beside their own rounding: as parts of the tree's size, and of
/// its distance from the world's origin.
const MARGIN: [f64; 2] = [1e-9, 1e-14];

impl RayTree {
    /// Where triangles cross a wedge: the faces with their sections, in ascending order.
    /// `mesh` is the one that the tree follows, `found` is memory.
    ///
    /// Answers are those of [`oracle::across`](crate::oracle::across), to the bit.
    pub fn across(&self, mesh: &Mesh, wedge: &Wedge, found: &mut Vec<(u32, [WedgePoint; 2])>) {
        found.clear();
        add_across(self.searched(), mesh, wedge, found);
        found.sort_unstable_by_key(|&(face, _)| face);
    }
}

/// Adds the sections of the faces in a tree and in its parts.
fn add_across(
    tree: &TriangleTree,
    mesh: &Mesh,
    wedge: &Wedge,
    found: &mut Vec<(u32, [WedgePoint; 2])>,
) {
    if tree.nodes.is_empty() {
        return;
    }
    let frame = &tree.frame;
    let margin = MARGIN[0] * frame.scale + MARGIN[1] * frame.reach;
    let mut open = vec![Child::node(0)];
    while let Some(child) = open.pop() {
        match child.kind() {
            Some(ChildKind::Node(node)) => {
                let node = &tree.nodes[node];
                let slots = node.children.iter().enumerate();
                let met = slots.filter(|&(slot, child)| {
                    child.kind().is_some() && {
                        let [middle, half] = node.child_box(slot);
                        let middle = frame.centre + middle * frame.scale;
                        wedge.meets_box(middle, half * frame.scale, margin)
                    }
                });
                open.extend(met.map(|(_, &child)| child));
            }
            Some(ChildKind::Leaf(leaf)) => match tree.leaves.get(leaf) {
                Some(leaf) => found.extend(leaf.faces().filter_map(|face| {
                    let section = wedge.section(mesh.corners(face as usize))?;
                    Some((face, section))
                })),
                None => {
                    let tree = match tree.part(leaf) {
                        Part::Tree(tree) => tree,
                        Part::Sphere(sphere) => sphere.tree(),
                    };
                    add_across(tree, mesh, wedge, found);
                }
            },
            None => {}
        }
    }
}
