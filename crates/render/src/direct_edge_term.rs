//! The boundary terms of light that comes from emitters (METHOD 8): sampled directions do not
//! move, turn with the normal, or follow the half vector, and points are sampled on the edges before an
//! emitter instead.

use capwalk_boundary::{Draw, EdgePoint, Gathers};
use capwalk_geometry::EdgeSelection;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::EmitterId;

use crate::emitter_choice::EmitterChoice;
use crate::gathered_term::gathered_term;
use crate::sampled_edge_term::{Subtrees, sampled_edge_term, subtree_count};
use crate::sampled_edges::{ShadingPoint, discontinuity};
use crate::scene_eval::{Primal, SceneEval};
use crate::surface::emitted_at;
use crate::tracer::{EDGE_NUMBERS, ENVIRONMENT_EDGE_NUMBERS, Tracer, WINDOW_EDGE_NUMBERS};
use crate::vertex::Vertex;

/// How many random numbers the edges before area emitters use at each vertex: to choose an
/// emitter, and points.
const NUMBERS: u32 = 2;

/// How many times as many edges are listed at the first vertex of a path, which matters most: points on a list have
/// less noise than points in subtrees.
const MORE_AT_FIRST: u32 = 8;

/// How many subtrees are sampled at the vertex of a path of this number in the place of a list that would be
/// too long, for each of [`Gathers::points`].
fn subtrees_per_point(depth: u32) -> u32 {
    if depth == 0 { 16 } else { 4 }
}

impl Tracer<'_> {
    /// An estimate of the boundary term of light from area emitters at the vertex of a path of
    /// number `depth`, `moving`, which `at` is without what directions follow.
    pub(crate) fn emitters_edge_term<R: Real, W: SceneEval<R>>(
        &self,
        at: &ShadingPoint<R, W>,
        moving: &Vertex<R>,
        draw: Draw,
        depth: u32,
    ) -> Rgb<R> {
        let (field, vertex) = (at.field, at.vertex);
        let emitters = &field.boundaries.area_emitters;
        if emitters.is_empty() || at.eval.is_still(at.viewpoint) {
            return Rgb::zero();
        }
        // Choose one of them.
        let dimension = EDGE_NUMBERS + NUMBERS * (depth + 1);
        let choice = EmitterChoice::by_light(
            self.accel,
            self.emitters,
            &vertex.receiver(),
            emitters.len(),
            |i| emitters[i].emitter,
        );
        let Some((chosen, probability)) = choice.choose(draw.stream.number(dimension)) else {
            return Rgb::zero();
        };
        let chosen = &emitters[chosen];
        let Some(window) = chosen.window(vertex.position) else {
            return Rgb::zero();
        };
        // Sample points on edges in its window.
        let discontinuity = |point: &EdgePoint| discontinuity(field, vertex, point, chosen.emitter);
        draw.count_queries(1);
        let place = draw.stream.number(dimension + 1);
        let at = &ShadingPoint {
            following: self.following_before(at.eval, moving, at.viewpoint, chosen.emitter),
            in_mirrors: None,
            ..*at
        };
        // If directions do not move, only edges that move contribute.
        let is_stationary = at.motion().is_still();
        let among = is_stationary.then(|| self.moving_edges(field.boundaries, at.eval));
        let Gathers { points, .. } = self.gathers;
        let listed =
            |among, most| gathered_term(at, &window, among, points, discontinuity, place, most);
        // Lists that are too long take longer than they are worth. Then subtrees of the meshes' edges are
        // sampled, and what no mesh has is listed.
        let crossings = field.boundaries.emitting_crossings();
        let listed_here = match depth {
            0 => self.gathers.listed.saturating_mul(MORE_AT_FIRST),
            _ => self.gathers.listed,
        };
        let most = crossings.map_or(u32::MAX, |_| listed_here);
        let term = listed(among, most).unwrap_or_else(|| {
            let edges = self.sampled_edges(field.boundaries, at.eval, EdgeSelection::Silhouettes);
            let count = points * subtrees_per_point(depth);
            let subtrees = Subtrees::drawn(count, draw, WINDOW_EDGE_NUMBERS, depth);
            let of_crossings = listed(crossings, u32::MAX).unwrap_or(Rgb::zero());
            let window = Some(&window);
            of_crossings + sampled_edge_term(at, edges, window, |_| 1.0, discontinuity, subtrees)
        });
        // Divide by the probability of the emitter.
        term * R::constant(1.0 / probability)
    }

    /// An estimate of the boundary term of light from the environment.
    pub(crate) fn environment_edge_term<R: Real, W: SceneEval<R>>(
        &self,
        at: &ShadingPoint<R, W>,
        environment: EmitterId,
        draw: Draw,
        depth: u32,
    ) -> Rgb<R> {
        let (accel, field, vertex) = (self.accel, at.field, at.vertex);
        let edges = self.sampled_edges(field.boundaries, at.eval, EdgeSelection::Silhouettes);
        let radiance = |direction: Vec3| {
            let origin = vertex.position;
            let light = emitted_at(&Primal(accel), accel, environment, None, origin, direction);
            light.max_component()
        };
        let discontinuity = |point: &EdgePoint| discontinuity(field, vertex, point, environment);
        let count = subtree_count(depth, false);
        let subtrees = Subtrees::drawn(count, draw, ENVIRONMENT_EDGE_NUMBERS, depth);
        sampled_edge_term(at, edges, None, radiance, discontinuity, subtrees)
    }
}
