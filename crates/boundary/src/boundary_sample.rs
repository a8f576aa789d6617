//! Boundary points, and what their velocities do to the directions in which they are seen.

use capwalk_geometry::SilhouettePoint;
use capwalk_math::Vec3;

use crate::mirror::Mirrors;

/// A boundary point as a linear map: from the velocities of its edge's ends, of the
/// mirrors it is seen in and of the viewpoint, to its angular velocity.
#[derive(Clone, Copy, Debug)]
pub struct BoundarySample {
    /// The ends of its edge, indices into [`Boundaries`](crate::Boundaries).
    pub points: [u32; 2],
    /// Position between them: 0 at the first, 1 at the second.
    pub t: f64,
    /// Unit vector: the direction in which the point is seen or, if `is_horizon`, the normal
    /// of the viewpoint's face.
    pub(crate) direction: Vec3,
    /// True if the edge is on the horizon of the viewpoint's face, across which alone its
    /// motion counts.
    pub(crate) is_horizon: bool,
    /// The direction in which the edge is seen to run, times the root of the part of its motion
    /// along itself that does not count: little counts close to the horizon.
    pub(crate) damped: Vec3,
    /// From the viewpoint along the path of light; in image space if its rays are parallel.
    pub(crate) distance: f64,
    /// Its position in camera space, if the viewpoint's rays are parallel.
    pub(crate) place: Option<Vec3>,
    /// The mirrors in which the viewpoint sees the point.
    pub mirrors: Mirrors,
}

impl BoundarySample {
    /// Coefficients of [`Viewpoint::vectors`](crate::Viewpoint::vectors) in the position of a
    /// point that is fixed to the viewpoint and coincides with this one.
    pub fn shares(&self) -> [f64; 4] {
        let Vec3 { x, y, z } = self.place.unwrap_or(Vec3::zero());
        [1.0, x, y, z]
    }

    /// Angular velocity `P_x̂ (ẋ - ȯ) / |x - o|`, radians, for a relative velocity `ẋ - ȯ`;
    /// on the horizon `n (n·(ẋ - ȯ)) / |x - o|`, and close to it less of the motion along the
    /// edge. The map is symmetric, so it is also its own transpose.
    #[inline]
    pub fn angular(&self, relative: Vec3) -> Vec3 {
        let along = self.direction * self.direction.dot(relative);
        let kept = if self.is_horizon {
            along
        } else {
            relative - along - self.damped * self.damped.dot(relative)
        };
        kept / self.distance
    }
}

/// A boundary point found by a query, before velocities matter.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The point; its direction is the one in which the viewpoint sees it.
    pub point: SilhouettePoint,
    /// The mirrors in which it is seen.
    pub mirrors: Mirrors,
    /// True if it is seen without a specular event.
    pub is_direct: bool,
}
