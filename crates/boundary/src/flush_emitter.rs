//! Flat emitters that lie in the plane of another surface, such as an emitter in a ceiling: they
//! are in front of it. Rounding would decide otherwise which of the two a ray meets, and light
//! sampled on the emitter, whose shadow rays end before both, would not be the light that rays
//! find there.

use capwalk_geometry::{Hit, Mesh, Ray, RayTree};
use capwalk_math::Vec3;
use capwalk_scene::{Scene, ShapeId};

/// Distance of a surface from the plane of an emitter up to which it lies in it, as a part of
/// the emitter's size or of the distance from which it is seen. Shadow rays end that much before an
/// emitter.
const IN_PLANE: f64 = 1e-9;
/// The most emitters times vertices for which the planes of emitters are searched for other
/// surfaces. Beyond it all flat emitters count as flush, which costs rays time.
const MOST_COMPARISONS: usize = 1 << 26;

/// The faces of these emitters, and the tree for their rays.
#[derive(Clone, Debug)]
pub struct FlushEmitters {
    tree: RayTree,
    mesh: Mesh,
    /// The number of each face in the joined mesh.
    faces: Vec<u32>,
}

/// The plane of a flat emitter.
struct Plane {
    corner: Vec3,
    normal: Vec3,
    margin: f64,
}

impl FlushEmitters {
    /// The flush emitters of a scene, whose shapes start at these faces of the joined mesh; `None` if there
    /// are none.
    pub fn new(
        scene: &Scene,
        joined: &Mesh,
        shape_of_face: &[ShapeId],
        first_face: &[u32],
    ) -> Option<Self> {
        let shapes = scene
            .emitters
            .iter()
            .filter_map(|emitter| emitter.shape())
            .filter_map(|shape| Some((shape, Plane::of(&scene.shape(shape).mesh)?)));
        let shapes: Vec<(ShapeId, Plane)> = shapes.collect();
        let is_affordable = shapes.len().saturating_mul(joined.positions.len()) <= MOST_COMPARISONS;
        let (mut mesh, mut faces) = (Mesh::default(), Vec::new());
        for (shape, plane) in &shapes {
            if is_affordable && !plane.has_others(*shape, joined, shape_of_face) {
                continue;
            }
            let own = &scene.shape(*shape).mesh;
            mesh.append(own);
            let first = first_face[shape.0 as usize];
            faces.extend(first..first + own.faces.len() as u32);
        }
        (!faces.is_empty()).then(|| Self {
            tree: RayTree::build(&mesh),
            mesh,
            faces,
        })
    }

    /// The hit of an emitter's front at the place where a ray hits something else, if there is
    /// one.
    pub fn in_front(&self, ray: &Ray, hit: &Hit) -> Option<Hit> {
        let near = Ray {
            t_min: ray.t_min.max(hit.t * (1.0 - IN_PLANE)),
            t_max: ray.t_max.min(hit.t * (1.0 + IN_PLANE)),
            ..*ray
        };
        let own = self.tree.first_hit(&near)?;
        let is_front = self.mesh.face_cross(own.face as usize).dot(ray.direction) < 0.0;
        is_front.then(|| Hit {
            face: self.faces[own.face as usize],
            ..own
        })
    }
}

impl Plane {
    /// The plane of a mesh, if it is flat.
    fn of(mesh: &Mesh) -> Option<Self> {
        let (low, high) = mesh.bounds();
        let margin = IN_PLANE * (high - low).length();
        let crosses = (0..mesh.faces.len()).map(|face| mesh.face_cross(face));
        let plane = Self {
            corner: mesh.positions[mesh.faces[0][0] as usize],
            normal: crosses.fold(Vec3::zero(), |sum, n| sum + n).normalized(),
            margin,
        };
        let mut corners = mesh.faces.iter().flatten();
        let is_flat = corners.all(|&i| plane.has(mesh.positions[i as usize]));
        is_flat.then_some(plane)
    }

    /// True for a point in it.
    fn has(&self, point: Vec3) -> bool {
        self.normal.dot(point - self.corner).abs() <= self.margin
    }

    /// True if a face of another shape lies in it.
    fn has_others(&self, shape: ShapeId, joined: &Mesh, shape_of_face: &[ShapeId]) -> bool {
        let mut faces = joined.faces.iter().zip(shape_of_face);
        faces.any(|(corners, &other)| {
            let mut corners = corners.iter().map(|&i| joined.positions[i as usize]);
            other != shape && corners.all(|corner| self.has(corner))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::accel::Accel;

    /// From in front, rays find an emitter in its ceiling wherever brute force finds the emitter alone,
    /// and the ceiling around it, whichever of the two comes first in the scene.
    #[test]
    fn emitters_are_in_front_of_their_ceilings() {
        let lit = capwalk_scene::builtin::scene("leaf").expect("built in");
        let emitter = lit.emitters[0].shape().expect("an emitter");
        for others in 0..2 {
            // The ceiling takes the place of another shape, before the emitter or behind it.
            let mut scene = lit.clone();
            let places = (0..scene.shapes.len()).filter(|&i| i != emitter.0 as usize);
            let place = places.clone().nth(others).expect("two other shapes");
            let own = scene.shape(emitter).mesh.clone();
            let (low, high) = own.bounds();
            let middle = (low + high) * 0.5;
            let ceiling = &mut Arc::make_mut(&mut scene.shapes[place]).mesh;
            *ceiling = own.clone();
            let corners = ceiling.positions.iter_mut();
            corners.for_each(|p| *p = middle + (*p - middle) * 3.0);
            let accel = Accel::new(scene);
            let normal = own.face_cross(0).normalized();
            let origin = middle + normal * 1.3 + (high - middle) * 0.37;
            let mut found = [0; 2];
            for i in 0..1000 {
                let share = |i: usize, step: f64| 3.2 * ((i as f64 * step).fract() - 0.5);
                let [a, b, c] = own.corners(0);
                let sides = (b - a) * share(i, 0.618034) + (c - a) * share(i, 0.754878);
                let ray = Ray::new(origin, (middle + sides - origin).normalized());
                let expected = capwalk_geometry::oracle::first_hit(&own, &ray);
                let Some(hit) = accel.first_hit_within(&ray) else {
                    assert_eq!(expected, None);
                    continue;
                };
                let is_emitter = accel.shape_of(&hit) == emitter;
                assert_eq!(is_emitter, expected.is_some(), "{ray:?}");
                found[usize::from(is_emitter)] += 1;
            }
            assert!(found.into_iter().all(|count| count > 20), "{found:?}");
        }
    }
}
