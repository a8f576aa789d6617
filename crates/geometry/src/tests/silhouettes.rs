//! The silhouette tree against brute force.

use std::ops::ControlFlow;

use super::meshes::{self, Place, Spot};
use crate::bvh::validate::TreeError;
use crate::simd::Instructions;
use crate::{
    ConeQuery, Edge, EdgeSelection, HalfSpace, Mesh, SilhouettePoint, SilhouetteTree, oracle,
    topology,
};
use capwalk_math::Vec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A query in words.
#[derive(Clone, Copy, Debug)]
struct View {
    viewpoint: Spot,
    towards: Result<Spot, Vec3>,
    max_angle: f64,
    edges: EdgeSelection,
    groups: u8,
    plane: Option<(Spot, Vec3)>,
}

fn view() -> impl Strategy<Value = View> {
    let towards = prop_oneof![
        meshes::spot().prop_map(Ok),
        meshes::direction().prop_map(Err)
    ];
    let max_angle = prop_oneof![
        3 => Just(std::f64::consts::PI),
        2 => 0.0..0.5_f64,
        1 => 0.0..3.2_f64,
        1 => (-12.0..-3.0_f64).prop_map(|digits| 10_f64.powf(digits)),
    ];
    let edges = prop_oneof![3 => Just(EdgeSelection::Silhouettes), 1 => Just(EdgeSelection::All)];
    let groups = prop_oneof![2 => Just(u8::MAX), 1 => any::<u8>()];
    let plane = prop::option::weighted(0.3, (meshes::spot(), meshes::point()));
    (meshes::spot(), towards, max_angle, edges, groups, plane).prop_map(
        |(viewpoint, towards, max_angle, edges, groups, plane)| View {
            viewpoint,
            towards,
            max_angle,
            edges,
            groups,
            plane,
        },
    )
}

impl View {
    fn query(&self, mesh: &Mesh, place: &Place) -> ConeQuery {
        let viewpoint = self.viewpoint.position(mesh, place);
        let axis = match self.towards {
            Ok(spot) => (spot.position(mesh, place) - viewpoint).normalized(),
            Err(direction) => direction,
        };
        ConeQuery {
            apex: viewpoint,
            axis: if axis.is_finite() {
                axis
            } else {
                Vec3::new(0.0, 0.6, 0.8)
            },
            max_angle: self.max_angle,
            edges: self.edges,
            groups: self.groups,
            in_front_of: self.plane.map(|(spot, normal)| HalfSpace {
                point: spot.position(mesh, place),
                normal,
            }),
        }
    }
}

/// What the tree gathers, in its order.
fn gathered(tree: &SilhouetteTree, query: &ConeQuery) -> Vec<u32> {
    let mut found = Vec::new();
    tree.gather(query, None, |edge, _| {
        found.push(edge);
        ControlFlow::Continue(())
    });
    found
}

/// True if each edge that is gathered comes with its own ends.
fn ends_are_right(tree: &SilhouetteTree, mesh: &Mesh, edges: &[Edge], query: &ConeQuery) -> bool {
    let mut right = true;
    tree.gather(query, None, |edge, ends| {
        let vertices = edges[edge as usize].vertices;
        right &= ends == vertices.map(|i| mesh.positions[i as usize]);
        ControlFlow::Continue(())
    });
    right
}

/// Queries that one of the edges found only just meets, or misses by as little:
/// with limits around its angle, and with planes around its ends. Rounding alone
/// decides which, and must decide as brute force does.
fn close_calls(mesh: &Mesh, edges: &[Edge], query: &ConeQuery, found: u32) -> Vec<ConeQuery> {
    let is_it = |point: &SilhouettePoint| point.edge == found;
    let point = oracle::closest_silhouette_where(mesh, edges, query, is_it);
    let angle = point.expect("it was found").angle;
    let limits = [
        angle * (1.0 - 1e-5),
        angle,
        angle.next_up(),
        angle * (1.0 + 1e-5),
    ];
    let limited = limits.map(|max_angle| ConeQuery {
        max_angle,
        ..*query
    });
    let ends = edges[found as usize]
        .vertices
        .map(|i| mesh.positions[i as usize]);
    let normal = query.axis.cross(Vec3::new(0.3, -0.5, 0.8)) + query.axis * 0.1;
    let highest = match ends[0].dot(normal) > ends[1].dot(normal) {
        true => ends[0],
        false => ends[1],
    };
    let size = (highest - query.apex).length();
    let cut = [-1e-6, 0.0, 1e-12, 1e-6].map(|lift| ConeQuery {
        in_front_of: Some(HalfSpace {
            point: highest + normal * (lift * size),
            normal,
        }),
        ..*query
    });
    [limited, cut].concat()
}

fn sorted(mut numbers: Vec<u32>) -> Vec<u32> {
    numbers.sort_unstable();
    numbers
}

fn check(
    tree: &SilhouetteTree,
    mesh: &Mesh,
    edges: &[Edge],
    queries: &[ConeQuery],
) -> Result<(), TestCaseError> {
    tree.validate(mesh, edges)
        .map_err(|error| TestCaseError::fail(format!("{error:?}")))?;
    let slower = Instructions::slower()
        .into_iter()
        .map(|it| tree.clone().with(it));
    let slower: Vec<_> = slower.collect();
    for (i, query) in queries.iter().enumerate() {
        let expected = oracle::closest_silhouette(mesh, edges, query);
        prop_assert_eq!(tree.closest(query), expected, "{:?}", query);
        for tree in &slower {
            prop_assert_eq!(tree.closest(query), expected, "{:?}", query);
        }
        let accept = |point: &SilhouettePoint| point.edge % 3 == 1;
        let expected = oracle::closest_silhouette_where(mesh, edges, query, accept);
        prop_assert_eq!(tree.closest_where(query, &accept), expected, "{:?}", query);
        let expected = oracle::gather(mesh, edges, query);
        let found = gathered(tree, query);
        for tree in &slower {
            prop_assert_eq!(&gathered(tree, query), &found, "{:?}", query);
        }
        let any = found.len().checked_sub(1).map(|last| found[i % (last + 1)]);
        prop_assert_eq!(sorted(found.clone()), expected, "{:?}", query);
        // Everywhere, in a part of the mesh, and none.
        let of_part = |edge: u32| edge as usize * 8 < edges.len();
        for contains in [&|edge| edge % 2 == 1, &of_part, &|_| false] as [&dyn Fn(u32) -> bool; 3] {
            let subset = tree.subset(contains);
            let mut among = Vec::new();
            tree.gather(query, Some(&subset), |edge, _| {
                among.push(edge);
                ControlFlow::Continue(())
            });
            let expected: Vec<u32> = found.iter().copied().filter(|&e| contains(e)).collect();
            prop_assert_eq!(
                tree.meets(query, &subset),
                !expected.is_empty(),
                "{:?}",
                query
            );
            prop_assert_eq!(among, expected, "{:?}", query);
        }
        prop_assert!(ends_are_right(tree, mesh, edges, query), "{:?}", query);
        for close in any.map_or_else(Vec::new, |any| close_calls(mesh, edges, query, any)) {
            let expected = oracle::gather(mesh, edges, &close);
            prop_assert_eq!(sorted(gathered(tree, &close)), expected, "{:?}", close);
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
        views in prop::collection::vec(view(), 20),
        groups in prop::collection::vec(any::<u8>(), 5),
        seed in 1..u64::MAX,
    ) {
        let mut edges = topology::edges(&mesh);
        for (edge, &groups) in edges.iter_mut().zip(groups.iter().cycle()) {
            edge.groups = groups;
        }
        let queries_at =
            |mesh: &Mesh| views.iter().map(|view| view.query(mesh, &place)).collect::<Vec<_>>();
        let mut tree = SilhouetteTree::build(&mesh, &edges);
        check(&tree, &mesh, &edges, &queries_at(&mesh))?;
        let moved = meshes::moved(&mesh, &place, 1.0, seed);
        tree.refit(&moved);
        check(&tree, &moved, &edges, &queries_at(&moved))?;
    }
}

fn query(viewpoint: Vec3, axis: Vec3, max_angle: f64) -> ConeQuery {
    ConeQuery {
        apex: viewpoint,
        axis,
        max_angle,
        edges: EdgeSelection::Silhouettes,
        groups: u8::MAX,
        in_front_of: None,
    }
}

/// Larger meshes than above, with several levels of nodes, from viewpoints on and
/// near the surface, looking along it, at silhouettes down to 1e-9 radians.
#[test]
fn deep_trees_are_brute_force() {
    let mesh = meshes::ball(20, |d| 1.0 + 0.1 * (9.0 * d.x).sin() * (7.0 * d.y).sin());
    let edges = topology::edges(&mesh);
    let tree = SilhouetteTree::build(&mesh, &edges);
    assert_eq!(tree.validate(&mesh, &edges), Ok(()));
    for i in 0..300 {
        let face = (i * 97) % mesh.faces.len();
        let [a, b, c] = mesh.corners(face);
        let height = [0.0, 1e-3, 0.5, 3.0][i % 4];
        let viewpoint = (a + b + c) / 3.0 * (1.0 + height);
        let axis = (mesh.positions[(i * 31) % mesh.positions.len()] - viewpoint).normalized();
        let wide = query(viewpoint, axis, 4.0);
        let found = oracle::closest_silhouette(&mesh, &edges, &wide);
        assert_eq!(tree.closest(&wide), found);
        // Aimed past the silhouette by a little.
        let point = found.expect("a closed surface has a silhouette");
        for (selection, angle) in [(EdgeSelection::Silhouettes, 0.4), (EdgeSelection::All, 0.1)] {
            let query = ConeQuery {
                edges: selection,
                max_angle: angle,
                axis: point.direction,
                ..wide
            };
            let found = gathered(&tree, &query);
            assert_eq!(sorted(found), oracle::gather(&mesh, &edges, &query));
        }
        for digits in [3, 6, 9] {
            let aside = Vec3::new(0.3, -0.8, 0.5) * 10_f64.powi(-digits);
            let axis = (point.direction + aside).normalized();
            let query = query(viewpoint, axis, [4.0, 1e-2][i % 2]);
            assert_eq!(
                tree.closest(&query),
                oracle::closest_silhouette(&mesh, &edges, &query)
            );
        }
    }
}

/// Viewpoints a hair off the plane of a face that they look at: in single precision
/// its edges may or may not be silhouettes, and must not limit the search.
#[test]
fn eyes_near_the_plane_of_a_face() {
    let mesh = meshes::ball(9, |d| 1.0 + 0.1 * (9.0 * d.x).sin() * (7.0 * d.y).sin());
    let edges = topology::edges(&mesh);
    let tree = SilhouetteTree::build(&mesh, &edges);
    for i in 0..2000 {
        let [a, b, c] = mesh.corners((i * 97) % mesh.faces.len());
        let normal = (b - a).cross(c - a).normalized();
        let height = [1e-7, -1e-7, 1e-8, -1e-8, 1e-6][i % 5];
        let viewpoint = a + (a - b) * (3.0 + (i % 7) as f64) + (a - c) * 2.0 + normal * height;
        let axis = (b * 0.4 + c * 0.6 - viewpoint).normalized();
        let query = query(viewpoint, axis, 4.0);
        let expected = oracle::closest_silhouette(&mesh, &edges, &query);
        assert_eq!(tree.closest(&query), expected, "{query:?}");
    }
}

/// A tree that has followed one motion after another answers as a new one does,
/// also where the cones of normals have become wide: the same closest
/// silhouettes, bit for bit, and the same edges gathered.
#[test]
fn refitted_trees_answer_like_new_ones() {
    let mesh = meshes::ball(20, |_| 1.0);
    let edges = topology::edges(&mesh);
    let mut tree = SilhouetteTree::build(&mesh, &edges);
    assert_eq!(tree.degradation(), 1.0);
    for (name, motion) in meshes::MOTIONS {
        let moved = meshes::with_positions(&mesh, motion);
        tree.refit(&moved);
        assert_eq!(tree.validate(&moved, &edges), Ok(()), "{name}");
        let new = SilhouetteTree::build(&moved, &edges);
        for i in 0..400 {
            let start = mesh.positions[(i * 31) % mesh.positions.len()];
            let viewpoint = motion(start * [0.3, 1.0, 1.5, 40.0][i % 4]);
            let target = moved.positions[(i * 57) % moved.positions.len()];
            let axis = (target - viewpoint).normalized();
            if !axis.is_finite() {
                continue;
            }
            let mut query = query(viewpoint, axis, [4.0, 0.3, 1e-3][i % 3]);
            if i % 5 == 0 {
                query.edges = EdgeSelection::All;
            }
            let found = tree.closest(&query);
            assert_eq!(found, new.closest(&query), "{name}, {query:?}");
            let counts = |point: &SilhouettePoint| point.edge.is_multiple_of(3);
            assert_eq!(
                tree.closest_where(&query, &counts),
                new.closest_where(&query, &counts),
                "{name}, {query:?}"
            );
            let gathered = sorted(gathered(&tree, &query));
            assert_eq!(gathered, sorted(self::gathered(&new, &query)), "{name}");
            if i % 20 == 0 {
                assert_eq!(found, oracle::closest_silhouette(&moved, &edges, &query));
                assert_eq!(gathered, oracle::gather(&moved, &edges, &query));
            }
        }
        if name == "crumpled" {
            assert!(tree.degradation() > 1.5, "{}", tree.degradation());
        }
    }
    assert_eq!(tree.degradation(), 1.0);
}

/// Nothing to find: no edges; an angle limit of zero; no groups.
#[test]
fn nothing_is_found() {
    let axis = Vec3::new(0.0, 0.0, 1.0);
    let empty = SilhouetteTree::build(&Mesh::default(), &[]);
    assert_eq!(empty.closest(&query(Vec3::zero(), axis, 4.0)), None);
    let mesh = meshes::sheet(2, |_, _| 0.0);
    let tree = SilhouetteTree::build(&mesh, &topology::edges(&mesh));
    let viewpoint = Vec3::new(0.1, 0.2, -1.0);
    assert!(tree.closest(&query(viewpoint, axis, 4.0)).is_some());
    for max_angle in [0.0, -1.0, f64::NAN] {
        assert_eq!(tree.closest(&query(viewpoint, axis, max_angle)), None);
        assert!(gathered(&tree, &query(viewpoint, axis, max_angle)).is_empty());
    }
    let no_groups = ConeQuery {
        groups: 0,
        ..query(viewpoint, axis, 4.0)
    };
    assert_eq!(tree.closest(&no_groups), None);
    assert!(gathered(&tree, &no_groups).is_empty());
    assert!(gathered(&empty, &query(viewpoint, axis, 4.0)).is_empty());
}

/// A tree does not pass for another mesh's, nor for other groups.
#[test]
fn validation_notices_changes() {
    let mesh = meshes::ball(3, |_| 1.0);
    let edges = topology::edges(&mesh);
    let mut tree = SilhouetteTree::build(&mesh, &edges);
    let mut regrouped = edges.clone();
    regrouped[5].groups = 1;
    assert!(matches!(
        tree.validate(&mesh, &regrouped),
        Err(TreeError::LeafContent { .. })
    ));
    let moved = meshes::ball(3, |d| 1.0 + 0.1 * d.x);
    assert!(matches!(
        tree.validate(&moved, &edges),
        Err(TreeError::LeafContent { .. })
    ));
    tree.refit(&moved);
    assert_eq!(tree.validate(&moved, &edges), Ok(()));
}
