//! Rows of texels, as Mitsuba 3.9 covers a surface with them: texel `i` of `n`
//! has its centre at `(i + 0.5) / n`.

use capwalk_math::elementary::floor;
use capwalk_math::{Affine, Real, Rgb};
use serde::{Deserialize, Serialize};

/// A rectangle of texels.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bitmap {
    /// Texels per row.
    pub width: u32,
    /// Rows; the first is at `v = 0`.
    pub height: u32,
    /// What is between the centres of texels.
    pub filter: TexelFilter,
    /// What is outside the unit square.
    pub wrap: Wrap,
    /// Acts on texture coordinates first.
    pub to_uv: UvTransform,
}

/// What is between the centres of texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum TexelFilter {
    /// The texel that is nearest.
    Nearest,
    /// A mean of the four around.
    Bilinear,
}

/// What is outside the unit square.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Wrap {
    /// The bitmap again.
    Repeat,
    /// The bitmap again, every other one reflected.
    Mirror,
    /// The texels at the border.
    Clamp,
}

/// An affine map of texture coordinates: `(a·u + b·v + c, d·u + e·v + f)`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct UvTransform {
    /// `[a, b, c]` and `[d, e, f]`.
    pub rows: [[f64; 3]; 2],
}

impl UvTransform {
    /// Leaves texture coordinates as they are.
    pub const IDENTITY: Self = Self {
        rows: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    };

    /// What a transform of space does in the plane `z = 0`.
    pub fn from_affine(affine: &Affine) -> Self {
        let row = |i: usize| {
            let [a, b, _] = affine.rows[i].to_array();
            [a, b, affine.translation[i]]
        };
        Self {
            rows: [row(0), row(1)],
        }
    }

    /// The image of texture coordinates.
    #[inline]
    pub fn apply<R: Real>(&self, [u, v]: [R; 2]) -> [R; 2] {
        self.rows
            .map(|[a, b, c]| u * R::constant(a) + v * R::constant(b) + R::constant(c))
    }
}

impl Wrap {
    /// The texel that stands for texel `i` of `n`.
    #[inline]
    fn apply(self, i: i64, n: u32) -> usize {
        let n = i64::from(n);
        if (0..n).contains(&i) {
            return i as usize;
        }
        let inside = match self {
            Self::Repeat => i.rem_euclid(n),
            Self::Clamp => i.clamp(0, n - 1),
            Self::Mirror => match i.rem_euclid(2 * n) {
                i if i < n => i,
                i => 2 * n - 1 - i,
            },
        };
        inside as usize
    }
}

impl Bitmap {
    /// How the value changes with both texture coordinates. `texel` is asked for
    /// texels counted row by row.
    ///
    /// The value counts as a quadratic B-spline of the texels: derivatives of
    /// [`TexelFilter::Bilinear`] are discontinuous at their centres. Halfway between two centres
    /// of a row both have the same derivative along it.
    pub fn gradient<R: Real>(
        &self,
        uv: [R; 2],
        mut texel: impl FnMut(usize) -> Rgb<R>,
    ) -> [Rgb<R>; 2] {
        let [u, v] = self.to_uv.apply(uv);
        let sizes = [self.width, self.height];
        let [x, y] = [(u, self.width), (v, self.height)].map(|(x, n)| spline(x, n));
        let [mut along_x, mut along_y] = [Rgb::zero(); 2];
        for (row, (weight_y, derivative_y)) in (y.first..).zip(y.weights) {
            let row = self.wrap.apply(row, self.height) * self.width as usize;
            for (column, (weight_x, derivative_x)) in (x.first..).zip(x.weights) {
                let value = texel(row + self.wrap.apply(column, self.width));
                along_x += value * (derivative_x * weight_y);
                along_y += value * (weight_x * derivative_y);
            }
        }
        let [width, height] = sizes.map(|n| R::constant(f64::from(n)));
        let (along_x, along_y) = (along_x * width, along_y * height);
        // The transpose of the transform of texture coordinates.
        let [[a, b, _], [c, d, _]] = self.to_uv.rows.map(|row| row.map(R::constant));
        [along_x * a + along_y * c, along_x * b + along_y * d]
    }

    /// The value at texture coordinates `uv`. `texel` is asked for texels
    /// counted row by row.
    pub fn lookup<R: Real>(&self, uv: [R; 2], mut texel: impl FnMut(usize) -> Rgb<R>) -> Rgb<R> {
        match self.corners(uv) {
            Corners::One(index) => texel(index),
            Corners::Four {
                rows: [[a, b], [c, d]],
                along,
            } => between([a, b, c, d].map(texel), along),
        }
    }

    /// The texels that [`Self::lookup`] adds up, with their weights.
    pub fn weights(&self, uv: [f64; 2]) -> [(usize, f64); 4] {
        match self.corners(uv) {
            Corners::One(index) => [(index, 1.0), (index, 0.0), (index, 0.0), (index, 0.0)],
            Corners::Four {
                rows: [[a, b], [c, d]],
                along,
            } => bilinear([a, b, c, d], along),
        }
    }

    /// The texels that are seen at texture coordinates.
    #[inline]
    fn corners<R: Real>(&self, uv: [R; 2]) -> Corners<R> {
        let [u, v] = self.to_uv.apply(uv);
        let column = |x: i64| self.wrap.apply(x, self.width);
        let start_of_row = |y: i64| self.wrap.apply(y, self.height) * self.width as usize;
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        match self.filter {
            TexelFilter::Nearest => {
                let below = |x: R, n: f64| floor(x.value() * n) as i64;
                Corners::One(start_of_row(below(v, height)) + column(below(u, width)))
            }
            TexelFilter::Bilinear => {
                // The texel whose centre is at or below, and the way from it.
                let split = |x: R, n: f64| {
                    let x = x * R::constant(n) - R::constant(0.5);
                    let below = floor(x.value());
                    (below as i64, x - R::constant(below))
                };
                let ((x, s), (y, t)) = (split(u, width), split(v, height));
                let columns = [x, x.saturating_add(1)].map(column);
                let rows = [y, y.saturating_add(1)].map(|y| {
                    let row = start_of_row(y);
                    columns.map(|column| row + column)
                });
                Corners::Four {
                    rows,
                    along: [s, t],
                }
            }
        }
    }
}

/// The bilinear mean of four texels, row by row, so far along from the first of them.
#[inline(always)]
pub fn between<R: Real>([a, b, c, d]: [Rgb<R>; 4], [s, t]: [R; 2]) -> Rgb<R> {
    let (first, second) = (a + (b - a) * s, c + (d - c) * s);
    first + (second - first) * t
}

/// The weights of four texels, row by row, at fractions of the way from the first of them.
pub fn bilinear([a, b, c, d]: [usize; 4], [s, t]: [f64; 2]) -> [(usize, f64); 4] {
    [
        (a, (1.0 - s) * (1.0 - t)),
        (b, s * (1.0 - t)),
        (c, (1.0 - s) * t),
        (d, s * t),
    ]
}

/// Texels of a bitmap that are seen at a point.
enum Corners<R> {
    /// Only one.
    One(usize),
    /// Those around it, and the fractions of the way from the first of them.
    Four {
        rows: [[usize; 2]; 2],
        along: [R; 2],
    },
}

/// Three texels of a row or column, and what they weigh in a quadratic B-spline.
struct Spline<R> {
    /// The first of them.
    first: i64,
    /// The weight of each and its derivative with respect to the place, in texels.
    weights: [(R, R); 3],
}

/// The spline at the place `x` of the unit interval, which has `n` texels.
fn spline<R: Real>(x: R, n: u32) -> Spline<R> {
    let constant = R::constant;
    // The texel whose centre is nearest, and the way from there.
    let x = x * constant(f64::from(n)) - constant(0.5);
    let nearest = (x.value() + 0.5).floor();
    let t = x - constant(nearest);
    let (before, behind) = (constant(0.5) - t, constant(0.5) + t);
    Spline {
        first: (nearest as i64).saturating_sub(1),
        weights: [
            (constant(0.5) * before.squared(), -before),
            (constant(0.75) - t.squared(), constant(-2.0) * t),
            (constant(0.5) * behind.squared(), behind),
        ],
    }
}
