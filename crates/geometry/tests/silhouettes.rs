//! The silhouette tree against brute force.

mod common;

use capwalk_geometry::{
    ConeQuery, Edge, EdgeSelection, Mesh, Plane, SilhouetteTree, oracle, topology,
};
use capwalk_math::Vec3;
use common::{Place, Spot};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A query in words.
#[derive(Clone, Copy, Debug)]
struct View {
    eye: Spot,
    towards: Result<Spot, Vec3>,
    max_angle: f64,
    edges: EdgeSelection,
    groups: u8,
    plane: Option<(Spot, Vec3)>,
}

fn view() -> impl Strategy<Value = View> {
    let towards = prop_oneof![
        common::spot().prop_map(Ok),
        common::direction().prop_map(Err)
    ];
    let max_angle = prop_oneof![
        3 => Just(std::f64::consts::PI),
        2 => 0.0..0.5_f64,
        1 => 0.0..3.2_f64,
        1 => (-12.0..-3.0_f64).prop_map(|digits| 10_f64.powf(digits)),
    ];
    let edges = prop_oneof![3 => Just(EdgeSelection::Silhouettes), 1 => Just(EdgeSelection::All)];
    let groups = prop_oneof![2 => Just(u8::MAX), 1 => any::<u8>()];
    let plane = prop::option::weighted(0.3, (common::spot(), common::point()));
    (common::spot(), towards, max_angle, edges, groups, plane).prop_map(
        |(eye, towards, max_angle, edges, groups, plane)| View {
            eye,
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
        let eye = self.eye.position(mesh, place);
        let axis = match self.towards {
            Ok(spot) => (spot.position(mesh, place) - eye).normalized(),
            Err(direction) => direction,
        };
        ConeQuery {
            eye,
            axis: if axis.is_finite() {
                axis
            } else {
                Vec3::new(0.0, 0.6, 0.8)
            },
            max_angle: self.max_angle,
            edges: self.edges,
            groups: self.groups,
            in_front_of: self.plane.map(|(spot, normal)| Plane {
                point: spot.position(mesh, place),
                normal,
            }),
        }
    }
}

fn check(
    tree: &SilhouetteTree,
    mesh: &Mesh,
    edges: &[Edge],
    queries: &[ConeQuery],
) -> Result<(), TestCaseError> {
    tree.validate(mesh, edges)
        .map_err(|error| TestCaseError::fail(error.to_string()))?;
    let scalar = tree.clone().without_simd();
    for query in queries {
        let expected = oracle::closest_silhouette(mesh, edges, query);
        prop_assert_eq!(tree.closest(query), expected, "{:?}", query);
        prop_assert_eq!(scalar.closest(query), expected, "scalar, {:?}", query);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() })]

    /// The tree finds what brute force finds, bit for bit; also after vertices
    /// moved.
    #[test]
    fn tree_is_brute_force(
        (mesh, place) in common::mesh(),
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
        let moved = common::moved(&mesh, &place, 1.0, seed);
        tree.refit(&moved);
        check(&tree, &moved, &edges, &queries_at(&moved))?;
    }
}
