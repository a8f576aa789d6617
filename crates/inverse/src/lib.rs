//! Inverse rendering: finds the parameters of a scene for which its images match given ones. A
//! [`Problem`] has a scene, the unknowns ([`variable::Variables`]), views with targets and a
//! [`loss::Loss`]; [`Problem::iterate`] takes one step of the optimisation.
//!
//! A step maps a [`State`] to the next one: images, the loss with its standard error, its gradient
//! (`capwalk_diff::backward`), a step of [`adam::Adam`], and the check that the step neither
//! inverts nor intersects a mesh ([`guard`]).
//!
//! It is a function of the problem and the state alone: equal states give equal ones, to the bit,
//! whatever the number of threads. So a run that is stopped anywhere and resumed from the last
//! state ends in the same numbers. The crate opens no file, prints nothing, and does not read the
//! clock.

pub mod adam;
pub mod guard;
pub mod loss;
pub mod problem;
pub mod record;
pub mod run;
pub mod samples;
pub mod schedule;
pub mod smooth;
pub mod state;
pub mod variable;
pub mod views;

pub use problem::{Limits, Problem, TargetView};
pub use run::{Iteration, Stop};
pub use state::State;
pub use views::PreparedViews;
