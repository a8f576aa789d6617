//! Nearest first, down one branch of a tree after the other.

use super::{Child, MAX_DEPTH, WIDTH};

/// A node on the way down leaves at most `WIDTH - 1` siblings behind; the last
/// one pushes all its children.
const STACK_SIZE: usize = MAX_DEPTH * (WIDTH - 1) + WIDTH;

/// Children still to visit, each with a lower bound (a non-negative number) of
/// what it can contribute.
pub struct Stack {
    /// Bound and child in one number, so that numbers compare like bounds: the
    /// bits of non-negative floats do.
    entries: [u64; STACK_SIZE],
    len: usize,
}

impl Stack {
    /// A stack that holds the root.
    #[inline(always)]
    pub fn with_root() -> Self {
        let mut entries = [0; STACK_SIZE];
        entries[0] = pack(0.0, Child::node(0));
        Self { entries, len: 1 }
    }

    /// The nearest child of the node opened last, and its bound.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<(f32, Child)> {
        self.len = self.len.checked_sub(1)?;
        let entry = self.entries[self.len];
        let bound = f32::from_bits((entry >> 32) as u32);
        Some((bound, Child::from_bits(entry as u32)))
    }

    /// Pushes the children whose bit is set, the farthest first.
    #[inline(always)]
    pub fn push_sorted(&mut self, mut mask: u32, bounds: &[f32; WIDTH], children: &[Child; WIDTH]) {
        let first = self.len;
        while mask != 0 {
            let i = mask.trailing_zeros() as usize % WIDTH;
            mask &= mask - 1;
            let entry = pack(bounds[i], children[i]);
            // Insertion sort: there are two or three as a rule.
            let mut slot = self.len;
            while slot > first && self.entries[slot - 1] < entry {
                self.entries[slot] = self.entries[slot - 1];
                slot -= 1;
            }
            self.entries[slot] = entry;
            self.len += 1;
        }
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
