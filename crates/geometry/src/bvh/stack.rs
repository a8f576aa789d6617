//! Nearest first, down one branch of a tree after the other.

use super::hierarchy::{Child, WIDTH};

/// Entries at the top of a stack: more than nearly every ray needs, and so few
/// that making them costs nothing beside a node.
const TOP: usize = 48;

/// Children still to visit, each with a lower bound (a non-negative number) of
/// what it can contribute.
pub struct Stack {
    /// The nearest child of a node just opened: it comes next, and is never
    /// written to memory.
    next: Option<Child>,
    /// Bound and child in one number, so that numbers compare like bounds: the
    /// bits of non-negative floats do.
    top: [u64; TOP],
    len: usize,
    /// What does not fit there, below it.
    below: Vec<u64>,
}

impl Stack {
    /// A stack that holds the root.
    #[inline(always)]
    pub fn with_root() -> Self {
        Self {
            next: Some(Child::node(0)),
            top: [0; TOP],
            len: 0,
            below: Vec::new(),
        }
    }

    /// The nearest child of the node opened last that is not bounded beyond
    /// `limit`.
    #[inline(always)]
    pub fn pop(&mut self, limit: f32) -> Option<Child> {
        if let Some(next) = self.next.take() {
            return Some(next);
        }
        loop {
            if self.len == 0 {
                self.raise();
            }
            self.len = self.len.checked_sub(1)?;
            let entry = self.top[self.len];
            if f32::from_bits((entry >> 32) as u32) <= limit {
                return Some(Child::from_bits(entry as u32));
            }
        }
    }

    /// Moves all entries below.
    #[cold]
    fn sink(&mut self) {
        self.below.extend_from_slice(&self.top[..self.len]);
        self.len = 0;
    }

    /// Takes entries from below, if there are any.
    #[cold]
    fn raise(&mut self) {
        let first = self.below.len().saturating_sub(TOP / 2);
        let raised = self.below.drain(first..);
        self.len = raised.len();
        for (slot, entry) in self.top.iter_mut().zip(raised) {
            *slot = entry;
        }
    }

    /// Pushes the children of the node popped last whose bit is set, the farthest first.
    #[inline(always)]
    pub fn push_sorted(&mut self, mut mask: u32, bounds: &[f32; WIDTH], children: &[Child; WIDTH]) {
        debug_assert!(self.next.is_none(), "a node is opened that is not popped");
        if mask == 0 {
            return;
        }
        let i = mask.trailing_zeros() as usize % WIDTH;
        mask &= mask - 1;
        self.next = Some(children[i]);
        if mask == 0 {
            return;
        }
        if self.len + WIDTH > TOP {
            self.sink();
        }
        let mut nearest = pack(bounds[i], children[i]);
        let first = self.len;
        while mask != 0 {
            let i = mask.trailing_zeros() as usize % WIDTH;
            mask &= mask - 1;
            let entry = pack(bounds[i], children[i]);
            let farther = entry.max(nearest);
            nearest = entry.min(nearest);
            // Insertion sort: there are one or two as a rule.
            let mut slot = self.len;
            while slot > first && self.top[slot - 1] < farther {
                self.top[slot] = self.top[slot - 1];
                slot -= 1;
            }
            self.top[slot] = farther;
            self.len += 1;
        }
        self.next = Some(Child::from_bits(nearest as u32));
    }
}

/// Calls `visit` with each lane whose bit is set and its bound, the nearest
/// first.
#[inline(always)]
pub fn for_each_sorted(mut mask: u32, bounds: &[f32; WIDTH], mut visit: impl FnMut(usize, f32)) {
    while mask != 0 {
        let mut nearest = mask.trailing_zeros() as usize % WIDTH;
        let mut rest = mask & (mask - 1);
        while rest != 0 {
            let lane = rest.trailing_zeros() as usize % WIDTH;
            rest &= rest - 1;
            if bounds[lane] < bounds[nearest] {
                nearest = lane;
            }
        }
        mask &= !(1 << nearest);
        visit(nearest, bounds[nearest]);
    }
}

#[inline(always)]
fn pack(bound: f32, child: Child) -> u64 {
    debug_assert!(bound.is_sign_positive(), "bound {bound}");
    u64::from(bound.to_bits()) << 32 | u64::from(child.bits())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However many are on it, the last node's nearest child comes first.
    #[test]
    fn deep_stacks_keep_their_order() {
        let mut stack = Stack::with_root();
        let mut expected = vec![0];
        let mut next = 1;
        let bounds: [f32; WIDTH] = std::array::from_fn(|i| 10.0 - i as f32);
        for round in 0..2000 {
            let popped = stack.pop(f32::INFINITY);
            assert_eq!(popped, expected.pop().map(Child::node), "round {round}");
            // Grows to several times the top, then shrinks to nothing.
            if round % 20 >= 3 && round <= 1000 {
                let mask = 0b1011 << (round % 4);
                let children = std::array::from_fn(|i| Child::node(next + i));
                stack.push_sorted(mask, &bounds, &children);
                // The bounds fall: the last child is the nearest.
                expected.extend((0..WIDTH).filter(|i| mask >> i & 1 != 0).map(|i| next + i));
                next += WIDTH;
            }
        }
        let rest = std::iter::from_fn(|| stack.pop(f32::INFINITY));
        let expected = expected.into_iter().rev().map(Child::node);
        assert!(rest.eq(expected));
    }
}
