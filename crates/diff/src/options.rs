//! What a caller chooses about a gradient.

use capwalk_boundary::Method;
use capwalk_render::Options;
use capwalk_walk::WalkSettings;

/// How to estimate a gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GradientOptions {
    /// How much to sample.
    pub options: Options,
    /// The boundary estimator.
    pub method: Method,
    /// The walk that builds the velocity field, for methods that walk.
    pub walk: WalkSettings,
}

impl GradientOptions {
    /// The default method and walk.
    pub fn new(options: Options) -> Self {
        Self {
            options,
            method: Method::default(),
            walk: WalkSettings::default(),
        }
    }
}
