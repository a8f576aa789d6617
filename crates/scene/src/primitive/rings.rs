//! Circles across curves with a thickness: Mitsuba's `bsplinecurve` and `linearcurve`.

use std::f64::consts::{FRAC_PI_2, PI};

use capwalk_math::{Frame, Vec3};

/// The most steps along one segment.
const MOST_STEPS: u32 = 64;

/// How curves follow their control points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// Uniform cubic B-splines, open at both ends.
    BSpline,
    /// Straight lines: cones that touch the spheres around their ends.
    Linear,
}

impl CurveKind {
    /// How many control points a curve has at least.
    pub fn least(self) -> usize {
        match self {
            Self::BSpline => 4,
            Self::Linear => 2,
        }
    }
}

/// A point of a curve: its position, and its radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlPoint {
    /// Position.
    pub position: Vec3,
    /// Radius, 0 or more.
    pub radius: f64,
}

/// A circle across a tube.
#[derive(Clone, Copy)]
pub(super) struct Ring {
    pub centre: Vec3,
    pub radius: f64,
    /// Unit vector along the tube.
    pub axis: Vec3,
    /// The normal in the direction `r` is along `(1 - r·bend) r + tilt axis`.
    pub bend: Vec3,
    pub tilt: f64,
    /// The second texture coordinate.
    pub v: f64,
}

/// A B-spline at one place.
pub(super) struct SplinePoint {
    pub position: Vec3,
    velocity: Vec3,
    acceleration: Vec3,
    pub radius: f64,
    radius_velocity: f64,
    radius_acceleration: f64,
}

/// The cubic B-spline of four control points at `t` from 0 to 1.
pub(super) fn spline_point(points: &[ControlPoint], t: f64) -> SplinePoint {
    let s = 1.0 - t;
    let value = [
        s * s * s,
        4.0 - 6.0 * t * t + 3.0 * t * t * t,
        4.0 - 6.0 * s * s + 3.0 * s * s * s,
        t * t * t,
    ]
    .map(|w| w / 6.0);
    let velocity = [-s * s, -4.0 * t + 3.0 * t * t, 4.0 * s - 3.0 * s * s, t * t].map(|w| w / 2.0);
    let acceleration = [s, 3.0 * t - 2.0, 3.0 * s - 2.0, t];
    let vector = |weights: [f64; 4]| {
        let terms = weights.iter().zip(points);
        terms.fold(Vec3::zero(), |sum, (&w, p)| sum + p.position * w)
    };
    let number = |weights: [f64; 4]| -> f64 {
        let terms = weights.iter().zip(points);
        terms.map(|(w, p)| w * p.radius).sum()
    };
    SplinePoint {
        position: vector(value),
        velocity: vector(velocity),
        acceleration: vector(acceleration),
        radius: number(value).max(0.0),
        radius_velocity: number(velocity),
        radius_acceleration: number(acceleration),
    }
}

/// The rings of a B-spline, with `v` counting its segments; or the control point at which
/// it has no direction.
pub(super) fn spline_rings(curve: &[ControlPoint], error: f64) -> Result<Vec<Ring>, usize> {
    let mut rings = Vec::new();
    for (segment, points) in curve.windows(4).enumerate() {
        let ring = |t: f64| spline_ring(points, t, segment).ok_or(segment);
        // Take the fewest steps, a power of two, with which no step is off by more.
        let mut steps = 1;
        while steps < MOST_STEPS && !is_straight(points, &ring, steps, error)? {
            steps *= 2;
        }
        let first = u32::from(segment > 0);
        for step in first..=steps {
            rings.push(ring(f64::from(step) / f64::from(steps))?);
        }
    }
    Ok(rings)
}

/// True if each of as many steps along a segment is straight up to an error in radii.
fn is_straight(
    points: &[ControlPoint],
    ring: &impl Fn(f64) -> Result<Ring, usize>,
    steps: u32,
    error: f64,
) -> Result<bool, usize> {
    let length = 1.0 / f64::from(steps);
    let mut from = ring(0.0)?;
    for step in 0..steps {
        let start = f64::from(step) * length;
        let middle = ring(start + 0.5 * length)?;
        let to = ring(start + length)?;
        // A curve is off its chord by length²/8 times the largest second derivative, which is
        // linear along a segment and so largest at an end.
        let bend = |t: f64| {
            let at = spline_point(points, t);
            let along = at.acceleration.dot(middle.axis);
            at.acceleration.reject_from(middle.axis).length()
                + (along * middle.tilt).abs()
                + at.radius_acceleration.abs()
        };
        let chord = bend(start).max(bend(start + length)) * length * length / 8.0;
        // Where it turns, so does what lies beside it; in an S the ends agree.
        let turn = |a: Vec3, b: Vec3| a.cross(b).length().atan2(a.dot(b));
        let turn = turn(from.axis, middle.axis).max(turn(middle.axis, to.axis));
        let radius = middle.radius.max(0.5 * (from.radius + to.radius));
        if chord + middle.radius * (1.0 - turn.cos()) > error * radius {
            return Ok(false);
        }
        from = to;
    }
    Ok(true)
}

/// The ring at a place of a segment, or `None` if the curve has no direction there.
fn spline_ring(points: &[ControlPoint], t: f64, segment: usize) -> Option<Ring> {
    /// Where control points coincide the curve may stop at an end of a segment; its
    /// direction is that of a place this far inside.
    const ASIDE: f64 = 1e-3;
    let point = spline_point(points, t);
    let spread = points
        .iter()
        .map(|p| (p.position - points[0].position).length());
    // What is left of a velocity of zero after rounding is not one.
    let rounding = 4.0 * f64::EPSILON * points[0].position.length();
    let smallest = 1e-9 * spread.fold(0.0, f64::max) + rounding;
    let is_moving = |at: &SplinePoint| at.velocity.length() > smallest;
    let aside = spline_point(points, t + if t < 0.5 { ASIDE } else { -ASIDE });
    let guide = [&point, &aside].into_iter().find(|&at| is_moving(at))?;
    let speed = guide.velocity.length();
    Some(Ring {
        centre: point.position,
        radius: point.radius,
        axis: guide.velocity / speed,
        bend: guide.acceleration * (guide.radius / (speed * speed)),
        tilt: -guide.radius_velocity / speed,
        v: segment as f64 + t,
    })
}

/// The rings of straight segments, with `v` counting them; or the control point that is
/// where the next one is. Each segment is a cone that touches the spheres around its ends;
/// around each control point the rings turn on its sphere.
pub(super) fn linear_rings(curve: &[ControlPoint], around: u32) -> Result<Vec<Ring>, usize> {
    let turn_per_ring = 2.0 * PI / f64::from(around);
    let mut cones = Vec::new();
    for (i, pair) in curve.windows(2).enumerate() {
        let along = pair[1].position - pair[0].position;
        let length = along.length();
        if length == 0.0 {
            return Err(i);
        }
        // The normal leans forward where the cone gets thinner.
        let lean = (pair[0].radius - pair[1].radius) / length;
        cones.push((along / length, lean.clamp(-1.0, 1.0).asin()));
    }
    let mut rings = Vec::new();
    for (i, point) in curve.iter().enumerate() {
        // From a pole or the cone before to the cone behind or a pole.
        let before = i.checked_sub(1).map(|i| cones[i]);
        let behind = cones.get(i).copied();
        let from = before.unwrap_or_else(|| (cones[i].0, -FRAC_PI_2));
        let to = behind.unwrap_or_else(|| (cones[i - 1].0, FRAC_PI_2));
        let turn = from.0.cross(to.0).length().atan2(from.0.dot(to.0));
        let most = turn.max((to.1 - from.1).abs());
        let steps = (most / turn_per_ring).ceil().max(1.0);
        let turned = Turned::new(from.0, to.0, turn);
        for step in 0..=steps as u32 {
            let part = f64::from(step) / steps;
            let (sin, cos) = (from.1 + (to.1 - from.1) * part).sin_cos();
            let axis = turned.at(part);
            rings.push(Ring {
                centre: point.position + axis * (point.radius * sin),
                radius: point.radius * cos.max(0.0),
                axis,
                bend: Vec3::zero(),
                // At a pole the normal is the axis.
                tilt: sin / cos.max(1e-9),
                v: i as f64,
            });
        }
    }
    Ok(rings)
}

/// Directions between two unit vectors.
struct Turned {
    from: Vec3,
    /// The unit vector perpendicular to it, towards the other.
    aside: Vec3,
    angle: f64,
}

impl Turned {
    fn new(from: Vec3, to: Vec3, angle: f64) -> Self {
        let aside = Frame::from_normal_and_tangent(from, to).s;
        Self { from, aside, angle }
    }

    fn at(&self, part: f64) -> Vec3 {
        let (sin, cos) = (part * self.angle).sin_cos();
        self.from * cos + self.aside * sin
    }
}
