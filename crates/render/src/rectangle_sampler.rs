//! Sampling of directions towards a rectangle in one piece: from near by uniformly by solid angle, which takes less
//! than half of the time of choosing between its two triangles, and from far away by [`FarRectangle`].

use capwalk_geometry::Mesh;
use capwalk_math::Vec3;
use capwalk_math::spherical_rectangle::SphericalRectangle;

use crate::far_rectangle::FarRectangle;

/// By how much corners may be off a rectangle, as a fraction of its shorter side, and of their
/// coordinates: more than the rounding of where a square is placed, and too little to be noticed.
const OFF_BY: [f64; 2] = [1e-12, 16.0 * f64::EPSILON];

/// A rectangle.
#[derive(Clone, Copy, Debug)]
pub struct Rectangle {
    /// A corner.
    pub corner: Vec3,
    /// Unit vectors along the sides from there.
    pub sides: [Vec3; 2],
    /// Unit normal of the front.
    pub normal: Vec3,
    /// Lengths of the sides.
    pub lengths: [f64; 2],
}

/// A rectangle that is made of two triangles.
#[derive(Clone, Debug)]
pub struct RectangleSampler {
    /// Where it is.
    pub rectangle: Rectangle,
    /// For each triangle, what gives the weights of its second and third corner at a point:
    /// one number, and two that are multiplied by the place along the sides.
    pub weights: [[[f64; 3]; 2]; 2],
}

/// A rectangle as it is sampled from a viewpoint that is in front of it.
#[derive(Clone, Copy, Debug)]
pub enum SeenRectangle {
    /// Uniformly by solid angle.
    Near(SphericalRectangle),
    /// In proportion to what is received, to first order.
    Far(FarRectangle),
}

/// A point sampled on a rectangle.
#[derive(Clone, Copy, Debug)]
pub struct RectanglePoint {
    /// From the viewpoint.
    pub offset: Vec3,
    /// The triangle, 0 or 1.
    pub face: u32,
    /// Weights of its second and third corner.
    pub barycentric: [f64; 2],
}

impl RectangleSampler {
    /// The sampler of a mesh, if that is a rectangle: two triangles with a common diagonal.
    pub fn new(mesh: &Mesh) -> Option<Self> {
        let &[_, _] = &mesh.faces[..] else {
            return None;
        };
        let faces = [0, 1].map(|face| mesh.corners(face));
        // The first triangle from its corner at the right angle, and the fourth corner.
        let squared = |i: usize| (faces[0][(i + 1) % 3] - faces[0][(i + 2) % 3]).length_squared();
        let right = (0..3).max_by(|&i, &k| squared(i).total_cmp(&squared(k)))?;
        let [corner, a, b] = [0, 1, 2].map(|i| faces[0][(right + i) % 3]);
        let [along_a, along_b] = [a - corner, b - corner];
        let lengths = [along_a.length(), along_b.length()];
        let sides = [along_a / lengths[0], along_b / lengths[1]];
        let normal = along_a.cross(along_b).normalized();
        // The second has the diagonal the other way round, from `b` to `a`.
        let start = faces[1].iter().position(|&p| p == b)?;
        let [_, next, fourth] = [0, 1, 2].map(|i| faces[1][(start + i) % 3]);
        let coordinates = faces[0].map(|p| p.map(f64::abs).max_component());
        let tolerance = OFF_BY[0] * lengths[0].min(lengths[1])
            + OFF_BY[1] * coordinates.into_iter().fold(0.0, f64::max);
        // How far corners are from where right angles would have them. False for NaN.
        let turned = sides[0].dot(sides[1]).abs() * lengths[0].max(lengths[1]);
        let open = (corner + along_a + along_b - fourth).length();
        let is_rectangle = next == a && turned <= tolerance && open <= tolerance;
        if !is_rectangle {
            return None;
        }
        let weights = faces.map(|[p, q, r]| {
            // The weight of a corner is 1 there and 0 at both others.
            let [p, q, r] = [p, q, r].map(|p| sides.map(|side| (p - corner).dot(side)));
            let weight = |own: [f64; 2], [[x, y], others]: [[f64; 2]; 2]| {
                let gradient = [others[1] - y, x - others[0]];
                let scale = 1.0 / (gradient[0] * (own[0] - x) + gradient[1] * (own[1] - y));
                let [a, b] = gradient.map(|gradient| gradient * scale);
                [-a * x - b * y, a, b]
            };
            [weight(q, [p, r]), weight(r, [p, q])]
        });
        let rectangle = Rectangle {
            corner,
            sides,
            normal,
            lengths,
        };
        Some(Self { rectangle, weights })
    }

    /// The rectangle as it is sampled for a surface, of which the position and the shading normal are given; `None` if
    /// that is not in front of it.
    #[inline]
    pub fn seen_from(&self, viewpoint: Vec3, n: Vec3) -> Option<SeenRectangle> {
        let (far, is_far) = self.rectangle.seen_from_afar(viewpoint, n);
        if is_far {
            return (far.rise > 0.0).then_some(SeenRectangle::Far(far));
        }
        let (seen, is_in_front) = self.rectangle.seen(viewpoint);
        is_in_front.then_some(SeenRectangle::Near(seen))
    }

    /// A point of it.
    #[inline]
    pub fn sample(&self, seen: &SeenRectangle, u: [f64; 2]) -> RectanglePoint {
        let (place, first, rise) = match seen {
            SeenRectangle::Near(seen) => (seen.sample(u), [seen.x[0], seen.y[0]], seen.z),
            SeenRectangle::Far(far) => {
                (far.place(far.sample(u)), far.place([-1.0, -1.0]), far.rise)
            }
        };
        let (face, barycentric) = self.place([place[0] - first[0], place[1] - first[1]]);
        RectanglePoint {
            offset: self.rectangle.offset_to(place, rise),
            face,
            barycentric,
        }
    }

    /// The density per solid angle of the direction to a point of it, whose offset from the viewpoint is given.
    #[inline]
    pub fn pdf(&self, seen: &SeenRectangle, offset: Vec3) -> f64 {
        match seen {
            SeenRectangle::Near(seen) => 1.0 / seen.solid_angle,
            SeenRectangle::Far(far) => {
                let place = self.rectangle.sides.map(|side| side.dot(offset));
                1.0 / far.inverse_density(far.point_at(place), offset.length())
            }
        }
    }

    /// The triangle, 0 or 1, and the weights of its second and third corner, at a point of the
    /// rectangle's plane in the world.
    pub fn place_of(&self, point: Vec3) -> (u32, [f64; 2]) {
        let Rectangle { corner, sides, .. } = self.rectangle;
        self.place(sides.map(|side| side.dot(point - corner)))
    }

    /// Those at distances along the sides.
    #[inline]
    fn place(&self, [s, t]: [f64; 2]) -> (u32, [f64; 2]) {
        // In one triangle all weights are at least 0, up to rounding.
        let weights = self
            .weights
            .map(|of_corners| of_corners.map(|[c, a, b]| c + a * s + b * t));
        let least = weights.map(|[wb, wc]| wb.min(wc).min(1.0 - wb - wc));
        let face = usize::from(least[1] > least[0]);
        let [wb, wc] = weights[face];
        // The second not by `clamp`, which panics where its bounds are not numbers.
        let wb = wb.clamp(0.0, 1.0);
        (face as u32, [wb, wc.max(0.0).min(1.0 - wb)])
    }
}

impl Rectangle {
    /// The rectangle as it is seen from a point, and whether that is in front of it; if not, its
    /// solid angle is zero.
    #[inline(always)]
    pub fn seen(&self, viewpoint: Vec3) -> (SphericalRectangle, bool) {
        let offset = self.corner - viewpoint;
        let [x, y] = self.sides.map(|side| side.dot(offset));
        let [width, height] = self.lengths;
        let bounds = [[x, x + width], [y, y + height]];
        SphericalRectangle::seen(bounds[0], bounds[1], -self.normal.dot(offset))
    }

    /// The rectangle as it is seen from far away for a surface, [`RectangleSampler::seen_from`], and whether that is
    /// far enough away.
    #[inline(always)]
    pub fn seen_from_afar(&self, viewpoint: Vec3, n: Vec3) -> (FarRectangle, bool) {
        let offset = self.corner - viewpoint;
        let [s, t] = self.sides;
        let half = [0.5 * self.lengths[0], 0.5 * self.lengths[1]];
        let middle = [s.dot(offset) + half[0], t.dot(offset) + half[1]];
        let normal = [s.dot(n), t.dot(n), -self.normal.dot(n)];
        FarRectangle::seen(middle, half, -self.normal.dot(offset), normal)
    }

    /// From a viewpoint to places along the sides from its foot, where the plane is at the distance `rise`.
    #[inline(always)]
    pub fn offset_to(&self, [x, y]: [f64; 2], rise: f64) -> Vec3 {
        self.sides[0] * x + self.sides[1] * y - self.normal * rise
    }
}

#[cfg(test)]
mod tests {
    use capwalk_math::Affine;
    use capwalk_scene::primitive::rectangle;

    use super::*;

    fn place() -> Affine {
        Affine::translate(Vec3::new(0.3, -0.2, 1.5))
            * Affine::rotate(Vec3::new(1.0, 0.4, -0.2), 2.6)
            * Affine::scale(Vec3::new(0.8, 0.5, 0.7))
    }

    /// Rectangles of any order of corners, also mirrored; nothing that is sheared, folded, open
    /// or bent the other way.
    #[test]
    fn only_rectangles_are_taken() {
        let (mesh, _) = rectangle(place());
        for (i, k) in [(0, 0), (1, 0), (2, 1), (0, 2)] {
            let mut turned = mesh.clone();
            turned.faces[0].rotate_left(i);
            turned.faces[1].rotate_left(k);
            assert!(RectangleSampler::new(&turned).is_some());
            turned.faces.iter_mut().for_each(|face| face.swap(1, 2));
            assert!(RectangleSampler::new(&turned).is_some());
            turned.faces[0].swap(1, 2);
            assert!(RectangleSampler::new(&turned).is_none());
        }
        let moved = |corner: usize, by: f64| {
            let mut mesh = mesh.clone();
            mesh.positions[corner] += Vec3::new(by, -by, by);
            RectangleSampler::new(&mesh).is_some()
        };
        for corner in 0..4 {
            assert!(moved(corner, 1e-15) && !moved(corner, 1e-9), "{corner}");
        }
        // Far from the origin corners are rounded more.
        for far in [1e3, 1e5, 1e7] {
            let place = Affine::translate(Vec3::splat(far)) * place();
            assert!(RectangleSampler::new(&rectangle(place).0).is_some());
        }
        let sheared = Affine::rotate(Vec3::new(0.0, 0.0, 1.0), 0.3);
        let sheared = Affine::scale(Vec3::new(2.0, 1.0, 1.0)) * sheared;
        assert!(RectangleSampler::new(&rectangle(sheared).0).is_none());
    }
}
