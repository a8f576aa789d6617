//! What holds for every tree, checked after the fact.

use super::{ChildKind, MAX_DEPTH, Topology};
use crate::aabb::Aabb;

/// A broken invariant of a tree, and where.
#[derive(Clone, Debug, PartialEq)]
pub enum TreeError {
    /// A primitive lies in no leaf, or in several.
    PrimitiveCount {
        /// The primitive: a face or an edge.
        primitive: usize,
        /// In how many leaves it lies.
        leaves: usize,
    },
    /// A node or leaf hangs below no parent, or below several.
    ParentCount {
        /// What it is.
        child: ChildKind,
        /// How many parents it has.
        parents: usize,
    },
    /// A child refers to a node or leaf that does not exist, or to a node
    /// before its parent.
    BadChild {
        /// The node.
        node: usize,
        /// Which of its children.
        slot: usize,
    },
    /// A leaf has too many primitives, or none.
    LeafSize {
        /// The leaf.
        leaf: usize,
        /// How many primitives it has.
        primitives: usize,
    },
    /// A leaf lies deeper than traversal stacks allow.
    TooDeep {
        /// The node at which the limit is passed.
        node: usize,
    },
    /// Something below a child pokes out of the child's box.
    Bounds {
        /// The node.
        node: usize,
        /// Which of its children.
        slot: usize,
        /// The primitive that pokes out.
        primitive: usize,
    },
    /// A child's cone of normals or view test misses a face normal.
    NormalCone {
        /// The node.
        node: usize,
        /// Which of its children.
        slot: usize,
        /// The edge with that face.
        edge: usize,
    },
    /// A child lacks a group that an edge below it has.
    Groups {
        /// The node.
        node: usize,
        /// Which of its children.
        slot: usize,
        /// The edge with that group.
        edge: usize,
    },
    /// The copy of a primitive in its leaf is not what the mesh has.
    LeafContent {
        /// The leaf.
        leaf: usize,
        /// The primitive.
        primitive: usize,
    },
}

impl std::fmt::Display for TreeError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::PrimitiveCount { primitive, leaves } => {
                write!(
                    f,
                    "primitive {primitive} lies in {leaves} leaves; expected 1"
                )
            }
            Self::ParentCount { child, parents } => {
                write!(
                    f,
                    "{child:?} has {parents} parents; expected 1 (the root: 0)"
                )
            }
            Self::BadChild { node, slot } => write!(
                f,
                "child {slot} of node {node} refers to nothing that comes after the node"
            ),
            Self::LeafSize { leaf, primitives } => {
                write!(f, "leaf {leaf} has {primitives} primitives")
            }
            Self::TooDeep { node } => write!(
                f,
                "below node {node} the tree is deeper than {MAX_DEPTH}, more than stacks hold"
            ),
            Self::Bounds {
                node,
                slot,
                primitive,
            } => write!(
                f,
                "primitive {primitive} pokes out of the box of child {slot} of node {node}"
            ),
            Self::NormalCone { node, slot, edge } => write!(
                f,
                "a face of edge {edge} is not covered by the normals of child {slot} of node {node}"
            ),
            Self::Groups { node, slot, edge } => write!(
                f,
                "child {slot} of node {node} lacks a group of edge {edge} below it"
            ),
            Self::LeafContent { leaf, primitive } => write!(
                f,
                "leaf {leaf} holds other numbers for primitive {primitive} than the mesh"
            ),
        }
    }
}

impl std::error::Error for TreeError {}

/// Checks that the nodes form one tree, that no leaf is too deep or too full,
/// and that each of `primitives` lies in exactly one leaf.
pub fn check_topology(
    topology: &Topology,
    primitives: usize,
    leaf_size: usize,
) -> Result<(), TreeError> {
    let mut node_parents = vec![0; topology.nodes.len()];
    let mut leaf_parents = vec![0; topology.leaf_count()];
    let mut depths = vec![0; topology.nodes.len()];
    for (node, children) in topology.nodes.iter().enumerate() {
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
    for leaf in 0..topology.leaf_count() {
        let members = topology.leaf(leaf);
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
    topology: &Topology,
    mut check: impl FnMut(usize, usize, usize) -> Result<(), E>,
) -> Result<(), E> {
    let leaves = super::refit::child_leaves(topology);
    for (node, ranges) in leaves.iter().enumerate() {
        for (slot, range) in ranges.iter().enumerate() {
            for leaf in range.clone() {
                for &primitive in topology.leaf(leaf as usize) {
                    check(node, slot, primitive as usize)?;
                }
            }
        }
    }
    Ok(())
}

/// Checks that the boxes of the children contain the primitives below them.
pub fn check_bounds(
    topology: &Topology,
    child_bounds: impl Fn(usize, usize) -> Aabb,
    primitive_fits: impl Fn(&Aabb, usize) -> bool,
) -> Result<(), TreeError> {
    for_each_below(topology, |node, slot, primitive| {
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
