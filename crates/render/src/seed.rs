//! Seeds, and which of them are independent of which. A product of two noisy numbers has the
//! right mean only if they do not share their random numbers. The gradient of a loss is such a
//! product, of what an image says and how it changes.

/// What all random numbers of an image or a derivative follow from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seed(pub u64);

/// What random numbers are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The image that a loss compares.
    Image = 0,
    /// Its derivative.
    Gradient = 1,
    /// A target that is rendered.
    Target = 2,
}

impl Seed {
    /// The seed of a derivative beside an image with this one, or of an image beside a derivative:
    /// the complement, which never collides with nearby seeds such as `seed + 1`.
    #[must_use]
    pub fn independent(self) -> Self {
        Self(!self.0)
    }

    /// The seed of a view among several, by its number from 0. The first has this one, and none of
    /// them collides with nearby seeds.
    #[must_use]
    pub fn of_view(self, view: u64) -> Self {
        Self(self.0.wrapping_add(view.wrapping_mul(GOLDEN)))
    }

    /// The seed for a purpose in an optimisation whose seed this is. Its last two bits are the
    /// purpose, so that seeds of different purposes always differ; the others are hashed from this
    /// seed, the iteration and the view, one after the other.
    #[must_use]
    pub fn of_iteration(self, iteration: u64, view: u64, purpose: Purpose) -> Self {
        let mut hash = mix(self.0);
        for part in [iteration, view] {
            hash = mix(hash ^ part.wrapping_add(GOLDEN));
        }
        Self((hash & !3) | purpose as u64)
    }
}

/// 2^64 over the golden ratio.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// A bijection of 64 bits that looks random (the finaliser of SplitMix64, Steele
/// et al. 2014).
fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(GOLDEN);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    /// No two of many seeds are equal, and purposes differ whatever the rest is.
    #[test]
    fn seeds_differ() {
        let mut seen = HashSet::new();
        for job in 0..4 {
            for iteration in 0..500 {
                for view in 0..4 {
                    for purpose in [Purpose::Image, Purpose::Gradient, Purpose::Target] {
                        let Seed(seed) = Seed(job).of_iteration(iteration, view, purpose);
                        assert_eq!(seed & 3, purpose as u64);
                        assert!(seen.insert(seed), "{job} {iteration} {view} {purpose:?}");
                    }
                }
            }
        }
    }
}
