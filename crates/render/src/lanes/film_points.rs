//! Points of the film that lanes draw by the filters of their pixels, as [`Support::sample_by_filter`] does.
//!
//! [`Support::sample_by_filter`]: crate::pixel::Support::sample_by_filter

use std::ops::Range;
use std::sync::Arc;

use capwalk_geometry::simd::{Computation, Simd};
use capwalk_math::elementary::exp;
use capwalk_scene::Filter;

use crate::filter_table::FilterTable;
use crate::lanes::vectors::{LANES, Numbers};
use crate::pixel::Side;
use crate::tiles::SampleRun;

/// Samples that are not taken yet.
pub struct RestOfRuns<'a> {
    runs: &'a [SampleRun],
    /// How many of the first run have been taken.
    taken: u32,
}

impl<'a> RestOfRuns<'a> {
    /// All of them.
    pub fn new(runs: &'a [SampleRun]) -> Self {
        Self { runs, taken: 0 }
    }

    /// True if there are none.
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// Takes the next ones of a run, at most so many.
    pub fn next(&mut self, most: usize) -> Option<(&'a SampleRun, Range<u32>)> {
        let (run, others) = self.runs.split_first()?;
        let Range { start, end } = run.numbers;
        let first = start + self.taken;
        let numbers = first..end.min(first.saturating_add(most as u32));
        self.taken += numbers.len() as u32;
        if numbers.end == end {
            (self.runs, self.taken) = (others, 0);
        }
        Some((run, numbers))
    }
}

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
        weigh(table.filter, &mut points.distances);
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

/// From distances to the centres of pixels to the filter there.
#[inline(always)]
fn weigh(filter: Filter, distances: &mut Numbers) {
    match filter {
        Filter::Gaussian { stddev } => {
            let (scale, least) = (-0.5 / (stddev * stddev), (-8.0_f64).exp());
            for x in distances {
                *x = exp(*x * *x * scale) - least;
            }
        }
        Filter::Tent { radius } => {
            let scale = 1.0 / radius;
            for x in distances {
                *x = 1.0 - x.abs() * scale;
            }
        }
        _ => {
            for x in distances {
                *x = filter.eval(*x);
            }
        }
    }
}

#[inline(always)]
fn multiply(weights: &mut Numbers, points: &Points) {
    for (lane, weight) in weights.iter_mut().enumerate() {
        *weight *= points.distances[lane] * points.factors[lane];
    }
}
