//! Materials: what a file says of a surface ([`Bsdf`]), what follows from that for
//! all who trace paths ([`MaterialTraits`]), and what it does to light at a point
//! ([`resolve`]), as [lobes](lobe).
//!
//! One that is not made of others is a file: a struct over what a [number] is, with its fields
//! declared once ([`fields`]), and what it answers ([`plain`]).
//!
//! To add one: write its file under `lobe/`, and put it into the list of `lobe/list.rs`.

pub mod bsdf;
pub mod fields;
pub mod lobe;
pub mod number;
pub mod plain;
pub mod resolve;
mod traits;
mod validation;

pub use bsdf::{Bsdf, Material};
pub use plain::Anisotropy;
pub use resolve::{Resolved, Resolver};
pub use traits::{Composition, MaterialTraits};
