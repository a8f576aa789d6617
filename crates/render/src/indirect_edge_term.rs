//! The boundary term of light that comes from other surfaces (METHOD 8): its
//! discontinuity at an edge is the difference of two paths that go on to either side of it.
//! Edges count as they are and as flat mirrors show them.

use std::borrow::Cow;

use capwalk_boundary::{Draw, EdgePoint, MirrorImage, Viewpoint, moving_apex};
use capwalk_geometry::EdgeSelection;
use capwalk_math::{Frame, Real, Rgb};
use capwalk_scene::lobe::Event;

use crate::emitter_edge_term::SHORT_OF_EDGE;
use crate::radiance::SpecularChain;
use crate::sampled_edge_term::sampled_edge_term;
use crate::sampled_edges::{InMirrors, ShadingPoint, beside_its_face};
use crate::scene_eval::{Primal, SceneEval};
use crate::tracer::{IMAGE_EDGE_NUMBERS, IMAGE_NUMBERS, INDIRECT_EDGE_NUMBERS, Tracer};
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
        let viewpoint = Viewpoint::towards_surfaces(vertex.position, vertex.face_normal, 0);
        let at = ShadingPoint {
            field: &moving.field,
            eval,
            viewpoint: &viewpoint,
            vertex: &primal,
            turning: self.turning(eval, vertex, &viewpoint),
            in_mirrors: None,
        };
        let edges = self.sampled_edges(at.field.boundaries, eval, EdgeSelection::All);
        let numbers = INDIRECT_EDGE_NUMBERS;
        let jump = |point: &EdgePoint| self.indirect_jump(&at, &primal, point, depth, draw);
        let direct = sampled_edge_term(&at, edges, |_| 1.0, jump, draw, numbers, depth);
        direct + self.indirect_image_term(&at, depth, draw)
    }

    /// The same over edges as flat mirrors show them: around where one of the mirrors, or some in
    /// turn, make the vertex appear. Drawn at random, they stand for all of them.
    fn indirect_image_term<R: Real, W: SceneEval<R>>(
        &self,
        at: &ShadingPoint<R, W>,
        depth: u32,
        draw: Draw,
    ) -> Rgb<R> {
        let (accel, vertex) = (self.accel, at.vertex);
        let events = self.events_behind(depth + 1);
        if events == 0 {
            return Rgb::zero();
        }
        let horizon = (!vertex.transmits).then_some(vertex.face_normal);
        let u = draw.stream.number(IMAGE_NUMBERS + depth);
        let Some(drawn) = accel.draw_image(vertex.position, horizon, events, u) else {
            return Rgb::zero();
        };
        // Behind its mirrors, the vertex looks into the scene as it is.
        let image = &drawn.image;
        let behind = |direction| image.direction_in_scene(direction);
        let Frame { s, t, n } = vertex.frame;
        let reflected = Vertex {
            position: image.apex,
            face_normal: behind(vertex.face_normal),
            frame: Frame {
                s: behind(s),
                t: behind(t),
                n: behind(n),
            },
            ..vertex.clone()
        };
        let position = at.viewpoint.position;
        let normal = at.turning.unwrap_or(position);
        let corner = |i| at.eval.vertex(i);
        let [apex, normal] = moving_apex(&accel.mesh, &image.mirrors(), [position, normal], corner);
        let viewpoint = Viewpoint::towards_surfaces(apex, reflected.face_normal, 0);
        let in_mirrors = ShadingPoint {
            field: at.field,
            eval: at.eval,
            viewpoint: &viewpoint,
            vertex: &reflected,
            turning: at.turning.map(|_| normal),
            in_mirrors: Some(InMirrors {
                image,
                events,
                position,
                turning: at.turning,
            }),
        };
        let edges = self.sampled_edges(at.field.boundaries, at.eval, EdgeSelection::All);
        let jump = |point: &EdgePoint| self.indirect_jump(&in_mirrors, vertex, point, depth, draw);
        let numbers = IMAGE_EDGE_NUMBERS;
        let term = sampled_edge_term(&in_mirrors, edges, |_| 1.0, jump, draw, numbers, depth);
        term * R::constant(1.0 / drawn.probability)
    }

    /// `f(behind) - f(before)` at a point of an edge, where `f` is what surfaces reflect
    /// towards the vertex, times BSDF and cosine. Both paths take the same random numbers.
    fn indirect_jump<R: Real, W: SceneEval<R>>(
        &self,
        at: &ShadingPoint<R, W>,
        vertex: &Vertex<f64>,
        point: &EdgePoint,
        depth: u32,
        draw: Draw,
    ) -> Rgb {
        let (accel, field) = (self.accel, at.field);
        let image: Option<&MirrorImage> = at.in_mirrors.as_ref().map(|seen| seen.image);
        let sides = point.sides_of_paths(field.boundaries, accel);
        let looks = sides.map(|side| {
            let (from, direction) = match image {
                None => (beside_its_face(field, vertex, point, side), side),
                Some(image) => (Cow::Borrowed(vertex), image.direction(side)),
            };
            let hit = accel.first_hit(from.position, direction);
            (from, direction, hit)
        });
        // Where a nearer face hides the edge, both sides are the same.
        let nearest = point.distance * (1.0 - SHORT_OF_EDGE);
        if image.is_none()
            && let [(_, _, Some(one)), (_, _, Some(other))] = &looks
            && one.face == other.face
            && one.t.max(other.t) < nearest
            && !accel.flat_events(one).contains(Event::Pass)
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
