//! What the tests of fields share.

use capwalk_math::Moments;

/// A number that looks random, from its index.
pub fn random(index: u64) -> f64 {
    let mut x = index.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((x ^ (x >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

/// The `d`-th number of the `i`-th of the samples that `set` names.
#[allow(dead_code)]
pub fn number(set: u64, i: u64, d: u32) -> f64 {
    random((set << 44) + (i << 12) + u64::from(d))
}

/// Panics unless a mean is what it should be within four of its standard
/// errors and an `allowance` for what the reference neglects. Four fail one
/// run in 16000 for each comparison, and seeds are fixed.
#[allow(dead_code)]
pub fn assert_mean(moments: &Moments, expected: f64, allowance: f64, what: &str) {
    let error = moments.standard_error();
    assert!(
        (moments.mean - expected).abs() < 4.0 * error + allowance,
        "{what}: {} ± {error}, expected {expected}",
        moments.mean
    );
}
