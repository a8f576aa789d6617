//! The toy of Section 3.3: an interval whose ends move.

use capwalk_walk::{Domain, Nearest};

/// The interval from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Interval;

/// An end of the interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The end at 0.
    Left,
    /// The end at 1.
    Right,
}

impl Domain for Interval {
    type Vector = f64;
    type Site = End;

    fn closest(&self, x: f64, limit: f64) -> Option<Nearest<End, f64>> {
        let (site, point) = if x < 0.5 {
            (End::Left, 0.0)
        } else {
            (End::Right, 1.0)
        };
        let distance = (x - point).abs();
        (distance < limit).then_some(Nearest {
            site,
            point,
            distance,
        })
    }

    fn radius_at(&self, x: f64, known: &Nearest<End, f64>) -> Option<f64> {
        Some((x - known.point).abs())
    }

    fn growth(&self, x: f64, nearest: &Nearest<End, f64>) -> f64 {
        (x - nearest.point).signum()
    }

    fn tangent(&self, _x: f64, azimuth: f64) -> f64 {
        if azimuth < 0.5 { 1.0 } else { -1.0 }
    }

    fn walk(&self, x: f64, e: f64, distance: f64) -> f64 {
        x + e * distance
    }

    fn radius_inside(&self, radius: f64, u: f64) -> f64 {
        radius * u
    }

    fn rim_over_ball(&self, radius: f64) -> f64 {
        radius.recip()
    }

    fn curvature(&self, _x: f64) -> f64 {
        0.0
    }
}
