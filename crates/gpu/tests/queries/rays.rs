//! Rays on the device against brute force.

use std::sync::Arc;

use capwalk_geometry::buffers::{LEAF, RAY_NODE};
use capwalk_geometry::ray::intersect_triangle;
use capwalk_geometry::{Hit, Ray, RayTree, oracle};
use capwalk_gpu::{DeviceRayTree, Gpu, Precision, SINGLE_ERROR};
use capwalk_math::Vec3;

use super::adapter;
use super::meshes::{self, Placed, Random};

/// Rays per mesh.
const RAYS: usize = 400;

/// Relative error of distances by divisions that are off by some ulp.
const DIVISION: f64 = 1e-14;

pub fn rays(placed: &Placed, random: &mut Random, count: usize) -> Vec<Ray> {
    let mut rays = Vec::new();
    for i in 0..count {
        let from = placed.spot(random);
        let towards = match random.below(3) {
            0 => random.direction() * placed.size,
            _ => placed.spot(random) - from,
        };
        // Along the axes, as well.
        let towards = match random.below(8) {
            0 => Vec3::new(0.0, 0.0, towards.z),
            _ => towards,
        };
        let length = [1.0, 1e-9, 1e6][i % 3];
        let whole = Ray::new(from, towards * length);
        rays.push(match random.below(4) {
            0 => Ray {
                t_min: 0.3 * random.number() / length,
                t_max: 2.0 * random.number() / length,
                ..whole
            },
            1 => Ray {
                t_min: f64::NEG_INFINITY,
                ..whole
            },
            _ => whole,
        });
    }
    rays
}

/// In double precision: as brute force, up to divisions.
fn check_double(gpu: &Gpu, ray: &Ray, found: Option<Hit>, expected: Option<Hit>) -> bool {
    match (found, expected) {
        (Some(found), Some(expected)) if !adapter::is_exact(gpu) => {
            (found.t - expected.t).abs() <= DIVISION * expected.t.abs()
        }
        _ => found == expected,
    }
    .then_some(())
    .or_else(|| {
        // At the very end of the ray an ulp decides.
        let t = found.or(expected)?.t;
        let at_end = |end: f64| (t - end).abs() <= DIVISION * end.abs();
        (!adapter::is_exact(gpu) && (at_end(ray.t_min) || at_end(ray.t_max))).then_some(())
    })
    .is_some()
}

/// In single precision: the hit lies on its triangle, and no triangle is missed, as far as
/// `error` (a distance in the world) lets one tell.
fn check_single(
    placed: &Placed,
    error: f64,
    ray: &Ray,
    found: Option<Hit>,
    expected: Option<Hit>,
) -> Result<(), String> {
    let speed = ray.direction.length();
    if let Some(hit) = found {
        let corners = placed.mesh.corners(hit.face as usize);
        let off = distance(ray.at(hit.t), corners);
        if off > error {
            return Err(format!("{off:e} from its face, allowed {error:e}"));
        }
        let beyond = (ray.t_min - hit.t).max(hit.t - ray.t_max) * speed;
        if beyond > error {
            return Err(format!("{beyond:e} beyond the ray's ends"));
        }
    }
    let Some(expected) = expected else {
        return Ok(());
    };
    // A hit that stays one wherever the ray moves by as much must not be missed.
    let corners = placed.mesh.corners(expected.face as usize);
    let direction = ray.direction.normalized();
    let across = direction.cross(Vec3::new(0.3, -0.5, 0.8)).normalized();
    let mut last = f64::NEG_INFINITY;
    for i in 0..8 {
        let (sin, cos) = (f64::from(i) * std::f64::consts::FRAC_PI_4).sin_cos();
        let shift = across * cos + direction.cross(across) * sin;
        let moved = Ray {
            origin: ray.origin + shift * error,
            t_min: ray.t_min + error / speed,
            t_max: ray.t_max - error / speed,
            ..*ray
        };
        match intersect_triangle(&moved, corners) {
            Some((t, _)) => last = last.max(t),
            None => return Ok(()),
        }
    }
    match found {
        Some(hit) if (hit.t - last) * speed <= error => Ok(()),
        _ => Err(format!("{expected:?} was missed")),
    }
}

/// The distance of a point from a triangle.
fn distance(p: Vec3, [a, b, c]: [Vec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a).normalized();
    let sides = [(a, b), (b, c), (c, a)];
    let is_inside = |(from, to): (Vec3, Vec3)| normal.dot((to - from).cross(p - from)) >= 0.0;
    if sides.into_iter().all(is_inside) {
        return normal.dot(p - a).abs();
    }
    let to_side = |(from, to): (Vec3, Vec3)| {
        let along: Vec3 = to - from;
        let t = (along.dot(p - from) / along.length_squared()).clamp(0.0, 1.0);
        (from + along * t - p).length()
    };
    sides.into_iter().map(to_side).fold(f64::INFINITY, f64::min)
}

/// Compares the answers with brute force, and returns how many hits there are.
pub fn check(
    gpu: &Arc<Gpu>,
    placed: &Placed,
    tree: &RayTree,
    device: &DeviceRayTree,
    rays: &[Ray],
) -> usize {
    let hits = device.first_hits(rays).expect("answers");
    let occluded = device.occluded(rays).expect("answers");
    assert_eq!(
        device.first_hits(rays).expect("answers"),
        hits,
        "a second time"
    );
    assert_eq!((hits.len(), occluded.len()), (rays.len(), rays.len()));
    let frame = tree.buffers().frame;
    for (i, (ray, &hit)) in rays.iter().zip(&hits).enumerate() {
        let expected = oracle::first_hit(&placed.mesh, ray);
        let name = &placed.name;
        assert_eq!(occluded[i], hit.is_some(), "{name}: {ray:?}");
        match gpu.precision() {
            Precision::Double => assert!(
                check_double(gpu, ray, hit, expected),
                "{name}: {hit:?} is not {expected:?} of {ray:?}"
            ),
            Precision::Single => {
                // Where a coordinate itself is coarser than that, as seen from a ray's far origin,
                // brute force is not better.
                let coarse = 1e-15 * (ray.origin.length() + frame.reach);
                let error = 4.0 * SINGLE_ERROR * frame.scale + coarse;
                let right = check_single(placed, error, ray, hit, expected);
                assert!(
                    right.is_ok(),
                    "{name}: {hit:?}, expected {expected:?} of {ray:?}: {right:?}"
                );
            }
        }
    }
    hits.iter().flatten().count()
}

/// First hits and occlusion, wherever meshes are and however large; also after vertices
/// moved.
#[test]
fn rays_hit_what_brute_force_hits() {
    adapter::each(|gpu| {
        let mut random = Random(1);
        let (mut asked, mut found) = (0, 0);
        for mut placed in meshes::all() {
            let mut tree = RayTree::build(&placed.mesh);
            let mut device = DeviceRayTree::new(gpu, &tree).expect("enough memory");
            let some = rays(&placed, &mut random, RAYS);
            found += check(gpu, &placed, &tree, &device, &some);
            for p in &mut placed.mesh.positions {
                *p += random.point() * (0.1 * placed.size);
            }
            tree.refit(&placed.mesh);
            device.refit(&placed.mesh).expect("enough memory");
            let some = rays(&placed, &mut random, RAYS / 4);
            found += check(gpu, &placed, &tree, &device, &some);
            asked += RAYS + RAYS / 4;
        }
        assert!(
            found > asked / 4,
            "{found} hits of {asked} rays prove little"
        );
    });
}

/// Rays through vertices and edges of a closed mesh hit one of the faces there: never none.
#[test]
fn closed_meshes_have_no_gaps() {
    adapter::each(|gpu| {
        let mut random = Random(2);
        let mesh = meshes::grid(30, 20, true, &mut random);
        let tree = DeviceRayTree::new(gpu, &RayTree::build(&mesh)).expect("enough memory");
        let mut rays = Vec::new();
        for face in &mesh.faces {
            let [a, b, _] = face.map(|i| mesh.positions[i as usize]);
            // From inside the tube, at a vertex and at an edge's middle.
            let centre = Vec3::new(a.x, a.y, 0.0).normalized() * 0.6;
            for target in [a, (a + b) * 0.5] {
                let from = centre + random.point() * 0.05;
                rays.push(Ray::new(from, target - from));
            }
        }
        let hits = tree.first_hits(&rays).expect("answers");
        let misses = hits.iter().filter(|hit| hit.is_none()).count();
        assert_eq!(misses, 0, "of {} rays from inside", rays.len());
    });
}

/// Any number of rays: none, one, not a multiple of a group, and more than a launch has.
#[test]
fn batches_of_any_size() {
    adapter::each(|gpu| {
        let mut random = Random(3);
        let placed = meshes::all().swap_remove(0);
        let tree = RayTree::build(&placed.mesh);
        let many = rays(&placed, &mut random, 10_000);
        let device = DeviceRayTree::new(gpu, &tree).expect("enough memory");
        let whole = device.first_hits(&many).expect("answers");
        for count in [0, 1, 63, 64, 65, 1000] {
            assert_eq!(
                device.first_hits(&many[..count]).expect("answers"),
                whole[..count],
                "{count}"
            );
            assert_eq!(
                device.occluded(&many[..count]).expect("answers").len(),
                count
            );
        }
    });
}

/// The way down some of the trees is long.
#[test]
fn some_trees_are_deep() {
    let mesh = meshes::spiral(300);
    let nodes = RayTree::build(&mesh).buffers().nodes;
    let mut levels = vec![1; nodes.len() / RAY_NODE];
    for (node, words) in nodes.chunks_exact(RAY_NODE).enumerate() {
        for &child in words[RAY_NODE - 8..]
            .iter()
            .filter(|&&child| child & LEAF == 0)
        {
            levels[child as usize] = levels[node] + 1;
        }
    }
    assert!(levels.iter().max() > Some(&9), "{:?}", levels.iter().max());
}
