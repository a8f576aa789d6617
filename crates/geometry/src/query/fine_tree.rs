//! Trees in trees: where small things stand in a wide scene, each has coordinates of its own.
//!
//! Single precision, in the coordinates of a whole scene, does not tell the triangles of a thing
//! apart that is millions of times smaller: each query near it would test them all. Here such a
//! part is a tree of its own, in its own coordinates, and so are its parts.

use std::sync::Arc;

use rayon::prelude::*;

use super::pieces::Pieces;
use super::ray_kernel::{RayNode, TriangleBlock};
use super::sphere::MeshSphere;
use super::triangle_tree::{Part, SpherePart, TriangleTree};
use crate::aabb::Aabb;
use crate::bvh::{Child, ChildKind, Hierarchy, WIDTH, child_bounds, child_leaves};
use crate::halt::Halt;
use crate::local_frame::LocalFrame;

/// Leaves that are smaller than this, in local units, are not told apart: sixteen times what
/// single precision adds up to where a ray meets a box (2⁻²⁰).
const RESOLVED: f64 = 1.0 / (1 << 16) as f64;

/// Parts with fewer leaves are searched leaf by leaf.
const FEW_LEAVES: usize = 16;

/// True if something in a tree with these boxes is so small that it should be a part.
pub fn has_unresolved(hierarchy: &Hierarchy, bounds: &[[Aabb; WIDTH]]) -> bool {
    let is_inner = |child: &Child| matches!(child.kind(), Some(ChildKind::Node(_)));
    let largest = size_of_unresolved(hierarchy.leaf_count());
    let is_small = |(child, bounds): (&Child, &Aabb)| is_inner(child) && size(bounds) < largest;
    let mut nodes = hierarchy.nodes.iter().zip(bounds);
    if !nodes.any(|(children, bounds)| children.iter().zip(bounds).any(is_small)) {
        return false;
    }
    let below = child_leaves(hierarchy);
    let mut nodes = hierarchy.nodes.iter().zip(bounds).zip(&below);
    nodes.any(|((children, bounds), below)| {
        let is_part = |slot: usize| is_unresolved(&bounds[slot], below[slot].len());
        (0..WIDTH).any(|slot| is_inner(&children[slot]) && is_part(slot))
    })
}

/// The tree over some pieces of a mesh, cut where small parts begin; an empty one if the work is
/// given up.
pub fn fine_tree(all: Pieces<'_>, pieces: Vec<u32>, halt: &Halt) -> TriangleTree {
    let frame = all.frame(&pieces);
    let hierarchy = all.hierarchy(pieces, &frame, halt);
    let leaf_bounds: Vec<Aabb> = (0..hierarchy.leaf_count())
        .map(|leaf| all.leaf_bounds(&frame, hierarchy.leaf(leaf)))
        .collect();
    let mut cut = Cut {
        all,
        frame: &frame,
        bounds: child_bounds(&hierarchy, &leaf_bounds),
        below: child_leaves(&hierarchy),
        hierarchy: &hierarchy,
        nodes: Vec::new(),
        leaves: Vec::new(),
        parts: Vec::new(),
    };
    if !hierarchy.nodes.is_empty() {
        cut.add_node(0);
    }
    let (mut nodes, leaves, parts) = (cut.nodes, cut.leaves, cut.parts);
    // Only now is known how many leaves come before the parts.
    for child in nodes.iter_mut().flat_map(|node| &mut node.children) {
        if let Some(ChildKind::Leaf(number)) = child.kind()
            && number >= FIRST_PART
        {
            *child = Child::leaf(leaves.len() + number - FIRST_PART);
        }
    }
    TriangleTree {
        has_no_trees: !parts.iter().any(|part| matches!(part, CutPart::Tree(_))),
        parts: parts
            .into_par_iter()
            .map(|part| match part {
                CutPart::Tree(pieces) => Part::Tree(fine_tree(all, pieces, halt)),
                CutPart::Sphere(sphere) => Part::Sphere(SpherePart::new(sphere)),
            })
            .collect(),
        frame,
        nodes,
        leaves,
    }
}

/// Numbers of parts while leaves are still counted: more than there are leaves, of which a
/// hierarchy numbers fewer than 2³¹, and a part has several, or hundreds of triangles.
const FIRST_PART: usize = 1 << 30;

/// A tree that is cut where parts begin.
struct Cut<'a> {
    all: Pieces<'a>,
    frame: &'a LocalFrame,
    hierarchy: &'a Hierarchy,
    bounds: Vec<[Aabb; WIDTH]>,
    below: Vec<[std::ops::Range<u32>; WIDTH]>,
    nodes: Vec<RayNode>,
    leaves: Vec<TriangleBlock>,
    parts: Vec<CutPart>,
}

/// What becomes a part.
enum CutPart {
    /// A tree over these pieces.
    Tree(Vec<u32>),
    Sphere(Arc<MeshSphere>),
}

impl Cut<'_> {
    /// Adds a node of the hierarchy and what is below it; its number.
    fn add_node(&mut self, node: usize) -> usize {
        let number = self.nodes.len();
        let bounds = self.bounds[node];
        self.nodes.push(RayNode::new(&bounds, [Child::NONE; WIDTH]));
        for slot in 0..WIDTH {
            let child = match self.hierarchy.nodes[node][slot].kind() {
                None => continue,
                Some(ChildKind::Leaf(leaf)) => {
                    let own = self.hierarchy.leaf(leaf);
                    match self.all.sphere_in(own) {
                        Some(sphere) => self.add_part(CutPart::Sphere(sphere.clone())),
                        None => {
                            self.leaves.push(TriangleBlock::new(self.all.mesh, own));
                            Child::leaf(self.leaves.len() - 1)
                        }
                    }
                }
                Some(ChildKind::Node(inner)) => match self.small(node, slot) {
                    Some(pieces) => self.add_part(CutPart::Tree(pieces)),
                    None => Child::node(self.add_node(inner)),
                },
            };
            self.nodes[number].children[slot] = child;
        }
        number
    }

    fn add_part(&mut self, part: CutPart) -> Child {
        self.parts.push(part);
        Child::leaf(FIRST_PART + self.parts.len() - 1)
    }

    /// The pieces below a child, if they should be a part.
    fn small(&self, node: usize, slot: usize) -> Option<Vec<u32>> {
        let below = self.below[node][slot].clone();
        if !is_unresolved(&self.bounds[node][slot], below.len()) {
            return None;
        }
        let pieces: Vec<u32> = below
            .flat_map(|leaf| self.hierarchy.leaf(leaf as usize))
            .copied()
            .collect();
        // Unless it has no extent at all, with which nothing is told apart.
        (self.all.frame(&pieces).scale < self.frame.scale).then_some(pieces)
    }
}

/// The longest side of a box.
fn size(bounds: &Aabb) -> f64 {
    let [x, y, z] = bounds.extent();
    f64::from(x.max(y).max(z))
}

/// So many leaves in a box smaller than this are not told apart: on a surface, each is as wide as
/// all, over the square root of their number.
fn size_of_unresolved(leaves: usize) -> f64 {
    RESOLVED * (leaves as f64).sqrt()
}

fn is_unresolved(bounds: &Aabb, leaves: usize) -> bool {
    leaves >= FEW_LEAVES && size(bounds) < size_of_unresolved(leaves)
}
