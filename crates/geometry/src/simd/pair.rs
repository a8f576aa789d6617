//! Sixteen numbers in two vectors of eight.

use std::ops::{Add, Div, Mul, Sub};

use super::vectors::{F32x8, F32x16, Lanes, Simd};

/// Lanes of one vector.
const HALF: usize = 8;

/// The lower and the upper eight.
#[derive(Clone, Copy)]
pub struct Pair<V>(V, V);

impl<V: F32x8> Pair<V> {
    /// The number in all lanes.
    #[inline(always)]
    pub fn splat(simd: impl Simd<F32x8 = V>, v: f32) -> Self {
        Self(simd.splat(v), simd.splat(v))
    }

    /// Numbers from memory, rounded to the nearest.
    #[inline(always)]
    pub fn round(simd: impl Simd<F32x8 = V>, v: &[f64; 2 * HALF]) -> Self {
        let [low, high] = [0, 1].map(|half| &v.as_chunks::<HALF>().0[half]);
        Self(simd.round(low), simd.round(high))
    }

    /// Numbers from memory.
    #[inline(always)]
    pub fn load(simd: impl Simd<F32x8 = V>, v: &[f32; 2 * HALF]) -> Self {
        let [low, high] = [0, 1].map(|half| &v.as_chunks::<HALF>().0[half]);
        Self(simd.load(low), simd.load(high))
    }
}

/// One operator, half by half.
macro_rules! operator {
    ($operator:ident, $method:ident) => {
        impl<V: F32x8> $operator for Pair<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, b: Self) -> Self {
                Self(self.0.$method(b.0), self.1.$method(b.1))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<V: F32x8> Lanes for Pair<V> {
    #[inline(always)]
    fn min(self, b: Self) -> Self {
        Self(self.0.min(b.0), self.1.min(b.1))
    }
    #[inline(always)]
    fn max(self, b: Self) -> Self {
        Self(self.0.max(b.0), self.1.max(b.1))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }
    #[inline(always)]
    fn le(self, b: Self) -> u32 {
        self.0.le(b.0) | self.1.le(b.1) << HALF
    }
    #[inline(always)]
    fn lt(self, b: Self) -> u32 {
        self.0.lt(b.0) | self.1.lt(b.1) << HALF
    }
}

impl<V: F32x8> F32x16 for Pair<V> {
    #[inline(always)]
    fn fused(self, b: Self, c: Self) -> Self {
        Self(self.0.fused(b.0, c.0), self.1.fused(b.1, c.1))
    }
    #[inline(always)]
    fn mul_sub(self, b: Self, c: Self) -> Self {
        Self(self.0.mul_sub(b.0, c.0), self.1.mul_sub(b.1, c.1))
    }
    #[inline(always)]
    fn replaced(self, mask: u32, other: Self) -> Self {
        Self(
            self.0.replaced(mask, other.0),
            self.1.replaced(mask >> HALF, other.1),
        )
    }
    #[inline(always)]
    fn select_by_sign(self, negative: Self, other: Self) -> Self {
        Self(
            self.0.select_by_sign(negative.0, other.0),
            self.1.select_by_sign(negative.1, other.1),
        )
    }
    #[inline(always)]
    fn smallest(self) -> f32 {
        self.0.min(self.1).smallest()
    }
    #[inline(always)]
    fn largest(self) -> f32 {
        self.0.max(self.1).largest()
    }
    #[inline(always)]
    fn to_array(self) -> [f32; 2 * HALF] {
        let mut array = [0.0; 2 * HALF];
        array[..HALF].copy_from_slice(&self.0.to_array());
        array[HALF..].copy_from_slice(&self.1.to_array());
        array
    }
}
