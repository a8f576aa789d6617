//! Nearest first, down one branch of a tree after the other.

use super::hierarchy::{Child, WIDTH};

/// Entries at the top of a stack: more than nearly every ray needs, and so few
/// that making them costs nothing beside a node.
const TOP: usize = 48;

/// What a stack holds: it goes into one number together with a lower bound, so that numbers
/// compare like bounds, as the bits of non-negative floats do.
pub trait Visit: Copy {
    /// Both in one number.
    fn pack(self, bound: f32) -> u64;
    /// What was packed, and a bound that is no larger than that.
    fn unpack(packed: u64) -> (Self, f32);
}

impl Visit for Child {
    #[inline(always)]
    fn pack(self, bound: f32) -> u64 {
        debug_assert!(bound.is_sign_positive(), "bound {bound}");
        u64::from(bound.to_bits()) << 32 | u64::from(self.bits())
    }

    #[inline(always)]
    fn unpack(packed: u64) -> (Self, f32) {
        let bound = f32::from_bits((packed >> 32) as u32);
        (Self::from_bits(packed as u32), bound)
    }
}

/// A child, and one bit for each of sixteen rays that are to visit it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VisitOfRays {
    pub child: Child,
    pub rays: u32,
}

impl Visit for VisitOfRays {
    /// Half of the bound's bits are enough: without the others it is lower.
    #[inline(always)]
    fn pack(self, bound: f32) -> u64 {
        debug_assert!(bound.is_sign_positive() && self.rays >> 16 == 0, "{self:?}");
        let upper = u64::from(bound.to_bits() >> 16) << 48;
        upper | u64::from(self.rays) << 32 | u64::from(self.child.bits())
    }

    #[inline(always)]
    fn unpack(packed: u64) -> (Self, f32) {
        let own = Self {
            child: Child::from_bits(packed as u32),
            rays: (packed >> 32) as u32 & 0xffff,
        };
        (own, f32::from_bits(((packed >> 48) as u32) << 16))
    }
}

/// Children still to visit, each with a lower bound (a non-negative number) of
/// what it can contribute.
pub struct Stack<V = Child> {
    /// The nearest child of a node just opened: it comes next, and is never
    /// written to memory.
    next: Option<V>,
    /// Bound and child, packed.
    top: [u64; TOP],
    len: usize,
    /// What does not fit there, below it.
    below: Vec<u64>,
}

impl<V: Visit> Stack<V> {
    /// A stack that holds one child.
    #[inline(always)]
    pub fn with(first: V) -> Self {
        Self {
            next: Some(first),
            top: [0; TOP],
            len: 0,
            below: Vec::new(),
        }
    }

    /// The nearest child of the node opened last that is not bounded beyond
    /// `limit`.
    #[inline(always)]
    pub fn pop(&mut self, limit: f32) -> Option<V> {
        if let Some(next) = self.next.take() {
            return Some(next);
        }
        loop {
            if self.len == 0 {
                self.raise();
            }
            self.len = self.len.checked_sub(1)?;
            let (child, bound) = V::unpack(self.top[self.len]);
            if bound <= limit {
                return Some(child);
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
    pub fn push_sorted(&mut self, mut mask: u32, bounds: &[f32; WIDTH], children: &[V; WIDTH]) {
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
        let mut nearest = children[i].pack(bounds[i]);
        let first = self.len;
        while mask != 0 {
            let i = mask.trailing_zeros() as usize % WIDTH;
            mask &= mask - 1;
            let entry = children[i].pack(bounds[i]);
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
        self.next = Some(V::unpack(nearest).0);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// However many are on it, the last node's nearest child comes first.
    #[test]
    fn deep_stacks_keep_their_order() {
        let mut stack = Stack::with(Child::node(0));
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
