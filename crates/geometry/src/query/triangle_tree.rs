//! Trees of triangles, of which parts may be trees of their own, or spheres.

use std::sync::{Arc, OnceLock};

use super::ray_kernel::{RayNode, TriangleBlock};
use super::sphere::MeshSphere;
use crate::aabb::Aabb;
use crate::bvh::{Child, ChildKind, child_bounds};
use crate::local_frame::LocalFrame;

/// A tree of triangles, of which parts are trees of their own, or spheres.
#[derive(Clone, Debug)]
pub struct TriangleTree {
    /// The coordinates of its nodes.
    pub frame: LocalFrame,
    pub nodes: Vec<RayNode>,
    pub leaves: Vec<TriangleBlock>,
    /// Behind the numbers of the leaves come those of the parts.
    pub parts: Vec<Part>,
    /// True if no part is a tree.
    pub has_no_trees: bool,
}

/// A part of a tree.
#[derive(Clone, Debug)]
pub enum Part {
    /// With coordinates of its own.
    Tree(TriangleTree),
    Sphere(SpherePart),
}

/// A sphere in a tree.
#[derive(Clone, Debug)]
pub struct SpherePart {
    pub sphere: Arc<MeshSphere>,
    tree: Arc<OnceLock<TriangleTree>>,
}

impl SpherePart {
    pub fn new(sphere: Arc<MeshSphere>) -> Self {
        Self {
            sphere,
            tree: Arc::default(),
        }
    }

    /// Its triangles as a tree, made when first asked for: for what is not done with it as a whole.
    pub fn tree(&self) -> &TriangleTree {
        self.tree
            .get_or_init(|| TriangleTree::of_sphere(&self.sphere))
    }
}

impl TriangleTree {
    fn of_sphere(sphere: &MeshSphere) -> Self {
        let frame = LocalFrame::around(sphere.corners());
        let hierarchy = sphere.hierarchy();
        let leaves: Vec<TriangleBlock> = (0..hierarchy.leaf_count())
            .map(|leaf| sphere.block(hierarchy.leaf(leaf)))
            .collect();
        let bounds_of = |block: &TriangleBlock| {
            let lanes = block.faces().enumerate();
            let corners = lanes.flat_map(|(lane, _)| block.corners_of(lane));
            Aabb::around(corners.map(|p| frame.local_from_world(p)))
        };
        let leaf_bounds: Vec<Aabb> = leaves.iter().map(bounds_of).collect();
        let bounds = child_bounds(hierarchy, &leaf_bounds);
        let nodes = bounds.iter().zip(&hierarchy.nodes);
        Self {
            nodes: nodes
                .map(|(bounds, &own)| RayNode::new(bounds, own))
                .collect(),
            leaves,
            frame,
            parts: Vec::new(),
            has_no_trees: true,
        }
    }

    /// The part with the number of a leaf, behind those of the leaves.
    #[inline(always)]
    pub fn part(&self, leaf: usize) -> &Part {
        &self.parts[leaf - self.leaves.len()]
    }

    /// The sphere that a child is which is no node and no block of triangles, in a tree that has no
    /// trees.
    #[inline(always)]
    pub fn sphere(&self, child: Child) -> &MeshSphere {
        match child.kind() {
            Some(ChildKind::Leaf(leaf)) if let Part::Sphere(part) = self.part(leaf) => &part.sphere,
            _ => unreachable!("{child:?} is no sphere"),
        }
    }
}
