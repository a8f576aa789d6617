//! The camera of one sample.

use capwalk_scene::sensor::view::View;

/// The camera of a sample, seen from one point of its lens.
pub struct Camera<R> {
    pub primal: View<f64>,
    pub moving: View<R>,
}
