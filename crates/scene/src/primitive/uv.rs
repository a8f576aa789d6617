//! Texture coordinates of the primitives, as Mitsuba 3.9 defines them: those of
//! the corners of each triangle, in the order of the mesh's faces.

use std::f64::consts::PI;

use capwalk_math::{Affine, Vec3};

use super::tessellated::{
    LastDivision, ROUND_SEGMENTS, SPHERE_DIVISION, cube, rectangle, turned_icosphere,
};

/// Texture coordinates of the three corners of each face.
pub type FaceUvs = Vec<[[f64; 2]; 3]>;

/// Texture coordinates of [`super::rectangle`]: from (0, 0) to (1, 1) along x and y.
pub fn rectangle_uvs(world_from_object: Affine) -> FaceUvs {
    let (mesh, _) = rectangle(Affine::IDENTITY);
    let faces = (0..mesh.faces.len()).map(|face| {
        let corners = mesh.corners(face);
        corners.map(|p| [0.5 * (p.x + 1.0), 0.5 * (p.y + 1.0)])
    });
    wound(faces.collect(), world_from_object)
}

/// Texture coordinates of [`super::cube`]: the unit square on each side. Mitsuba turns it
/// from side to side; the table is that of its `cube.cpp`.
pub fn cube_uvs(world_from_object: Affine) -> FaceUvs {
    // For the sides -x, +x, -y, +y, -z, +z in the order of our faces: the
    // corners at (0, 1), (1, 1), (1, 0) and (0, 0).
    let corners_of_side = [
        [4, 6, 2, 0],
        [1, 3, 7, 5],
        [1, 5, 4, 0],
        [3, 2, 6, 7],
        [3, 1, 0, 2],
        [5, 7, 6, 4],
    ];
    let square = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let (mesh, _) = cube(Affine::IDENTITY);
    let faces = mesh.faces.iter().enumerate().map(|(face, corners)| {
        let of_side: [u32; 4] = corners_of_side[face / 2];
        corners.map(|corner| {
            let place = of_side.iter().position(|&c| c == corner);
            square[place.expect("the corner is on its side")]
        })
    });
    wound(faces.collect(), world_from_object)
}

/// Texture coordinates of [`super::disk`]: radius and angle over 2π. Along each of the thin
/// triangles the angle is that of its middle at the centre.
pub fn disk_uvs(world_from_object: Affine) -> FaceUvs {
    let n = f64::from(ROUND_SEGMENTS);
    let faces = (0..ROUND_SEGMENTS).map(f64::from);
    let faces = faces.map(|i| [[0.0, (i + 0.5) / n], [1.0, i / n], [1.0, (i + 1.0) / n]]);
    wound(faces.collect(), world_from_object)
}

/// Texture coordinates of [`super::cylinder`]: azimuth over 2π, and height from 0 to 1.
pub fn cylinder_uvs(world_from_object: Affine) -> FaceUvs {
    let n = f64::from(ROUND_SEGMENTS);
    let sides = (0..ROUND_SEGMENTS).map(f64::from);
    let faces = sides.flat_map(|i| {
        let [low, next] = [i / n, (i + 1.0) / n];
        [
            [[low, 0.0], [next, 0.0], [next, 1.0]],
            [[low, 0.0], [next, 1.0], [low, 1.0]],
        ]
    });
    wound(faces.collect(), world_from_object)
}

/// Texture coordinates of [`super::sphere`]: azimuth over 2π, polar angle over π. Where the
/// azimuth is discontinuous it goes on beyond 1, so that triangles are not torn. Between
/// vertices both are interpolated; the triangles at the poles are too large for
/// that and show their azimuth distorted.
pub fn sphere_uvs() -> FaceUvs {
    divided_sphere_uvs(SPHERE_DIVISION)
}

/// Texture coordinates of [`super::divided_sphere`].
pub fn divided_sphere_uvs(division: u32) -> FaceUvs {
    static LAST: LastDivision<FaceUvs> = LastDivision::none();
    let uvs = LAST.get(division, || {
        let mesh = turned_icosphere(division);
        let vertices: Vec<_> = mesh.positions.iter().map(|&p| spherical(p)).collect();
        let faces = mesh.faces.iter();
        let corners = faces.map(|face| face.map(|vertex| vertices[vertex as usize]));
        corners.map(unwrapped).collect()
    });
    FaceUvs::clone(&uvs)
}

/// These angles, in turns, as close to each other as they can be, none below 0.
pub(super) fn unwrapped(mut corners: [[f64; 2]; 3]) -> [[f64; 2]; 3] {
    let first = corners[0][0];
    for [u, _] in &mut corners[1..] {
        *u -= (*u - first).round();
    }
    if corners.iter().any(|[u, _]| *u < 0.0) {
        corners.iter_mut().for_each(|[u, _]| *u += 1.0);
    }
    corners
}

fn spherical(p: Vec3) -> [f64; 2] {
    let azimuth = p.y.atan2(p.x) / (2.0 * PI);
    [azimuth - azimuth.floor(), p.z.clamp(-1.0, 1.0).acos() / PI]
}

/// Where the map mirrors, the primitives wind their faces the other way.
fn wound(mut uvs: FaceUvs, world_from_object: Affine) -> FaceUvs {
    if world_from_object.determinant() < 0.0 {
        uvs.iter_mut().for_each(|corners| corners.swap(1, 2));
    }
    uvs
}

#[cfg(test)]
mod tests {
    use super::super::{cylinder, disk, sphere};
    use super::*;
    use crate::ids::BsdfId;
    use crate::shape::{ShadingNormals, Shape};
    use capwalk_geometry::oracle::first_hit;
    use capwalk_geometry::{Mesh, Ray};

    /// Texture coordinates where a ray along the map of `direction` from the map of
    /// `origin` meets the shape.
    fn uv_at(
        (mesh, normals): (Mesh, ShadingNormals),
        uvs: FaceUvs,
        world_from_object: Affine,
        (origin, direction): ([f64; 3], [f64; 3]),
    ) -> [f64; 2] {
        let mut shape = Shape::new("shape", mesh, normals, BsdfId(0));
        assert_eq!(uvs.len(), shape.mesh.faces.len());
        shape.uvs = Some(uvs);
        let ray = Ray::new(
            world_from_object.point(origin.into()),
            world_from_object.vector(direction.into()),
        );
        let hit = first_hit(&shape.mesh, &ray).expect("the ray meets the shape");
        let face = hit.face as usize;
        let p = ray.origin + ray.direction * hit.t;
        let [a, b, c] = shape.mesh.corners(face);
        let cross = (b - a).cross(c - a);
        let weight = |x: Vec3, y: Vec3| (x - p).cross(y - p).dot(cross) / cross.length_squared();
        shape.uv(face, [weight(b, c), weight(c, a), weight(a, b)])
    }

    fn mirrored() -> Affine {
        Affine::translate(Vec3::new(1.0, -2.0, 0.5))
            * Affine::rotate(Vec3::new(0.3, 1.0, -0.4), 0.8)
            * Affine::scale(Vec3::new(2.0, 2.0, -2.0))
    }

    /// Rays towards the shapes and what Mitsuba 3.9.1 says of where they end.
    #[test]
    fn primitives_have_the_coordinates_of_mitsuba() {
        let from = |p: [f64; 3], d: [f64; 3]| (p, d);
        let above = from([0.3, 0.2, 5.0], [0.0, 0.0, -1.0]);
        let below = from([0.3, 0.2, -5.0], [0.0, 0.0, 1.0]);
        let right = from([5.0, 0.3, 0.2], [-1.0, 0.0, 0.0]);
        let left = from([-5.0, 0.3, 0.2], [1.0, 0.0, 0.0]);
        let behind = from([0.3, 5.0, 0.2], [0.0, -1.0, 0.0]);
        let front = from([0.3, -5.0, 0.2], [0.0, 1.0, 0.0]);
        let side = from([1.5, 3.1, 0.3], [-0.75, -1.55, 0.0]);
        let disk_uv = [0.36055514, 0.09358355];
        type Place = fn(Affine) -> (Mesh, ShadingNormals);
        let sphere_at = |affine| sphere(affine, Vec3::zero(), 1.0);
        for (shape, uvs, ray, expected, error) in [
            (
                rectangle as Place,
                rectangle_uvs as fn(Affine) -> FaceUvs,
                above,
                [0.65, 0.6],
                1e-12,
            ),
            (rectangle, rectangle_uvs, below, [0.65, 0.6], 1e-12),
            (cube, cube_uvs, above, [0.6, 0.65], 1e-12),
            (cube, cube_uvs, below, [0.4, 0.65], 1e-12),
            (cube, cube_uvs, right, [0.65, 0.4], 1e-12),
            (cube, cube_uvs, left, [0.65, 0.6], 1e-12),
            (cube, cube_uvs, behind, [0.35, 0.4], 1e-12),
            (cube, cube_uvs, front, [0.6, 0.65], 1e-12),
            (disk, disk_uvs, above, disk_uv, 2e-3),
            (cylinder, cylinder_uvs, side, [0.178275, 0.3], 1e-4),
            (
                sphere_at,
                |_| sphere_uvs(),
                above,
                [0.09358355, 0.11741273],
                1e-3,
            ),
            (
                sphere_at,
                |_| sphere_uvs(),
                below,
                [0.09358355, 0.8825873],
                1e-3,
            ),
            (
                sphere_at,
                |_| sphere_uvs(),
                right,
                [0.04952651, 0.43590575],
                1e-3,
            ),
            (
                sphere_at,
                |_| sphere_uvs(),
                left,
                [0.4504735, 0.43590575],
                1e-3,
            ),
            (
                sphere_at,
                |_| sphere_uvs(),
                front,
                [0.7995265, 0.43590575],
                1e-3,
            ),
        ] {
            for map in [Affine::IDENTITY, mirrored()] {
                let uv = uv_at(shape(map), uvs(map), map, ray);
                let distance = (uv[0] - expected[0]).abs().max((uv[1] - expected[1]).abs());
                assert!(distance < error, "{ray:?}: {uv:?}, expected {expected:?}");
            }
        }
    }

    /// No triangle of the sphere reaches around it, but for those at the poles.
    #[test]
    fn the_seam_of_a_sphere_tears_no_triangle() {
        let (mut seam, mut poles) = (0, 0);
        for corners in sphere_uvs() {
            let u = corners.map(|[u, _]| u);
            let (low, high) = (u[0].min(u[1]).min(u[2]), u[0].max(u[1]).max(u[2]));
            assert!(low >= 0.0 && high < 2.0);
            let at_pole = corners.iter().any(|[_, v]| *v < 0.02 || *v > 0.98);
            assert!(high - low < 0.2 || at_pole, "{corners:?}");
            seam += usize::from(high > 1.0);
            poles += usize::from(at_pole);
        }
        assert!(seam > 100 && poles < 200, "{seam} {poles}");
    }
}
