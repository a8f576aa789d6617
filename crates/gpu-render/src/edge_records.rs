//! The edges of a scene that moves, as the kernels read them: `edges.slang` says which word is what.

use capwalk_boundary::{AreaEmitter, Boundaries, EdgeSampler, Extent, Field, MANY_CORNERS, Method};
use capwalk_diff::Forward;
use capwalk_geometry::edge::ON_PLANE;
use capwalk_geometry::sampler_buffers::{BOUNDS, EDGE, FACTORS, NODE, NONE};
use capwalk_geometry::{EdgeSelection, LocalFrame};
use capwalk_math::Vec3;
use capwalk_render::{Plan, PreparedScene, SceneEval};
use capwalk_scene::Tangent;

use crate::texture_records::float;

/// Words of the header.
const HEADER: usize = 4;

/// How far outside of a window an edge counts as inside, over its distance, and the angle between an
/// edge and the rays beside it, as on the processor.
const IN_PLANE: f64 = 1e-9;
const BESIDE: f64 = 1e-10;

/// The part of its radius by which a ball around an emitter is larger: more than rounding.
const WIDER: f64 = 1e-6;

/// The edges of a scene along a direction that it moves in.
pub struct EdgeRecords {
    /// Numbers of exact tests.
    pub numbers: Vec<f64>,
    /// Everything else.
    pub words: Vec<u32>,
    /// Where paths can cross edges.
    pub crosses: Crosses,
}

/// Between which vertices of paths and what there can be edges.
#[derive(Clone, Copy, Debug)]
pub struct Crosses {
    /// Emitters, the environment among them.
    pub emitters: bool,
    /// Surfaces that reflect light.
    pub surfaces: bool,
}

impl EdgeRecords {
    /// Those of the edges that a scene has, in the coordinates of the frame.
    pub fn new(prepared: &PreparedScene, tangent: &Tangent, frame: &LocalFrame) -> Self {
        let (accel, boundaries) = (prepared.accel(), prepared.boundaries());
        let eval = Forward::new(Field::new(accel, boundaries, Method::EDGES), tangent);
        let plan = Plan::new(prepared.scene());
        let (areas, surroundings) = (
            !boundaries.area_emitters.is_empty(),
            accel.scene.environment().is_some(),
        );
        let crosses = Crosses {
            emitters: plan.reaches(2) && (areas || surroundings),
            surfaces: plan.reaches(3),
        };
        // What emits may end where textures do, or where another surface passes through it.
        let emits_partly = areas && boundaries.crossings.iter().any(|crossing| crossing.emits);
        let away = frame.centre.map(f64::abs);
        let away = 2.0 * (away.x + away.y + away.z) * frame.inverse_scale;
        let mut records = Self {
            numbers: vec![ON_PLANE, away, IN_PLANE, BESIDE],
            words: vec![0; HEADER],
            crosses,
        };
        let mut tree = |selection, is_needed| match is_needed {
            true => {
                let sampler = boundaries.edge_sampler(accel, selection);
                records.add_tree(sampler, boundaries, &eval, frame)
            }
            false => NONE,
        };
        let needs_silhouettes = surroundings || areas && !emits_partly;
        let silhouettes = tree(
            EdgeSelection::Silhouettes,
            crosses.emitters && needs_silhouettes,
        );
        let all = tree(
            EdgeSelection::All,
            crosses.surfaces || crosses.emitters && emits_partly,
        );
        let before_emitters = u32::from(emits_partly);
        let windows = records.add_windows(&boundaries.area_emitters, frame, accel.scene.emitters.len());
        records.words[..HEADER].copy_from_slice(&[silhouettes, all, before_emitters, windows]);
        records
    }

    /// Adds a tree, and returns where it starts; [`NONE`] if it has no edges.
    fn add_tree(
        &mut self,
        sampler: &EdgeSampler,
        boundaries: &Boundaries,
        eval: &Forward,
        frame: &LocalFrame,
    ) -> u32 {
        let buffers = sampler.buffers();
        if buffers.edges.is_empty() {
            return NONE;
        }
        // The lists of edges that lie on others, by their places in the tree.
        let mut places = vec![NONE; boundaries.edges().len()];
        for (place, &edge) in (0..).zip(&buffers.edges) {
            places[edge as usize] = place;
        }
        let overlaps = buffers.edges.iter().map(|&edge| {
            let first = self.words.len() as u32;
            let others = sampler.overlapping(edge);
            self.words.extend(others.map(|other| places[other as usize]));
            [first, self.words.len() as u32]
        });
        let overlaps: Vec<_> = overlaps.collect();

        let edges_at = self.words.len() as u32;
        let factors = buffers.factors.as_chunks::<FACTORS>().0;
        for ((&edge, factors), overlaps) in buffers.edges.iter().zip(factors).zip(overlaps) {
            self.words.extend(factors.map(float));
            for point in boundaries.edge(edge).vertices {
                let velocity = eval.boundary_point(point).tangent(0) * frame.inverse_scale;
                self.words.extend(velocity.to_array().map(float));
            }
            self.words.extend(overlaps);
        }
        let numbers_at = self.numbers.len() as u32;
        for edge in buffers.ends_and_normals.as_chunks::<EDGE>().0 {
            let [a, b, first, second] = [0, 3, 6, 9].map(|i| Vec3::new(edge[i], edge[i + 1], edge[i + 2]));
            let ends = [a, b].map(|end| frame.local_from_world(end));
            // Of unit length, unless it is flat.
            let normals = [first, second].map(|cross| match cross.normalized() {
                normal if normal.is_finite() => normal,
                _ => Vec3::zero(),
            });
            let vectors = ends.into_iter().chain(normals);
            self.numbers.extend(vectors.flat_map(Vec3::to_array));
            self.numbers.extend(normals.map(Vec3::length));
        }

        let nodes_at = self.words.len() as u32;
        let motions = sampler.motions(|point| eval.motion_of_point(point));
        let leaf = if buffers.all_edges { 12 } else { 32 };
        let nodes = buffers.nodes.as_chunks::<NODE>().0.iter();
        let bounds = buffers.bounds.as_chunks::<BOUNDS>().0;
        for ((node, bounds), motion) in nodes.zip(bounds).zip(motions) {
            self.words.extend(node);
            let centre = frame.local_from_world(Vec3::new(bounds[0], bounds[1], bounds[2]));
            self.words.extend(centre.to_array().map(float));
            let local = |length: f64| float(length * frame.inverse_scale);
            let radius = bounds[3];
            self.words.push(local(radius));
            self.words.extend(bounds[4..9].iter().copied().map(float));
            self.words.extend(bounds[9..12].iter().copied().map(local));
            let count = (node[3] - node[2]).max(leaf);
            self.words.push(local(radius * (f64::from(leaf) / f64::from(count)).sqrt()));
            self.words.extend(motion.velocity.to_array().map(local));
            self.words.push(local(motion.spread));
            self.words.extend(bounds[12..].iter().copied().map(float));
        }
        let tree = self.words.len() as u32;
        self.words.extend([nodes_at, edges_at, numbers_at]);
        tree
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
                    self.numbers.extend(frame.local_from_world(*centre).to_array());
                    self.numbers.push(radius * (1.0 + WIDER) * frame.inverse_scale);
                }
            }
        }
        at as u32
    }
}
