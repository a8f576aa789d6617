//! The directions in which an emitter can be seen from a point, bounded by a cone and by
//! planes.

use std::f64::consts::{FRAC_PI_2, PI};

use capwalk_geometry::{ConeQuery, EdgeSelection, HalfSpace, Mesh};
use capwalk_math::{Frame, Vec3, sphere};
use capwalk_scene::{EmitterId, Scene};

use crate::viewpoint::SEEN;

/// An area emitter and its bounds.
#[derive(Clone, Debug)]
pub struct AreaEmitter {
    /// The emitter.
    pub emitter: EmitterId,
    extent: Extent,
    /// The middle of its box, and half of the diagonal.
    ball: (Vec3, f64),
}

/// Bounds of an emitter.
#[derive(Clone, Debug)]
pub enum Extent {
    /// In a plane: the corners of a polygon around it, counterclockwise around the
    /// normal of its emitting side.
    Flat {
        /// The corners.
        hull: Vec<Vec3>,
        /// The normal, unit vector.
        normal: Vec3,
    },
    /// In a ball.
    Ball {
        /// Its centre.
        centre: Vec3,
        /// Its radius.
        radius: f64,
    },
}

/// The directions in which an emitter may be seen from a viewpoint.
pub struct Window {
    /// A cone around them.
    pub cone: ConeQuery,
    /// Planes through the viewpoint around them, by unit normals that point inside.
    pub planes: Vec<Vec3>,
}

/// Part of its distance by which a ball must be outside: more than rounding, and than edges in a plane
/// of the window, which count as inside.
const OUTSIDE: f64 = 1e-8;

impl Window {
    /// The share of a ball that is in the window, roughly; zero only if no point of it is.
    pub fn share(&self, centre: Vec3, radius: f64) -> f64 {
        let offset = centre - self.cone.apex;
        let distance = offset.length();
        let reach = radius + OUTSIDE * (distance + radius);
        let is_outside = |normal: &Vec3| normal.dot(offset) < -reach;
        let is_behind = |plane: &HalfSpace| plane.normal.dot(centre - plane.point) < -reach;
        if self.planes.iter().any(is_outside)
            || self.cone.in_front_of.as_ref().is_some_and(is_behind)
        {
            return 0.0;
        }
        let width = self.cone.max_angle.min(FRAC_PI_2).sin() * (distance + radius);
        (width / radius).powi(2).min(1.0)
    }
}

/// Emitters lie in a plane if their vertices do up to this part of their size.
const FLAT: f64 = 1e-9;
/// Flat emitters with more corners get windows of four.
pub const MANY_CORNERS: usize = 8;
/// Radians by which cones are opened, and the part of its size by which an emitter's
/// plane is moved back: more than rounding.
const MARGIN: f64 = 1e-6;

impl AreaEmitter {
    /// All emitters of a scene.
    pub fn all(scene: &Scene) -> Vec<Self> {
        let emitters = (0..).map(EmitterId).zip(&scene.emitters);
        let found = emitters.filter_map(|(emitter, what)| {
            let shape = what.shape()?;
            Some(Self::new(emitter, &scene.shape(shape).mesh))
        });
        found.collect()
    }

    fn new(emitter: EmitterId, mesh: &Mesh) -> Self {
        let (low, high) = mesh.bounds();
        let (centre, size) = ((low + high) * 0.5, (high - low).length());
        let normals = (0..mesh.faces.len()).map(|face| mesh.face_cross(face));
        let sum = normals.clone().fold(Vec3::zero(), |sum, n| sum + n);
        let normal = sum.normalized();
        let mut vertices = mesh.positions.iter();
        let height = |p: Vec3| normal.dot(p - mesh.positions[0]).abs();
        let is_flat = vertices.all(|&p| height(p) <= FLAT * size)
            && normals.into_iter().all(|n| n.dot(normal) >= 0.0);
        let extent = match is_flat {
            true => Extent::Flat {
                hull: flat_hull(&mesh.positions, normal),
                normal,
            },
            false => Extent::Ball {
                centre,
                radius: mesh
                    .positions
                    .iter()
                    .map(|&p| (p - centre).length())
                    .fold(0.0, f64::max),
            },
        };
        Self {
            emitter,
            extent,
            ball: (centre, 0.5 * size),
        }
    }

    /// About the squared tangent of half the angle under which it is seen.
    pub fn tan2(&self, viewpoint: Vec3) -> f64 {
        let (centre, radius) = self.ball;
        radius * radius / (centre - viewpoint).length_squared()
    }

    /// Its bounds.
    pub fn extent(&self) -> &Extent {
        &self.extent
    }

    /// What a viewpoint sees of it; `None` if only its back.
    pub fn window(&self, viewpoint: Vec3) -> Option<Window> {
        let mut in_front_of = None;
        let (axis, max_angle, planes) = match &self.extent {
            Extent::Flat { hull, normal } => {
                let offsets: Vec<Vec3> = hull.iter().map(|&p| p - viewpoint).collect();
                if normal.dot(offsets[0]) >= 0.0 {
                    return None;
                }
                let size = |p: &Vec3| (*p - hull[0]).length();
                let size = hull.iter().map(size).fold(0.0, f64::max);
                in_front_of = Some(HalfSpace {
                    point: hull[0] - *normal * (MARGIN * size),
                    normal: *normal,
                });
                let corners = offsets.iter().map(|p| p.normalized());
                let axis = corners.clone().fold(Vec3::zero(), |sum, c| sum + c);
                let axis = axis.normalized();
                let widest = corners.map(|c| sphere::angle_between(axis, c));
                // Counterclockwise around the normal, which points to the viewpoint.
                let next = offsets.iter().cycle().skip(1);
                let sides = offsets.iter().zip(next);
                let planes = sides.map(|(a, b)| b.cross(*a).normalized()).collect();
                (axis, widest.fold(0.0, f64::max) + MARGIN, planes)
            }
            Extent::Ball { centre, radius } => {
                let offset = *centre - viewpoint;
                let axis = offset.normalized();
                let angle = (radius / offset.length()).asin() + MARGIN;
                let (sin, cos) = angle.sin_cos();
                let Frame { s, t, .. } = Frame::from_normal(axis);
                let planes = [s, -s, t, -t].map(|side| axis * sin + side * cos);
                (axis, angle, planes.to_vec())
            }
        };
        // Not for NaN: from inside there is no such cone.
        let is_narrow = max_angle < FRAC_PI_2;
        let all = (Vec3::new(0.0, 0.0, 1.0), PI);
        let (axis, max_angle) = if is_narrow { (axis, max_angle) } else { all };
        Some(Window {
            cone: ConeQuery {
                apex: viewpoint,
                axis,
                max_angle,
                edges: EdgeSelection::Silhouettes,
                groups: SEEN,
                in_front_of,
            },
            planes: match (&self.extent, is_narrow) {
                (Extent::Ball { .. }, false) => Vec::new(),
                _ => planes,
            },
        })
    }
}

/// The corners of the convex hull of points in a plane, or of a rectangle around
/// it, counterclockwise around the normal.
fn flat_hull(points: &[Vec3], normal: Vec3) -> Vec<Vec3> {
    let Frame { s, t, .. } = Frame::from_normal(normal);
    let origin = points[0];
    let mut flat: Vec<[f64; 2]> = points
        .iter()
        .map(|&p| [(p - origin).dot(s), (p - origin).dot(t)])
        .collect();
    flat.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    // Andrew's monotone chain: the lower half, then the upper one.
    let turns_left = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])
    };
    let mut hull: Vec<[f64; 2]> = Vec::new();
    let mut add = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let first = hull.len();
        for point in points {
            while hull.len() >= first + 2
                && !turns_left(hull[hull.len() - 2], hull[hull.len() - 1], point)
            {
                hull.pop();
            }
            hull.push(point);
        }
        hull.pop(); // the next half starts with it
    };
    add(&mut flat.iter().copied());
    add(&mut flat.iter().rev().copied());
    if hull.len() > MANY_CORNERS {
        let low = [0, 1].map(|i| flat.iter().map(|p| p[i]).fold(f64::INFINITY, f64::min));
        let high = [0, 1].map(|i| flat.iter().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max));
        hull = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
    }
    let place = |[x, y]: [f64; 2]| origin + s * x + t * y;
    hull.into_iter().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::silhouette_pieces::clip;
    use capwalk_math::Affine;
    use capwalk_scene::primitive::{cube, disk, rectangle, sphere as ball};

    /// Whatever is seen of an emitter's front is seen through its window, and a flat
    /// emitter of few corners fills it.
    #[test]
    fn emitters_are_seen_through_their_windows() {
        let place = Affine::translate(Vec3::new(0.3, -0.2, 1.5))
            * Affine::rotate(Vec3::new(1.0, 0.4, -0.2), 2.6)
            * Affine::scale(Vec3::new(0.8, 0.5, 0.7));
        let triangle = Mesh {
            positions: [[0.0, 0.0, 2.0], [1.0, 0.2, 2.1], [0.3, 1.0, 1.8]]
                .map(Vec3::from)
                .to_vec(),
            faces: vec![[0, 2, 1]],
        };
        let meshes = [
            (rectangle(place).0, Some(4)),
            (triangle, Some(3)),
            (disk(place).0, Some(4)),
            (cube(place).0, None),
            (ball(place, Vec3::zero(), 0.6).0, None),
        ];
        for (mesh, corners) in meshes {
            let emitter = AreaEmitter::new(EmitterId(0), &mesh);
            let found = match &emitter.extent {
                Extent::Flat { hull, .. } => Some(hull.len()),
                Extent::Ball { .. } => None,
            };
            assert_eq!(found, corners);
            let mut seen = 0;
            for i in 0..200 {
                let number = |k: i32| (f64::from(i * 7 + k) * 12.9898).sin() * 2.5;
                let viewpoint = Vec3::new(number(1), number(2), number(3));
                for face in 0..mesh.faces.len() {
                    let [a, b, c] = mesh.corners(face).map(|p| p - viewpoint);
                    let is_front = (b - a).cross(c - a).dot(a) < 0.0;
                    if !is_front {
                        continue;
                    }
                    seen += 1;
                    let window = emitter.window(viewpoint).expect("its front is seen");
                    for p in [a, b, c, (a + b + c) / 3.0] {
                        let angle = sphere::angle_between(p.normalized(), window.cone.axis);
                        assert!(angle <= window.cone.max_angle);
                        let least = window.planes.iter().map(|n| n.dot(p.normalized()));
                        assert!(least.fold(1.0, f64::min) > -1e-12);
                    }
                    // Its edges lie on its border, and count.
                    assert_eq!(clip(&window.planes, 1e-9, [a, b]), Some([0.0, 1.0]));
                }
            }
            assert!(seen > 50, "{seen}");
        }
    }

    /// The part of a segment between two planes.
    #[test]
    fn segments_are_clipped() {
        let diagonal = 0.5_f64.sqrt();
        let planes = [[diagonal, 0.0, diagonal], [-diagonal, 0.0, diagonal]].map(Vec3::from);
        let segment = [[-2.0, 0.3, 1.0], [2.0, 0.3, 1.0]].map(Vec3::from);
        let [from, to] = clip(&planes, 0.0, segment).expect("in the middle");
        assert!(
            (from - 0.25).abs() < 1e-8 && (to - 0.75).abs() < 1e-8,
            "{from} {to}"
        );
        assert!(clip(&planes, 0.0, [segment[0], segment[0]]).is_none());
        assert!(clip(&planes, 0.0, segment.map(|p| -p)).is_none());
    }

    /// A ball has no share only if no point of it is in the window, and all balls around points in it have one.
    #[test]
    fn what_is_in_a_window_has_a_share() {
        let place = Affine::translate(Vec3::new(0.3, -0.2, 1.5))
            * Affine::rotate(Vec3::new(1.0, 0.4, -0.2), 2.6)
            * Affine::scale(Vec3::new(0.8, 0.5, 0.7));
        let meshes = [
            rectangle(place).0,
            disk(place).0,
            ball(place, Vec3::zero(), 0.6).0,
        ];
        let number = |i: u32, k: u32| (f64::from(i * 7 + k) * 0.618_033_988_749_895).fract();
        let mut without = 0;
        for mesh in meshes {
            let emitter = AreaEmitter::new(EmitterId(0), &mesh);
            let mut windows = 0;
            for i in 0..4000 {
                let viewpoint = Vec3::from([0, 1, 2].map(|k| 4.0 * number(i, k) - 2.0));
                let Some(window) = emitter.window(viewpoint) else {
                    continue;
                };
                windows += 1;
                let radius = number(i, 3).powi(3);
                let corner = mesh.positions[i as usize % mesh.positions.len()];
                let middle = mesh.positions.iter().fold(Vec3::zero(), |sum, &p| sum + p);
                let middle = middle / mesh.positions.len() as f64;
                // On the way to a point of the emitter, and beside it by up to three times that.
                let seen = viewpoint + (corner * 0.9 + middle * 0.1 - viewpoint) * number(i, 4);
                let centre = seen + (middle - corner).normalized() * (radius * 3.0 * number(i, 5));
                let share = window.share(centre, radius);
                assert!((0.0..=1.0).contains(&share), "{share}");
                without += u32::from(share == 0.0);
                let touches = (centre - seen).length() <= radius;
                assert!(share > 0.0 || !touches, "{i}: {share}");
            }
            assert!(windows > 1000, "{windows}");
        }
        assert!(without > 100, "{without}");
    }
}
