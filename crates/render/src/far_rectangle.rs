//! A rectangle from far away: points on it are drawn by a density that follows, to first order, what a surface
//! receives from them. It is a product of linear functions of the places along both sides, so that a point takes two
//! square roots, a third of the time of one that is uniform by solid angle ([`SphericalRectangle`]), and what
//! it weighs differs less from point to point, since the cosine at the surface is in it. (The rest is of second order:
//! a standard deviation of less than a tenth where a square that is just far enough faces the surface, and more where
//! it is seen edge-on.)
//!
//! [`SphericalRectangle`]: capwalk_math::spherical_rectangle::SphericalRectangle

use capwalk_math::spherical_rectangle::IN_ITS_PLANE;

/// From how far away this is enough: the squared distance of the middle over that of a corner from the middle.
pub const FAR: f64 = 5.0;
/// The largest slope, from the middle to a side as a part of the middle's density.
pub const MOST_TILT: f64 = 0.9;
/// The least cosine at the surface, squared, that is followed: below it changes much from point to point.
pub const LEAST_COSINE2: f64 = 0.01;

/// A rectangle that is seen from far away.
#[derive(Clone, Copy, Debug)]
pub struct FarRectangle {
    /// The middle along both sides, from the viewpoint's foot in the rectangle's plane.
    middle: [f64; 2],
    /// Half of the lengths of the sides.
    half: [f64; 2],
    /// The distance of the viewpoint from the plane; at most 0 behind it, and 0 within.
    pub rise: f64,
    /// By how much the density rises from the middle to the ends of the sides.
    slopes: [f64; 2],
}

impl FarRectangle {
    /// The rectangle, and whether it is far enough away for this: with this middle and these halves of its sides, at
    /// a distance from its plane, for a surface whose unit normal has these coordinates along the sides and towards
    /// the plane.
    #[inline(always)]
    pub fn seen(middle: [f64; 2], half: [f64; 2], rise: f64, normal: [f64; 3]) -> (Self, bool) {
        let [x, y] = middle;
        let [nx, ny, nz] = normal;
        let squared = x * x + y * y + rise * rise;
        // A surface at the origin receives (n·o) rise / |o|⁴ from the area at o: the slope of the logarithm of that
        // is n / (n·o) - 4 o / |o|². Where the middle is behind the surface, or nearly, the solid angle alone is
        // followed, which is rise / |o|³ of the area: then the slope is -3 o / |o|².
        let cos = nx * x + ny * y + nz * rise;
        let has_cosine = cos > 0.0 && cos * cos > LEAST_COSINE2 * squared;
        let (below, falls) = match has_cosine {
            true => (squared * cos, -4.0 * cos),
            false => (squared, -3.0),
        };
        let inverse = 1.0 / below;
        let slope = |normal: f64, middle: f64, half: f64| {
            let rises = if has_cosine { squared * normal } else { 0.0 };
            let slope = half * (falls * middle + rises) * inverse;
            let slope = if slope > MOST_TILT { MOST_TILT } else { slope };
            if slope < -MOST_TILT {
                -MOST_TILT
            } else {
                slope
            }
        };
        let is_in_plane = rise * rise <= IN_ITS_PLANE * IN_ITS_PLANE * squared;
        let seen = Self {
            middle,
            half,
            rise: if is_in_plane { 0.0 } else { rise },
            slopes: [slope(nx, x, half[0]), slope(ny, y, half[1])],
        };
        (
            seen,
            squared > FAR * (half[0] * half[0] + half[1] * half[1]),
        )
    }

    /// Draws a point: where it is along both sides, from -1 to 1. The density along a side is `(1 + a s) / 2`, whose
    /// integral to `s` is a uniform number.
    #[inline(always)]
    pub fn sample(&self, u: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.slopes;
        let root = |slope: f64, u: f64| {
            let least = 1.0 - slope;
            1.0 + (least * least + 4.0 * slope * u).sqrt()
        };
        // Both quotients from one division.
        let [first, second] = [root(a, u[0]), root(b, u[1])];
        let inverse = 1.0 / (first * second);
        [
            (4.0 * u[0] - 2.0 + a) * (second * inverse),
            (4.0 * u[1] - 2.0 + b) * (first * inverse),
        ]
    }

    /// Where such a point is along the sides, from the viewpoint's foot.
    #[inline(always)]
    pub fn place(&self, [s, t]: [f64; 2]) -> [f64; 2] {
        let Self { middle, half, .. } = self;
        [middle[0] + half[0] * s, middle[1] + half[1] * t]
    }

    /// The point at a place from the viewpoint's foot.
    #[inline]
    pub fn point_at(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| (place[i] - self.middle[i]) / self.half[i])
    }

    /// The inverse of the density per solid angle of the direction to a point, at a distance.
    #[inline(always)]
    pub fn inverse_density(&self, [s, t]: [f64; 2], distance: f64) -> f64 {
        let [a, b] = self.slopes;
        let area = 4.0 * self.half[0] * self.half[1];
        let rises = (1.0 + a * s) * (1.0 + b * t);
        area * self.rise / (rises * distance * distance * distance)
    }
}
