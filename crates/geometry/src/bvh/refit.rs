//! Bounds of all nodes from those of the leaves, from the bottom up.

use std::ops::Range;

use super::hierarchy::{Child, ChildKind, Hierarchy, WIDTH};
use crate::aabb::Aabb;

/// The box of each child of each node; empty for empty slots.
pub fn child_bounds(hierarchy: &Hierarchy, leaf_bounds: &[Aabb]) -> Vec<[Aabb; WIDTH]> {
    fold_up(
        hierarchy,
        Aabb::EMPTY,
        |leaf| leaf_bounds[leaf],
        Aabb::union,
    )
}

/// The leaves below each child of each node; `0..0` for empty slots.
pub fn child_leaves(hierarchy: &Hierarchy) -> Vec<[Range<u32>; WIDTH]> {
    let leaf = |leaf: usize| leaf as u32..leaf as u32 + 1;
    fold_up(hierarchy, 0..0, leaf, |a, b| {
        match (a.is_empty(), b.is_empty()) {
            (true, _) => b.clone(),
            (_, true) => a.clone(),
            _ => a.start.min(b.start)..a.end.max(b.end),
        }
    })
}

/// For each child of each node, whether `holds` for any of the leaves below it.
pub fn any_below(hierarchy: &Hierarchy, holds: impl Fn(usize) -> bool) -> Vec<[bool; WIDTH]> {
    fold_up(hierarchy, false, holds, |&a, &b| a || b)
}

/// What `merge` makes of everything below each child.
fn fold_up<T: Clone>(
    hierarchy: &Hierarchy,
    empty: T,
    leaf: impl Fn(usize) -> T,
    merge: impl Fn(&T, &T) -> T,
) -> Vec<[T; WIDTH]> {
    let none: [T; WIDTH] = std::array::from_fn(|_| empty.clone());
    let mut folded = vec![none; hierarchy.nodes.len()];
    // Children come after their parents, so this meets them first.
    for (node, children) in hierarchy.nodes.iter().enumerate().rev() {
        for (i, child) in children
            .iter()
            .map(|child: &Child| child.kind())
            .enumerate()
        {
            folded[node][i] = match child {
                None => continue,
                Some(ChildKind::Leaf(index)) => leaf(index),
                Some(ChildKind::Node(index)) => folded[index]
                    .iter()
                    .fold(empty.clone(), |a, b| merge(&a, b)),
            };
        }
    }
    folded
}
