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

use std::f64::consts::PI;

use capwalk_geometry::{Hit, Ray};
use capwalk_math::{Frame, Real, Rgb, Vec3};
use capwalk_scene::lobe::{Bsdf, Event, Specular};
use capwalk_scene::sensor::view::{View, ViewRay};
use capwalk_scene::{Integrator, Layer, Scene};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::diff::boundary::{Draw, Eye, Field, Numbers};
use crate::diff::flux::lamp_edge_flux;
use crate::diff::unfold::MAX_EVENTS;
use crate::layer::layer_at;
use crate::light::{Continuation, LightSampling, emitter_towards, sample_lights};
use crate::material::{FlatEvents, vertex_at};
use crate::pixel::{Support, Supports};
use crate::world::{AtRest, World, emitted_at, surface_at};

/// Random numbers by purpose: where in the pixel.
const FILM: u32 = 0;
/// Which way to draw the film point.
const FILM_CHOICE: u32 = 2;
/// The first vertex's numbers start here, if the camera has no lens.
pub const FIRST_VERTEX: u32 = 3;
/// Where on the lens.
const LENS: u32 = FIRST_VERTEX;
/// How many numbers that takes.
const LENS_NUMBERS: u32 = 2;
/// With no largest depth, the numbers of walks start here.
const BEHIND_ALL_VERTICES: u32 = 1 << 20;

/// Share of film points drawn uniformly over the support: the slope of a
/// filter stays finite where the filter goes to zero, so drawing by the filter
/// alone would give derivatives infinite variance.
const UNIFORM: f64 = 0.5;

/// Largest probability that a path survives roulette.
const RR_MAX: f64 = 0.95;
/// Smallest one for derivatives: a path that carries no light may carry a
/// derivative, such as that of a black material's reflectance.
const RR_MIN: f64 = 0.05;

/// Which paths are sampled, and how.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Where the random numbers of the first vertex start.
    pub first_vertex: u32,
    /// Most segments of a path.
    pub max_depth: Option<u32>,
    /// Paths of more segments than this are subject to roulette.
    pub rr_depth: u32,
    /// How light from emitters is sampled at each vertex.
    pub sampling: LightSampling,
    /// Emitters are not seen by the camera.
    pub hide_emitters: bool,
    /// Instead of light: this.
    pub layer: Option<Layer>,
}

impl Plan {
    /// What a scene asks for.
    pub fn new(scene: &Scene) -> Self {
        let first_vertex = match scene.sensor.model.has_lens() {
            true => FIRST_VERTEX + LENS_NUMBERS,
            false => FIRST_VERTEX,
        };
        match scene.settings.integrator {
            Integrator::Direct {
                emitter_samples,
                bsdf_samples,
                hide_emitters,
            } => Self {
                first_vertex,
                max_depth: Some(2),
                rr_depth: u32::MAX,
                sampling: LightSampling {
                    emitter_samples,
                    bsdf_samples,
                },
                hide_emitters,
                layer: None,
            },
            Integrator::Path {
                max_depth,
                rr_depth,
                hide_emitters,
            } => Self {
                first_vertex,
                max_depth,
                rr_depth,
                sampling: LightSampling {
                    emitter_samples: 1,
                    bsdf_samples: 1,
                },
                hide_emitters,
                layer: None,
            },
            Integrator::Aov(layer) => Self {
                first_vertex,
                max_depth: Some(1),
                rr_depth: u32::MAX,
                sampling: LightSampling {
                    emitter_samples: 0,
                    bsdf_samples: 0,
                },
                hide_emitters: false,
                layer: Some(layer),
            },
        }
    }

    /// True if paths of this many segments are sampled.
    fn reaches(&self, segments: u32) -> bool {
        self.max_depth.is_none_or(|max| segments <= max)
    }

    /// Most specular events between a point that paths of so many segments lead
    /// to and what they show of the scene.
    fn events_behind(&self, segments: u32) -> u32 {
        let left = self.max_depth.map(|max| max.saturating_sub(segments + 1));
        left.map_or(MAX_EVENTS, |left| left.min(MAX_EVENTS))
    }

    /// Random numbers of each vertex: light and continuation, roulette.
    fn numbers_per_vertex(&self) -> u32 {
        self.sampling.dimensions() + 1
    }

    fn vertex_numbers(&self, depth: u32) -> u32 {
        let first = self.first_vertex;
        first.saturating_add(depth.saturating_mul(self.numbers_per_vertex()))
    }

    fn first_walk(&self) -> u32 {
        match self.max_depth {
            None => BEHIND_ALL_VERTICES,
            Some(max) => self
                .vertex_numbers(max.saturating_sub(1))
                .min(BEHIND_ALL_VERTICES),
        }
    }
}

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
}

/// The camera of a sample, seen from one point of its lens.
struct Camera<R> {
    at_rest: View<f64>,
    moving: View<R>,
}

/// A film point that moves with the field around the camera.
struct FilmPoint<R> {
    /// Where it looks.
    ray: ViewRay<R>,
    /// The moving film point.
    film: [R; 2],
    /// Film area per solid angle over its value, times the field's stretch: 1,
    /// and its change.
    stretch: R,
    near_boundary: bool,
}

impl<R: Real> FilmPoint<R> {
    fn moves(&self) -> bool {
        self.near_boundary || self.film.iter().any(|x| !x.is_constant())
    }
}

/// The specular events since a direction was carried along a field.
#[derive(Clone, Copy, Debug)]
pub struct Unfolded {
    /// How many, if the field has the outlines that are seen behind them.
    count: Option<u32>,
    /// After which further ones at this place it has them, too.
    events_here: FlatEvents,
}

impl Default for Unfolded {
    fn default() -> Self {
        Self {
            count: Some(0),
            events_here: FlatEvents::default(),
        }
    }
}

impl Unfolded {
    /// Their number with one more, if the field has the outlines behind it.
    fn after(&self, event: Event) -> Option<u32> {
        let count = self.count.filter(|_| self.events_here.contains(event))?;
        (count < MAX_EVENTS).then_some(count + 1)
    }
}

/// A surface point that scatters light.
#[derive(Clone, Debug)]
pub struct Vertex<R> {
    /// Where it is.
    pub position: Vec3<R>,
    /// Unit normal of the face on the viewer's side.
    pub face_normal: Vec3,
    /// The shading frame.
    pub frame: Frame<R>,
    /// Unit direction to the viewer in that frame.
    pub wi: Vec3<R>,
    /// What it does to light.
    pub bsdf: Bsdf<R>,
    /// True if light can come from both sides.
    pub transmits: bool,
}

impl<R: Real> Vertex<R> {
    /// Scattered radiance per incident radiance and solid angle, the cosine
    /// included; zero for what is perfectly specular.
    #[inline]
    pub fn eval(&self, direction: Vec3<R>) -> Rgb<R> {
        self.bsdf.eval(self.wi, self.frame.to_local(direction))
    }

    /// The direction of a specular event, and the fraction of light that comes
    /// from there.
    pub fn specular(&self, event: Specular) -> (Vec3<R>, Rgb<R>) {
        let (wo, throughput) = self.bsdf.specular(event, self.wi);
        (self.frame.to_world(wo), throughput)
    }

    /// The vertex without its derivative.
    pub fn value(&self) -> Vertex<f64> {
        Vertex {
            position: self.position.value(),
            face_normal: self.face_normal,
            frame: self.frame.value(),
            wi: self.wi.value(),
            bsdf: self.bsdf.value(),
            transmits: self.transmits,
        }
    }
}

impl Vertex<f64> {
    /// Density per solid angle with which the material draws a direction.
    #[inline]
    pub fn pdf(&self, direction: Vec3) -> f64 {
        self.bsdf.pdf(self.wi, self.frame.to_local(direction))
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
            ..Self::at_rest(accel)
        }
    }

    /// The same with another plan.
    pub fn with_plan(self, plan: Plan) -> Self {
        Self { plan, ..self }
    }

    /// One sample of a pixel.
    pub fn pixel<R: Real, W: World<R>>(&self, world: &W, pixel: [u32; 2], draw: Draw) -> Rgb<R> {
        let support = self.supports.pixel(pixel);
        let camera = self.camera(world, draw);
        let light = self.interior(world, &camera, &support, draw);
        match W::MOVES && support.jumps() {
            true => light + self.border_flux(world, &camera, &support, draw),
            false => light,
        }
    }

    /// The camera, from a point of its lens.
    fn camera<R: Real, W: World<R>>(&self, world: &W, draw: Draw) -> Camera<R> {
        let scene = self.accel.scene;
        let lens = match scene.sensor.model.has_lens() {
            true => uniform_disk(draw.stream.pair(LENS)),
            false => [0.0; 2],
        };
        let moving = View::new(&scene.sensor, &scene.film, &world.sensor(), lens);
        Camera {
            at_rest: moving.value(),
            moving,
        }
    }

    fn interior<R: Real, W: World<R>>(
        &self,
        world: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let stream = draw.stream;
        let uniform = if W::MOVES { UNIFORM } else { 0.0 };
        let s = support.sample(uniform, stream.number(FILM_CHOICE), stream.pair(FILM));
        let density = support.pdf(uniform, s);
        let point = self.film_point(world, camera, s, 0, draw);
        if !W::MOVES || support.jumps() {
            return self.share(world, support, &point, density, draw);
        }
        // The filter's slope points opposite ways on opposite sides of its
        // centre: where the picture moves, averaging both removes most of its
        // noise.
        let other = self.film_point(world, camera, support.mirror(s), 1, draw);
        if !point.moves() && !other.moves() {
            return self.share(world, support, &point, density, draw);
        }
        let both = self.share(world, support, &point, density, draw)
            + self.share(world, support, &other, density, draw);
        both * R::constant(0.5)
    }

    /// The share of a film point drawn with `density`: `W L / J` times the
    /// field's stretch.
    fn share<R: Real, W: World<R>>(
        &self,
        world: &W,
        support: &Support,
        point: &FilmPoint<R>,
        density: f64,
        draw: Draw,
    ) -> Rgb<R> {
        let weight = support.weight(point.film) * point.stretch * R::constant(1.0 / density);
        self.radiance(world, point.ray, draw) * weight
    }

    /// `-∮ W L ṡ·n dl` along the sides of the support where the filter jumps.
    /// Opposite sides are sampled at the same place with the same numbers, so
    /// that a picture that moves as a whole costs little noise.
    fn border_flux<R: Real, W: World<R>>(
        &self,
        world: &W,
        camera: &Camera<R>,
        support: &Support,
        draw: Draw,
    ) -> Rgb<R> {
        let mut flux = Rgb::zero();
        let stream = draw.stream;
        let first = self.film_numbers();
        let axis = usize::from(stream.number(first) < 0.5);
        let (side, along) = (support.sides[axis], support.sides[1 - axis]);
        let place = along.bounds[0] + along.width() * stream.number(first + 1);
        for (end, outward) in [(0, -1.0), (1, 1.0)] {
            if !side.jumps[end] {
                continue;
            }
            let mut s = [place; 2];
            s[axis] = side.bounds[end];
            let film = self.carried_film_point(world, camera, s, draw)[axis];
            let flow = film - R::constant(film.value());
            if !flow.is_constant() {
                // Two axes, each drawn half of the time.
                let weight = support.weight(s) * 2.0 * along.width();
                let ray = camera.at_rest.ray(camera.at_rest.direction(s));
                let light = self.radiance(&AtRest(self.accel), ray, draw);
                flux += Rgb::constant(light * (-outward * weight)) * flow;
            }
        }
        flux
    }

    fn film_point<R: Real, W: World<R>>(
        &self,
        world: &W,
        camera: &Camera<R>,
        s: [f64; 2],
        walk: u32,
        draw: Draw,
    ) -> FilmPoint<R> {
        let view = &camera.moving;
        let q = camera.at_rest.direction(s);
        if !W::MOVES {
            return FilmPoint {
                ray: view.ray(Vec3::constant(q)),
                film: s.map(R::constant),
                stretch: R::constant(1.0),
                near_boundary: false,
            };
        }
        let (settings, numbers) = self.film_walk(walk, draw);
        let carried = world.carry(&self.camera_eye(view), q, settings, numbers);
        let area = view.film_area_per_solid_angle(carried.direction);
        FilmPoint {
            ray: view.ray(carried.direction),
            film: view.film(carried.direction),
            stretch: area * R::constant(1.0 / area.value()) * carried.stretch,
            near_boundary: carried.near_boundary,
        }
    }

    /// Where the field carries a film point, pixels.
    fn carried_film_point<R: Real, W: World<R>>(
        &self,
        world: &W,
        camera: &Camera<R>,
        s: [f64; 2],
        draw: Draw,
    ) -> [R; 2] {
        let (settings, numbers) = self.film_walk(2, draw);
        let q = camera.at_rest.direction(s);
        let view = &camera.moving;
        view.film(world.carry_value(&self.camera_eye(view), q, settings, numbers))
    }

    fn camera_eye<R: Real>(&self, view: &View<R>) -> Eye<R> {
        Eye::camera(view.eye, self.events_behind(0))
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
        let mut unfolded = Unfolded::default();
        for depth in 0.. {
            let Some(found) = hit.filter(|_| plan.reaches(depth + 2)) else {
                break;
            };
            let surface = surface_at(world, accel, &found, origin, direction);
            let Some(vertex) = vertex_at(world, accel, &surface, direction) else {
                break;
            };
            unfolded.events_here = accel.flat_events(&found);
            let (emitted, next) = self.emitted(world, &vertex, depth, unfolded, draw);
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
                    unfolded = Unfolded::default();
                    carried.direction
                }
                Some(event) => {
                    let (wo, fraction) = vertex.specular(event);
                    throughput = throughput.hadamard(fraction * over_density);
                    unfolded.count = unfolded.after(event.event);
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
        unfolded: Unfolded,
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
                let (walk, numbers) = self.vertex_walk(depth, 2 + i, draw);
                let carried = world.carry(&eye, sample.direction, walk, numbers);
                let f = vertex.eval(carried.direction);
                light += f.hadamard(radiance(carried.direction)) * (carried.stretch * weight);
            },
            |event, hit| {
                if W::MOVES && unfolded.after(event.event).is_none() {
                    let (direction, _) = vertex.specular(event);
                    self.count_uncovered(world, vertex.position, direction, hit, draw);
                }
            },
        );
        if W::MOVES
            && self.plan.sampling.dimensions() > 0
            && at_rest.bsdf.has_smooth()
            && let Some((field, _)) = self.moving
        {
            // What the field carries over the edges of lamps.
            let u = draw.stream.number(self.flux_number(depth));
            let (walk, numbers) = self.vertex_walk(depth, 0, draw);
            let boundaries = &field.boundaries;
            let flux = lamp_edge_flux(
                self.accel, boundaries, world, &eye, &at_rest, u, walk, numbers,
            );
            light += flux;
        }
        (light, next)
    }

    fn walks(&self) -> &Walks {
        &self.moving.as_ref().expect("only worlds that move walk").1
    }

    /// Two numbers for a place on the border of a pixel; behind them those of
    /// three walks: at a film point, opposite to it, at the border.
    fn film_numbers(&self) -> u32 {
        self.plan.first_walk()
    }

    fn film_walk<'d>(&self, k: u32, draw: Draw<'d>) -> (&WalkSettings, Numbers<'d>) {
        let walk = &self.walks().camera;
        let dimension = self.film_numbers() + 2 + k * walk.dimensions();
        (walk, Numbers { draw, dimension })
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

/// Largest angle of the camera's field, in pixels: beyond it everything visible
/// stays at rest on the film. A field that reaches farther moves pixels without
/// need, and their derivatives become noisy; one that reaches less far than a
/// pixel has steep slopes. Two pixels measured best on the built-in scenes.
const CAMERA_PIXELS: f64 = 2.0;

/// [`CAMERA_PIXELS`] as an angle, in the middle of the film.
fn camera_angle(accel: &Accel) -> f64 {
    (CAMERA_PIXELS * accel.view.pixel_size()).atan()
}

/// A uniform point of the unit disk.
fn uniform_disk(u: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = (2.0 * PI * u[1]).sin_cos();
    [cos, sin].map(|x| x * u[0].sqrt())
}
