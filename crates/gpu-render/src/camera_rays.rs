//! The camera's rays as the kernels read them.

use capwalk_geometry::LocalFrame;
use capwalk_render::Tracer;
use capwalk_render::tiles::SamplePlace;

use crate::texture_records::float;

/// By how much the box of the tree counts as larger, local units: more than rounding.
const WIDER: f64 = 1.0 / (1 << 20) as f64;

/// Rays without end are so long, local units.
const ENDLESS: f64 = 1e30;

/// Writes the ray of a sample into the first nine words: where it enters the tree, in local units, its direction, how long it
/// is (negative if it misses the tree), and the key of its random numbers. Returns its weight in
/// the pixel.
pub fn write_camera_ray(
    tracer: &Tracer,
    frame: &LocalFrame,
    place: &SamplePlace,
    words: &mut [u32],
) -> f64 {
    let (ray, weight) = tracer.camera_ray(place.pixel, &place.stream);
    let (origin, direction) = (
        frame.local_from_world(ray.origin).to_array(),
        ray.direction.to_array(),
    );
    let [mut enter, mut exit] = ray.range.map(|t| t * frame.inverse_scale);
    let until = exit;
    for axis in 0..3 {
        let (from, d, side) = (origin[axis], direction[axis], 1.0 + WIDER);
        if d != 0.0 {
            let side = side.copysign(d);
            enter = enter.max((-side - from) / d);
            exit = exit.min((side - from) / d);
        } else if from.abs() > side {
            exit = f64::NEG_INFINITY;
        }
    }
    let is_inside = enter <= exit; // false for NaN
    let start = [0, 1, 2].map(|axis| match is_inside {
        true => origin[axis] + direction[axis] * enter,
        false => 0.0,
    });
    let length = if is_inside {
        (until - enter).min(ENDLESS)
    } else {
        -1.0
    };
    let key = place.stream.independent_key().unwrap_or_default();
    let numbers = start
        .into_iter()
        .chain(direction)
        .chain([length])
        .map(float);
    let key = [key as u32, (key >> 32) as u32];
    for (word, value) in words.iter_mut().zip(numbers.chain(key)) {
        *word = value;
    }
    weight
}
