//! Derivatives of rendered images: [`gradient`] is the derivative image along a
//! [`Tangent`](capwalk_scene::Tangent) of the scene (forward mode), [`backward`] the gradient of a
//! loss with respect to everything (reverse mode), [`finite_difference`] their reference, and
//! [`check::compare`] the verdict.
//!
//! All of them share the path tracer of `capwalk-render` and differ in the scalar that it runs
//! over. The crate opens no file, prints nothing, and does not read the clock.

mod adjoint;
mod auto;
pub mod check;
mod finite;
mod forward;
mod forward_eval;
mod gradient_image;
mod options;
mod refused;
mod reverse;
mod reverse_eval;
mod sparse_sums;

// What appears in the signatures here.
pub use capwalk_boundary::pool::with_threads;
pub use capwalk_boundary::{Gathers, Method, MethodTraits, Refusal, may_be_specular};
pub use capwalk_render::{
    Accumulate, Cell, Device, Dips, Estimate, Grid, Halted, Part, PartError, Partial, PixelSums,
    PreparedScene, Purpose, RenderOptions, RenderWork, Rendering, Seed, Statistics, Unwatched,
    UsedDevice, Watch, render,
};
pub use capwalk_walk::{Estimator, WalkSettings};

pub use adjoint::{Adjoint, Target, Wanted};
pub use auto::{Chosen, KeptChoice, PilotSize, Trial};
pub use finite::{Differences, Stencil, finite_difference};
pub use forward::{GradientWork, gradient};
pub use forward_eval::Forward;
pub use gradient_image::GradientImage;
pub use options::GradientOptions;
pub use refused::refusal;
pub use reverse::{Backward, BackwardWork, BatchSums, backward};
pub use reverse_eval::Reverse;
