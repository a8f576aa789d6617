//! The flat arrays hold what their documentation says: read as a device reads them.

use super::meshes;
use crate::buffers::{CONE_NODE, EDGE, FLIPPED, LEAF, NONE, RAY_NODE, TRIANGLE};
use crate::edge::{Sides, separates};
use crate::{RayTree, SilhouetteTree, topology};
use capwalk_math::Vec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// What single precision adds to the sides of boxes, local units.
const ROUNDING: f64 = 1.0 / (1 << 20) as f64;

/// How the words of a child are found: `child(node, slot)`.
type ChildWord<'a> = &'a dyn Fn(usize, usize) -> u32;

/// Calls `visit` with each primitive, and with the node and slot of every child above it.
fn walk(
    leaf_starts: &[u32],
    child: ChildWord,
    node: usize,
    above: &mut Vec<[usize; 2]>,
    visit: &mut dyn FnMut(usize, &[[usize; 2]]),
) {
    let mut is_over = false;
    for slot in 0..8 {
        let word = child(node, slot);
        assert!(word == NONE || !is_over, "slots in use come first");
        is_over = word == NONE;
        if is_over {
            continue;
        }
        above.push([node, slot]);
        if word & LEAF == 0 {
            assert!(word as usize > node, "children come after their parents");
            walk(leaf_starts, child, word as usize, above, visit);
        } else {
            let leaf = (word & !LEAF) as usize;
            for primitive in leaf_starts[leaf]..leaf_starts[leaf + 1] {
                visit(primitive as usize, above);
            }
        }
        above.pop();
    }
}

/// The primitive is among those that are said to be below a child.
fn is_below(below: &[u32], [node, slot]: [usize; 2], primitive: usize) -> bool {
    let range = &below[2 * (8 * node + slot)..][..2];
    (range[0] as usize..range[1] as usize).contains(&primitive)
}

fn numbers(words: &[u32]) -> Vec<f64> {
    words
        .iter()
        .map(|&word| f64::from(f32::from_bits(word)))
        .collect()
}

fn vector(numbers: &[f64]) -> Vec3 {
    Vec3::new(numbers[0], numbers[1], numbers[2])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, rng_seed: RngSeed::Fixed(3), failure_persistence: None, ..Default::default() })]

    /// Every triangle is reached once, lies in all boxes above it, and has the mesh's corners.
    #[test]
    fn triangles((mesh, _) in meshes::mesh()) {
        let buffers = RayTree::build(&mesh).buffers();
        let mut times = vec![0; mesh.faces.len()];
        prop_assert_eq!(buffers.triangles.len(), TRIANGLE * times.len());
        let child = |node: usize, slot: usize| buffers.nodes[RAY_NODE * node + 48 + slot];
        let visit = &mut |i: usize, above: &[[usize; 2]]| {
            let face = buffers.faces[i] as usize;
            times[face] += 1;
            let corners = buffers.triangles[TRIANGLE * i..][..TRIANGLE].chunks(3).map(vector);
            for (corner, expected) in corners.zip(mesh.corners(face)) {
                assert_eq!(corner, expected);
                let local = buffers.frame.local_from_world(corner).to_array();
                for &[node, slot] in above {
                    assert!(is_below(&buffers.below, [node, slot], i));
                    let planes = numbers(&buffers.nodes[RAY_NODE * node..][..48]);
                    let is_inside = |axis: usize| {
                        let [low, high] = [axis, axis + 3].map(|plane| planes[8 * plane + slot]);
                        low <= local[axis] && local[axis] <= high
                    };
                    assert!((0..3).all(is_inside));
                }
            }
        };
        if !mesh.faces.is_empty() {
            walk(&buffers.leaf_starts, &child, 0, &mut Vec::new(), visit);
        }
        prop_assert!(times.iter().all(|&times| times == 1));
        for (local, exact) in buffers.local_triangles().chunks(3).zip(buffers.triangles.chunks(3)) {
            let expected = buffers.frame.local_from_world(vector(exact)).to_array();
            prop_assert_eq!(local, expected.map(|v| v as f32));
        }
    }

    /// Every edge is reached once, its ends lie in all boxes above it, and it is a silhouette
    /// where the mesh says so.
    #[test]
    fn edges((mesh, place) in meshes::mesh(), views in prop::collection::vec(meshes::spot(), 10)) {
        let edges = topology::edges(&mesh);
        let buffers = SilhouetteTree::build(&mesh, &edges).buffers();
        let mut times = vec![0; edges.len()];
        let row = |node: usize, slot: usize, row: usize| {
            buffers.nodes[CONE_NODE * node + 32 * row + 4 * slot..][..4].to_vec()
        };
        let child = |node: usize, slot: usize| row(node, slot, 3)[2];
        let local_edges = buffers.local_edges();
        let visit = &mut |i: usize, above: &[[usize; 2]]| {
            let id = buffers.edges[2 * i] as usize;
            let edge = &edges[id];
            times[id] += 1;
            assert_eq!(buffers.edges[2 * i + 1], u32::from(edge.groups));
            let exact = &buffers.ends_and_normals[EDGE * i..][..EDGE];
            let [a, b, first, second] = [0, 3, 6, 9].map(|at| vector(&exact[at..]));
            assert_eq!([a, b], edge.vertices.map(|v| mesh.positions[v as usize]));
            assert_eq!([first.length(), second.length()], exact[12..]);
            for view in &views {
                let view = view.position(&mesh, &place);
                assert_eq!(separates([first, second], a, false, view), edge.is_silhouette(&mesh, view));
            }
            let local = &local_edges[EDGE * i..][..EDGE];
            let local: Vec<f64> = local.iter().map(|&v| f64::from(v)).collect();
            let ends = [a, b].map(|p| buffers.frame.local_from_world(p));
            assert!((vector(&local) - ends[0]).length() < ROUNDING);
            assert!((vector(&local) + vector(&local[3..]) - ends[1]).length() < ROUNDING);
            let sides = match edge.sides {
                Sides::Open => [NONE; 2],
                Sides::Between { faces: [first, second], flipped } => {
                    [first, second + u32::from(flipped) * FLIPPED]
                }
            };
            assert_eq!(buffers.sides[4 * i..][..4], [edge.vertices, sides].concat());
            for &[node, slot] in above {
                assert!(is_below(&buffers.below, [node, slot], i));
                let words: Vec<u32> = (0..4).flat_map(|i| row(node, slot, i)).collect();
                assert_eq!(words[15] & u32::from(edge.groups), u32::from(edge.groups));
                let child = numbers(&words[..14]);
                let [centre, first, second] = [0, 4, 8].map(|at| vector(&child[at..]));
                let third = first.cross(second);
                let volume = first.cross(second).dot(third);
                let duals = [second.cross(third), third.cross(first), third].map(|v| v * (1.0 / volume));
                for end in ends {
                    for (dual, half) in duals.iter().zip([child[7], child[11], child[13]]) {
                        assert!(dual.dot(end - centre).abs() <= half + 4.0 * ROUNDING);
                    }
                }
            }
        };
        if !edges.is_empty() {
            walk(&buffers.leaf_starts, &child, 0, &mut Vec::new(), visit);
        }
        prop_assert!(times.iter().all(|&times| times == 1));
    }
}
