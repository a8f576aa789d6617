//! Directions towards light: what a shading point samples, and with which
//! weight. Primal and derivative use the same samples; densities and weights
//! are never differentiated.

use std::f64::consts::{FRAC_1_PI, PI};

use capwalk_boundary::{Accel, Stream};
use capwalk_geometry::Hit;
use capwalk_math::Vec3;
use capwalk_scene::EmitterId;
use capwalk_scene::emitter::{EnvironmentTable, MapPlace};
use capwalk_scene::lobe::{Specular, cosine_pdf, sample_cosine};

use crate::emitter_choice::EmitterChoice;
use crate::emitter_sampler::{DirectionSampler, EmitterSampler};
use crate::plan::{BSDF_NUMBERS, EMITTER_NUMBERS, LightSampling};
use crate::receiver::Receiver;
use crate::vertex::Vertex;

/// An unoccluded direction towards an emitter.
#[derive(Clone, Copy, Debug)]
pub struct LightSample {
    /// Unit direction from the shading point.
    pub direction: Vec3,
    /// The emitter seen there.
    pub emitter: EmitterId,
    /// Where the direction hits it, if it is on a surface.
    pub hit: Option<Hit>,
    /// Multiple-importance weight over density per solid angle, divided by the
    /// number of samples of the technique.
    pub weight: f64,
    /// The specular event that it comes from: then `weight` has its probability
    /// in the place of a density.
    pub specular: Option<Specular>,
}

/// A direction drawn from a material, in which a path can go on.
#[derive(Clone, Copy, Debug)]
pub struct Continuation {
    /// Unit direction from the shading point.
    pub direction: Vec3,
    /// Its density per solid angle, or the probability of the specular event.
    pub pdf: f64,
    /// The specular event, if it is one.
    pub specular: Option<Specular>,
    /// What it hits.
    pub hit: Option<Hit>,
}

/// Samples directions towards emitters from a shading point, by points on emitters and by
/// the material, combined with the power heuristic (Veach 1997). Calls `shade` with each
/// sample that reaches an emitter and its number. Uses `sampling.dimensions()` random numbers from
/// `dimension` on. Returns the first direction sampled from the material; where the path does
/// not go on (`goes_on`) there may be none.
pub fn sample_lights(
    accel: &Accel,
    emitters: &[EmitterSampler],
    vertex: &Vertex<f64>,
    sampling: LightSampling,
    stream: &Stream,
    dimension: u32,
    goes_on: bool,
    mut shade: impl FnMut(u32, LightSample),
) -> Option<Continuation> {
    let counts = LightSampling {
        bsdf_samples: match goes_on || !is_sampled_well(emitters, vertex, sampling) {
            true => sampling.bsdf_samples,
            false => 0,
        },
        ..sampling
    };
    // Densities of all samples of each technique together.
    let of_emitters = |pdf: f64| f64::from(counts.emitter_samples) * pdf;
    let of_bsdf = |pdf: f64| f64::from(counts.bsdf_samples) * pdf;

    // Points on emitters are of no use to what is perfectly specular.
    let on_emitters = if vertex.bsdf.has_smooth() {
        counts.emitter_samples
    } else {
        0
    };
    let (count, receiver) = (emitters.len(), vertex.receiver());
    let emitter_choice = match sampling.alike || on_emitters == 0 {
        true => EmitterChoice::alike(count),
        false => {
            EmitterChoice::by_light(accel, emitters, &receiver, count, |i| EmitterId(i as u32))
        }
    };
    for i in 0..on_emitters {
        let base = dimension + i * EMITTER_NUMBERS;
        let (u, point) = (stream.number(base), stream.pair(base + 1));
        let Some((chosen, probability)) = emitter_choice.choose(u) else {
            continue;
        };
        let emitter = EmitterId(chosen as u32);
        let sampler = &emitters[chosen].directions;
        let drawn = TowardsEmitter::draw(accel, emitter, sampler, &receiver, point);
        let Some(drawn) = drawn.filter(|drawn| drawn.is_free(accel, receiver.position)) else {
            continue;
        };
        // Nothing else samples the direction of an emitter without extent.
        let other = match sampler {
            DirectionSampler::Delta => 0.0,
            _ if counts.bsdf_samples == 0 => 0.0,
            DirectionSampler::Area(_)
            | DirectionSampler::Constant
            | DirectionSampler::Environment(_) => of_bsdf(vertex.pdf(drawn.direction)),
        };
        let own = of_emitters(probability * drawn.pdf);
        if own > 0.0 {
            let sample = LightSample {
                direction: drawn.direction,
                emitter,
                hit: drawn.hit,
                weight: power_heuristic(own, other) / own,
                specular: None,
            };
            shade(i, sample);
        }
    }
    let mut next = None;
    for i in 0..counts.bsdf_samples {
        let base = dimension + sampling.emitter_samples * EMITTER_NUMBERS + i * BSDF_NUMBERS;
        let (choice, u) = (stream.number(base), stream.pair(base + 1));
        let Some(drawn) = vertex.bsdf.sample(vertex.wi, choice, u) else {
            continue;
        };
        let direction = vertex.frame.to_world(drawn.wo).normalized();
        let ray = match drawn.specular {
            Some(Specular { event, .. }) => {
                accel.ray_leaving(&vertex.leaving(event), vertex.position, direction)
            }
            None => accel.surface_ray(vertex.position, direction),
        };
        let hit = accel.first_hit_within(&ray);
        if i == 0 {
            next = Some(Continuation {
                direction,
                pdf: drawn.pdf,
                specular: drawn.specular,
                hit,
            });
        }
        let Some(emitter) = emitter_towards(accel, hit.as_ref(), direction) else {
            continue;
        };
        let own = of_bsdf(drawn.pdf);
        // Nothing else samples a specular direction.
        let other = match drawn.specular {
            Some(_) => 0.0,
            None => {
                let sampler = &emitters[emitter.0 as usize].directions;
                let pdf = emitter_pdf(accel, emitter, sampler, hit.as_ref(), direction, &receiver);
                of_emitters(emitter_choice.probability(emitter.0 as usize) * pdf)
            }
        };
        let sample = LightSample {
            direction,
            emitter,
            hit,
            weight: power_heuristic(own, other) / own,
            specular: drawn.specular,
        };
        shade(counts.emitter_samples + i, sample);
    }
    next
}

/// Largest solid angle of an emitter, steradians, of which points alone are sampled at diffuse
/// surfaces: in a wider one cosines differ much.
pub const NARROW: f64 = 1.0;

/// True if no direction from a material leads to any of the emitters: they have no extent.
pub fn all_are_deltas(emitters: &[EmitterSampler]) -> bool {
    let mut samplers = emitters.iter().map(|emitter| &emitter.directions);
    samplers.all(|sampler| matches!(sampler, DirectionSampler::Delta))
}

/// True if directions from the material would add more time than they take noise away: where they lead
/// to no emitter, and where light comes from one area emitter, which is not wide, to a surface that scatters it
/// evenly, points on the emitter have weights that hardly differ.
fn is_sampled_well(
    emitters: &[EmitterSampler],
    vertex: &Vertex<f64>,
    sampling: LightSampling,
) -> bool {
    if all_are_deltas(emitters) {
        return true;
    }
    let [emitter] = emitters else {
        return false;
    };
    let DirectionSampler::Area(triangles) = &emitter.directions else {
        return false;
    };
    sampling.emitter_samples > 0
        && vertex.bsdf.is_diffuse()
        && triangles.solid_angle(vertex.position) < NARROW
}

/// Weight of a sample of density `own` that the density `other` could have
/// drawn too (Veach 1997, power heuristic with exponent 2).
#[inline(always)]
pub fn power_heuristic(own: f64, other: f64) -> f64 {
    own * own / (own * own + other * other)
}

/// The emitter seen along a ray that hit `hit`, or nothing.
#[inline]
pub fn emitter_towards(accel: &Accel, hit: Option<&Hit>, direction: Vec3) -> Option<EmitterId> {
    match hit {
        Some(hit) => accel.emitter_at(hit, direction),
        None => accel.scene.environment(),
    }
}

/// Density per solid angle with which [`TowardsEmitter::draw`] draws a direction in
/// which the emitter is seen.
pub fn emitter_pdf(
    accel: &Accel,
    emitter: EmitterId,
    sampler: &DirectionSampler,
    hit: Option<&Hit>,
    direction: Vec3,
    receiver: &Receiver,
) -> f64 {
    match (sampler, hit) {
        (DirectionSampler::Area(triangles), Some(hit)) => {
            let face = hit.face - accel.emitter_face(emitter, 0);
            triangles.pdf(
                [receiver.position, receiver.frame.n],
                face,
                direction,
                hit.t,
            )
        }
        (DirectionSampler::Environment(table), _) => map_pdf(table, &table.map().place(direction)),
        (DirectionSampler::Constant, _) => {
            environment_pdf(receiver, receiver.frame.to_local(direction))
        }
        (DirectionSampler::Area(_) | DirectionSampler::Delta, _) => 0.0,
    }
}

/// A direction drawn towards an emitter: to a point of an area emitter, or to the environment.
#[derive(Clone, Copy, Debug)]
pub struct TowardsEmitter {
    /// Unit direction.
    pub direction: Vec3,
    /// Distance to the emitter; infinite for the environment and directional light.
    pub distance: f64,
    /// The point of the emitter, if it is on a surface.
    pub hit: Option<Hit>,
    /// Its density per solid angle; 1 if there is only one direction.
    pub pdf: f64,
}

impl TowardsEmitter {
    /// Draws one, whatever is in between; `None` if the emitter is seen from behind, or is behind
    /// the receiver.
    pub fn draw(
        accel: &Accel,
        emitter: EmitterId,
        sampler: &DirectionSampler,
        receiver: &Receiver,
        u: [f64; 2],
    ) -> Option<Self> {
        let position = receiver.position;
        let far = |direction, pdf| Self {
            direction,
            distance: f64::INFINITY,
            hit: None,
            pdf,
        };
        match sampler {
            DirectionSampler::Area(triangles) => {
                let point = triangles.sample([position, receiver.frame.n], u)?;
                let hit = Hit {
                    t: point.distance,
                    face: accel.emitter_face(emitter, point.face),
                    barycentric: point.barycentric,
                };
                (!receiver.is_behind(point.direction)).then_some(Self {
                    direction: point.direction,
                    distance: point.distance,
                    hit: Some(hit),
                    pdf: point.pdf,
                })
            }
            DirectionSampler::Constant => {
                let local = sample_environment(receiver, u);
                let pdf = environment_pdf(receiver, local);
                Some(far(receiver.frame.to_world(local), pdf))
            }
            DirectionSampler::Environment(table) => {
                let (direction, place) = sample_map(table, u);
                Some(far(direction, map_pdf(table, &place)))
            }
            DirectionSampler::Delta => {
                let light = accel.delta_light(emitter, position)?;
                let distance = light.distance;
                Some(Self {
                    distance,
                    ..far(light.direction, 1.0)
                })
            }
        }
    }

    /// True if nothing lies between the emitter and the point that it is drawn from.
    pub fn is_free(&self, accel: &Accel, position: Vec3) -> bool {
        accel.surface_sees(position, self.direction, self.distance)
    }
}

/// Share of directions to an environment map that are drawn uniformly: black
/// texels have derivatives, too.
pub const UNIFORM_SKY: f64 = 0.05;

/// A direction to an environment map, in world space, and its place on the map.
pub fn sample_map(table: &EnvironmentTable, u: [f64; 2]) -> (Vec3, MapPlace<f64>) {
    let is_uniform = table.is_black() || u[0] < UNIFORM_SKY;
    match is_uniform {
        true => {
            let share = if table.is_black() { 1.0 } else { UNIFORM_SKY };
            let direction = uniform_direction([u[0] / share, u[1]]);
            (direction, table.map().place(direction))
        }
        false => table.sample([(u[0] - UNIFORM_SKY) / (1.0 - UNIFORM_SKY), u[1]]),
    }
}

/// Density per solid angle of [`sample_map`] at a place.
#[inline(always)]
pub fn map_pdf(table: &EnvironmentTable, place: &MapPlace<f64>) -> f64 {
    let uniform = 0.25 * FRAC_1_PI;
    match table.is_black() {
        true => uniform,
        false => UNIFORM_SKY * uniform + (1.0 - UNIFORM_SKY) * table.pdf(place),
    }
}

/// A direction drawn uniformly from the sphere.
fn uniform_direction(u: [f64; 2]) -> Vec3 {
    let z = 1.0 - 2.0 * u[0];
    let (sin, cos) = (2.0 * PI * u[1]).sin_cos();
    let radius = (1.0 - z * z).max(0.0).sqrt();
    Vec3::new(radius * cos, radius * sin, z)
}

/// A direction in the shading frame: by the cosine, or uniform if light can come
/// from both sides.
fn sample_environment(receiver: &Receiver, u: [f64; 2]) -> Vec3 {
    match receiver.transmits {
        true => uniform_direction(u),
        false => sample_cosine(u),
    }
}

/// Density per solid angle of [`sample_environment`].
fn environment_pdf(receiver: &Receiver, local: Vec3) -> f64 {
    match receiver.transmits {
        true => 0.25 * FRAC_1_PI,
        false => cosine_pdf(local),
    }
}
