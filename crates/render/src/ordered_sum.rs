//! Sums whose terms may come in any order, and are added in one.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// What can be summed. Rounding makes the order count.
pub trait Accumulate {
    /// Adds the next term.
    fn add(&mut self, next: &Self);
}

/// A sum of numbered terms, of which some may be missing. They are added by their numbers:
/// what comes next is added at once, what comes later waits.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OrderedSum<T> {
    /// The sum of the first terms, and how many they are.
    first: Option<(u32, T)>,
    waiting: BTreeMap<u32, T>,
}

impl<T> Default for OrderedSum<T> {
    fn default() -> Self {
        Self {
            first: None,
            waiting: BTreeMap::new(),
        }
    }
}

impl<T: Accumulate> OrderedSum<T> {
    /// Takes a term in; false if it was there already.
    pub fn insert(&mut self, number: u32, term: T) -> bool {
        let is_new = number >= self.summed() && self.waiting.insert(number, term).is_none();
        self.add_what_is_next();
        is_new
    }

    /// Takes all terms of another sum in; the number of one that was there already if there
    /// is any.
    pub fn merge(&mut self, other: Self) -> Result<(), u32> {
        if let Some((count, sum)) = other.first {
            if let Some((own, _)) = self.first {
                return Err(own.min(count) - 1);
            }
            if let Some((&number, _)) = self.waiting.range(..count).next() {
                return Err(number);
            }
            self.first = Some((count, sum));
        }
        for (number, term) in other.waiting {
            if !self.insert(number, term) {
                return Err(number);
            }
        }
        self.add_what_is_next();
        Ok(())
    }

    /// How many terms are there.
    pub fn count(&self) -> u32 {
        self.summed() + self.waiting.len() as u32
    }

    /// The sum of the terms that have all terms before them.
    pub fn into_sum(self) -> Option<T> {
        self.first.map(|(_, sum)| sum)
    }

    fn summed(&self) -> u32 {
        self.first.as_ref().map_or(0, |&(count, _)| count)
    }

    fn add_what_is_next(&mut self) {
        while let Some(term) = self.waiting.remove(&self.summed()) {
            match &mut self.first {
                None => self.first = Some((1, term)),
                Some((count, sum)) => {
                    sum.add(&term);
                    *count += 1;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Accumulate for String {
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
    fn order_is_that_of_the_numbers() {
        let expected = of(&[0, 1, 2, 3, 4]).into_sum();
        assert_eq!(expected.as_deref(), Some("((((01)2)3)4)"));
        assert_eq!(of(&[4, 2, 0, 3, 1]).into_sum(), expected);
        for (a, b) in [(&[0, 1][..], &[4, 2, 3][..]), (&[3, 1], &[2, 0, 4])] {
            for (mut first, second) in [(of(a), of(b)), (of(b), of(a))] {
                first.merge(second).expect("no number twice");
                assert_eq!(first.count(), 5);
                assert_eq!(first.into_sum(), expected);
            }
        }
    }

    #[test]
    fn no_term_counts_twice() {
        for (a, b, twice) in [
            (&[0, 1, 2][..], &[0][..], 0),
            (&[1], &[0, 1], 1),
            (&[0, 1], &[3, 1], 1),
            (&[3], &[3], 3),
        ] {
            assert_eq!(of(a).merge(of(b)), Err(twice));
            assert_eq!(of(b).merge(of(a)), Err(twice));
        }
        assert!(!of(&[0, 1]).insert(1, String::new()));
    }
}
