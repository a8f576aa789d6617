//! Whether the trees are what they should be: checked in tests.

use super::edge_block::EdgeBlock;
use super::pieces::Pieces;
use super::ray_kernel::{LANES, TriangleBlock};
use super::ray_tree::RayTree;
use super::silhouette_tree::{self, SilhouetteTree};
use super::tree_edge::TreeEdge;
use crate::bvh::Hierarchy;
use crate::bvh::validate::{self, TreeError};
use crate::edge::Edge;
use crate::mesh::Mesh;

impl RayTree {
    /// Checks the tree against the mesh it should represent.
    pub fn validate(&self, mesh: &Mesh) -> Result<(), TreeError> {
        let pieces = Pieces {
            mesh,
            spheres: &self.spheres,
        };
        let all = pieces.all();
        // By their places among all pieces.
        let place = |piece: &u32| all.binary_search(piece).map_or(u32::MAX, |i| i as u32);
        let hierarchy = &Hierarchy {
            order: self.hierarchy.order.iter().map(place).collect(),
            ..self.hierarchy.clone()
        };
        validate::check_hierarchy(hierarchy, all.len(), LANES)?;
        for leaf in 0..hierarchy.leaf_count() {
            let own = self.hierarchy.leaf(leaf);
            let is_followed = match pieces.sphere_in(own) {
                None => self.flat.leaves[leaf] == TriangleBlock::new(mesh, own),
                Some(sphere) => sphere
                    .faces()
                    .zip(0..)
                    .all(|(face, own)| sphere.corners_of(own) == mesh.corners(face as usize)),
            };
            if !is_followed {
                let primitive = own[0] as usize;
                return Err(TreeError::LeafContent { leaf, primitive });
            }
        }
        validate::check_bounds(
            hierarchy,
            |node, slot| self.flat.nodes[node].child_bounds(slot),
            |bounds, place| {
                let piece = all[place];
                let faces = match pieces.sphere_in(&[piece]) {
                    None => piece..piece + 1,
                    Some(sphere) => sphere.faces(),
                };
                faces
                    .flat_map(|face| mesh.corners(face as usize))
                    .all(|p| bounds.contains_point(self.flat.frame.local_from_world(p)))
            },
        )
    }
}

impl SilhouetteTree {
    /// Checks the tree against the mesh and edges it should represent.
    pub fn validate(&self, mesh: &Mesh, edges: &[Edge]) -> Result<(), TreeError> {
        let hierarchy = &self.hierarchy;
        validate::check_hierarchy(hierarchy, edges.len(), silhouette_tree::LEAF_SIZE)?;
        let expected = |id: u32| TreeEdge::new(mesh, id, &edges[id as usize]);
        for leaf in 0..hierarchy.leaf_count() {
            let mut local = Vec::new();
            for (place, &id) in (hierarchy.leaf_starts[leaf] as usize..).zip(hierarchy.leaf(leaf)) {
                let edge = expected(id);
                if self.edges[place] != edge || self.sources[place] != edges[id as usize] {
                    let primitive = id as usize;
                    return Err(TreeError::LeafContent { leaf, primitive });
                }
                local.push(edge.local(&self.frame, edges[id as usize].groups));
            }
            let start = hierarchy.leaf_starts[leaf] as usize;
            if self.leaves[leaf] != EdgeBlock::new(start, &local) {
                let primitive = hierarchy.leaf(leaf)[0] as usize;
                return Err(TreeError::LeafContent { leaf, primitive });
            }
        }
        validate::for_each_below(hierarchy, |node, slot, edge| {
            let local = expected(edge as u32).local(&self.frame, edges[edge].groups);
            let child = &self.nodes[node];
            if !child.contains(slot, &local) {
                let primitive = edge;
                return Err(TreeError::Bounds {
                    node,
                    slot,
                    primitive,
                });
            }
            if !child.covers(slot, &local) {
                return Err(TreeError::NormalCone { node, slot, edge });
            }
            if child.groups(slot) & local.groups != local.groups {
                return Err(TreeError::Groups { node, slot, edge });
            }
            Ok(())
        })
    }
}
