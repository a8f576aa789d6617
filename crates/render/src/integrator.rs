//! The picture itself: direct light and path tracing over diffuse surfaces.

use capwalk_geometry::{Hit, Ray};
use capwalk_math::{Frame, Rgb, Vec3};
use capwalk_scene::{Diffuse, Integrator, Scene};

use crate::accel::Accel;
use crate::estimate::Rendering;
use crate::light::{
    EMITTER_NUMBERS, LightSampling, emitter_pdf, emitter_towards, power_heuristic, sample_emitter,
    sample_lights,
};
use crate::options::{Options, Watch};
use crate::pixel::Supports;
use crate::sampler::Stream;
use crate::tiles::{self, Sample};
use crate::world::{AtRest, Surface, World, surface_at};

/// Random numbers by purpose: where in the pixel.
pub(crate) const FILM: u32 = 0;
/// Which way to draw the film point.
pub(crate) const FILM_CHOICE: u32 = 2;
/// The first vertex's numbers start here.
pub(crate) const FIRST_VERTEX: u32 = 3;
/// Numbers that each vertex of a path takes: light, continuation, roulette.
pub(crate) const PER_VERTEX: u32 = EMITTER_NUMBERS + 3;

/// The picture of a scene. The scene must have passed [`Scene::check`].
pub fn render(scene: &Scene, options: &Options, watch: &dyn Watch) -> Rendering {
    let accel = Accel::new(scene);
    let supports = Supports::new(&scene.film);
    let averages = tiles::average(scene, options, watch, |pixel, stream| {
        let light = pixel_sample(&accel, &supports, pixel, stream);
        Sample {
            numbers: light.to_array(),
            cone_queries: 0,
        }
    });
    Rendering {
        value: averages.estimate(scene, 0),
        statistics: averages.statistics,
    }
}

/// One sample of a pixel's value.
pub(crate) fn pixel_sample(
    accel: &Accel,
    supports: &Supports,
    pixel: [u32; 2],
    stream: &Stream,
) -> Rgb {
    let support = supports.pixel(pixel);
    let s = support.sample(0.0, 0.0, stream.pair(FILM));
    let weight = support.weight(s) / support.pdf(0.0, s);
    radiance(accel, s, stream) * weight
}

/// A camera ray and what it meets.
pub(crate) struct CameraRay {
    /// Unit direction in world space.
    pub direction: Vec3,
    /// What it hits between the clip planes.
    pub hit: Option<Hit>,
}

/// The camera ray through a film point.
pub(crate) fn camera_ray(accel: &Accel, s: [f64; 2]) -> CameraRay {
    let scene = accel.scene;
    let local = scene.sensor.camera_from_film(&scene.film, s);
    let direction = scene.sensor.world_from_camera.vector(local).normalized();
    let hit = accel.first_hit_within(&Ray {
        origin: scene.sensor.origin(),
        direction,
        t_min: scene.sensor.near_clip / local.z,
        t_max: scene.sensor.far_clip / local.z,
    });
    CameraRay { direction, hit }
}

/// A sample of the radiance that arrives at a film point.
pub(crate) fn radiance(accel: &Accel, s: [f64; 2], stream: &Stream) -> Rgb {
    let ray = camera_ray(accel, s);
    let origin = accel.scene.sensor.origin();
    match accel.scene.settings.integrator {
        Integrator::Direct {
            emitter_samples,
            bsdf_samples,
            hide_emitters,
        } => {
            let sampling = LightSampling {
                emitter_samples,
                bsdf_samples,
            };
            direct(accel, origin, &ray, sampling, hide_emitters, stream)
        }
        Integrator::Path {
            max_depth,
            rr_depth,
            hide_emitters,
        } => path(
            accel,
            origin,
            ray,
            max_depth,
            rr_depth,
            hide_emitters,
            stream,
        ),
    }
}

/// Emitted light, and light reflected once.
fn direct(
    accel: &Accel,
    origin: Vec3,
    ray: &CameraRay,
    sampling: LightSampling,
    hide_emitters: bool,
    stream: &Stream,
) -> Rgb {
    let world = AtRest(accel);
    let mut light = Rgb::zero();
    if let Some(emitter) = emitter_towards(accel, ray.hit.as_ref(), ray.direction)
        && !hide_emitters
    {
        light += world.radiance(emitter);
    }
    let Some(hit) = &ray.hit else { return light };
    let surface = surface_at(&world, accel, hit, origin, ray.direction);
    let Some(bsdf) = surface.bsdf else {
        return light;
    };
    let reflectance = world.reflectance(bsdf);
    let Surface {
        position, normal, ..
    } = surface;
    sample_lights(
        accel,
        position,
        normal,
        sampling,
        stream,
        FIRST_VERTEX,
        |_, sample| {
            let f = Diffuse::eval(reflectance, normal.dot(sample.direction));
            light += f.hadamard(world.radiance(sample.emitter)) * sample.weight;
        },
    );
    light
}

/// Light along paths of up to `max_depth` segments.
fn path(
    accel: &Accel,
    mut origin: Vec3,
    mut ray: CameraRay,
    max_depth: Option<u32>,
    rr_depth: u32,
    hide_emitters: bool,
    stream: &Stream,
) -> Rgb {
    /// Most that throughput may be trusted to survive roulette.
    const RR_MAX: f64 = 0.95;

    let world = AtRest(accel);
    let mut light = Rgb::zero();
    let mut throughput = Rgb::splat(1.0); // of the path so far, over its density
    let mut last: Option<(f64, Vec3)> = None; // density of the direction taken, normal there
    for depth in 0.. {
        if max_depth.is_some_and(|max| depth >= max) {
            break;
        }
        // Light emitted where the path has arrived, weighted against having
        // drawn the emitter itself at the vertex before.
        let emitter = emitter_towards(accel, ray.hit.as_ref(), ray.direction);
        if let Some(emitter) = emitter {
            let weight = match last {
                None if hide_emitters => 0.0,
                None => 1.0,
                Some((pdf, normal)) => {
                    let hit = ray.hit.as_ref();
                    let other = emitter_pdf(accel, emitter, hit, ray.direction, normal);
                    power_heuristic(pdf, other)
                }
            };
            light += throughput.hadamard(world.radiance(emitter)) * weight;
        }
        let Some(hit) = &ray.hit else { break };
        if max_depth.is_some_and(|max| depth + 1 >= max) {
            break;
        }
        let surface = surface_at(&world, accel, hit, origin, ray.direction);
        let Some(bsdf) = surface.bsdf else { break };
        let reflectance = world.reflectance(bsdf);
        let normal = surface.normal;
        let frame = Frame::from_normal(normal);
        let dimension = FIRST_VERTEX + depth * PER_VERTEX;

        // Light from a point drawn on an emitter.
        if let Some((direction, emitter, pdf)) =
            sample_emitter(accel, surface.position, &frame, stream, dimension)
        {
            let cos_o = direction.dot(normal);
            let weight = power_heuristic(pdf, Diffuse::pdf(cos_o)) / pdf;
            let f = Diffuse::eval(reflectance, cos_o);
            light += throughput.hadamard(f).hadamard(world.radiance(emitter)) * weight;
        }

        // Go on in a direction drawn from the material; cosine and density
        // cancel to the reflectance.
        let local = Diffuse::sample(stream.pair(dimension + EMITTER_NUMBERS));
        throughput = throughput.hadamard(reflectance);
        if throughput == Rgb::zero() {
            break;
        }
        if depth + 1 >= rr_depth {
            let survival = throughput.max_component().min(RR_MAX);
            if stream.number(dimension + EMITTER_NUMBERS + 2) >= survival {
                break;
            }
            throughput = throughput / survival;
        }
        let direction = frame.to_world(local);
        last = Some((Diffuse::pdf(local.z), normal));
        origin = surface.position;
        ray = CameraRay {
            direction,
            hit: accel.first_hit(origin, direction),
        };
    }
    light
}
