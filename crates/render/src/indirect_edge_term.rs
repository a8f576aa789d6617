//! The boundary term of light that comes from other surfaces (METHOD 8): its
//! discontinuity at an edge is the difference of two paths that go on to either side of it.
//! Edges count as they are and as flat mirrors show them.

use std::borrow::Cow;

use capwalk_boundary::{Draw, EdgePoint, MirrorImage, Viewpoint, moving_apex};
use capwalk_geometry::{EdgeSelection, Hit};
use capwalk_math::{Frame, Real, Rgb, Vec3};
use capwalk_scene::lobe::Event;

use crate::emitter_edge_term::SHORT_OF_EDGE;
use crate::light::emitter_towards;
use crate::radiance::SpecularChain;
use crate::sampled_edge_term::{Subtrees, sampled_edge_term, subtree_count};
use crate::sampled_edges::{InMirrors, ShadingPoint, beside_its_face};
use crate::scene_eval::{Primal, SceneEval};
use crate::shading::{add_lobes, black_vertex_at};
use crate::surface::{emitted_at, surface_at};
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
            following: self.following(eval, vertex, &viewpoint),
            in_mirrors: None,
        };
        let edges = self.sampled_edges(at.field.boundaries, eval, EdgeSelection::All);
        let count = subtree_count(depth, false);
        let subtrees = Subtrees::drawn(count, draw, INDIRECT_EDGE_NUMBERS, depth);
        let discontinuity =
            |point: &EdgePoint| self.indirect_discontinuity(&at, &primal, point, depth, draw);
        let direct = sampled_edge_term(&at, edges, None, |_| 1.0, discontinuity, subtrees);
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
        let corner = |i| at.eval.vertex(i);
        let mirrors = image.mirrors();
        let seen = |direction| moving_apex(&accel.mesh, &mirrors, [position, direction], corner);
        let [apex, _] = seen(position);
        let viewpoint = Viewpoint::towards_surfaces(apex, reflected.face_normal, 0);
        let in_mirrors = ShadingPoint {
            field: at.field,
            eval: at.eval,
            viewpoint: &viewpoint,
            vertex: &reflected,
            following: (at.following)
                .map(|following| following.seen(reflected.frame, |direction| seen(direction)[1])),
            in_mirrors: Some(InMirrors {
                image,
                events,
                position,
                following: at.following,
                spread: image.spread(self.mirror_spreads(at.eval)),
            }),
        };
        let edges = self.sampled_edges(at.field.boundaries, at.eval, EdgeSelection::All);
        let discontinuity = |point: &EdgePoint| {
            self.indirect_discontinuity(&in_mirrors, vertex, point, depth, draw)
        };
        let count = subtree_count(depth, true);
        let subtrees = Subtrees::drawn(count, draw, IMAGE_EDGE_NUMBERS, depth);
        let term = sampled_edge_term(&in_mirrors, edges, None, |_| 1.0, discontinuity, subtrees);
        term * R::constant(1.0 / drawn.probability)
    }

    /// `f(behind) - f(before)` at a point of an edge, where `f` is what comes back from there to the
    /// vertex, times BSDF and cosine. Both paths take the same random numbers. On the way to the edge
    /// they are reflected by the mirrors that show it and by no others: other edges may be seen in the
    /// same direction.
    fn indirect_discontinuity<R: Real, W: SceneEval<R>>(
        &self,
        at: &ShadingPoint<R, W>,
        vertex: &Vertex<f64>,
        point: &EdgePoint,
        depth: u32,
        draw: Draw,
    ) -> Rgb {
        let (accel, field) = (self.accel, at.field);
        let image: Option<&MirrorImage> = at.in_mirrors.as_ref().map(|seen| seen.image);
        let nearest = point.distance * (1.0 - SHORT_OF_EDGE);
        let sides = point.sides_of_paths(field.boundaries, accel);
        let mut paths = sides.map(|side| {
            let (from, direction) = match image {
                None => (beside_its_face(field, vertex, point, side), side),
                Some(image) => (Cow::Borrowed(vertex), image.direction(side)),
            };
            SidePath {
                weight: from.eval(direction),
                ray: [from.position, direction],
                hit: accel.first_hit(from.position, direction),
                left: nearest,
            }
        });
        let (mut events, mut reflections) = (0, 0);
        let mut chain = SpecularChain::default();
        while let Some(hit) = one_nearer_face(&paths) {
            let shows = image.is_some_and(|image| accel.reflects_next(image, reflections, &hit));
            let event = if shows { Event::Reflect } else { Event::Pass };
            let flat = accel.flat_events(&hit);
            // Where a nearer face hides the edge, both sides are the same.
            if !flat.contains(event) || !self.plan.reaches(depth + events + 3) {
                return Rgb::zero();
            }
            paths = paths.map(|path| self.after(path, event));
            chain = chain.at(flat).followed_by(event);
            // Light behind so many events has a field along them.
            if self.has_chains && chain.is_missed() {
                return Rgb::zero();
            }
            events += 1;
            reflections += usize::from(shows);
        }
        if image.is_some_and(|image| reflections < image.count()) {
            return Rgb::zero();
        }
        let shown = self.beside_edges();
        let [behind, before] = paths.map(|path| {
            let SidePath {
                weight, ray, hit, ..
            } = path;
            if weight == Rgb::zero() {
                return weight;
            }
            let eval = Primal(accel);
            // Emitters are sampled by themselves, but for those after specular events.
            let emitter = match events {
                0 => None,
                _ => emitter_towards(accel, hit.as_ref(), ray[1]),
            };
            let emitted = emitter.map_or(Rgb::zero(), |emitter| {
                emitted_at(&eval, accel, emitter, hit.as_ref(), ray[0], ray[1])
            });
            let first = depth + 1 + events;
            weight * (emitted + self.reflected(&eval, ray, hit, first, chain, shown, draw))
        });
        behind - before
    }

    /// What is seen after a specular event at the surface that is hit.
    fn after(&self, path: SidePath, event: Event) -> SidePath {
        let (eval, accel, [origin, direction]) = (Primal(self.accel), self.accel, path.ray);
        let found = path.hit.expect("a surface was hit");
        let surface = surface_at(&eval, accel, &found, origin, direction);
        let mut vertex = black_vertex_at(&surface, direction);
        add_lobes(&eval, accel, &surface, &mut vertex);
        let mut next = SidePath {
            weight: Rgb::zero(),
            left: path.left - found.t,
            ..path
        };
        // All lobes with this event send light the same way.
        let events = vertex.bsdf.events(vertex.wi);
        for event in events.filter(|specular| specular.event == event) {
            let ([_, direction], fraction) = vertex.specular(event, path.ray);
            next.weight += path.weight * fraction;
            next.ray = [vertex.position, direction];
        }
        next.hit = accel.first_hit(next.ray[0], next.ray[1]);
        next
    }
}

/// Where a path to one side of an edge is.
#[derive(Clone, Copy)]
struct SidePath {
    /// What light from there is multiplied by.
    weight: Rgb,
    ray: [Vec3; 2],
    hit: Option<Hit>,
    /// Up to this distance, surfaces are nearer than the edge.
    left: f64,
}

/// The face that both of two paths hit before the edge, where one of them does.
fn one_nearer_face(paths: &[SidePath; 2]) -> Option<Hit> {
    let [one, other] = paths.map(|path| path.hit.filter(|hit| hit.t < path.left));
    one.filter(|one| other.is_some_and(|other| one.face == other.face))
}
