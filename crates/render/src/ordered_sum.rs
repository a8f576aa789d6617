//! Sums whose terms may come in any order, and are added along a fixed binary tree.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// What can be summed. Rounding makes the order count.
pub trait Accumulate {
    /// True if another term can be added: it has as many numbers.
    fn fits(&self, next: &Self) -> bool;
    /// Adds the next term.
    fn add(&mut self, next: &Self);
}

/// Why two sums are not terms of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CannotMerge {
    /// Both have the term with this number.
    Twice(u32),
    /// Their terms do not fit each other.
    Misfit,
}

/// A sum of terms numbered from 0, of which some may be missing. A node of the tree is the
/// sum of 2^k terms from a multiple of 2^k on; two halves of a larger one are added as soon
/// as both are there, the left one first. So the bits of the sum do not depend on who comes
/// when, and a range of n terms takes the memory of at most 2 log2 n.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OrderedSum<T> {
    /// By their first terms.
    nodes: BTreeMap<u32, Node<T>>,
}

/// The sum of some consecutive terms.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Node<T> {
    /// How many: a power of two.
    count: u32,
    sum: T,
}

impl<T> Default for OrderedSum<T> {
    fn default() -> Self {
        Self {
            nodes: BTreeMap::new(),
        }
    }
}

impl<T: Accumulate> OrderedSum<T> {
    /// Takes a term in; false, and without it, if it was there already.
    pub fn insert(&mut self, number: u32, term: T) -> bool {
        self.insert_and_spare(number, term, &mut Vec::new())
    }

    /// [`Self::insert`], which leaves the memory of what was added to others.
    pub fn insert_and_spare(&mut self, number: u32, term: T, spare: &mut Vec<T>) -> bool {
        let node = Node {
            count: 1,
            sum: term,
        };
        self.insert_node(number, node, spare).is_ok()
    }

    /// Takes all terms of another sum in.
    pub fn merge(&mut self, other: Self) -> Result<(), CannotMerge> {
        let mut nodes = other.nodes.into_iter();
        nodes.try_for_each(|(first, node)| self.insert_node(first, node, &mut Vec::new()))
    }

    fn insert_node(
        &mut self,
        first: u32,
        node: Node<T>,
        spare: &mut Vec<T>,
    ) -> Result<(), CannotMerge> {
        // The last node that starts before this one ends tells whether they overlap.
        let last = u64::from(first) + u64::from(node.count);
        let before = self.nodes.range(..=(last - 1) as u32).next_back();
        if let Some((&start, other)) = before
            && u64::from(start) + u64::from(other.count) > u64::from(first)
        {
            return Err(CannotMerge::Twice(start.max(first)));
        }
        if !self.nodes.values().all(|other| other.sum.fits(&node.sum)) {
            return Err(CannotMerge::Misfit);
        }
        // Add it to its sibling, and what they make to theirs, as far as they are there.
        let (mut first, mut node) = (first, node);
        loop {
            let sibling = first ^ node.count;
            let is_sibling = |other: &Node<T>| other.count == node.count;
            if !self.nodes.get(&sibling).is_some_and(is_sibling) {
                self.nodes.insert(first, node);
                return Ok(());
            }
            let Some(other) = self.nodes.remove(&sibling) else {
                return Ok(());
            };
            let (mut left, right) = match sibling < first {
                true => (other, node),
                false => (node, other),
            };
            left.sum.add(&right.sum);
            spare.push(right.sum);
            left.count *= 2;
            (first, node) = (first.min(sibling), left);
        }
    }

    /// The numbers of the terms that are there.
    pub fn numbers(&self) -> impl Iterator<Item = u32> + '_ {
        let nodes = self.nodes.iter();
        nodes.flat_map(|(&first, node)| first..first + node.count)
    }

    /// The sum of all terms that are there; `None` if there are none.
    pub fn into_sum(self) -> Option<T> {
        // What is left of the tree if the number of terms is no power of two, from the left.
        let mut nodes = self.nodes.into_values().map(|node| node.sum);
        let mut sum = nodes.next()?;
        nodes.for_each(|next| sum.add(&next));
        Some(sum)
    }

    /// True if it can be a sum of some of the first `count` terms: what comes from elsewhere
    /// may be anything.
    pub fn is_valid(&self, count: u32) -> bool {
        let mut end = 0;
        let one = self.nodes.values().next();
        self.nodes.iter().all(|(&first, node)| {
            let starts_right = first >= end && first.checked_rem(node.count) == Some(0);
            let is_one = node.count.is_power_of_two() && node.count <= count;
            end = first.saturating_add(node.count);
            let fits = one.is_some_and(|one| one.sum.fits(&node.sum));
            starts_right && is_one && end <= count && fits
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Accumulate for String {
        fn fits(&self, next: &Self) -> bool {
            self.is_empty() == next.is_empty()
        }
        fn add(&mut self, next: &Self) {
            *self = format!("({self}{next})");
        }
    }

    fn of(numbers: &[u32]) -> OrderedSum<String> {
        let mut sum = OrderedSum::default();
        for &i in numbers {
            assert!(sum.insert(i, i.to_string()));
        }
        sum
    }

    /// Whatever comes first, the parentheses are the same.
    #[test]
    fn order_is_that_of_the_tree() {
        let expected = of(&[0, 1, 2, 3, 4, 5, 6]).into_sum();
        assert_eq!(expected.as_deref(), Some("((((01)(23))(45))6)"));
        assert_eq!(of(&[6, 4, 2, 0, 5, 3, 1]).into_sum(), expected);
        for (a, b) in [
            (&[0, 1][..], &[4, 2, 6, 5, 3][..]),
            (&[3, 1, 6], &[2, 0, 4, 5]),
            (&[6, 5, 4], &[0, 1, 2, 3]),
        ] {
            for (mut first, second) in [(of(a), of(b)), (of(b), of(a))] {
                first.merge(second).expect("no number twice");
                assert!(first.numbers().eq(0..7));
                assert!(first.is_valid(7));
                assert_eq!(first.into_sum(), expected);
            }
        }
    }

    #[test]
    fn no_term_counts_twice() {
        for (a, b, twice) in [
            (&[0, 1, 2][..], &[0][..], [0, 0]),
            (&[1], &[0, 1], [1, 1]),
            (&[0, 1], &[3, 1], [1, 1]),
            (&[3], &[3], [3, 3]),
            (&[0, 1, 2, 3, 4, 5, 6, 7], &[5, 6, 7], [5, 6]),
        ] {
            assert_eq!(of(a).merge(of(b)), Err(CannotMerge::Twice(twice[0])));
            assert_eq!(of(b).merge(of(a)), Err(CannotMerge::Twice(twice[1])));
        }
        assert!(!of(&[0, 1]).insert(1, String::new()));
    }

    /// Nodes that no sum has.
    #[test]
    fn what_cannot_be_is_found() {
        let with = |nodes: &[(u32, u32)]| OrderedSum {
            nodes: nodes
                .iter()
                .map(|&(first, count)| {
                    let sum = String::new();
                    (first, Node { count, sum })
                })
                .collect(),
        };
        for nodes in [
            &[(0, 0)][..],
            &[(0, 3)],
            &[(1, 2)],
            &[(0, 4), (2, 2)],
            &[(8, 8)],
            &[(4_294_967_295, 1)],
        ] {
            assert!(!with(nodes).is_valid(12), "{nodes:?}");
        }
        assert!(with(&[(0, 8), (10, 2)]).is_valid(12));
        assert_eq!(with(&[(0, 8)]).merge(of(&[9])), Err(CannotMerge::Misfit));
    }
}
