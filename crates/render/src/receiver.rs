//! A point that receives light: what sampling directions towards emitters needs to know of a surface.

use capwalk_math::{Frame, Vec3};

/// Largest rounding error of a cosine.
const ROUNDING: f64 = 1e-9;

/// A point that receives light.
#[derive(Clone, Copy, Debug)]
pub struct Receiver {
    /// World-space position.
    pub position: Vec3,
    /// The shading frame.
    pub frame: Frame,
    /// True if light can come from both sides.
    pub transmits: bool,
}

impl Receiver {
    /// The largest cosine between the shading normal and the direction to a point of a ball, at
    /// least 0, and 0 only if no light from there is reflected or transmitted.
    pub fn largest_cosine(&self, centre: Vec3, radius: f64) -> f64 {
        let offset = centre - self.position;
        let distance = offset.length();
        if distance <= radius {
            return 1.0;
        }
        // The angle between the normal and the centre, less that of the ball around it.
        let cos = offset.dot(self.frame.n) / distance;
        let cos = if self.transmits { cos.abs() } else { cos };
        let sin_ball = radius / distance;
        let cos_ball = (1.0 - sin_ball * sin_ball).max(0.0).sqrt();
        match cos >= cos_ball {
            true => 1.0,
            false => {
                let sin = (1.0 - cos * cos).max(0.0).sqrt();
                (cos * cos_ball + sin * sin_ball + ROUNDING).max(0.0)
            }
        }
    }

    /// The cosine between the shading normal and a unit direction, and a little more, as
    /// [`Self::largest_cosine`] has it: 0 only if no light from there is reflected or transmitted.
    pub fn cosine_in(&self, direction: Vec3) -> f64 {
        cosine_in(direction.dot(self.frame.n), self.transmits)
    }

    /// True if light from a unit direction comes from behind. False for NaN, which the pixel counts.
    #[inline]
    pub fn is_behind(&self, direction: Vec3) -> bool {
        !self.transmits && direction.dot(self.frame.n) <= 0.0
    }
}

/// [`Receiver::cosine_in`], from the cosine itself.
#[inline(always)]
pub fn cosine_in(cos: f64, transmits: bool) -> f64 {
    let cos = if transmits { cos.abs() } else { cos };
    (cos + ROUNDING).clamp(0.0, 1.0)
}
