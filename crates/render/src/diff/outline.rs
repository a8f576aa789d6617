//! Edges gathered around an eye, and points drawn on them (METHOD 8).
//!
//! Each edge is an arc on the sphere of directions, or a few pieces of one. A
//! piece is chosen by weights that do not depend on any motion, and a direction
//! on it uniformly.

use capwalk_math::{Real, Vec3, sphere};

use crate::world::World;

use super::boundary::Boundaries;

/// A piece of an edge.
#[derive(Clone, Copy, Debug)]
struct Piece {
    edge: u32,
    /// Where it starts and ends on the edge: 0 is its first vertex, 1 its second.
    range: [f64; 2],
    /// Weights of all pieces up to and including this one.
    cumulative: f64,
}

/// Pieces of edges to draw points from.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    pieces: Vec<Piece>,
    total: f64,
}

/// A direction in which an edge is seen.
#[derive(Clone, Copy, Debug)]
pub struct EdgePoint {
    /// The ends of the edge, points of the boundaries.
    points: [u32; 2],
    /// Position between them.
    t: f64,
    /// The unit direction.
    pub direction: Vec3,
    /// Distance from the eye.
    pub distance: f64,
    /// Unit normal of the plane through the eye and the edge.
    normal: Vec3,
    /// Angle between directions on either side of the edge and this one.
    beside: f64,
    /// One over the density per radian along the edge, shared among edges that lie
    /// on each other.
    weight: f64,
}

/// The integrand is taken this part of the angle of an edge beside it, and at most
/// [`BESIDE`] radians, where whatever else bounds the two faces is farther away
/// but near the edge's ends; so the flux is wrong by a fraction of this size.
const BESIDE_OF_EDGE: f64 = 1e-5;
const BESIDE: f64 = 1e-7;
/// And at least this many radians, a thousand times the rounding of directions.
const LEAST_BESIDE: f64 = 1e-12;

/// Fraction of its length by which an edge may lie beside another one and still
/// lie on it: edges of shapes that touch.
const ON_EDGE: f64 = 1e-6;

/// The part of a segment, seen from the origin, on the inner sides of planes
/// through the origin with these unit normals, moved outward by a distance.
pub fn clip(planes: &[Vec3], margin: f64, [a, b]: [Vec3; 2]) -> Option<[f64; 2]> {
    let [mut from, mut to] = [0.0_f64, 1.0_f64];
    for normal in planes {
        let [first, second] = [a, b].map(|p| normal.dot(p) + margin);
        if first < 0.0 && second < 0.0 {
            return None;
        }
        let crossing = first / (first - second);
        if first < 0.0 {
            from = from.max(crossing);
        } else if second < 0.0 {
            to = to.min(crossing);
        }
    }
    (from < to).then_some([from, to])
}

impl Outline {
    /// Adds the part of an edge in a range. Without a weight it is not drawn.
    pub fn push(&mut self, edge: u32, range: [f64; 2], weight: f64) {
        // Not for NaN.
        if weight > 0.0 {
            self.total += weight;
            self.pieces.push(Piece {
                edge,
                range,
                cumulative: self.total,
            });
        }
    }

    /// Adds the chance that no point is drawn, if there are any to draw.
    pub fn push_nothing(&mut self, weight: f64) {
        self.total += weight;
    }

    /// How many pieces there are.
    pub fn len(&self) -> usize {
        self.pieces.len()
    }

    /// A point on an edge, by the number `u`.
    pub fn draw(&self, boundaries: &Boundaries, eye: Vec3, u: f64) -> Option<EdgePoint> {
        let target = u * self.total;
        let i = self.pieces.partition_point(|p| p.cumulative <= target);
        let piece = self.pieces.get(i)?;
        let before = i.checked_sub(1).map_or(0.0, |i| self.pieces[i].cumulative);
        let own = piece.cumulative - before;
        let ends = boundaries.ends(piece.edge);
        let [a, b] = ends.map(|p| p - eye);
        let along = b - a;
        let normal = a.cross(along).normalized();
        let [from, to] = piece.range.map(|t| (a + along * t).normalized());
        let angle = sphere::angle_between(from, to);
        // What is left of the number within its piece is uniform again.
        let inside = ((target - before) / own).clamp(0.0, 1.0);
        let q = sphere::walk_along(from, normal.cross(from), angle * inside);
        // Where on the edge that is: (a + t along) × q = 0.
        let t = -a.cross(q).dot(normal) / along.cross(q).dot(normal);
        let t = t.clamp(piece.range[0], piece.range[1]);
        let offset = a + along * t;
        let distance = offset.length();
        let whole = sphere::angle_between(a.normalized(), b.normalized());
        Some(EdgePoint {
            points: boundaries.edge(piece.edge).vertices,
            t,
            direction: offset / distance,
            distance,
            normal,
            beside: (BESIDE_OF_EDGE * whole).clamp(LEAST_BESIDE, BESIDE),
            weight: angle * self.total / (own * self.multiplicity(boundaries, piece.edge, ends, t)),
        })
        .filter(|point| point.weight.is_finite())
    }

    /// How many edges lie at a place on an edge, itself among them: each takes its
    /// share of what jumps there.
    fn multiplicity(&self, boundaries: &Boundaries, edge: u32, ends: [Vec3; 2], t: f64) -> f64 {
        let along = ends[1] - ends[0];
        let point = ends[0] + along * t;
        let is_there = |other: &&Piece| {
            if other.edge == edge {
                return false;
            }
            let [a, b] = boundaries.ends(other.edge);
            let direction = b - a;
            let squared = direction.length_squared();
            let tolerance = ON_EDGE * ON_EDGE * squared;
            let offset = point - a;
            let place = offset.dot(direction) / squared;
            (other.range[0]..=other.range[1]).contains(&place)
                && (offset - direction * place).length_squared() <= tolerance
                && along.cross(direction).length_squared() <= tolerance * along.length_squared()
        };
        1.0 + self.pieces.iter().filter(is_there).count() as f64
    }
}

impl EdgePoint {
    /// Unit directions beside the edge: on the side that [`EdgePoint::flow`] counts
    /// as behind, and on the other.
    pub fn sides(&self) -> [Vec3; 2] {
        [-1.0, 1.0].map(|side| (self.direction + self.normal * (side * self.beside)).normalized())
    }

    /// Zero, with the velocity of the edge across itself against that of a carried
    /// direction, from the first of [`EdgePoint::sides`] to the second, divided by
    /// the density of the point.
    pub fn flow<R: Real, W: World<R>>(&self, world: &W, eye: Vec3<R>, carried: Vec3<R>) -> R {
        let [a, b] = self.points.map(|i| world.boundary_point(i));
        let edge = (a + (b - a) * R::constant(self.t) - eye).normalized();
        let flow = (edge - carried).dot(Vec3::constant(self.normal * self.weight));
        flow - R::constant(flow.value())
    }
}
