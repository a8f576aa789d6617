//! What every instruction set can do.

use std::ops::{Add, Div, Mul, Sub};

/// A computation that is compiled for each instruction set. Implementations
/// of `run`, and what they call, must be `#[inline(always)]`: only then are
/// they compiled with the instructions.
pub trait Computation {
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
    /// Sixteen single-precision numbers.
    type F32x16: F32x16;
    /// A vector with the number in all eight lanes.
    fn splat(self, v: f32) -> Self::F32x8;
    /// Eight numbers from memory.
    fn load(self, v: &[f32; 8]) -> Self::F32x8;
    /// Eight numbers from memory, rounded to the nearest.
    fn round(self, v: &[f64; 8]) -> Self::F32x8;
    /// Eight integers from memory.
    fn load_i16(self, v: &[i16; 8]) -> Self::F32x8;
    /// Eight small integers from memory.
    fn load_i8(self, v: &[i8; 8]) -> Self::F32x8;
    /// A vector with the number in all four lanes.
    fn splat_f64(self, v: f64) -> Self::F64x4;
    /// Brings a value into the caches that will be needed soon.
    fn prefetch<T>(self, value: &T);
    /// Four numbers from memory.
    fn load_f64(self, v: &[f64; 4]) -> Self::F64x4;
    /// A vector with the number in all sixteen lanes.
    fn splat_16(self, v: f32) -> Self::F32x16;
    /// Sixteen numbers from memory, rounded to the nearest.
    fn round_16(self, v: &[f64; 16]) -> Self::F32x16;
    /// Sixteen numbers from memory.
    fn load_16(self, v: &[f32; 16]) -> Self::F32x16;
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

/// Largest relative error of estimates on any CPU.
pub const ESTIMATE_ERROR: f32 = 1.5 / (1 << 12) as f32;

/// Eight single-precision numbers.
pub trait F32x8: Lanes {
    /// `self * b + c`, rounded once or twice.
    fn mul_add(self, b: Self, c: Self) -> Self;
    /// `self * b + c`, rounded once on every machine.
    fn fused(self, b: Self, c: Self) -> Self;
    /// `self * b - c`, rounded once or twice.
    fn mul_sub(self, b: Self, c: Self) -> Self;
    /// About one over each number, to a relative error of [`ESTIMATE_ERROR`].
    fn recip_estimate(self) -> Self;
    /// About one over the square root of each number, as precise.
    fn rsqrt_estimate(self) -> Self;
    /// The lanes of `other` where the mask has a bit, else of `self`.
    fn replaced(self, mask: u32, other: Self) -> Self;
    /// Lanes of `negative` where `self` has its sign bit set, else of `other`.
    fn select_by_sign(self, negative: Self, other: Self) -> Self;
    /// The smallest number, if none is NaN.
    fn smallest(self) -> f32;
    /// The largest number, if none is NaN.
    fn largest(self) -> f32;
    /// The numbers.
    fn to_array(self) -> [f32; 8];
}

/// Sixteen single-precision numbers.
pub trait F32x16: Lanes {
    /// `self * b + c`, rounded once on every machine.
    fn fused(self, b: Self, c: Self) -> Self;
    /// `self * b - c`, rounded once or twice.
    fn mul_sub(self, b: Self, c: Self) -> Self;
    /// The lanes of `other` where the mask has a bit, else of `self`.
    fn replaced(self, mask: u32, other: Self) -> Self;
    /// Lanes of `negative` where `self` has its sign bit set, else of `other`.
    fn select_by_sign(self, negative: Self, other: Self) -> Self;
    /// The smallest number, if none is NaN.
    fn smallest(self) -> f32;
    /// The largest number, if none is NaN.
    fn largest(self) -> f32;
    /// The numbers.
    fn to_array(self) -> [f32; 16];
}

/// Four double-precision numbers.
pub trait F64x4: Lanes {
    /// The numbers.
    fn to_array(self) -> [f64; 4];
}
