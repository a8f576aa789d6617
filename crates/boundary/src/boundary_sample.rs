//! A boundary point seen from a viewpoint.

use capwalk_geometry::SilhouettePoint;
use capwalk_math::Vec3;

use crate::mirror::Mirrors;

/// A boundary point seen from a viewpoint.
#[derive(Clone, Copy, Debug)]
pub struct BoundarySample {
    /// Two points of the boundaries ([`Boundaries`](crate::Boundaries)), and the
    /// place between them.
    pub points: [u32; 2],
    /// Position between them: 0 at the first, 1 at the second.
    pub t: f64,
    /// Velocities along this unit vector are kept if `is_horizon`, else
    /// rejected.
    pub(crate) direction: Vec3,
    pub(crate) is_horizon: bool,
    pub(crate) distance: f64,
    /// Where it is in camera space, if the viewpoint's rays are parallel.
    pub(crate) place: Option<Vec3>,
    /// The mirrors in which the viewpoint sees the point.
    pub mirrors: Mirrors,
}

impl BoundarySample {
    /// How much each of [`Viewpoint::vectors`](crate::Viewpoint::vectors) moves what is fixed to the viewpoint here.
    pub fn shares(&self) -> [f64; 4] {
        let Vec3 { x, y, z } = self.place.unwrap_or(Vec3::zero());
        [1.0, x, y, z]
    }

    /// `P_x̂ v / |x - o|` of a velocity relative to the viewpoint, in the space of its
    /// directions. A symmetric map: its own transpose.
    #[inline]
    pub fn angular(&self, relative: Vec3) -> Vec3 {
        let along = self.direction * self.direction.dot(relative);
        let kept = if self.is_horizon {
            along
        } else {
            relative - along
        };
        kept / self.distance
    }
}

/// A boundary point and how it is seen.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The point; its direction is that of its image.
    pub point: SilhouettePoint,
    /// The mirrors in which it is seen.
    pub mirrors: Mirrors,
    /// True if nothing specular lies before it.
    pub is_direct: bool,
}
