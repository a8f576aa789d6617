//! Nearest first over the whole tree: children still to visit, sorted roughly.

use super::hierarchy::Child;

/// How many lists there are.
const BUCKETS: usize = 64;

/// Bounds in one bucket differ by less than this power of two in their bits:
/// there are eight buckets in each octave, so eight octaves are told apart.
const BUCKET_BITS: u32 = 23 - 3;

/// Entries kept without allocating. There are fewer than a hundred as a rule.
const CAPACITY: usize = 128;

/// The end of a list.
const END: u8 = u8::MAX;

/// Children still to visit, each with a lower bound (a non-negative number) of
/// what it can contribute. The nearest come first, to within an eighth of an
/// octave: putting the next one first costs as little as on a stack.
pub struct Buckets {
    /// A bit for each bucket that is not empty.
    used: u64,
    /// The first entry of each of those.
    heads: [u8; BUCKETS],
    /// The bits of the bounds, and of the children.
    entries: [(u32, u32); CAPACITY],
    /// The next entry in the same bucket.
    next: [u8; CAPACITY],
    /// Entries that are free again.
    free: u8,
    /// No entry has been used from this one on.
    len: usize,
    /// Bits of the largest bound.
    largest: u32,
    /// What does not fit: for the end, in no order.
    overflow: Vec<(u32, u32)>,
}

impl Buckets {
    /// Holds the root. Bounds will not be larger than `largest`.
    #[inline(always)]
    pub fn with_root(largest: f32) -> Self {
        let mut buckets = Self {
            used: 0,
            heads: [END; BUCKETS],
            entries: [(0, 0); CAPACITY],
            next: [END; CAPACITY],
            free: END,
            len: 0,
            largest: largest.to_bits(),
            overflow: Vec::new(),
        };
        buckets.push(0.0, Child::node(0));
        buckets
    }

    /// Adds a child.
    #[inline(always)]
    pub fn push(&mut self, bound: f32, child: Child) {
        // The bits of floats that are not negative compare like the floats.
        let entry = (bound.to_bits(), child.bits());
        let slot = if self.free != END {
            let slot = self.free as usize % CAPACITY;
            self.free = self.next[slot];
            slot
        } else if self.len < CAPACITY {
            self.len += 1;
            self.len - 1
        } else {
            self.overflow.push(entry);
            return;
        };
        let below = self.largest.saturating_sub(entry.0) >> BUCKET_BITS;
        let bucket = BUCKETS - 1 - (below as usize).min(BUCKETS - 1);
        let is_used = self.used >> bucket & 1 != 0;
        self.next[slot] = if is_used { self.heads[bucket] } else { END };
        self.heads[bucket] = slot as u8;
        self.entries[slot] = entry;
        self.used |= 1 << bucket;
    }

    /// A child of the first bucket that has any, and its bound.
    #[inline(always)]
    pub fn pop(&mut self) -> Option<(f32, Child)> {
        let (bound, child) = if self.used != 0 {
            let bucket = self.used.trailing_zeros() as usize % BUCKETS;
            let slot = self.heads[bucket] as usize % CAPACITY;
            let next = self.next[slot];
            self.heads[bucket] = next;
            if next == END {
                self.used &= self.used - 1;
            }
            self.next[slot] = self.free;
            self.free = slot as u8;
            self.entries[slot]
        } else {
            self.overflow.pop()?
        };
        Some((f32::from_bits(bound), Child::from_bits(child)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Everything comes out once, roughly in order, also what overflows.
    #[test]
    fn nearest_first() {
        for count in [5, 100, 1000] {
            let mut buckets = Buckets::with_root(1.0);
            assert_eq!(buckets.pop(), Some((0.0, Child::node(0))));
            let bound = |i: usize| ((i * 7919) % count + 1) as f32 / count as f32;
            for i in 0..count {
                buckets.push(bound(i), Child::leaf(i));
            }
            let popped: Vec<_> = std::iter::from_fn(|| buckets.pop()).collect();
            let mut children: Vec<u32> = popped.iter().map(|(_, child)| child.bits()).collect();
            children.sort_unstable();
            let all: Vec<u32> = (0..count).map(|i| Child::leaf(i).bits()).collect();
            assert_eq!(children, all);
            let sorted = &popped[..count.min(CAPACITY)];
            let is_rough = |pair: &[(f32, Child)]| pair[0].0 <= pair[1].0 * 1.13;
            assert!(count > CAPACITY || sorted.windows(2).all(is_rough));
        }
    }
}
