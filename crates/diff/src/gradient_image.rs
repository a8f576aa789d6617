//! What forward mode and finite differences give.

use capwalk_render::{Estimate, Statistics};

use crate::auto::Chosen;

/// A derivative image, with the image that came with it.
#[derive(Clone, Debug)]
pub struct GradientImage {
    /// The image.
    pub value: Estimate,
    /// Its derivative per unit of the parameter.
    pub gradient: Estimate,
    /// The method that samples were differentiated by, or the one that was asked for if others chose
    /// it and computed all parts. `None` for finite differences.
    pub chosen: Option<Chosen>,
    /// What was done.
    pub statistics: Statistics,
}
