//! Rays and what they hit.

use capwalk_math::Vec3;

/// A ray and the part of it that counts.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes; distances are in multiples of its length.
    pub direction: Vec3,
    /// Nearer intersections do not count.
    pub t_min: f64,
    /// Farther intersections do not count.
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
    /// The face.
    pub face: u32,
    /// The distance, in multiples of the ray direction's length.
    pub t: f64,
    /// Weights of the face's second and third corner; the first has the rest.
    pub barycentric: [f64; 2],
}

/// Where the ray meets the triangle, without its face; `None` if it misses, is
/// parallel, or the triangle has no area. Möller and Trumbore 1997, two-sided.
#[inline]
pub fn intersect_triangle(ray: &Ray, [a, b, c]: [Vec3; 3]) -> Option<(f64, [f64; 2])> {
    let (edge1, edge2) = (b - a, c - a);
    let p = ray.direction.cross(edge2);
    let determinant = edge1.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let inverse = determinant.recip();
    let s = ray.origin - a;
    let u = s.dot(p) * inverse;
    let q = s.cross(edge1);
    let v = ray.direction.dot(q) * inverse;
    let t = edge2.dot(q) * inverse;
    // Written so that NaN misses.
    let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    (inside && t >= ray.t_min && t <= ray.t_max).then_some((t, [u, v]))
}
