//! The arithmetic of capwalk: scalars that may carry derivatives ([`Real`]), dual numbers and a
//! tape, vectors, affine transforms, frames, the unit sphere with its caps, spherical triangles and
//! rectangles, and running statistics.
//!
//! Smooth code is generic over [`Real`], so the same function evaluates a formula and its
//! derivative:
//!
//! ```
//! use capwalk_math::{Dual, Vec3};
//! let q = Vec3::new(Dual::variable(3.0, 0), Dual::new(4.0, [0.0]), Dual::new(0.0, [0.0]));
//! assert_eq!(q.length().value, 5.0);
//! assert!((q.length().tangent[0] - 0.6).abs() < 1e-15); // x / |q|
//! ```

pub mod affine;
pub mod dual;
pub mod elementary;
pub mod frame;
pub mod near_key;
pub mod quadrature;
pub mod real;
pub mod rgb;
pub mod special;
pub mod sphere;
pub mod spherical_rectangle;
pub mod spherical_triangle;
pub mod stats;
pub mod tape;
pub mod vec2;
pub mod vec3;

pub use affine::Affine;
pub use dual::Dual;
pub use frame::Frame;
pub use real::Real;
pub use rgb::Rgb;
pub use stats::Moments;
pub use tape::{Tape, Var};
pub use vec2::Vec2;
pub use vec3::Vec3;
