//! Edges gathered around a viewpoint, and points sampled on them (METHOD 8).
//!
//! Projected on the sphere of directions, an edge is an arc, cut into pieces. A piece is
//! chosen by a weight that is not differentiated, and a direction on it
//! uniformly by angle.

use capwalk_geometry::Sides;
use capwalk_math::{Real, Vec3, sphere};
use capwalk_scene::EmitterId;

use crate::accel::Accel;
use crate::beside::{BESIDE, beside, beside_for_paths};
use crate::boundaries::Boundaries;
use crate::coincident::ALONE;
use crate::mirror_image::MirrorImage;

/// A piece of an edge.
#[derive(Clone, Copy, Debug)]
struct Piece {
    edge: u32,
    /// The number of its image.
    image: u32,
    /// Its ends on the edge, from 0 at the first vertex to 1 at the second.
    range: [f64; 2],
    /// Sum of the weights up to and including this one.
    cumulative: f64,
}

/// A ball around the directions in which a piece is seen.
#[derive(Clone, Copy, Debug)]
struct Ball {
    centre: [f32; 3],
    squared_radius: f32,
}

impl Ball {
    /// Part of the radius, and distance, by which it is larger than need be: more than rounding
    /// and [`BESIDE`].
    const MARGIN: [f64; 2] = [1e-4, 1e-6];

    /// Around the shorter arc between two directions.
    fn around([first, last]: [Vec3; 2]) -> Self {
        let [part, least] = Self::MARGIN;
        let radius = 0.5 * (last - first).length() * (1.0 + part) + least;
        Self {
            centre: ((first + last) * 0.5).to_array().map(|x| x as f32),
            squared_radius: (radius * radius) as f32,
        }
    }

    /// True for what is not a number.
    #[inline]
    fn may_contain(&self, [x, y, z]: [f32; 3]) -> bool {
        let [a, b, c] = self.centre;
        let square = (x - a) * (x - a) + (y - b) * (y - b) + (z - c) * (z - c);
        let is_outside = square > self.squared_radius;
        !is_outside
    }
}

/// Pieces of edges with sampling weights.
#[derive(Clone, Debug, Default)]
pub struct SilhouettePieces {
    pieces: Vec<Piece>,
    /// Where each piece is seen, by the numbers of the pieces, if the viewpoint is a fixed one.
    balls: Vec<Ball>,
    /// The row of each piece's edge ([`Boundaries::row`]), by the numbers of the pieces, if it is not.
    rows: Vec<u32>,
    total: f64,
    /// True if the viewpoint is a fixed one, which may lie in the plane of two edges.
    from_one_place: bool,
    /// The images in mirrors of which there are pieces; the scene as it is comes first. Without
    /// any, all pieces are of that.
    images: Vec<MirrorImage>,
}

/// A sampled point of an edge, as seen from the viewpoint.
#[derive(Clone, Copy, Debug)]
pub struct EdgePoint {
    /// Which edge.
    edge: u32,
    /// In which image.
    image: u32,
    /// The ends of the edge, points of the boundaries.
    points: [u32; 2],
    /// Position between them.
    t: f64,
    /// Unit direction from the viewpoint.
    pub direction: Vec3,
    /// Distance from the viewpoint.
    pub distance: f64,
    /// Unit normal of the plane through the viewpoint and the edge.
    normal: Vec3,
    /// One over the density per radian along the edge, and over the number of edges that
    /// coincide there.
    weight: f64,
}

// Edges that are seen less than [`BESIDE`] apart count as coincident: the rays beside one
// of them pass all of them, and see the sum of their discontinuities.

/// Least sine of an angle between a face and the view, or its projection and its edge, for
/// which rays beside the edge hit it or pass it as they should.
const CLEARLY: f64 = 1e-4;

/// Largest sine of the angle between coincident edges.
pub const PARALLEL: f64 = 1e-6;

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

/// The place on an edge, between the ends of a range, whose projection divides that of the
/// range at the fraction `part`, in an image plane or on the chord between directions.
/// `near` and `far` are the depths of the range's ends, in any unit: perspective shortens
/// what is far.
pub fn place([from, to]: [f64; 2], [near, far]: [f64; 2], part: f64) -> f64 {
    from + (to - from) * part * near / (part * near + (1.0 - part) * far)
}

impl SilhouettePieces {
    /// None yet, for the camera: its viewpoint is no random one, and may lie in the plane of
    /// two edges, which then coincide there.
    ///
    /// It sees these images.
    pub fn of_camera(images: Vec<MirrorImage>) -> Self {
        Self {
            from_one_place: true,
            images,
            ..Self::default()
        }
    }

    /// Takes all pieces away.
    pub fn clear(&mut self) {
        self.pieces.clear();
        self.balls.clear();
        self.rows.clear();
        self.total = 0.0;
    }

    /// Adds a piece of an edge. One whose weight is not above 0 is never sampled.
    pub fn push(&mut self, boundaries: &Boundaries, edge: u32, range: [f64; 2], weight: f64) {
        if self.add(edge, 0, range, weight) {
            self.rows.push(boundaries.row(edge));
        }
    }

    /// Adds a piece of an edge in one of the images of the camera, which sees its ends in these
    /// directions.
    pub fn push_seen(
        &mut self,
        edge: u32,
        image: u32,
        range: [f64; 2],
        directions: [Vec3; 2],
        weight: f64,
    ) {
        if self.add(edge, image, range, weight) {
            self.balls.push(Ball::around(directions));
        }
    }

    /// Adds a piece if its weight is above 0, and says so.
    fn add(&mut self, edge: u32, image: u32, range: [f64; 2], weight: f64) -> bool {
        let is_sampled = weight > 0.0; // false for NaN
        if is_sampled {
            self.total += weight;
            self.pieces.push(Piece {
                edge,
                image,
                range,
                cumulative: self.total,
            });
        }
        is_sampled
    }

    /// Adds an edge that is not sampled, but shares the discontinuity where it lies on
    /// edges that are. Once for each such edge.
    pub fn push_companion(&mut self, boundaries: &Boundaries, edge: u32) {
        self.rows.push(boundaries.row(edge));
        self.pieces.push(Piece {
            edge,
            image: 0,
            range: [0.0, 1.0],
            cumulative: self.total,
        });
    }

    /// True if there is a piece of this edge.
    pub fn contains(&self, edge: u32) -> bool {
        self.pieces.iter().any(|piece| piece.edge == edge)
    }

    /// Adds a probability that no point is sampled. Comes after all pieces.
    pub fn push_nothing(&mut self, weight: f64) {
        self.total += weight;
    }

    /// How many pieces there are.
    pub fn count(&self) -> usize {
        self.pieces.len()
    }

    /// A point on an edge by the random number `u` in `[0, 1)`; `None` where there is no
    /// piece, or with the probability of [`SilhouettePieces::push_nothing`].
    ///
    /// `is_seen` says of an image whether the viewpoint sees a point of it, in a direction and at
    /// a distance.
    pub fn draw(
        &self,
        boundaries: &Boundaries,
        viewpoint: Vec3,
        u: f64,
        is_seen: impl Fn(&MirrorImage, Vec3, f64) -> bool,
    ) -> Option<EdgePoint> {
        let places = if self.from_one_place {
            self.balls.len()
        } else {
            self.rows.len()
        };
        debug_assert_eq!(places, self.pieces.len());
        let target = u * self.total;
        let i = self.pieces.partition_point(|p| p.cumulative <= target);
        let piece = self.pieces.get(i)?;
        let before = i.checked_sub(1).map_or(0.0, |i| self.pieces[i].cumulative);
        let own = piece.cumulative - before;
        // The arc of this piece, from its ends as seen from the viewpoint.
        let [a, b] = self.ends(boundaries, piece).map(|p| p - viewpoint);
        let along = b - a;
        let normal = a.cross(along).normalized();
        let [from, to] = piece.range.map(|t| (a + along * t).normalized());
        let angle = sphere::angle_between(from, to);
        // The random number, rescaled within the piece, is uniform again: a place on the arc.
        let inside = ((target - before) / own).clamp(0.0, 1.0);
        let q = sphere::walk_along(from, normal.cross(from), angle * inside);
        // Project the direction back on the edge: (a + t along) × q = 0.
        let t = -a.cross(q).dot(normal) / along.cross(q).dot(normal);
        let t = t.clamp(piece.range[0], piece.range[1]);
        let offset = a + along * t;
        let distance = offset.length();
        Some(EdgePoint {
            edge: piece.edge,
            image: piece.image,
            points: boundaries.edge(piece.edge).vertices,
            t,
            direction: offset / distance,
            distance,
            normal,
            weight: angle * self.total
                / (own * self.multiplicity(boundaries, viewpoint, i, q, is_seen)),
        })
    }

    /// The image of which a point is.
    pub fn image(&self, point: &EdgePoint) -> &MirrorImage {
        &self.images[point.image as usize]
    }

    /// Where the ends of a piece's edge are seen.
    fn ends(&self, boundaries: &Boundaries, piece: &Piece) -> [Vec3; 2] {
        let ends = boundaries.ends(piece.edge);
        match self.images.get(piece.image as usize) {
            None => ends,
            Some(image) => ends.map(|p| image.point(p)),
        }
    }

    /// How many edges coincide where the edge of a piece is seen in the direction `q`, itself
    /// included: each of them adds its share of the discontinuity.
    /// In a direct view all count, hidden or not; otherwise those that are seen.
    fn multiplicity(
        &self,
        boundaries: &Boundaries,
        viewpoint: Vec3,
        piece: usize,
        q: Vec3,
        is_seen: impl Fn(&MirrorImage, Vec3, f64) -> bool,
    ) -> f64 {
        let own = &self.pieces[piece];
        let [a, b] = self.ends(boundaries, own).map(|p| p - viewpoint);
        let normal = a.cross(b).normalized();
        let along = normal.cross(q);
        let coincides = |other: &Piece| {
            if (other.edge, other.image) == (own.edge, own.image) {
                return false;
            }
            let [a, b] = self.ends(boundaries, other).map(|p| p - viewpoint);
            let direction = b - a;
            // Intersect it with the plane through the viewpoint, perpendicular to the first edge.
            let place = -a.dot(along) / direction.dot(along);
            let point = a + direction * place;
            let is_direct = own.image == 0 && other.image == 0;
            (other.range[0]..=other.range[1]).contains(&place)
                && point.dot(q) > 0.0
                && normal.dot(point).abs() <= BESIDE * point.length()
                && normal.dot(a.cross(direction).normalized()).abs() > 1.0 - PARALLEL
                && (is_direct || {
                    let (image, distance) = (&self.images[other.image as usize], point.length());
                    is_seen(image, point / distance, distance)
                })
        };
        let count = if self.from_one_place {
            let seen = q.to_array().map(|x| x as f32);
            let near = self.pieces.iter().zip(&self.balls);
            let near = near.filter(|(_, ball)| ball.may_contain(seen));
            near.filter(|(other, _)| coincides(other)).count()
        } else {
            // Seen from all places but a few, edges coincide only where they do in space.
            let row = self.rows[piece];
            if row == ALONE {
                return 1.0;
            }
            let others = self.pieces.iter().zip(&self.rows);
            let others = others.filter(|&(_, &other)| other == row);
            others.filter(|(other, _)| coincides(other)).count()
        };
        1.0 + count as f64
    }
}

impl EdgePoint {
    /// The ends of the edge, points of the boundaries.
    pub fn ends(&self) -> [u32; 2] {
        self.points
    }

    /// Unit directions beside the edge: behind it, from where [`EdgePoint::flow`] counts, and
    /// before it.
    pub fn sides(&self) -> [Vec3; 2] {
        beside(self.direction, self.normal)
    }

    /// [`EdgePoint::sides`] for paths that go on to the surfaces there, and from these to others.
    pub fn sides_of_paths(&self, boundaries: &Boundaries, accel: &Accel) -> [Vec3; 2] {
        let ends = boundaries.ends(self.edge);
        let place = [self.t, self.distance];
        beside_for_paths(accel, ends, place, [self.direction, self.normal])
    }

    /// The one of [`EdgePoint::sides`] on which, seen from the viewpoint, a surface that is
    /// no part of the emitter begins at the edge; `None` if that is not certain.
    pub fn covered_side(
        &self,
        boundaries: &Boundaries,
        accel: &Accel,
        viewpoint: Vec3,
        emitter: EmitterId,
    ) -> Option<usize> {
        let edge = boundaries.edge(self.edge);
        let Sides::Between { faces, .. } = edge.sides else {
            return None;
        };
        // Both faces must be clearly seen, from different sides: then they fold here, and
        // lie on the same side of the edge.
        let mut seen = [0.0; 2];
        let mut beside = [0.0; 2];
        for (i, face) in faces.into_iter().enumerate() {
            let shape = accel.shape_of_face[face as usize];
            if accel.scene.shape(shape).emitter == Some(emitter) {
                return None;
            }
            let cross = accel.mesh.face_cross(face as usize).normalized();
            seen[i] = cross.dot(self.direction);
            let corners = accel.mesh.faces[face as usize];
            let third = corners
                .into_iter()
                .find(|corner| !edge.vertices.contains(corner))?;
            let offset = accel.mesh.positions[third as usize] - viewpoint;
            beside[i] = self.normal.dot(offset.normalized());
        }
        let is_clear = seen.iter().chain(&beside).all(|x| x.abs() > CLEARLY);
        let same_side = beside[0] * beside[1] > 0.0;
        (is_clear && same_side).then_some(usize::from(beside[0] > 0.0))
    }

    /// `(u_edge - u)·n` over the density of the point: a number of value zero with this
    /// derivative. `u_edge` is the angular velocity of the edge around `origin`, `u` that of
    /// the direction `warped`, and `n` points from the first of [`EdgePoint::sides`] to the
    /// second. `a` and `b` are the ends of the edge with their derivatives.
    pub fn flow<R: Real>(&self, [a, b]: [Vec3<R>; 2], origin: Vec3<R>, warped: Vec3<R>) -> R {
        let edge = (a + (b - a) * R::constant(self.t) - origin).normalized();
        let flow = (edge - warped).dot(Vec3::constant(self.normal * self.weight));
        flow - R::constant(flow.value())
    }
}

#[cfg(test)]
mod tests {
    use capwalk_math::Affine;
    use capwalk_scene::primitive::cube;
    use capwalk_scene::{BsdfId, Scene, Shape, builtin};

    use super::*;

    /// Two cubes that touch along an edge, and one beside them.
    fn cubes() -> Accel {
        let mut scene: Scene = builtin::scene("leaf").expect("built in");
        scene.shapes.clear();
        scene.emitters.clear();
        for (i, place) in [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [-4.0, 0.0, 0.0]]
            .into_iter()
            .enumerate()
        {
            let (mesh, normals) = cube(Affine::translate(place.into()));
            scene.add_shape(Shape::new(format!("{i}"), mesh, normals, BsdfId(0)));
        }
        Accel::new(scene)
    }

    /// Edges that touch, and others that lie behind them as seen from a point: as many coincide where
    /// only pieces are asked that may lie there as if all were.
    #[test]
    fn balls_leave_out_nothing_that_coincides() {
        let accel = cubes();
        let boundaries = Boundaries::new(&accel);
        // In the plane of sides of the first and the third cube.
        let viewpoint = Vec3::new(7.0, 0.3, 1.0);
        let images = accel.images(viewpoint, [Vec3::zero(); 4], 0).expect("one");
        let mut pieces = SilhouettePieces::of_camera(images);
        for edge in 0..boundaries.edges().len() as u32 {
            let ends = boundaries.ends(edge).map(|p| p - viewpoint);
            for i in 0..4 {
                let range = [0, 1].map(|k| f64::from(i + k) / 4.0);
                let seen = range.map(|t| (ends[0] + (ends[1] - ends[0]) * t).normalized());
                pieces.push_seen(edge, 0, range, seen, 1.0);
            }
        }
        let mut asked = pieces.clone();
        asked.balls.fill(Ball {
            centre: [0.0; 3],
            squared_radius: f32::INFINITY,
        });
        let mut coincide = 0;
        for i in 0..2000 {
            let u = (f64::from(i) + 0.5) / 2000.0;
            let [found, expected] = [&pieces, &asked].map(|pieces| {
                let point = pieces.draw(&boundaries, viewpoint, u, |_, _, _| true);
                point.expect("a piece").weight
            });
            assert_eq!(found, expected);
            let single = SilhouettePieces {
                from_one_place: false,
                rows: vec![ALONE; pieces.count()],
                ..pieces.clone()
            };
            let alone = single.draw(&boundaries, viewpoint, u, |_, _, _| true);
            coincide += u32::from(alone.expect("a piece").weight > found);
        }
        assert!(coincide > 20, "{coincide}");
    }

    /// Seen from all places but a few, as many coincide where only edges of one row are asked as if
    /// all were.
    #[test]
    fn rows_leave_out_nothing_that_coincides() {
        let accel = cubes();
        let boundaries = Boundaries::new(&accel);
        let viewpoint = Vec3::new(7.1, 0.3, 2.7);
        let mut pieces = SilhouettePieces::default();
        for edge in 0..boundaries.edges().len() as u32 {
            for i in 0..4 {
                let range = [0, 1].map(|k| f64::from(i + k) / 4.0);
                pieces.push(&boundaries, edge, range, 1.0);
            }
        }
        let [mut all, mut none] = [0, 1].map(|_| pieces.clone());
        all.rows.fill(0);
        none.rows.fill(ALONE);
        let mut coincide = 0;
        for i in 0..2000 {
            let u = (f64::from(i) + 0.5) / 2000.0;
            let [found, expected, alone] = [&pieces, &all, &none].map(|pieces| {
                let point = pieces.draw(&boundaries, viewpoint, u, |_, _, _| true);
                point.expect("a piece").weight
            });
            assert_eq!(found, expected);
            coincide += u32::from(alone > found);
        }
        assert!(coincide > 20, "{coincide}");
    }

    /// The ball of a piece contains all directions to it, also those beside it, however long it is
    /// and however it lies to the axes; and few others.
    #[test]
    fn balls_contain_their_pieces() {
        let spread = |i: i32, k: f64| 2.0 * (f64::from(i) * k).fract() - 1.0;
        let direction = |i: i32| {
            let [x, y, z] = [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|k| spread(i, k));
            Vec3::new(x, y, z).normalized()
        };
        let single = |q: Vec3| q.to_array().map(|x| x as f32);
        for i in 1..400 {
            let (first, other) = (direction(i), direction(7 * i + 3));
            let normal = first.cross(other).normalized();
            // From a hundred millionth of a turn to nearly half of one.
            for angle in [1e-8, 1e-4, 0.01, 0.3, 2.0, 3.1] {
                let across = normal.cross(first);
                let at = |part: f64| sphere::walk_along(first, across, angle * part);
                let ball = Ball::around([first, at(1.0)]);
                for part in [0.0, 0.1, 0.5, 0.9, 1.0] {
                    for q in beside(at(part), normal) {
                        assert!(ball.may_contain(single(q)), "{i}: {part} of {angle}");
                    }
                }
                let far = [at(-1.0), sphere::walk_along(first, normal, angle)];
                let is_clear = (1e-4..2.0).contains(&angle);
                let others = far.into_iter().filter(|&q| ball.may_contain(single(q)));
                assert!(!is_clear || others.count() == 0, "{i}: {angle}");
            }
            let nowhere = Ball::around([first, Vec3::splat(f64::NAN)]);
            assert!(nowhere.may_contain(single(first)));
        }
    }
}
