//! Rectangles on the unit sphere: their solid angle, and uniform directions in them.
//!
//! In coordinates whose first two axes are along the sides, with the viewpoint as origin, the
//! rectangle is `[x0, x1] × [y0, y1]` at the distance `z` along the third. Ureña, Fajardo and
//! King 2013, "An Area-Preserving Parametrization for Spherical Rectangles". They add angles;
//! here numbers of the complex plane with these arguments are multiplied, so that all of it
//! takes one arc tangent, and one sine and cosine.

use std::f64::consts::TAU;

use crate::elementary::{angle_of, sin_cos};

/// A rectangle whose plane is closer to the viewpoint than this fraction of its distance
/// cannot be told from one that is seen from within its plane: more than rounding.
pub const IN_ITS_PLANE: f64 = 1e-12;

/// A rectangle as it is seen from a viewpoint.
#[derive(Clone, Copy, Debug)]
pub struct SphericalRectangle {
    /// Where it starts and ends, along one side.
    pub x: [f64; 2],
    /// Along the other one.
    pub y: [f64; 2],
    /// Distance of its plane.
    pub z: f64,
    /// Solid angle, steradians.
    pub solid_angle: f64,
    /// Ureña's `k`, as cosine and sine: where the angles `k + u · solid_angle` start.
    start: [f64; 2],
    /// One over the distances of the viewpoint from the lines `y = y0` and `y = y1` of its plane.
    inverse_to_line: [f64; 2],
}

/// The product of two complex numbers.
#[inline(always)]
fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

impl SphericalRectangle {
    /// The rectangle between these bounds in the plane at distance `z`; `None` if that is not
    /// positive, or so small that the viewpoint is in the plane.
    #[inline]
    pub fn new(x: [f64; 2], y: [f64; 2], z: f64) -> Option<Self> {
        let (seen, is_in_front) = Self::seen(x, y, z);
        is_in_front.then_some(seen)
    }

    /// [`Self::new`] without a branch, and whether there is one; if not, its solid angle is zero.
    #[inline(always)]
    pub fn seen(x: [f64; 2], y: [f64; 2], z: f64) -> (Self, bool) {
        let ([x0, x1], [y0, y1], z2) = (x, y, z * z);
        let [xx0, xx1, yy0, yy1] = [x0 * x0, x1 * x1, y0 * y0, y1 * y1];
        // Distances of the corners.
        let corner = |xx: f64, yy: f64| (xx + yy + z2).sqrt();
        let [r00, r01] = [corner(xx0, yy0), corner(xx0, yy1)];
        let [r10, r11] = [corner(xx1, yy0), corner(xx1, yy1)];
        // False for NaN.
        let is_in_front = z > IN_ITS_PLANE * r00.max(r01).max(r10).max(r11);
        // The angles of the rectangle on the sphere, at the ends of `y = y0` and `y = y1`:
        // where planes meet whose normals are (0, z, -y) and (-z, 0, x).
        let at_first = times([x0 * y1, z * r01], [-x0 * y0, z * r00]);
        let at_last = times([x1 * y0, z * r10], [-x1 * y1, z * r11]);
        // The solid angle is their sum, less a whole turn. More than a half turn it is only near
        // by and in front of the rectangle; elsewhere rounding made it negative.
        let [cos, sin] = times(at_first, at_last);
        let angle = angle_of([cos, sin]);
        let is_near = x0 < 0.0 && x1 > 0.0 && y0 < 0.0 && y1 > 0.0 && z2 < (x1 - x0) * (y1 - y0);
        let if_negative = if is_near { angle + TAU } else { 0.0 };
        let solid_angle = if angle < 0.0 { if_negative } else { angle };
        // The length of `at_first` is `x0² + z²` times the distances of both lines: all quotients come
        // from one division.
        let to_line = [(yy0 + z2).sqrt(), (yy1 + z2).sqrt()];
        let between = xx0 + z2;
        let inverse = 1.0 / (between * to_line[0] * to_line[1]);
        let seen = Self {
            x,
            y,
            z,
            solid_angle: if is_in_front { solid_angle } else { 0.0 },
            start: [at_first[0] * inverse, -at_first[1] * inverse],
            inverse_to_line: [
                between * to_line[1] * inverse,
                between * to_line[0] * inverse,
            ],
        };
        (seen, is_in_front)
    }

    /// Maps the unit square uniformly onto the rectangle on the sphere: where on the sides the
    /// direction meets the plane.
    #[inline(always)]
    pub fn sample(&self, u: [f64; 2]) -> [f64; 2] {
        let Self { z, .. } = *self;
        let ([x0, x1], [y0, y1]) = (self.x, self.y);
        // The part of the area with smaller x: Ureña's fu = n / d, and with it
        // x = z / √(fu² + b0² - 1), of the sign of fu.
        let (sin, cos) = sin_cos(u[0] * self.solid_angle);
        let [cos, sin] = times(self.start, [cos, sin]);
        let [first, last] = self.inverse_to_line;
        let b0 = -y0 * first;
        let n = cos * b0 - y1 * last;
        let flat = sin * (z * first);
        let x = z * sin.abs().copysign(n * sin) / (n * n - flat * flat).max(0.0).sqrt();
        // At an end that is seen at a grazing angle rounding may leave nothing of `n`; the bounds
        // are where it belongs then.
        let x = x.max(x0).min(x1);
        // Along the line of this x, the sine of the angle from its foot is uniform.
        let squared = x * x + z * z;
        let [first, last] = [y0, y1].map(|y| (squared + y * y).sqrt());
        let inverse = 1.0 / (first * last);
        let [h0, h1] = [y0 * (last * inverse), y1 * (first * inverse)];
        let h = h0 + u[1] * (h1 - h0);
        // Rounding may leave a sine above one where the line is all but in the rectangle's plane.
        let y = h * (squared / ((1.0 - h) * (1.0 + h)).max(0.0)).sqrt();
        [x, y.max(y0).min(y1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spherical_triangle;
    use crate::vec3::Vec3;

    /// Around the foot of the viewpoint, beside it, wide, narrow, seen at a grazing angle, and
    /// small: its bounds and its distance.
    const RECTANGLES: [([f64; 2], [f64; 2], f64); 7] = [
        ([-1.0, 1.0], [-1.0, 1.0], 1.0),
        ([-0.3, 0.9], [0.4, 1.7], 0.8),
        ([-2.9, -0.4], [-1.7, -1.1], 0.5),
        ([-40.0, 30.0], [-20.0, 50.0], 0.3),
        ([-3.0, 4.0], [0.5, 0.51], 1.2),
        ([-0.5, 0.5], [2.0, 3.0], 0.01),
        ([7.0, 7.01], [-3.0, -2.99], 5.0),
    ];

    /// Its solid angle is that of two triangles.
    #[test]
    fn solid_angle_is_that_of_two_triangles() {
        for (x, y, z) in RECTANGLES {
            let corner = |i: usize, k: usize| Vec3::new(x[i], y[k], z);
            let [a, b, c, d] = [corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)];
            let halves = [[a, b, c], [a, c, d]].map(spherical_triangle::solid_angle);
            let found = SphericalRectangle::new(x, y, z).expect("it is in front");
            let error = (found.solid_angle - halves[0] - halves[1]).abs();
            assert!(error < 1e-14, "{x:?}, {y:?}, {z}: {error:e}");
        }
        // Far away, and nearly in the plane of what is beside.
        for (x, z) in [([-1.0, 1.0], 1e9), ([-1.0, 1.0], 1e12), ([1.0, 2.0], 1e-11)] {
            let found = SphericalRectangle::new(x, [-1.0, 1.0], z).expect("it is in front");
            assert!(
                found.solid_angle < 1e-10,
                "{x:?}, {z}: {}",
                found.solid_angle
            );
        }
        for z in [0.0, -0.0, 1e-14, -1.0, f64::NAN] {
            assert!(SphericalRectangle::new([-1.0, 2.0], [0.5, 1.0], z).is_none());
        }
    }

    /// A sampling map is right if and only if its area element is the same everywhere.
    #[test]
    fn area_element_of_sample_is_the_solid_angle() {
        for (x, y, z) in RECTANGLES {
            let rectangle = SphericalRectangle::new(x, y, z).expect("it is in front");
            for u in [[0.3, 0.7], [0.05, 0.2], [0.97, 0.9], [0.5, 0.5]] {
                let h = 1e-4;
                let at = |du: f64, dv: f64| {
                    let [x, y] = rectangle.sample([u[0] + du, u[1] + dv]);
                    Vec3::new(x, y, z).normalized()
                };
                let [du, dv] = [at(h, 0.0) - at(-h, 0.0), at(0.0, h) - at(0.0, -h)];
                let element = du.cross(dv).length() / (4.0 * h * h);
                let error = (element / rectangle.solid_angle - 1.0).abs();
                assert!(error < 1e-4, "{x:?}, {y:?}, {z}, {u:?}: {error:e}");
            }
        }
    }

    /// The corners of the square are those of the rectangle, and nothing is outside.
    #[test]
    fn corners_are_kept() {
        for (x, y, z) in RECTANGLES {
            let rectangle = SphericalRectangle::new(x, y, z).expect("it is in front");
            for (i, k) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let found = rectangle.sample([i as f64, k as f64]);
                let error = (found[0] - x[i]).abs() + (found[1] - y[k]).abs();
                let size = x[1] - x[0] + y[1] - y[0];
                assert!(error < 1e-5 * size, "{x:?}, {y:?}, {z}: {error:e}");
                assert!(found[0] >= x[0] && found[0] <= x[1]);
                assert!(found[1] >= y[0] && found[1] <= y[1]);
            }
        }
    }
}
