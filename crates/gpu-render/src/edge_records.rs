//! The edges of a scene that moves, as the kernels read them: `layout.rs` says which word is what.

use std::f64::consts::PI;

use capwalk_boundary::{
    AreaEmitter, BESIDE, Boundaries, EdgeSampler, Extent, MANY_CORNERS, Motion,
};
use capwalk_geometry::buffers::SilhouetteBuffers;
use capwalk_geometry::edge::ON_PLANE;
use capwalk_geometry::sampler_buffers::{BOUNDS, EDGE, FACTORS, NONE, SamplerBuffers};
use capwalk_geometry::{EdgeSelection, LocalFrame};
use capwalk_math::{Real, Vec3};
use capwalk_render::constants::IN_PLANE;
use capwalk_render::{Plan, SceneEval, Tracer};

use crate::kept_edges::{KeptEdges, LEAF};
use crate::layout::edge::{EDGE_NUMBERS, EDGE_RECORD};
use crate::layout::edge_node::EDGE_NODE;
use crate::layout::edges::*;
use crate::layout::record;
use crate::layout::tree::*;
use crate::texture_records::float;

/// The part of its radius by which a ball around an emitter is larger: more than rounding.
const WIDER: f64 = 1e-6;

/// The tangent of half an angle, which is given, as kernels compare angles: of half a turn and more it is
/// as large as none.
fn tangent_of(half: f64) -> f64 {
    match half < 0.5 * PI {
        true => half.tan(),
        false => 1e9,
    }
}

/// The edges of a scene along a direction that it moves in.
pub struct EdgeRecords {
    /// Numbers of exact tests.
    pub numbers: Vec<f64>,
    /// Everything else.
    pub words: Vec<u32>,
    /// Where paths can cross edges.
    pub crosses: Crosses,
    /// How many leaves the edges before area emitters have.
    pub leaves_before_areas: usize,
}

/// What the kernels read of how edges move.
pub struct EdgeMotion<'a> {
    /// True if sampling uses no velocities.
    pub is_blind: bool,
    pub of_points: OfPoints<'a>,
}

/// What is known of the motion of the edges' ends, points of the boundaries.
pub enum OfPoints<'a> {
    /// Velocities, in forward mode.
    Velocities(&'a dyn Fn(u32) -> Vec3),
    /// Where the sums of derivatives start, if they are asked for, in reverse mode.
    Sums(&'a dyn Fn(u32) -> Option<u32>),
}

/// Between which vertices of paths and what there can be edges.
#[derive(Clone, Copy, Debug)]
pub struct Crosses {
    /// Area emitters, and the environment.
    areas: bool,
    surroundings: bool,
    /// True if directions to surfaces that reflect light walk; else they stay, and there are edges.
    walks: bool,
    /// How long paths are.
    plan: Plan,
}

impl Crosses {
    /// True if light from area emitters gets to a vertex of this number past edges.
    pub fn before_areas(&self, depth: usize) -> bool {
        self.areas && self.plan.reaches(depth as u32 + 2)
    }

    /// True if light from the environment does.
    pub fn before_environment(&self, depth: usize) -> bool {
        self.surroundings && self.plan.reaches(depth as u32 + 2)
    }

    /// True if light that surfaces reflect does.
    pub fn before_surfaces(&self, depth: usize) -> bool {
        !self.walks && self.plan.reaches(depth as u32 + 3)
    }

    /// True if directions from there to surfaces walk.
    pub fn walks(&self, depth: usize) -> bool {
        self.walks && self.plan.reaches(depth as u32 + 3)
    }
}

impl EdgeRecords {
    /// The records of the edges that a tracer's scene has, in the coordinates of the frame, with what is known
    /// of its motion and what the kernels read of that. So many leaves and points before an emitter are
    /// for one launch.
    pub fn new<R: Real, W: SceneEval<R>>(
        tracer: &Tracer,
        boundaries: &Boundaries,
        eval: &W,
        motion: &EdgeMotion,
        frame: &LocalFrame,
        [leaves, points]: [u32; 2],
    ) -> Self {
        let (accel, plan) = (tracer.accel, tracer.plan);
        let walks = tracer.surface_walks();
        let (areas, surroundings) = (
            !boundaries.area_emitters.is_empty(),
            accel.scene.environment().is_some(),
        );
        let crosses = Crosses {
            areas,
            surroundings,
            walks: walks.is_some(),
            plan,
        };
        // What emits may end where textures do, or where another surface passes through it.
        let emits_partly = areas && boundaries.crossings.iter().any(|crossing| crossing.emits);
        let away = frame.centre.map(f64::abs);
        let away = 2.0 * (away.x + away.y + away.z) * frame.inverse_scale;
        let cap = walks.map_or(0.0, |walks| walks.settings.max_radius);
        let [half, whole] = [0.5, 1.0].map(|part| tangent_of(part * cap));
        let searched = walks.map(|_| boundaries.tree().buffers());
        let its_frame = searched.as_ref().map_or(*frame, |tree| tree.frame);
        let [x, y, z] = frame.local_from_world(its_frame.centre).to_array();
        let scale = its_frame.inverse_scale * frame.scale;
        let tests = [ON_PLANE, away, IN_PLANE, BESIDE, half, whole];
        let mut records = Self {
            numbers: [&tests[..], &[x, y, z, scale]].concat(),
            words: vec![0; EDGES_HEADER],
            crosses,
            leaves_before_areas: 0,
        };
        let mut tree = |selection, is_needed| match is_needed {
            true => {
                let sampler = boundaries.edge_sampler(accel, selection);
                records.add_trees(sampler, boundaries, eval, motion, frame)
            }
            false => ([NONE; 2], 0),
        };
        let needs_silhouettes = surroundings || areas && !emits_partly;
        let ([silhouettes, moving_silhouettes], few) = tree(
            EdgeSelection::Silhouettes,
            (crosses.before_areas(0) || crosses.before_environment(0)) && needs_silhouettes,
        );
        let ([all, moving], many) = tree(
            EdgeSelection::All,
            plan.reaches(3) || crosses.before_areas(0) && emits_partly,
        );
        let before_emitters = u32::from(emits_partly);
        if crosses.before_areas(0) {
            records.leaves_before_areas = if emits_partly { many } else { few };
        }
        let windows =
            records.add_windows(&boundaries.area_emitters, frame, accel.scene.emitters.len());
        let [nodes, leaf_starts, places] = searched.map_or([NONE; 3], |tree| {
            let sampler = boundaries.edge_sampler(accel, EdgeSelection::All);
            records.add_searched(&tree, &sampler.buffers().edges)
        });
        let header: [u32; EDGES_HEADER] = record(&[
            (SILHOUETTES, silhouettes),
            (ALL_EDGES, all),
            (OF_MOVING + SILHOUETTES, moving_silhouettes),
            (OF_MOVING + ALL_EDGES, moving),
            (BEFORE_EMITTERS, before_emitters),
            (WINDOWS, windows),
            (FIRST_WALK, walks.map_or(0, |walks| walks.first_number)),
            (
                WALK_NUMBERS,
                walks.map_or(0, |walks| walks.numbers_per_vertex),
            ),
            (MIRRORS, walks.map_or(0, |walks| walks.events)),
            (MOST_LEAVES, leaves),
            (MOST_POINTS, points),
            (SEARCHED_NODES, nodes),
            (SEARCHED_LEAVES, leaf_starts),
            (SEARCHED_EDGES, places),
        ]);
        records.words[..EDGES_HEADER].copy_from_slice(&header);
        records
    }

    /// Adds the tree of a sampler's edges, of all of them and of those alone that move; returns where
    /// both start, [`NONE`] for one without edges, and how many leaves the first one has.
    fn add_trees<R: Real, W: SceneEval<R>>(
        &mut self,
        sampler: &EdgeSampler,
        boundaries: &Boundaries,
        eval: &W,
        motion: &EdgeMotion,
        frame: &LocalFrame,
    ) -> ([u32; 2], usize) {
        let buffers = sampler.buffers();
        let moves = |edge: &u32| {
            let mut points = boundaries.edge(*edge).vertices.into_iter();
            points.any(|point| !eval.motion_of_point(point).is_still())
        };
        let moving: Vec<bool> = buffers.edges.iter().map(moves).collect();
        let motions = sampler.motions(|point| eval.motion_of_point(point));
        let all = vec![true; moving.len()];
        let mut add = |kept: &[bool]| {
            let Some(tree) = KeptEdges::new(&buffers, kept) else {
                return (NONE, 0);
            };
            let at = self.add_tree(
                &tree, &buffers, sampler, &motions, boundaries, eval, motion, frame,
            );
            (at, tree.leaves())
        };
        let (whole, leaves) = add(&all);
        let part = if moving == all { whole } else { add(&moving).0 };
        ([whole, part], leaves)
    }

    /// Adds a tree, and returns where it starts.
    #[allow(
        clippy::too_many_arguments,
        reason = "what is known of edges comes from many places"
    )]
    fn add_tree<R: Real, W: SceneEval<R>>(
        &mut self,
        tree: &KeptEdges,
        buffers: &SamplerBuffers,
        sampler: &EdgeSampler,
        motions: &[Motion],
        boundaries: &Boundaries,
        eval: &W,
        motion: &EdgeMotion,
        frame: &LocalFrame,
    ) -> u32 {
        // The lists of edges that lie on others, by their places in the tree.
        let mut places = vec![NONE; boundaries.edges().len()];
        for (place, &kept) in (0..).zip(&tree.edges) {
            places[buffers.edges[kept] as usize] = place;
        }
        let overlaps = tree.edges.iter().map(|&kept| {
            let first = self.words.len() as u32;
            let others = sampler.overlapping(buffers.edges[kept]);
            let others = others.map(|other| places[other as usize]);
            self.words.extend(others.filter(|&place| place != NONE));
            [first, self.words.len() as u32]
        });
        let overlaps: Vec<_> = overlaps.collect();

        let edges_at = self.words.len() as u32;
        let factors = buffers.factors.as_chunks::<FACTORS>().0;
        for (&kept, overlaps) in tree.edges.iter().zip(overlaps) {
            self.words.extend(factors[kept].map(float));
            let points = boundaries.edge(buffers.edges[kept]).vertices;
            self.words.extend(match motion.of_points {
                OfPoints::Velocities(velocity) => {
                    let velocities = points.map(|point| velocity(point) * frame.inverse_scale);
                    velocities
                        .map(Vec3::to_array)
                        .as_flattened()
                        .iter()
                        .copied()
                        .map(float)
                        .collect()
                }
                OfPoints::Sums(sum) => {
                    let [a, b] = points.map(|point| sum(point).unwrap_or(NONE));
                    vec![a, b, 0, 0, 0, 0]
                }
            });
            self.words.extend(overlaps);
            // Only a guess of the speed does not depend on where and across what.
            let guess = eval.speed(points, 0.5, Vec3::zero(), Vec3::zero());
            self.words.push(float(guess));
            self.words.push(buffers.edges[kept]);
        }
        debug_assert_eq!(
            self.words.len(),
            edges_at as usize + EDGE_RECORD * tree.edges.len()
        );
        let numbers_at = self.numbers.len() as u32;
        let numbers = buffers.ends_and_normals.as_chunks::<EDGE>().0;
        for &kept in &tree.edges {
            let edge = numbers[kept];
            let vector = |i| Vec3::new(edge[i], edge[i + 1], edge[i + 2]);
            let [a, b, first, second] = [0, 3, 6, 9].map(vector);
            let ends = [a, b].map(|end| frame.local_from_world(end));
            // Of unit length, unless the face has no area.
            let normals = [first, second].map(|cross| match cross.normalized() {
                normal if normal.is_finite() => normal,
                _ => Vec3::zero(),
            });
            let vectors = ends.into_iter().chain(normals);
            self.numbers.extend(vectors.flat_map(Vec3::to_array));
            self.numbers.extend(normals.map(Vec3::length));
        }
        let numbers_end = numbers_at as usize + EDGE_NUMBERS * tree.edges.len();
        debug_assert_eq!(self.numbers.len(), numbers_end);

        let nodes_at = self.words.len() as u32;
        let bounds = buffers.bounds.as_chunks::<BOUNDS>().0;
        for node in &tree.nodes {
            let bounds = bounds[node.source];
            let Motion { velocity, spread } = motions[node.source];
            let local = |length: f64| float(length * frame.inverse_scale);
            let second = node.second.map_or(NONE, |second| second as u32);
            let (radius, count) = (bounds[3], node.edges.len().max(LEAF));
            self.words.extend([second, node.end as u32]);
            self.words
                .extend([node.edges.start, node.edges.end].map(|i| i as u32));
            let centre = frame.local_from_world(Vec3::new(bounds[0], bounds[1], bounds[2]));
            self.words.extend(centre.to_array().map(float));
            self.words.push(local(radius));
            self.words.extend(bounds[4..9].iter().copied().map(float));
            self.words.extend(bounds[9..12].iter().copied().map(local));
            // On a surface, so many edges in a disk are in one smaller by the root.
            self.words
                .push(local(radius * (LEAF as f64 / count as f64).sqrt()));
            self.words.extend(velocity.to_array().map(local));
            // Guesses have no units.
            self.words.push(match motion.is_blind {
                true => float(spread),
                false => local(spread),
            });
            self.words.extend(bounds[12..].iter().copied().map(float));
        }
        debug_assert_eq!(
            self.words.len(),
            nodes_at as usize + EDGE_NODE * tree.nodes.len()
        );
        let at = self.words.len() as u32;
        self.words.extend(record::<3>(&[
            (TREE_NODES, nodes_at),
            (TREE_EDGES, edges_at),
            (TREE_NUMBERS, numbers_at),
        ]));
        at
    }

    /// Adds the tree that walks search, given all edges in the order of their records, and returns where its nodes,
    /// the starts of its leaves and the places of its edges in that order are.
    fn add_searched(&mut self, tree: &SilhouetteBuffers, edges: &[u32]) -> [u32; 3] {
        let mut places = vec![NONE; edges.len()];
        for (place, &edge) in (0..).zip(edges) {
            places[edge as usize] = place;
        }
        let searched = tree.edges.as_chunks::<2>().0.iter();
        let searched: Vec<u32> = searched.map(|&[edge, _]| places[edge as usize]).collect();
        [&tree.nodes, &tree.leaf_starts, &searched].map(|words| {
            let at = self.words.len() as u32;
            self.words.extend(words);
            at
        })
    }

    /// Adds the windows of area emitters, and returns where the list of all emitters' is.
    fn add_windows(&mut self, emitters: &[AreaEmitter], frame: &LocalFrame, count: usize) -> u32 {
        let at = self.words.len();
        self.words.resize(at + count, NONE);
        for emitter in emitters {
            self.words[at + emitter.emitter.0 as usize] = self.numbers.len() as u32;
            match emitter.extent() {
                Extent::Flat { hull, normal } => {
                    assert!(hull.len() <= MANY_CORNERS, "windows have few corners");
                    self.numbers.push(hull.len() as f64);
                    self.numbers.extend(normal.to_array());
                    let corners = hull.iter().map(|&corner| frame.local_from_world(corner));
                    self.numbers.extend(corners.flat_map(Vec3::to_array));
                }
                Extent::Ball { centre, radius } => {
                    self.numbers.push(0.0);
                    self.numbers
                        .extend(frame.local_from_world(*centre).to_array());
                    self.numbers
                        .push(radius * (1.0 + WIDER) * frame.inverse_scale);
                }
            }
        }
        at as u32
    }
}
