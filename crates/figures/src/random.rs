//! Random numbers by address.

/// The number with this address, uniform in `[0, 1)`. SplitMix64's finaliser
/// (Steele et al. 2014) over the parts one after the other.
pub fn random(address: [u64; 4]) -> f64 {
    let mixed = address.into_iter().fold(0, |state: u64, part| {
        let mut x = (state ^ part).wrapping_add(0x9e37_79b9_7f4a_7c15);
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    });
    (mixed >> 11) as f64 * (-53.0_f64).exp2()
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_math::Moments;

    #[test]
    fn numbers_are_uniform_and_their_addresses_matter() {
        let [mut mean, mut product] = [Moments::default(); 2];
        for i in 0..40_000 {
            let [a, b] = [0, 1].map(|d| random([1, 2, i, d]));
            mean.add(a);
            product.add((a - 0.5) * (b - 0.5));
        }
        assert!((mean.mean - 0.5).abs() < 4.0 * mean.standard_error());
        assert!((mean.variance() * 12.0 - 1.0).abs() < 0.03);
        assert!(product.mean.abs() < 4.0 * product.standard_error());
        assert_ne!(random([1, 2, 3, 4]), random([1, 3, 2, 4]));
    }
}
