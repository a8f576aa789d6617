//! Numbers and vectors of lanes.

use capwalk_math::{Rgb, Vec3};

/// Samples that are taken together.
pub const LANES: usize = 16;

/// One bit for each lane.
#[cfg(test)]
pub const ALL: u32 = (1 << LANES) - 1;

/// A number of each lane.
pub type Numbers = [f64; LANES];

/// A vector of each lane, coordinate by coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Vectors(pub [Numbers; 3]);

impl Vectors {
    /// Zero in all lanes.
    pub const ZERO: Self = Self::splat([0.0; 3]);

    /// The third axis in all lanes.
    pub const UP: Self = Self::splat([0.0, 0.0, 1.0]);

    /// The vector in all lanes.
    pub const fn splat([x, y, z]: [f64; 3]) -> Self {
        Self([[x; LANES], [y; LANES], [z; LANES]])
    }

    /// The vector of a lane.
    #[inline(always)]
    pub fn get(&self, lane: usize) -> Vec3 {
        let [x, y, z] = &self.0;
        Vec3::new(x[lane], y[lane], z[lane])
    }

    /// The products of coordinates.
    #[inline]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = *self;
        for (product, other) in product.0.iter_mut().zip(&other.0) {
            for (product, other) in product.iter_mut().zip(other) {
                *product *= other;
            }
        }
        product
    }

    /// The vector of a lane as a colour.
    #[inline(always)]
    pub fn colour(&self, lane: usize) -> Rgb {
        self.get(lane).to_array().into()
    }

    /// Sets that of a lane to a colour.
    #[inline(always)]
    pub fn set_colour(&mut self, lane: usize, colour: Rgb) {
        self.set(lane, colour.to_array().into());
    }

    /// Sets those of some lanes to the same.
    #[inline(always)]
    pub fn fill(&mut self, lanes: u32, [x, y, z]: [f64; 3]) {
        fill(&mut self.0[0], lanes, x);
        fill(&mut self.0[1], lanes, y);
        fill(&mut self.0[2], lanes, z);
    }

    /// Sets that of a lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, v: Vec3) {
        let [x, y, z] = &mut self.0;
        (x[lane], y[lane], z[lane]) = (v.x, v.y, v.z);
    }
}

/// Sets the numbers of some lanes to the same.
#[inline(always)]
pub fn fill(numbers: &mut Numbers, lanes: u32, x: f64) {
    for (lane, number) in numbers.iter_mut().enumerate() {
        let is_asked = lanes >> lane & 1 == 1;
        *number = if is_asked { x } else { *number };
    }
}

/// One bit for each of some lanes of which something holds.
pub fn mask_of(lanes: u32, mut holds: impl FnMut(usize) -> bool) -> u32 {
    lanes_of(lanes)
        .filter(|&lane| holds(lane))
        .fold(0, |mask, lane| mask | 1 << lane)
}

/// The numbers of the lanes with a bit in the mask.
pub fn lanes_of(mut mask: u32) -> impl Iterator<Item = usize> + Clone {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}
