//! Unknowns: which numbers of a scene are looked for, what is done to them on the
//! way into the scene, and the transposed way for gradients.
//!
//! ```text
//! unknowns -> values -> scene     Reparameterization::values, Variables::apply
//! unknowns <- values <- Tangent    gradients: Reparameterization::pull, Variables::pull
//! ```
//!
//! A variable's *values* are what a user reads: the numbers of an array, a
//! translation, displacements of vertices. Its unknowns are what the optimiser
//! steps in; they are the values unless a [`Reparameterization`] says otherwise.

mod all;
mod error;
mod kind;
mod overlap;
pub mod pose;
mod reparameterization;
mod spec;
pub mod vertices;

pub use all::{Outcome, Variables};
pub use error::{ApplyError, VariableError, VerticesError};
pub use kind::Variable;
pub use reparameterization::Reparameterization;
pub use spec::{Curve, VariableSpec, variable};

#[cfg(test)]
pub(crate) mod tests;
