//! Eight rays at a time, as they are asked for.

use std::array;

use capwalk_math::Vec3;

/// Rays in a packet.
pub const RAYS: usize = 8;

/// Eight rays. Those without a bit in the mask are not asked for.
#[derive(Clone, Copy, Debug)]
pub struct Packet {
    /// World-space origins, coordinate by coordinate.
    pub origin: [[f64; RAYS]; 3],
    /// Unit directions.
    pub direction: [[f64; RAYS]; 3],
    /// Distances between which something is met.
    pub range: [[f64; RAYS]; 2],
    /// One bit for each ray.
    pub mask: u32,
}

impl Packet {
    /// None is asked for yet.
    pub const EMPTY: Self = Self {
        origin: [[0.0; RAYS]; 3],
        direction: [[0.0; RAYS]; 3],
        range: [[0.0; RAYS], [f64::INFINITY; RAYS]],
        mask: 0,
    };

    /// Asks for a ray.
    pub fn set(&mut self, ray: usize, origin: Vec3, direction: Vec3, [from, to]: [f64; 2]) {
        let (origin, direction) = (origin.to_array(), direction.to_array());
        let _: [(); 3] = array::from_fn(|axis| {
            self.origin[axis][ray] = origin[axis];
            self.direction[axis][ray] = direction[axis];
        });
        self.range[0][ray] = from;
        self.range[1][ray] = to;
        self.mask |= 1 << ray;
    }
}
