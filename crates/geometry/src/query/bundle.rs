//! Sixteen rays at a time, as they are asked for.

use capwalk_math::Vec3;

use crate::ray::Ray;

/// Rays in a bundle.
pub const BUNDLE: usize = 16;

/// A number of each ray.
pub type Numbers = [f64; BUNDLE];

/// No face.
pub(super) const NO_FACE: u32 = u32::MAX;

/// Sixteen rays. Those without a bit in the mask are not asked for.
#[derive(Clone, Copy, Debug)]
pub struct Bundle<'a> {
    /// World-space origins, coordinate by coordinate.
    pub origin: &'a [[f64; BUNDLE]; 3],
    /// Directions.
    pub direction: &'a [[f64; BUNDLE]; 3],
    /// Distances between which something is met, in multiples of the directions' lengths.
    pub range: [&'a [f64; BUNDLE]; 2],
    /// One bit for each ray.
    pub mask: u32,
}

impl Bundle<'_> {
    /// The direction of a ray.
    #[inline(always)]
    pub(super) fn direction_of(&self, ray: usize) -> Vec3 {
        vector(self.direction, ray)
    }

    /// A ray, up to a distance.
    #[inline(always)]
    pub(super) fn ray(&self, ray: usize, t_max: f64) -> Ray {
        Ray {
            origin: vector(self.origin, ray),
            direction: self.direction_of(ray),
            t_min: self.range[0][ray],
            t_max,
        }
    }
}

/// The vector of a ray.
#[inline(always)]
pub(super) fn vector(numbers: &[Numbers; 3], ray: usize) -> Vec3 {
    Vec3::new(numbers[0][ray], numbers[1][ray], numbers[2][ray])
}
