//! A view cone in a tree's own coordinates, ready for the kernels.

use capwalk_math::{Frame, Vec3};

use super::cone_query::{ConeQuery, EdgeSelection, HalfSpace};
use super::lanes::splat;
use crate::aabb::round_up;
use crate::edge::ON_PLANE;
use crate::local_frame::LocalFrame;
use crate::simd::Simd;

/// A plane in local coordinates, relative to the apex, with unit normal `n`: in
/// front is `n·(p - apex) >= offset`.
#[derive(Clone, Copy)]
pub struct LocalPlane {
    /// `n`.
    pub normal: [f32; 3],
    /// `offset`.
    pub offset: f32,
    /// Error of heights over the plane.
    pub margin: f32,
}

/// Error of positions in local coordinates, and of what is computed from them,
/// per local unit of distance from the apex. The numbers compared are sums of
/// some thirty terms of at most that size, each rounded by at most 2⁻²⁴.
const POSITION_MARGIN: f64 = 1.0 / (1 << 19) as f64;

/// Everything in a tree is nearer to a point in its coordinates than this.
fn range(apex: Vec3) -> f64 {
    sum(apex) + 3.0
}

fn sum(p: Vec3) -> f64 {
    p.x.abs() + p.y.abs() + p.z.abs()
}

impl LocalPlane {
    /// A plane as it is seen from an apex.
    pub fn new(frame: &LocalFrame, apex: Vec3, plane: &HalfSpace) -> Self {
        let apex = frame.local_from_world(apex);
        let normal = plane.normal.normalized();
        let offset = frame.local_from_world(plane.point).dot(normal);
        Self {
            normal: [normal.x as f32, normal.y as f32, normal.z as f32],
            offset: (offset - apex.dot(normal)) as f32,
            margin: round_up(POSITION_MARGIN * (range(apex) + offset.abs())),
        }
    }
}

/// A view cone in the coordinates of a tree.
pub struct LocalCone<S: Simd> {
    pub apex: [S::F32x8; 3],
    pub axis: [S::F32x8; 3],
    /// Two unit vectors that complete the axis to a frame.
    pub across: [[S::F32x8; 3]; 2],
    /// Error of positions.
    pub margin: S::F32x8,
    /// Distance from a face's plane below which the apex may count as in it.
    pub plane_margin: S::F32x8,
    /// True if all edges count, silhouettes or not.
    pub all_edges: bool,
    /// The groups that count.
    pub groups: u8,
    /// The plane that edges must not be behind.
    pub in_front_of: Option<LocalPlane>,
}

impl<S: Simd> LocalCone<S> {
    /// The cone of a query, in a tree's coordinates and single precision.
    #[inline(always)]
    pub fn new(simd: S, frame: &LocalFrame, query: &ConeQuery) -> Self {
        let apex = frame.local_from_world(query.apex);
        let margin = POSITION_MARGIN * range(apex);
        let on_plane = ON_PLANE * (sum(query.apex) + frame.reach) * frame.inverse_scale;
        let axis = query.axis;
        let Frame { s, t, .. } = Frame::from_normal(axis);
        let in_front_of = query.in_front_of;
        let in_front_of = in_front_of.map(|plane| LocalPlane::new(frame, query.apex, &plane));
        Self {
            apex: splat(simd, [apex.x as f32, apex.y as f32, apex.z as f32]),
            axis: splat(simd, [axis.x as f32, axis.y as f32, axis.z as f32]),
            across: [
                splat(simd, [s.x as f32, s.y as f32, s.z as f32]),
                splat(simd, [t.x as f32, t.y as f32, t.z as f32]),
            ],
            margin: simd.splat(round_up(margin)),
            // Twice: the test in double precision rounds, too.
            plane_margin: simd.splat(round_up(margin + 2.0 * on_plane)),
            all_edges: query.edges == EdgeSelection::All,
            groups: query.groups,
            in_front_of,
        }
    }
}
