//! Trees on the device that follow moved vertices, against brute force, and against trees that
//! the CPU refits.

use std::f64::consts::PI;

use capwalk_geometry::{ConeQuery, EdgeSelection, Mesh, RayTree, SilhouetteTree};
use capwalk_gpu::{DeviceRayTree, DeviceSilhouetteTree, GpuError, GpuOptions, Precision};
use capwalk_math::Vec3;

use super::adapter;
use super::meshes::{self, Placed, Random};
use super::rays;
use super::silhouettes::{check, cones, edges_of};

/// Rays and cones after each motion.
const QUERIES: usize = 40;

/// Some meshes at the origin, of every kind.
fn some() -> Vec<Placed> {
    let is_at_origin = |placed: &Placed| placed.name.contains("at the origin");
    meshes::all().into_iter().filter(is_at_origin).collect()
}

/// Moves the vertices in every way that there is: all from where they were at first, so that
/// errors do not add up.
fn motions(original: &Placed, random: &mut Random) -> Vec<Placed> {
    let axis = random.direction();
    let turned = |p: Vec3| {
        let (sin, cos) = 2.0_f64.sin_cos();
        p * cos + axis.cross(p) * sin + axis * (axis.dot(p) * (1.0 - cos))
    };
    let mut moved = Vec::new();
    let mut push = |name: &str, centre: Vec3, size: f64, at: &mut dyn FnMut(Vec3) -> Vec3| {
        let positions = original
            .mesh
            .positions
            .iter()
            .map(|&p| centre + at(p) * size);
        moved.push(Placed {
            name: format!("{}, {name}", original.name),
            mesh: Mesh {
                positions: positions.collect(),
                faces: original.mesh.faces.clone(),
            },
            centre,
            size,
        });
    };
    let far = Vec3::new(-4e4, 2e5, 3e4);
    push("turned and far away", far, 1.0, &mut |p| turned(p));
    push("tiny", Vec3::new(1e-3, 0.0, 0.0), 1e-6, &mut |p| turned(p));
    push("huge", Vec3::zero(), 1e12, &mut |p| p);
    push("stretched", Vec3::zero(), 1.0, &mut |p| {
        Vec3::new(3.0 * p.x, p.y, 0.01 * p.z)
    });
    push("shaken", Vec3::zero(), 1.0, &mut |p| {
        p + random.point() * 0.3
    });
    push("flat", Vec3::zero(), 1.0, &mut |p| {
        turned(Vec3::new(p.x, p.y, 0.0))
    });
    push("inside out", Vec3::zero(), 1.0, &mut |p| -p);
    push("a point", Vec3::new(0.1, 0.2, 0.3), 1.0, &mut |_| {
        Vec3::zero()
    });
    push("as it was", Vec3::zero(), 1.0, &mut |p| p);
    moved
}

/// Rays hit what they hit in a tree that the CPU refitted, to the last bit, and what brute
/// force says.
#[test]
fn rays_follow() {
    adapter::each(|gpu| {
        let mut random = Random(31);
        for original in some() {
            let mut tree = RayTree::build(&original.mesh);
            let mut device = DeviceRayTree::new(gpu, &tree).expect("enough memory");
            for moved in motions(&original, &mut random) {
                tree.refit(&moved.mesh);
                device.refit(&moved.mesh).expect("the same mesh");
                let rays = rays::rays(&moved, &mut random, QUERIES);
                let anew = DeviceRayTree::new(gpu, &tree).expect("enough memory");
                assert_eq!(
                    device.first_hits(&rays).expect("answers"),
                    anew.first_hits(&rays).expect("answers"),
                    "{}",
                    moved.name
                );
                // Where triangles became slivers, single precision is off by more, in any tree.
                if gpu.precision() == Precision::Double || !moved.name.ends_with("flat") {
                    rays::check(gpu, &moved, &tree, &device, &rays);
                }
            }
        }
    });
}

/// Cones find what brute force finds; in double precision, to the last bit what they find in a
/// tree that the CPU refitted. All silhouettes there are, as well: whatever bounds exclude
/// wrongly is missed.
#[test]
fn cones_follow() {
    adapter::each(|gpu| {
        let mut random = Random(32);
        for original in some() {
            let edges = edges_of(&original.mesh);
            let mut tree = SilhouetteTree::build(&original.mesh, &edges);
            let mut device = DeviceSilhouetteTree::new(gpu, &tree).expect("enough memory");
            for moved in motions(&original, &mut random) {
                tree.refit(&moved.mesh);
                device.refit(&moved.mesh).expect("the same mesh");
                let mut some = cones(&moved, &mut random, QUERIES);
                for _ in 0..QUERIES / 2 {
                    some.push(ConeQuery {
                        apex: moved.spot(&mut random),
                        axis: random.direction(),
                        max_angle: PI,
                        edges: EdgeSelection::Silhouettes,
                        groups: u8::MAX,
                        in_front_of: None,
                    });
                }
                check(gpu, &moved, &edges, &tree, &device, &some);
                if gpu.precision() == Precision::Single || !adapter::is_exact(gpu) {
                    continue;
                }
                let anew = DeviceSilhouetteTree::new(gpu, &tree).expect("enough memory");
                let name = &moved.name;
                let [own, other] = [&device, &anew].map(|tree| tree.closest(&some));
                assert_eq!(own, other, "{name}");
                let [own, other] = [&device, &anew].map(|tree| {
                    let gathered = tree.gather(&some, 8).expect("answers");
                    let sorted = |i: usize| {
                        let mut edges = gathered.of(i).to_vec();
                        edges.sort_unstable();
                        edges
                    };
                    (0..some.len()).map(sorted).collect::<Vec<_>>()
                });
                assert_eq!(own, other, "{name}");
            }
        }
    });
}

/// A mesh that the tree is not of, or that is none, changes nothing.
#[test]
fn other_meshes_are_refused() {
    let Some((gpu, _turn)) = adapter::open(&GpuOptions::default()) else {
        return;
    };
    let original = some().swap_remove(0);
    let mut random = Random(33);
    let rays = rays::rays(&original, &mut random, QUERIES);
    let some = cones(&original, &mut random, QUERIES);
    let edges = edges_of(&original.mesh);
    let (ray_tree, edge_tree) = (
        RayTree::build(&original.mesh),
        SilhouetteTree::build(&original.mesh, &edges),
    );
    let mut ray_device = DeviceRayTree::new(&gpu, &ray_tree).expect("enough memory");
    let mut edge_device = DeviceSilhouetteTree::new(&gpu, &edge_tree).expect("enough memory");
    let hits = ray_device.first_hits(&rays).expect("answers");
    let points = edge_device.closest(&some).expect("answers");
    let mesh = &original.mesh;
    let changed = |change: fn(&mut Mesh)| {
        let mut mesh = mesh.clone();
        change(&mut mesh);
        mesh
    };
    let bad = [
        changed(|mesh| mesh.faces.truncate(9)),
        changed(|mesh| mesh.positions.truncate(9)),
        changed(|mesh| mesh.positions[5].y = f64::NAN),
        changed(|mesh| mesh.positions[6].x = f64::INFINITY),
    ];
    // Also after the first refit, when the faces are there.
    for _ in 0..2 {
        for bad in &bad {
            let errors = [ray_device.refit(bad), edge_device.refit(bad)];
            for error in errors {
                let error = error.expect_err("another mesh");
                assert!(matches!(error, GpuError::OtherMesh { .. }), "{error}");
            }
            assert_eq!(ray_device.first_hits(&rays).expect("answers"), hits);
            assert_eq!(edge_device.closest(&some).expect("answers"), points);
        }
        ray_device.refit(mesh).expect("the same mesh");
        edge_device.refit(mesh).expect("the same mesh");
    }
    // One vertex more, which is no part of any face.
    let more = changed(|mesh| mesh.positions.push(Vec3::zero()));
    let error = ray_device.refit(&more).expect_err("another mesh");
    assert!(error.to_string().contains("vertices"), "{error}");
}
