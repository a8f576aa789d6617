//! Eight rays at a time, as they are asked for.

/// Rays in a packet.
pub const RAYS: usize = 8;

/// Eight rays. Those without a bit in the mask are not asked for.
#[derive(Clone, Copy, Debug)]
pub struct Packet<'a> {
    /// World-space origins, coordinate by coordinate.
    pub origin: [&'a [f64; RAYS]; 3],
    /// Unit directions.
    pub direction: [&'a [f64; RAYS]; 3],
    /// Distances between which something is met.
    pub range: [&'a [f64; RAYS]; 2],
    /// One bit for each ray.
    pub mask: u32,
}
