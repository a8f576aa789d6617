//! Directions towards light: what a shading point samples, and with which
//! weight. Primal and derivative use the same samples; densities and weights
//! are never differentiated.

use capwalk_geometry::Hit;
use capwalk_math::{Frame, Vec3};
use capwalk_scene::{Diffuse, EmitterId};

use crate::accel::Accel;
use crate::sampler::Stream;

/// An unoccluded direction towards an emitter.
#[derive(Clone, Copy, Debug)]
pub struct LightSample {
    /// Unit direction from the shading point.
    pub direction: Vec3,
    /// The emitter seen there.
    pub emitter: EmitterId,
    /// Multiple-importance weight over density per solid angle, divided by the
    /// number of samples of the technique.
    pub weight: f64,
}

/// A direction drawn from a material, in which a path can go on.
#[derive(Clone, Copy, Debug)]
pub struct Continuation {
    /// Unit direction from the shading point.
    pub direction: Vec3,
    /// Its density per solid angle.
    pub pdf: f64,
    /// What it meets.
    pub hit: Option<Hit>,
}

/// How many samples of each technique a shading point takes.
#[derive(Clone, Copy, Debug)]
pub struct LightSampling {
    /// Points drawn on emitters.
    pub emitter_samples: u32,
    /// Directions drawn from the material.
    pub bsdf_samples: u32,
}

/// Random numbers that [`sample_emitter`] takes.
pub const EMITTER_NUMBERS: u32 = 3;
/// Random numbers of each material sample.
const BSDF_NUMBERS: u32 = 2;

impl LightSampling {
    /// Random numbers that [`sample_lights`] takes.
    pub fn dimensions(&self) -> u32 {
        self.emitter_samples * EMITTER_NUMBERS + self.bsdf_samples * BSDF_NUMBERS
    }
}

/// Draws directions towards light from a diffuse surface, by points on
/// emitters and by the material, combined with the power heuristic (Veach
/// 1997), and passes on those that reach an emitter, with the number of the
/// sample. Takes `sampling.dimensions()` numbers from `dimension` on. Gives back
/// the first direction drawn from the material.
pub fn sample_lights(
    accel: &Accel,
    position: Vec3,
    normal: Vec3,
    sampling: LightSampling,
    stream: &Stream,
    dimension: u32,
    mut shade: impl FnMut(u32, LightSample),
) -> Option<Continuation> {
    let frame = Frame::from_normal(normal);
    let counts = sampling;
    // Densities of all samples of each technique together.
    let of_emitters = |pdf: f64| f64::from(counts.emitter_samples) * pdf;
    let of_bsdf = |pdf: f64| f64::from(counts.bsdf_samples) * pdf;

    for i in 0..counts.emitter_samples {
        let base = dimension + i * EMITTER_NUMBERS;
        let Some((direction, emitter, pdf)) = sample_emitter(accel, position, &frame, stream, base)
        else {
            continue;
        };
        let (own, other) = (
            of_emitters(pdf),
            of_bsdf(Diffuse::pdf(direction.dot(normal))),
        );
        if own > 0.0 {
            let weight = power_heuristic(own, other) / own;
            shade(
                i,
                LightSample {
                    direction,
                    emitter,
                    weight,
                },
            );
        }
    }
    let mut next = None;
    for i in 0..counts.bsdf_samples {
        let base = dimension + counts.emitter_samples * EMITTER_NUMBERS + i * BSDF_NUMBERS;
        let local = Diffuse::sample(stream.pair(base));
        let direction = frame.to_world(local);
        let hit = accel.first_hit(position, direction);
        let pdf = Diffuse::pdf(local.z);
        if pdf > 0.0 {
            next = next.or(Some(Continuation {
                direction,
                pdf,
                hit,
            }));
        }
        let Some(emitter) = emitter_towards(accel, hit.as_ref(), direction) else {
            continue;
        };
        let own = of_bsdf(Diffuse::pdf(direction.dot(normal)));
        let other = of_emitters(emitter_pdf(accel, emitter, hit.as_ref(), direction, normal));
        if own > 0.0 {
            let weight = power_heuristic(own, other) / own;
            shade(
                counts.emitter_samples + i,
                LightSample {
                    direction,
                    emitter,
                    weight,
                },
            );
        }
    }
    next
}

/// Weight of a sample of density `own` that the density `other` could have
/// drawn too (Veach 1997, power heuristic with exponent 2).
#[inline]
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

/// Density per solid angle with which [`sample_emitter`] draws a direction in
/// which `emitter` is seen.
pub fn emitter_pdf(
    accel: &Accel,
    emitter: EmitterId,
    hit: Option<&Hit>,
    direction: Vec3,
    normal: Vec3,
) -> f64 {
    let chosen = 1.0 / accel.lamps.len() as f64;
    match (&accel.lamps[emitter.0 as usize], hit) {
        (Some(lamp), Some(hit)) => {
            let face_normal = accel.mesh.face_cross(hit.face as usize).normalized();
            chosen * lamp.solid_angle_pdf(hit.t, face_normal.dot(direction))
        }
        _ => chosen * Diffuse::pdf(direction.dot(normal)),
    }
}

/// Draws an emitter uniformly and a direction towards it: a uniform point of a
/// lamp, or a cosine-distributed direction to the environment. `None` if it is
/// occluded or seen from behind.
pub fn sample_emitter(
    accel: &Accel,
    position: Vec3,
    frame: &Frame,
    stream: &Stream,
    dimension: u32,
) -> Option<(Vec3, EmitterId, f64)> {
    let count = accel.lamps.len();
    if count == 0 {
        return None;
    }
    let index = ((stream.number(dimension) * count as f64) as usize).min(count - 1);
    let u = stream.pair(dimension + 1);
    let chosen = 1.0 / count as f64;
    let emitter = EmitterId(index as u32);
    let Some(lamp) = &accel.lamps[index] else {
        let local = Diffuse::sample(u);
        let direction = frame.to_world(local);
        let free = accel.first_hit(position, direction).is_none();
        return free.then(|| (direction, emitter, chosen * Diffuse::pdf(local.z)));
    };
    let point = lamp.sample(u);
    let offset = point.position - position;
    let distance = offset.length();
    let direction = offset / distance;
    let cos_l = -point.normal.dot(direction);
    let lit = cos_l > 0.0 && direction.dot(frame.n) > 0.0;
    (lit && accel.visible(position, point.position)).then(|| {
        (
            direction,
            emitter,
            chosen * lamp.solid_angle_pdf(distance, cos_l),
        )
    })
}
