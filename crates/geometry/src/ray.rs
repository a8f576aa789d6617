//! Rays and what they hit.

use capwalk_math::Vec3;

/// A ray and the part of it that counts.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// World units.
    pub origin: Vec3,
    /// Direction of any length; distances along the ray are multiples of this length.
    pub direction: Vec3,
    /// Intersections at smaller distances do not count, those at it do.
    pub t_min: f64,
    /// Intersections at larger distances do not count, those at it do.
    pub t_max: f64,
}

impl Ray {
    /// The whole ray, from its origin to infinity.
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self {
            origin,
            direction,
            t_min: 0.0,
            t_max: f64::INFINITY,
        }
    }

    /// The point at distance `t`.
    #[inline]
    pub fn at(&self, t: f64) -> Vec3 {
        self.origin + self.direction * t
    }
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index into [`Mesh::faces`](crate::Mesh::faces).
    pub face: u32,
    /// Distance, in multiples of the length of the ray's direction.
    pub t: f64,
    /// Weights of the face's second and third corner; the first has the rest.
    pub barycentric: [f64; 2],
}

/// The linear map that takes a ray to the positive or negative z axis: the
/// axes are permuted so that the direction's largest component comes last, and
/// the other two are sheared to zero (Woop, Benthin and Wald 2013).
#[derive(Clone, Copy, Debug)]
pub struct RayShear {
    /// Which components of the direction become x, y and z.
    pub axes: [usize; 3],
    /// How much of z is taken off x and y.
    pub shear: [f64; 2],
    /// From z to distance along the ray: one over the largest component.
    pub inverse_z: f64,
}

impl RayShear {
    /// The map of a ray; `None` if its direction is not finite, or zero, or so
    /// short that its inverse overflows.
    #[inline]
    pub fn new(direction: Vec3) -> Option<Self> {
        let size = direction.map(f64::abs);
        let z = match (size.x >= size.y, size.x >= size.z, size.y >= size.z) {
            (true, true, _) => 0,
            (_, _, true) => 1,
            _ => 2,
        };
        let axes = [(z + 1) % 3, (z + 2) % 3, z];
        let inverse_z = direction[z].recip();
        let shear = [direction[axes[0]], direction[axes[1]]].map(|d| d / direction[z]);
        let is_usable = inverse_z.is_finite() && direction.is_finite();
        is_usable.then_some(Self {
            axes,
            shear,
            inverse_z,
        })
    }
}

/// A triangle whose projected area is below this fraction of the products it
/// is summed from is seen edge-on: the area is nothing but their rounding,
/// some four errors of 2⁻⁵³ each.
pub const EDGE_ON: f64 = 1.0 / (1_u64 << 50) as f64;

/// What single precision may add up to between a plane of a box and the
/// distance at which the ray crosses it, as a displacement of the plane in
/// local units. All coordinates are below 1 or so, and there are eight
/// roundings of at most 2⁻²⁴: of the start, its product with the inverse
/// direction, the inverse (twice its share, for distances up to 2), the
/// product, and the sums.
pub const PLANE_MARGIN: f64 = 1.0 / (1 << 20) as f64;

/// This displacement for double precision, per local unit between the tree and the
/// ray's origin.
pub const ORIGIN_MARGIN: f64 = 1.0 / (1_u64 << 46) as f64;

/// Slower components of the direction (relative to the fastest) are rounded
/// to this, which moves no point of the ray within the tree by more than twice
/// as much. Keeps their inverses finite.
pub const SLOWEST: f64 = 1.0 / (1_u64 << 60) as f64;

/// Where the ray meets the triangle, without its face; `None` if it misses, is
/// parallel, or the triangle has no area. Two-sided, borders included.
///
/// Watertight (Woop, Benthin and Wald 2013): a ray through an edge or vertex
/// of a closed mesh hits one of the triangles there. An edge function
/// `x₁y₂ - x₂y₁` can round to zero but never to the wrong sign, is the same
/// for both triangles up to sign, and zero counts as inside, unless the whole
/// triangle is edge-on. The distance is a convex combination of the corners',
/// even for needles.
#[inline]
pub fn intersect_triangle(ray: &Ray, corners: [Vec3; 3]) -> Option<(f64, [f64; 2])> {
    let RayShear {
        axes,
        shear,
        inverse_z,
    } = RayShear::new(ray.direction)?;
    let [a, b, c] = corners.map(|corner| {
        let relative = corner - ray.origin;
        let z = relative[axes[2]];
        let x = relative[axes[0]] - shear[0] * z;
        let y = relative[axes[1]] - shear[1] * z;
        Vec3::new(x, y, z)
    });
    // Twice the signed areas opposite to each corner, seen along the ray.
    let u = c.x * b.y - c.y * b.x;
    let v = a.x * c.y - a.y * c.x;
    let w = b.x * a.y - b.y * a.x;
    let least = u.min(v).min(w);
    let largest = u.max(v).max(w);
    if least < 0.0 && largest > 0.0 {
        return None;
    }
    let determinant = u + v + w;
    if least <= 0.0 && largest >= 0.0 {
        // On the lines of all three edges at once, as far as rounding can tell?
        let products = (c.x * b.y).abs()
            + (c.y * b.x).abs()
            + (a.x * c.y).abs()
            + (a.y * c.x).abs()
            + (b.x * a.y).abs()
            + (b.y * a.x).abs();
        if determinant.abs() <= EDGE_ON * products {
            return None;
        }
    }
    // Not a number if the determinant is zero or the ray not finite: a miss.
    let t = (u * a.z + v * b.z + w * c.z) / determinant * inverse_z;
    (t >= ray.t_min && t <= ray.t_max).then_some((t, [v / determinant, w / determinant]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners() -> [Vec3; 3] {
        [[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.0, 1.0, 2.0]].map(Vec3::from)
    }

    fn ray(x: f64, y: f64) -> Ray {
        Ray::new(Vec3::new(x, y, 0.0), Vec3::new(0.0, 0.0, 0.5))
    }

    /// Inside, on the border, outside; the bounds of `t` are inclusive.
    #[test]
    fn inside_border_and_bounds() {
        let hit = |ray: &Ray| intersect_triangle(ray, corners());
        assert_eq!(hit(&ray(0.25, 0.5)), Some((4.0, [0.25, 0.5])));
        assert_eq!(hit(&ray(0.0, 0.0)), Some((4.0, [0.0, 0.0])));
        assert_eq!(hit(&ray(0.5, 0.5)), Some((4.0, [0.5, 0.5])));
        assert_eq!(hit(&ray(0.6, 0.5)), None);
        for (t_min, t_max, is_hit) in [(4.0, 4.0, true), (4.1, 9.0, false), (0.0, 3.9, false)] {
            let bounded = Ray {
                t_min,
                t_max,
                ..ray(0.25, 0.5)
            };
            assert_eq!(hit(&bounded).is_some(), is_hit, "{t_min} {t_max}");
        }
    }

    /// In the plane, without direction, not finite, without area: misses.
    #[test]
    fn degenerate_cases_miss() {
        let along = Vec3::new(1.0, 0.3, 0.0);
        let in_plane = Ray::new(Vec3::new(-1.0, 0.0, 2.0), along);
        assert_eq!(intersect_triangle(&in_plane, corners()), None);
        for direction in [0.0, f64::NAN, f64::INFINITY, 1e-320] {
            let bad = Ray::new(Vec3::zero(), Vec3::new(0.0, 0.0, direction));
            assert_eq!(intersect_triangle(&bad, corners()), None, "{direction}");
        }
        let [a, b, _] = corners();
        for flat in [[a, a, a], [a, b, b], [a, b, (a + b) * 0.5]] {
            assert_eq!(intersect_triangle(&ray(0.25, 0.0), flat), None);
        }
    }
}
