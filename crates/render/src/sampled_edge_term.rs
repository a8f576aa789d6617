//! The boundary term of edges that are too many to gather (METHOD 8): before the environment,
//! and before surfaces that reflect light. Sampled directions do not move, and points are
//! sampled on edges around the shading point instead: a tree of them is descended at random to
//! a few.

use std::cell::RefCell;

use capwalk_boundary::{Draw, EdgeBounds, EdgePoint, EdgeSampler, Motion, Window};
use capwalk_geometry::EdgeSelection;
use capwalk_math::{Real, Rgb, Vec3};

use crate::highlight::Highlight;
use crate::sampled_edges::{ListedEdge, SampledEdges, ShadingPoint};
use crate::scene_eval::SceneEval;
use crate::vertex::Vertex;

/// How many random numbers [`sampled_edge_term`] uses.
const NUMBERS: u32 = 2;

/// Subtrees for the vertex of a path of this number: later ones matter less, and so does what is seen
/// in mirrors.
pub const fn subtree_count(depth: u32, in_mirrors: bool) -> u32 {
    if depth == 0 && !in_mirrors { 2 } else { 1 }
}
/// Points on the edges of each.
const POINTS: u32 = 1;

/// 1 over the golden ratio: its multiples are spread evenly in `[0, 1)`.
pub const SPREAD: f64 = 0.618_033_988_749_895;

/// How many subtrees are sampled, and by which random numbers.
#[derive(Clone, Copy, Debug)]
pub struct Subtrees {
    /// How many, with a point in each.
    count: u32,
    /// They choose subtrees and points.
    numbers: [f64; 2],
}

impl Subtrees {
    /// So many at the vertex of number `depth`, by [`NUMBERS`] random numbers from `first` on.
    pub fn drawn(count: u32, draw: Draw, first: u32, depth: u32) -> Self {
        draw.count_queries(u64::from(count));
        Self {
            count,
            numbers: draw.stream.pair(first + NUMBERS * depth),
        }
    }
}

/// An estimate of the boundary term over all edges of a sampler, or all in a window, see
/// [`SampledEdges::term`]. `motions` are those of the sampler's nodes. `light` guesses the radiance
/// from a direction, and `discontinuity` is the discontinuity of reflected radiance.
pub fn sampled_edge_term<R: Real, W: SceneEval<R>>(
    at: &ShadingPoint<R, W>,
    (sampler, motions): (&EdgeSampler, &[Motion]),
    window: Option<&Window>,
    light: impl Fn(Vec3) -> f64,
    mut discontinuity: impl FnMut(&EdgePoint) -> Rgb,
    subtrees: Subtrees,
) -> Rgb<R> {
    let (field, vertex) = (at.field, at.vertex);
    if at.eval.is_still(at.viewpoint) {
        return Rgb::zero();
    }
    let position = vertex.position;
    let turning = at.motion();
    let highlight = Highlight::of(vertex);
    let importance = |node: usize, bounds: &EdgeBounds| {
        // Over all of the node, what turns moves as at its centre, give or take its size.
        let mut motion = turning.at(bounds.centre - position);
        motion.spread += turning.speed() * bounds.radius;
        let speed = motions[node].speed_against(&motion, &bounds.normals);
        let share = window.map_or(1.0, |window| window.share(bounds.centre, bounds.radius));
        share * importance(vertex, highlight, bounds, speed)
    };
    let counts = |edge: u32| {
        let edge = field.boundaries.edge(edge);
        sampler.selection() == EdgeSelection::All || edge.is_silhouette(&field.accel.mesh, position)
    };
    let (count, [u, place]) = (subtrees.count, subtrees.numbers);
    let planes = window.map_or(&[][..], |window| &window.planes);
    MEMORY.with_borrow_mut(|edges| {
        let mut term = Rgb::zero();
        for i in 0..count {
            // Descend to a few edges, stratified.
            let u = (f64::from(i) + u) / f64::from(count);
            let Some(subtree) = sampler.descend(position, u, importance) else {
                continue;
            };
            // Weigh those of them that count.
            let counted = sampler.counted(&subtree, position);
            let listed = counted.map(|counted| ListedEdge {
                edge: counted.edge,
                ends: counted.ends,
                factor: counted.factor,
            });
            edges.weigh(at, listed, planes, &light);
            // Edges of other subtrees may lie on them and share the discontinuity, if they move.
            edges.push_companions(field.boundaries, |edge| {
                let others = sampler.overlapping(edge);
                others.filter(|&other| counts(other) && !at.is_stationary(&turning, other))
            });
            // Divide by the probability of the subtree.
            let place = (place + SPREAD * f64::from(i)).fract();
            let weight = 1.0 / (subtree.probability * f64::from(count));
            term += edges.term(at, &mut discontinuity, place, POINTS) * R::constant(weight);
        }
        term
    })
}

/// A guess of what edges contribute: the visible length of those that count times their speed,
/// over the square of their distance, times the most that is scattered of light from there. Zero
/// only if they contribute nothing.
fn importance(
    vertex: &Vertex<f64>,
    highlight: Option<Highlight>,
    bounds: &EdgeBounds,
    speed: f64,
) -> f64 {
    let distance = (bounds.centre - vertex.position).length();
    let cosine = vertex
        .receiver()
        .largest_cosine(bounds.centre, bounds.radius);
    let scattered = highlight.map_or(cosine, |highlight| {
        highlight.largest(vertex, bounds.centre, bounds.radius, cosine)
    });
    // The mean of 1/d² over a disk, beside the smallest one.
    let squared = |x: f64| x * x;
    let radius = squared(bounds.radius).max(f64::MIN_POSITIVE);
    let beyond = (squared(distance) - radius).max(0.0) + squared(bounds.least_radius);
    let near = (radius / beyond).ln_1p() / radius;
    bounds.visible_length(vertex.position) * speed * scattered * near
}

thread_local! {
    static MEMORY: RefCell<SampledEdges> = RefCell::default();
}
