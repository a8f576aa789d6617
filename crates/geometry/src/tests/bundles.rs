//! Bundles of rays against brute force.

use capwalk_math::Vec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::meshes;
use super::rays::{aim, wide_mesh};
use crate::simd::Instructions;
use crate::{BUNDLE, Bundle, Mesh, Ray, RayTree, oracle};

/// The rays of a bundle.
struct Rays {
    origin: [[f64; BUNDLE]; 3],
    direction: [[f64; BUNDLE]; 3],
    range: [[f64; BUNDLE]; 2],
}

impl Rays {
    fn new(rays: &[Ray; BUNDLE]) -> Self {
        let numbers =
            |of: fn(&Ray) -> Vec3| [0, 1, 2].map(|axis| rays.each_ref().map(|ray| of(ray)[axis]));
        Self {
            origin: numbers(|ray| ray.origin),
            direction: numbers(|ray| ray.direction),
            range: [rays.map(|ray| ray.t_min), rays.map(|ray| ray.t_max)],
        }
    }

    fn bundle(&self, mask: u32) -> Bundle<'_> {
        Bundle {
            origin: &self.origin,
            direction: &self.direction,
            range: self.range.each_ref(),
            mask,
        }
    }
}

/// Numbers between -1 and 1 that are spread evenly, by a number of their own.
pub fn spread(i: usize) -> Vec3 {
    Vec3::from([0.618_034, 0.754_878, 0.569_840].map(|k| 2.0 * (i as f64 * k).fract() - 1.0))
}

/// Rays around another one: how far their origins are from its own and their targets from a point
/// on it, in parts of what lies between.
pub fn beam(ray: &Ray, seed: usize, [origins, targets]: [f64; 2]) -> [Ray; BUNDLE] {
    let length = ray.direction.length();
    std::array::from_fn(|i| {
        let [from, to] = [0, BUNDLE].map(|k| spread(seed + k + i) * length);
        Ray {
            origin: ray.origin + from * origins,
            direction: ray.direction + to * targets - from * origins,
            // Some end early.
            t_max: if i % 5 == 4 {
                0.5 * ray.t_max
            } else {
                ray.t_max
            },
            ..*ray
        }
    })
}

/// Compares all rays with brute force; how many hit something.
pub fn check(tree: &RayTree, mesh: &Mesh, rays: &[Ray; BUNDLE], mask: u32) -> usize {
    let slower = Instructions::slower().into_iter();
    let slower = slower.map(|instructions| tree.clone().with(instructions));
    let own = Rays::new(rays);
    let bundle = own.bundle(mask);
    for tree in slower.chain([tree.clone()]) {
        let (faces, occluded) = (tree.first_hits(&bundle), tree.occluded_rays(&bundle));
        for (i, ray) in rays.iter().enumerate() {
            let is_asked = mask >> i & 1 == 1;
            let expected = oracle::first_hit(mesh, ray).filter(|_| is_asked);
            let expected = expected.map_or(u32::MAX, |hit| hit.face);
            assert_eq!(faces[i], expected, "{i} of {mask:b}: {ray:?}");
            let expected = is_asked && oracle::occluded(mesh, ray);
            assert_eq!(occluded >> i & 1 == 1, expected, "{i} of {mask:b}: {ray:?}");
        }
    }
    tree.occluded_rays(&bundle).count_ones() as usize
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, rng_seed: RngSeed::Fixed(11), failure_persistence: None, ..Default::default() })]

    /// The tree finds what brute force finds, of rays that go any ways and of beams, wide and narrow.
    #[test]
    fn bundles_are_brute_force(
        (mesh, place) in meshes::mesh(),
        aims in prop::collection::vec(aim(), BUNDLE),
        mask in prop_oneof![Just(0xffff_u32), 0..0x1_0000_u32],
        widths in prop_oneof![
            Just([0.0, 0.001]),
            Just([0.0, 0.1]),
            Just([0.01, 0.02]),
            Just([0.2, 0.2]),
            Just([0.0, 0.0]),
        ],
        seed in 0..1000_usize,
    ) {
        let tree = RayTree::build(&mesh);
        let rays: Vec<Ray> = aims.iter().map(|aim| aim.ray(&mesh, &place)).collect();
        check(&tree, &mesh, &beam(&rays[0], seed, widths), mask);
        check(&tree, &mesh, &beam(&rays[1], seed, widths), 0xffff);
        check(&tree, &mesh, &rays.try_into().expect("as many as there are"), mask);
    }
}

/// Beams through a ball of many triangles, each of which has its own: rays part on their way down.
#[test]
fn beams_split() {
    let mesh = meshes::ball(24, |d| 1.0 + 0.1 * (9.0 * d.x).sin() * (7.0 * d.y).sin());
    let tree = RayTree::build(&mesh);
    let mut hits = 0;
    for i in 0..300 {
        let origin = spread(3 * i) * [3.0, 1.5, 0.3][i % 3];
        let direction = spread(5 * i + 1) - origin;
        let width = [0.3, 0.1, 0.03, 0.003][i % 4];
        let rays = beam(&Ray::new(origin, direction), i, [0.0, width]);
        hits += check(&tree, &mesh, &rays, 0xffff);
    }
    assert!(hits > 3000, "{hits}");
}

/// Small things in a wide scene, which have trees of their own.
#[test]
fn bundles_find_small_things_in_wide_scenes() {
    let mesh = wide_mesh(6);
    let tree = RayTree::build(&mesh);
    let mut hits = 0;
    for i in 0..60 {
        let target = mesh.corners((i * 97) % mesh.faces.len())[0];
        let origin = target + spread(i) * [1e-6, 1.0, 1e5][i % 3];
        let rays = beam(&Ray::new(origin, target - origin), i, [0.0, 0.1]);
        hits += check(&tree, &mesh, &rays, 0xffff);
    }
    assert!(hits > 500, "{hits}");
}

/// Rays that are not finite, or lead nowhere, hit nothing, and hide nothing from the others.
#[test]
fn bad_rays_do_not_harm_others() {
    let mesh = meshes::ball(5, |_| 1.0);
    let tree = RayTree::build(&mesh);
    let ray = Ray::new(Vec3::new(0.1, 0.2, 3.0), Vec3::new(0.0, 0.0, -1.0));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1e-320] {
        for lane in 0..BUNDLE {
            let mut rays = beam(&ray, lane, [0.0, 0.05]);
            rays[lane].direction = Vec3::new(0.0, 0.0, bad);
            check(&tree, &mesh, &rays, 0xffff);
            check(&tree, &mesh, &rays, !(1 << lane) & 0xffff);
            let mut rays = beam(&ray, lane, [0.0, 0.05]);
            rays[lane].origin.x = bad;
            check(&tree, &mesh, &rays, 0xffff);
            let mut rays = beam(&ray, lane, [0.0, 0.05]);
            rays[lane].t_max = bad;
            check(&tree, &mesh, &rays, 0xffff);
            let mut rays = beam(&ray, lane, [0.0, 0.05]);
            rays[lane].t_min = bad;
            check(&tree, &mesh, &rays, 0xffff);
        }
    }
}

/// Whoever finds them, faces in one place are found by their number.
#[test]
fn lowest_of_coincident_faces_is_found() {
    let mut mesh = meshes::ball(6, |_| 1.0);
    let faces = mesh.faces.clone();
    (0..3).for_each(|_| mesh.faces.extend(faces.iter().rev()));
    let tree = RayTree::build(&mesh);
    for i in 0..100 {
        let origin = spread(7 * i) * 3.0;
        let rays = beam(&Ray::new(origin, spread(i) * 0.5 - origin), i, [0.0, 0.05]);
        check(&tree, &mesh, &rays, 0xffff);
    }
}
