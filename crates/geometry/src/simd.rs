//! Short vectors of numbers, computed eight or four at a time.
//!
//! Node and leaf tests are written once, generic over [`Simd`], and compiled
//! for each instruction set ([`Scalar`], and AVX2 in `simd/avx2.rs`). Which
//! one runs is decided once per tree, see [`Instructions`].
//!
//! Only [`F32x8::mul_add`] (fused or not) and the estimates of [`F32x8`] differ
//! between instruction sets. They are used for bounds, which carry margins for
//! it; the tests of triangles and edges themselves are bitwise the same
//! everywhere.

#[cfg(target_arch = "x86_64")]
mod avx2;

use std::ops::{Add, Div, Mul, Sub};

/// An instruction set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// Plain Rust, runs everywhere.
    Scalar,
    /// AVX2 with fused multiply-add.
    #[cfg(target_arch = "x86_64")]
    Avx2(avx2::Avx2),
}

impl Instructions {
    /// The fastest that this processor has.
    pub fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = avx2::Avx2::detect() {
            return Self::Avx2(avx2);
        }
        Self::Scalar
    }

    /// Runs the job compiled for these instructions.
    #[inline]
    pub fn run<J: Job>(self, job: J) -> J::Output {
        match self {
            Self::Scalar => job.run(Scalar),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(avx2) => avx2.run(job),
        }
    }
}

/// A computation that is compiled for each instruction set. Implementations
/// of `run`, and what they call, must be `#[inline(always)]`: only then are
/// they compiled with the instructions.
pub trait Job {
    /// What it computes.
    type Output;
    /// Computes it.
    fn run<S: Simd>(self, simd: S) -> Self::Output;
}

/// Makes the vectors of one instruction set.
pub trait Simd: Copy {
    /// Eight single-precision numbers.
    type F32x8: F32x8;
    /// Four double-precision numbers.
    type F64x4: F64x4;
    /// The same number eight times.
    fn splat(self, v: f32) -> Self::F32x8;
    /// Eight numbers from memory.
    fn load(self, v: &[f32; 8]) -> Self::F32x8;
    /// Eight integers from memory.
    fn load_i16(self, v: &[i16; 8]) -> Self::F32x8;
    /// Eight small integers from memory.
    fn load_i8(self, v: &[i8; 8]) -> Self::F32x8;
    /// The same number four times.
    fn splat_f64(self, v: f64) -> Self::F64x4;
    /// Brings a value into the caches that will be needed soon.
    fn prefetch<T>(self, value: &T);
    /// Four numbers from memory.
    fn load_f64(self, v: &[f64; 4]) -> Self::F64x4;
}

/// The operations that every vector has.
pub trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The smaller number of each lane; `b` if either is NaN.
    fn min(self, b: Self) -> Self;
    /// The larger number of each lane; `b` if either is NaN.
    fn max(self, b: Self) -> Self;
    /// The absolute values.
    fn abs(self) -> Self;
    /// One bit per lane: `self <= b`. False for NaN.
    fn le(self, b: Self) -> u32;
    /// One bit per lane: `self < b`. False for NaN.
    fn lt(self, b: Self) -> u32;
}

/// Largest relative error of estimates on any processor.
pub const ESTIMATE_ERROR: f32 = 1.5 / (1 << 12) as f32;

/// Eight single-precision numbers.
pub trait F32x8: Lanes {
    /// `self * b + c`, rounded once or twice.
    fn mul_add(self, b: Self, c: Self) -> Self;
    /// `self * b - c`, rounded once or twice.
    fn mul_sub(self, b: Self, c: Self) -> Self;
    /// About one over each number, to a relative error of [`ESTIMATE_ERROR`].
    fn recip_estimate(self) -> Self;
    /// About one over the square root of each number, as precise.
    fn rsqrt_estimate(self) -> Self;
    /// Lanes of `negative` where `self` has its sign bit set, else of `other`.
    fn select_by_sign(self, negative: Self, other: Self) -> Self;
    /// The numbers.
    fn to_array(self) -> [f32; 8];
}

/// Four double-precision numbers.
pub trait F64x4: Lanes {
    /// The numbers.
    fn to_array(self) -> [f64; 4];
}

/// The instruction set that every machine has.
#[derive(Clone, Copy)]
pub struct Scalar;

/// A vector as an array.
#[derive(Clone, Copy)]
pub struct Array<T, const N: usize>([T; N]);

impl Simd for Scalar {
    type F32x8 = Array<f32, 8>;
    type F64x4 = Array<f64, 4>;
    #[inline(always)]
    fn splat(self, v: f32) -> Self::F32x8 {
        Array([v; 8])
    }
    #[inline(always)]
    fn load(self, v: &[f32; 8]) -> Self::F32x8 {
        Array(*v)
    }
    #[inline(always)]
    fn load_i16(self, v: &[i16; 8]) -> Self::F32x8 {
        Array(v.map(f32::from))
    }
    #[inline(always)]
    fn load_i8(self, v: &[i8; 8]) -> Self::F32x8 {
        Array(v.map(f32::from))
    }
    #[inline(always)]
    fn splat_f64(self, v: f64) -> Self::F64x4 {
        Array([v; 4])
    }
    #[inline(always)]
    fn load_f64(self, v: &[f64; 4]) -> Self::F64x4 {
        Array(*v)
    }
    #[inline(always)]
    fn prefetch<T>(self, _value: &T) {}
}

/// Numbers that have an absolute value.
trait Abs {
    fn abs(self) -> Self;
}
impl Abs for f32 {
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
}
impl Abs for f64 {
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
}

impl<T: Copy, const N: usize> Array<T, N> {
    #[inline(always)]
    fn zip(self, b: Self, f: impl Fn(T, T) -> T) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], b.0[i])))
    }
    #[inline(always)]
    fn mask(self, b: Self, f: impl Fn(T, T) -> bool) -> u32 {
        (0..N).fold(0, |mask, i| mask | u32::from(f(self.0[i], b.0[i])) << i)
    }
}

impl<T: Copy + Add<Output = T>, const N: usize> Add for Array<T, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self.zip(b, |a, b| a + b)
    }
}
impl<T: Copy + Sub<Output = T>, const N: usize> Sub for Array<T, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self.zip(b, |a, b| a - b)
    }
}
impl<T: Copy + Mul<Output = T>, const N: usize> Mul for Array<T, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        self.zip(b, |a, b| a * b)
    }
}
impl<T: Copy + Div<Output = T>, const N: usize> Div for Array<T, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        self.zip(b, |a, b| a / b)
    }
}

impl<T, const N: usize> Lanes for Array<T, N>
where
    T: Copy
        + PartialOrd
        + Add<Output = T>
        + Sub<Output = T>
        + Mul<Output = T>
        + Div<Output = T>
        + Abs,
{
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(Abs::abs))
    }
    #[inline(always)]
    fn min(self, b: Self) -> Self {
        self.zip(b, |a, b| if a < b { a } else { b })
    }
    #[inline(always)]
    fn max(self, b: Self) -> Self {
        self.zip(b, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn le(self, b: Self) -> u32 {
        self.mask(b, |a, b| a <= b)
    }
    #[inline(always)]
    fn lt(self, b: Self) -> u32 {
        self.mask(b, |a, b| a < b)
    }
}

impl F32x8 for Array<f32, 8> {
    #[inline(always)]
    fn mul_add(self, b: Self, c: Self) -> Self {
        self * b + c
    }
    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        self * b - c
    }
    #[inline(always)]
    fn recip_estimate(self) -> Self {
        Self(self.0.map(f32::recip))
    }
    #[inline(always)]
    fn rsqrt_estimate(self) -> Self {
        Self(self.0.map(|v| v.sqrt().recip()))
    }
    #[inline(always)]
    fn select_by_sign(self, negative: Self, other: Self) -> Self {
        Self(std::array::from_fn(|i| {
            if self.0[i].is_sign_negative() {
                negative.0[i]
            } else {
                other.0[i]
            }
        }))
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        self.0
    }
}

impl F64x4 for Array<f64, 4> {
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        self.0
    }
}
