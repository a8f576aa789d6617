//! The boundary term of light that comes from other surfaces (METHOD 8): its
//! discontinuity at an edge is the difference of two paths that go on to either side of it.

use capwalk_boundary::{Draw, EdgePoint, Field, Viewpoint};
use capwalk_geometry::EdgeSelection;
use capwalk_math::{Real, Rgb};

use crate::emitter_edge_term::SHORT_OF_EDGE;
use crate::radiance::SpecularChain;
use crate::sampled_edge_term::sampled_edge_term;
use crate::sampled_edges::{ShadingPoint, beside_its_face};
use crate::scene_eval::{Primal, SceneEval};
use crate::tracer::{INDIRECT_EDGE_NUMBERS, Tracer};
use crate::vertex::Vertex;

impl Tracer<'_> {
    /// An estimate of it at the vertex of a path of number `depth`, over all edges; zero if the
    /// vertex reflects light in single directions only.
    pub(crate) fn indirect_edge_term<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        vertex: &Vertex<R>,
        depth: u32,
        draw: Draw,
    ) -> Rgb<R> {
        let (Some(moving), primal) = (&self.moving, eval.primal(vertex)) else {
            return Rgb::zero();
        };
        if !primal.bsdf.has_smooth() {
            return Rgb::zero();
        }
        let field = &moving.field;
        let viewpoint = Viewpoint::towards_surfaces(vertex.position, vertex.face_normal, 0);
        let at = ShadingPoint {
            field,
            eval,
            viewpoint: &viewpoint,
            vertex: &primal,
            turning: self.turning(eval, vertex, &viewpoint),
        };
        let edges = self.sampled_edges(field.boundaries, eval, EdgeSelection::All);
        let jump = |point: &EdgePoint| self.indirect_jump(field, &primal, point, depth, draw);
        sampled_edge_term(
            &at,
            edges,
            |_| 1.0,
            jump,
            draw,
            INDIRECT_EDGE_NUMBERS,
            depth,
        )
    }

    /// `f(behind) - f(before)` at a point of an edge, where `f` is what surfaces reflect
    /// towards the vertex, times BSDF and cosine. Both paths take the same random numbers.
    fn indirect_jump(
        &self,
        field: &Field,
        vertex: &Vertex<f64>,
        point: &EdgePoint,
        depth: u32,
        draw: Draw,
    ) -> Rgb {
        let accel = self.accel;
        let sides = point.sides_of_paths(field.boundaries, accel);
        let looks = sides.map(|direction| {
            let from = beside_its_face(field, vertex, point, direction);
            let hit = accel.first_hit(from.position, direction);
            (from, direction, hit)
        });
        // Where a nearer face hides the edge, both sides are the same.
        let nearest = point.distance * (1.0 - SHORT_OF_EDGE);
        if let [(_, _, Some(one)), (_, _, Some(other))] = &looks
            && one.face == other.face
            && one.t.max(other.t) < nearest
        {
            return Rgb::zero();
        }
        let [behind, before] = looks.map(|(from, direction, hit)| {
            let f = from.eval(direction);
            if f == Rgb::zero() {
                return f;
            }
            let (eval, chain) = (Primal(accel), SpecularChain::default());
            let ray = [from.position, direction];
            f * self.reflected(&eval, ray, hit, depth + 1, chain, draw)
        });
        behind - before
    }
}
