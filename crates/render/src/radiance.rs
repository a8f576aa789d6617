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

use capwalk_boundary::{Draw, FlatEvents, MAX_EVENTS, Viewpoint, bounded_ray};
use capwalk_geometry::Hit;
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::emitter::delta::DeltaLight;
use capwalk_scene::lobe::{Event, Specular};
use capwalk_scene::sensor::view::{View, ViewRay};
use capwalk_scene::{Emitter, EmitterId};

use crate::aov::aov_at;
use crate::emitter_edge_term::emitter_edge_term;
use crate::half_vector::{Following, along};
use crate::light::{Continuation, emitter_towards, sample_lights};
use crate::plan::LightSampling;
use crate::sampled_edges::ShadingPoint;
use crate::scene_eval::SceneEval;
use crate::shading::{add_lobes, black_vertex_at};
use crate::surface::{emitted_at, irradiance_of, surface_at};
use crate::tracer::{Moving, Tracer};
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

    /// True if the field does not have the silhouettes behind them.
    pub(crate) fn is_missed(&self) -> bool {
        self.count.is_none()
    }

    /// This chain with one event more, at this place.
    pub(crate) fn followed_by(self, event: Event) -> Self {
        let count = self.after(event);
        Self { count, ..self }
    }

    /// Their number with one more, if the field has the silhouettes behind it.
    fn after(&self, event: Event) -> Option<u32> {
        let is_missed = self.is_parallel && event == Event::Reflect;
        let has = self.here.contains(event) && !is_missed;
        let count = self.count.filter(|_| has)?;
        (count < MAX_EVENTS).then_some(count + 1)
    }
}

/// Which light a path brings, by the specular events since its direction was chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shown {
    /// All of it.
    #[default]
    All,
    /// That behind events whose silhouettes are in the fields of viewpoints, or that are gathered.
    Covered,
    /// The other light, after so many events.
    After(u32),
}

impl Shown {
    /// True for light that arrives after so many events, of which some are missed.
    fn has(self, events: u32, is_missed: bool) -> bool {
        match self {
            Self::All => true,
            Self::Covered => !is_missed,
            Self::After(count) => is_missed && count == events,
        }
    }

    /// True if there may be some after more events than these.
    fn goes_on(self, events: u32, is_missed: bool) -> bool {
        match self {
            Self::All => true,
            Self::Covered => !is_missed,
            Self::After(count) => events <= count,
        }
    }
}

/// How a path arrived at a vertex, since its direction was chosen.
#[derive(Clone, Copy, Debug, Default)]
pub struct Arrival {
    shown: Shown,
    events: u32,
    is_missed: bool,
}

impl Arrival {
    /// True if light that is scattered there counts.
    fn is_shown(&self) -> bool {
        self.shown.has(self.events, self.is_missed)
    }

    /// True if light that arrives there by an event counts, or without one.
    fn is_after(&self, event: Option<Specular>, is_missed: impl FnOnce(Specular) -> bool) -> bool {
        event.map_or(self.is_shown(), |event| {
            (self.shown).has(self.events + 1, self.is_missed || is_missed(event))
        })
    }
}

/// Light from emitters that a surface reflects.
pub struct Emitted<R> {
    /// All of it.
    pub light: Rgb<R>,
    /// Where a path could go on.
    pub next: Option<Continuation>,
}

impl Tracer<'_> {
    /// A sample of the radiance that arrives along a moving camera ray.
    pub(crate) fn radiance<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        ray: ViewRay<R>,
        shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        let (accel, plan) = (self.accel, &self.plan);
        let ViewRay {
            origin, direction, ..
        } = ray;
        let hit = self.first_hit(&ray.value());
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
            && shown.has(0, false)
            && let Some(emitter) = emitter_towards(accel, hit.as_ref(), direction.value())
        {
            light += emitted_at(eval, accel, emitter, hit.as_ref(), origin, direction);
        }
        let chain = SpecularChain::of_camera(&accel.view);
        light + self.reflected(eval, [origin, direction], hit, 0, chain, shown, draw)
    }

    /// What the camera sees first along a ray, between its clip planes.
    pub(crate) fn first_hit(&self, ray: &ViewRay<f64>) -> Option<Hit> {
        self.accel.first_hit_within(&bounded_ray(ray))
    }

    /// The vertex of a path of number `depth`, where a ray hits a surface that scatters light, if paths so long are
    /// sampled; the chain arrives there.
    pub(crate) fn path_vertex<R: Real, W: SceneEval<R>>(
        &self,
        eval: &W,
        ray: [Vec3<R>; 2],
        hit: Option<Hit>,
        depth: u32,
        chain: &mut SpecularChain,
    ) -> Option<Vertex<R>> {
        let hit = hit.filter(|_| self.plan.reaches(depth + 2))?;
        let surface = surface_at(eval, self.accel, &hit, ray[0], ray[1]);
        let mut vertex = black_vertex_at(&surface, ray[1]);
        if !add_lobes(eval, self.accel, &surface, &mut vertex) {
            return None;
        }
        *chain = chain.at(self.accel.flat_events(&hit));
        Some(vertex)
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
        mut shown: Shown,
        draw: Draw,
    ) -> Rgb<R> {
        let plan = &self.plan;
        // Specular events since the direction was chosen.
        let mut events = 0;
        // Radiance collected so far.
        let mut light = Rgb::zero();
        // The product of BSDFs, cosines and Jacobians over the density of the path so far.
        let mut throughput = Rgb::constant(Rgb::splat(1.0));
        // True behind a specular event with silhouettes that no field has.
        let mut is_missed = false;
        for depth in first.. {
            let Some(vertex) = self.path_vertex(eval, ray, hit, depth, &mut chain) else {
                break;
            };
            let arrival = Arrival {
                shown,
                events,
                is_missed,
            };
            // Light that comes from emitters, and a direction in which the path can go on.
            let Emitted {
                light: emitted,
                next,
            } = self.emitted(eval, &vertex, ray, depth, chain, arrival, draw);
            light += throughput * emitted;
            // What moves across directions towards other surfaces, if those stay.
            let stays = W::MOVES && self.gathers.indirect;
            let is_shown = arrival.is_shown();
            if stays && plan.reaches(depth + 3) && is_shown {
                light += throughput * self.indirect_edge_term(eval, &vertex, depth, draw);
            }
            let Some(next) = next.filter(|_| plan.reaches(depth + 3)) else {
                break;
            };
            // A path ends where all that it may bring is behind it.
            let over_density = R::constant(1.0 / next.pdf);
            let is_smooth = next.specular.is_none();
            if is_smooth && !is_shown {
                break;
            }
            // Light that arrives from another surface by a chain has a field of its own.
            if is_smooth && self.walks_chains(eval) {
                let after = self.chained(eval, &vertex, next.direction, next.hit, depth, draw);
                light += throughput * (after * over_density);
                shown = Shown::Covered;
            } else if is_smooth {
                shown = Shown::All;
            }
            ray = match next.specular {
                None => {
                    // Light from another surface: the direction moves along the field around
                    // this one, and the path is multiplied by `1 + div u` (Algorithm 1).
                    let viewpoint = Viewpoint::towards_surfaces(
                        vertex.position,
                        vertex.face_normal,
                        self.events_behind(depth + 1),
                    );
                    let warped = match stays {
                        true => {
                            let following = self.following(eval, &vertex, &viewpoint);
                            along(next.direction, following)
                        }
                        false => {
                            let walk = self.vertex_walk(depth, 1, draw);
                            self.warp(eval, &viewpoint, next.direction, walk)
                        }
                    };
                    let f = vertex.eval(warped.direction);
                    throughput = throughput * (f * (warped.jacobian * over_density));
                    (chain, events, is_missed) = (SpecularChain::default(), 0, false);
                    [vertex.position, warped.direction]
                }
                Some(event) => {
                    // A specular direction moves as its event says; it has no field of its own
                    // (METHOD 6).
                    let (after, fraction) = vertex.specular(event, ray);
                    throughput = throughput * (fraction * over_density);
                    is_missed |= self.misses(chain, event);
                    chain = chain.followed_by(event.event);
                    events += 1;
                    after
                }
            };
            if !shown.goes_on(events, is_missed) {
                break;
            }
            // Nothing more can come; a derivative still can.
            if !W::MOVES && throughput == Rgb::zero() {
                break;
            }
            let Some(weight) = self.roulette(eval, throughput.value(), depth, draw) else {
                break;
            };
            throughput = throughput * R::constant(weight);
            hit = next.hit;
        }
        light
    }

    /// Roulette ends long paths at random after the vertex of number `depth`, by their throughput without derivative;
    /// what the others are multiplied by.
    pub(crate) fn roulette<R: Real, W: SceneEval<R>>(
        &self,
        _: &W,
        throughput: Rgb,
        depth: u32,
        draw: Draw,
    ) -> Option<f64> {
        let next = depth + 1;
        if next < self.plan.rr_depth {
            return Some(1.0);
        }
        let least = if W::MOVES { RR_MIN } else { 0.0 };
        let survival = throughput.max_component().clamp(least, RR_MAX);
        let last = self.plan.vertex_numbers(next) - 1;
        (draw.stream.number(last) < survival).then(|| 1.0 / survival)
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
        chain.after(event.event).is_none()
    }

    /// How light is sampled at a vertex: with chains, by one direction from the material, whose events are those
    /// that the path goes on by.
    fn sampling(&self) -> LightSampling {
        let sampling = self.plan.sampling;
        match self.has_chains {
            true => LightSampling {
                bsdf_samples: 1,
                ..sampling
            },
            false => sampling,
        }
    }

    /// True if light that arrives by chains of specular events is walked along them.
    pub(crate) fn walks_chains<R: Real, W: SceneEval<R>>(&self, _: &W) -> bool {
        W::MOVES && self.has_chains
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
        arrival: Arrival,
        draw: Draw,
    ) -> Emitted<R> {
        let mut light = Rgb::zero();
        let viewpoint = Viewpoint::towards_emitters(vertex.position, vertex.face_normal);
        let primal = eval.primal(vertex);
        let next = sample_lights(
            self.accel,
            self.emitters,
            &primal,
            self.sampling(),
            draw.stream,
            self.plan.vertex_numbers(depth),
            self.plan.reaches(depth + 3),
            |i, sample| {
                if !arrival.is_after(sample.specular, |event| self.misses(chain, event)) {
                    return;
                }
                let weight = R::constant(sample.weight);
                let radiance = |[origin, direction]: [Vec3<R>; 2]| {
                    let hit = sample.hit.as_ref();
                    emitted_at(eval, self.accel, sample.emitter, hit, origin, direction)
                };
                // A specular direction: what emits there, seen by the event.
                if let Some(event) = sample.specular {
                    let (ray, fraction) = vertex.specular(event, incoming);
                    light += fraction * radiance(ray) * weight;
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
                        let walk = self.vertex_walk(depth, 2 + i, draw);
                        self.warp(eval, &viewpoint, sample.direction, walk)
                    }
                };
                let f = vertex.eval(warped.direction);
                let ray = [vertex.position, warped.direction];
                light += f * radiance(ray) * (warped.jacobian * weight);
            },
        );
        if W::MOVES
            && arrival.is_shown()
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
                let walk = self.vertex_walk(depth, 0, draw);
                let warped = |q| self.warp_value(eval, &viewpoint, q, walk);
                let (boundaries, walks) = (field.boundaries, |id| !self.gathers(id));
                light += emitter_edge_term(
                    self.accel, boundaries, eval, &viewpoint, &primal, u, warped, walks,
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
        Emitted { light, next }
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
