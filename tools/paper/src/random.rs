//! Random numbers: by address, and one after the other. SplitMix64 (Steele et al. 2014).

/// What its state grows by.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// The number with this address, uniform in `[0, 1)`: the parts are mixed one after
/// the other.
pub fn random(address: [u64; 4]) -> f64 {
    to_unit(
        address
            .into_iter()
            .fold(0, |state, part| after(state ^ part)),
    )
}

/// The next number of a sequence, uniform in `[0, 1)`.
pub fn uniform(state: &mut u64) -> f64 {
    let bits = after(*state);
    *state = state.wrapping_add(STEP);
    to_unit(bits)
}

/// What the generator returns when it leaves a state.
fn after(state: u64) -> u64 {
    let mut x = state.wrapping_add(STEP);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

fn to_unit(bits: u64) -> f64 {
    (bits >> 11) as f64 * (-53.0_f64).exp2()
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
