//! The sphere of directions around a shading point; balls are spherical caps.

use std::cell::Cell;

use capwalk_geometry::{
    ConeQuery, EdgeSelection, HalfSpace, Sight, SilhouettePoint, SilhouetteTree,
};
use capwalk_math::{Frame, Vec3, sphere};

use crate::domain::{Domain, Nearest};

/// The sphere of directions around a point, bounded by the edges seen from it.
pub struct Sphere<'a, F = fn(&SilhouettePoint) -> bool> {
    /// Of all edges that may be boundaries.
    pub tree: &'a SilhouetteTree,
    /// The shading point, the paper's `p_{K+1}`, or the camera. World units.
    pub origin: Vec3,
    /// Which edges are boundaries.
    pub edges: EdgeSelection,
    /// Only edges of these groups are.
    pub groups: u8,
    /// Edges wholly outside are not (`domain = triangle`).
    pub in_front_of: Option<HalfSpace>,
    /// Which points of these edges count, for example only those that can be
    /// seen; `None` if all of them do.
    pub counts: Option<F>,
    /// How many closest-silhouette queries were made.
    pub queries: Cell<u64>,
}

impl<'a> Sphere<'a> {
    /// The sphere around a point, bounded by all silhouettes that are seen from it.
    pub fn of_silhouettes(tree: &'a SilhouetteTree, origin: Vec3) -> Self {
        Self {
            tree,
            origin,
            edges: EdgeSelection::Silhouettes,
            groups: u8::MAX,
            in_front_of: None,
            counts: None,
            queries: Cell::new(0),
        }
    }
}

impl<F: Sight> Domain for Sphere<'_, F> {
    type Vector = Vec3;
    type Site = SilhouettePoint;

    #[inline]
    fn closest(&self, q: Vec3, limit: f64) -> Option<Nearest<SilhouettePoint, Vec3>> {
        self.queries.set(self.queries.get() + 1);
        let query = ConeQuery {
            apex: self.origin,
            axis: q,
            max_angle: limit,
            edges: self.edges,
            groups: self.groups,
            in_front_of: self.in_front_of,
        };
        let site = match &self.counts {
            None => self.tree.closest(&query)?,
            Some(counts) => self.tree.closest_where(&query, counts)?,
        };
        Some(Nearest {
            site,
            point: site.direction,
            distance: site.angle,
        })
    }

    #[inline]
    fn radius_at(&self, q: Vec3, known: &Nearest<SilhouettePoint, Vec3>) -> Option<f64> {
        Some(sphere::angle_between(q, known.point))
    }

    #[inline]
    fn growth(&self, q: Vec3, nearest: &Nearest<SilhouettePoint, Vec3>) -> Vec3 {
        -sphere::tangent_towards(q, nearest.point)
    }

    #[inline]
    fn tangent(&self, q: Vec3, azimuth: f64) -> Vec3 {
        sphere::sample_tangent(&Frame::from_normal(q), azimuth)
    }

    #[inline]
    fn walk(&self, q: Vec3, e: Vec3, angle: f64) -> Vec3 {
        sphere::walk_along(q, e, angle)
    }

    /// `1 - cos θ = u (1 - cos A)`, in half angles.
    #[inline]
    fn radius_inside(&self, half_angle: f64, u: f64) -> f64 {
        2.0 * (u.sqrt() * (0.5 * half_angle).sin()).asin()
    }

    /// `2π sin A / (2π (1 - cos A)) = cot(A/2)`, Eq. (34).
    #[inline]
    fn rim_over_ball(&self, half_angle: f64) -> f64 {
        (0.5 * half_angle).tan().recip()
    }

    /// `div(P_q ū) = Σ d·∂_d ū - 2 q·ū` (METHOD 2).
    #[inline]
    fn curvature(&self, q: Vec3) -> Vec3 {
        q * -2.0
    }
}
