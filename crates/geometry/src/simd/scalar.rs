//! Vectors in plain Rust: the instruction set that every machine has.

use std::ops::{Add, Div, Mul, Sub};

use super::pair::Pair;
use super::vectors::{F32x8, F64x4, Lanes, Simd};

/// The instruction set that every machine has.
#[derive(Clone, Copy)]
pub struct Scalar;

/// A vector as an array.
#[derive(Clone, Copy)]
pub struct Array<T, const N: usize>([T; N]);

impl Simd for Scalar {
    type F32x8 = Array<f32, 8>;
    type F64x4 = Array<f64, 4>;
    type F32x16 = Pair<Self::F32x8>;
    #[inline(always)]
    fn splat(self, v: f32) -> Self::F32x8 {
        Array([v; 8])
    }
    #[inline(always)]
    fn load(self, v: &[f32; 8]) -> Self::F32x8 {
        Array(*v)
    }
    #[inline(always)]
    fn round(self, v: &[f64; 8]) -> Self::F32x8 {
        Array(v.map(|v| v as f32))
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
    #[inline(always)]
    fn splat_16(self, v: f32) -> Self::F32x16 {
        Pair::splat(self, v)
    }
    #[inline(always)]
    fn round_16(self, v: &[f64; 16]) -> Self::F32x16 {
        Pair::round(self, v)
    }
    #[inline(always)]
    fn load_16(self, v: &[f32; 16]) -> Self::F32x16 {
        Pair::load(self, v)
    }
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
    fn fused(self, b: Self, c: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].mul_add(b.0[i], c.0[i])))
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
    fn replaced(self, mask: u32, other: Self) -> Self {
        let lane = |i: usize| match mask >> i & 1 {
            0 => self.0[i],
            _ => other.0[i],
        };
        Self(std::array::from_fn(lane))
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
    fn smallest(self) -> f32 {
        self.0.into_iter().fold(f32::INFINITY, f32::min)
    }
    #[inline(always)]
    fn largest(self) -> f32 {
        self.0.into_iter().fold(f32::NEG_INFINITY, f32::max)
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

/// Asks for the memory of a value that is read a little later, where there is a way to.
#[cfg(not(target_arch = "x86_64"))]
#[inline(always)]
pub fn prefetch<T>(_: &T) {}
