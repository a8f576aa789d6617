//! Edges gathered around a viewpoint, and points drawn on them (METHOD 8).
//!
//! Each edge is an arc on the sphere of directions, or a few pieces of one. A
//! piece is chosen by weights that do not depend on any motion, and a direction
//! on it uniformly.

use capwalk_math::{Real, Vec3, sphere};

use crate::boundaries::Boundaries;

/// Radians by which a ray passes an edge on either side of it: a million times the
/// rounding of directions, and far less than what the single precision of mesh
/// files sets edges apart. The integrand is taken this far from where it jumps,
/// which changes the boundary term by a fraction of this size.
const BESIDE: f64 = 1e-10;

/// Unit directions on either side of an edge that is seen in the direction `q`:
/// against the normal of the plane through the viewpoint and the edge, and along it.
pub fn beside(q: Vec3, normal: Vec3) -> [Vec3; 2] {
    [-1.0, 1.0].map(|side| (q + normal * (side * BESIDE)).normalized())
}

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
pub struct SilhouettePieces {
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
    /// Distance from the viewpoint.
    pub distance: f64,
    /// Unit normal of the plane through the viewpoint and the edge.
    normal: Vec3,
    /// One over the density per radian along the edge, shared among edges that lie
    /// on each other.
    weight: f64,
}

// Edges seen closer to each other than [`BESIDE`] lie on each other: what jumps
// there is the sum of what jumps at each, seen from either side of all.

/// Largest sine between edges that lie on each other.
const PARALLEL: f64 = 1e-6;

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

/// Where on the part of an edge in a range a place on its image is, in a plane or
/// on the chord between directions: there, what is far is short. `depths` are those
/// of the part's ends, in any unit.
pub fn place([from, to]: [f64; 2], [near, far]: [f64; 2], part: f64) -> f64 {
    from + (to - from) * part * near / (part * near + (1.0 - part) * far)
}

impl SilhouettePieces {
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
    pub fn count(&self) -> usize {
        self.pieces.len()
    }

    /// A point on an edge, by the number `u`.
    pub fn draw(&self, boundaries: &Boundaries, viewpoint: Vec3, u: f64) -> Option<EdgePoint> {
        let target = u * self.total;
        let i = self.pieces.partition_point(|p| p.cumulative <= target);
        let piece = self.pieces.get(i)?;
        let before = i.checked_sub(1).map_or(0.0, |i| self.pieces[i].cumulative);
        let own = piece.cumulative - before;
        let ends = boundaries.ends(piece.edge);
        let [a, b] = ends.map(|p| p - viewpoint);
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
        Some(EdgePoint {
            points: boundaries.edge(piece.edge).vertices,
            t,
            direction: offset / distance,
            distance,
            normal,
            weight: angle * self.total
                / (own * self.multiplicity(boundaries, viewpoint, piece.edge, q)),
        })
    }

    /// How many edges lie where an edge is seen in the direction `q`, itself among
    /// them: each takes its share of what jumps there.
    fn multiplicity(&self, boundaries: &Boundaries, viewpoint: Vec3, edge: u32, q: Vec3) -> f64 {
        let [a, b] = boundaries.ends(edge).map(|p| p - viewpoint);
        let normal = a.cross(b).normalized();
        let along = normal.cross(q);
        let is_there = |other: &&Piece| {
            if other.edge == edge {
                return false;
            }
            let [a, b] = boundaries.ends(other.edge).map(|p| p - viewpoint);
            let direction = b - a;
            // Where it meets the plane through the viewpoint across the first edge.
            let place = -a.dot(along) / direction.dot(along);
            let point = a + direction * place;
            (other.range[0]..=other.range[1]).contains(&place)
                && point.dot(q) > 0.0
                && normal.dot(point).abs() <= BESIDE * point.length()
                && normal.dot(a.cross(direction).normalized()).abs() > 1.0 - PARALLEL
        };
        1.0 + self.pieces.iter().filter(is_there).count() as f64
    }
}

impl EdgePoint {
    /// The ends of the edge, points of the boundaries.
    pub fn ends(&self) -> [u32; 2] {
        self.points
    }

    /// Unit directions beside the edge: on the side that [`EdgePoint::flow`] counts
    /// as behind, and on the other.
    pub fn sides(&self) -> [Vec3; 2] {
        beside(self.direction, self.normal)
    }

    /// Zero, with the velocity of the edge across itself, seen from `origin`, against
    /// that of a warped direction, from the first of [`EdgePoint::sides`] to the second,
    /// divided by the density of the point. `ends` are those of the edge, in motion.
    pub fn flow<R: Real>(&self, [a, b]: [Vec3<R>; 2], origin: Vec3<R>, warped: Vec3<R>) -> R {
        let edge = (a + (b - a) * R::constant(self.t) - origin).normalized();
        let flow = (edge - warped).dot(Vec3::constant(self.normal * self.weight));
        flow - R::constant(flow.value())
    }
}
