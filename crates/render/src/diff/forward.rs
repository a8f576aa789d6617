//! The derivative picture in forward mode: every sample moves with a velocity
//! field, and is differentiated along it.
//!
//! With `u` the field around the camera and `L` the radiance along the moved
//! camera ray, a pixel's derivative is (METHOD 1 and 4)
//!
//! ```text
//! ∫ [ d/dε (W L / J)(moved) + (W L / J) div u ] dω  -  ∮ W L ṡ·n dl
//! ```
//!
//! where `W / J` is the filter times film area per solid angle, and the flux
//! is taken where the filter ends without being zero, `ṡ` the film velocity of
//! the moved direction. `L` itself is such an integral, over the directions
//! from the surface towards light, with a field of its own around the moved
//! hit point (Algorithm 1).

use std::cell::Cell;

use capwalk_geometry::EdgeSelection;
use capwalk_math::{Dual, Real, Rgb, Vec3};
use capwalk_scene::{Diffuse, Integrator, Motion, Scene, SensorMotion};
use capwalk_walk::WalkSettings;

use crate::accel::Accel;
use crate::estimate::GradientImage;
use crate::integrator::{FILM, FILM_CHOICE, FIRST_VERTEX, PER_VERTEX, camera_ray, radiance};
use crate::light::{LightSample, LightSampling, emitter_towards, sample_lights};
use crate::options::{GradientOptions, Refusal, Watch};
use crate::pixel::{Support, Supports};
use crate::tiles::{self, Sample};
use crate::unsupported::unsupported_text;
use crate::world::{D, InMotion, Surface, World, surface_at};

use super::boundary::{Boundaries, CAMERA, Draw, Eye, Field, LIGHT, Numbers};
use super::clip::refuse_clipped;
use super::flux::lamp_edge_flux;

/// Everything that the samples of a gradient share.
pub(super) struct Forward<'a> {
    pub accel: &'a Accel<'a>,
    world: InMotion<'a>,
    pub field: Field<'a>,
    supports: Supports,
    sampling: LightSampling,
    hide_emitters: bool,
    camera_walk: WalkSettings,
    pub light_walk: WalkSettings,
}

/// Share of film points drawn uniformly over the support: the slope of a
/// filter stays finite where the filter goes to zero, so drawing by the filter
/// alone would give derivatives infinite variance.
const UNIFORM: f64 = 0.5;

/// The derivative of the picture for a unit change along `motion`, in forward
/// mode, with its standard error. Refuses what it cannot differentiate rightly:
/// paths longer than camera - surface - emitter, and surfaces that move while a
/// clip plane of the camera cuts them.
pub fn gradient(
    scene: &Scene,
    motion: &Motion,
    options: &GradientOptions,
    watch: &dyn Watch,
) -> Result<GradientImage, Refusal> {
    if let Some(refusal) = refusal(scene) {
        return Err(refusal);
    }
    let (sampling, hide_emitters) = light_paths(&scene.settings.integrator)?;
    check_walk(&options.walk)?;
    let accel = Accel::new(scene);
    let forward = Forward::new(&accel, motion, options.walk, sampling, hide_emitters);
    if forward.field.boundaries.any_moves || motion.sensor != SensorMotion::default() {
        refuse_clipped(&accel)?;
    }
    let averages = tiles::average(scene, &options.options, watch, |pixel, stream| {
        let queries = Cell::new(0);
        let draw = Draw {
            stream,
            queries: &queries,
        };
        let [value, slope] = forward.pixel_sample(pixel, draw);
        Sample {
            numbers: [value.x, value.y, value.z, slope.x, slope.y, slope.z],
            cone_queries: queries.get(),
        }
    });
    Ok(GradientImage {
        value: averages.estimate(scene, 0),
        gradient: averages.estimate(scene, 3),
        statistics: averages.statistics,
    })
}

/// The reason why [`gradient`] refuses the scene whatever moves, if it does.
pub fn refusal(scene: &Scene) -> Option<Refusal> {
    if let Some(reason) = unsupported_text(scene) {
        return Some(Refusal { reason });
    }
    light_paths(&scene.settings.integrator).err()
}

/// How light is sampled, if its paths are of the kind that is covered.
fn light_paths(integrator: &Integrator) -> Result<(LightSampling, bool), Refusal> {
    match *integrator {
        Integrator::Direct {
            emitter_samples,
            bsdf_samples,
            hide_emitters,
        } => {
            let sampling = LightSampling {
                emitter_samples,
                bsdf_samples,
            };
            Ok((sampling, hide_emitters))
        }
        Integrator::Path {
            max_depth: Some(depth @ 1..=2),
            hide_emitters,
            ..
        } => {
            let sampling = LightSampling {
                emitter_samples: depth - 1,
                bsdf_samples: depth - 1,
            };
            Ok((sampling, hide_emitters))
        }
        Integrator::Path { max_depth, .. } => Err(Refusal {
            reason: format!(
                "derivatives of indirect light are not available yet, and the path integrator's \
                 max_depth is {}. Use the integrator `direct`, or `path` with max_depth at most \
                 2, or finite differences, which cover everything",
                max_depth.map_or("unlimited".into(), |depth| depth.to_string())
            ),
        }),
    }
}

pub(super) fn check_walk(walk: &WalkSettings) -> Result<(), Refusal> {
    if walk.steps == 0 {
        return Err(Refusal {
            reason: "a walk of 0 steps gives a field that is not continuous, and a wrong \
                     derivative; use at least 1 step"
                .into(),
        });
    }
    if !(walk.max_radius > 0.0 && walk.max_radius <= std::f64::consts::PI) {
        return Err(Refusal {
            reason: format!(
                "the largest angle of a walk is {}; expected radians above 0 and at most π",
                walk.max_radius
            ),
        });
    }
    Ok(())
}

/// Largest angle of the camera's field, in pixels: beyond it everything visible
/// stays at rest on the film. A field that reaches farther moves pixels without
/// need, and their derivatives become noisy; one that reaches less far than a
/// pixel has steep slopes. Two pixels measured best on the built-in scenes.
const CAMERA_PIXELS: f64 = 2.0;

/// [`CAMERA_PIXELS`] as an angle, in the middle of the film.
fn camera_angle(scene: &Scene) -> f64 {
    let pixel = 2.0 * (0.5 * scene.sensor.fov_x).tan() / f64::from(scene.film.size[0]);
    (CAMERA_PIXELS * pixel).atan()
}

/// A film point that moves with the field.
struct FilmPoint {
    /// Where, pixels.
    at: [f64; 2],
    /// The moving world-space direction.
    direction: Vec3<D>,
    /// The moving film point.
    film: [D; 2],
    /// Film area per solid angle over its value: 1, and its change.
    stretch: D,
    /// Of the field around the camera.
    divergence: f64,
}

impl FilmPoint {
    fn moves(&self) -> bool {
        self.divergence != 0.0 || self.film.iter().any(|x| x.tangent[0] != 0.0)
    }
}

impl<'a> Forward<'a> {
    pub(super) fn new(
        accel: &'a Accel<'a>,
        motion: &'a Motion,
        walk: WalkSettings,
        sampling: LightSampling,
        hide_emitters: bool,
    ) -> Self {
        let world = InMotion::new(accel, motion);
        Self {
            accel,
            field: Field {
                accel,
                boundaries: Boundaries::new(accel, &world),
                horizon_distance: accel.horizon_distance(),
            },
            world,
            supports: Supports::new(&accel.scene.film),
            sampling,
            hide_emitters,
            camera_walk: WalkSettings {
                max_radius: walk.max_radius.min(camera_angle(accel.scene)),
                ..walk
            },
            light_walk: walk,
        }
    }

    /// One sample of a pixel's value and derivative.
    fn pixel_sample(&self, pixel: [u32; 2], draw: Draw) -> [Rgb; 2] {
        let support = self.supports.pixel(pixel);
        let [value, slope] = self.interior(&support, draw);
        [value, slope + self.border_flux(&support, draw)]
    }

    fn interior(&self, support: &Support, draw: Draw) -> [Rgb; 2] {
        let stream = draw.stream;
        let s = support.sample(UNIFORM, stream.number(FILM_CHOICE), stream.pair(FILM));
        let density = support.pdf(UNIFORM, s);
        let point = self.film_point(s, self.walk_numbers(draw, 0));
        if support.jumps() {
            return self.share(support, &point, density, draw);
        }
        // The filter's slope points opposite ways on opposite sides of its
        // centre: where the picture moves, averaging both removes most of its
        // noise.
        let other = self.film_point(support.mirror(s), self.walk_numbers(draw, 1));
        if !point.moves() && !other.moves() {
            return self.share(support, &point, density, draw);
        }
        let pair = [&point, &other].map(|point| self.share(support, point, density, draw));
        [0, 1].map(|k| (pair[0][k] + pair[1][k]) * 0.5)
    }

    /// The share of a film point drawn with `density`: `W L / J` and its
    /// derivative along the field.
    fn share(&self, support: &Support, point: &FilmPoint, density: f64, draw: Draw) -> [Rgb; 2] {
        let weight = support.weight(point.film) * point.stretch * Dual::constant(1.0 / density);
        let light = self.radiance(point.at, point.direction, draw) * weight;
        let value = light.value();
        [value, light.tangent(0) + value * point.divergence]
    }

    /// `-∮ W L ṡ·n dl` along the sides of the support where the filter jumps.
    /// Opposite sides are sampled at the same place with the same numbers, so
    /// that a picture that moves as a whole costs little noise.
    fn border_flux(&self, support: &Support, draw: Draw) -> Rgb {
        let mut flux = Rgb::zero();
        if !support.jumps() {
            return flux;
        }
        let stream = draw.stream;
        let axis = usize::from(stream.number(self.border_dimension()) < 0.5);
        let (side, along) = (support.sides[axis], support.sides[1 - axis]);
        let place = along.bounds[0] + along.width() * stream.number(self.border_dimension() + 1);
        for (end, outward) in [(0, -1.0), (1, 1.0)] {
            if !side.jumps[end] {
                continue;
            }
            let mut s = [place; 2];
            s[axis] = side.bounds[end];
            let velocity = self.film_velocity(s, self.walk_numbers(draw, 2))[axis];
            if velocity != 0.0 {
                // Two axes, each drawn half of the time.
                let weight = support.weight(s) * 2.0 * along.width();
                flux += radiance(self.accel, s, stream) * (-velocity * outward * weight);
            }
        }
        flux
    }

    /// The camera and what it may see jump.
    fn camera(&self) -> Eye {
        Eye {
            position: self.world.sensor_origin(),
            face_normal: None,
            // Shading jumps at every crease, seen from either side.
            selection: EdgeSelection::All,
            group: CAMERA,
            is_camera: true,
        }
    }

    fn film_point(&self, s: [f64; 2], numbers: Numbers) -> FilmPoint {
        let q = self.film_direction(s);
        let field = self
            .field
            .sample(&self.camera(), q, &self.camera_walk, numbers);
        let scene = self.accel.scene;
        let direction = q.with_tangent(field.velocity);
        let local = self.world.camera_direction(direction);
        let area = scene.sensor.film_area_per_solid_angle(&scene.film, local);
        FilmPoint {
            at: s,
            direction,
            film: scene.sensor.film_from_camera(&scene.film, local),
            stretch: area * Dual::constant(1.0 / area.value),
            divergence: field.divergence,
        }
    }

    /// The velocity at which the field carries a film point, pixels.
    fn film_velocity(&self, s: [f64; 2], numbers: Numbers) -> [f64; 2] {
        let q = self.film_direction(s);
        let u = self
            .field
            .sample_value(&self.camera(), q, &self.camera_walk, numbers);
        let scene = self.accel.scene;
        let local = self.world.camera_direction(q.with_tangent(u));
        let film = scene.sensor.film_from_camera(&scene.film, local);
        film.map(|x| x.tangent[0])
    }

    fn film_direction(&self, s: [f64; 2]) -> Vec3 {
        let scene = self.accel.scene;
        let local = scene.sensor.camera_from_film(&scene.film, s);
        scene.sensor.world_from_camera.vector(local).normalized()
    }

    /// Radiance along a moving camera ray, with its derivative.
    fn radiance(&self, s: [f64; 2], direction: Vec3<D>, draw: Draw) -> Rgb<D> {
        let world = &self.world;
        let ray = camera_ray(self.accel, s);
        let mut light = Rgb::zero();
        if let Some(emitter) = emitter_towards(self.accel, ray.hit.as_ref(), ray.direction)
            && !self.hide_emitters
        {
            light += world.radiance(emitter);
        }
        let Some(hit) = &ray.hit else { return light };
        let surface = surface_at(world, self.accel, hit, world.sensor_origin(), direction);
        if let Some(bsdf) = surface.bsdf {
            light += self.reflected(&surface, world.reflectance(bsdf), draw);
        }
        light
    }

    /// Light that arrives from emitters at a moving surface point and is
    /// reflected there, with its derivative.
    pub(super) fn reflected(
        &self,
        surface: &Surface<D>,
        reflectance: Rgb<D>,
        draw: Draw,
    ) -> Rgb<D> {
        let mut light = Rgb::zero();
        if self.sampling.dimensions() == 0 {
            return light;
        }
        let eye = Eye {
            position: surface.position,
            face_normal: Some(surface.face_normal),
            selection: EdgeSelection::Silhouettes,
            group: LIGHT,
            // Around a direction that reaches light nothing is hidden: what
            // hides an edge would have an outline nearer than the edge.
            is_camera: false,
        };
        let at_rest = surface.value();

        // Light from sampled directions that move with the field around the
        // surface point.
        let shade = |i: u32, sample: LightSample| {
            let q = sample.direction;
            let numbers = self.walk_numbers(draw, 4 + i);
            let field = self.field.sample(&eye, q, &self.light_walk, numbers);
            let cos_o = surface.normal.dot(q.with_tangent(field.velocity));
            let f = Diffuse::eval(reflectance, cos_o);
            let f = f.hadamard(self.world.radiance(sample.emitter));
            let slope = f.tangent(0) + f.value() * field.divergence;
            light += (f.value() * sample.weight).with_tangent(slope * sample.weight);
        };
        let (position, normal) = (at_rest.position, at_rest.normal);
        let (sampling, stream) = (self.sampling, draw.stream);
        sample_lights(
            self.accel,
            position,
            normal,
            sampling,
            stream,
            FIRST_VERTEX,
            shade,
        );

        // What the field carries over the edges of lamps.
        let u = stream.number(self.border_dimension() + 2);
        let numbers = self.walk_numbers(draw, 3);
        let flux = lamp_edge_flux(self, &eye, &at_rest, reflectance.value(), u, numbers);
        light + Rgb::zero().with_tangent(flux)
    }

    /// Dimensions behind those of the light samples and of the primal at the
    /// border: the side of the border, the place on it, and the place on the
    /// lamps' edges.
    fn border_dimension(&self) -> u32 {
        FIRST_VERTEX + self.sampling.dimensions().max(PER_VERTEX)
    }

    /// The numbers of the `k`-th walk: 0 and 1 at the film, 2 at its border, 3
    /// at a lamp's edge, then one for each light sample.
    fn walk_numbers<'d>(&self, draw: Draw<'d>, k: u32) -> Numbers<'d> {
        let dimension = self.border_dimension() + 3 + k * self.light_walk.dimensions();
        Numbers { draw, dimension }
    }
}
