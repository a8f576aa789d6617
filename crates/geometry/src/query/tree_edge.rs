//! An edge as the silhouette tree keeps it: all that the exact test needs.

use capwalk_math::Vec3;

use super::cone_query::{ConeQuery, EdgeSelection, SilhouettePoint};
use super::edge_block::LocalEdge;
use crate::edge::{Edge, Sides, closest_direction, separates};
use crate::local_frame::LocalFrame;
use crate::mesh::Mesh;

/// What queries need of an edge, in two cache lines.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(super) struct TreeEdge {
    /// World units.
    pub(super) ends: [Vec3; 2],
    /// `Mesh::face_cross` of its two faces; zero if it is open.
    crosses: [Vec3; 2],
    /// Index in the list that the tree was built with.
    pub(super) id: u32,
    kind: EdgeKind,
}

/// [`Sides`] without the faces.
#[derive(Clone, Copy, Debug, PartialEq)]
enum EdgeKind {
    Open,
    Between { flipped: bool },
}

impl TreeEdge {
    /// The edge with this number.
    pub(super) fn new(mesh: &Mesh, id: u32, edge: &Edge) -> Self {
        let (kind, crosses) = match edge.sides {
            Sides::Open => (EdgeKind::Open, [Vec3::zero(); 2]),
            Sides::Between { faces, flipped } => {
                let crosses = faces.map(|face| mesh.face_cross(face as usize));
                (EdgeKind::Between { flipped }, crosses)
            }
        };
        Self {
            ends: edge.vertices.map(|i| mesh.positions[i as usize]),
            crosses,
            id,
            kind,
        }
    }

    /// The normals of its two faces, towards the same side of the surface, as
    /// [`separates`] compares them; zero if it is open.
    pub(super) fn outward_crosses(&self) -> [Vec3; 2] {
        let [first, second] = self.crosses;
        match self.kind {
            EdgeKind::Between { flipped: true } => [first, -second],
            _ => [first, second],
        }
    }

    /// As [`Edge::is_silhouette`].
    #[inline(always)]
    fn is_silhouette(&self, viewpoint: Vec3) -> bool {
        match self.kind {
            EdgeKind::Open => true,
            EdgeKind::Between { flipped } => {
                separates(self.crosses, self.ends[0], flipped, viewpoint)
            }
        }
    }

    /// The edge in local coordinates.
    pub(super) fn local(&self, frame: &LocalFrame, groups: u8) -> LocalEdge {
        let normals = match self.kind {
            EdgeKind::Open => None,
            EdgeKind::Between { flipped } => {
                let [first, second] = self.crosses.map(|cross| self.usable_normal(frame, cross));
                let second = second.map(|n| if flipped { -n } else { n });
                first.zip(second).map(|(first, second)| [first, second])
            }
        };
        LocalEdge {
            ends: self.ends.map(|p| frame.local_from_world(p)),
            normals,
            open: self.kind == EdgeKind::Open,
            groups,
        }
    }

    /// The unit normal of a face; `None` if the face is degenerate, or so thin
    /// that rounding tilts its normal against the edge: the orientation towards
    /// a viewpoint then depends on where along the edge it is measured.
    fn usable_normal(&self, frame: &LocalFrame, cross: Vec3) -> Option<Vec3> {
        let normal = cross.normalized();
        let [a, b] = self.ends;
        let tilt = (b - a).dot(normal).abs() * frame.inverse_scale;
        (tilt <= EDGE_TILT).then_some(normal) // not for NaN
    }

    /// The point of the edge closest to the axis, if the edge is a boundary and
    /// the point nearer than `max_angle`, or as near as `best` and the edge
    /// before it.
    #[inline(always)]
    pub(super) fn closest(
        &self,
        query: &ConeQuery,
        best: Option<&SilhouettePoint>,
    ) -> Option<SilhouettePoint> {
        let counts = query.edges == EdgeSelection::All || self.is_silhouette(query.apex);
        if !counts
            || query
                .in_front_of
                .is_some_and(|plane| plane.hides(self.ends))
        {
            return None;
        }
        let [a, b] = self.ends.map(|p| p - query.apex);
        let closest = closest_direction(a, b, query.axis)?;
        let is_nearer = match best {
            Some(best) => (closest.angle, self.id) < (best.angle, best.edge),
            None => closest.angle < query.max_angle,
        };
        is_nearer.then_some(SilhouettePoint {
            edge: self.id,
            t: closest.t,
            direction: closest.direction,
            distance: closest.distance,
            angle: closest.angle,
        })
    }
}

/// Faces whose computed plane misses their edge by more than this, in local
/// units, are too thin for their normals to be used. Part of the margin of
/// positions.
const EDGE_TILT: f64 = 1.0 / (1 << 24) as f64;
