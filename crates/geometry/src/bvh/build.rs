//! Building a tree: binned surface-area splits (Wald 2007), then up to eight
//! neighbouring subtrees gathered under one node (`widen.rs`).
//!
//! Large ranges are split in parallel. Which thread does what cannot change
//! the result: each range of primitives has its own slots for its nodes.

use super::binary::BinaryNode;
use super::hierarchy::{Hierarchy, MAX_DEPTH};
use super::widen::widen;
use crate::aabb::Aabb;
use crate::halt::Halt;

/// Bins per axis. More find slightly better splits and cost building time.
const BINS: usize = 16;
/// Bins per axis where splits are to be fine, in ranges of at least so many primitives.
const FINE_BINS: usize = 64;
const FINE_MINIMUM: usize = 2048;

/// How well large ranges are split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Splits {
    Coarse,
    /// A tree that takes a little longer to build and is searched faster.
    Fine,
    /// As fine, by this thread alone.
    Alone,
}

/// Which primitives leaves may have.
#[derive(Clone, Copy, Debug)]
pub struct Leaves {
    /// No more than so many.
    pub size: usize,
    /// Those from this number on have leaves of their own.
    pub alone_from: u32,
}

impl Leaves {
    /// Any, but no more than so many.
    pub fn of(size: usize) -> Self {
        Self {
            size,
            alone_from: u32::MAX,
        }
    }

    fn may_hold(self, primitives: &[Primitive]) -> bool {
        let is_alone = |primitive: &Primitive| primitive.id >= self.alone_from;
        let count = primitives.len();
        count == 1 || count <= self.size && !primitives.iter().any(is_alone)
    }
}

/// Ranges with fewer primitives than this are not worth a task.
const PARALLEL_MINIMUM: usize = 4096;

/// A primitive while building.
#[derive(Clone, Copy)]
struct Primitive {
    bounds: Aabb,
    id: u32,
}

/// A tree over primitives with the given boxes; without any if the work is given up.
pub fn build(bounds: &[Aabb], leaves: Leaves, splits: Splits, halt: &Halt) -> Hierarchy {
    if bounds.is_empty() {
        return Hierarchy::default();
    }
    let mut primitives: Vec<Primitive> = bounds
        .iter()
        .zip(0..)
        .map(|(&bounds, id)| Primitive { bounds, id })
        .collect();
    let mut binary = vec![BinaryNode::UNUSED; 2 * primitives.len() - 1];
    let whole = Range {
        primitives: &mut primitives,
        nodes: &mut binary,
        start: 0,
        depth: 0,
    };
    split_recursively(whole, leaves, splits, halt);
    if halt.now() {
        return Hierarchy::default();
    }

    let mut hierarchy = Hierarchy {
        nodes: Vec::new(),
        order: primitives.iter().map(|primitive| primitive.id).collect(),
        leaf_starts: Vec::new(),
    };
    widen(&binary, &mut hierarchy);
    hierarchy.leaf_starts.push(bounds.len() as u32);
    hierarchy
}

/// A range of primitives with the node slots it owns.
struct Range<'a> {
    primitives: &'a mut [Primitive],
    nodes: &'a mut [BinaryNode],
    start: u32,
    depth: usize,
}

fn split_recursively(range: Range, leaves: Leaves, splits: Splits, halt: &Halt) {
    let Range {
        primitives,
        nodes,
        start,
        depth,
    } = range;
    let count = primitives.len();
    // Smaller ranges take milliseconds.
    if count >= PARALLEL_MINIMUM && halt.now() {
        return;
    }
    // The box around the primitives decides how often the node is visited, that around
    // their centres where it can be split.
    let mut bounds = Aabb::EMPTY;
    let mut centres = Aabb::EMPTY;
    for primitive in primitives.iter() {
        let centre = primitive.bounds.centre2();
        bounds = bounds.union(&primitive.bounds);
        centres = centres.union(&Aabb {
            low: centre,
            high: centre,
        });
    }
    nodes[0] = BinaryNode {
        half_area: bounds.half_area(),
        start,
        left: 0,
    };
    if leaves.may_hold(primitives) {
        return;
    }
    // Halving the rest all the way down must not exceed the depth limit.
    let depth_if_halved = depth + count.next_power_of_two().ilog2() as usize;
    // The primitives on the left of the split come first in the range.
    let left = match depth_if_halved < MAX_DEPTH {
        true if splits != Splits::Coarse && count >= FINE_MINIMUM => {
            split_best::<FINE_BINS>(primitives, &centres, leaves.size)
        }
        true => split_best::<BINS>(primitives, &centres, leaves.size),
        false => None,
    };
    let left = left.unwrap_or(count / 2); // all centres equal, or too deep
    nodes[0].left = left as u32;
    let (left_primitives, right_primitives) = primitives.split_at_mut(left);
    let (left_nodes, right_nodes) = nodes[1..].split_at_mut(2 * left - 1);
    let left_range = Range {
        primitives: left_primitives,
        nodes: left_nodes,
        start,
        depth: depth + 1,
    };
    let right_range = Range {
        primitives: right_primitives,
        nodes: right_nodes,
        start: start + left as u32,
        depth: depth + 1,
    };
    if count >= PARALLEL_MINIMUM && splits != Splits::Alone {
        rayon::join(
            || split_recursively(left_range, leaves, splits, halt),
            || split_recursively(right_range, leaves, splits, halt),
        );
    } else {
        split_recursively(left_range, leaves, splits, halt);
        split_recursively(right_range, leaves, splits, halt);
    }
}

/// Splits a range where the surface-area cost is least; how many come first, or `None` if all
/// centres fall in one bin on every axis.
fn split_best<const BINS: usize>(
    primitives: &mut [Primitive],
    centres: &Aabb,
    leaf_size: usize,
) -> Option<usize> {
    let split = best_split::<BINS>(primitives, centres, leaf_size)?;
    Some(partition(primitives, |p| split.is_left(p)))
}

/// A plane between two bins.
#[derive(Clone, Copy)]
struct Split<const BINS: usize> {
    bins: Bins<BINS>,
    axis: usize,
    /// Bins up to this one, exclusive, are left.
    bin: usize,
}

impl<const BINS: usize> Split<BINS> {
    #[inline]
    fn is_left(&self, primitive: &Primitive) -> bool {
        self.bins.index(primitive.bounds.centre2(), self.axis) < self.bin
    }
}

/// Equal intervals between the smallest and the largest centre on each axis.
#[derive(Clone, Copy)]
struct Bins<const BINS: usize> {
    low: [f32; 3],
    bins_per_length: [f32; 3],
}

impl<const BINS: usize> Bins<BINS> {
    fn new(centres: &Aabb) -> Self {
        let bins_per_length = centres.extent().map(|extent| {
            let scale = BINS as f32 / extent;
            // Without extent (or with so little that the scale overflows),
            // everything falls in the first bin.
            if scale.is_finite() { scale } else { 0.0 }
        });
        Self {
            low: centres.low,
            bins_per_length,
        }
    }

    #[inline]
    fn index(&self, centre: [f32; 3], axis: usize) -> usize {
        let position = (centre[axis] - self.low[axis]) * self.bins_per_length[axis];
        (position as usize).min(BINS - 1)
    }
}

/// The split of least surface-area cost; `None` if all centres fall in one
/// bin on every axis.
fn best_split<const BINS: usize>(
    primitives: &[Primitive],
    centres: &Aabb,
    leaf_size: usize,
) -> Option<Split<BINS>> {
    let bins = Bins::<BINS>::new(centres);
    // What falls into each bin of each axis: a box, and how many.
    let mut filled = [[(Aabb::EMPTY, 0_usize); BINS]; 3];
    for primitive in primitives {
        let centre = primitive.bounds.centre2();
        for (axis, filled) in filled.iter_mut().enumerate() {
            let (bounds, count) = &mut filled[bins.index(centre, axis)];
            *bounds = bounds.union(&primitive.bounds);
            *count += 1;
        }
    }
    // A leaf costs the same however full it is, so counts are in leaves.
    let cost = |bounds: &Aabb, count: usize| bounds.half_area() * count.div_ceil(leaf_size) as f32;
    let mut best: Option<(f32, Split<BINS>)> = None;
    for (axis, filled) in filled.iter().enumerate() {
        // From the right: the cost of everything from each bin on.
        let mut right_costs = [0.0; BINS];
        let (mut bounds, mut count) = (Aabb::EMPTY, 0);
        for bin in (1..BINS).rev() {
            bounds = bounds.union(&filled[bin].0);
            count += filled[bin].1;
            right_costs[bin] = if count == 0 {
                f32::NAN
            } else {
                cost(&bounds, count)
            };
        }
        // From the left: the cost of everything before each bin. A split must leave
        // something on both sides.
        let (mut bounds, mut count) = (Aabb::EMPTY, 0);
        for bin in 1..BINS {
            bounds = bounds.union(&filled[bin - 1].0);
            count += filled[bin - 1].1;
            if count == 0 || right_costs[bin].is_nan() {
                continue;
            }
            let cost = cost(&bounds, count) + right_costs[bin];
            if best.is_none_or(|(least, _)| cost < least) {
                best = Some((cost, Split { bins, axis, bin }));
            }
        }
    }
    best.map(|(_, split)| split)
}

/// Moves the primitives that are left to the front; how many they are.
fn partition(primitives: &mut [Primitive], is_left: impl Fn(&Primitive) -> bool) -> usize {
    let (mut front, mut back) = (0, primitives.len());
    while front < back {
        if is_left(&primitives[front]) {
            front += 1;
        } else {
            back -= 1;
            primitives.swap(front, back);
        }
    }
    front
}
