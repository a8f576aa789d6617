//! Spheres as one thing of the ray tree, against brute force.

use capwalk_math::{Affine, Vec3};

use super::bundles::{self, spread};
use super::rays;
use crate::{Apex, Mesh, Ray, RayTree, Wedge, icosphere, oracle};

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

/// Rays in the planes of a long ellipsoid's faces, which begin and end where they hit it; what is still
/// longer is no sphere.
#[test]
fn ellipsoids_are_brute_force() {
    let long = |length: f64| {
        let mut mesh = icosphere(4);
        mesh.positions.iter_mut().for_each(|p| p.z *= length);
        mesh
    };
    assert_eq!(RayTree::build(&long(1e4)).sphere_count(), 0);
    for length in [1.0, 100.0] {
        let mesh = long(length);
        let tree = RayTree::build(&mesh);
        assert_eq!(tree.sphere_count(), 1);
        let rays = (0..4000).filter_map(|i| {
            let ray = Ray {
                t_min: f64::NEG_INFINITY,
                t_max: f64::INFINITY,
                ..grazing(&mesh, i)
            };
            let t = oracle::first_hit(&mesh, &ray)?.t;
            let [t_min, t_max] = [[t, t], [t, f64::INFINITY], [f64::NEG_INFINITY, t]][i % 3];
            Some(Ray {
                t_min,
                t_max,
                ..ray
            })
        });
        let mut rays: Vec<Ray> = rays.collect();
        if length > 1.0 {
            // Its distance is that of another part of the face.
            let t = -0.032_135_478_258_222_765;
            rays.push(Ray {
                origin: Vec3::new(0.6262223599184013, -0.7472687683034976, -18.85968403222804),
                direction: Vec3::new(-7.192688054576877, -4.849683451702436, -52.370426083989884),
                t_min: t,
                t_max: t,
            });
        }
        assert!(rays.len() > 2000, "{}", rays.len());
        rays::check(&tree, &mesh, &rays).unwrap();
    }
}

/// Threads that need a sphere's triangles while one of them finds them do not wait for each other.
#[test]
fn spheres_are_shared_between_tasks() {
    let mesh = icosphere(55);
    let wedge = [Vec3::new(0.1, 0.9, 0.0), Vec3::new(0.0, 0.2, 0.9)];
    let wedge = Wedge::new(Apex::Point(Vec3::new(4.0, 0.3, 0.2)), wedge).expect("a wedge");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build();
    let pool = pool.expect("three threads");
    let work = move || {
        for _ in 0..20 {
            let tree = RayTree::build(&mesh);
            let wait = |ms| std::thread::sleep(std::time::Duration::from_millis(ms));
            let ask = |after| {
                wait(after);
                let mut found = Vec::new();
                tree.across(&mesh, &wedge, &mut found);
                assert!(!found.is_empty());
            };
            pool.install(|| {
                let two = || rayon::join(|| ask(3), || ask(0));
                rayon::join(|| ask(2), || rayon::join(two, || wait(4)))
            });
        }
    };
    let (done, is_done) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        work();
        done.send(())
    });
    let minute = std::time::Duration::from_secs(60);
    assert_eq!(is_done.recv_timeout(minute), Ok(()), "they wait for ever");
}

/// A tree that devices have stays what it was when vertices move, but for where its triangles are.
#[test]
fn buffers_follow_vertices() {
    let mesh = icosphere(9);
    let mut tree = RayTree::build(&mesh);
    let before = tree.buffers();
    let mut moved = mesh.clone();
    for p in &mut moved.positions {
        *p = Vec3::new(3.0 * p.x, p.y + p.x, 0.3 * p.z);
    }
    moved.positions[20] = moved.positions[20] * 0.7;
    tree.refit(&moved);
    let after = tree.buffers();
    assert_eq!(before.faces, after.faces);
    assert_eq!(before.leaf_starts, after.leaf_starts);
    assert_eq!(before.below, after.below);
    let corners = after
        .faces
        .iter()
        .flat_map(|&face| moved.corners(face as usize));
    let corners: Vec<f64> = corners.flat_map(Vec3::to_array).collect();
    assert_eq!(after.triangles, corners);
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
