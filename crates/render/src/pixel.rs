//! Pixels as integrals over the film.
//!
//! A pixel is `∫ W(s) L(s) ds` over the support of its filter, a rectangle of
//! the film cut off at the border of the rendered part unless the film samples
//! beyond it, with `∫ W ds = 1` over what is left. Each pixel samples its own
//! support (filter importance sampling, Ernst et al. 2006): pixels are
//! independent of each other, so their errors are known, and the expectation
//! is that of splatting. Where a filter is negative, points are drawn by its magnitude
//! and weigh less than nothing.
//!
//! `W` is discontinuous where the rectangle ends and the filter is not zero: at all sides
//! of the box filter, and at cut-off sides of the others. The derivative has a boundary term
//! there, which [`crate::Tracer::pixel`] adds.

use std::sync::Arc;

use capwalk_math::Real;
use capwalk_scene::{Film, Filter};

use crate::filter_table::{BINS, FilterTable};

/// The support of a column or a row of pixels, and the filter along it.
#[derive(Clone, Debug)]
pub struct Side {
    /// Film coordinate of the pixels' centre.
    pub centre: f64,
    /// Where the support starts and ends.
    pub bounds: [f64; 2],
    /// True where the filter is not zero at that bound: it is discontinuous there.
    pub discontinuous: [bool; 2],
    /// What points are drawn by; the same for all that are cut off alike.
    pub table: Arc<FilterTable>,
}

/// The support of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Support<'a> {
    /// Along x and y.
    pub sides: [&'a Side; 2],
}

/// A film point that was drawn for a pixel.
#[derive(Clone, Copy, Debug)]
pub struct DrawnPoint {
    pub place: [f64; 2],
    /// The normalised filter there over the density of the point.
    pub weight: f64,
}

/// The supports of all pixels of a film.
#[derive(Clone, Debug)]
pub struct Supports {
    columns: Vec<Side>,
    rows: Vec<Side>,
}

impl Supports {
    /// The supports of a film's pixels.
    pub fn new(film: &Film) -> Self {
        let mut tables = Vec::new();
        let mut sides = |axis: usize| {
            let count = film.crop_size[axis];
            let side = |index| Side::new(film, axis, index, &mut tables);
            (0..count).map(side).collect()
        };
        Self {
            columns: sides(0),
            rows: sides(1),
        }
    }

    /// What film points are drawn by along each column and then along each row of the image, for
    /// devices: where it starts, from the pixel's centre; the width of a bin, and that over the
    /// filter's integral; the probabilities of all bins below each; and its own.
    pub fn tables(&self) -> impl Iterator<Item = [f64; 3 + 2 * BINS]> {
        let sides = self.columns.iter().chain(&self.rows);
        sides.map(|side| side.table.numbers())
    }

    /// The support of the pixel in column `x` and row `y` of the image.
    #[inline]
    pub fn pixel(&self, [x, y]: [u32; 2]) -> Support<'_> {
        Support {
            sides: [&self.columns[x as usize], &self.rows[y as usize]],
        }
    }
}

impl Support<'_> {
    /// The normalised filter `W` at a film point inside the support.
    #[inline]
    pub fn weight<R: Real>(&self, s: [R; 2]) -> R {
        self.sides[0].weight(s[0]) * self.sides[1].weight(s[1])
    }

    /// True if the filter is discontinuous at some side of the support.
    pub fn is_discontinuous(&self) -> bool {
        self.sides
            .iter()
            .any(|side| side.discontinuous[0] || side.discontinuous[1])
    }

    /// True if a film point is in the support.
    #[inline]
    pub fn contains(&self, s: [f64; 2]) -> bool {
        (0..2).all(|axis| {
            let [from, to] = self.sides[axis].bounds;
            s[axis] >= from && s[axis] < to
        })
    }

    /// The film point opposite to `s`, seen from the middle of the support.
    pub fn mirror(&self, s: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.sides[axis].bounds[0] + self.sides[axis].bounds[1] - s[axis])
    }

    /// A film point, drawn from a mixture of the filter's magnitude and, with the
    /// probability `uniform`, the uniform distribution over the support.
    #[inline]
    pub fn sample(&self, uniform: f64, choice: f64, u: [f64; 2]) -> [f64; 2] {
        let draw = |side: &Side, u: f64| match choice < uniform {
            true => side.bounds[0] + side.width() * u,
            false => side.sample(u),
        };
        [draw(self.sides[0], u[0]), draw(self.sides[1], u[1])]
    }

    /// A film point drawn from the filter's magnitude alone.
    #[inline]
    pub fn sample_by_filter(&self, u: [f64; 2]) -> DrawnPoint {
        let [(x, of_x), (y, of_y)] = [0, 1].map(|axis| self.sides[axis].draw(u[axis]));
        DrawnPoint {
            place: [x, y],
            weight: of_x * of_y,
        }
    }

    /// Density of [`Support::sample`], per pixel area.
    #[inline]
    pub fn pdf(&self, uniform: f64, s: [f64; 2]) -> f64 {
        let flat = 1.0 / (self.sides[0].width() * self.sides[1].width());
        uniform * flat + (1.0 - uniform) * self.sides[0].pdf(s[0]) * self.sides[1].pdf(s[1])
    }
}

impl Side {
    /// `tables` has those of others, and gets this one's if it is new.
    fn new(film: &Film, axis: usize, index: u32, tables: &mut Vec<Arc<FilterTable>>) -> Self {
        let filter = film.filter;
        let start = f64::from(film.crop_offset[axis]);
        let centre = f64::from(film.crop_offset[axis] + index) + 0.5;
        let whole = [-filter.radius(), filter.radius()];
        let mut ends = whole;
        if !film.sample_border {
            let end = start + f64::from(film.crop_size[axis]);
            ends = [whole[0].max(start - centre), whole[1].min(end - centre)];
        }
        let found = tables.iter().find(|table| table.ends == ends);
        let table = found.cloned().unwrap_or_else(|| {
            let table = Arc::new(FilterTable::new(filter, ends));
            tables.push(Arc::clone(&table));
            table
        });
        Self {
            centre,
            bounds: ends.map(|end| centre + end),
            discontinuous: [0, 1].map(|i| filter == Filter::Box || ends[i] != whole[i]),
            table,
        }
    }

    /// Length of the support.
    #[inline]
    pub fn width(&self) -> f64 {
        self.table.ends[1] - self.table.ends[0]
    }

    /// The normalised filter along this axis.
    #[inline]
    pub fn weight<R: Real>(&self, s: R) -> R {
        self.table.weight(s - R::constant(self.centre))
    }

    /// Draws a point with a density close to the filter's magnitude.
    #[inline]
    fn sample(&self, u: f64) -> f64 {
        self.centre + self.table.sample(u)
    }

    /// [`Side::sample`], with the normalised filter there over the density.
    #[inline]
    fn draw(&self, u: f64) -> (f64, f64) {
        if self.table.filter == Filter::Box {
            return (self.sample(u), 1.0);
        }
        let [distance, factor] = self.table.draw(u);
        let weight = self.table.filter.eval(distance) * factor;
        (self.centre + distance, weight)
    }

    /// Density of [`Side::sample`].
    fn pdf(&self, s: f64) -> f64 {
        self.table.pdf(s - self.centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_math::Moments;

    fn film(filter: Filter) -> Film {
        Film::new(5, 4, filter)
    }

    /// `E[W / pdf] = 1` and `E[W s / pdf]` is the filter's centre, for whole
    /// and cut-off supports: the draw has the density it claims.
    #[test]
    fn samples_have_their_density() {
        let n = 1600;
        for filter in [
            Filter::Box,
            Filter::Tent { radius: 1.3 },
            Filter::Gaussian { stddev: 0.5 },
            Filter::Mitchell { b: 0.2, c: 0.4 },
            Filter::Lanczos { lobes: 3 },
        ] {
            for (x, y) in [(2, 2), (0, 0), (4, 1)] {
                let supports = Supports::new(&film(filter));
                let support = supports.pixel([x, y]);
                for uniform in [0.0, 0.5] {
                    let mut total = Moments::default();
                    let mut inverse = Moments::default();
                    for i in 0..n {
                        for k in 0..n {
                            let u = [
                                (f64::from(i) + 0.5) / f64::from(n),
                                (f64::from(k) + 0.5) / f64::from(n),
                            ];
                            // Spread evenly whatever the others are.
                            let choice =
                                (f64::from(i) * 0.754_877_67 + f64::from(k) * 0.569_840_29).fract();
                            let s = support.sample(uniform, choice, u);
                            let pdf = support.pdf(uniform, s);
                            total.add(support.weight(s) / pdf);
                            inverse.add(1.0 / pdf);
                        }
                    }
                    assert!(
                        (total.mean - 1.0).abs() < 5e-3,
                        "{filter:?} at {x}, {y}: {}",
                        total.mean
                    );
                    let area: f64 = support.sides.iter().map(|side| side.width()).product();
                    // Without the uniform part the tails are too rare to count.
                    assert!(
                        uniform == 0.0 || (inverse.mean / area - 1.0).abs() < 2e-2,
                        "{filter:?}: {} of {area}",
                        inverse.mean
                    );
                }
            }
        }
    }

    /// Film borders cut supports, unless the film samples beyond them.
    #[test]
    fn supports_end_at_the_film() {
        let mut film = film(Filter::Gaussian { stddev: 0.5 });
        let supports = Supports::new(&film);
        let [x, y] = supports.pixel([0, 3]).sides;
        assert_eq!((x.bounds, x.discontinuous), ([0.0, 2.5], [true, false]));
        assert_eq!((y.bounds, y.discontinuous), ([1.5, 4.0], [false, true]));
        film.sample_border = true;
        let supports = Supports::new(&film);
        let [x, _] = supports.pixel([0, 3]).sides;
        assert_eq!((x.bounds, x.discontinuous), ([-1.5, 2.5], [false, false]));
    }
}
