//! Points of the film that lanes draw by the filters of their pixels, as [`Support::sample_by_filter`] does.
//!
//! [`Support::sample_by_filter`]: crate::pixel::Support::sample_by_filter

use std::sync::Arc;

use capwalk_geometry::simd::{Computation, Simd};
use capwalk_scene::Filter;

use crate::filter_table::FilterTable;
use crate::lanes::vectors::{LANES, Numbers};
use crate::pixel::Side;

/// Draws the points along one axis, from random numbers.
pub struct DrawAlong<'a> {
    /// The supports of the pixels, all with the same filter.
    pub sides: &'a [&'a Side; LANES],
    /// The random numbers, and then the points.
    pub film: &'a mut Numbers,
    /// The weights of the samples, which are multiplied by this axis's part of them.
    pub weights: &'a mut Numbers,
}

impl Computation for DrawAlong<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, _: S) {
        let Self {
            sides,
            film,
            weights,
        } = self;
        let table = &sides[0].table;
        if table.filter == Filter::Box {
            return draw_in_boxes(sides, film);
        }
        let mut points = Points::NONE;
        match sides.iter().all(|side| Arc::ptr_eq(&side.table, table)) {
            true => draw(table, film, &mut points),
            // At the border of the image.
            false => {
                for (lane, side) in sides.iter().enumerate() {
                    points.set(lane, &side.table, film[lane]);
                }
            }
        }
        for (lane, side) in sides.iter().enumerate() {
            film[lane] = side.centre + points.distances[lane];
        }
        table.filter.eval_each(&mut points.distances);
        multiply(weights, &points);
    }
}

#[inline(always)]
fn draw_in_boxes(sides: &[&Side; LANES], film: &mut Numbers) {
    for (film, side) in film.iter_mut().zip(sides) {
        *film = side.centre + side.table.sample(*film);
    }
}

/// Points along an axis.
struct Points {
    /// From the centres of the pixels.
    distances: Numbers,
    /// What the filter there is multiplied by for its weight over the density.
    factors: Numbers,
}

impl Points {
    const NONE: Self = Self {
        distances: [0.0; LANES],
        factors: [0.0; LANES],
    };

    #[inline]
    fn set(&mut self, lane: usize, table: &FilterTable, u: f64) {
        [self.distances[lane], self.factors[lane]] = table.draw(u);
    }
}

/// [`Points::set`] in all lanes, with one table.
#[inline(always)]
fn draw(table: &FilterTable, film: &Numbers, points: &mut Points) {
    let (mut bins, mut below) = ([0.0; LANES], [0.0; LANES]);
    let mut inverse = [table.inverse[0]; LANES];
    for (bin, (&start, &over)) in table.below.iter().zip(&table.inverse).enumerate() {
        for lane in 0..LANES {
            let is_reached = film[lane] >= start;
            bins[lane] = if is_reached { bin as f64 } else { bins[lane] };
            below[lane] = if is_reached { start } else { below[lane] };
            inverse[lane] = if is_reached { over } else { inverse[lane] };
        }
    }
    for lane in 0..LANES {
        let bin = [below[lane], inverse[lane]];
        let [distance, factor] = table.draw_in(bins[lane], film[lane], bin);
        (points.distances[lane], points.factors[lane]) = (distance, factor);
    }
}

#[inline(always)]
fn multiply(weights: &mut Numbers, points: &Points) {
    for (lane, weight) in weights.iter_mut().enumerate() {
        *weight *= points.distances[lane] * points.factors[lane];
    }
}
