//! Curves with a thickness as triangles: Mitsuba's `bsplinecurve` and `linearcurve`.
//!
//! A curve becomes a row of rings of vertices, and triangles between neighbours. The rings
//! are polygons with the circumference of the circle that they stand for: by Cauchy's
//! formula, a tube is as wide as it should be on average over all directions, so that
//! many thin ones hide as much as round ones.

use std::f64::consts::PI;

use capwalk_geometry::Mesh;
use capwalk_math::{Frame, Vec3};

use super::SILHOUETTE_ERROR;
use super::rings::{ControlPoint, CurveKind, Ring, linear_rings, spline_rings};
use super::uv::{FaceUvs, unwrapped};
use crate::shape::ShadingNormals;

/// The largest and the smallest distance between a tube and the true one, in radii.
/// Between them it is [`SILHOUETTE_ERROR`] of the size of all curves together, so that hairs
/// have few triangles.
const TUBE_ERROR: [f64; 2] = [1e-4, 1e-2];

/// Why curves have no tubes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TubeError {
    /// The control point of this curve at which it has no direction.
    NoDirection {
        /// Which curve.
        curve: usize,
        /// Which of its control points.
        point: usize,
    },
    /// They have more triangles than they may.
    TooMany {
        /// The most triangles.
        most: usize,
    },
}

/// The tubes around curves that each have as many control points as their kind needs, with
/// smooth normals, front outside, and Mitsuba's texture coordinates: the angle around the
/// curve over 2π, and the place along all segments of all curves, from 0 to 1. At most
/// `most` triangles.
pub fn tubes(
    kind: CurveKind,
    curves: &[Vec<ControlPoint>],
    most: usize,
) -> Result<(Mesh, ShadingNormals, FaceUvs), TubeError> {
    let error = relative_error(curves);
    let around = segments_around(error);
    let segments = |curve: &Vec<ControlPoint>| curve.len() + 1 - kind.least();
    let all_segments = curves.iter().map(segments).sum::<usize>() as f64;
    let mut tubes = Tubes::default();
    let mut before = 0;
    for (index, curve) in curves.iter().enumerate() {
        let mut rings = match kind {
            CurveKind::BSpline => spline_rings(curve, error),
            CurveKind::Linear => linear_rings(curve, around),
        }
        .map_err(|point| TubeError::NoDirection {
            curve: index,
            point,
        })?;
        for ring in &mut rings {
            ring.v = (before as f64 + ring.v) / all_segments;
        }
        if tubes.mesh.faces.len() + 2 * around as usize * rings.len() > most {
            return Err(TubeError::TooMany { most });
        }
        tubes.add(&rings, around);
        before += segments(curve);
    }
    Ok((tubes.mesh, ShadingNormals::Given(tubes.normals), tubes.uvs))
}

/// How far tubes may be from the true ones, in radii.
fn relative_error(curves: &[Vec<ControlPoint>]) -> f64 {
    let points = || curves.iter().flatten();
    let (low, high) = points().fold(
        (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY)),
        |(low, high), point| (low.min(point.position), high.max(point.position)),
    );
    let thickest = points().map(|point| point.radius).fold(0.0, f64::max);
    let size = (high - low).length();
    match thickest > 0.0 {
        true => (SILHOUETTE_ERROR * size / thickest).clamp(TUBE_ERROR[0], TUBE_ERROR[1]),
        false => TUBE_ERROR[1],
    }
}

/// Corners of polygons whose sides are that close to the circle: with its circumference,
/// the sides of an n-gon are `1 - (π/n) / tan(π/n)`, about `(π/n)² / 3`, inside.
fn segments_around(error: f64) -> u32 {
    let n = PI / (3.0 * error).sqrt();
    4 * (n / 4.0).ceil() as u32
}

/// Tubes, one after the other.
#[derive(Default)]
struct Tubes {
    mesh: Mesh,
    normals: Vec<Vec3>,
    uvs: FaceUvs,
}

impl Tubes {
    fn add(&mut self, rings: &[Ring], around: u32) {
        // With the circle's circumference.
        let corner = {
            let half = PI / f64::from(around);
            half / half.sin()
        };
        let mut side = Frame::from_normal(rings[0].axis).s;
        let mut last_axis = rings[0].axis;
        let mut last_row: Option<u32> = None;
        let mut vertex_uvs = Vec::with_capacity(rings.len() * around as usize);
        let first_vertex = self.mesh.positions.len() as u32;
        for ring in rings {
            side = transported(side, last_axis, ring.axis);
            last_axis = ring.axis;
            let other = ring.axis.cross(side);
            let row = self.mesh.positions.len() as u32;
            for i in 0..around {
                let (sin, cos) = (2.0 * PI * f64::from(i) / f64::from(around)).sin_cos();
                let out = side * cos + other * sin;
                let position = ring.centre + out * (ring.radius * corner);
                self.mesh.positions.push(position);
                // Where a tube is thicker than its curve bends, the formula turns over.
                let outward = (1.0 - out.dot(ring.bend)).max(1e-3);
                let normal = out * outward + ring.axis * ring.tilt;
                self.normals.push(normal.normalized());
                vertex_uvs.push([angle_around(ring.axis, out), ring.v]);
            }
            for i in (0..around).filter(|_| last_row.is_some()) {
                let below = last_row.expect("only behind the first ring");
                let next = (i + 1) % around;
                let quad = [below + i, below + next, row + next, row + i];
                for corners in [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]] {
                    self.add_face(corners, &vertex_uvs, first_vertex);
                }
            }
            last_row = Some(row);
        }
    }

    /// Adds a triangle, unless two of its corners coincide.
    fn add_face(&mut self, corners: [u32; 3], vertex_uvs: &[[f64; 2]], first_vertex: u32) {
        let [a, b, c] = corners.map(|i| self.mesh.positions[i as usize]);
        if a == b || b == c || c == a || (b - a).cross(c - a).length_squared() == 0.0 {
            return;
        }
        let uvs = corners.map(|i| vertex_uvs[(i - first_vertex) as usize]);
        self.mesh.faces.push(corners);
        self.uvs.push(unwrapped(uvs));
    }
}

/// A vector perpendicular to one axis, turned with it into another by the shortest way.
fn transported(side: Vec3, from: Vec3, to: Vec3) -> Vec3 {
    let turned = match 1.0 + from.dot(to) {
        // A tube that turns back keeps its side.
        sum if sum < 1e-12 => side,
        sum => side - (from + to) * (to.dot(side) / sum),
    };
    turned.reject_from(to).normalized()
}

/// Mitsuba's angle around a curve, in turns from 0 to 1: it is at 1/4 in the direction that
/// is closest to `+z`.
fn angle_around(axis: Vec3, out: Vec3) -> f64 {
    let up = Vec3::new(0.0, 0.0, 1.0).reject_from(axis);
    let up = match up.length() > 0.0 {
        true => up.normalized(),
        false => Vec3::new(0.0, 1.0, 0.0),
    };
    let angle = up.dot(out).atan2(up.cross(axis).dot(out)) / (2.0 * PI);
    angle - angle.floor()
}

#[cfg(test)]
mod tests {
    use super::super::rings::spline_point;
    use super::*;
    use capwalk_geometry::Sides;
    use capwalk_geometry::topology::edges;

    fn point(position: [f64; 3], radius: f64) -> ControlPoint {
        let position = position.into();
        ControlPoint { position, radius }
    }

    fn bent() -> Vec<ControlPoint> {
        vec![
            point([-2.0, -0.5, 0.3], 0.1),
            point([-1.0, 0.4, 0.1], 0.2),
            point([0.2, 0.1, 0.5], 0.15),
            point([1.0, -0.6, -0.2], 0.2),
            point([1.8, 0.5, 0.2], 0.1),
        ]
    }

    /// Between its corners it is S-shaped: middles of segments are on their chords.
    fn zigzag() -> Vec<ControlPoint> {
        let sign = |i: usize| if i.is_multiple_of(2) { 0.3 } else { -0.3 };
        let points = (0..6).map(|i| point([0.5 * i as f64, 0.1, sign(i)], 0.05));
        points.collect()
    }

    fn borders(mesh: &Mesh) -> usize {
        let edges = edges(mesh);
        edges.iter().filter(|e| e.sides == Sides::Open).count()
    }

    /// The distance of a point from the tube around a curve, by the closest of many places.
    fn distance(curve: &[ControlPoint], kind: CurveKind, p: Vec3) -> f64 {
        let steps = 20_000;
        let mut best = f64::INFINITY;
        for points in curve.windows(kind.least()) {
            for step in 0..=steps {
                let t = f64::from(step) / f64::from(steps);
                let (position, radius) = match kind {
                    CurveKind::BSpline => {
                        let at = spline_point(points, t);
                        (at.position, at.radius)
                    }
                    CurveKind::Linear => (
                        points[0].position * (1.0 - t) + points[1].position * t,
                        points[0].radius * (1.0 - t) + points[1].radius * t,
                    ),
                };
                best = best.min((p - position).length() - radius);
            }
        }
        best
    }

    /// Corners are a little outside, middles of triangles a little inside of the true tube:
    /// within the stated error of the radius, which is not wasted either.
    #[test]
    fn tubes_are_within_their_error() {
        for (kind, curve) in [
            (CurveKind::BSpline, bent()),
            (CurveKind::BSpline, zigzag()),
            (CurveKind::Linear, bent()),
        ] {
            let curves = [curve.clone()];
            let error = relative_error(&curves) * 0.2;
            let (mesh, _, uvs) = tubes(kind, &curves, usize::MAX).expect("a tube");
            assert_eq!(uvs.len(), mesh.faces.len());
            let mut worst = 0.0_f64;
            for face in (0..mesh.faces.len()).step_by(97) {
                let [a, b, c] = mesh.corners(face);
                for p in [a, (a + b + c) / 3.0, (a + c) * 0.5] {
                    let off = distance(&curve, kind, p);
                    // Folds inside a joint are inside.
                    if kind == CurveKind::BSpline || off > 0.0 {
                        worst = worst.max(off.abs());
                    }
                }
            }
            assert!(worst < 2.0 * error, "{kind:?}: {worst} of {error}");
            assert!(worst > 0.1 * error, "{kind:?} is too fine: {worst}");
        }
    }

    /// B-splines end openly, unless their radius is 0 there; linear curves are closed.
    #[test]
    fn ends_are_those_of_mitsuba() {
        let curves = [bent()];
        let around = segments_around(relative_error(&curves)) as usize;
        let (open, _, _) = tubes(CurveKind::BSpline, &curves, usize::MAX).expect("a tube");
        assert_eq!(borders(&open), 2 * around);
        let (closed, _, _) = tubes(CurveKind::Linear, &curves, usize::MAX).expect("a tube");
        assert_eq!(borders(&closed), 0);
        let mut pointed = bent();
        for point in &mut pointed[..3] {
            point.radius = 0.0;
        }
        let (mesh, _, _) = tubes(CurveKind::BSpline, &[pointed], usize::MAX).expect("a tube");
        assert!(borders(&mesh) > 0 && borders(&mesh) < 2 * around);
    }

    /// Faces and normals look outward, and a straight tube of 4 control points has the
    /// surface of a cylinder: the circumference is exact.
    #[test]
    fn tubes_are_outward_and_have_their_circumference() {
        let straight: Vec<_> = (0..4)
            .map(|i| point([0.0, f64::from(i), 0.0], 0.25))
            .collect();
        let (mesh, _, _) = tubes(CurveKind::BSpline, &[straight], usize::MAX).expect("a tube");
        assert!((mesh.area() / (2.0 * PI * 0.25) - 1.0).abs() < 1e-12);
        for kind in [CurveKind::BSpline, CurveKind::Linear] {
            let (mesh, normals, _) = tubes(kind, &[bent()], usize::MAX).expect("a tube");
            let normals = normals.per_vertex().expect("tubes are smooth");
            let agreeing = |face: &usize| {
                let n = mesh.face_cross(*face).normalized();
                let corners = mesh.faces[*face];
                corners.iter().all(|&i| n.dot(normals[i as usize]) > 0.5)
            };
            let faces = mesh.faces.len();
            let outward = (0..faces).filter(agreeing).count();
            // But for the folds inside the joints.
            let least = if kind == CurveKind::BSpline { 1.0 } else { 0.6 };
            assert!(
                outward as f64 >= least * faces as f64,
                "{outward} of {faces}"
            );
        }
    }

    #[test]
    fn what_has_no_direction_is_an_error() {
        let same = vec![point([1.0, 2.0, 3.0], 0.1); 4];
        for (kind, place) in [(CurveKind::BSpline, 0), (CurveKind::Linear, 0)] {
            let error = tubes(kind, &[bent(), same.clone()], usize::MAX).expect_err("no direction");
            assert_eq!(
                error,
                TubeError::NoDirection {
                    curve: 1,
                    point: place
                }
            );
        }
        // Three points at one place end a B-spline there, and that is usual.
        let mut clamped = bent();
        clamped[1] = clamped[0];
        clamped[2] = clamped[0];
        assert!(tubes(CurveKind::BSpline, &[clamped], usize::MAX).is_ok());
        let error = tubes(CurveKind::BSpline, &[bent()], 100).expect_err("too many");
        assert_eq!(error, TubeError::TooMany { most: 100 });
    }
}
