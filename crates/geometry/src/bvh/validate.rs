//! What holds for every tree, checked after the fact.

use super::hierarchy::{ChildKind, Hierarchy, MAX_DEPTH};
use super::refit::child_leaves;
use crate::aabb::Aabb;

/// A broken invariant of a tree, and where.
#[derive(Clone, Debug, PartialEq)]
pub enum TreeError {
    /// A primitive lies in no leaf, or in several.
    PrimitiveCount { primitive: usize, leaves: usize },
    /// A node or leaf hangs below no parent, or below several.
    ParentCount { child: ChildKind, parents: usize },
    /// A child refers to a node or leaf that does not exist, or to a node
    /// before its parent.
    BadChild { node: usize, slot: usize },
    /// A leaf has too many primitives, or none.
    LeafSize { leaf: usize, primitives: usize },
    /// A leaf lies deeper than traversal stacks allow.
    TooDeep { node: usize },
    /// Something below a child pokes out of the child's box.
    Bounds {
        node: usize,
        slot: usize,
        primitive: usize,
    },
    /// A child's cone of normals or view test misses a face normal.
    NormalCone {
        node: usize,
        slot: usize,
        edge: usize,
    },
    /// A child lacks a group that an edge below it has.
    Groups {
        node: usize,
        slot: usize,
        edge: usize,
    },
    /// The copy of a primitive in its leaf is not what the mesh has.
    LeafContent { leaf: usize, primitive: usize },
}

/// Checks that the nodes form one tree, that no leaf is too deep or too full,
/// and that each of `primitives` lies in exactly one leaf.
pub fn check_hierarchy(
    hierarchy: &Hierarchy,
    primitives: usize,
    leaf_size: usize,
) -> Result<(), TreeError> {
    let mut node_parents = vec![0; hierarchy.nodes.len()];
    let mut leaf_parents = vec![0; hierarchy.leaf_count()];
    let mut depths = vec![0; hierarchy.nodes.len()];
    for (node, children) in hierarchy.nodes.iter().enumerate() {
        if depths[node] >= MAX_DEPTH {
            return Err(TreeError::TooDeep { node });
        }
        for (slot, child) in children.iter().enumerate() {
            match child.kind() {
                None => {}
                Some(ChildKind::Node(index)) if node < index && index < node_parents.len() => {
                    node_parents[index] += 1;
                    depths[index] = depths[node] + 1;
                }
                Some(ChildKind::Leaf(index)) if index < leaf_parents.len() => {
                    leaf_parents[index] += 1;
                }
                Some(_) => return Err(TreeError::BadChild { node, slot }),
            }
        }
    }
    let node_children = node_parents.iter().enumerate().skip(1);
    let children = node_children
        .map(|(i, &parents)| (ChildKind::Node(i), parents))
        .chain(
            leaf_parents
                .iter()
                .enumerate()
                .map(|(i, &parents)| (ChildKind::Leaf(i), parents)),
        );
    for (child, parents) in children {
        if parents != 1 {
            return Err(TreeError::ParentCount { child, parents });
        }
    }
    let mut leaves_of = vec![0; primitives];
    for leaf in 0..hierarchy.leaf_count() {
        let members = hierarchy.leaf(leaf);
        if members.is_empty() || members.len() > leaf_size {
            let primitives = members.len();
            return Err(TreeError::LeafSize { leaf, primitives });
        }
        for &member in members {
            leaves_of[member as usize] += 1;
        }
    }
    match leaves_of.iter().position(|&leaves| leaves != 1) {
        Some(primitive) => Err(TreeError::PrimitiveCount {
            primitive,
            leaves: leaves_of[primitive],
        }),
        None => Ok(()),
    }
}

/// Calls `check` for every child and every primitive below it.
pub fn for_each_below<E>(
    hierarchy: &Hierarchy,
    mut check: impl FnMut(usize, usize, usize) -> Result<(), E>,
) -> Result<(), E> {
    let leaves = child_leaves(hierarchy);
    for (node, ranges) in leaves.iter().enumerate() {
        for (slot, range) in ranges.iter().enumerate() {
            for leaf in range.clone() {
                for &primitive in hierarchy.leaf(leaf as usize) {
                    check(node, slot, primitive as usize)?;
                }
            }
        }
    }
    Ok(())
}

/// Checks that the boxes of the children contain the primitives below them.
pub fn check_bounds(
    hierarchy: &Hierarchy,
    child_bounds: impl Fn(usize, usize) -> Aabb,
    primitive_fits: impl Fn(&Aabb, usize) -> bool,
) -> Result<(), TreeError> {
    for_each_below(hierarchy, |node, slot, primitive| {
        if primitive_fits(&child_bounds(node, slot), primitive) {
            Ok(())
        } else {
            Err(TreeError::Bounds {
                node,
                slot,
                primitive,
            })
        }
    })
}
