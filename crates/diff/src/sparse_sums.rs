//! Many sums, of which mostly few are added to.

use std::ops::{AddAssign, Mul};

use serde::{Deserialize, Serialize};

/// So many sums that follow each other have memory together. A multiple of the channels of texels.
const BLOCK: usize = 96;

/// Sums that begin as zero. Those of a block have memory once one of them is added to. A few samples
/// meet a few texels of a large texture: then memory, and the time to copy and to add, are those of
/// a few blocks.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SparseSums<T> {
    length: usize,
    /// For each block 0 if nothing was added to it, else the number of its sums, from 1.
    places: Vec<u32>,
    sums: Vec<T>,
}

impl<T: Copy + Default + AddAssign + Mul<f64, Output = T>> SparseSums<T> {
    /// So many of them.
    pub fn zero(length: usize) -> Self {
        Self {
            length,
            places: vec![0; length.div_ceil(BLOCK)],
            sums: Vec::new(),
        }
    }

    /// Adds to one of them.
    #[inline]
    pub fn add(&mut self, index: usize, number: T) {
        self.add_each(index, [number]);
    }

    /// Adds to some that follow each other: so many that they divide a block, from a multiple of them.
    #[inline]
    pub fn add_each<const N: usize>(&mut self, first: usize, numbers: [T; N]) {
        const { assert!(BLOCK.is_multiple_of(N)) };
        debug_assert!(first.is_multiple_of(N));
        assert!(first + N <= self.length);
        let sums = &mut self.block(first / BLOCK)[first % BLOCK..][..N];
        for (sum, number) in sums.iter_mut().zip(numbers) {
            *sum += number;
        }
    }

    #[inline]
    fn block(&mut self, block: usize) -> &mut [T] {
        if self.places[block] == 0 {
            self.add_block(block);
        }
        let first = (self.places[block] as usize - 1) * BLOCK;
        &mut self.sums[first..first + BLOCK]
    }

    #[cold]
    fn add_block(&mut self, block: usize) {
        let length = self.sums.len();
        if length == self.sums.capacity() {
            // Twice as many, but never more than there are.
            let rest = self.places.len() * BLOCK - length;
            self.sums.reserve_exact(length.max(BLOCK).min(rest));
        }
        self.sums.resize(length + BLOCK, T::default());
        self.places[block] = (self.sums.len() / BLOCK) as u32;
    }

    /// Multiplies all by a factor.
    pub fn scale(&mut self, factor: f64) {
        self.sums.iter_mut().for_each(|sum| *sum = *sum * factor);
    }

    /// Adds others, of which there are [as many](Self::fits).
    pub fn add_all(&mut self, next: &Self) {
        for (block, sums) in next.blocks() {
            let own = self.block(block).iter_mut();
            own.zip(sums).for_each(|(own, &sum)| *own += sum);
        }
    }

    /// True if there are as many of the others, and neither was damaged on its way from another process.
    pub fn fits(&self, next: &Self) -> bool {
        self.length == next.length && self.is_sound() && next.is_sound()
    }

    /// True if each block has a place of its own.
    fn is_sound(&self) -> bool {
        let mut free = vec![true; self.sums.len() / BLOCK];
        let mut places = self.places.iter().filter(|&&place| place > 0);
        let is_free = |place: &u32| {
            let free = free.get_mut(*place as usize - 1);
            free.is_some_and(|free| std::mem::replace(free, false))
        };
        self.places.len() == self.length.div_ceil(BLOCK)
            && places.all(is_free)
            && self.sums.len() == BLOCK * self.blocks().count()
    }

    /// All of them in a list.
    pub fn into_list(self) -> Vec<T> {
        let mut list = vec![T::default(); self.length];
        for (block, sums) in self.blocks() {
            let own = list[block * BLOCK..].iter_mut();
            own.zip(sums).for_each(|(own, &sum)| *own = sum);
        }
        list
    }

    /// The blocks that have been added to.
    fn blocks(&self) -> impl Iterator<Item = (usize, &[T])> {
        let places = self.places.iter().enumerate();
        places
            .filter(|&(_, &place)| place > 0)
            .map(|(block, &place)| (block, &self.sums[(place as usize - 1) * BLOCK..][..BLOCK]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// They are the sums that a list has, whichever are added to, and in whatever order.
    #[test]
    fn sums_are_those_of_a_list() {
        for length in [1, 3, 95, 96, 97, 1000, 3000] {
            let mut sums = [0, 1].map(|_| SparseSums::<f64>::zero(length));
            let mut lists = [0, 1].map(|_| vec![0.0; length]);
            for (i, (sums, list)) in sums.iter_mut().zip(&mut lists).enumerate() {
                for k in 0..40 {
                    let (index, number) = ((k * k * 37 + i * 501) % length, 0.1 + k as f64);
                    sums.add(index, number);
                    list[index] += number;
                    let first = index / 3 * 3;
                    if first + 3 <= length {
                        sums.add_each(first, [number, -number, 0.3]);
                        let numbers = [number, -number, 0.3].into_iter();
                        let three = list[first..].iter_mut().zip(numbers);
                        three.for_each(|(x, number)| *x += number);
                    }
                }
                sums.scale(0.7);
                list.iter_mut().for_each(|x| *x *= 0.7);
                assert_eq!(sums.clone().into_list(), *list);
            }
            let [mut sum, next] = sums;
            assert!(sum.fits(&next) && !sum.fits(&SparseSums::zero(length + 1)));
            sum.add_all(&next);
            let added: Vec<f64> = lists[0].iter().zip(&lists[1]).map(|(a, b)| a + b).collect();
            assert_eq!(sum.clone().into_list(), added);
            assert!(sum.sums.capacity() <= sum.places.len() * BLOCK);
            for damaged in [
                SparseSums {
                    sums: Vec::new(),
                    ..next.clone()
                },
                SparseSums {
                    sums: vec![0.0; next.sums.len() + 1],
                    ..next.clone()
                },
                SparseSums {
                    places: vec![1; next.places.len() + 1],
                    ..next.clone()
                },
                SparseSums {
                    places: vec![7_000_000; next.places.len()],
                    ..next.clone()
                },
            ] {
                assert!(!sum.fits(&damaged) && !damaged.fits(&sum));
            }
        }
        // Of many of them few take memory.
        let mut few = SparseSums::<f64>::zero(1_000_000);
        (0..1000).for_each(|i| few.add(500_000 + i, 1.0));
        assert!(few.sums.len() <= 12 * BLOCK);
    }
}
