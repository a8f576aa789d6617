//! How much to sample, and how.

use capwalk_diff::{Method, WalkSettings};
use capwalk_scene::Scene;

use crate::error::Error;
use crate::method::MethodChoice;

/// How an image is rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenderOptions {
    /// Samples per pixel, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// Seed of all random numbers: the same scene and seed give the same bits.
    pub seed: u64,
}

impl Default for RenderOptions {
    /// 64 samples per pixel and the seed 0.
    fn default() -> Self {
        Self { spp: 64, seed: 0 }
    }
}

impl RenderOptions {
    /// What the scene says of itself.
    pub fn of(scene: &Scene) -> Self {
        Self {
            spp: scene.settings.spp,
            seed: scene.settings.seed,
        }
    }

    /// The same with another seed, for an image whose noise must be independent of one
    /// with this seed: an adjoint must not know the random numbers of its gradient. The
    /// complement is nobody's neighbour in a row of seeds.
    #[must_use]
    pub fn with_independent_seed(self) -> Self {
        Self {
            seed: !self.seed,
            ..self
        }
    }
}

/// How a gradient is estimated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GradientOptions {
    /// Samples per pixel, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// Seed of all random numbers.
    pub seed: u64,
    /// How the discontinuities of the integrand are accounted for.
    pub method: Method,
    /// The walk that builds the velocity field, for methods that walk.
    pub walk: WalkSettings,
}

impl Default for GradientOptions {
    /// 64 samples per pixel, the seed 0, and walks on the sphere.
    fn default() -> Self {
        RenderOptions::default().into()
    }
}

impl From<RenderOptions> for GradientOptions {
    /// The default method, sampled like this.
    fn from(RenderOptions { spp, seed }: RenderOptions) -> Self {
        Self {
            spp,
            seed,
            method: Method::default(),
            walk: WalkSettings::default(),
        }
    }
}

impl GradientOptions {
    /// What the scene says of itself, with the default method.
    pub fn of(scene: &Scene) -> Self {
        RenderOptions::of(scene).into()
    }

    /// The same with a method that was chosen by name.
    pub fn with_method(self, choice: &MethodChoice) -> Result<Self, Error> {
        let (method, walk) = choice.resolve()?;
        Ok(Self {
            method,
            walk,
            ..self
        })
    }

    /// How an image with as many samples and the same seed is rendered.
    pub fn sampling(&self) -> RenderOptions {
        RenderOptions {
            spp: self.spp,
            seed: self.seed,
        }
    }
}

/// How central differences are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceOptions {
    /// Samples per pixel on each side, at least 1; at least 2 for standard errors.
    pub spp: u32,
    /// Seed of all random numbers, the same on both sides.
    pub seed: u64,
    /// How far the parameter moves on each side, above 0, in its own units; `None`
    /// chooses [`difference_step`](crate::difference_step).
    pub step: Option<f64>,
}

impl Default for DifferenceOptions {
    /// 64 samples per pixel, the seed 0, and the step that fits the scene.
    fn default() -> Self {
        let RenderOptions { spp, seed } = RenderOptions::default();
        Self {
            spp,
            seed,
            step: None,
        }
    }
}
