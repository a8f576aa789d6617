//! Directions beside an edge, in which its discontinuity is looked at.

use capwalk_math::Vec3;

/// Angle between an edge and the rays that are traced beside it, radians: a million times
/// the rounding of directions, and far less than the distance between edges that differ
/// by the single precision of mesh files. The integrand is evaluated this far from its
/// discontinuity, which changes the boundary term by a fraction of this size.
pub(crate) const BESIDE: f64 = 1e-10;

/// From what rays beside an edge hit, the least distance to the other surface there, in units of
/// [`Accel::horizon_distance`](crate::Accel::horizon_distance), where paths go on: rays from
/// surfaces, and behind those that let them through, miss what is nearer than one unit.
const APART: f64 = 2.0;
/// The largest angle that is taken for that, radians: far less than a pixel. Surfaces in a wedge of
/// which it is not enough are one, as far as rays can tell.
const WIDEST: f64 = 1e-5;

/// Unit directions on either side of an edge that is seen in the direction `q`:
/// against the normal of the plane through the viewpoint and the edge, and along it.
pub fn beside(q: Vec3, normal: Vec3) -> [Vec3; 2] {
    at_angle(BESIDE, q, normal)
}

/// The same for paths that go on: so far from the edge that a ray from one of the surfaces that meet
/// there, or through it, meets the other. `apart` is the distance within which rays from surfaces miss
/// others, divided by the distance of the edge; `wedge_sine` is the sine of the angle between the
/// surfaces.
pub(crate) fn beside_for_paths(apart: f64, wedge_sine: f64, [q, normal]: [Vec3; 2]) -> [Vec3; 2] {
    let [alone, in_wedge] = [1.0, wedge_sine].map(|sine| (APART * apart / sine).max(BESIDE));
    // False for a wedge of a face without area.
    let angle = match in_wedge <= WIDEST {
        true => in_wedge,
        false => alone.min(WIDEST),
    };
    at_angle(angle, q, normal)
}

fn at_angle(angle: f64, q: Vec3, normal: Vec3) -> [Vec3; 2] {
    [-1.0, 1.0].map(|side| (q + normal * (side * angle)).normalized())
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use capwalk_geometry::{Mesh, Ray};
    use capwalk_math::Affine;
    use capwalk_scene::primitive::rectangle;
    use capwalk_scene::{BsdfId, Scene, Shape, builtin};

    use super::*;
    use crate::{Accel, Boundaries, SilhouettePieces};

    fn scene_of(meshes: impl IntoIterator<Item = Mesh>) -> Accel {
        let mut scene: Scene = builtin::scene("leaf").expect("built in");
        scene.shapes.clear();
        scene.emitters.clear();
        let template = rectangle(Affine::scale(Vec3::splat(1.0)));
        for (i, mesh) in meshes.into_iter().enumerate() {
            let (_, normals) = template.clone();
            let mut shape = Shape::new(format!("{i}"), template.0.clone(), normals, BsdfId(0));
            shape.mesh = mesh;
            scene.shapes.push(Arc::new(shape));
        }
        Accel::new(scene)
    }

    /// Beside the line in which a leaf crosses a floor that is much wider, from what a ray hits, the
    /// shortest ray to the other surface meets it.
    #[test]
    fn rays_from_one_surface_meet_the_other() {
        let viewpoint = Vec3::new(0.3, -3.0, 2.0);
        for degrees in [1.0_f64, 3.0, 30.0, 60.0] {
            let turn = Affine::rotate(Vec3::new(1.0, 0.1, 0.0), degrees.to_radians());
            let (leaf, _) = rectangle(turn * Affine::scale(Vec3::splat(0.5)));
            let (floor, _) = rectangle(Affine::scale(Vec3::new(300.0, 310.0, 1.0)));
            let accel = scene_of([leaf, floor]);
            let boundaries = Boundaries::new(&accel);
            let mut pieces = SilhouettePieces::default();
            let crossings = boundaries.crossings.len();
            for edge in (0..boundaries.edges().len() as u32).rev().take(crossings) {
                pieces.push(edge, [0.1, 0.9], 1.0);
            }
            assert!(pieces.count() > 0);
            for i in 0..20 {
                let u = (f64::from(i) + 0.5) / 20.0;
                let point = pieces.draw(&boundaries, viewpoint, u, |_, _, _| true);
                let sides = point.expect("a piece").sides_of_paths(&boundaries, &accel);
                let mut seen = sides.map(|direction| {
                    let ray = Ray::new(viewpoint, direction);
                    let hit = accel.first_hit_within(&ray).expect("a surface");
                    let shape = accel.shape_of(&hit).0;
                    let other = accel
                        .mesh
                        .face_cross(accel.first_face[1 - shape as usize] as usize);
                    let other = other.normalized();
                    // The crossing passes through the origin, and so do both planes.
                    let height = other.dot(ray.at(hit.t));
                    let across = accel.first_hit(ray.at(hit.t), other * -height.signum());
                    let across = across.map(|hit| accel.shape_of(&hit).0);
                    assert_eq!(across, Some(1 - shape), "{degrees}: {height:e}");
                    shape
                });
                seen.sort_unstable();
                assert_eq!(seen, [0, 1], "{degrees}");
            }
        }
    }

    /// The angle at the fold of two triangles, wound alike or not; that of a wide one does not count.
    #[test]
    fn folds_have_the_angle_between_their_faces() {
        for (degrees, sine) in [(30.0_f64, 0.5), (150.0, 1.0), (210.0, 1.0), (330.0, 0.5)] {
            for second in [[1, 0, 3], [0, 1, 3]] {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let mesh = Mesh {
                    positions: [
                        (0.0, 1.0, 0.0),
                        (0.0, 0.0, 0.0),
                        (1.0, 0.2, 0.0),
                        (cos, 0.3, sin),
                    ]
                    .map(|(x, y, z)| Vec3::new(x, y, z))
                    .to_vec(),
                    faces: vec![[0, 1, 2], second],
                };
                let accel = scene_of([mesh]);
                let boundaries = Boundaries::new(&accel);
                let is_fold = |edge: &u32| boundaries.edge(*edge).vertices.iter().all(|&i| i < 2);
                let edges = 0..boundaries.edges().len() as u32;
                let fold = edges.into_iter().find(is_fold).expect("an edge");
                let found = boundaries.wedge_sine(fold, &accel.mesh);
                assert!((found - sine).abs() < 1e-12, "{degrees}: {found}");
            }
        }
    }
}
