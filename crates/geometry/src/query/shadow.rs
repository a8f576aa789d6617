//! What one face hides from a viewpoint: edges there need not be looked for.

use capwalk_math::Vec3;

use super::cone_query::{HalfSpace, SilhouettePoint};

/// Which points of edges a search asks for.
pub trait Sight {
    /// True if the point counts: usually, if nothing hides it.
    fn sees(&self, point: &SilhouettePoint) -> bool;

    /// Where no point counts either, if that is known: around a point that did not, usually the shadow of
    /// what hides it.
    fn shadow(&self, _point: &SilhouettePoint) -> Option<Shadow> {
        None
    }
}

/// A predicate, and nothing is known around a point.
impl<F: Fn(&SilhouettePoint) -> bool> Sight for F {
    fn sees(&self, point: &SilhouettePoint) -> bool {
        self(point)
    }
}

/// The part of space that is certainly hidden by one face: behind its plane, and between the planes
/// through the viewpoint and its sides.
#[derive(Clone, Copy, Debug)]
pub struct Shadow {
    /// It lies in front of all of these.
    pub(super) planes: [HalfSpace; 5],
}

/// The share of its size by which a face is smaller than it is, so that rays to what it hides meet it whatever
/// the rounding.
const SHRINK: f64 = 1e-4;
/// The least sine of the angle between the view of a side and of the corner opposite to it. What looks narrower hides
/// little, and less than rounding allows to say.
const NARROWEST: f64 = 1e-3;
/// What is hidden is farther than the face by this share of the distance.
const BEYOND: f64 = 1e-6;
/// The viewpoint is at least so many times as far from the plane of the face as rays are from what they leave.
const LEAST_HEIGHT: f64 = 1e4;

impl Shadow {
    /// What the face with these corners hides from a viewpoint; `None` if that is little. Rays do not meet what is
    /// nearer to the viewpoint than `nearest`, in world units, of which the rounding of a coordinate is a millionth
    /// at most.
    pub fn of_face(viewpoint: Vec3, corners: [Vec3; 3], nearest: f64) -> Option<Self> {
        let corners = corners.map(|corner| corner - viewpoint);
        let [a, b, c] = corners;
        let middle = (a + b + c) / 3.0;
        let [a, b, c] = corners.map(|corner| corner + (middle - corner) * SHRINK);
        // The normal points away from the viewpoint.
        let normal = (b - a).cross(c - a).normalized();
        let normal = normal * normal.dot(middle).signum();
        let height = normal.dot(middle);
        // False for NaN, which a face without area has.
        let is_high = height > LEAST_HEIGHT * nearest;
        if !is_high {
            return None;
        }
        let behind = HalfSpace {
            point: viewpoint + normal * (height * (1.0 + BEYOND)),
            normal,
        };
        // The first three are those through the sides; the last is a place for another one.
        let mut planes = [behind; 5];
        for (plane, [from, to, opposite]) in
            planes.iter_mut().zip([[a, b, c], [b, c, a], [c, a, b]])
        {
            let across = from.cross(to).normalized();
            let inwards = across * across.dot(opposite).signum();
            // False for NaN, which a side seen end-on has.
            let is_wide = inwards.dot(opposite) > NARROWEST * opposite.length();
            if !is_wide {
                return None;
            }
            *plane = HalfSpace {
                point: viewpoint,
                normal: inwards,
            };
        }
        Some(Self { planes })
    }

    /// The part of it in front of a plane.
    pub fn in_front_of(mut self, plane: HalfSpace) -> Self {
        self.planes[4] = plane;
        self
    }

    /// True if all of an edge with these ends is in it.
    #[inline]
    pub(crate) fn hides(&self, ends: [Vec3; 2]) -> bool {
        let is_inside = |plane: &HalfSpace| {
            let is_in_front = |end: Vec3| (end - plane.point).dot(plane.normal) > 0.0;
            ends.into_iter().all(is_in_front)
        };
        self.planes.iter().all(is_inside)
    }
}
