//! One path tracer for the picture and its derivatives.
//!
//! A pixel is an integral over paths. With a [`World`] at rest a sample of it is
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
//! where `W / J` is the filter times film area per solid angle, and the flux
//! is taken where the filter ends without being zero, `ṡ` the film velocity of
//! the moved direction. `L` itself is such an integral, over the directions
//! from the surface, once for light that comes from emitters and once for
//! light that comes from other surfaces.
//!
//! Sampling, weights and roulette see the scene at rest.

mod film;
mod outline;

use capwalk_geometry::{Hit, Ray};
use capwalk_math::{Real, Rgb, Vec3};
use capwalk_scene::lobe::Event;
use capwalk_scene::sensor::view::ViewRay;
use capwalk_scene::{Emitter, EmitterId};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::diff::boundary::{Draw, Eye, Field, Numbers};
use crate::diff::edge_flux::{self, lamp_outline_flux};
use crate::diff::flux::lamp_edge_flux;
use crate::diff::unfold::MAX_EVENTS;
use crate::layer::layer_at;
use crate::light::{Continuation, emitter_towards, sample_lights};
use crate::material::{FlatEvents, vertex_at};
use crate::options::Method;
use crate::pixel::Supports;
use crate::plan::Plan;
use crate::vertex::Vertex;
use crate::world::{Carried, World, emitted_at, surface_at};

use film::camera_angle;
use outline::Outlines;

/// Largest probability that a path survives roulette.
const RR_MAX: f64 = 0.95;
/// Smallest one for derivatives: a path that carries no light may carry a
/// derivative, such as that of a black material's reflectance.
const RR_MIN: f64 = 0.05;

/// The numbers of gathered edges start here, behind all others: those of the
/// camera, then of each vertex.
const EDGE_NUMBERS: u32 = 1 << 30;

/// How directions are carried.
#[derive(Clone, Copy, Debug)]
pub struct Walks {
    /// On the film.
    pub camera: WalkSettings,
    /// Around surface points.
    pub surface: WalkSettings,
}

/// Samples pixels of a scene.
pub struct Tracer<'a> {
    /// The scene.
    pub accel: &'a Accel<'a>,
    supports: Supports,
    plan: Plan,
    /// The boundaries, and how directions move among them; not needed at rest.
    pub moving: Option<(&'a Field<'a>, Walks)>,
    /// The edges in each pixel, where the camera's rays all start from one point.
    outlines: Outlines,
}

/// The specular events since a direction was carried along a field.
#[derive(Clone, Copy, Debug)]
pub struct SpecularChain {
    /// How many, if the field has the outlines that are seen behind them.
    count: Option<u32>,
    /// After which further ones at this place it has them, too.
    here: FlatEvents,
    /// True for fields in picture space, which have no images in mirrors.
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
    /// Their number with one more, if the field has the outlines behind it.
    fn after(&self, event: Event) -> Option<u32> {
        let is_missed = self.is_parallel && event == Event::Reflect;
        let has = self.here.contains(event) && !is_missed;
        let count = self.count.filter(|_| has)?;
        (count < MAX_EVENTS).then_some(count + 1)
    }
}

impl<'a> Tracer<'a> {
    /// A tracer of the picture alone.
    pub fn at_rest(accel: &'a Accel<'a>) -> Self {
        Self {
            accel,
            supports: Supports::new(&accel.scene.film),
            plan: Plan::new(accel.scene),
            moving: None,
            outlines: Outlines::default(),
        }
    }

    /// A tracer of derivatives, too, with the given walk around surfaces.
    pub fn moving(accel: &'a Accel<'a>, field: &'a Field<'a>, surface: WalkSettings) -> Self {
        let camera = WalkSettings {
            max_radius: surface.max_radius.min(camera_angle(accel)),
            ..surface
        };
        Self {
            moving: Some((field, Walks { camera, surface })),
            outlines: Outlines::of(accel.scene),
            ..Self::at_rest(accel)
        }
    }

    /// The same with another plan.
    pub fn with_plan(self, plan: Plan) -> Self {
        Self { plan, ..self }
    }

    /// Most specular events behind which edges count.
    fn events_behind(&self, segments: u32) -> u32 {
        match self.accel.has_flat_events() {
            true => self.plan.events_behind(segments),
            false => 0,
        }
    }

    /// A sample of the radiance that arrives along a moving camera ray.
    fn radiance<R: Real, W: World<R>>(&self, world: &W, ray: ViewRay<R>, draw: Draw) -> Rgb<R> {
        let (accel, plan) = (self.accel, &self.plan);
        let ViewRay {
            mut origin,
            mut direction,
            range: [t_min, t_max],
        } = ray;
        let mut hit = accel.first_hit_within(&Ray {
            origin: origin.value(),
            direction: direction.value(),
            t_min,
            t_max,
        });
        if let Some(layer) = plan.layer {
            return hit.map_or(Rgb::zero(), |hit| {
                let surface = surface_at(world, accel, &hit, origin, direction);
                layer_at(world, accel, layer, &surface, origin, direction)
            });
        }
        let mut light = Rgb::zero();
        if plan.reaches(1)
            && !plan.hide_emitters
            && let Some(emitter) = emitter_towards(accel, hit.as_ref(), direction.value())
        {
            light += emitted_at(world, accel, emitter, hit.as_ref(), origin, direction);
        }
        let mut throughput = Rgb::constant(Rgb::splat(1.0)); // over its density
        let mut chain = SpecularChain {
            is_parallel: accel.view.is_parallel(),
            ..SpecularChain::default()
        };
        for depth in 0.. {
            let Some(found) = hit.filter(|_| plan.reaches(depth + 2)) else {
                break;
            };
            let surface = surface_at(world, accel, &found, origin, direction);
            let Some(vertex) = vertex_at(world, accel, &surface, direction) else {
                break;
            };
            chain.here = accel.flat_events(&found);
            let (emitted, next) = self.emitted(world, &vertex, depth, chain, draw);
            light += throughput.hadamard(emitted);
            let Some(next) = next.filter(|_| plan.reaches(depth + 3)) else {
                break;
            };
            let over_density = R::constant(1.0 / next.pdf);
            direction = match next.specular {
                None => {
                    // Light from another surface, along the field around this one.
                    let events = self.events_behind(depth + 1);
                    let eye = Eye::towards_surfaces(vertex.position, vertex.face_normal, events);
                    let (walk, numbers) = self.vertex_walk(depth, 1, draw);
                    let carried = world.carry(&eye, next.direction, walk, numbers);
                    let f = vertex.eval(carried.direction);
                    throughput = throughput.hadamard(f * (carried.stretch * over_density));
                    chain = SpecularChain::default();
                    carried.direction
                }
                Some(event) => {
                    let (wo, fraction) = vertex.specular(event);
                    throughput = throughput.hadamard(fraction * over_density);
                    chain.count = chain.after(event.event);
                    wo
                }
            };
            if !W::MOVES && throughput == Rgb::zero() {
                break;
            }
            if depth + 1 >= plan.rr_depth {
                let least = if W::MOVES { RR_MIN } else { 0.0 };
                let survival = throughput.value().max_component().clamp(least, RR_MAX);
                let last = plan.vertex_numbers(depth + 1) - 1;
                if draw.stream.number(last) >= survival {
                    break;
                }
                throughput = throughput * R::constant(1.0 / survival);
            }
            origin = vertex.position;
            hit = next.hit;
        }
        light
    }

    /// Counts a ray after a specular event that bends light if outlines seen there
    /// can move against it: they bound no field.
    fn count_uncovered<R: Real, W: World<R>>(
        &self,
        world: &W,
        origin: Vec3<R>,
        direction: Vec3<R>,
        hit: &Option<Hit>,
        draw: Draw,
    ) {
        let ray_moves = !origin.is_constant() || !direction.is_constant();
        let surface_moves = || {
            let corners = hit.map(|hit| self.accel.mesh.faces[hit.face as usize]);
            let mut corners = corners.into_iter().flatten();
            corners.any(|i| !world.vertex(i).is_constant())
        };
        if ray_moves || surface_moves() {
            let uncovered = &draw.counts.uncovered;
            uncovered.set(uncovered.get() + 1);
        }
    }

    /// Light that arrives from emitters at a moving surface point and is
    /// reflected there, and where a path could go on.
    pub fn emitted<R: Real, W: World<R>>(
        &self,
        world: &W,
        vertex: &Vertex<R>,
        depth: u32,
        chain: SpecularChain,
        draw: Draw,
    ) -> (Rgb<R>, Option<Continuation>) {
        let mut light = Rgb::zero();
        let eye = Eye::towards_emitters(vertex.position, vertex.face_normal);
        let at_rest = vertex.value();
        let next = sample_lights(
            self.accel,
            &at_rest,
            self.plan.sampling,
            draw.stream,
            self.plan.vertex_numbers(depth),
            |i, sample| {
                let weight = R::constant(sample.weight);
                let radiance = |direction: Vec3<R>| {
                    let hit = sample.hit.as_ref();
                    emitted_at(
                        world,
                        self.accel,
                        sample.emitter,
                        hit,
                        vertex.position,
                        direction,
                    )
                };
                if let Some(event) = sample.specular {
                    let (direction, fraction) = vertex.specular(event);
                    light += fraction.hadamard(radiance(direction)) * weight;
                    return;
                }
                let emitter = self.accel.scene.emitter(sample.emitter);
                if let Some(delta) = emitter.delta_light(vertex.position, |id| world.texel(id, 0).x)
                {
                    let f = vertex.eval(delta.direction);
                    let irradiance = world.texel(emitter.radiance(), 0) * delta.factor;
                    light += f.hadamard(irradiance) * weight;
                    return;
                }
                let carried = match self.gathers(sample.emitter) {
                    true => Carried::at_rest(sample.direction),
                    false => {
                        let (walk, numbers) = self.vertex_walk(depth, 2 + i, draw);
                        world.carry(&eye, sample.direction, walk, numbers)
                    }
                };
                let f = vertex.eval(carried.direction);
                light += f.hadamard(radiance(carried.direction)) * (carried.stretch * weight);
            },
            |event, hit| {
                if W::MOVES && (chain.after(event.event).is_none() || self.misses_mirrors()) {
                    let (direction, _) = vertex.specular(event);
                    self.count_uncovered(world, vertex.position, direction, hit, draw);
                }
            },
        );
        if W::MOVES
            && self.plan.sampling.dimensions() > 0
            && at_rest.bsdf.has_smooth()
            && let Some((field, _)) = self.moving
            && !field.has_flow()
        {
            let scene = self.accel.scene;
            if field.method != Method::Edges || scene.environment().is_some() {
                // What the field carries over the edges of lamps.
                let u = draw.stream.number(self.flux_number(depth));
                let (walk, numbers) = self.vertex_walk(depth, 0, draw);
                let (boundaries, walks) = (&field.boundaries, |id| !self.gathers(id));
                light += lamp_edge_flux(
                    self.accel, boundaries, world, &eye, &at_rest, u, walk, numbers, walks,
                );
            }
            // What moves across directions that stay.
            let dimension = EDGE_NUMBERS + edge_flux::NUMBERS * (depth + 1);
            light += lamp_outline_flux(field, world, &eye, &at_rest, draw, dimension);
        }
        (light, next)
    }

    /// True if directions towards an emitter stay, and edges before it are gathered.
    fn gathers(&self, emitter: EmitterId) -> bool {
        let method = self.moving.map(|(field, _)| field.method);
        let emitter = || self.accel.scene.emitter(emitter);
        method == Some(Method::Edges) && matches!(emitter(), Emitter::Area { .. })
    }

    /// True if the field knows nothing of what mirrors show.
    fn misses_mirrors(&self) -> bool {
        self.moving.is_some_and(|(field, _)| field.has_flow())
    }

    fn walks(&self) -> &Walks {
        &self.moving.as_ref().expect("only worlds that move walk").1
    }

    /// The number for a place on the lamps' edges; behind it those of walks:
    /// there, towards the next surface, and for each light sample.
    fn flux_number(&self, depth: u32) -> u32 {
        let walks = &self.walks();
        let film = self.film_numbers() + 2 + 3 * walks.camera.dimensions();
        let sampling = self.plan.sampling;
        let samples = sampling.emitter_samples + sampling.bsdf_samples;
        film + depth * (1 + (2 + samples) * walks.surface.dimensions())
    }

    fn vertex_walk<'d>(&self, depth: u32, k: u32, draw: Draw<'d>) -> (&WalkSettings, Numbers<'d>) {
        let Some((_, walks)) = &self.moving else {
            // Asked at rest, where nobody walks.
            return (&NO_WALK, Numbers { draw, dimension: 0 });
        };
        let walk = &walks.surface;
        let dimension = self.flux_number(depth) + 1 + k * walk.dimensions();
        (walk, Numbers { draw, dimension })
    }
}

const NO_WALK: WalkSettings = WalkSettings {
    steps: 0,
    max_radius: 0.0,
    estimator: capwalk_walk::Estimator::Anchored,
    antithetic: false,
};
