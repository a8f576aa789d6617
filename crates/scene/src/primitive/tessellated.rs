//! Rectangles, cubes, disks, cylinders and spheres of triangles.

use std::f64::consts::PI;
use std::sync::{Arc, Mutex, PoisonError};

use capwalk_geometry::{Mesh, icosphere};
use capwalk_math::{Affine, Vec3};

use crate::shape::ShadingNormals;

/// The largest distance between the silhouette of a tessellated disk, cylinder or
/// sphere and the true one, in radii: a tenth of a pixel for a disk that fills an
/// image of 2000 pixels.
pub const SILHOUETTE_ERROR: f64 = 1e-4;

/// Straight segments around a disk or a cylinder. A regular n-gon is off by `1 - cos(π/n)`;
/// a multiple of four reaches the extreme points along the axes.
pub(super) const ROUND_SEGMENTS: u32 = 224;

/// Triangles of a disk.
pub const DISK_TRIANGLES: u32 = ROUND_SEGMENTS;

/// Triangles of a cylinder.
pub const CYLINDER_TRIANGLES: u32 = 2 * ROUND_SEGMENTS;

/// Subdivision of each icosahedron edge for a sphere, as fine as [`SILHOUETTE_ERROR`] asks for.
pub const SPHERE_DIVISION: u32 = 55;

/// The largest distance between the silhouette of a sphere of this division and the true one, in
/// radii: its faces come closest to the centre next to the middle of an icosahedron face
/// (measured in the tests).
pub fn sphere_error(division: u32) -> f64 {
    0.29 / f64::from(division).powi(2)
}

/// Triangles of a sphere of this division.
pub fn sphere_triangles(division: u32) -> u32 {
    20 * division * division
}

/// The square `[-1, 1]²` in the plane `z = 0`, normal `+z`, then placed.
pub fn rectangle(world_from_object: Affine) -> (Mesh, ShadingNormals) {
    let mesh = Mesh {
        positions: vec![
            Vec3::new(-1.0, -1.0, 0.0),
            Vec3::new(1.0, -1.0, 0.0),
            Vec3::new(1.0, 1.0, 0.0),
            Vec3::new(-1.0, 1.0, 0.0),
        ],
        faces: vec![[0, 1, 2], [0, 2, 3]],
    };
    (placed(mesh, world_from_object), ShadingNormals::Face)
}

/// The cube `[-1, 1]³` with outward normals, then placed. Corner `i` has the
/// signs of the bits of `i`: bit 0 is x, bit 1 is y, bit 2 is z.
pub fn cube(world_from_object: Affine) -> (Mesh, ShadingNormals) {
    let sign = |i: u32, bit: u32| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
    let positions = (0..8).map(|i| Vec3::new(sign(i, 0), sign(i, 1), sign(i, 2)));
    let quads = [
        [0, 4, 6, 2], // -x
        [1, 3, 7, 5], // +x
        [0, 1, 5, 4], // -y
        [2, 6, 7, 3], // +y
        [0, 2, 3, 1], // -z
        [4, 5, 7, 6], // +z
    ];
    let faces = quads
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let mesh = Mesh {
        positions: positions.collect(),
        faces: faces.collect(),
    };
    (placed(mesh, world_from_object), ShadingNormals::Face)
}

/// The unit disk in the plane `z = 0`, normal `+z`, then placed: a fan around
/// its centre, vertex 0.
pub fn disk(world_from_object: Affine) -> (Mesh, ShadingNormals) {
    let mesh = Mesh {
        positions: std::iter::once(Vec3::zero()).chain(circle()).collect(),
        faces: (0..ROUND_SEGMENTS)
            .map(|i| [0, 1 + i, 1 + (i + 1) % ROUND_SEGMENTS])
            .collect(),
    };
    (placed(mesh, world_from_object), ShadingNormals::Face)
}

/// The cylinder of radius 1 around the z axis from `z = 0` to `z = 1`, without lids,
/// normals outward, then placed. Its vertices lie on the true surface and carry its
/// exact normals; where the map mirrors, they stay outside, as in Mitsuba 3.9.
pub fn cylinder(world_from_object: Affine) -> (Mesh, ShadingNormals) {
    let top = circle().map(|p| p + Vec3::new(0.0, 0.0, 1.0));
    let mesh = Mesh {
        positions: circle().chain(top).collect(),
        faces: (0..ROUND_SEGMENTS)
            .flat_map(|i| {
                let next = (i + 1) % ROUND_SEGMENTS;
                let [above, above_next] = [i, next].map(|i| i + ROUND_SEGMENTS);
                [[i, next, above_next], [i, above_next, above]]
            })
            .collect(),
    };
    let normals = circle().chain(circle());
    let normals = normals.map(|n| world_from_object.normal(n).normalized());
    let normals = ShadingNormals::Given(normals.collect());
    (placed(mesh, world_from_object), normals)
}

/// The vertices of a disk's rim, counter-clockwise seen from `+z`.
fn circle() -> impl Iterator<Item = Vec3> {
    (0..ROUND_SEGMENTS).map(|i| {
        let (sin, cos) = (2.0 * PI * f64::from(i) / f64::from(ROUND_SEGMENTS)).sin_cos();
        Vec3::new(cos, sin, 0.0)
    })
}

/// A sphere around an object-space point, then placed (an ellipsoid if the
/// map stretches). Its vertices lie on the true surface and carry its exact
/// normals; the mesh is closed and shares its vertices.
///
/// Where the map mirrors, the sphere turns inside out. The flat shapes do not;
/// both as in Mitsuba 3.9.
pub fn sphere(world_from_object: Affine, centre: Vec3, radius: f64) -> (Mesh, ShadingNormals) {
    divided_sphere(world_from_object, centre, radius, SPHERE_DIVISION)
}

/// A sphere with another division, at least 1.
pub fn divided_sphere(
    world_from_object: Affine,
    centre: Vec3,
    radius: f64,
    division: u32,
) -> (Mesh, ShadingNormals) {
    let mut mesh = Mesh::clone(&turned_icosphere(division));
    let side = world_from_object.determinant().signum();
    let mut normals = Vec::with_capacity(mesh.positions.len());
    for p in &mut mesh.positions {
        let direction = *p;
        *p = world_from_object.point(centre + direction * radius);
        normals.push(world_from_object.normal(direction).normalized() * side);
    }
    (mesh, ShadingNormals::Given(normals))
}

/// The unit sphere. The icosahedron's edges lie in planes of symmetry. Turned at
/// random they do not line up with axes, cameras and emitters. It stays symmetric
/// about its centre, so the bounding box keeps its centre there.
pub(super) fn turned_icosphere(division: u32) -> Arc<Mesh> {
    static LAST: LastDivision<Mesh> = LastDivision::none();
    LAST.get(division, || {
        let mut mesh = icosphere(division);
        let turned = Affine::rotate(Vec3::new(0.36, 0.48, -0.8), 0.7);
        for p in &mut mesh.positions {
            *p = turned.vector(*p);
        }
        mesh
    })
}

/// What was made last for a division: scenes have hundreds of equal spheres.
pub(super) struct LastDivision<T>(Mutex<Option<(u32, Arc<T>)>>);

impl<T> LastDivision<T> {
    /// Nothing yet.
    pub const fn none() -> Self {
        Self(Mutex::new(None))
    }

    /// That for this division, made if it is not the last one.
    pub fn get(&self, division: u32, make: impl FnOnce() -> T) -> Arc<T> {
        // Another thread that panicked while it held the lock has not changed it.
        let mut last = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match &*last {
            Some((known, made)) if *known == division => made.clone(),
            _ => {
                let made = Arc::new(make());
                *last = Some((division, made.clone()));
                made
            }
        }
    }
}

/// The image of a mesh. Where the map mirrors, faces are wound the other way,
/// so that their normals stay on the side they were on.
fn placed(mut mesh: Mesh, world_from_object: Affine) -> Mesh {
    for p in &mut mesh.positions {
        *p = world_from_object.point(*p);
    }
    if world_from_object.determinant() < 0.0 {
        for face in &mut mesh.faces {
            face.swap(1, 2);
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use capwalk_geometry::Sides;
    use capwalk_geometry::topology::{edges, weld};
    use std::collections::HashMap;

    fn stretch() -> Affine {
        Affine::translate(Vec3::new(1.0, -2.0, 0.5))
            * Affine::rotate(Vec3::new(0.3, 1.0, -0.4), 0.8)
            * Affine::scale(Vec3::new(2.0, 0.5, 3.0))
    }

    fn mirrored() -> Affine {
        stretch() * Affine::scale(Vec3::new(1.0, 1.0, -1.0))
    }

    /// Signed volume about the origin, by the divergence theorem.
    fn volume(mesh: &Mesh) -> f64 {
        let six = (0..mesh.faces.len()).map(|face| {
            let [a, b, c] = mesh.corners(face);
            a.dot(b.cross(c))
        });
        six.sum::<f64>() / 6.0
    }

    /// Vertices - edges + faces, after checking that each edge is used once
    /// in each direction and no vertex is doubled.
    fn euler_characteristic_of_closed(mesh: &Mesh) -> i64 {
        let mut uses: HashMap<(u32, u32), u32> = HashMap::new();
        for f in &mesh.faces {
            for i in 0..3 {
                *uses.entry((f[i], f[(i + 1) % 3])).or_default() += 1;
            }
        }
        for (&(a, b), &count) in &uses {
            assert_eq!((count, uses.get(&(b, a))), (1, Some(&1)), "edge {a}-{b}");
        }
        let welded = weld(&mesh.positions);
        assert!(welded.iter().enumerate().all(|(i, &w)| w as usize == i));
        mesh.positions.len() as i64 - uses.len() as i64 / 2 + mesh.faces.len() as i64
    }

    #[test]
    fn flat_shapes_have_their_area_and_side() {
        for (shape, area) in [(rectangle as fn(Affine) -> _, 4.0), (disk, PI)] {
            let (mesh, normals): (Mesh, _) = shape(Affine::IDENTITY);
            assert_eq!(normals, ShadingNormals::Face);
            assert!((mesh.area() / area - 1.0).abs() < 2.0 * SILHOUETTE_ERROR);
            for world_from_object in [stretch(), mirrored()] {
                let (mesh, _) = shape(world_from_object);
                let normal = world_from_object.normal(Vec3::new(0.0, 0.0, 1.0));
                for face in 0..mesh.faces.len() {
                    let n = mesh.face_cross(face);
                    assert!(n.dot(normal) > 0.0, "face {face}");
                    assert!(n.cross(normal).length() < 1e-12 * n.length() * normal.length());
                }
            }
        }
    }

    /// The worst point of a regular polygon is the middle of a side.
    #[test]
    fn disk_silhouette_is_within_its_error() {
        let (mesh, _) = disk(Affine::IDENTITY);
        for &[_, a, b] in &mesh.faces {
            let [a, b] = [a, b].map(|i| mesh.positions[i as usize]);
            assert!(1.0 - ((a + b) * 0.5).length() < SILHOUETTE_ERROR);
            assert!((a.length() - 1.0).abs() < 1e-15);
        }
    }

    /// Its sides are planes through chords of the circle, so its silhouette is as far off
    /// as a disk's; it is open, and its front and its normals are outside, mirrored or not.
    #[test]
    fn cylinder_is_open_and_outward() {
        let (mesh, _) = cylinder(Affine::IDENTITY);
        assert!((mesh.area() / (2.0 * PI) - 1.0).abs() < SILHOUETTE_ERROR);
        assert_eq!(mesh.bounds().0, Vec3::new(-1.0, -1.0, 0.0));
        assert_eq!(mesh.bounds().1, Vec3::new(1.0, 1.0, 1.0));
        let edges = edges(&mesh);
        let open = edges.iter().filter(|e| e.sides == Sides::Open).count();
        assert_eq!(open, 2 * ROUND_SEGMENTS as usize);
        for world_from_object in [Affine::IDENTITY, stretch(), mirrored()] {
            let (mesh, normals) = cylinder(world_from_object);
            let normals = normals.per_vertex().expect("a cylinder is smooth");
            let axis = |z: f64| world_from_object.point(Vec3::new(0.0, 0.0, z));
            for (face, corners) in mesh.faces.iter().enumerate() {
                let n = mesh.face_cross(face).normalized();
                let outward = mesh.corners(face)[0] - (axis(0.0) + axis(1.0)) * 0.5;
                let along = (axis(1.0) - axis(0.0)).normalized();
                assert!(n.dot(outward.reject_from(along)) > 0.0, "face {face}");
                assert!(corners.iter().all(|&i| n.dot(normals[i as usize]) > 0.99));
            }
        }
    }

    #[test]
    fn cube_is_closed_and_outward() {
        for world_from_object in [Affine::IDENTITY, stretch(), mirrored()] {
            let (mesh, _) = cube(world_from_object);
            assert_eq!(euler_characteristic_of_closed(&mesh), 2);
            let expected = 8.0 * world_from_object.determinant().abs();
            assert!((volume(&mesh) / expected - 1.0).abs() < 1e-14);
        }
        let (mesh, _) = cube(Affine::IDENTITY);
        assert_eq!(mesh.area(), 24.0);
        assert_eq!(mesh.bounds(), (Vec3::splat(-1.0), Vec3::splat(1.0)));
    }

    #[test]
    fn sphere_is_closed_and_has_its_size_and_side() {
        let (centre, radius) = (Vec3::new(0.3, -0.2, 0.1), 0.7);
        for world_from_object in [Affine::IDENTITY, stretch(), mirrored()] {
            let (mesh, normals) = sphere(world_from_object, centre, radius);
            assert_eq!(euler_characteristic_of_closed(&mesh), 2);
            let true_volume = 4.0 / 3.0 * PI * radius.powi(3) * world_from_object.determinant();
            assert!((volume(&mesh) / true_volume - 1.0).abs() < 3.0 * SILHOUETTE_ERROR);
            let (low, high) = mesh.bounds();
            let middle = world_from_object.point(centre);
            assert!(((low + high) * 0.5 - middle).length() < 1e-13);
            // Given normals are unit and on the side of the faces around them,
            // which is the outside unless mirrored (the volume's sign).
            let normals = normals.per_vertex().expect("a sphere is smooth");
            assert!(normals.iter().all(|n| (n.length() - 1.0).abs() < 4e-15));
            for (face, corners) in mesh.faces.iter().enumerate() {
                let n = mesh.face_cross(face).normalized();
                for &i in corners {
                    assert!(n.dot(normals[i as usize]) > 0.99);
                }
            }
        }
        let (mesh, _) = sphere(Affine::IDENTITY, centre, radius);
        assert!((mesh.area() / (4.0 * PI * radius * radius) - 1.0).abs() < 2.0 * SILHOUETTE_ERROR);
    }

    /// Seen from anywhere, the silhouette lies between the sphere and the sphere
    /// inscribed in the mesh: its error is at most the largest face depth.
    #[test]
    fn sphere_silhouette_is_within_its_error() {
        let radius = 2.5;
        let (mesh, _) = sphere(Affine::IDENTITY, Vec3::zero(), radius);
        let depth = |face| {
            let normal = mesh.face_cross(face).normalized();
            1.0 - normal.dot(mesh.corners(face)[0]) / radius
        };
        let worst = (0..mesh.faces.len()).map(depth).fold(0.0, f64::max);
        assert!(worst < SILHOUETTE_ERROR, "{worst:e}");
        assert!(
            worst > 0.9 * SILHOUETTE_ERROR,
            "finer than needed: {worst:e}"
        );
    }
}
