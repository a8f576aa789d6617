//! A triangle as a point sees it: the part of the sphere of directions that the
//! paper's own fields live on (`domain = triangle`, METHOD 1).

use capwalk_geometry::SilhouettePoint;
use capwalk_geometry::edge::closest_direction;
use capwalk_math::{Vec3, sphere};
use capwalk_walk::{Domain, Nearest, Sphere};

/// The directions from a point to a triangle, bounded by the triangle's own border
/// and by the silhouettes before it. Walks that start inside stay inside.
pub struct Triangle<'a, F> {
    /// The sphere around the point, with the edges that may be before the triangle.
    pub sphere: Sphere<'a, F>,
    /// The corners relative to the point.
    pub corners: [Vec3; 3],
}

/// A boundary point of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TriangleBoundary {
    /// On its own border: a topological boundary.
    Border,
    /// On a silhouette before it: a visibility boundary.
    Silhouette(SilhouettePoint),
}

impl<F> Triangle<'_, F> {
    /// The closest point of the border: within this angle of a direction to the
    /// triangle everything lies on the triangle (the initial half-angle of
    /// Algorithm 6).
    fn border(&self, q: Vec3) -> Option<Nearest<TriangleBoundary, Vec3>> {
        let [a, b, c] = self.corners;
        let sides = [[a, b], [b, c], [c, a]].into_iter();
        let closest = sides.filter_map(|[from, to]| closest_direction(from, to, q));
        let nearest = closest.min_by(|x, y| x.angle.total_cmp(&y.angle))?;
        Some(Nearest {
            site: TriangleBoundary::Border,
            point: nearest.direction,
            distance: nearest.angle,
        })
    }
}

impl<F: Fn(&SilhouettePoint) -> bool> Domain for Triangle<'_, F> {
    type Vector = Vec3;
    type Site = TriangleBoundary;

    fn closest(&self, q: Vec3, limit: f64) -> Option<Nearest<TriangleBoundary, Vec3>> {
        let border = self.border(q).filter(|border| border.distance < limit);
        let limit = border.map_or(limit, |border| border.distance);
        let silhouette = self.sphere.closest(q, limit).map(|nearest| Nearest {
            site: TriangleBoundary::Silhouette(nearest.site),
            point: nearest.point,
            distance: nearest.distance,
        });
        silhouette.or(border)
    }

    #[inline]
    fn radius_at(&self, q: Vec3, known: &Nearest<TriangleBoundary, Vec3>) -> Option<f64> {
        Some(sphere::angle_between(q, known.point))
    }
    #[inline]
    fn growth(&self, q: Vec3, nearest: &Nearest<TriangleBoundary, Vec3>) -> Vec3 {
        -sphere::tangent_towards(q, nearest.point)
    }
    #[inline]
    fn tangent(&self, q: Vec3, azimuth: f64) -> Vec3 {
        self.sphere.tangent(q, azimuth)
    }
    #[inline]
    fn walk(&self, q: Vec3, e: Vec3, angle: f64) -> Vec3 {
        self.sphere.walk(q, e, angle)
    }
    #[inline]
    fn radius_inside(&self, half_angle: f64, u: f64) -> f64 {
        self.sphere.radius_inside(half_angle, u)
    }
    #[inline]
    fn rim_over_ball(&self, half_angle: f64) -> f64 {
        self.sphere.rim_over_ball(half_angle)
    }
    /// None: the velocities are vectors of the triangle's plane, whose divergence
    /// is taken there (Eq. 38).
    #[inline]
    fn curvature(&self, _q: Vec3) -> Vec3 {
        Vec3::zero()
    }
}
