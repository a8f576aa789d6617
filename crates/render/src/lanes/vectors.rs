//! Numbers and vectors of eight lanes.

use capwalk_math::{Rgb, Vec3};

/// Samples that are taken together.
pub const LANES: usize = 8;

/// A number of each lane.
pub type Numbers = [f64; LANES];

/// A vector of each lane, coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Vectors(pub [Numbers; 3]);

impl Vectors {
    /// The same in all lanes.
    pub fn splat(v: [f64; 3]) -> Self {
        Self(v.map(|number| [number; LANES]))
    }

    /// That of a lane.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> Vec3 {
        let [x, y, z] = &self.0;
        Vec3::new(x[lane], y[lane], z[lane])
    }

    /// That of a lane as a colour.
    #[inline(always)]
    pub fn colour(&self, lane: usize) -> Rgb {
        self.get(lane).to_array().into()
    }

    /// Sets that of a lane to a colour.
    #[inline(always)]
    pub fn set_colour(&mut self, lane: usize, colour: Rgb) {
        self.set(lane, colour.to_array().into());
    }

    /// Sets that of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, v: Vec3) {
        let [x, y, z] = &mut self.0;
        (x[lane], y[lane], z[lane]) = (v.x, v.y, v.z);
    }
}
