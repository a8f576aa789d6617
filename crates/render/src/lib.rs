//! How radiance and its derivatives are estimated.
//!
//! [`render`] makes the picture, [`gradient`] its derivative for a
//! [`Motion`](capwalk_scene::Motion) of the scene, [`finite_difference`] the
//! reference that the derivative is checked against, and [`check::compare`]
//! the verdict. Every estimate comes with a standard error per pixel, and is
//! the same to the bit for the same scene, seed and options, whatever the
//! number of threads.
//!
//! Nothing here opens a file, prints, or reads the clock.

mod accel;
pub mod check;
pub mod diff;
pub mod estimate;
mod integrator;
mod lamp;
mod layer;
mod light;
mod material;
pub mod options;
mod path;
mod pixel;
mod plan;
mod sampler;
mod tiles;
mod vertex;
mod world;

pub use capwalk_walk::{Estimator, WalkSettings};
pub use diff::adjoint::Wanted;
pub use diff::finite::finite_difference;
pub use diff::forward::gradient;
pub use diff::refuse::refusal;
pub use diff::reverse::{Backward, backward};
pub use estimate::{Estimate, GradientImage, Rendering, Statistics};
pub use integrator::render;
pub use material::may_be_specular;
pub use options::{
    GradientOptions, Method, Options, Refusal, Unwatched, WasBoundary, WasSettings, Watch,
};
