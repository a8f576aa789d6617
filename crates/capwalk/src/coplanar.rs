//! Faces of different shapes that lie on each other and move against each other: there, an
//! image has no derivative. A flat emitter is in front of what lies in its plane, and may
//! slide and grow within it.

use std::collections::BTreeSet;

use capwalk_math::Vec3;
use capwalk_math::near_key::near_key;
use capwalk_scene::{Mesh, Scene, Tangent};

/// Part of the largest coordinate up to which planes may be the same: more than rounding.
pub const SAME_PLANE: f64 = 1e-9;

/// Part of the largest coordinate by which faces overlap that do not only touch.
const OVERLAP: f64 = 1e-7;

/// Faces that are nearer to the origin than the farthest ones by this factor are compared among
/// themselves with tolerances of their own.
const NEARER: f64 = 1.0 / 4096.0;

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
    /// Largest coordinate of its corners.
    size: f64,
    /// [`Face::key`] at the scale that is looked at.
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
    let mut faces = faces(scene, tangent);
    let mut pairs = 0;
    // The largest with all others, then the largest of these with the rest, and so on: what is
    // rounding in a wide plane is none between small things.
    while !faces.is_empty() {
        let sizes = faces.iter().map(|face| face.size);
        let scale = sizes.fold(f64::MIN_POSITIVE, f64::max);
        let is_far = |face: &Face| face.size >= scale * NEARER;
        // Sort by planes: faces of one plane are neighbours then.
        faces.iter_mut().for_each(|face| face.key = face.key(scale));
        faces.sort_unstable_by(|a, b| a.key.total_cmp(&b.key));
        for plane in faces.chunk_by_mut(|a, b| b.key - a.key <= SAME_PLANE) {
            if plane.iter().all(|face| face.shape == plane[0].shape) {
                continue;
            }
            let is_complete = visit_overlaps(plane, is_far, |before, next| {
                let mut pair = [before.shape, next.shape];
                pair.sort_unstable();
                if !found.contains(&pair)
                    && before.moves_against(next)
                    && before.overlaps(next, OVERLAP * before.size.max(next.size))
                {
                    found.insert(pair);
                }
                pairs += 1;
                pairs <= MOST_PAIRS
            });
            if !is_complete {
                return found;
            }
        }
        faces.retain(|face| !is_far(face));
    }
    found
}

/// Calls `visit` with the pairs of faces of different shapes, in one plane, of which one is far and
/// which may overlap, until it answers `false`; then the answer is that.
fn visit_overlaps(
    plane: &mut [Face],
    is_far: impl Fn(&Face) -> bool,
    mut visit: impl FnMut(&Face, &Face) -> bool,
) -> bool {
    // Along the sweep, compare each face with those that have not ended before it starts.
    plane.sort_unstable_by(|a, b| a.range[0].total_cmp(&b.range[0]));
    let (mut far, mut near): (Vec<&Face>, Vec<&Face>) = (Vec::new(), Vec::new());
    for next in &*plane {
        let is_open = |before: &&Face| before.range[1] > next.range[0];
        far.retain(is_open);
        // Pairs of small things have their turn later.
        if is_far(next) {
            near.retain(is_open);
        }
        let others = far.iter().chain(near.iter().filter(|_| is_far(next)));
        let mut others = others.filter(|before| before.shape != next.shape);
        if !others.all(|before| visit(before, next)) {
            return false;
        }
        match is_far(next) {
            true => far.push(next),
            false => near.push(next),
        }
    }
    true
}

fn faces(scene: &Scene, tangent: &Tangent) -> Vec<Face> {
    let mut emitters = vec![false; scene.shapes.len()];
    for shape in scene.emitters.iter().filter_map(|emitter| emitter.shape()) {
        emitters[shape.0 as usize] = true;
    }
    let shapes = scene.shapes.iter().zip(&tangent.shapes).enumerate();
    let faces = shapes.flat_map(|(shape, (what, velocities))| {
        let mesh = &what.mesh;
        let is_flush = emitters[shape] && is_flat(mesh);
        mesh.faces.iter().filter_map(move |face| {
            let corners = face.map(|i| mesh.positions[i as usize]);
            let velocities = face.map(|i| match velocities {
                Some(vectors) => vectors.vertices[i as usize],
                None => Vec3::zero(),
            });
            let face = Face::new(shape, corners, velocities)?;
            Some(Face { is_flush, ..face })
        })
    });
    faces.collect()
}

/// True if all vertices of a mesh are in the plane of its first face with area.
fn is_flat(mesh: &Mesh) -> bool {
    let margin = SAME_PLANE * mesh.positions.iter().map(largest).fold(0.0, f64::max);
    let crosses = (0..mesh.faces.len()).map(|face| (face, mesh.face_cross(face)));
    let first = crosses.into_iter().find(|(_, n)| n.length() > 0.0);
    first.is_some_and(|(face, cross)| {
        let (corner, normal) = (mesh.corners(face)[0], cross.normalized());
        let mut positions = mesh.positions.iter();
        positions.all(|&p| normal.dot(p - corner).abs() <= margin)
    })
}

/// The largest coordinate.
pub fn largest(p: &Vec3) -> f64 {
    p.x.abs().max(p.y.abs()).max(p.z.abs())
}

impl Face {
    /// `None` for a face without area.
    fn new(shape: usize, corners: [Vec3; 3], velocities: [Vec3; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let cross = (b - a).cross(c - a);
        let area = cross.length();
        if area == 0.0 {
            return None;
        }
        let n = cross / area;
        let along = corners.map(|p| p.dot(DIRECTION));
        Some(Self {
            shape,
            corners,
            velocities,
            is_flush: false,
            normal: n,
            size: corners.iter().map(largest).fold(0.0, f64::max),
            key: 0.0,
            range: [
                along.into_iter().fold(f64::INFINITY, f64::min),
                along.into_iter().fold(f64::NEG_INFINITY, f64::max),
            ],
        })
    }

    /// Equal for faces in one plane, and for hardly any others, up to [`SAME_PLANE`] of `scale`.
    fn key(&self, scale: f64) -> f64 {
        let n = self.normal;
        // Both signs of the normal give the same plane.
        let foot = n * (n.dot(self.corners[0]) / scale);
        near_key(&[
            n.x * n.x,
            n.y * n.y,
            n.x * n.y,
            n.y * n.z,
            n.z * n.x,
            n.z * n.z,
            foot.x,
            foot.y,
            foot.z,
        ])
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

    /// True if points of one move on the other; if one of them is in front of the
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

    /// The number of pairs that are found over another shape.
    fn found_beside(under: &str, place: Affine, expression: &str) -> usize {
        found_in(under, place, expression, |_| {})
    }

    /// The number of pairs that are found in a changed scene.
    fn found_in(
        under: &str,
        place: Affine,
        expression: &str,
        change: impl Fn(&mut Scene),
    ) -> usize {
        let mut scene = capwalk_scene::builtin::scene("leaf").unwrap();
        change(&mut scene);
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

    /// Small things beside a wide one: planes that are apart stay so, and those that are one are found.
    #[test]
    fn small_shapes_are_told_apart_in_wide_scenes() {
        let at = |z| Affine::translate(Vec3::new(0.0, 0.0, z)) * Affine::scale(Vec3::splat(0.1));
        for (height, expected) in [(1e-4, 0), (0.0, 1)] {
            let widen = |scene: &mut Scene| {
                let wall = rectangle(
                    Affine::translate(Vec3::new(3.0, 2e6, 1.0)) * Affine::scale(Vec3::splat(1e6)),
                );
                let bsdf = scene.shapes[0].bsdf;
                let wall = capwalk_scene::Shape::new("wall", wall.0, wall.1, bsdf);
                scene.shapes.push(Arc::new(wall));
            };
            let pairs = found_in("floor", at(height), "leaf.translate.x", widen);
            assert_eq!(pairs, expected, "{height}");
        }
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
