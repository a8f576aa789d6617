//! What a tree costs to traverse, so that a caller can tell when refitting has
//! made it so much worse that building it anew pays.

use super::hierarchy::WIDTH;
use crate::aabb::Aabb;

/// The surface-area cost of a tree: how many nodes and leaves a random line that
/// meets its root is expected to visit (Goldsmith and Salmon 1987).
#[derive(Clone, Copy, Debug, Default)]
pub struct SurfaceCost {
    when_new: f64,
    now: f64,
}

impl SurfaceCost {
    /// Takes the cost of a tree with these boxes of children: the sum of their
    /// surfaces over that of the whole. The root comes first, empty boxes do not
    /// count.
    pub fn update(&mut self, bounds: &[[Aabb; WIDTH]]) {
        let used = || bounds.iter().flatten().filter(|child| !child.is_empty());
        let surfaces: f64 = used().map(|child| f64::from(child.half_area())).sum();
        let root = bounds.iter().take(1).flatten();
        let whole = root.fold(Aabb::EMPTY, |whole, child| whole.union(child));
        self.now = surfaces / f64::from(whole.half_area());
    }

    /// Remembers that the tree has just been built.
    pub fn now_is_new(&mut self) {
        self.when_new = self.now;
    }

    /// The cost over that when the tree was new. Where all lies on one line there
    /// is no surface to compare: 1 if it does now, infinite if it only did then.
    pub fn degradation(&self) -> f64 {
        if !self.now.is_finite() || self.now == self.when_new {
            1.0
        } else if self.when_new.is_finite() {
            self.now / self.when_new
        } else {
            f64::INFINITY
        }
    }
}
