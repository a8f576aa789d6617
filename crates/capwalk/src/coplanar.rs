//! Faces of different shapes that lie on each other and move against each other: there, an
//! image has no derivative. A flat emitter is in front of what lies in its plane, and may
//! slide and grow within it.

use std::collections::BTreeSet;

use capwalk_math::Vec3;
use capwalk_math::near_key::near_key;
use capwalk_scene::{Mesh, Scene, Tangent};

/// Part of the scene's size up to which planes may be the same: more than rounding.
pub const SAME_PLANE: f64 = 1e-9;

/// Part of the scene's size by which faces overlap that do not only touch.
const OVERLAP: f64 = 1e-7;

/// The axis of the sweep, along no edge that is likely.
const DIRECTION: Vec3 = Vec3::new(0.414213562373, 0.732050807569, 0.236067977500);

/// Pairs of faces that are looked at, at most: beyond that, pairs of shapes may be missed.
const MOST_PAIRS: usize = 1_000_000;

/// A face in its plane.
struct Face {
    shape: usize,
    corners: [Vec3; 3],
    velocities: [Vec3; 3],
    /// True for a face of a flat emitter.
    is_flush: bool,
    /// Unit normal.
    normal: Vec3,
    /// Equal for faces in one plane, and for hardly any others.
    key: f64,
    /// From where to where it is along the axis of the sweep.
    range: [f64; 2],
}

/// Pairs of shapes, by their indices, that have faces in one plane which overlap there and
/// move against each other; within the plane, only if it is up to rounding which is in front.
pub fn coplanar(scene: &Scene, tangent: &Tangent) -> BTreeSet<[usize; 2]> {
    let mut found = BTreeSet::new();
    // Without motion of shapes nothing moves against anything.
    if tangent.shapes.iter().all(Option::is_none) {
        return found;
    }
    let positions = || scene.shapes.iter().flat_map(|shape| &shape.mesh.positions);
    let size = |p: &Vec3| p.x.abs().max(p.y.abs()).max(p.z.abs());
    let scale = positions().map(size).fold(f64::MIN_POSITIVE, f64::max);
    // Sort by planes: faces of one plane are neighbours then.
    let mut faces = faces(scene, tangent, scale);
    faces.sort_unstable_by(|a, b| a.key.total_cmp(&b.key));
    let mut pairs = 0;
    for plane in faces.chunk_by_mut(|a, b| b.key - a.key <= SAME_PLANE) {
        if plane.iter().all(|face| face.shape == plane[0].shape) {
            continue;
        }
        // In each plane, compare each face with those that have not ended before it starts.
        plane.sort_unstable_by(|a, b| a.range[0].total_cmp(&b.range[0]));
        let mut open: Vec<&Face> = Vec::new();
        for next in &*plane {
            open.retain(|before| before.range[1] > next.range[0]);
            for before in open.iter().filter(|before| before.shape != next.shape) {
                let mut pair = [before.shape, next.shape];
                pair.sort_unstable();
                pairs += 1;
                if pairs > MOST_PAIRS {
                    return found;
                }
                if !found.contains(&pair)
                    && before.moves_against(next)
                    && before.overlaps(next, OVERLAP * scale)
                {
                    found.insert(pair);
                }
            }
            open.push(next);
        }
    }
    found
}

fn faces(scene: &Scene, tangent: &Tangent, scale: f64) -> Vec<Face> {
    let mut emitters = vec![false; scene.shapes.len()];
    for shape in scene.emitters.iter().filter_map(|emitter| emitter.shape()) {
        emitters[shape.0 as usize] = true;
    }
    let shapes = scene.shapes.iter().zip(&tangent.shapes).enumerate();
    let faces = shapes.flat_map(|(shape, (what, velocities))| {
        let mesh = &what.mesh;
        let is_flush = emitters[shape] && is_flat(mesh, SAME_PLANE * scale);
        mesh.faces.iter().filter_map(move |face| {
            let corners = face.map(|i| mesh.positions[i as usize]);
            let velocities = face.map(|i| match velocities {
                Some(vectors) => vectors.vertices[i as usize],
                None => Vec3::zero(),
            });
            let face = Face::new(shape, corners, velocities, scale)?;
            Some(Face { is_flush, ..face })
        })
    });
    faces.collect()
}

/// True if all vertices of a mesh are that close to the plane of its first face with area.
fn is_flat(mesh: &Mesh, margin: f64) -> bool {
    let crosses = (0..mesh.faces.len()).map(|face| (face, mesh.face_cross(face)));
    let first = crosses.into_iter().find(|(_, n)| n.length() > 0.0);
    first.is_some_and(|(face, cross)| {
        let (corner, normal) = (mesh.corners(face)[0], cross.normalized());
        let mut positions = mesh.positions.iter();
        positions.all(|&p| normal.dot(p - corner).abs() <= margin)
    })
}

impl Face {
    /// `None` for a face without area.
    fn new(shape: usize, corners: [Vec3; 3], velocities: [Vec3; 3], scale: f64) -> Option<Self> {
        let [a, b, c] = corners;
        let cross = (b - a).cross(c - a);
        let area = cross.length();
        if area == 0.0 {
            return None;
        }
        let n = cross / area;
        // Both signs of the normal give the same plane.
        let foot = n * (n.dot(a) / scale);
        let numbers = [
            n.x * n.x,
            n.y * n.y,
            n.x * n.y,
            n.y * n.z,
            n.z * n.x,
            n.z * n.z,
            foot.x,
            foot.y,
            foot.z,
        ];
        let along = corners.map(|p| p.dot(DIRECTION));
        Some(Self {
            shape,
            corners,
            velocities,
            is_flush: false,
            normal: n,
            key: near_key(&numbers),
            range: [
                along.into_iter().fold(f64::INFINITY, f64::min),
                along.into_iter().fold(f64::NEG_INFINITY, f64::max),
            ],
        })
    }

    /// The velocity of a point of its plane that moves with it.
    fn velocity(&self, point: Vec3) -> Vec3 {
        let [a, b, c] = self.corners;
        let twice = |p: Vec3, q: Vec3, r: Vec3| self.normal.dot((q - p).cross(r - p));
        let whole = twice(a, b, c);
        let weights = [twice(point, b, c), twice(a, point, c), twice(a, b, point)];
        let sum = self.velocities.iter().zip(weights);
        sum.fold(Vec3::zero(), |sum, (&v, w)| sum + v * (w / whole))
    }

    /// True if points of one are not at rest on the other; if one of them is in front of the
    /// other, if they leave its plane.
    fn moves_against(&self, other: &Self) -> bool {
        let speeds = self.velocities.iter().chain(&other.velocities);
        let fastest = speeds.map(|v| v.length()).fold(0.0, f64::max);
        let mut corners = self.corners.iter().zip(self.velocities);
        let has_order = self.is_flush != other.is_flush;
        corners.any(|(&p, v)| {
            let against = other.velocity(p) - v;
            let speed = match has_order {
                true => self.normal.dot(against).abs(),
                false => against.length(),
            };
            speed > 1e-6 * fastest
        })
    }

    /// True if no line along an edge separates them, up to this distance.
    fn overlaps(&self, other: &Self, distance: f64) -> bool {
        let edges = |face: &Self| {
            let [a, b, c] = face.corners;
            [b - a, c - b, a - c]
        };
        let lines = edges(self).into_iter().chain(edges(other));
        let mut across = lines.map(|edge| self.normal.cross(edge).normalized());
        across.all(|axis| {
            let range = |face: &Self| {
                let along = face.corners.map(|p| p.dot(axis));
                let least = along.into_iter().fold(f64::INFINITY, f64::min);
                (least, along.into_iter().fold(f64::NEG_INFINITY, f64::max))
            };
            let ((low, high), (other_low, other_high)) = (range(self), range(other));
            high.min(other_high) - low.max(other_low) > distance
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use capwalk_math::Affine;
    use capwalk_scene::params::Registry;
    use capwalk_scene::primitive::rectangle;

    use super::*;

    /// The built-in leaf, replaced by a rectangle over the floor that is moved and turned.
    fn found(place: Affine, expression: &str) -> usize {
        found_beside("floor", place, expression)
    }

    /// The same over another shape.
    fn found_beside(under: &str, place: Affine, expression: &str) -> usize {
        let mut scene = capwalk_scene::builtin::scene("leaf").unwrap();
        let floor = scene.shapes.iter().find(|shape| shape.id == under).unwrap();
        let [a, b, c] = floor.mesh.corners(0);
        let ((low, high), normal) = (floor.mesh.bounds(), (b - a).cross(c - a).normalized());
        assert!((high - low).length() < 2.0 * BESIDE - 1.0);
        let to_floor = Affine::translate((low + high) * 0.5);
        let leaf = scene
            .shapes
            .iter_mut()
            .find(|shape| shape.id == "leaf")
            .unwrap();
        let mut mesh = rectangle(place).0;
        let frame = capwalk_math::Frame::from_normal(normal);
        for p in &mut mesh.positions {
            *p = to_floor.point(frame.s * p.x + frame.t * p.y + normal * p.z);
        }
        Arc::make_mut(leaf).mesh = mesh;
        let tangent = Registry::new(&scene).tangent(&scene, expression).unwrap();
        coplanar(&scene, &tangent).len()
    }

    /// Farther from the middle of the floor than its corners.
    const BESIDE: f64 = 20.0;

    #[test]
    fn shapes_on_each_other_are_found() {
        let at = |x, z| Affine::translate(Vec3::new(x, 0.0, z)) * Affine::scale(Vec3::splat(0.1));
        let turned = at(0.03, 0.0) * Affine::rotate(Vec3::new(0.0, 0.0, 1.0), 0.4);
        for motion in [
            "leaf.translate.x",
            "leaf.translate.y",
            "leaf.rotate.z",
            "floor.translate.z",
        ] {
            assert_eq!(found(turned, motion), 1, "{motion}");
        }
        // Above it, beside it, turned out of its plane, and moved with it or not at all.
        assert_eq!(found(at(0.0, 1e-4), "leaf.translate.x"), 0);
        for i in 0..16 {
            let (sin, cos) = f64::from(i).sin_cos();
            let beside = Affine::translate(Vec3::new(cos, sin, 0.0) * BESIDE) * at(0.0, 0.0);
            assert_eq!(found(beside, "leaf.translate.x"), 0, "{i}");
        }
        let tilted = at(0.0, 0.0) * Affine::rotate(Vec3::new(1.0, 0.0, 0.0), 1e-3);
        assert_eq!(found(tilted, "leaf.translate.x"), 0);
        let together = "leaf.translate.x + floor.translate.x";
        assert_eq!(found(turned, together), 0);
        assert_eq!(found(turned, "floor.bsdf.reflectance.value"), 0);
    }

    /// A flat emitter is in front of what lies in its plane as long as it stays there.
    #[test]
    fn emitters_may_slide_in_their_plane() {
        let place = Affine::scale(Vec3::splat(0.1));
        let pairs = |expression: &str| found_beside("lamp", place, expression);
        for within in ["lamp.translate.x", "lamp.scale", "leaf.translate.x"] {
            assert_eq!(pairs(within), 0, "{within}");
        }
        for out_of_it in [
            "lamp.translate.y",
            "lamp.rotate.x",
            "leaf.translate.x + lamp.rotate.z",
        ] {
            assert_eq!(pairs(out_of_it), 1, "{out_of_it}");
        }
    }
}
