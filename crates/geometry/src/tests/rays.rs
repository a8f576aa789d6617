//! The ray tree against brute force.

use super::meshes::{self, Place, Spot};
use crate::bvh::validate::TreeError;
use crate::simd::Instructions;
use crate::{Mesh, Ray, RayTree, SilhouetteTree, oracle};
use capwalk_math::Vec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A ray in words: from where, to where, how long, which part counts.
#[derive(Clone, Copy, Debug)]
pub struct Aim {
    from: Spot,
    towards: Result<Spot, Vec3>,
    length: f64,
    bounds: [f64; 2],
}

/// Any ray.
pub fn aim() -> impl Strategy<Value = Aim> {
    let towards = prop_oneof![
        meshes::spot().prop_map(Ok),
        meshes::direction().prop_map(Err)
    ];
    let length = prop_oneof![Just(1.0), Just(1e-9), Just(1e12), 0.1..10.0_f64];
    let bounds = prop_oneof![
        3 => Just([0.0, f64::INFINITY]),
        1 => Just([f64::NEG_INFINITY, f64::INFINITY]),
        1 => (0.0..1.0_f64, 0.0..3.0_f64).prop_map(|(near, more)| [near, near + more]),
    ];
    (meshes::spot(), towards, length, bounds).prop_map(|(from, towards, length, bounds)| Aim {
        from,
        towards,
        length,
        bounds,
    })
}

impl Aim {
    /// The ray before a mesh.
    pub fn ray(&self, mesh: &Mesh, place: &Place) -> Ray {
        let origin = self.from.position(mesh, place);
        let direction = match self.towards {
            Ok(spot) => spot.position(mesh, place) - origin,
            Err(direction) => direction * place.size,
        };
        Ray {
            origin,
            direction: direction * self.length,
            t_min: self.bounds[0] / self.length,
            t_max: self.bounds[1] / self.length,
        }
    }
}

pub fn check(tree: &RayTree, mesh: &Mesh, rays: &[Ray]) -> Result<(), TestCaseError> {
    tree.validate(mesh)
        .map_err(|error| TestCaseError::fail(format!("{error:?}")))?;
    let slower = Instructions::slower()
        .into_iter()
        .map(|it| tree.clone().with(it));
    let trees: Vec<_> = slower.chain([tree.clone()]).collect();
    for ray in rays {
        let expected = oracle::first_hit(mesh, ray);
        for tree in &trees {
            prop_assert_eq!(tree.first_hit(ray), expected, "{:?}", ray);
            prop_assert_eq!(tree.occluded(ray), oracle::occluded(mesh, ray), "{:?}", ray);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() })]

    /// The tree finds what brute force finds, bit for bit; also after vertices
    /// moved.
    #[test]
    fn tree_is_brute_force(
        (mesh, place) in meshes::mesh(),
        aims in prop::collection::vec(aim(), 20),
        seed in 1..u64::MAX,
    ) {
        let rays_at = |mesh: &Mesh| aims.iter().map(|aim| aim.ray(mesh, &place)).collect::<Vec<_>>();
        let mut tree = RayTree::build(&mesh);
        check(&tree, &mesh, &rays_at(&mesh))?;
        let moved = meshes::moved(&mesh, &place, 1.0, seed);
        tree.refit(&moved);
        check(&tree, &moved, &rays_at(&moved))?;
    }
}

/// No ray slips through a closed mesh between two faces: rays from inside, at
/// the vertices and at points of the edges as exactly as they can be aimed,
/// all hit.
#[test]
fn closed_meshes_are_watertight() {
    for (n, offset, size) in [(1, 0.0, 1.0), (4, 0.0, 1.0), (9, 1e5, 1e-2), (7, 0.0, 1e-6)] {
        let mut mesh = meshes::ball(n, |d| 1.0 + 0.2 * (5.0 * d.x + 3.0 * d.y).sin());
        for p in &mut mesh.positions {
            *p = *p * size + Vec3::splat(offset);
        }
        let tree = RayTree::build(&mesh);
        for face in 0..mesh.faces.len() {
            let corners = mesh.corners(face);
            for step in 0..=30 {
                let origin =
                    Vec3::new(0.1, -0.05, 0.02 * f64::from(step % 3)) * size + Vec3::splat(offset);
                for side in 0..3 {
                    let (a, b) = (corners[side], corners[(side + 1) % 3]);
                    let target = a + (b - a) * (f64::from(step) / 30.0);
                    let ray = Ray::new(origin, target - origin);
                    assert!(tree.first_hit(&ray).is_some(), "{n} {face} {step} {side}");
                }
            }
        }
    }
}

/// No faces: nothing is hit.
#[test]
fn empty_mesh() {
    let tree = RayTree::build(&Mesh::default());
    let ray = Ray::new(Vec3::zero(), Vec3::new(0.0, 0.0, 1.0));
    assert_eq!((tree.first_hit(&ray), tree.occluded(&ray)), (None, false));
    assert_eq!(tree.validate(&Mesh::default()), Ok(()));
}

/// All triangles in one place, where no split helps: still a tree.
#[test]
fn many_equal_triangles() {
    let mut mesh = meshes::sheet(1, |_, _| 0.0);
    let faces = mesh.faces[0];
    mesh.faces = vec![faces; 5000];
    let tree = RayTree::build(&mesh);
    assert_eq!(tree.validate(&mesh), Ok(()));
    let ray = Ray::new(Vec3::new(0.3, -0.2, 1.0), Vec3::new(0.0, 0.0, -1.0));
    assert_eq!(tree.first_hit(&ray), oracle::first_hit(&mesh, &ray));
}

/// A tree that has followed one motion after another answers as a new one does,
/// bit for bit, and knows how much slower it has become.
#[test]
fn refitted_trees_answer_like_new_ones() {
    let mesh = meshes::ball(20, |d| 1.0 + 0.1 * (9.0 * d.x).sin() * (7.0 * d.y).sin());
    let mut tree = RayTree::build(&mesh);
    assert_eq!(tree.degradation(), 1.0);
    for (name, motion) in meshes::MOTIONS {
        let moved = meshes::with_positions(&mesh, motion);
        tree.refit(&moved);
        assert_eq!(tree.validate(&moved), Ok(()), "{name}");
        let new = RayTree::build(&moved);
        let (low, high) = moved.bounds();
        let above = Vec3::new(0.0, 0.0, 0.2 * (high - low).length());
        let mut hits = 0;
        for i in 0..2000 {
            // From near and far, at points of faces.
            let [a, b, c] = moved.corners((i * 97) % moved.faces.len());
            let target = a * 0.2 + b * 0.3 + c * 0.5;
            let start = mesh.positions[(i * 31) % mesh.positions.len()];
            let origin = motion(start * [0.3, 1.0, 1.5, 40.0][i % 4]) + above;
            let ray = Ray::new(origin, target - origin);
            let found = tree.first_hit(&ray);
            hits += usize::from(found.is_some());
            assert_eq!(found, new.first_hit(&ray), "{name}, {ray:?}");
            assert_eq!(tree.occluded(&ray), found.is_some(), "{name}, {ray:?}");
            if i % 50 == 0 {
                assert_eq!(found, oracle::first_hit(&moved, &ray), "{name}, {ray:?}");
            }
        }
        let has_area = moved.area() > 0.0;
        assert_eq!(hits > 500, has_area, "{name}: {hits} hits");
        let degradation = tree.degradation();
        let expected = match name {
            "crumpled" => 1.5..20.0,
            _ => 0.9..1.2,
        };
        let is_comparable = has_area && name != "flat";
        assert!(
            !is_comparable || expected.contains(&degradation),
            "{name}: {degradation}"
        );
    }
}

/// Trees keep what they need, and threads may share them.
#[test]
fn trees_are_owned_and_shared() {
    fn check<T: Send + Sync + 'static>() {}
    check::<RayTree>();
    check::<SilhouetteTree>();
}

/// A tree does not pass for another mesh's.
#[test]
fn validation_notices_moved_vertices() {
    let mesh = meshes::ball(3, |_| 1.0);
    let mut tree = RayTree::build(&mesh);
    let moved = meshes::ball(3, |d| 1.0 + 0.1 * d.x);
    assert!(matches!(
        tree.validate(&moved),
        Err(TreeError::LeafContent { .. })
    ));
    tree.refit(&moved);
    assert_eq!(tree.validate(&moved), Ok(()));
}

/// Balls of very different sizes beside, inside and on each other.
pub fn wide_mesh(divisions: usize) -> Mesh {
    let mut mesh = Mesh::default();
    let places = [
        (Vec3::zero(), 1.0),
        (Vec3::new(0.0, -4e9 - 1.0, 0.0), 4e9),
        (Vec3::new(3e4, 5.0, -2e4), 2.0),
        (Vec3::new(0.3, 0.9, 0.1), 3e-7),
        (Vec3::new(0.2, 1.1, 0.0), 0.25),
    ];
    for (centre, radius) in places {
        let mut ball = meshes::ball(divisions, |_| 1.0);
        ball.positions
            .iter_mut()
            .for_each(|p| *p = centre + *p * radius);
        mesh.append(&ball);
    }
    mesh
}

/// Small things in a wide scene are found as by brute force, bit for bit, from near and far; also
/// after they moved.
#[test]
fn small_things_in_wide_scenes_are_found() {
    let mesh = wide_mesh(8);
    let mut tree = RayTree::build(&mesh);
    let mut moved = mesh.clone();
    for p in &mut moved.positions {
        p.x += 0.25 * p.y.clamp(-1.0, 1.0);
    }
    let mut hits = 0;
    for mesh in [&mesh, &moved] {
        tree.refit(mesh);
        let count = mesh.faces.len();
        let rays = (0..3000).map(|i| {
            let [a, b, c] = mesh.corners((i * 97) % count);
            let target = a * 0.2 + b * 0.3 + c * 0.5;
            let from = mesh.corners((i * 611 + 5) % count)[0];
            let away = [1.0, 1.0 + 1e-9, 1.5, 1e3][i % 4];
            let origin = target + (from - target) * away;
            let t_max = [f64::INFINITY, 1.0, 1e-3][i % 3];
            Ray {
                t_max,
                ..Ray::new(origin, target - origin)
            }
        });
        let rays: Vec<Ray> = rays.collect();
        hits += rays
            .iter()
            .filter(|ray| tree.first_hit(ray).is_some())
            .count();
        check(&tree, mesh, &rays).unwrap();
    }
    assert!(hits > 2000, "{hits}");
}

/// Rays near a small ball test few of its triangles, however wide the scene is: all of them would
/// take a minute.
#[test]
fn small_things_in_wide_scenes_are_told_apart() {
    let mesh = wide_mesh(40);
    let tree = RayTree::build(&mesh);
    let started = std::time::Instant::now();
    let mut hits = 0;
    for i in 0..300_000 {
        let [a, b, c] = mesh.corners((i * 97) % (mesh.faces.len() / 5));
        let target = a * 0.2 + b * 0.3 + c * 0.5;
        let ray = Ray {
            t_max: 1.0 + 1e-9,
            ..Ray::new(target * 1.1, target * -0.1)
        };
        hits += usize::from(tree.first_hit(&ray).is_some());
    }
    assert_eq!(hits, 300_000);
    let taken = started.elapsed().as_secs_f64();
    assert!(taken < 8.0, "{taken} s");
}
