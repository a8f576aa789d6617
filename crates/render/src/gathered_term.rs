//! The boundary term of all edges in a window, gathered (METHOD 8).

use std::cell::RefCell;

use capwalk_boundary::{EdgePoint, Window};
use capwalk_geometry::EdgeSubset;
use capwalk_math::{Real, Rgb, Vec3};

use crate::sampled_edges::{ListedEdge, SampledEdges, ShadingPoint};
use crate::scene_eval::SceneEval;

/// Bounds of the root of the number of pieces, as far as it decides how many points there are:
/// where there are many pieces they differ more.
pub const ROOTS: [f64; 2] = [2.0, 32.0];

/// An estimate of the boundary term, see [`SampledEdges::term`], over all edges in the window
/// of an emitter and its own, from `points` times the root of the number of their pieces. The
/// random number `u` chooses the points. `discontinuity` is the discontinuity of reflected radiance.
/// `among` are all edges that contribute, if some do not. `None` if there are more than `most` edges.
pub fn gathered_term<R: Real, W: SceneEval<R>>(
    at: &ShadingPoint<R, W>,
    window: &Window,
    among: Option<&EdgeSubset>,
    points: u32,
    discontinuity: impl FnMut(&EdgePoint) -> Rgb,
    u: f64,
    most: u32,
) -> Option<Rgb<R>> {
    MEMORY.with_borrow_mut(|Memory { gathered, edges }| {
        let boundaries = at.field.boundaries;
        let are_all = boundaries.gather(&window.cone, among, most as usize, gathered);
        if !are_all {
            return None;
        }
        let listed = gathered.iter().map(|&(edge, ends)| ListedEdge {
            edge,
            ends,
            factor: 1.0,
        });
        edges.weigh(at, listed, &window.planes, |_| 1.0);
        let root = (edges.count() as f64).sqrt().clamp(ROOTS[0], ROOTS[1]);
        let points = ((f64::from(points) * root) as u32).max(1);
        Some(edges.term(at, discontinuity, u, points))
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
