//! What crosses a wedge, against brute force.

use capwalk_math::Vec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::meshes::{self, Spot};
use crate::{Apex, RayTree, Wedge, oracle};

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, rng_seed: RngSeed::Fixed(5), failure_persistence: None, ..Default::default() })]

    /// The tree finds the sections that brute force finds, bit for bit; also after vertices
    /// moved.
    #[test]
    fn tree_is_brute_force(
        (mesh, place) in meshes::mesh(),
        spots in prop::collection::vec(([meshes::spot(), meshes::spot(), meshes::spot()], any::<bool>()), 12),
        seed in 1..u64::MAX,
    ) {
        let mut tree = RayTree::build(&mesh);
        let mut found = Vec::new();
        for mesh in [mesh.clone(), meshes::moved(&mesh, &place, 1.0, seed)] {
            tree.refit(&mesh);
            for (spots, is_point) in &spots {
                let [light, a, b] = spots.each_ref().map(|spot: &Spot| spot.position(&mesh, &place));
                let apex = match is_point {
                    true => Apex::Point(light),
                    false => Apex::Direction(a - light),
                };
                let Some(wedge) = Wedge::new(apex, [a, b]) else {
                    continue;
                };
                tree.across(&mesh, &wedge, &mut found);
                prop_assert_eq!(&found, &oracle::across(&mesh, &wedge), "{:?}", wedge);
            }
        }
    }
}

/// The same where some things are millions of times smaller than others.
#[test]
fn small_things_in_wide_scenes_are_found() {
    let mut mesh = meshes::ball(12, |_| 1.0);
    for (size, x) in [(1e-7, 0.9), (3e8, 0.0)] {
        let mut other = meshes::ball(12, |_| size);
        other.positions.iter_mut().for_each(|p| p.x += x);
        mesh.append(&other);
    }
    let tree = RayTree::build(&mesh);
    let (mut found, mut count) = (Vec::new(), 0);
    for i in 0..600 {
        let [a, b, _] = mesh.corners((i * 97) % mesh.faces.len());
        let light = Vec3::new(2.0, 3.0, 0.1 * (i % 9) as f64);
        let Some(wedge) = Wedge::new(Apex::Point(light), [a, b]) else {
            continue;
        };
        tree.across(&mesh, &wedge, &mut found);
        assert_eq!(found, oracle::across(&mesh, &wedge), "{wedge:?}");
        count += found.len();
    }
    assert!(count > 1000, "{count}");
}
