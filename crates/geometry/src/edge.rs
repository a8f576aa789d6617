//! One edge: whether it is a silhouette, and its closest direction.

use capwalk_math::{Vec3, sphere};

use crate::mesh::Mesh;
use crate::wedge::Apex;

/// An edge of a mesh and what lies on its sides. Coplanar neighbours have no
/// edge between them: it could never be a boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Vertices at its ends, indices into [`Mesh::positions`].
    pub vertices: [u32; 2],
    /// Decides from where it is a silhouette.
    pub sides: Sides,
    /// Bits that a query can select edges by (see `ConeQuery::groups`).
    pub groups: u8,
}

/// What the surface does at an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sides {
    /// One face, more than two, or a degenerate one: always a boundary.
    Open,
    /// Two faces: a silhouette where one is seen from the front and the other
    /// from behind.
    Between {
        /// Indices into [`Mesh::faces`].
        faces: [u32; 2],
        /// True if they are wound against each other, so that the second one's
        /// normal counts reversed.
        flipped: bool,
    },
}

/// A face whose plane passes the viewpoint within this fraction of the coordinates'
/// size is the face that the viewpoint lies on, whose orientation test would be 0/0
/// (METHOD 1). Ray hits in double precision stay within some 1e-14 of it.
pub const ON_PLANE: f64 = 1e-11;

/// 1 if the viewpoint sees the front of a face, -1 if its back, 0 if it lies in its
/// plane. The face has the normal `cross`, of any length, and contains `point`.
#[inline]
fn side_seen(cross: Vec3, point: Vec3, viewpoint: Vec3) -> i32 {
    let height = cross.dot(viewpoint - point);
    let sum = |p: Vec3| p.x.abs() + p.y.abs() + p.z.abs();
    let tolerance = ON_PLANE * (sum(viewpoint) + sum(point)) * cross.length();
    i32::from(height > tolerance) - i32::from(height < -tolerance)
}

/// 1 if parallel light lights the front of a face, -1 if its back, 0 if it passes along it. The
/// face has the normal `cross`, of any length, and so has the light its direction.
fn side_lit(cross: Vec3, direction: Vec3) -> i32 {
    let height = cross.dot(direction);
    let tolerance = ON_PLANE * cross.length() * direction.length();
    i32::from(height < -tolerance) - i32::from(height > tolerance)
}

/// True if light from there passes along a face, up to rounding: it takes no light from what is
/// behind it, and receives none. The tolerance is that of [`Edge::is_silhouette_to`].
pub fn is_edge_on(mesh: &Mesh, face: u32, light: Apex) -> bool {
    let cross = mesh.face_cross(face as usize);
    let [corner, ..] = mesh.corners(face as usize);
    let side = match light {
        Apex::Point(origin) => side_seen(cross, corner, origin),
        Apex::Direction(direction) => side_lit(cross, direction),
    };
    side == 0
}

/// True if an edge through `point` between faces with these normals may bound
/// what the viewpoint sees: one face is seen from the front and the other from
/// behind, or one has the viewpoint in its plane. The latter is the viewpoint's own face;
/// its edges are the horizon, whichever side of the face the viewpoint is on.
#[inline]
pub fn separates(crosses: [Vec3; 2], point: Vec3, flipped: bool, viewpoint: Vec3) -> bool {
    let [first, second] = crosses;
    let (first, second) = (
        side_seen(first, point, viewpoint),
        side_seen(second, point, viewpoint),
    );
    let second = if flipped { -second } else { second };
    first * second <= 0
}

impl Edge {
    /// True if the surface ends or folds at this edge as light sees it that comes from there.
    pub fn is_silhouette_to(&self, mesh: &Mesh, light: Apex) -> bool {
        match (self.sides, light) {
            (Sides::Open, _) => true,
            (Sides::Between { .. }, Apex::Point(origin)) => self.is_silhouette(mesh, origin),
            (Sides::Between { faces, flipped }, Apex::Direction(direction)) => {
                let sides = faces.map(|face| side_lit(mesh.face_cross(face as usize), direction));
                let [first, second] = sides;
                first * if flipped { -second } else { second } <= 0
            }
        }
    }

    /// True if the visible surface ends or folds at this edge seen from `viewpoint`.
    #[inline]
    pub fn is_silhouette(&self, mesh: &Mesh, viewpoint: Vec3) -> bool {
        match self.sides {
            Sides::Open => true,
            Sides::Between { faces, flipped } => {
                // On both faces, so both planes are met at the same point.
                let point = mesh.positions[self.vertices[0] as usize];
                let crosses = faces.map(|face| mesh.face_cross(face as usize));
                separates(crosses, point, flipped, viewpoint)
            }
        }
    }
}

/// The direction on a segment closest to an axis, as seen from the origin.
#[derive(Clone, Copy, Debug)]
pub struct ClosestDirection {
    /// Position along the segment, 0 at `a`, 1 at `b`.
    pub t: f64,
    /// Unit direction from the viewpoint to that point.
    pub direction: Vec3,
    /// Distance of that point from the viewpoint, world units.
    pub distance: f64,
    /// Its angle to the axis, radians.
    pub angle: f64,
}

/// The point of the segment `a b` (relative to the viewpoint) under the smallest
/// angle to the unit vector `axis`, Eq. (30); `None` if the segment passes
/// through the viewpoint.
///
/// The angle has full relative precision however small it is.
#[inline]
pub fn closest_direction(a: Vec3, b: Vec3, axis: Vec3) -> Option<ClosestDirection> {
    let along = b - a;
    let normal = a.cross(along); // of the plane of the great circle
    if normal == Vec3::zero() && a.dot(b) <= 0.0 {
        return None;
    }
    // The plane through axis and normal meets the segment's line where the
    // angle is least, or greatest: (a + t along) · (axis × normal) = 0.
    let w = axis.cross(normal);
    let t = -a.dot(w) / along.dot(w);
    let mut best = (0.0, a);
    if is_nearer(b, a, axis) {
        best = (1.0, b);
    }
    // Comparing with the ends covers the line's far branch, and a segment seen
    // end-on, whose `t` is noise or NaN.
    if t > 0.0 && t < 1.0 {
        let inner = a + along * t;
        if is_nearer(inner, best.1, axis) {
            best = (t, inner);
        }
    }
    let (t, point) = best;
    let distance = point.length();
    let direction = point / distance;
    let angle = sphere::angle_between(axis, direction);
    angle.is_finite().then_some(ClosestDirection {
        t,
        direction,
        distance,
        angle,
    })
}

/// True if `p` has a smaller angle to the axis than `q`.
#[inline]
fn is_nearer(p: Vec3, q: Vec3, axis: Vec3) -> bool {
    // (cos, sin) of the two angles, times the distances: their cross product
    // tells which angle is larger, also when both are tiny.
    let (p_cos, p_sin) = (axis.dot(p), axis.cross(p).length());
    let (q_cos, q_sin) = (axis.dot(q), axis.cross(q).length());
    p_sin * q_cos < q_sin * p_cos
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXIS: Vec3 = Vec3::new(0.0, 0.0, 1.0);

    /// Inside the segment, at either end, and behind the viewpoint.
    #[test]
    fn closest_is_inside_or_an_end() {
        let at = |a: [f64; 3], b: [f64; 3]| closest_direction(a.into(), b.into(), AXIS);
        let inside = at([-1.0, 1e-9, 1.0], [3.0, 1e-9, 1.0]).expect("does not meet the viewpoint");
        assert_eq!(inside.t, 0.25);
        assert!((inside.angle / 1e-9 - 1.0).abs() < 1e-9);
        let first = at([1.0, 0.0, 1.0], [3.0, 1.0, 1.0]).expect("does not meet the viewpoint");
        assert_eq!((first.t, first.distance), (0.0, 2.0_f64.sqrt()));
        let second = at([3.0, 1.0, 1.0], [1.0, 0.0, 1.0]).expect("does not meet the viewpoint");
        assert_eq!((second.t, second.angle), (1.0, first.angle));
        // The line's nearest point lies behind: the segment is farthest there.
        let behind = at([-1.0, 0.1, -1.0], [2.0, 0.1, -1.0]).expect("does not meet the viewpoint");
        assert_eq!(behind.t, 1.0);
    }

    /// Segments through the viewpoint have no direction, whichever end comes first.
    #[test]
    fn segments_through_the_viewpoint() {
        let (zero, p) = (Vec3::zero(), Vec3::new(1.0, 2.0, 3.0));
        for (a, b) in [(zero, p), (p, zero), (p, -p), (zero, zero)] {
            assert!(closest_direction(a, b, AXIS).is_none(), "{a:?} {b:?}");
        }
        // Seen end-on, but not through the viewpoint.
        let end_on = closest_direction(p, p * 2.0, AXIS).expect("does not meet the viewpoint");
        assert!((end_on.direction - p.normalized()).length() < 1e-15);
        // A point.
        assert!(closest_direction(p, p, AXIS).is_some());
    }

    /// A point of the closest direction is never farther from the axis than
    /// the points of a fine subdivision.
    #[test]
    fn closest_is_closest() {
        let [a, b] = [[0.3, -2.0, 1.0], [0.2, 1.5, -0.5]].map(Vec3::from);
        let closest = closest_direction(a, b, AXIS).expect("does not meet the viewpoint");
        let angle_at = |t: f64| sphere::angle_between(AXIS, (a + (b - a) * t).normalized());
        let least = (0..=1000)
            .map(|i| angle_at(1e-3 * f64::from(i)))
            .fold(f64::INFINITY, f64::min);
        assert!(closest.angle <= least && least < closest.angle + 1e-3);
    }
}
