//! Derivatives of rendered images.
//!
//! [`gradient`] is the derivative image for a [`Tangent`](capwalk_scene::Tangent) of the
//! scene (forward mode), [`backward`] the gradient of a loss in everything (reverse
//! mode), [`finite_difference`] the reference that they are checked against, and
//! [`check::compare`] the verdict. All of them share the path tracer of
//! `capwalk-render`; what differs is the scalar that it runs over.
//!
//! Nothing here opens a file, prints, or reads the clock.

mod adjoint;
mod auto;
pub mod check;
mod coverage;
mod finite;
mod forward;
mod forward_eval;
mod options;
#[cfg(feature = "paper")]
pub mod probe;
mod refused;
mod reverse;
mod reverse_eval;

// What appears in the signatures here.
pub use capwalk_boundary::pool::with_threads;
pub use capwalk_boundary::{
    Gathers, Method, MethodTraits, Refusal, SpecularCause, may_be_specular,
};
#[cfg(feature = "paper")]
pub use capwalk_boundary::{WasBoundary, WasSettings};
pub use capwalk_render::{
    Accumulate, Cell, Estimate, GradientImage, Grid, Halted, Missing, Part, PartError, Partial,
    PixelSums, PreparedScene, Purpose, RenderOptions, RenderWork, Rendering, Seed, Statistics,
    Unwatched, Watch, render,
};
pub use capwalk_walk::{Estimator, WalkSettings};

pub use adjoint::{Adjoint, Target, Wanted};
pub use auto::{Chosen, KeptChoice, PilotSize, Trial};
pub use finite::{Differences, Stencil, finite_difference};
pub use forward::{GradientWork, gradient};
pub use forward_eval::Forward;
pub use options::{AllowMissing, GradientOptions};
pub use refused::refusal;
pub use reverse::{Backward, BackwardWork, BatchSums, backward};
pub use reverse_eval::Reverse;
