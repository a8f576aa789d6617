//! The boundary term of the edges before the environment (METHOD 8): sampled directions do
//! not move, and points are sampled on edges around the shading point instead. There are
//! too many to gather; a tree of them is descended at random to a few.

use std::cell::RefCell;

use capwalk_boundary::{Draw, EdgeBounds, Motion};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::EmitterId;

use crate::sampled_edges::{ListedEdge, SampledEdges, ShadingPoint};
use crate::scene_eval::{Primal, SceneEval};
use crate::surface::emitted_at;
use crate::vertex::Vertex;

/// How many random numbers [`environment_edge_term`] uses.
pub const NUMBERS: u32 = 2;

/// Subtrees for each shading point.
const SUBTREES: u32 = 2;
/// Points on the edges of each.
const POINTS: u32 = 1;

/// 1 over the golden ratio: its multiples are spread evenly in `[0, 1)`.
const SPREAD: f64 = 0.618_033_988_749_895;

/// An estimate of the boundary term of direct light from the environment, see
/// [`SampledEdges::term`], over all edges. `motions` are those of the nodes of the edge
/// sampler. The [`NUMBERS`] from `dimension` on choose subtrees and points.
pub fn environment_edge_term<R: Real, W: SceneEval<R>>(
    at: &ShadingPoint<R, W>,
    motions: &[Motion],
    environment: EmitterId,
    draw: Draw,
    dimension: u32,
) -> Rgb<R> {
    let (field, eval, vertex) = (at.field, at.eval, at.vertex);
    if eval.is_still(at.viewpoint) {
        return Rgb::zero();
    }
    let position = vertex.position;
    let turning = at.motion();
    let sampler = field.boundaries.edge_sampler(field.accel);
    let importance = |node: usize, bounds: &EdgeBounds| {
        // Over all of the node, what turns moves as at its centre, give or take its size.
        let mut motion = turning.at(bounds.centre - position);
        motion.spread += turning.speed() * bounds.radius;
        let speed = motions[node].speed_against(&motion, &bounds.normals);
        importance(vertex, bounds, speed)
    };
    let primal = Primal(field.accel);
    let radiance = |direction: Vec3| {
        let radiance = emitted_at(&primal, field.accel, environment, None, position, direction);
        radiance.max_component()
    };
    let [u, place] = draw.stream.pair(dimension);
    draw.count_queries(u64::from(SUBTREES));
    MEMORY.with_borrow_mut(|edges| {
        let mut light = Rgb::zero();
        for i in 0..SUBTREES {
            // Descend to a few edges, stratified.
            let u = (f64::from(i) + u) / f64::from(SUBTREES);
            let Some(subtree) = sampler.descend(position, u, importance) else {
                continue;
            };
            // Weigh the silhouettes among them.
            let silhouettes = sampler.silhouettes(&subtree, position);
            let listed = silhouettes.map(|silhouette| ListedEdge {
                edge: silhouette.edge,
                ends: silhouette.ends,
                factor: silhouette.exposure,
            });
            edges.weigh(at, listed, &[], radiance);
            // Edges of other subtrees may lie on them and share the discontinuity.
            edges.push_companions(|edge| {
                let others = sampler.overlapping(edge);
                others.filter(|&other| {
                    let edge = field.boundaries.edge(other);
                    edge.is_silhouette(&field.accel.mesh, position)
                })
            });
            // Divide by the probability of the subtree.
            let place = (place + SPREAD * f64::from(i)).fract();
            let weight = 1.0 / (subtree.probability * f64::from(SUBTREES));
            light += edges.term(at, environment, place, POINTS) * R::constant(weight);
        }
        light
    })
}

/// A guess of what edges contribute: the length of the visible silhouettes among them times their
/// speed, over the square of their distance, times the largest cosine of a direction to
/// them. Zero only if they contribute nothing.
fn importance(vertex: &Vertex<f64>, bounds: &EdgeBounds, speed: f64) -> f64 {
    let offset = bounds.centre - vertex.position;
    let distance = offset.length();
    let cosine = match distance <= bounds.radius {
        true => 1.0,
        false => {
            // The angle between the normal and the centre, less that of the ball around it.
            let cos = offset.dot(vertex.frame.n) / distance;
            let cos = if vertex.transmits { cos.abs() } else { cos };
            let sin_ball = bounds.radius / distance;
            let cos_ball = (1.0 - sin_ball * sin_ball).max(0.0).sqrt();
            match cos >= cos_ball {
                true => 1.0,
                false => {
                    let sin = (1.0 - cos * cos).max(0.0).sqrt();
                    (cos * cos_ball + sin * sin_ball + ROUNDING).max(0.0)
                }
            }
        }
    };
    // The mean of 1/d² over a disk, beside the smallest one.
    let squared = |x: f64| x * x;
    let radius = squared(bounds.radius).max(f64::MIN_POSITIVE);
    let beyond = (squared(distance) - radius).max(0.0) + squared(bounds.least_radius);
    let near = (radius / beyond).ln_1p() / radius;
    bounds.visible_length(vertex.position) * speed * cosine * near
}

/// Of a cosine.
const ROUNDING: f64 = 1e-9;

thread_local! {
    static MEMORY: RefCell<SampledEdges> = RefCell::default();
}
