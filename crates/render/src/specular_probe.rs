//! Whether anything moves that is seen in curved mirrors or behind refracting glass, asked before
//! the work (METHOD 6).
//!
//! A probe follows paths with random numbers of its own. How many there are does not depend on the
//! film, on the samples that are asked for or on their seed, so its answer is a property of the
//! scene and of what moves in it. Paths are spread over the whole film, whatever part of it is
//! rendered, and aimed: at mirrors, from the camera and from the surfaces that it sees, and by
//! mirrors at what moves ([`crate::specular_search`]). At each specular vertex all events are looked
//! at, however little light they carry.

use std::ops::Range;

use capwalk_boundary::{
    Counts, Draw, MAX_EVENTS, Stream, Viewpoint, bends_images, flat_events, may_be_specular,
};
use capwalk_geometry::{Hit, Ray};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::ShapeId;
use capwalk_scene::lobe::Event;
use capwalk_scene::sensor::view::{View, ViewRay};

use crate::half_vector::direction_along;
use crate::radiance::SpecularChain;
use crate::scene_eval::SceneEval;
use crate::shading::{add_lobes, black_vertex_at};
use crate::surface::surface_at;
use crate::tracer::Tracer;
use crate::uncovered_events::{CAMERA_FIELD, Causes, MOTION, SURFACE_FIELD, UncoveredEvents};
use crate::vertex::Vertex;

/// Paths along each side of the film that begin at film points spread over it.
const SIDE: u32 = 16;
/// Paths that begin at a point of a mirror which the camera may see. A mirror that fills a hundredth of
/// the image is met by three of the others.
const AIMED: u32 = 256;
/// Points of what moves of which one must be in the image, for the camera's field to move its rays.
const CAMERA_SAMPLES: u32 = 64;
/// Most vertices of a path that scatter light otherwise than by specular events. Farther on the same
/// surfaces are met.
const MOST_BOUNCES: u32 = 3;
/// Most specular events in a row that are followed: more than silhouettes are covered behind.
pub(crate) const MOST_EVENTS: u32 = MAX_EVENTS + 2;

/// The seed of all probes; the square root of 3.
const SEED: u64 = 0xbb67_ae85_84ca_a73b;
/// The first random number of a path that is none of the camera's.
const FIRST_NUMBER: u32 = 16;

/// The random numbers of one path of a probe, one after the other.
pub(crate) struct Random {
    pub(crate) stream: Stream,
    next: u32,
}

impl Random {
    pub(crate) fn new(path: u64) -> Self {
        Self {
            stream: Stream::independent(SEED, path),
            next: FIRST_NUMBER,
        }
    }

    /// Uniform in [0, 1).
    pub(crate) fn number(&mut self) -> f64 {
        self.next += 1;
        self.stream.number(self.next)
    }

    pub(crate) fn pair(&mut self) -> [f64; 2] {
        [self.number(), self.number()]
    }

    /// Uniform from 0 to below `count`, which is not 0.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        ((self.number() * count as f64) as usize).min(count - 1)
    }
}

/// A segment of a path.
#[derive(Clone, Copy)]
pub(crate) struct Segment<R> {
    /// Origin and direction.
    pub(crate) ray: [Vec3<R>; 2],
    hit: Option<Hit>,
    chain: SpecularChain,
    past: Past,
}

/// The path before the end of a segment.
#[derive(Clone, Copy)]
pub(crate) struct Past {
    /// The number of the vertex at that end.
    depth: u32,
    /// Which fields may have moved its segments.
    fields: Causes,
}

/// The motion, as far as a probe may use it.
pub struct ProbedMotion<'m> {
    /// Which shapes move.
    pub shapes: &'m [bool],
    /// True if curves in the image move: then directions along fields may move.
    pub moves_curves: bool,
}

/// A probe of the paths of a tracer, by any scalar that tells what depends on the motion.
pub struct SpecularProbe<'a> {
    pub(crate) tracer: &'a Tracer<'a>,
    /// The faces of each shape that shows images which are not covered.
    mirrors: Vec<Range<u32>>,
    /// The faces of each shape that moves.
    moving: Vec<Range<u32>>,
    /// The faces of each shape that shows flat mirror images.
    pub(crate) flat_mirrors: Vec<Range<u32>>,
    /// True if boundaries may be seen to move where no face that moves is seen: shadows.
    pub(crate) has_shadows: bool,
    pub(crate) moves_curves: bool,
    /// Which fields move the camera's rays.
    of_camera: Causes,
}

impl<'a> SpecularProbe<'a> {
    /// A probe; `None` if it would find nothing: what the camera sees is not light, paths end at the
    /// first surface, or all specular events are covered.
    pub fn new(tracer: &'a Tracer<'a>, motion: &ProbedMotion) -> Option<Self> {
        let (accel, plan) = (tracer.accel, &tracer.plan);
        let scene = &accel.scene;
        if plan.aov.is_some() || !plan.reaches(2) {
            return None;
        }
        let all_miss = tracer.misses_mirrors() || accel.view.is_parallel();
        let shapes = (0..).map(ShapeId).zip(&scene.shapes);
        let faces = |id: ShapeId| {
            let first = accel.first_face[id.0 as usize];
            first..first + scene.shape(id).mesh.faces.len() as u32
        };
        let mirrors = shapes.clone().filter(|(_, shape)| match all_miss {
            true => may_be_specular(scene, shape.bsdf),
            false => bends_images(scene, shape),
        });
        let mirrors: Vec<_> = mirrors.map(|(id, _)| faces(id)).collect();
        if mirrors.is_empty() && !has_long_chains(tracer) {
            return None;
        }
        let moving = shapes.zip(motion.shapes).filter(|(_, moves)| **moves);
        let flat_mirrors = (0..).map(ShapeId).take(scene.shapes.len());
        let flat_mirrors = flat_mirrors.filter(|&id| accel.is_flat_mirror(id));
        let mut probe = Self {
            tracer,
            mirrors,
            moving: moving.map(|((id, _), _)| faces(id)).collect(),
            flat_mirrors: flat_mirrors.map(faces).collect(),
            has_shadows: scene.emitters.iter().any(|emitter| emitter.is_delta()),
            moves_curves: motion.moves_curves,
            of_camera: 0,
        };
        let sees = |number: u32| probe.camera_sees_motion(&mut Random::new(u64::from(number)));
        if motion.moves_curves && (0..CAMERA_SAMPLES).any(sees) {
            probe.of_camera = CAMERA_FIELD;
        }
        Some(probe)
    }

    /// How many paths there are.
    pub fn paths(&self) -> u32 {
        match self.mirrors.is_empty() {
            true => SIDE * SIDE,
            false => SIDE * SIDE + AIMED,
        }
    }

    /// What a path finds.
    pub fn path<R: Real, W: SceneEval<R>>(&self, eval: &W, path: u32) -> UncoveredEvents {
        let mut found = UncoveredEvents::default();
        let mut random = Random::new(u64::from(CAMERA_SAMPLES + path));
        let view = self.view(eval, &random);
        let film = match path.checked_sub(SIDE * SIDE) {
            None => {
                let [x, y] = random.pair();
                let place = [f64::from(path % SIDE) + x, f64::from(path / SIDE) + y];
                Some(self.film_point(place.map(|x| x / f64::from(SIDE))))
            }
            Some(aimed) => {
                let mirror = aimed as usize % self.mirrors.len();
                let point = self.point_on(&self.mirrors[mirror], &mut random);
                self.film_point_of(&view.value(), point)
            }
        };
        if let Some(film) = film {
            self.wander(
                eval,
                self.camera_segment(&view, film),
                &mut random,
                &mut found,
            );
        }
        found
    }

    /// Follows a path at random, by specular events more often than light would.
    fn wander<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        mut segment: Segment<R>,
        random: &mut Random,
        found: &mut UncoveredEvents,
    ) {
        let mut bounces = 0;
        while segment.past.depth <= MOST_EVENTS + MOST_BOUNCES
            && let Some((vertex, onward)) = self.arrive(eval, &segment, found)
        {
            let scatters = vertex.bsdf.has_smooth();
            if !onward.is_empty() && (!scatters || random.number() < 0.5) {
                segment = onward[random.below(onward.len())];
                continue;
            }
            if !scatters || bounces == MOST_BOUNCES || !self.goes_on(&segment) {
                return;
            }
            bounces += 1;
            let primal = vertex.value();
            let past = self.past(&segment, &primal, random);
            if let Some(direction) = self.aim(&primal, random)
                && let Some(aimed) = self.scattered(eval, &vertex, direction, past)
            {
                let rule = random.below(RULES) as u32;
                self.along(eval, aimed, rule, found);
            }
            let drawn = primal
                .bsdf
                .sample(primal.wi, random.number(), random.pair());
            let Some(drawn) = drawn.filter(|drawn| drawn.specular.is_none()) else {
                return;
            };
            let direction = primal.frame.to_world(drawn.wo).normalized();
            let Some(next) = self.scattered(eval, &vertex, direction, past) else {
                return;
            };
            segment = next;
        }
    }

    /// Follows a chain of specular events that are chosen by a rule, and returns its last segment; `None`
    /// if no event of it is uncovered.
    pub(crate) fn along<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        mut segment: Segment<R>,
        rule: u32,
        found: &mut UncoveredEvents,
    ) -> Option<Segment<R>> {
        let mut is_missed = false;
        for number in 0..MOST_EVENTS {
            let onward = self.arrive(eval, &segment, found);
            let onward = onward.map(|(_, onward)| onward).unwrap_or_default();
            let reflects = rule >> (number % RULE_BITS) & 1 == 1;
            let chosen = match reflects {
                true => onward.first(),
                false => onward.last(),
            };
            let Some(&next) = chosen else { break };
            is_missed |= next.chain.is_missed() || self.tracer.misses_mirrors();
            segment = next;
        }
        is_missed.then_some(segment)
    }

    /// The vertex that a segment leads to, and the segments behind each of its specular events,
    /// reflections first. Those that are not covered and show a motion are noted.
    pub(crate) fn arrive<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        segment: &Segment<R>,
        found: &mut UncoveredEvents,
    ) -> Option<(Vertex<R>, Vec<Segment<R>>)> {
        let (accel, tracer) = (self.tracer.accel, self.tracer);
        let reaches = tracer.plan.reaches(segment.past.depth + 2);
        let hit = segment.hit.filter(|_| reaches)?;
        let surface = surface_at(eval, accel, &hit, segment.ray[0], segment.ray[1]);
        let mut vertex = black_vertex_at(&surface, segment.ray[1]);
        if !add_lobes(eval, accel, &surface, &mut vertex) {
            return None;
        }
        let chain = segment.chain.at(accel.flat_events(&hit));
        let mut onward = Vec::new();
        for event in vertex.bsdf.events(vertex.wi) {
            let (ray, fraction) = vertex.specular(event, segment.ray);
            if fraction.value() == Rgb::zero() {
                continue;
            }
            let next = accel.first_hit(vertex.position.value(), ray[1].value());
            if tracer.misses(chain, event) {
                let moves = tracer.moves_behind(eval, &ray, &next);
                found.add(segment.past.fields | if moves { MOTION } else { 0 });
            }
            onward.push(Segment {
                ray,
                hit: next,
                chain: chain.followed_by(event.event),
                past: Past {
                    depth: segment.past.depth + 1,
                    ..segment.past
                },
            });
        }
        Some((vertex, onward))
    }

    /// True if light that the vertex behind a segment scatters is sampled.
    pub(crate) fn goes_on<R>(&self, segment: &Segment<R>) -> bool {
        self.tracer.plan.reaches(segment.past.depth + 3)
    }

    /// What is behind a segment from a vertex, to which another one led.
    pub(crate) fn past<R>(
        &self,
        before: &Segment<R>,
        vertex: &Vertex<f64>,
        random: &mut Random,
    ) -> Past {
        let field = match self.sees_motion(vertex, random) {
            true => SURFACE_FIELD,
            false => 0,
        };
        Past {
            depth: before.past.depth + 1,
            fields: before.past.fields | field,
        }
    }

    /// The segment in a direction from a vertex that scatters light; `None` if no light comes from
    /// there.
    pub(crate) fn scattered<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        vertex: &Vertex<R>,
        direction: Vec3,
        past: Past,
    ) -> Option<Segment<R>> {
        let f = vertex.eval(Vec3::constant(direction));
        if f.value() == Rgb::zero() {
            return None;
        }
        let tracer = self.tracer;
        let position = vertex.position.value();
        let viewpoint = Viewpoint::towards_surfaces(vertex.position, vertex.face_normal, 0);
        let following = tracer.following(eval, vertex, &viewpoint);
        Some(Segment {
            ray: [vertex.position, direction_along(direction, following)],
            hit: tracer.accel.first_hit(position, direction),
            chain: SpecularChain::default(),
            past,
        })
    }

    /// What the camera sees from a point of its lens.
    pub(crate) fn view<R: Real, W: SceneEval<R>>(&self, eval: &W, random: &Random) -> View<R> {
        let draw = Draw {
            stream: &random.stream,
            counts: &Counts::default(),
        };
        self.tracer.view(eval, draw)
    }

    /// The first segment of the path through a film point that stays.
    pub(crate) fn camera_segment<R: Real>(&self, view: &View<R>, film: [f64; 2]) -> Segment<R> {
        let accel = self.tracer.accel;
        let ray: ViewRay<R> = view.ray(view.direction(film.map(R::constant)));
        let ViewRay {
            origin,
            direction,
            range: [t_min, t_max],
        } = ray.value();
        Segment {
            ray: [ray.origin, ray.direction],
            hit: accel.first_hit_within(&Ray {
                origin,
                direction,
                t_min,
                t_max,
            }),
            chain: SpecularChain::of_camera(&accel.view),
            past: Past {
                depth: 0,
                fields: self.of_camera,
            },
        }
    }

    /// The film point at these fractions of the whole film.
    pub(crate) fn film_point(&self, place: [f64; 2]) -> [f64; 2] {
        let size = self.tracer.accel.scene.film.size;
        [0, 1].map(|axis| place[axis] * f64::from(size[axis]))
    }

    /// The point of the film at which a point in world space would be seen, if it is on the film.
    pub(crate) fn film_point_of(&self, view: &View<f64>, point: Vec3) -> Option<[f64; 2]> {
        let film = view.film(view.towards(point));
        let is_inside = self.is_on_film(film) && view.depth(point) > 0.0;
        is_inside.then_some(film)
    }

    /// True if the film has this point.
    pub(crate) fn is_on_film(&self, film: [f64; 2]) -> bool {
        let size = self.tracer.accel.scene.film.size;
        [0, 1]
            .into_iter()
            .all(|axis| (0.0..=f64::from(size[axis])).contains(&film[axis]))
    }

    /// A direction from a vertex to a point on a mirror.
    pub(crate) fn aim(&self, vertex: &Vertex<f64>, random: &mut Random) -> Option<Vec3> {
        let point = self.point_on_any(&self.mirrors, random)?;
        let offset = point - vertex.position;
        let direction = offset / offset.length();
        direction.is_finite().then_some(direction)
    }

    /// A random point on a mirror.
    pub(crate) fn point_on_mirror(&self, random: &mut Random) -> Option<Vec3> {
        self.point_on_any(&self.mirrors, random)
    }

    /// A point on a surface that moves.
    pub(crate) fn point_that_moves(&self, random: &mut Random) -> Option<Vec3> {
        self.point_on_any(&self.moving, random)
    }

    fn point_on_any(&self, shapes: &[Range<u32>], random: &mut Random) -> Option<Vec3> {
        if shapes.is_empty() {
            return None;
        }
        let shape = random.below(shapes.len());
        Some(self.point_on(&shapes[shape], random))
    }

    /// A point on one of these faces; each is as likely as another.
    fn point_on(&self, faces: &Range<u32>, random: &mut Random) -> Vec3 {
        let face = faces.start as usize + random.below(faces.len());
        let [a, b, c] = self.tracer.accel.mesh.corners(face);
        let [u, v] = random.pair();
        let root = u.sqrt();
        a * (1.0 - root) + b * (root * (1.0 - v)) + c * (root * v)
    }
}

/// How many rules there are by which chains of specular events are followed, and how many events in a
/// row they say something of, over and over.
pub(crate) const RULES: usize = 1 << RULE_BITS;
const RULE_BITS: u32 = 3;

/// True if paths may meet more specular events in a row than silhouettes are covered behind: if they
/// are long enough, and mirrors can face each other or several panes follow one another.
fn has_long_chains(tracer: &Tracer) -> bool {
    let accel = tracer.accel;
    let scene = &accel.scene;
    let shapes = scene.shapes.iter();
    let panes = shapes.filter(|shape| flat_events(scene, shape).contains(Event::Pass));
    let panes: usize = panes.map(|shape| shape.mesh.faces.len()).sum();
    let mirrors = accel.mirror_planes().map(|planes| planes.count());
    tracer.plan.reaches(MAX_EVENTS + 2)
        && (mirrors.is_none_or(|count| count > 1) || panes > FACES_OF_A_PANE)
}

/// Faces of a pane: one before a mirror makes no more than five events in a row.
const FACES_OF_A_PANE: usize = 2;
