//! One path tracer for the primal image and its derivatives.
//!
//! A pixel is an integral over paths. With the [`Primal`](crate::Primal) scene a sample of it is
//! its value; with one that carries derivatives, every sampled direction moves
//! with the velocity field around the point that it starts from, and the same
//! code gives the integrand's derivative along the moved path (Algorithm 1).
//! With `u` the field around the camera and `L` the radiance along the moved
//! camera ray (METHOD 1 and 4)
//!
//! ```text
//! ∫ [ d/dε (W L / J)(moved) + (W L / J) div u ] dω  -  ∮ W L ṡ·n dl
//! ```
//!
//! where `W / J` is the filter times film area per solid angle, and the border term
//! is taken where the filter ends without being zero, `ṡ` the film velocity of
//! the moved direction. `L` itself is such an integral, over the directions
//! from the surface, once for light that comes from emitters and once for
//! light that comes from other surfaces.
//!
//! Sampling, weights and roulette are detached: they see the primal scene.

use capwalk_boundary::{Draw, FlatEvents, MAX_EVENTS, Viewpoint};
use capwalk_geometry::{Hit, Ray};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::emitter::delta::DeltaLight;
use capwalk_scene::lobe::{Event, Specular};
use capwalk_scene::sensor::view::{View, ViewRay};
use capwalk_scene::{Emitter, EmitterId};

use crate::aov::aov_at;
use crate::emitter_edge_term::emitter_edge_term;
use crate::half_vector::{Following, along};
use crate::light::{Continuation, emitter_towards, sample_lights};
use crate::sampled_edges::ShadingPoint;
use crate::scene_eval::SceneEval;
use crate::shading::{add_lobes, black_vertex_at};
use crate::surface::{emitted_at, irradiance_of, surface_at};
use crate::tracer::{LeavesOut, Moving, Tracer};
use crate::vertex::Vertex;

/// Largest probability that a path survives roulette.
pub const RR_MAX: f64 = 0.95;
/// Smallest one for derivatives: a path that carries no light may carry a
/// derivative, such as that of a black material's reflectance.
pub const RR_MIN: f64 = 0.05;

/// The specular events since a direction was warped along a field.
#[derive(Clone, Copy, Debug)]
pub struct SpecularChain {
    /// How many, if the field has the silhouettes that are seen behind them.
    count: Option<u32>,
    /// After which further ones at this place it has them, too.
    here: FlatEvents,
    /// True for fields in image space, which have no images in mirrors.
    is_parallel: bool,
}

impl Default for SpecularChain {
    fn default() -> Self {
        Self {
            count: Some(0),
            here: FlatEvents::default(),
            is_parallel: false,
        }
    }
}

impl SpecularChain {
    /// None, before the camera.
    pub(crate) fn of_camera(view: &View<f64>) -> Self {
        Self {
            is_parallel: view.is_parallel(),
            ..Self::default()
        }
    }

    /// This chain at a surface with these events.
    pub(crate) fn at(self, here: FlatEvents) -> Self {
        Self { here, ..self }
    }

    /// This chain with one event more, at this place.
    pub(crate) fn followed_by(self, event: Event) -> Self {
        let count = self.after(event);
        Self { count, ..self }
    }

    /// True if the field does not have the silhouettes behind them.
    pub(crate) fn is_missed(&self) -> bool {
        self.count.is_none()
    }

    /// Their number with one more, if the field has the silhouettes behind it.
    fn after(&self, event: Event) -> Option<u32> {
        let is_missed = self.is_parallel && event == Event::Reflect;
        let has = self.here.contains(event) && !is_missed;
        let count = self.count.filter(|_| has)?;
        (count < MAX_EVENTS).then_some(count + 1)
    }
}

/// Light from emitters that a surface reflects.
pub struct Emitted<R> {
    /// All of it.
    pub light: Rgb<R>,
    /// What arrives by a specular event with silhouettes that no field has; not part of it if
    /// that is left out.
    pub missed: Rgb,
    /// Where a path could go on.
    pub next: Option<Continuation>,
}

impl Tracer<'_> {
    /// A sample of the radiance that arrives along a moving camera ray.
    pub(crate) fn radiance<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        ray: ViewRay<R>,
        draw: Draw,
    ) -> Rgb<R> {
        let (accel, plan) = (self.accel, &self.plan);
        let ViewRay {
            origin,
            direction,
            range: [t_min, t_max],
        } = ray;
        // What the camera sees first, between its clip planes.
        let hit = accel.first_hit_within(&Ray {
            origin: origin.value(),
            direction: direction.value(),
            t_min,
            t_max,
        });
        // An image of something else than light ends there.
        if let Some(aov) = plan.aov {
            return hit.map_or(Rgb::zero(), |hit| {
                let surface = surface_at(eval, accel, &hit, origin, direction);
                aov_at(eval, accel, aov, &surface, origin, direction)
            });
        }
        // Paths of one segment end at what emits, others go on.
        let mut light = Rgb::zero();
        if plan.reaches(1)
            && !plan.hide_emitters
            && let Some(emitter) = emitter_towards(accel, hit.as_ref(), direction.value())
        {
            light += emitted_at(eval, accel, emitter, hit.as_ref(), origin, direction);
        }
        let chain = SpecularChain::of_camera(&accel.view);
        light + self.reflected(eval, [origin, direction], hit, 0, chain, draw)
    }

    /// A sample of the radiance that comes back along a moving ray, given by its origin and its
    /// direction, from the surface that it hits, the vertex of a path of number `first`, less what
    /// that emits. `chain` are the specular events since the direction was last warped.
    pub(crate) fn reflected<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        mut ray: [Vec3<R>; 2],
        mut hit: Option<Hit>,
        first: u32,
        mut chain: SpecularChain,
        draw: Draw,
    ) -> Rgb<R> {
        let (accel, plan) = (self.accel, &self.plan);
        // Radiance collected so far.
        let mut light = Rgb::zero();
        // The product of BSDFs, cosines and Jacobians over the density of the path so far.
        let mut throughput = Rgb::constant(Rgb::splat(1.0));
        // True behind a specular event with silhouettes that no field has.
        let mut is_missed = false;
        for depth in first.. {
            // The path goes on from a surface that is hit, if paths so long are sampled.
            let Some(found) = hit.filter(|_| plan.reaches(depth + 2)) else {
                break;
            };
            let surface = surface_at(eval, accel, &found, ray[0], ray[1]);
            let mut vertex = black_vertex_at(&surface, ray[1]);
            if !add_lobes(eval, accel, &surface, &mut vertex) {
                break;
            }
            chain = chain.at(accel.flat_events(&found));
            // Light that comes from emitters, and a direction in which the path can go on.
            let Emitted {
                light: emitted,
                missed,
                next,
            } = self.emitted(eval, &vertex, ray, depth, chain, draw);
            let is_left_out = is_missed && self.leaves_out != LeavesOut::Nothing;
            if !is_left_out {
                light += throughput * emitted;
            }
            if W::MOVES {
                let missed = if is_missed { emitted.value() } else { missed };
                draw.add_missing(throughput.value() * missed);
            }
            // What moves across directions towards other surfaces, if those stay.
            let stays = W::MOVES && self.gathers.indirect;
            if stays && plan.reaches(depth + 3) && !is_left_out {
                light += throughput * self.indirect_edge_term(eval, &vertex, depth, draw);
            }
            let Some(next) = next.filter(|_| plan.reaches(depth + 3)) else {
                break;
            };
            let over_density = R::constant(1.0 / next.pdf);
            ray = match next.specular {
                None => {
                    // Light from another surface: the direction moves along the field around
                    // this one, and the path is multiplied by `1 + div u` (Algorithm 1).
                    let events = self.events_behind(depth + 1);
                    let viewpoint =
                        Viewpoint::towards_surfaces(vertex.position, vertex.face_normal, events);
                    let warped = match stays {
                        true => {
                            let following = self.following(eval, &vertex, &viewpoint);
                            along(next.direction, following)
                        }
                        false => {
                            let (walk, numbers) = self.vertex_walk(depth, 1, draw);
                            eval.warp(&viewpoint, next.direction, walk, numbers)
                        }
                    };
                    let f = vertex.eval(warped.direction);
                    throughput = throughput * (f * (warped.jacobian * over_density));
                    chain = SpecularChain::default();
                    [vertex.position, warped.direction]
                }
                Some(event) => {
                    // A specular direction moves as its event says; it has no field of its own
                    // (METHOD 6).
                    let (after, fraction) = vertex.specular(event, ray);
                    throughput = throughput * (fraction * over_density);
                    is_missed |= self.misses(chain, event);
                    chain = chain.followed_by(event.event);
                    after
                }
            };
            // Nothing more can come; a derivative still can.
            if !W::MOVES && throughput == Rgb::zero() {
                break;
            }
            // Roulette ends long paths at random, by their throughput without derivative.
            if depth + 1 >= plan.rr_depth {
                let least = if W::MOVES { RR_MIN } else { 0.0 };
                let survival = throughput.value().max_component().clamp(least, RR_MAX);
                let last = plan.vertex_numbers(depth + 1) - 1;
                if draw.stream.number(last) >= survival {
                    break;
                }
                throughput = throughput * R::constant(1.0 / survival);
            }
            hit = next.hit;
        }
        light
    }

    /// What a point that stays receives from an emitter without extent; `None` from another one.
    pub fn irradiance<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        emitter: EmitterId,
        position: Vec3,
    ) -> Option<Rgb<R>> {
        let light = self.delta_light(eval, emitter, Vec3::constant(position))?;
        Some(irradiance_of(
            eval,
            self.accel.scene.emitter(emitter),
            &light,
        ))
    }

    /// The light of an emitter without extent that reaches a point.
    fn delta_light<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        id: EmitterId,
        point: Vec3<R>,
    ) -> Option<DeltaLight<R>> {
        let first = self.accel.anchor(id);
        let anchor = |i: usize| eval.boundary_point(first + i as u32);
        let number = |id| eval.texel(id, 0).r;
        let emitter = self.accel.scene.emitter(id);
        emitter.delta_light(point, anchor, number)
    }

    /// True if no field has the silhouettes that are seen by a specular event.
    pub(crate) fn misses(&self, chain: SpecularChain, event: Specular) -> bool {
        chain.after(event.event).is_none() || self.misses_mirrors()
    }

    /// True if silhouettes or edges of hard shadows that a ray shows after a specular event may
    /// move against it.
    pub(crate) fn moves_behind<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        ray: &[Vec3<R>; 2],
        hit: &Option<Hit>,
    ) -> bool {
        let ray_moves = ray.iter().any(|v| !v.is_constant());
        let surface_moves = || {
            let corners = hit.map(|hit| self.accel.mesh.faces[hit.face as usize]);
            let mut corners = corners.into_iter().flatten();
            corners.any(|i| !eval.vertex(i).is_constant())
        };
        // A shadow moves with its light and with what throws it, also on a face that does not move.
        let shadow_moves = || hit.is_some_and(|hit| self.shadow_moves(eval, hit.face));
        W::MOVES && (ray_moves || surface_moves() || shadow_moves())
    }

    /// Light that arrives from emitters at a moving surface point, to which the ray `incoming`
    /// led, and is reflected there.
    pub fn emitted<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        vertex: &Vertex<R>,
        incoming: [Vec3<R>; 2],
        depth: u32,
        chain: SpecularChain,
        draw: Draw,
    ) -> Emitted<R> {
        let mut light = Rgb::zero();
        let mut missed = Rgb::zero();
        let viewpoint = Viewpoint::towards_emitters(vertex.position, vertex.face_normal);
        let primal = eval.primal(vertex);
        let next = sample_lights(
            self.accel,
            self.emitters,
            &primal,
            self.plan.sampling,
            draw.stream,
            self.plan.vertex_numbers(depth),
            self.plan.reaches(depth + 3),
            |i, sample| {
                let weight = R::constant(sample.weight);
                let radiance = |[origin, direction]: [Vec3<R>; 2]| {
                    let hit = sample.hit.as_ref();
                    emitted_at(eval, self.accel, sample.emitter, hit, origin, direction)
                };
                // A specular direction: what emits there, seen by the event.
                if let Some(event) = sample.specular {
                    let (ray, fraction) = vertex.specular(event, incoming);
                    let seen = fraction * radiance(ray) * weight;
                    let is_missed = self.misses(chain, event);
                    if is_missed {
                        missed += seen.value();
                    }
                    if !is_missed || self.leaves_out == LeavesOut::Nothing {
                        light += seen;
                    }
                    return;
                }
                // An emitter without extent is seen in one direction, wherever that moves.
                let emitter = self.accel.scene.emitter(sample.emitter);
                let delta = self.delta_light(eval, sample.emitter, vertex.position);
                if let Some(delta) = delta {
                    let f = vertex.eval(delta.direction);
                    light += f * irradiance_of(eval, emitter, &delta) * weight;
                    return;
                }
                // Any other direction moves along the field around this point, unless edges
                // before the emitter are gathered.
                let warped = match self.gathers(sample.emitter) {
                    true => {
                        let following =
                            self.following_before(eval, vertex, &viewpoint, sample.emitter);
                        along(sample.direction, following)
                    }
                    false => {
                        let (walk, numbers) = self.vertex_walk(depth, 2 + i, draw);
                        eval.warp(&viewpoint, sample.direction, walk, numbers)
                    }
                };
                let f = vertex.eval(warped.direction);
                let ray = [vertex.position, warped.direction];
                light += f * radiance(ray) * (warped.jacobian * weight);
            },
            |event, hit| {
                if W::MOVES && self.misses(chain, event) {
                    let (ray, fraction) = vertex.specular(event, incoming);
                    // Events are drawn that are black, because their colours may have derivatives.
                    let is_black = fraction.value() == Rgb::zero();
                    draw.count_uncovered(!is_black && self.moves_behind(eval, &ray, hit));
                }
            },
        );
        if W::MOVES
            && self.plan.sampling.dimensions() > 0
            && primal.bsdf.has_smooth()
            && let Some(Moving { field, .. }) = &self.moving
            && field.method.traits().is_spherical
        {
            let gathers = self.gathers;
            let environment = self.accel.scene.environment();
            if !gathers.emitters || (environment.is_some() && !gathers.environment) {
                // What the field moves across the edges of emitters (METHOD 3).
                let u = draw.stream.number(self.emitter_edge_number(depth));
                let (walk, numbers) = self.vertex_walk(depth, 0, draw);
                let (boundaries, walks) = (field.boundaries, |id| !self.gathers(id));
                light += emitter_edge_term(
                    self.accel, boundaries, eval, &viewpoint, &primal, u, walk, numbers, walks,
                );
            }
            // What moves across directions that stay, or turn (METHOD 8).
            let at = ShadingPoint {
                field,
                eval,
                viewpoint: &viewpoint,
                vertex: &primal,
                following: None,
                in_mirrors: None,
            };
            if gathers.emitters {
                light += self.emitters_edge_term(&at, vertex, draw, depth);
            }
            if gathers.environment
                && let Some(environment) = environment
            {
                let following = self.following_before(eval, vertex, &viewpoint, environment);
                let at = ShadingPoint { following, ..at };
                light += self.environment_edge_term(&at, environment, draw, depth);
            }
        }
        Emitted {
            light,
            missed,
            next,
        }
    }

    /// What directions towards an emitter follow: only light that is the same
    /// everywhere is not noisier by it. Their density vanishes at the horizon, so there they
    /// must follow it, or the derivative of the cosine over that density has no bound.
    pub(crate) fn following_before<'v, R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        vertex: &'v Vertex<R>,
        viewpoint: &Viewpoint<R>,
        emitter: EmitterId,
    ) -> Option<Following<'v, R>> {
        let scene = &self.accel.scene;
        let Some(Moving { field, .. }) = &self.moving else {
            return None;
        };
        match scene.emitter(emitter) {
            Emitter::Constant { .. } => self.following(eval, vertex, viewpoint),
            _ if eval.is_still(viewpoint) || !self.gathers.half_vector => None,
            _ => {
                let mut areas = field.boundaries.area_emitters.iter();
                let area = areas.find(|area| area.emitter == emitter)?;
                Following::of_facets(vertex, area.tan2(vertex.position.value()))
            }
        }
    }

    /// What directions follow that do not move along a field with boundaries. Where no boundary
    /// moves, none is sampled, and they stay.
    pub(crate) fn following<'v, R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        vertex: &'v Vertex<R>,
        viewpoint: &Viewpoint<R>,
    ) -> Option<Following<'v, R>> {
        let moves = W::MOVES && !eval.is_still(viewpoint);
        moves.then(|| match self.gathers.half_vector {
            true => Following::of(vertex),
            false => Following::normal_of(vertex),
        })
    }
}
