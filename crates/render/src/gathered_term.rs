//! The boundary term of gathered silhouettes towards emitters (METHOD 8): sampled
//! directions do not move, and points are sampled on the projected edges instead.

use std::cell::RefCell;

use capwalk_boundary::{Draw, EdgePoint};
use capwalk_math::{Real, Rgb, Vec3};

use crate::sampled_edges::{ListedEdge, SampledEdges, ShadingPoint, discontinuity};
use crate::scene_eval::SceneEval;

/// How many random numbers [`gathered_term`] uses.
pub const NUMBERS: u32 = 2;

/// Bounds of the root of the number of pieces, as far as it decides how many points there are:
/// where there are many pieces they differ more.
const ROOTS: [f64; 2] = [2.0, 32.0];

/// An estimate of the boundary term of direct light from area emitters, see
/// [`SampledEdges::term`], over all edges in front of an emitter and its own, from `points` times
/// the root of the number of their pieces. The [`NUMBERS`] from `dimension` on choose the emitter and the points.
pub fn gathered_term<R: Real, W: SceneEval<R>>(
    at: &ShadingPoint<R, W>,
    points: u32,
    draw: Draw,
    dimension: u32,
) -> Rgb<R> {
    let boundaries = at.field.boundaries;
    let emitters = &boundaries.area_emitters;
    if emitters.is_empty() || at.eval.is_still(at.viewpoint) {
        return Rgb::zero();
    }
    // Choose one emitter uniformly.
    let [choice, place] = draw.stream.pair(dimension);
    let chosen = &emitters[((choice * emitters.len() as f64) as usize).min(emitters.len() - 1)];
    let Some(window) = chosen.window(at.vertex.position) else {
        return Rgb::zero();
    };
    // Gather the edges in its window, with sampling weights.
    draw.count_queries(1);
    MEMORY.with_borrow_mut(|Memory { gathered, edges }| {
        boundaries.gather(&window.cone, gathered);
        let listed = gathered.iter().map(|&(edge, ends)| ListedEdge {
            edge,
            ends,
            factor: 1.0,
        });
        edges.weigh(at, listed, &window.planes, |_| 1.0);
        // Divide by the probability of the emitter.
        let root = (edges.count() as f64).sqrt().clamp(ROOTS[0], ROOTS[1]);
        let points = ((f64::from(points) * root) as u32).max(1);
        let jump = |point: &EdgePoint| discontinuity(at.field, at.vertex, point, chosen.emitter);
        edges.term(at, jump, place, points) * R::constant(emitters.len() as f64)
    })
}

/// Memory for one sample after another.
#[derive(Default)]
struct Memory {
    gathered: Vec<(u32, [Vec3; 2])>,
    edges: SampledEdges,
}

thread_local! {
    static MEMORY: RefCell<Memory> = RefCell::default();
}
