//! Searches that leave out what is in shadows, against brute force, which asks for every edge.

use std::cell::Cell;

use super::meshes;
use crate::simd::Instructions;
use crate::{
    ConeQuery, Edge, EdgeSelection, HalfSpace, Mesh, Ray, RayTree, Shadow, Sight, SilhouettePoint,
    SilhouetteTree, oracle, topology,
};
use capwalk_math::Vec3;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// What is seen from a point by rays. Edges that are not in front of the plane count whatever hides them.
struct Eyes<'a> {
    mesh: &'a Mesh,
    edges: &'a [Edge],
    rays: &'a RayTree,
    viewpoint: Vec3,
    plane: Option<HalfSpace>,
    nearest: f64,
    asked: Cell<u32>,
}

impl<'a> Eyes<'a> {
    fn new(mesh: &'a Mesh, edges: &'a [Edge], rays: &'a RayTree, viewpoint: Vec3) -> Self {
        let points = mesh.positions.iter().chain([&viewpoint]);
        let largest = points.map(|p| p.map(f64::abs).max_component());
        Self {
            mesh,
            edges,
            rays,
            viewpoint,
            plane: None,
            nearest: 1e-10 * largest.fold(0.0, f64::max),
            asked: Cell::new(0),
        }
    }

    fn ray(&self, direction: Vec3, t_max: f64) -> Ray {
        Ray {
            t_min: self.nearest,
            t_max,
            ..Ray::new(self.viewpoint, direction)
        }
    }
}

impl Sight for Eyes<'_> {
    fn sees(&self, point: &SilhouettePoint) -> bool {
        self.asked.set(self.asked.get() + 1);
        let ends = self.edges[point.edge as usize].vertices;
        let is_in_front = |plane: &HalfSpace| {
            let mut ends = ends.iter().map(|&i| self.mesh.positions[i as usize]);
            ends.all(|end| (end - plane.point).dot(plane.normal) > 0.0)
        };
        let hides = self.plane.as_ref().is_none_or(is_in_front);
        let ray = self.ray(point.direction, point.distance * (1.0 - 1e-9));
        !(hides && self.rays.occluded(&ray))
    }

    fn shadow(&self, point: &SilhouettePoint) -> Option<Shadow> {
        let hit = self
            .rays
            .first_hit(&self.ray(point.direction, f64::INFINITY))?;
        let corners = self.mesh.corners(hit.face as usize);
        let shadow = Shadow::of_face(self.viewpoint, corners, self.nearest)?;
        Some(self.plane.map_or(shadow, |plane| shadow.in_front_of(plane)))
    }
}

/// Where a query looks from and to, and the normal of a plane through the viewpoint.
type View = (meshes::Spot, Vec3, Option<Vec3>);

fn view() -> impl Strategy<Value = View> {
    let normal = prop::option::weighted(0.3, meshes::direction());
    (meshes::spot(), meshes::direction(), normal)
}

fn query(apex: Vec3, axis: Vec3, max_angle: f64) -> ConeQuery {
    ConeQuery {
        apex,
        axis,
        max_angle,
        edges: EdgeSelection::All,
        groups: u8::MAX,
        in_front_of: None,
    }
}

/// Compares the search with brute force on all CPUs; how many points each asks for.
fn asked(tree: &SilhouetteTree, eyes: &Eyes, query: &ConeQuery) -> Result<[u32; 2], TestCaseError> {
    let count = |find: &dyn Fn() -> Option<SilhouettePoint>| {
        eyes.asked.set(0);
        let found = find();
        (found, eyes.asked.get())
    };
    let sees = |point: &SilhouettePoint| eyes.sees(point);
    let expected = oracle::closest_silhouette_where(eyes.mesh, eyes.edges, query, sees);
    let (plain, most) = count(&|| tree.closest_where(query, &sees));
    prop_assert_eq!(plain, expected, "{:?}", query);
    let (found, least) = count(&|| tree.closest_where(query, eyes));
    prop_assert_eq!(found, expected, "{:?}", query);
    for it in Instructions::slower() {
        let slower = tree.clone().with(it);
        let (found, asked) = count(&|| slower.closest_where(query, eyes));
        prop_assert_eq!(found, expected, "{:?}", query);
        prop_assert_eq!(asked, least, "{:?}", query);
    }
    Ok([most, least])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6000, rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..Default::default() })]

    /// Nothing that counts is left out, whatever the mesh.
    #[test]
    fn shadows_hide_what_rays_say_is_hidden(
        (mesh, place) in meshes::mesh(),
        views in prop::collection::vec(view(), 6),
    ) {
        let edges = topology::edges(&mesh);
        let tree = SilhouetteTree::build(&mesh, &edges);
        let rays = RayTree::build(&mesh);
        for (spot, axis, normal) in views {
            let viewpoint = spot.position(&mesh, &place);
            let mut eyes = Eyes::new(&mesh, &edges, &rays, viewpoint);
            eyes.plane = normal.map(|normal| HalfSpace { point: viewpoint, normal });
            asked(&tree, &eyes, &query(viewpoint, axis, 4.0))?;
        }
    }
}

/// A bumpy ball behind a wall of two faces, and another one beside the wall: few of the first one's edges are asked for. A
/// tree that followed a motion asks for as many as a new one does.
#[test]
fn few_are_asked_for_behind_a_wall() {
    let bumpy = |d: Vec3| 1.0 + 0.1 * (9.0 * d.x).sin() * (7.0 * d.y).sin();
    let mut mesh = meshes::sheet(1, |_, _| 0.0);
    for shift in [Vec3::new(0.2, 0.1, -3.0), Vec3::new(6.0, 0.0, -2.0)] {
        let mut ball = meshes::ball(14, bumpy);
        ball.positions
            .iter_mut()
            .for_each(|p| *p = *p * 0.8 + shift);
        mesh.append(&ball);
    }
    let edges = topology::edges(&mesh);
    let mut moved =
        SilhouetteTree::build(&meshes::with_positions(&mesh, meshes::MOTIONS[2].1), &edges);
    moved.refit(&mesh);
    let tree = SilhouetteTree::build(&mesh, &edges);
    let rays = RayTree::build(&mesh);
    let mut sum = [0; 2];
    for i in 0..60 {
        let turn = |k: f64| (f64::from(i) * k).fract() - 0.5;
        let viewpoint = Vec3::new(turn(0.618), turn(0.755), 1.5 + turn(0.57));
        let eyes = Eyes::new(&mesh, &edges, &rays, viewpoint);
        let axis = Vec3::new(turn(0.325), turn(0.89), -2.0).normalized();
        let query = query(viewpoint, axis, 4.0);
        let counts = asked(&tree, &eyes, &query).expect("brute force agrees");
        assert_eq!(
            asked(&moved, &eyes, &query).expect("it agrees")[1],
            counts[1]
        );
        sum = [sum[0] + counts[0], sum[1] + counts[1]];
    }
    assert!(sum[0] > 60 * 500 && 20 * sum[1] < sum[0], "{sum:?}");
}

/// Planes that the farthest corner of a hidden ball only just passes or only just does not: single precision must not
/// take it for hidden.
#[test]
fn corners_at_planes_are_not_lost() {
    let mut mesh = meshes::sheet(1, |_, _| 0.0);
    let wall = topology::edges(&mesh).len();
    let mut ball = meshes::ball(14, |d| 1.0 + 0.1 * (9.0 * d.x).sin());
    ball.positions
        .iter_mut()
        .for_each(|p| *p += Vec3::new(0.0, 0.0, -3.0));
    mesh.append(&ball);
    let mut edges = topology::edges(&mesh);
    edges[..wall].iter_mut().for_each(|edge| edge.groups = 0);
    let tree = SilhouetteTree::build(&mesh, &edges);
    let rays = RayTree::build(&mesh);
    let viewpoint = Vec3::new(0.1, 0.0, 0.5);
    let mut eyes = Eyes::new(&mesh, &edges, &rays, viewpoint);
    let mut found = 0;
    for i in 0..400 {
        let turn = |k: f64| (f64::from(i) * k).fract() - 0.5;
        let away = Vec3::new(turn(0.618), turn(0.755), turn(0.57)).normalized();
        let height = |p: &&Vec3| p.dot(away);
        let corner = (ball.positions.iter()).max_by(|a, b| height(a).total_cmp(&height(b)));
        let lift = [0.0, 1e-9, 1e-7, 1e-6, 1e-5, -1e-9, -1e-7][i as usize % 7];
        eyes.plane = Some(HalfSpace {
            point: *corner.expect("many") - away * lift,
            normal: -away,
        });
        let query = query(viewpoint, Vec3::new(0.0, 0.0, -1.0), 1.0);
        let sees = |point: &SilhouettePoint| eyes.sees(point);
        let expected = oracle::closest_silhouette_where(&mesh, &edges, &query, sees);
        assert_eq!(tree.closest_where(&query, &eyes), expected, "{i}");
        found += usize::from(expected.is_some());
    }
    assert!((200..350).contains(&found), "{found}");
}

/// A face hides all of an edge that its shadow hides: tried with ends on and beside its border, just before and behind
/// its plane.
#[test]
fn what_is_in_the_shadow_of_a_face_is_hidden() {
    let digits = |u: f64| 10_f64.powf(-1.0 - 9.0 * u);
    let (mut hidden, mut close) = (0, 0);
    for i in 0..100_000 {
        let number = |k: u32| (f64::from(i) * f64::from(2 * k + 3).sqrt() * 0.618_034).fract();
        let point = |k| Vec3::new(number(k), number(k + 1), number(k + 2)) - Vec3::splat(0.5);
        let offset = if i % 2 == 0 {
            Vec3::zero()
        } else {
            Vec3::splat(1e3)
        };
        let mesh = Mesh {
            positions: [1, 4, 7].map(|k| point(k) + offset).to_vec(),
            faces: vec![[0, 1, 2]],
        };
        let viewpoint = point(10) * if i % 3 == 0 { 1.0 } else { 9.0 } + offset;
        let nearest = 1e-10 * (offset.x + 5.0);
        let corners = mesh.corners(0);
        let Some(shadow) = Shadow::of_face(viewpoint, corners, nearest) else {
            continue;
        };
        // A point beside a side, from well inside to well outside, and as far as the plane or more.
        let end = |k: u32| {
            let side = (number(k) * 3.0) as usize;
            let [a, b, c] = [0, 1, 2].map(|j| corners[(side + j) % 3]);
            let inside = digits(number(k + 1)) * if number(k + 2) < 0.5 { 1.0 } else { -1.0 };
            let on_side = a + (b - a) * number(k + 3);
            let beyond =
                1.0 + 3.0 * digits(number(k + 4)) * if number(k + 5) < 0.8 { 1.0 } else { -1.0 };
            viewpoint + (on_side + (c - on_side) * inside - viewpoint) * beyond
        };
        // The other end is well behind the middle.
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let ends = [end(13), viewpoint + (middle - viewpoint) * 2.0];
        let free = |p: Vec3| {
            let distance = (p - viewpoint).length();
            let ray = Ray {
                t_min: nearest,
                t_max: distance * (1.0 - 1e-9),
                ..Ray::new(viewpoint, (p - viewpoint) / distance)
            };
            oracle::first_hit(&mesh, &ray).is_none()
        };
        let is_hidden = shadow.hides(ends);
        let mut places = [0.0, 1e-3, number(25)]
            .into_iter()
            .map(|t| ends[0] + (ends[1] - ends[0]) * t);
        assert!(!is_hidden || !places.any(free), "{i}");
        hidden += usize::from(is_hidden);
        // Nearer to the viewpoint, or farther out by a thousandth, it would not be.
        let aside = ends[0] + (ends[0] - ends[1]) * 1e-3;
        close += usize::from(is_hidden && free(aside));
    }
    assert!(hidden > 5000 && close > 1000, "{hidden}, {close}");
}

/// Where a face is seen edge-on, or is too near or too small to tell, nothing is said of what it hides.
#[test]
fn not_every_face_has_a_shadow() {
    let [a, b, c] = [(1.0, 0.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(x, y)| Vec3::new(x, y, 0.0));
    let of = |viewpoint, corners| Shadow::of_face(viewpoint, corners, 1e-10).is_some();
    let above = |height| Vec3::new(0.0, 0.0, height);
    assert!(of(above(1.0), [a, b, c]) && of(above(-1.0), [a, b, c]) && of(above(1.0), [a, c, b]));
    assert!(!of(above(1e-7), [a, b, c]) && !of(Vec3::new(3.0, 0.0, 0.0), [a, b, c]));
    assert!(!of(above(1.0), [a, b, b]) && !of(above(1e4), [a, b, c]));
}
