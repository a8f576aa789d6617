//! Directions beside an edge, in which its discontinuity is looked at.

use std::f64::consts::TAU;

use capwalk_geometry::Ray;
use capwalk_math::{Frame, Vec3};

use crate::accel::Accel;

/// Angle between an edge and the rays that are traced beside it, radians: a million times
/// the rounding of directions, and far less than the distance between edges that differ
/// by the single precision of mesh files. The integrand is evaluated this far from its
/// discontinuity, which changes the boundary term by a fraction of this size.
pub const BESIDE: f64 = 1e-10;

/// From what rays beside an edge hit, the least distance to the other surface there, in units of
/// [`Accel::horizon_distance`], where paths go on: rays from surfaces, and behind those that let them
/// through, miss what is nearer than one unit.
const APART: f64 = 2.0;
/// The largest angle that is taken for that, radians, which changes the boundary term by a fraction of
/// this size. A wedge for which it is not enough, narrower than 0.1° in a scene 10⁵ times as wide as the
/// edge is far, is looked at as if its surfaces did not meet.
const WIDEST: f64 = 1e-2;
/// How far around a point of an edge surfaces are looked for that meet there, radians.
const AROUND: f64 = 1e-5;
/// Sine of the angle between two surfaces below which they count as one.
const ALIKE: f64 = 1e-7;

/// Unit directions on either side of an edge that is seen in the direction `q`:
/// against the normal of the plane through the viewpoint and the edge, and along it.
pub fn beside(q: Vec3, normal: Vec3) -> [Vec3; 2] {
    at_angle(BESIDE, q, normal)
}

/// Unit directions on either side of an edge for paths that go on: so far from the edge that a ray from
/// one of the surfaces that meet there, or through it, hits the other. The edge lies between `a` and
/// `b`; its point is that part of the way from `a`, and seen in the direction `q` at a distance, world
/// units.
pub(crate) fn beside_for_paths(
    accel: &Accel,
    [a, b]: [Vec3; 2],
    [part, distance]: [f64; 2],
    [q, normal]: [Vec3; 2],
) -> [Vec3; 2] {
    let least = APART * accel.horizon_distance();
    let surfaces = surfaces_at(accel, a + (b - a) * part, b - a, distance * AROUND);
    let wedge_sine = narrowest(&surfaces);
    let [alone, in_wedge] = [1.0, wedge_sine].map(|sine| (least / distance / sine).max(BESIDE));
    let angle = match in_wedge <= WIDEST {
        true => in_wedge,
        false => alone.min(WIDEST),
    };
    at_angle(angle, q, normal)
}

/// The surfaces that meet at a point of a line, up to a distance `reach` from there (world units), or as
/// near as rays can tell: a face of each, and the unit direction in which it leaves the point, at right
/// angles to the line.
pub(crate) fn surfaces_at(accel: &Accel, point: Vec3, along: Vec3, reach: f64) -> Vec<(u32, Vec3)> {
    let reach = reach.max(10.0 * APART * accel.horizon_distance());
    // Walk around the edge, along a triangle that has the point in its middle.
    let frame = Frame::from_normal(along.normalized());
    let corner = |i: u32| {
        let (sin, cos) = (f64::from(i) * TAU / 3.0).sin_cos();
        point + (frame.s * cos + frame.t * sin) * (2.0 * reach)
    };
    let mut found = Vec::new();
    for i in 0..3 {
        // A little beyond the corners, which surfaces may pass exactly.
        let side = corner(i + 1) - corner(i);
        let mut ray = Ray {
            t_max: 1.02,
            ..Ray::new(corner(i) - side * 0.01, side)
        };
        while let Some(hit) = accel.rays().first_hit(&ray) {
            ray.t_min = hit.t + ALIKE;
            // Leave out what passes by.
            let cross = accel.mesh.face_cross(hit.face as usize).normalized();
            let offset = ray.at(hit.t) - point;
            if cross.dot(offset).abs() <= APART * accel.horizon_distance() {
                let direction = cross.cross(frame.n).normalized();
                found.push((hit.face, direction * direction.dot(offset).signum()));
            }
        }
    }
    found
}

/// Sine of the smallest angle between [`surfaces_at`] a point; 1 if all are right or obtuse. Surfaces
/// in one plane count as one.
fn narrowest(surfaces: &[(u32, Vec3)]) -> f64 {
    let mut least = 1.0_f64;
    for (i, &(_, first)) in surfaces.iter().enumerate() {
        for &(_, second) in &surfaces[..i] {
            let sine = first.cross(second).length();
            if first.dot(second) > 0.0 && sine > ALIKE {
                least = least.min(sine);
            }
        }
    }
    least
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

    /// Beside the line in which a leaf crosses a floor that is much wider, or lies on it, from what a
    /// ray hits, the shortest ray to the other surface meets it.
    #[test]
    fn rays_from_one_surface_meet_the_other() {
        let viewpoint = Vec3::new(0.3, -3.0, 2.0);
        for (degrees, lies) in [1.0_f64, 3.0, 30.0, 60.0]
            .map(|d| [(d, false), (d, true)])
            .concat()
        {
            let turn = Affine::rotate(Vec3::new(1.0, 0.1, 0.0), degrees.to_radians());
            // Its border is then on the axis.
            let along = Affine::rotate(Vec3::new(0.0, 0.0, 1.0), 0.1_f64.atan());
            let from_axis = Affine::translate(Vec3::new(0.0, f64::from(u8::from(lies)), 0.0));
            let (leaf, _) = rectangle(turn * along * Affine::scale(Vec3::splat(0.5)) * from_axis);
            let (floor, _) = rectangle(Affine::scale(Vec3::new(300.0, 310.0, 1.0)));
            let accel = scene_of([leaf, floor]);
            let boundaries = Boundaries::new(&accel);
            let mut pieces = SilhouettePieces::default();
            let is_on_floor = |p: Vec3| p.z.abs() < 1e-12 && p.length() < 1.0;
            for edge in 0..boundaries.edges().len() as u32 {
                if boundaries.ends(edge).into_iter().all(is_on_floor) {
                    pieces.push(&boundaries, edge, [0.1, 0.9], 1.0);
                }
            }
            assert!(pieces.count() > 0, "{degrees}, {lies}");
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
                    // The line passes through the origin, and so do both planes.
                    let height = other.dot(ray.at(hit.t));
                    // A leaf that ends there is nowhere above what is beside it.
                    if !(lies && shape == 1) {
                        let across = accel.first_hit(ray.at(hit.t), other * -height.signum());
                        let across = across.map(|hit| accel.shape_of(&hit).0);
                        assert_eq!(across, Some(1 - shape), "{degrees}, {lies}: {height:e}");
                    }
                    shape
                });
                seen.sort_unstable();
                assert_eq!(seen, [0, 1], "{degrees}, {lies}");
            }
        }
    }

    /// The angle at the fold of two triangles, in all directions around it, also those in which a side
    /// of the walk around it ends exactly; that of a wide one does not count.
    #[test]
    fn folds_have_the_angle_between_their_faces() {
        let folds = [(30.0_f64, 0.5), (150.0, 1.0), (210.0, 1.0), (330.0, 0.5)];
        for ((degrees, sine), turn) in folds
            .map(|fold| (0..24).map(move |i| (fold, i)))
            .into_iter()
            .flatten()
        {
            let at = |degrees: f64, y: f64| {
                let (sin, cos) = (degrees + 15.0 * f64::from(turn)).to_radians().sin_cos();
                Vec3::new(cos, y, sin)
            };
            let ends = [Vec3::new(0.0, 1.0, 0.0), Vec3::zero()];
            let mesh = Mesh {
                positions: vec![ends[0], ends[1], at(0.0, 0.2), at(degrees, 0.3)],
                faces: vec![[0, 1, 2], [1, 0, 3]],
            };
            let accel = scene_of([mesh]);
            let surfaces = surfaces_at(&accel, ends[0] * 0.3, ends[0], 1e-4);
            let found = narrowest(&surfaces);
            assert!(
                (found - sine).abs() < 1e-12,
                "{degrees}, {turn}: {surfaces:?}"
            );
        }
    }
}
