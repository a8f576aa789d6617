//! Materials: what a file says of a surface ([`Bsdf`]), what follows from that for
//! all who trace paths ([`MaterialTraits`]), and what it does to light at a point
//! ([`resolve`]), as [lobes](lobe).
//!
//! To add one: add a variant to [`Bsdf`], and follow the compiler.

pub mod bsdf;
pub mod lobe;
pub mod resolve;
mod traits;
mod validation;

pub use bsdf::{Bsdf, Material};
pub use resolve::{Resolved, Resolver};
pub use traits::{Anisotropy, Composition, MaterialTraits};
