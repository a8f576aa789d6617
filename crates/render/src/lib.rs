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

pub mod check;
pub mod estimate;
pub mod options;

pub use estimate::{Estimate, GradientImage, Rendering, Statistics};
pub use options::{Estimator, GradientOptions, Options, Refusal, Unwatched, WalkSettings, Watch};

use capwalk_scene::{Motion, Scene};

/// The picture of a scene. The scene must have passed [`Scene::check`].
pub fn render(_scene: &Scene, _options: &Options, _watch: &dyn Watch) -> Rendering {
    todo!()
}

/// The derivative of the picture for a unit change along `motion`, in forward
/// mode. Refuses, with the reason, what it cannot differentiate rightly.
pub fn gradient(
    _scene: &Scene,
    _motion: &Motion,
    _options: &GradientOptions,
    _watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    todo!()
}

/// The same derivative by central differences with common random numbers over
/// `±step`, unbiased up to terms of order `step²`.
pub fn finite_difference(
    _scene: &Scene,
    _motion: &Motion,
    _step: f64,
    _options: &Options,
    _watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    todo!()
}
