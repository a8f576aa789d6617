//! Inverse rendering: which numbers of a scene make its images look like given ones?
//!
//! A [`Problem`] has a scene, [`variable::Variables`] that say which of its numbers
//! are unknown and how values are made of unknowns, views with targets, and a
//! [`loss::Loss`]. [`Problem::iterate`] takes a [`State`] and returns the next one:
//! images, the loss with its standard error, its gradient (`capwalk_diff::backward`), a
//! step of [`adam::Adam`], and the check that the step tore or folded nothing
//! ([`guard`]).
//!
//! An iteration is a function of the problem and the state alone: equal states give
//! equal ones, to the bit, whatever the number of threads. So a run that is stopped
//! anywhere and resumed from the last state ends in the same numbers.
//!
//! Nothing here opens a file, prints, or reads the clock.

pub mod adam;
pub mod guard;
pub mod loss;
pub mod problem;
pub mod record;
pub mod run;
pub mod schedule;
pub mod smooth;
pub mod state;
pub mod variable;
pub mod views;

pub use problem::{Limits, Problem, TargetView};
pub use run::{Iteration, Stop};
pub use state::State;
pub use views::PreparedViews;
