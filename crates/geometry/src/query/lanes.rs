//! Vectors of points for the kernels of the silhouette tree: eight at a time.
//!
//! No closures over vectors here: they would not be compiled with the
//! instructions.

use crate::simd::{F32x8, Simd};

/// The vector, eight times.
#[inline(always)]
pub fn splat<S: Simd>(simd: S, v: [f32; 3]) -> [S::F32x8; 3] {
    [simd.splat(v[0]), simd.splat(v[1]), simd.splat(v[2])]
}

/// Eight vectors of integers from memory.
#[inline(always)]
pub fn load_i16<S: Simd>(simd: S, v: &[[i16; 8]; 3]) -> [S::F32x8; 3] {
    [
        simd.load_i16(&v[0]),
        simd.load_i16(&v[1]),
        simd.load_i16(&v[2]),
    ]
}

/// Eight vectors of small integers from memory.
#[inline(always)]
pub fn load_i8<S: Simd>(simd: S, v: &[[i8; 8]; 3]) -> [S::F32x8; 3] {
    [
        simd.load_i8(&v[0]),
        simd.load_i8(&v[1]),
        simd.load_i8(&v[2]),
    ]
}

/// `a - b`.
#[inline(always)]
pub fn sub<F: F32x8>(a: [F; 3], b: [F; 3]) -> [F; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Inner products.
#[inline(always)]
pub fn dot<F: F32x8>(a: [F; 3], b: [F; 3]) -> F {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

/// One over each number, to almost full precision: an estimate and one step of
/// Newton's method.
#[inline(always)]
pub fn recip<S: Simd>(simd: S, v: S::F32x8) -> S::F32x8 {
    let estimate = v.recip_estimate();
    estimate * (simd.splat(2.0) - v * estimate)
}

/// One over the square root of each number, as precise.
#[inline(always)]
pub fn rsqrt<S: Simd>(simd: S, v: S::F32x8) -> S::F32x8 {
    let estimate = v.rsqrt_estimate();
    estimate * (simd.splat(1.5) - simd.splat(0.5) * v * estimate * estimate)
}

/// `v - axis z`.
#[inline(always)]
pub fn reject<F: F32x8>(v: [F; 3], axis: [F; 3], z: F) -> [F; 3] {
    [v[0] - axis[0] * z, v[1] - axis[1] * z, v[2] - axis[2] * z]
}

/// Cross products.
#[inline(always)]
pub fn cross<F: F32x8>(a: [F; 3], b: [F; 3]) -> [F; 3] {
    [
        a[1].mul_sub(b[2], a[2] * b[1]),
        a[2].mul_sub(b[0], a[0] * b[2]),
        a[0].mul_sub(b[1], a[1] * b[0]),
    ]
}

/// One bit for each entry that shares a group with `selected`.
#[inline(always)]
pub fn groups_mask(groups: &[u8; 8], selected: u8) -> u32 {
    const LOW_BITS: u64 = 0x7f7f_7f7f_7f7f_7f7f;
    let shared = u64::from_le_bytes(*groups) & u64::from_le_bytes([selected; 8]);
    // The top bit of each byte that is not zero; no byte carries to the next.
    let top_bits = (((shared & LOW_BITS) + LOW_BITS) | shared) & !LOW_BITS;
    // The product gathers the eight bits in the top byte.
    ((top_bits >> 7).wrapping_mul(0x0102_0408_1020_4080) >> 56) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bit tricks do what the loop does.
    #[test]
    fn mask_of_groups() {
        let mut groups = [0, 1, 2, 3, 128, 255, 64, 0];
        for selected in 0..=255 {
            groups.rotate_left(1);
            let expected = (0..8).filter(|&i| groups[i] & selected != 0);
            let expected = expected.fold(0, |mask, i| mask | 1 << i);
            assert_eq!(
                groups_mask(&groups, selected),
                expected,
                "{groups:?} {selected}"
            );
        }
    }
}
