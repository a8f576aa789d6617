//! From two children per node to eight: which nodes of the binary tree become
//! nodes of the wide one.
//!
//! A node is visited about in proportion to its surface, so the sum of their
//! surfaces is to be least. It is found from the bottom up: what a subtree
//! costs as one tree, and opened to two, three, ... trees among which its parent
//! can choose (Ylitie, Karras, Laine 2017, section 3.2).

use super::binary::BinaryNode;
use super::hierarchy::{Child, Hierarchy, WIDTH};

/// What a subtree costs, by the largest number of trees it may come as, less
/// one.
#[derive(Clone, Copy)]
struct Plan {
    cost: [f32; WIDTH],
    /// How many of those trees come from the left half; 0 if it stays one tree.
    /// First: how many of the children if it becomes a node.
    left: [u8; WIDTH],
}

/// Fills the hierarchy with nodes and leaves; leaves in the order of their
/// primitives.
pub fn widen(binary: &[BinaryNode], hierarchy: &mut Hierarchy) {
    // Leaves cost the same whatever is above them.
    let leaf = Plan {
        cost: [0.0; WIDTH],
        left: [0; WIDTH],
    };
    let mut plans = vec![leaf; binary.len()];
    plan(binary, &mut plans, 0);
    push_node(binary, &plans, 0, hierarchy);
}

fn plan(binary: &[BinaryNode], plans: &mut [Plan], slot: usize) {
    let Some(halves) = binary[slot].halves(slot) else {
        return;
    };
    let [left, right] = halves.map(|half| {
        plan(binary, plans, half);
        plans[half].cost
    });
    // The least cost of the two halves as `count` trees together, and how many of them
    // come from the left.
    let opened = |count: usize| {
        let cost = |of_left: usize| left[of_left - 1] + right[count - of_left - 1];
        (1..count)
            .map(|of_left| (cost(of_left), of_left as u8))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .expect("two trees are one on each side")
    };
    // As one tree, the subtree is a node with eight children: its own surface, and theirs.
    let (below, of_left) = opened(WIDTH);
    let as_one = binary[slot].half_area + below;
    let mut plan = Plan {
        cost: [as_one; WIDTH],
        left: [0; WIDTH],
    };
    plan.left[0] = of_left;
    // As several, it has no node of its own; where that costs more it stays one.
    for count in 2..=WIDTH {
        let (cost, of_left) = opened(count);
        if cost <= as_one {
            plan.cost[count - 1] = cost;
            plan.left[count - 1] = of_left;
        }
    }
    plans[slot] = plan;
}

/// Appends the wide node for the binary node at `slot`, and all below it; its
/// index.
fn push_node(
    binary: &[BinaryNode],
    plans: &[Plan],
    slot: usize,
    hierarchy: &mut Hierarchy,
) -> usize {
    let mut children = Vec::with_capacity(WIDTH);
    match binary[slot].halves(slot) {
        Some([left, right]) => {
            let of_left = usize::from(plans[slot].left[0]);
            open(binary, plans, left, of_left, &mut children);
            open(binary, plans, right, WIDTH - of_left, &mut children);
        }
        None => children.push(slot), // everything is in one leaf
    }
    let index = hierarchy.nodes.len();
    hierarchy.nodes.push([Child::NONE; WIDTH]);
    for (i, &child) in children.iter().enumerate() {
        let node = &binary[child];
        hierarchy.nodes[index][i] = if node.halves(child).is_none() {
            hierarchy.leaf_starts.push(node.start);
            Child::leaf(hierarchy.leaf_starts.len() - 1)
        } else {
            Child::node(push_node(binary, plans, child, hierarchy))
        };
    }
    index
}

/// Appends the slots of the trees that the subtree comes as, at most `count`.
fn open(
    binary: &[BinaryNode],
    plans: &[Plan],
    slot: usize,
    count: usize,
    children: &mut Vec<usize>,
) {
    let of_left = usize::from(plans[slot].left[count - 1]);
    match binary[slot].halves(slot) {
        Some([left, right]) if count > 1 && of_left > 0 => {
            open(binary, plans, left, of_left, children);
            open(binary, plans, right, count - of_left, children);
        }
        _ => children.push(slot),
    }
}
