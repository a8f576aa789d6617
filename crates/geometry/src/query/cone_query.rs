//! The question that the silhouette tree answers, and the answer.

use capwalk_math::Vec3;

/// Which edges count as boundaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeSelection {
    /// Open edges, and edges with one face seen from the front and one from
    /// behind.
    Silhouettes,
    /// Every edge, creases too.
    All,
}

/// What lies in front of a plane: on the side that its normal points to.
#[derive(Clone, Copy, Debug)]
pub struct HalfSpace {
    /// Any point of the plane, world units.
    pub point: Vec3,
    /// Normal of the plane, of any length.
    pub normal: Vec3,
}

impl HalfSpace {
    /// True if both ends of an edge, and so all of it, lie behind the plane.
    #[inline]
    pub fn hides(&self, ends: [Vec3; 2]) -> bool {
        let is_behind = |p: Vec3| (p - self.point).dot(self.normal) < 0.0;
        ends.into_iter().all(is_behind)
    }
}

/// A cone to search for boundaries.
#[derive(Clone, Copy, Debug)]
pub struct ConeQuery {
    /// The viewpoint: a shading point, or the camera. World units.
    pub apex: Vec3,
    /// Unit vector.
    pub axis: Vec3,
    /// Half-angle in radians: only points at smaller angles are found. At
    /// least π means no limit.
    pub max_angle: f64,
    /// Which edges count.
    pub edges: EdgeSelection,
    /// Only edges that share a bit with it count.
    pub groups: u8,
    /// Edges wholly outside do not count (`domain = triangle`, mirrors).
    pub in_front_of: Option<HalfSpace>,
}

/// A point on a boundary edge, seen from the viewpoint of the query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SilhouettePoint {
    /// Index in the list that the tree was built with.
    pub edge: u32,
    /// Position along it: 0 at its first vertex, 1 at its second.
    pub t: f64,
    /// Unit direction from the viewpoint.
    pub direction: Vec3,
    /// Distance from the viewpoint, world units.
    pub distance: f64,
    /// Angle to the axis, radians.
    pub angle: f64,
}
