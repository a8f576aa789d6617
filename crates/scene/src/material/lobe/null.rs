//! The surface that is not there.

use capwalk_math::Vec3;

use super::event::{Drawn, Event};

/// Lets all light pass straight on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Null;

impl Null {
    #[inline]
    pub(super) fn sample(&self, _wi: Vec3, _choice: f64, _u: [f64; 2]) -> Option<Drawn> {
        Some(Drawn::Specular(Event::Pass, 1.0))
    }
}
