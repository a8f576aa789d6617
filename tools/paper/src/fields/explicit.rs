//! The walk of Section 5 on the triangle that a direction meets (Algorithms 2 to
//! 4), among all of its boundaries: the impractical variant, which the practical
//! one can be compared with.
//!
//! Every edge of the scene is asked whether it is a silhouette before the
//! triangle's plane, and projected through the viewpoint on the plane. The walk is on
//! disks there, not on caps: another field, with the same boundary values.

use capwalk_boundary::{
    Accel, Boundaries, CustomField, Field, Flow, Method, Numbers, Refusal, Viewpoint, Visibility,
};
use capwalk_geometry::{Edge, SilhouettePoint};
use capwalk_math::{Frame, Vec2, Vec3};
use capwalk_walk::{WalkSettings, sample_field};

use super::on_triangles::projected;
use super::receiver::{IN_PLANE, Receiver};
use crate::walk::plane::{BoundaryCurve, Plane};

/// The walk on disks in the plane of the triangle that each direction hits, among all silhouettes
/// projected on it: unbiased, and so slow that scenes of many edges are refused.
pub const AMONG_EXPLICIT_BOUNDARIES: Method = Method::Custom(&AmongExplicit);

/// Scenes with more edges are refused: every direction looks at all of them
/// several times.
const MOST_EDGES: usize = 4000;

/// Silhouettes are cut off at this fraction of the viewpoint's height over the plane
/// below the viewpoint: there, they are projected to where no triangle is.
const BELOW_EYE: f64 = 1e-6;

#[derive(Debug)]
struct AmongExplicit;

impl CustomField for AmongExplicit {
    fn name(&self) -> &'static str {
        "walk among explicit boundaries"
    }

    fn is_unbiased(&self) -> bool {
        true
    }

    fn walks(&self) -> bool {
        true
    }

    fn check(&self, boundaries: &Boundaries, _: &WalkSettings) -> Result<(), Refusal> {
        let count = boundaries.edges().len();
        match count > MOST_EDGES {
            true => Err(Refusal::Custom {
                reason: format!(
                    "the scene has {count} edges, and walks among explicit boundaries test all of \
                     them for every direction; expected at most {MOST_EDGES}"
                ),
                instead: Some(
                    "Use fields on triangles or on the sphere, which find the closest ones in a \
                     tree"
                        .into(),
                ),
            }),
            false => Ok(()),
        }
    }

    /// Algorithm 3; `None` if the direction meets nothing.
    fn flow(
        &self,
        accel: &Accel,
        boundaries: &Boundaries,
        viewpoint: &Viewpoint<f64>,
        q: Vec3,
        walk: &WalkSettings,
        random: Numbers,
    ) -> Option<Flow> {
        let receiver = Receiver::met(accel, viewpoint, q)?;
        let field = Field::new(accel, boundaries, AMONG_EXPLICIT_BOUNDARIES);
        let shadows = shadows(&field, &receiver, viewpoint.visibility);
        let frame = Frame::from_normal(receiver.plane(0.0).normal);
        let hit = receiver.viewpoint + q * receiver.distance;
        let flat = |p: Vec3| Vec2::new(frame.s.dot(p - hit), frame.t.dot(p - hit));
        // The border first, then the projected silhouettes.
        let [a, b, c] = receiver.corners;
        let border = [[a, b], [b, c], [c, a]];
        let segments = border.into_iter().chain(shadows.iter().map(|it| it.ends));
        let plane = Plane {
            curves: segments
                .map(|it| BoundaryCurve::Segment(it.map(flat)))
                .collect(),
        };
        let unlimited = WalkSettings {
            max_radius: f64::INFINITY,
            ..*walk
        };
        let number = |i| random.number(i);
        let sample = sample_field(&plane, Vec2::new(0.0, 0.0), &unlimited, number);
        let mut flow = receiver.material();
        for term in sample.terms() {
            let Some(index) = term.site.curve.checked_sub(border.len()) else {
                continue; // on the border, which does not move
            };
            let shadow = &shadows[index];
            let ends = boundaries.ends(shadow.edge);
            let point = shadow.point(&receiver, ends, term.site.t);
            let velocity = projected(&field, viewpoint, &receiver, &point);
            let divergence = frame.s * term.gradient.x + frame.t * term.gradient.y;
            receiver.add(&mut flow, &velocity, term.weight, divergence);
        }
        Some(flow)
    }
}

/// A silhouette and its projection.
struct Shadow {
    edge: u32,
    /// The part of the edge that is projected.
    bounds: [f64; 2],
    /// How far below the viewpoint its ends are, over the viewpoint's height.
    depths: [f64; 2],
    /// Their projections.
    ends: [Vec3; 2],
}

impl Shadow {
    /// The projection of an edge through the receiver's viewpoint on its plane, unless
    /// nothing of it is there. `range` tells how far an end is inside of what can be
    /// seen: below zero, it cannot.
    fn new(
        receiver: &Receiver,
        index: u32,
        ends: [Vec3; 2],
        range: &[&dyn Fn(Vec3) -> f64],
    ) -> Option<Self> {
        let plane = receiver.plane(0.0);
        let depth = |p: Vec3| (receiver.viewpoint - p).dot(plane.normal);
        let full = depth(plane.point);
        let [a, b] = ends.map(|p| depth(p) / full);
        let mut bounds = cut([0.0, 1.0], [a - BELOW_EYE, b - BELOW_EYE])?;
        for inside in range {
            bounds = cut(bounds, ends.map(inside))?;
        }
        let depths = bounds.map(|t| a + (b - a) * t);
        let offset = |t: f64| ends[0] + (ends[1] - ends[0]) * t - receiver.viewpoint;
        Some(Self {
            edge: index,
            bounds,
            depths,
            ends: [0, 1].map(|i| receiver.viewpoint + offset(bounds[i]) / depths[i]),
        })
    }

    /// The point of the edge whose projection is at `t` between the projected ends.
    fn point(&self, receiver: &Receiver, edge_ends: [Vec3; 2], t: f64) -> SilhouettePoint {
        // Equal steps of the projection are longer where the edge is deeper.
        let [a, b] = self.depths;
        let part = t * a / (t * a + (1.0 - t) * b);
        let t = self.bounds[0] + (self.bounds[1] - self.bounds[0]) * part;
        let offset = edge_ends[0] + (edge_ends[1] - edge_ends[0]) * t - receiver.viewpoint;
        let distance = offset.length();
        SilhouettePoint {
            edge: self.edge,
            t,
            direction: offset / distance,
            distance,
            angle: f64::NAN, // nobody asks for it
        }
    }
}

/// The part of an interval where what is linear in `t` from 0 to 1 is not negative.
fn cut([from, to]: [f64; 2], [a, b]: [f64; 2]) -> Option<[f64; 2]> {
    let zero = a / (a - b);
    let bounds = match (a >= 0.0, b >= 0.0) {
        (true, true) => [from, to],
        (true, false) => [from, to.min(zero)],
        (false, true) => [from.max(zero), to],
        (false, false) => return None,
    };
    (bounds[0] < bounds[1]).then_some(bounds)
}

/// All silhouettes between a viewpoint and a receiver, projected on its plane.
fn shadows(field: &Field, receiver: &Receiver, visibility: Visibility) -> Vec<Shadow> {
    let (accel, boundaries) = (field.accel, field.boundaries);
    // The camera sees between its clip planes.
    let view = accel.view.from(receiver.viewpoint);
    let [near, far] = view.clip();
    let behind_near = |p: Vec3| view.depth(p) - near;
    let before_far = |p: Vec3| far - view.depth(p);
    let clip: [&dyn Fn(Vec3) -> f64; 2] = [&behind_near, &before_far];
    let range = match visibility {
        Visibility::Camera => &clip[..],
        Visibility::Surface | Visibility::All => &[],
    };
    let plane = receiver.plane(IN_PLANE * receiver.distance);
    let edges = boundaries.edges().iter().enumerate();
    let shadow = |(index, edge): (usize, &Edge)| {
        let ends = boundaries.ends(index as u32);
        let is_boundary = !plane.hides(ends) && edge.is_silhouette(&accel.mesh, receiver.viewpoint);
        match is_boundary {
            true => Shadow::new(receiver, index as u32, ends, range),
            false => None,
        }
    };
    edges.filter_map(shadow).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_geometry::{Hit, Mesh};

    /// Points of a projected edge are projections of the edge's points, also where it
    /// rises above the viewpoint.
    #[test]
    fn points_of_shadows_are_shadows_of_points() {
        let v = |x: f64, y: f64, z: f64| Vec3::new(x, y, z);
        let mesh = Mesh {
            positions: vec![v(-1.0, -0.8, 2.0), v(1.2, -0.7, 2.6), v(0.1, 1.3, 1.7)],
            faces: vec![[0, 1, 2]],
        };
        let viewpoint = v(0.1, 0.05, -0.3);
        let hit = Hit {
            face: 0,
            t: 2.2,
            barycentric: [0.3, 0.3],
        };
        let receiver = Receiver::new(&mesh, &hit, viewpoint, v(0.0, 0.0, 1.0));
        let inner = [v(-0.1, 0.1, 0.8), v(0.2, 0.3, 1.4)];
        for ends in [
            inner,
            [inner[0], v(0.3, 0.4, -1.0)],
            [v(0.1, 0.9, -2.0), inner[1]],
        ] {
            let shadow =
                Shadow::new(&receiver, 0, ends, &[]).expect("some of it is before the plane");
            for t in [0.2, 0.7, 0.95] {
                let point = shadow.point(&receiver, ends, t);
                let at = viewpoint + point.direction * point.distance;
                let on_edge = ends[0] + (ends[1] - ends[0]) * point.t;
                assert!((at - on_edge).length() < 1e-12);
                let expected = shadow.ends[0] + (shadow.ends[1] - shadow.ends[0]) * t;
                let distance = receiver.distance_along(point.direction);
                let projected = viewpoint + point.direction * distance;
                let error = (projected - expected).length() / distance;
                assert!(error < 1e-9, "{projected:?} {expected:?}");
            }
        }
        let above = [v(0.0, 0.0, -0.5), v(0.4, 0.3, -1.0)];
        assert!(Shadow::new(&receiver, 0, above, &[]).is_none());
    }
}
