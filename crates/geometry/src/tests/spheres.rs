//! Spheres as one thing of the ray tree, against brute force.

use capwalk_math::{Affine, Vec3};

use super::bundles;
use super::rays;
use crate::{Apex, Mesh, Ray, RayTree, Wedge, icosphere, oracle};

/// Numbers between -1 and 1 that are spread evenly, by a number of their own.
fn spread(i: usize) -> Vec3 {
    bundles::spread(i)
}

/// Icospheres under affine maps: round ones, stretched and mirrored, far away, small and large;
/// between them a few triangles.
fn spheres(frequency: u32) -> Mesh {
    let turned = |angle| Affine::rotate(Vec3::new(0.3, 1.0, -0.4), angle);
    let maps = [
        Affine::IDENTITY,
        Affine::translate(Vec3::new(2.5, 0.3, 0.0)) * turned(0.8) * Affine::scale(Vec3::splat(0.7)),
        Affine::translate(Vec3::new(-2.0, 1.0, 0.5))
            * turned(2.0)
            * Affine::scale(Vec3::new(0.2, 1.0, 0.6)),
        Affine::translate(Vec3::new(0.0, -2.0, 0.5)) * Affine::scale(Vec3::new(-0.8, 0.5, 0.4)),
        Affine::translate(Vec3::new(0.2, 1.5, 0.0)) * Affine::scale(Vec3::splat(1e-3)),
        Affine::translate(Vec3::new(0.0, 0.0, 300.0)) * Affine::scale(Vec3::splat(40.0)),
    ];
    let mut mesh = Mesh::default();
    for (i, map) in maps.into_iter().enumerate() {
        let mut sphere = icosphere(frequency + i as u32 % 2);
        sphere.positions.iter_mut().for_each(|p| *p = map.point(*p));
        if map.determinant() < 0.0 {
            sphere.faces.iter_mut().for_each(|face| face.swap(1, 2));
        }
        mesh.append(&sphere);
        mesh.append(&Mesh {
            positions: [0, 1, 2].map(|k| spread(7 * i + k) * 3.0).to_vec(),
            faces: vec![[0, 1, 2]],
        });
    }
    mesh
}

/// A ray to a point of a mesh, from the mesh, from inside, beside and far away; many just touch
/// something.
fn ray(mesh: &Mesh, i: usize) -> Ray {
    let face = (i * 97) % mesh.faces.len();
    let [a, b, c] = mesh.corners(face);
    let target = match i % 5 {
        0 => a,
        1 => (a + b) * 0.5,
        2 => a * 0.999 + b * 1e-3,
        _ => a * 0.2 + b * 0.3 + c * 0.5,
    };
    let other = mesh.corners((i * 611 + 5) % mesh.faces.len())[0];
    let size = (b - a).length();
    let origin = match i % 7 {
        0 => other,
        1 => target + spread(i) * 0.5,
        2 => target + spread(i) * 1e4,
        3 => target + (b - c) * (10.0 * spread(i).x) + spread(i) * (1e-3 * size),
        4 => target + spread(i) * (3.0 * size),
        // Through the middle of the first.
        5 => -target,
        _ => spread(i) * 4.0,
    };
    let [t_min, t_max] = match i % 4 {
        0 => [1e-6, f64::INFINITY],
        1 => [0.0, 1.0 - 1e-9],
        2 => [0.0, 1.0],
        _ => [0.3, 1.7],
    };
    Ray {
        t_min,
        t_max,
        ..Ray::new(origin, target - origin)
    }
}

/// A ray along an edge, or in the plane of a face, which it may hit anywhere; it begins or ends within the
/// face.
fn grazing(mesh: &Mesh, i: usize) -> Ray {
    let [a, b, c] = mesh.corners((i * 97) % mesh.faces.len());
    let along = match i % 3 {
        0 => b - a,
        1 => c - a,
        _ => (b + c) * 0.5 - a,
    };
    let before = [0.0, 0.5, 3.0, 1e3][i % 4];
    let lift = (b - a).cross(c - a) * (spread(i).y * [0.0, 1e-15, 1e-12][i / 3 % 3]);
    let [t_min, t_max] = [[0.0, 0.4], [0.6, 9.0], [0.4, 0.6]][i / 4 % 3];
    Ray {
        t_min: before + t_min,
        t_max: before + t_max,
        ..Ray::new(a - along * before + lift, along)
    }
}

/// They are found, and rays hit what brute force finds, bit for bit; also after they moved, and
/// after one of them is no sphere any more.
#[test]
fn spheres_are_brute_force() {
    for frequency in [4, 9] {
        let mesh = spheres(frequency);
        let mut tree = RayTree::build(&mesh);
        assert_eq!(tree.sphere_count(), 6);
        let mut moved = mesh.clone();
        for p in &mut moved.positions {
            *p = Affine::rotate(Vec3::new(1.0, 0.2, 0.1), 0.4)
                .point(*p + Vec3::new(0.1 * p.y, 0.3, 0.0));
        }
        let mut dented = moved.clone();
        dented.positions[9] = dented.positions[9] * 0.8;
        for (mesh, count) in [(&mesh, 6), (&moved, 6), (&dented, 5)] {
            tree.refit(mesh);
            assert_eq!(tree.sphere_count(), count);
            let rays = (0..1500).map(|i| ray(mesh, i));
            let rays: Vec<Ray> = rays.chain((0..400).map(|i| grazing(mesh, i))).collect();
            let hits = rays.iter().filter(|ray| tree.occluded(ray)).count();
            assert!(hits > 450, "{hits}");
            rays::check(&tree, mesh, &rays).unwrap();
            for i in 0..20 {
                let width = [0.3, 0.01, 1e-4][i % 3];
                let rays = bundles::beam(&ray(mesh, 13 * i), i, [0.0, width]);
                bundles::check(&tree, mesh, &rays, 0xffff);
            }
        }
    }
}

/// What crosses wedges of light is found in spheres, too.
#[test]
fn what_crosses_wedges_is_brute_force() {
    let mesh = spheres(6);
    let tree = RayTree::build(&mesh);
    let (mut found, mut count) = (Vec::new(), 0);
    for i in 0..200 {
        let [a, b, _] = mesh.corners((i * 97) % mesh.faces.len());
        let Some(wedge) = Wedge::new(Apex::Point(spread(i) * 4.0), [a, b]) else {
            continue;
        };
        tree.across(&mesh, &wedge, &mut found);
        assert_eq!(found, oracle::across(&mesh, &wedge), "{wedge:?}");
        count += found.len();
    }
    assert!(count > 500, "{count}");
}

/// Rays that go so far, or are so long, that double precision does not tell where they pass a sphere.
#[test]
fn spheres_that_are_hard_to_see_are_brute_force() {
    let mesh = spheres(5);
    let tree = RayTree::build(&mesh);
    let near = (0..100).map(|i| ray(&mesh, i));
    let rays = near.flat_map(|ray| {
        let far = [1e7, 1e9, 1e12].map(|away| Ray {
            t_max: f64::INFINITY,
            ..Ray::new(ray.origin - ray.direction * away, ray.direction)
        });
        let scaled = [1e-200, 1e200].map(|length| Ray {
            direction: ray.direction * length,
            t_min: ray.t_min / length,
            t_max: ray.t_max / length,
            ..ray
        });
        far.into_iter().chain(scaled)
    });
    let rays: Vec<Ray> = rays.collect();
    rays::check(&tree, &mesh, &rays).unwrap();
}

/// Faces that are no icosphere, or not all of one, are triangles.
#[test]
fn others_are_no_spheres() {
    let whole = icosphere(6);
    let count = |mesh: &Mesh| RayTree::build(mesh).sphere_count();
    assert_eq!(count(&whole), 1);
    let mut cut = whole.clone();
    cut.faces.pop();
    assert_eq!(count(&cut), 0);
    let mut swapped = whole.clone();
    swapped.faces.swap(40, 41);
    assert_eq!(count(&swapped), 0);
    let mut flat = whole.clone();
    flat.positions.iter_mut().for_each(|p| p.z = 0.0);
    assert_eq!(count(&flat), 0);
    let mut bumpy = whole.clone();
    bumpy.positions[100] = bumpy.positions[100] * (1.0 + 1e-8);
    assert_eq!(count(&bumpy), 0);
    assert_eq!(count(&icosphere(3)), 0);
}
