//! Seeds of images and gradients: a function of the job's seed, the iteration,
//! the view and the purpose. The gradient of a loss is a product of what the
//! image says and how it changes, and the mean of the product is the product of
//! the means only if the two do not share their random numbers.

/// What random numbers are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The image that the loss compares.
    Image = 0,
    /// Its derivative.
    Gradient = 1,
    /// A target that is rendered.
    Target = 2,
}

/// The seed for a purpose. Its last two bits are the purpose, so that seeds of
/// different purposes always differ; the others are hashed from the seed of the
/// job, the iteration and the view, one after the other.
pub fn seed(job: u64, iteration: u64, view: u64, purpose: Purpose) -> u64 {
    let mut hash = mix(job);
    for part in [iteration, view] {
        hash = mix(hash ^ part.wrapping_add(GOLDEN));
    }
    (hash & !3) | purpose as u64
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
                        let seed = seed(job, iteration, view, purpose);
                        assert_eq!(seed & 3, purpose as u64);
                        assert!(seen.insert(seed), "{job} {iteration} {view} {purpose:?}");
                    }
                }
            }
        }
    }
}
