//! Triangles on the unit sphere: their solid angle, and uniform directions in them.

use crate::vec3::Vec3;

/// A triangle whose plane is closer to the viewpoint than this fraction of its distance
/// cannot be told from one that is seen from within its plane: more than rounding.
const IN_ITS_PLANE: f64 = 1e-12;

/// Solid angle of a triangle whose corners lie at these offsets from the viewpoint, which
/// need not be of unit length; 0 if they are not counterclockwise as seen from there, or if
/// the viewpoint is in their plane (Van Oosterom and Strackee 1983). Steradians.
#[inline]
pub fn solid_angle([a, b, c]: [Vec3; 3]) -> f64 {
    let [la, lb, lc] = [a, b, c].map(Vec3::length);
    // The triple product of the corners, by their differences: small triangles keep their digits.
    let cross = (b - a).cross(c - a);
    let volume = -a.dot(cross);
    // False for NaN.
    if volume > IN_ITS_PLANE * la.max(lb).max(lc) * cross.length() {
        let denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        2.0 * volume.atan2(denominator)
    } else {
        0.0
    }
}

/// Maps the unit square uniformly onto the triangle on the sphere whose corners lie in these
/// directions and whose area is known, as [`solid_angle`] gives it (Arvo 1995). Loses digits
/// for triangles of less than 1e-8 steradians.
pub fn sample(corners: [Vec3; 3], area: f64, u: [f64; 2]) -> Vec3 {
    let [a, b, c] = corners.map(Vec3::normalized);
    // The angle α at a, between the planes of its sides.
    let [ab, ca] = [a.cross(b), c.cross(a)].map(Vec3::normalized);
    let (sin_alpha, cos_alpha) = (ab.cross(ca).length(), -ab.dot(ca));
    // The subtriangle a, b, c' of area u[0] times that: find c' on the side from a to c.
    // Arvo's s = sin(area' - α) and t = cos(area' - α), with cos c = a·b.
    let (sin, cos) = (u[0] * area).sin_cos();
    let sin_phi = sin * cos_alpha - cos * sin_alpha;
    let cos_phi = cos * cos_alpha + sin * sin_alpha;
    let k1 = cos_phi - cos_alpha;
    let k2 = sin_phi + sin_alpha * a.dot(b);
    let cos_side = ((k2 * cos_phi - k1 * sin_phi) * cos_alpha - k2)
        / ((k2 * sin_phi + k1 * cos_phi) * sin_alpha);
    let c_prime = along(a, c, cos_side);
    // A direction between b and c', so that area is uniform.
    along(b, c_prime, 1.0 - u[1] * (1.0 - c_prime.dot(b)))
}

/// The direction whose angle to the unit vector `from` has this cosine, on the way to `to`.
fn along(from: Vec3, to: Vec3, cos: f64) -> Vec3 {
    let cos = cos.clamp(-1.0, 1.0);
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    from * cos + to.reject_from(from).normalized() * sin
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// Clockwise and counterclockwise around the view, narrow, wide, and small.
    const TRIANGLES: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
        [[1.0, 0.2, -0.3], [0.9, -0.8, 0.4], [0.3, 0.9, 0.5]],
        [[3.0, 0.1, -1.3], [3.0, -0.1, 1.2], [3.1, 0.1, 1.3]],
        [[5.0, 0.0, 0.0], [5.0, 0.004, 0.05], [5.0, 0.05, 0.02]],
    ];

    fn offsets(corners: [[f64; 3]; 3]) -> [Vec3; 3] {
        let corners = corners.map(Vec3::from);
        match solid_angle(corners) {
            0.0 => [corners[0], corners[2], corners[1]],
            _ => corners,
        }
    }

    /// An octant, and a triangle whose solid angle a grid of its points adds up.
    #[test]
    fn solid_angles() {
        let octant = offsets(TRIANGLES[0]);
        assert!((solid_angle(octant) - PI / 2.0).abs() < 1e-14);
        assert_eq!(solid_angle([octant[0], octant[2], octant[1]]), 0.0);
        // From a point of the triangle, up to rounding.
        let around = [[1.1, 0.3, 0.7], [-0.9, 1.3, 0.2], [-0.2, -1.6, -0.9]].map(Vec3::from);
        let inside = around[0] * 0.3 + around[1] * 0.3 + around[2] * 0.4;
        for height in [-1e-15, 0.0, 1e-15] {
            let viewpoint = inside + Vec3::new(height, -height, height);
            assert_eq!(solid_angle(around.map(|p| p - viewpoint)), 0.0);
            let [a, b, c] = around.map(|p| p - viewpoint);
            assert_eq!(solid_angle([a, c, b]), 0.0);
        }
        let [a, b, c] = offsets(TRIANGLES[1]);
        let cross = (b - a).cross(c - a);
        let (mut sum, n) = (0.0, 1000);
        for i in 0..n {
            for k in 0..n {
                let [x, y] = [i, k].map(|i| (f64::from(i) + 0.5) / f64::from(n));
                let p = a + (b - a) * (x * (1.0 - y)) + (c - a) * (x * y);
                let density = x * cross.dot(p).abs() / p.length().powi(3);
                sum += density / f64::from(n * n);
            }
        }
        assert!((solid_angle([a, b, c]) / sum - 1.0).abs() < 1e-5);
    }

    /// A sampling map is right if and only if its area element is the same everywhere.
    #[test]
    fn area_element_of_sample_is_the_solid_angle() {
        for corners in TRIANGLES.map(offsets) {
            for u in [[0.3, 0.7], [0.05, 0.2], [0.97, 0.9], [0.5, 0.5]] {
                let h = 1e-4;
                let area = solid_angle(corners);
                let at = |du: f64, dv: f64| sample(corners, area, [u[0] + du, u[1] + dv]);
                let [du, dv] = [at(h, 0.0) - at(-h, 0.0), at(0.0, h) - at(0.0, -h)];
                let element = du.cross(dv).length() / (4.0 * h * h);
                let error = (element / area - 1.0).abs();
                assert!(error < 1e-5, "{corners:?}, {u:?}: {error:e}");
                // It is inside, too.
                let q = at(0.0, 0.0);
                let [a, b, c] = corners;
                for (from, to) in [(a, b), (b, c), (c, a)] {
                    assert!(to.cross(from).dot(q) > 0.0, "{corners:?}, {u:?}");
                }
            }
        }
    }
}
