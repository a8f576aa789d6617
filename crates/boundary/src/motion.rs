//! The motion of points, as far as sampling weights may use it.

use capwalk_geometry::NormalCone;
use capwalk_math::Vec3;

/// The motion of one or more points, as far as sampling may use it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Their mean velocity, as far as it is known.
    pub velocity: Vec3,
    /// Mean speed against it.
    pub spread: f64,
}

impl Motion {
    /// None.
    pub const STILL: Self = Self::known(Vec3::new(0.0, 0.0, 0.0));

    /// So little that it counts for nothing, of what must not count as stationary.
    pub const LEAST: Self = Self::guessed(f64::MIN_POSITIVE);

    /// One that is known.
    pub const fn known(velocity: Vec3) -> Self {
        Self {
            velocity,
            spread: 0.0,
        }
    }

    /// One of which only the speed is guessed.
    pub const fn guessed(spread: f64) -> Self {
        Self {
            velocity: Vec3::new(0.0, 0.0, 0.0),
            spread,
        }
    }

    /// True if it is certainly none.
    pub fn is_still(&self) -> bool {
        *self == Self::STILL
    }

    /// The mean of several with these weights, above 0.
    pub(crate) fn mean(motions: impl Iterator<Item = (f64, Self)> + Clone) -> Self {
        let total: f64 = motions.clone().map(|(weight, _)| weight).sum();
        let velocities = motions.clone().map(|(weight, one)| one.velocity * weight);
        let velocity = velocities.fold(Vec3::zero(), |sum, v| sum + v) / total;
        let spreads = motions.map(|(weight, one)| {
            let apart = (one.velocity - velocity).length();
            weight * (one.spread + apart)
        });
        Self {
            velocity,
            spread: spreads.sum::<f64>() / total,
        }
    }

    /// A bound of the mean speed against another one along normals in a cone.
    #[inline]
    pub fn speed_against(&self, other: &Self, normals: &NormalCone) -> f64 {
        let relative = self.velocity - other.velocity;
        // Beyond a right angle the cone has all normals.
        let along = normals.axis.dot(relative).abs();
        let across = normals.axis.cross(relative).length();
        let cos = (1.0 - normals.sin * normals.sin).max(0.0).sqrt();
        let speed = match across * cos > along * normals.sin {
            // The normal closest to the velocity is on the rim of the cone.
            true => along * cos + across * normals.sin,
            false => relative.length(),
        };
        speed + self.spread + other.spread
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bounds of the speed of many motions, along all normals of a cone.
    #[test]
    fn speeds_are_bounded() {
        let number = |i: u32| (f64::from(i) * 12.9898).sin();
        let vector = |i: u32| Vec3::new(number(i), number(i + 1), number(i + 2));
        for i in 0..200 {
            let base = vector(100 * i).normalized();
            let spread = 0.4 * number(i).abs();
            let normals: Vec<Vec3> = (1..9)
                .map(|k| (base + vector(100 * i + 3 * k) * spread).normalized())
                .collect();
            let cone = NormalCone::around(|| normals.iter().map(|&n| Some(n)));
            let velocities: Vec<Vec3> = (1..9).map(|k| vector(77 * i + 5 * k)).collect();
            let known = velocities.iter().map(|&v| (1.0, Motion::known(v)));
            let (all, other) = (Motion::mean(known), Motion::known(vector(i)));
            for normal in normals {
                let speeds = velocities
                    .iter()
                    .map(|&v| (v - other.velocity).dot(normal).abs());
                let mean = speeds.sum::<f64>() / velocities.len() as f64;
                assert!(mean <= all.speed_against(&other, &cone) * (1.0 + 1e-12));
            }
        }
        let cone = NormalCone::ALL;
        let [fast, slow] = [2.0, 0.5].map(|speed| Motion::known(base_direction() * speed));
        assert_eq!(fast.speed_against(&fast, &cone), 0.0);
        assert!((fast.speed_against(&slow, &cone) - 1.5).abs() < 1e-15);
        assert_eq!(
            Motion::guessed(1.0).speed_against(&Motion::STILL, &cone),
            1.0
        );
    }

    fn base_direction() -> Vec3 {
        Vec3::new(0.6, 0.0, 0.8)
    }
}
