//! Subtrees of edges, sampled as seen from a viewpoint (METHOD 8): a tree of edges is descended
//! at random to a few of them; where only silhouettes count, past all that certainly has none.
//! The time grows with the logarithm of the edges.

mod division;
mod flat_arrays;

use std::ops::Range;

use capwalk_geometry::sampler_buffers::CLEAR;
use capwalk_geometry::{Edge, EdgeSelection, Halt, Halted, NormalCone, add_effort};
use capwalk_math::Vec3;

use crate::accel::Accel;
use crate::coincident::visit_overlaps;
use crate::edge_visibility::{EdgeVisibility, LearnedVisibility, VisibilitySum};
use crate::motion::Motion;
use crate::sampled_edge::{SampledEdge, outward};

use division::{Bin, divide};

/// The most edges in a leaf, which are listed one by one: more where few of them count.
fn leaf_size(selection: EdgeSelection) -> usize {
    match selection {
        EdgeSelection::Silhouettes => 32,
        EdgeSelection::All => 12,
    }
}

/// The effort of a step down: two importances.
const EFFORT_OF_STEP: u64 = 5;

/// The edges of a scene, for sampling those that count.
#[derive(Debug)]
pub struct EdgeSampler {
    /// Which of them count.
    selection: EdgeSelection,
    /// In the order of the tree's leaves.
    edges: Vec<SampledEdge>,
    /// The root is the first; those below a node come behind it.
    nodes: Vec<Node>,
    /// Pairs of edges that may lie on each other, in both orders, sorted.
    overlaps: Vec<[u32; 2]>,
}

/// A node of the tree.
#[derive(Debug)]
struct Node {
    /// The places of its edges in the order.
    places: Range<usize>,
    /// The nodes of both halves; none in a leaf.
    halves: Option<[usize; 2]>,
    bounds: EdgeBounds,
}

/// What is known of edges while a tree is built, by their numbers.
struct Known<'a> {
    /// See [`SampledEdge::normals`].
    normals: &'a [[Option<Vec3>; 2]],
    /// From where they are visible; not asked of creases.
    visibility: Option<&'a [EdgeVisibility]>,
}

/// Bounds of some edges.
#[derive(Clone, Copy, Debug)]
pub struct EdgeBounds {
    /// Centre of a ball around them.
    pub centre: Vec3,
    /// Its radius.
    pub radius: f64,
    /// The normals of the faces at them; all directions if creases count.
    pub normals: NormalCone,
    /// The sum of their lengths, each times its share of viewpoints.
    pub length: f64,
    /// The radius of the subtrees that are chosen below, roughly.
    pub least_radius: f64,
    /// The planes of their faces pass the centre within this distance.
    height: f64,
    visibility: LearnedVisibility,
}

/// A subtree that was chosen at random.
#[derive(Clone, Copy, Debug)]
pub struct Subtree {
    node: usize,
    /// Its probability.
    pub probability: f64,
}

/// An edge of a subtree that counts.
#[derive(Clone, Copy, Debug)]
pub struct Counted {
    /// The number of the edge.
    pub edge: u32,
    /// Its ends.
    pub ends: [Vec3; 2],
    /// How likely it is not hidden by its own surface, or how large the discontinuity is at a
    /// crease, roughly; above 0 and at most 1.
    pub factor: f64,
}

impl EdgeSampler {
    /// A sampler of the edges of a scene: of the silhouettes among the first `of_meshes`, or,
    /// given how large the discontinuity is at each where it is no silhouette, of all. It depends
    /// on where surfaces are alone, not on how the scene came about.
    pub(crate) fn try_new(
        edges: &[Edge],
        of_meshes: usize,
        positions: &[Vec3],
        creases: Option<&[f32]>,
        accel: &Accel,
        halt: &Halt,
    ) -> Result<Self, Halted> {
        let outward = outward(&edges[..of_meshes], accel);
        let (selection, edges) = match creases {
            None => (EdgeSelection::Silhouettes, &edges[..of_meshes]),
            Some(_) => (EdgeSelection::All, edges),
        };
        let sampled = edges.iter().zip(0..).map(|(edge, number)| {
            let ends = edge.vertices.map(|i| positions[i as usize]);
            // Those beyond are of two shapes.
            let of_mesh = (number as usize) < of_meshes;
            let shape = of_mesh.then(|| accel.shape_of_vertex(edge.vertices[0]));
            let outward = shape.and_then(|shape| outward[shape.0 as usize]);
            let crease = creases.map_or(0.0, |creases| f64::from(creases[number as usize]));
            SampledEdge::new(number, edge, ends, &accel.mesh, outward, crease)
        });
        let sampled: Vec<SampledEdge> = sampled.collect();
        let normals: Vec<_> = sampled.iter().map(SampledEdge::normals).collect();
        // Creases are seen from wherever one of their faces is.
        let visibility = match selection {
            EdgeSelection::Silhouettes => {
                let visibility = EdgeVisibility::all(&sampled, accel, halt);
                Some(halt.unless_halted(visibility)?)
            }
            EdgeSelection::All => None,
        };
        let count = sampled.len();
        let known = Known {
            normals: &normals,
            visibility: visibility.as_deref(),
        };
        let mut sampler = Self {
            selection,
            edges: sampled,
            nodes: Vec::new(),
            overlaps: Vec::new(),
        };
        if count > 0 {
            sampler.add_node(0..count, 0, &known, halt);
        }
        visit_overlaps(edges, positions, halt, |[a, b]| {
            let [a, b] = [a as u32, b as u32];
            sampler.overlaps.extend([[a, b], [b, a]]);
        });
        sampler.overlaps.sort_unstable();
        sampler.overlaps.dedup();
        halt.now();
        halt.unless_halted(sampler)
    }

    /// Adds the node of these places and all below it, and returns its number and what is seen
    /// of its edges. Not all below it if the work is given up.
    fn add_node(
        &mut self,
        places: Range<usize>,
        depth: u32,
        known: &Known,
        halt: &Halt,
    ) -> (usize, VisibilitySum) {
        let (number, leaf) = (self.nodes.len(), leaf_size(self.selection));
        self.nodes.push(Node {
            places: places.clone(),
            halves: None,
            bounds: EdgeBounds::new(&self.edges[places.clone()], leaf, known),
        });
        let mut seen = VisibilitySum::default();
        if places.len() > leaf && !halt.now() {
            let middle = places.start + divide(&mut self.edges[places.clone()], depth);
            let halves = [places.start..middle, middle..places.end];
            let halves = halves.map(|places| {
                let (half, seen_of_half) = self.add_node(places, depth + 1, known, halt);
                seen.add(&seen_of_half);
                half
            });
            self.nodes[number].halves = Some(halves);
        } else if let Some(visibility) = known.visibility {
            for edge in &self.edges[places] {
                seen.add_edge(edge.weight, &visibility[edge.edge as usize]);
            }
        }
        if known.visibility.is_some() {
            self.nodes[number].bounds.visibility = LearnedVisibility::of(&seen);
        }
        (number, seen)
    }

    /// The motion of each node's edges, from that of points of the boundaries.
    pub fn motions(&self, of_point: impl Fn(u32) -> Motion) -> Vec<Motion> {
        let mut motions = vec![Motion::STILL; self.nodes.len()];
        // From the leaves up: those below a node come behind it.
        for (i, node) in self.nodes.iter().enumerate().rev() {
            motions[i] = match node.halves {
                Some(halves) => Motion::mean(halves.into_iter().map(|half| {
                    let weight = self.nodes[half].bounds.length;
                    (weight, motions[half])
                })),
                None => Motion::mean(self.edges[node.places.clone()].iter().flat_map(|edge| {
                    let weight = edge.weight;
                    edge.points.map(|point| (weight, of_point(point)))
                })),
            };
        }
        motions
    }

    /// A subtree of few edges, chosen by the random number `u` in `[0, 1)`. On the way down
    /// nodes are chosen in proportion to their importance, given their number and bounds,
    /// unless they certainly have no edge that counts. `None` if that leads to nothing. A tree of
    /// one leaf is always chosen. Where an importance is not a number, the probability is none.
    pub fn descend(
        &self,
        viewpoint: Vec3,
        mut u: f64,
        importance: impl Fn(usize, &EdgeBounds) -> f64,
    ) -> Option<Subtree> {
        let importance = |i: usize| {
            let bounds = &self.nodes[i].bounds;
            match self.selection == EdgeSelection::All || bounds.may_have_silhouette(viewpoint) {
                true => importance(i, bounds),
                false => 0.0,
            }
        };
        if self.nodes.is_empty() {
            return None;
        }
        let mut chosen = Subtree {
            node: 0,
            probability: 1.0,
        };
        // Listing the edges of the leaf, and each step on the way there.
        let mut effort = leaf_size(self.selection) as u64;
        while let Some(halves) = self.nodes[chosen.node].halves {
            effort += EFFORT_OF_STEP;
            let importances = halves.map(importance);
            let sum = importances[0] + importances[1];
            if sum == 0.0 {
                return None;
            }
            let shares = importances.map(|importance| importance / sum);
            // Rounding leads to no half of no importance.
            let half = usize::from(u >= shares[0] && shares[1] > 0.0);
            // The random number, rescaled within the half, is uniform again.
            u = match half {
                0 => (u / shares[0]).min(1.0),
                _ => (u - shares[0]) / shares[1],
            };
            chosen.probability *= shares[half];
            chosen.node = halves[half];
        }
        add_effort(effort);
        Some(chosen)
    }

    /// The edges of a subtree that count as seen from a viewpoint.
    pub fn counted(&self, subtree: &Subtree, viewpoint: Vec3) -> impl Iterator<Item = Counted> {
        let edges = &self.edges[self.nodes[subtree.node].places.clone()];
        edges.iter().filter_map(move |edge| {
            let factor = match edge.is_silhouette(viewpoint) {
                true => edge.exposure,
                false => edge.crease,
            };
            (factor > 0.0).then_some(Counted {
                edge: edge.edge,
                ends: edge.ends,
                factor,
            })
        })
    }

    /// The edges that may lie on a part of this one.
    pub fn overlapping(&self, edge: u32) -> impl Iterator<Item = u32> {
        let first = self.overlaps.partition_point(|&[a, _]| a < edge);
        let pairs = self.overlaps[first..].iter();
        pairs.take_while(move |&&[a, _]| a == edge).map(|&[_, b]| b)
    }

    /// Which of its edges count.
    pub fn selection(&self) -> EdgeSelection {
        self.selection
    }
}

impl EdgeBounds {
    /// Bounds of edges in a tree with leaves of so many; of what is seen of them, nothing is known.
    fn new(edges: &[SampledEdge], leaf: usize, known: &Known) -> Self {
        let has_creases = edges.iter().any(|edge| edge.crease > 0.0);
        let mut all = Bin::EMPTY;
        edges.iter().for_each(|edge| all.add(&Bin::of(edge)));
        let centre = (all.low + all.high) * 0.5;
        let offsets = edges.iter().flat_map(|edge| edge.ends);
        let squares = offsets.map(|p| (p - centre).length_squared());
        let radius = squares.fold(0.0, f64::max).sqrt();
        let normals_of = |edge: &SampledEdge| known.normals[edge.edge as usize];
        let height = |edge: &SampledEdge| {
            let normals = normals_of(edge).into_iter().flatten();
            let heights = normals.map(|normal| normal.dot(edge.ends[0] - centre).abs());
            heights.fold(0.0, f64::max)
        };
        Self {
            centre,
            radius,
            // On a surface, so many edges in a disk are in one smaller by the square root.
            least_radius: radius * (leaf as f64 / edges.len().max(leaf) as f64).sqrt(),
            normals: match has_creases {
                // The plane through a viewpoint and a crease need not be between its faces.
                true => NormalCone::ALL,
                false => NormalCone::around(|| edges.iter().flat_map(normals_of)),
            },
            length: all.weight,
            visibility: LearnedVisibility::ALL,
            height: edges.iter().map(height).fold(0.0, f64::max),
        }
    }

    /// What of [`length`](Self::length) is visible from the viewpoint, roughly; above 0.
    pub fn visible_length(&self, viewpoint: Vec3) -> f64 {
        self.length * self.visibility.from(viewpoint - self.centre)
    }

    /// Distance by which a viewpoint must clear a plane: more than what rounding adds up to, world
    /// units.
    fn clear(&self, viewpoint: Vec3) -> f64 {
        let sum = |p: Vec3| p.x.abs() + p.y.abs() + p.z.abs();
        CLEAR * (sum(viewpoint) + sum(self.centre) + 2.0 * self.radius)
    }

    /// False if certainly none of the edges is a silhouette as seen from the viewpoint.
    fn may_have_silhouette(&self, viewpoint: Vec3) -> bool {
        let offset = self.centre - viewpoint;
        let clear = self.clear(viewpoint);
        let margin = self
            .normals
            .view_margin(self.radius + clear, self.height + clear);
        let least = self.normals.sin * offset.length() + margin + clear;
        // True for NaN.
        let is_clear = self.normals.axis.dot(offset).abs() > least;
        !is_clear
    }
}

#[cfg(test)]
mod tests {
    use capwalk_math::Affine;
    use capwalk_scene::primitive::{cube, icosphere, rectangle};
    use capwalk_scene::{BsdfId, Scene, ShadingNormals, Shape, builtin};

    use super::*;
    use crate::boundaries::Boundaries;

    /// Waves on a ball, a box, and sheets: one of them open, one large and far away.
    fn accel() -> Accel {
        let mut scene: Scene = builtin::scene("leaf").expect("built in");
        scene.shapes.clear();
        scene.emitters.clear();
        let mut ball = icosphere(9);
        for p in &mut ball.positions {
            *p = *p * (1.0 + 0.1 * (7.0 * p.x).sin() * (6.0 * p.y).cos() * (5.0 * p.z).sin());
        }
        let place = |x: f64, size: f64| {
            Affine::translate(Vec3::new(x, 0.3, -0.2))
                * Affine::rotate(Vec3::new(0.3, 0.8, 0.5), 0.7)
                * Affine::scale(Vec3::splat(size))
        };
        let meshes = [
            ball,
            cube(place(1.5, 0.4)).0,
            rectangle(place(-1.6, 0.5)).0,
            rectangle(Affine::scale(Vec3::splat(90.0))).0,
        ];
        for mesh in meshes {
            scene.add_shape(Shape::new("", mesh, ShadingNormals::Face, BsdfId(0)));
        }
        Accel::new(scene)
    }

    /// Far, near, on a face of the ball, inside of it, in the plane of a sheet.
    fn viewpoints(accel: &Accel) -> Vec<Vec3> {
        let mut found = vec![
            Vec3::new(30.0, -20.0, 40.0),
            Vec3::new(1.1, -0.4, 0.6),
            Vec3::new(0.1, 0.2, -0.3),
            Vec3::new(0.7, 1.4, 0.0),
        ];
        for face in [100, 777, 1300] {
            let [a, b, c] = accel.mesh.corners(face);
            found.push(a * 0.3 + b * 0.5 + c * 0.2);
        }
        found
    }

    /// What is listed has the edges of brute force that count and no others, each list as often
    /// as its probability says, so that over it they are counted.
    #[test]
    fn subtrees_are_brute_force() {
        let accel = accel();
        let boundaries = Boundaries::new(&accel);
        // Surfaces that cross are on both sides of where they do.
        let crossings = boundaries.crossings.len();
        assert!(crossings > 0);
        let all = boundaries.edges();
        let of_meshes = &all[..all.len() - crossings];
        let is_silhouette = |edge: &Edge, viewpoint| edge.is_silhouette(&accel.mesh, viewpoint);
        samples_all(EdgeSelection::Silhouettes, of_meshes, is_silhouette);
        samples_all(EdgeSelection::All, all, |_, _| true);
    }

    /// Compares a sampler of these edges, of which those for which `counts` holds count.
    fn samples_all(selection: EdgeSelection, edges: &[Edge], counts: impl Fn(&Edge, Vec3) -> bool) {
        let accel = accel();
        let boundaries = Boundaries::new(&accel);
        let sampler = boundaries.edge_sampler(&accel, selection);
        assert_eq!(sampler.edges.len(), edges.len());
        for viewpoint in viewpoints(&accel) {
            let importance = |_: usize, bounds: &EdgeBounds| {
                let distance = (bounds.centre - viewpoint).length().max(bounds.radius);
                bounds.length / (distance * distance)
            };
            let edges = edges.iter().zip(0..);
            let mut expected: Vec<u32> = edges
                .filter(|(edge, _)| counts(edge, viewpoint))
                .map(|(_, number)| number)
                .collect();
            // Each subtree that is found, how often, and its probability.
            let mut found = std::collections::BTreeMap::new();
            let n = 400_000;
            let (mut count, mut hits) = (0.0, 0);
            for i in 0..n {
                let u = (f64::from(i) + 0.5) / f64::from(n);
                let Some(subtree) = sampler.descend(viewpoint, u, importance) else {
                    continue;
                };
                hits += 1;
                let entry = found.entry(subtree.node).or_insert((0, subtree));
                entry.0 += 1;
            }
            let mut listed: Vec<u32> = Vec::new();
            for (times, subtree) in found.values() {
                let share = f64::from(*times) / f64::from(n);
                assert!((share - subtree.probability).abs() < 2.0 / f64::from(n));
                let before = listed.len();
                let counted = sampler.counted(subtree, viewpoint);
                listed.extend(counted.map(|counted| counted.edge));
                count += share * (listed.len() - before) as f64 / subtree.probability;
            }
            listed.sort_unstable();
            expected.sort_unstable();
            // Some subtrees are too improbable to be met.
            let n = expected.len();
            println!("{n} edges, {} subtrees, {hits} hits", found.len());
            assert!(
                listed
                    .iter()
                    .all(|edge| expected.binary_search(edge).is_ok())
            );
            assert_eq!(listed, expected);
            assert!((count / expected.len() as f64 - 1.0).abs() < 1e-2);
        }
    }
}
