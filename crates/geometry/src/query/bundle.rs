//! Sixteen rays at a time, as they are asked for.

/// Rays in a bundle.
pub const BUNDLE: usize = 16;

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
