//! Short vectors of numbers, computed sixteen, eight or four at a time.
//!
//! Node and leaf tests are written once, generic over [`Simd`], and compiled
//! for each instruction set (`simd/scalar.rs` and `simd/avx2.rs`). Which
//! one runs is decided once per tree, see [`Instructions`].
//!
//! Only [`F32x8::mul_add`] (fused or not) and the estimates of [`F32x8`] differ
//! between instruction sets. They are used for bounds, which carry margins for
//! it; the tests of triangles and edges themselves are bitwise the same
//! everywhere.

#[cfg(target_arch = "x86_64")]
mod avx2;
mod instructions;
mod pair;
mod scalar;
mod vectors;

#[cfg(target_arch = "x86_64")]
pub use avx2::prefetch;
pub use instructions::Instructions;
#[cfg(not(target_arch = "x86_64"))]
pub use scalar::prefetch;
pub use vectors::{Computation, ESTIMATE_ERROR, F32x8, F32x16, F64x4, Lanes, Simd};
