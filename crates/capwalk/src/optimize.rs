//! Inverse rendering: which numbers of a scene make its images look like given ones?
//!
//! A [`Problem`] says what is looked for; it is put together by hand or read from a
//! [`Job`]. [`Problem::iterate`] takes a [`State`] and returns the next one; a [`Run`]
//! does so until the end and keeps every iteration in a folder.

mod duration;
mod fingerprint;
mod folder;
mod job;
mod posed;
mod problem;
mod run;

pub use capwalk_inverse::adam::{Adam, MomentEstimates};
pub use capwalk_inverse::guard::{Guards, Violation, ViolationKind};
pub use capwalk_inverse::record::{Row, Step};
pub use capwalk_inverse::samples::{ByNoise, Descent, NoDescent, StepNoise};
pub use capwalk_inverse::schedule::{Decay, Schedule};
pub use capwalk_inverse::smooth::Smoother;
pub use capwalk_inverse::variable::{
    ApplyError, Curve, Reparameterization, Variable, VariableError, VariableSpec, Variables,
    VerticesError, variable,
};
pub use capwalk_inverse::{Iteration, Limits, PreparedViews, Problem, State, Stop, TargetView};

pub use crate::folder_error::FolderError;
pub use duration::parse_duration;
pub use job::Job;
pub use posed::LoadedProblem;
pub use run::Run;
