//! The camera's rays as the kernels read them.

use capwalk_boundary::Stream;
use capwalk_diff::Forward;
use capwalk_geometry::LocalFrame;
use capwalk_math::Vec3;
use capwalk_render::tiles::SamplePlace;
use capwalk_render::{Primal, Tracer};
use capwalk_scene::sensor::view::ViewRay;

use crate::texture_records::float;

/// By how much the box of the tree counts as larger, local units: more than rounding.
const WIDER: f64 = 1.0 / (1 << 20) as f64;

/// Rays without end are so long, local units.
const ENDLESS: f64 = 1e30;

/// A camera's ray in the tree's coordinates.
#[derive(Clone, Copy, Debug)]
pub struct CameraRay {
    /// Where it enters the tree, and its direction.
    start: Vec3,
    direction: Vec3,
    /// How far the start is from the origin.
    pub enter: f64,
    /// How long it is; negative if it misses the tree.
    length: f64,
}

impl CameraRay {
    /// That of a ray of the world.
    pub fn new(frame: &LocalFrame, ray: &ViewRay<f64>) -> Self {
        let (origin, direction) = (frame.local_from_world(ray.origin), ray.direction);
        let [mut enter, mut exit] = ray.range.map(|t| t * frame.inverse_scale);
        let until = exit;
        for (from, d) in origin.to_array().into_iter().zip(direction.to_array()) {
            let side = 1.0 + WIDER;
            if d != 0.0 {
                let side = side.copysign(d);
                enter = enter.max((-side - from) / d);
                exit = exit.min((side - from) / d);
            } else if from.abs() > side {
                exit = f64::NEG_INFINITY;
            }
        }
        let is_inside = enter <= exit; // false for NaN
        Self {
            start: match is_inside {
                true => origin + direction * enter,
                false => Vec3::zero(),
            },
            direction,
            enter: if is_inside { enter } else { 0.0 },
            length: match is_inside {
                true => (until - enter).min(ENDLESS),
                false => -1.0,
            },
        }
    }

    /// Writes it into the first nine words: start, direction, length, and the key of random numbers.
    pub fn write(&self, stream: &Stream, words: &mut [u32]) {
        let numbers = [self.start, self.direction].map(Vec3::to_array);
        let numbers = numbers.into_iter().flatten().chain([self.length]);
        let key = stream.independent_key().unwrap_or_default();
        let key = [key as u32, (key >> 32) as u32];
        for (word, value) in words.iter_mut().zip(numbers.map(float).chain(key)) {
            *word = value;
        }
    }
}

/// Writes the ray of a sample, see [`CameraRay::write`]. Returns its weight in the pixel.
pub fn write_camera_ray(
    tracer: &Tracer,
    frame: &LocalFrame,
    place: &SamplePlace,
    words: &mut [u32],
) -> f64 {
    let (ray, weight) = tracer.camera_ray(&Primal(tracer.accel), place.pixel, &place.stream);
    CameraRay::new(frame, &ray).write(&place.stream, words);
    weight
}

/// The same of a camera that moves, and behind it the derivatives of start and direction.
pub fn write_moving_ray(
    tracer: &Tracer,
    frame: &LocalFrame,
    eval: &Forward,
    place: &SamplePlace,
    words: &mut [u32],
) -> f64 {
    let (moving, weight) = tracer.camera_ray(eval, place.pixel, &place.stream);
    let ray = CameraRay::new(frame, &moving.value());
    ray.write(&place.stream, words);
    let change = moving.direction.tangent(0);
    // The start stays at its distance from the origin.
    let of_start = moving.origin.tangent(0) * frame.inverse_scale + change * ray.enter;
    let changes = [of_start, change].map(Vec3::to_array);
    for (word, change) in words[9..].iter_mut().zip(changes.as_flattened()) {
        *word = float(*change);
    }
    weight
}
