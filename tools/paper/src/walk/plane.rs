//! The plane, bounded by curves; balls are disks.

use capwalk_math::Vec2;
use capwalk_walk::{Domain, Nearest};

/// A curve with boundary values on it.
#[derive(Clone, Copy, Debug)]
pub enum BoundaryCurve {
    /// The straight line between two points.
    Segment([Vec2; 2]),
    /// A circle.
    Circle {
        /// Its centre.
        centre: Vec2,
        /// Its radius.
        radius: f64,
    },
}

/// A point on a boundary curve.
#[derive(Clone, Copy, Debug)]
pub struct CurvePoint {
    /// Index of the curve.
    pub curve: usize,
    /// Where on it, from 0 to 1: from the first end of a segment to the second,
    /// once around a circle from its rightmost point, counter-clockwise.
    pub t: f64,
    /// Where it is.
    pub point: Vec2,
}

/// The plane around a set of curves. Walks may start on any side of them.
#[derive(Clone, Debug)]
pub struct Plane {
    /// The boundary.
    pub curves: Vec<BoundaryCurve>,
}

impl BoundaryCurve {
    /// The curve's point at `t` from 0 to 1, see [`CurvePoint::t`].
    pub fn at(&self, t: f64) -> Vec2 {
        match *self {
            BoundaryCurve::Segment([a, b]) => a + (b - a) * t,
            BoundaryCurve::Circle { centre, radius } => centre + Vec2::unit(t) * radius,
        }
    }

    /// Where on it the point closest to `x` is, Eq. (15). To the centre of a
    /// circle all its points are equally close; the rightmost is returned.
    pub fn closest(&self, x: Vec2) -> f64 {
        match *self {
            BoundaryCurve::Segment([a, b]) => {
                let along = b - a;
                let t = (x - a).dot(along) / along.dot(along);
                // A segment of no length has one point.
                if t.is_finite() {
                    t.clamp(0.0, 1.0)
                } else {
                    0.0
                }
            }
            BoundaryCurve::Circle { centre, .. } => {
                let from_centre = x - centre;
                let turn = from_centre.y.atan2(from_centre.x) / std::f64::consts::TAU;
                if turn < 0.0 { turn + 1.0 } else { turn }
            }
        }
    }
}

impl Plane {
    /// The plane around a polygon with these corners.
    pub fn polygon(corners: &[Vec2]) -> Self {
        let following = corners.iter().cycle().skip(1);
        let sides = corners.iter().zip(following);
        Self {
            curves: sides
                .map(|(&a, &b)| BoundaryCurve::Segment([a, b]))
                .collect(),
        }
    }

    /// The plane around a circle.
    pub fn circle(centre: Vec2, radius: f64) -> Self {
        Self {
            curves: vec![BoundaryCurve::Circle { centre, radius }],
        }
    }
}

impl Domain for Plane {
    type Vector = Vec2;
    type Site = CurvePoint;

    /// Looks at every curve: there are few.
    fn closest(&self, x: Vec2, limit: f64) -> Option<Nearest<CurvePoint, Vec2>> {
        let mut best: Option<Nearest<CurvePoint, Vec2>> = None;
        for (index, curve) in self.curves.iter().enumerate() {
            let t = curve.closest(x);
            let point = curve.at(t);
            let distance = (x - point).length();
            if distance < best.map_or(limit, |best| best.distance) {
                best = Some(Nearest {
                    site: CurvePoint {
                        curve: index,
                        t,
                        point,
                    },
                    point,
                    distance,
                });
            }
        }
        best
    }

    fn radius_at(&self, x: Vec2, known: &Nearest<CurvePoint, Vec2>) -> Option<f64> {
        Some((x - known.point).length())
    }

    fn growth(&self, x: Vec2, nearest: &Nearest<CurvePoint, Vec2>) -> Vec2 {
        (x - nearest.point).normalized()
    }

    fn tangent(&self, _x: Vec2, azimuth: f64) -> Vec2 {
        Vec2::unit(azimuth)
    }

    fn walk(&self, x: Vec2, e: Vec2, distance: f64) -> Vec2 {
        x + e * distance
    }

    fn radius_inside(&self, radius: f64, u: f64) -> f64 {
        radius * u.sqrt()
    }

    /// `2π D / (π D²)`, Eqs. (23) and (27).
    fn rim_over_ball(&self, radius: f64) -> f64 {
        2.0 / radius
    }

    fn curvature(&self, _x: Vec2) -> Vec2 {
        Vec2::new(0.0, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closest point of a curve is the closest of very many.
    #[test]
    fn closest_is_closest_of_many() {
        let curves = [
            BoundaryCurve::Segment([Vec2::new(-1.0, 0.5), Vec2::new(2.0, -0.3)]),
            BoundaryCurve::Segment([Vec2::new(0.3, 0.3), Vec2::new(0.3, 0.3)]),
            BoundaryCurve::Circle {
                centre: Vec2::new(0.4, -0.2),
                radius: 0.7,
            },
        ];
        let plane = Plane {
            curves: curves.to_vec(),
        };
        for i in 0..200 {
            let x = Vec2::new((f64::from(i) * 1.7).sin() * 2.5, (f64::from(i) * 2.9).cos());
            let n = 4000;
            let mut all = f64::INFINITY;
            for curve in &curves {
                let points = (0..=n).map(|k| curve.at(f64::from(k) / f64::from(n)));
                let least = points
                    .map(|p| (p - x).length())
                    .fold(f64::INFINITY, f64::min);
                let found = (curve.at(curve.closest(x)) - x).length();
                assert!(found <= least + 1e-12, "{curve:?} at {x:?}");
                // The points are at most 0.003 apart.
                assert!(found > least - 0.002, "{curve:?} at {x:?}");
                all = all.min(found);
            }
            let nearest = plane.closest(x, f64::INFINITY).expect("there are curves");
            assert!((nearest.distance - all).abs() < 1e-12);
            let curve = plane.curves[nearest.site.curve];
            assert_eq!(curve.at(nearest.site.t), nearest.point);
            assert!(plane.closest(x, all).is_none());
        }
    }

    #[test]
    fn centre_of_a_circle_has_a_closest_point() {
        let plane = Plane::circle(Vec2::new(0.0, 0.0), 2.0);
        let nearest = plane.closest(Vec2::new(0.0, 0.0), 3.0);
        assert_eq!(nearest.expect("it is 2 away").point, Vec2::new(2.0, 0.0));
    }
}
