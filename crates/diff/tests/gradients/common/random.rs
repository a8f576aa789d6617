//! Numbers for scenes put together at random.

use capwalk_math::{Rgb, Vec3};

use super::v;

/// Numbers that look random.
pub struct Random(pub u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }
    /// Uniform between two numbers.
    pub fn number(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }
    pub fn chance(&mut self, probability: f64) -> bool {
        self.number(0.0, 1.0) < probability
    }
    pub fn vector(&mut self, size: f64) -> Vec3 {
        v(
            self.number(-size, size),
            self.number(-size, size),
            self.number(-size, size),
        )
    }
    /// A number that is sometimes at the end of its range.
    pub fn fraction(&mut self) -> f64 {
        match self.below(6) {
            0 => 0.0,
            1 => 1.0,
            _ => self.number(0.0, 1.0),
        }
    }
    pub fn colour(&mut self) -> Rgb {
        Rgb::new(self.fraction(), self.fraction(), self.fraction())
    }
}
