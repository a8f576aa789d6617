//! AVX2 with fused multiply-add: the one file that allows `unsafe`.
//!
//! The same code is compiled for AVX-512 as well, and runs where the CPU has it: with
//! twice as many registers, and with longer ones for [`F32x16`] and for loops that the compiler
//! makes vectors of. Results are bitwise the same.
//!
//! The intrinsics are safe to execute exactly if the CPU has them. That
//! is proved by the token [`Avx2`]: only [`Avx2::detect`] makes one, and every
//! vector is made from a token or from other vectors.
#![allow(unsafe_code)]

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::pair::Pair;
use super::vectors::{Computation, F32x8, F32x16, F64x4, Lanes, Simd};

/// Proof that the CPU has AVX2 and fused multiply-add.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Avx2 {
    /// True if it has AVX-512 as well, and that is to be used.
    uses_avx512: bool,
}

impl Avx2 {
    /// The proof, if it is true.
    pub fn detect() -> Option<Self> {
        let has_avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        let uses_avx512 = is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("f16c")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512bw");
        has_avx2.then_some(Self { uses_avx512 })
    }

    /// This proof for jobs compiled for AVX2 alone.
    #[cfg(test)]
    pub fn without_avx512(self) -> Self {
        Self { uses_avx512: false }
    }

    /// Runs the job compiled for what the CPU has.
    #[inline]
    pub fn run<J: Computation>(self, job: J) -> J::Output {
        #[target_feature(enable = "avx2,fma")]
        fn compiled<J: Computation>(avx2: Avx2, job: J) -> J::Output {
            job.run(avx2)
        }
        #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq,avx512bw")]
        fn compiled_wide<J: Computation>(avx2: Avx2, job: J) -> J::Output {
            job.run(Avx512(avx2))
        }
        // SAFETY: `self` proves that the CPU has the features.
        unsafe {
            match self.uses_avx512 {
                true => compiled_wide(self, job),
                false => compiled(self, job),
            }
        }
    }
}

/// Proof that the CPU has AVX-512, which [`Avx2::run`] makes where that is so.
#[derive(Clone, Copy, Debug)]
struct Avx512(Avx2);

/// Bytes that are fetched together.
const CACHE_LINE: usize = 64;

/// Eight single-precision numbers in a register.
#[derive(Clone, Copy)]
pub struct F32x8Avx2(__m256);

/// Four double-precision numbers in a register.
#[derive(Clone, Copy)]
pub struct F64x4Avx2(__m256d);

/// Sixteen single-precision numbers in a register.
#[derive(Clone, Copy)]
struct F32x16Avx512(__m512);

impl Simd for Avx2 {
    type F32x8 = F32x8Avx2;
    type F64x4 = F64x4Avx2;
    type F32x16 = Pair<F32x8Avx2>;
    #[inline(always)]
    fn splat(self, v: f32) -> F32x8Avx2 {
        // SAFETY: `self` proves the feature.
        F32x8Avx2(unsafe { _mm256_set1_ps(v) })
    }
    #[inline(always)]
    fn load(self, v: &[f32; 8]) -> F32x8Avx2 {
        // SAFETY: `self` proves the feature; 32 bytes are readable at `v`, and
        // the load needs no alignment.
        F32x8Avx2(unsafe { _mm256_loadu_ps(v.as_ptr()) })
    }
    #[inline(always)]
    fn round(self, v: &[f64; 8]) -> F32x8Avx2 {
        // SAFETY: `self` proves the feature; 64 bytes are readable at `v`, and
        // the loads need no alignment.
        F32x8Avx2(unsafe {
            let low = _mm256_cvtpd_ps(_mm256_loadu_pd(v.as_ptr()));
            let high = _mm256_cvtpd_ps(_mm256_loadu_pd(v[4..].as_ptr()));
            _mm256_set_m128(high, low)
        })
    }
    #[inline(always)]
    fn load_i16(self, v: &[i16; 8]) -> F32x8Avx2 {
        // SAFETY: `self` proves the feature; 16 bytes are readable at `v`, and
        // the load needs no alignment.
        F32x8Avx2(unsafe {
            let integers = _mm_loadu_si128(v.as_ptr().cast());
            _mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(integers))
        })
    }
    #[inline(always)]
    fn load_i8(self, v: &[i8; 8]) -> F32x8Avx2 {
        // SAFETY: `self` proves the feature; 8 bytes are readable at `v`, and
        // the load needs no alignment.
        F32x8Avx2(unsafe {
            let integers = _mm_loadl_epi64(v.as_ptr().cast());
            _mm256_cvtepi32_ps(_mm256_cvtepi8_epi32(integers))
        })
    }
    #[inline(always)]
    fn splat_f64(self, v: f64) -> F64x4Avx2 {
        // SAFETY: `self` proves the feature.
        F64x4Avx2(unsafe { _mm256_set1_pd(v) })
    }
    #[inline(always)]
    fn load_f64(self, v: &[f64; 4]) -> F64x4Avx2 {
        // SAFETY: `self` proves the feature; 32 bytes are readable at `v`, and
        // the load needs no alignment.
        F64x4Avx2(unsafe { _mm256_loadu_pd(v.as_ptr()) })
    }
    #[inline(always)]
    fn prefetch<T>(self, value: &T) {
        let start = std::ptr::from_ref(value).cast::<i8>();
        for offset in (0..size_of::<T>()).step_by(CACHE_LINE) {
            // SAFETY: `self` proves the feature; a prefetch accesses nothing.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(start.wrapping_add(offset)) };
        }
    }
    #[inline(always)]
    fn splat_16(self, v: f32) -> Pair<F32x8Avx2> {
        Pair::splat(self, v)
    }
    #[inline(always)]
    fn round_16(self, v: &[f64; 16]) -> Pair<F32x8Avx2> {
        Pair::round(self, v)
    }
    #[inline(always)]
    fn load_16(self, v: &[f32; 16]) -> Pair<F32x8Avx2> {
        Pair::load(self, v)
    }
}

impl Simd for Avx512 {
    type F32x8 = F32x8Avx2;
    type F64x4 = F64x4Avx2;
    type F32x16 = F32x16Avx512;
    #[inline(always)]
    fn splat(self, v: f32) -> F32x8Avx2 {
        self.0.splat(v)
    }
    #[inline(always)]
    fn load(self, v: &[f32; 8]) -> F32x8Avx2 {
        self.0.load(v)
    }
    #[inline(always)]
    fn round(self, v: &[f64; 8]) -> F32x8Avx2 {
        self.0.round(v)
    }
    #[inline(always)]
    fn load_i16(self, v: &[i16; 8]) -> F32x8Avx2 {
        self.0.load_i16(v)
    }
    #[inline(always)]
    fn load_i8(self, v: &[i8; 8]) -> F32x8Avx2 {
        self.0.load_i8(v)
    }
    #[inline(always)]
    fn splat_f64(self, v: f64) -> F64x4Avx2 {
        self.0.splat_f64(v)
    }
    #[inline(always)]
    fn load_f64(self, v: &[f64; 4]) -> F64x4Avx2 {
        self.0.load_f64(v)
    }
    #[inline(always)]
    fn prefetch<T>(self, value: &T) {
        self.0.prefetch(value);
    }
    #[inline(always)]
    fn splat_16(self, v: f32) -> F32x16Avx512 {
        // SAFETY: `self` proves the feature.
        F32x16Avx512(unsafe { _mm512_set1_ps(v) })
    }
    #[inline(always)]
    fn round_16(self, v: &[f64; 16]) -> F32x16Avx512 {
        // SAFETY: `self` proves the feature; 128 bytes are readable at `v`, and
        // the loads need no alignment.
        F32x16Avx512(unsafe {
            let low = _mm512_cvtpd_ps(_mm512_loadu_pd(v.as_ptr()));
            let high = _mm512_cvtpd_ps(_mm512_loadu_pd(v[8..].as_ptr()));
            _mm512_insertf32x8::<1>(_mm512_castps256_ps512(low), high)
        })
    }
    #[inline(always)]
    fn load_16(self, v: &[f32; 16]) -> F32x16Avx512 {
        // SAFETY: `self` proves the feature; 64 bytes are readable at `v`, and
        // the load needs no alignment.
        F32x16Avx512(unsafe { _mm512_loadu_ps(v.as_ptr()) })
    }
}

/// One operator of a vector type as one intrinsic.
macro_rules! operator {
    ($vector:ident, $operator:ident, $method:ident, $intrinsic:ident) => {
        impl $operator for $vector {
            type Output = Self;
            #[inline(always)]
            fn $method(self, b: Self) -> Self {
                // SAFETY: the vectors were made from a token, which proves the
                // feature.
                Self(unsafe { $intrinsic(self.0, b.0) })
            }
        }
    };
}

operator!(F32x8Avx2, Add, add, _mm256_add_ps);
operator!(F32x8Avx2, Sub, sub, _mm256_sub_ps);
operator!(F32x8Avx2, Mul, mul, _mm256_mul_ps);
operator!(F32x8Avx2, Div, div, _mm256_div_ps);
operator!(F32x16Avx512, Add, add, _mm512_add_ps);
operator!(F32x16Avx512, Sub, sub, _mm512_sub_ps);
operator!(F32x16Avx512, Mul, mul, _mm512_mul_ps);
operator!(F32x16Avx512, Div, div, _mm512_div_ps);
operator!(F64x4Avx2, Add, add, _mm256_add_pd);
operator!(F64x4Avx2, Sub, sub, _mm256_sub_pd);
operator!(F64x4Avx2, Mul, mul, _mm256_mul_pd);
operator!(F64x4Avx2, Div, div, _mm256_div_pd);

impl Lanes for F32x8Avx2 {
    #[inline(always)]
    fn min(self, b: Self) -> Self {
        // SAFETY: the vectors were made from a token, which proves the feature.
        Self(unsafe { _mm256_min_ps(self.0, b.0) })
    }
    #[inline(always)]
    fn max(self, b: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_max_ps(self.0, b.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
    }
    #[inline(always)]
    fn le(self, b: Self) -> u32 {
        // SAFETY: as above.
        unsafe { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(self.0, b.0)) as u32 }
    }
    #[inline(always)]
    fn lt(self, b: Self) -> u32 {
        // SAFETY: as above.
        unsafe { _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LT_OQ>(self.0, b.0)) as u32 }
    }
}

impl F32x8 for F32x8Avx2 {
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        // SAFETY: the vectors were made from a token, which proves the feature.
        Self(unsafe { _mm256_fmadd_ps(self.0, b.0, c.0) })
    }
    #[inline(always)]
    fn fused(self, b: Self, c: Self) -> Self {
        self.mul_add(b, c)
    }
    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_fmsub_ps(self.0, b.0, c.0) })
    }
    #[inline(always)]
    fn recip_estimate(self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_rcp_ps(self.0) })
    }
    #[inline(always)]
    fn rsqrt_estimate(self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_rsqrt_ps(self.0) })
    }
    #[inline(always)]
    fn replaced(self, mask: u32, other: Self) -> Self {
        // SAFETY: as above.
        unsafe {
            let bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let own = _mm256_and_si256(_mm256_set1_epi32(mask as i32), bits);
            let is_set = _mm256_castsi256_ps(_mm256_cmpeq_epi32(own, bits));
            Self(_mm256_blendv_ps(self.0, other.0, is_set))
        }
    }
    #[inline(always)]
    fn select_by_sign(self, negative: Self, other: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_blendv_ps(other.0, negative.0, self.0) })
    }
    #[inline(always)]
    fn smallest(self) -> f32 {
        // SAFETY: as above.
        unsafe {
            let upper = _mm256_extractf128_ps::<1>(self.0);
            let four = _mm_min_ps(_mm256_castps256_ps128(self.0), upper);
            let two = _mm_min_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)))
        }
    }
    #[inline(always)]
    fn largest(self) -> f32 {
        // SAFETY: as above.
        unsafe {
            let upper = _mm256_extractf128_ps::<1>(self.0);
            let four = _mm_max_ps(_mm256_castps256_ps128(self.0), upper);
            let two = _mm_max_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)))
        }
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        let mut array = [0.0; 8];
        // SAFETY: as above; 32 bytes are writable, without alignment.
        unsafe { _mm256_storeu_ps(array.as_mut_ptr(), self.0) };
        array
    }
}

impl Lanes for F64x4Avx2 {
    #[inline(always)]
    fn min(self, b: Self) -> Self {
        // SAFETY: the vectors were made from a token, which proves the feature.
        Self(unsafe { _mm256_min_pd(self.0, b.0) })
    }
    #[inline(always)]
    fn max(self, b: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_max_pd(self.0, b.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }
    #[inline(always)]
    fn le(self, b: Self) -> u32 {
        // SAFETY: as above.
        unsafe { _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(self.0, b.0)) as u32 }
    }
    #[inline(always)]
    fn lt(self, b: Self) -> u32 {
        // SAFETY: as above.
        unsafe { _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, b.0)) as u32 }
    }
}

impl F64x4 for F64x4Avx2 {
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        let mut array = [0.0; 4];
        // SAFETY: the vector was made from a token, which proves the feature;
        // 32 bytes are writable, without alignment.
        unsafe { _mm256_storeu_pd(array.as_mut_ptr(), self.0) };
        array
    }
}

impl Lanes for F32x16Avx512 {
    #[inline(always)]
    fn min(self, b: Self) -> Self {
        // SAFETY: the vectors were made from a token, which proves the feature.
        Self(unsafe { _mm512_min_ps(self.0, b.0) })
    }
    #[inline(always)]
    fn max(self, b: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm512_max_ps(self.0, b.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm512_abs_ps(self.0) })
    }
    #[inline(always)]
    fn le(self, b: Self) -> u32 {
        // SAFETY: as above.
        u32::from(unsafe { _mm512_cmp_ps_mask::<_CMP_LE_OQ>(self.0, b.0) })
    }
    #[inline(always)]
    fn lt(self, b: Self) -> u32 {
        // SAFETY: as above.
        u32::from(unsafe { _mm512_cmp_ps_mask::<_CMP_LT_OQ>(self.0, b.0) })
    }
}

impl F32x16 for F32x16Avx512 {
    #[inline(always)]
    fn fused(self, b: Self, c: Self) -> Self {
        // SAFETY: the vectors were made from a token, which proves the feature.
        Self(unsafe { _mm512_fmadd_ps(self.0, b.0, c.0) })
    }
    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm512_fmsub_ps(self.0, b.0, c.0) })
    }
    #[inline(always)]
    fn replaced(self, mask: u32, other: Self) -> Self {
        // SAFETY: as above.
        Self(unsafe { _mm512_mask_blend_ps(mask as u16, self.0, other.0) })
    }
    #[inline(always)]
    fn select_by_sign(self, negative: Self, other: Self) -> Self {
        // SAFETY: as above.
        unsafe {
            let is_negative = _mm512_movepi32_mask(_mm512_castps_si512(self.0));
            Self(_mm512_mask_blend_ps(is_negative, other.0, negative.0))
        }
    }
    #[inline(always)]
    fn smallest(self) -> f32 {
        // SAFETY: as above.
        unsafe { _mm512_reduce_min_ps(self.0) }
    }
    #[inline(always)]
    fn largest(self) -> f32 {
        // SAFETY: as above.
        unsafe { _mm512_reduce_max_ps(self.0) }
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 16] {
        let mut array = [0.0; 16];
        // SAFETY: as above; 64 bytes are writable, without alignment.
        unsafe { _mm512_storeu_ps(array.as_mut_ptr(), self.0) };
        array
    }
}

/// Asks for the memory of a value that is read a little later.
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    // SAFETY: every x86-64 CPU has it, and it changes nothing.
    unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(value).cast()) }
}
