//! The coordinates that a tree measures in: from its centre, in units of its size,
//! so that single precision is as good far from the world's origin as near it.

use capwalk_math::Vec3;

/// A tree's own coordinates: measured from its centre, and scaled by a power
/// of two such that the tree fits between -1 and 1. The scaling is exact. (Packets
/// of rays have coordinates in which it just fits, and round.)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalFrame {
    /// The centre, in world units.
    pub centre: Vec3,
    /// World units per local unit.
    pub scale: f64,
    /// Local units per world unit.
    pub inverse_scale: f64,
    /// Largest `|x| + |y| + |z|` that a point inside can have, world units.
    pub reach: f64,
}

/// Exponents of the scale are kept within this range, where both the scale and
/// its inverse are normal numbers.
const EXPONENT_LIMIT: i32 = 1000;

impl LocalFrame {
    /// The frame of a tree around the points.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Self {
        let start = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        let (low, high) = points
            .into_iter()
            .fold(start, |(low, high), p| (low.min(p), high.max(p)));
        if low.x > high.x {
            return Self {
                centre: Vec3::zero(),
                scale: 1.0,
                inverse_scale: 1.0,
                reach: 0.0,
            };
        }
        // Halved first, so that nothing overflows.
        let centre = low * 0.5 + high * 0.5;
        let half = (high - centre).max(centre - low).max_component();
        let exponent = if half > 0.0 {
            (half.log2().ceil() as i32).clamp(-EXPONENT_LIMIT, EXPONENT_LIMIT)
        } else {
            0
        };
        let farthest = low.map(f64::abs).max(high.map(f64::abs));
        Self {
            centre,
            scale: 2.0_f64.powi(exponent),
            inverse_scale: 2.0_f64.powi(-exponent),
            reach: farthest.x + farthest.y + farthest.z,
        }
    }

    /// The local coordinates of a point.
    #[inline]
    pub fn local_from_world(&self, p: Vec3) -> Vec3 {
        (p - self.centre) * self.inverse_scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Any mesh ends up between -1 and 1 (rounding aside), wherever it is and
    /// whatever its size.
    #[test]
    fn frame_normalises_position_and_size() {
        for (offset, size) in [
            (0.0, 1.0),
            (1e6, 1e-6),
            (-3e100, 1e90),
            (1.0, 0.0),
            (0.0, 1e-320),
        ] {
            let points = [-1.0, 0.3, 1.0].map(|s| Vec3::new(offset + s * size, s * size, offset));
            let frame = LocalFrame::around(points);
            for p in points {
                let local = frame.local_from_world(p);
                assert!(
                    local.map(f64::abs).max_component() <= 1.0,
                    "{offset} {size}: {local:?}"
                );
            }
        }
    }
}
