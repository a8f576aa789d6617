//! The camera as the kernels read it: `layout.rs` says which word and which number is what.

use std::collections::BTreeMap;

use capwalk_boundary::Accel;
use capwalk_geometry::LocalFrame;
use capwalk_math::{Dual, Real, Vec3};
use capwalk_render::{SampleRange, Supports};
use capwalk_scene::Filter;
use capwalk_scene::sensor::view::View;
use capwalk_scene::sensor::{Optic, SensorState};

use crate::layout::camera::*;
use crate::layout::camera_numbers::SIDE_TABLES;
use crate::layout::filter::*;
use crate::layout::record;
use crate::layout::sample::*;
use crate::texture_records::float;

/// Nothing is seen farther than this, local units: single precision can represent it.
const ENDLESS: f64 = 1e30;

/// What is known of a camera.
pub struct CameraRecords {
    pub words: Vec<u32>,
    /// Numbers in the precision of exact tests.
    pub numbers: Vec<f64>,
}

impl CameraRecords {
    /// The camera of a scene, whose rays start in these coordinates.
    pub fn new(accel: &Accel, frame: &LocalFrame) -> Self {
        let (film, view) = (&accel.scene.film, &accel.view);
        let depth = depth_of_tree(accel, frame);
        let vectors = camera_vectors(accel, &accel.scene.sensor.state(), frame);
        let vectors = vectors.map(Vec3::to_array);
        let mut numbers = vectors.as_flattened().to_vec();
        let axis_point = view.axis_point();
        numbers.extend([0, 1].map(|i| axis_point[i] - f64::from(film.crop_offset[i]) - 0.5));
        let per_depth = match view.is_parallel() {
            true => 1.0 / view.axes()[2].length(),
            false => 1.0,
        };
        let clip = view.clip().map(|clip| clip * per_depth - depth);
        let clip = clip.map(|clip| (clip * frame.inverse_scale).clamp(-ENDLESS, ENDLESS));
        numbers.extend(clip);
        numbers.push(depth * frame.inverse_scale);
        debug_assert_eq!(numbers.len(), SIDE_TABLES);

        let [width, height] = film.crop_size;
        let (kind, [first, second]) = filter_words(&film.filter);
        let has_lens = accel.scene.sensor.model.has_lens();
        let head: [u32; SIDES] = record(&[
            (IMAGE_COLUMNS, width),
            (IMAGE_PIXELS, width * height),
            (FILTER, kind as u32),
            (FILTER_NUMBERS, first),
            (FILTER_NUMBERS + 1, second),
            (HAS_LENS, has_lens.into()),
        ]);
        let mut words = head.to_vec();
        // Sides with the same bounds around the pixel's centre have one table.
        let mut tables = BTreeMap::new();
        for table in Supports::new(film).tables() {
            let key = [table[0], table[1]].map(float);
            words.push(*tables.entry(key).or_insert_with(|| {
                let at = numbers.len() as u32;
                numbers.extend(table);
                at
            }));
        }
        Self { words, numbers }
    }
}

/// Derivatives of the vectors of a camera that moves.
pub fn camera_changes(
    accel: &Accel,
    state: &SensorState<Dual<1>>,
    frame: &LocalFrame,
) -> impl Iterator<Item = u32> {
    let vectors = camera_vectors(accel, state, frame).map(|vector| vector.tangent(0).to_array());
    vectors.into_iter().flatten().map(float)
}

/// The samples that paths begin with, as the kernels read them: the seed, and pixel and number of
/// the first one.
pub fn sample_words(samples: &SampleRange) -> [u32; SAMPLE_WORDS] {
    let seed = samples.sampler().independent_seed();
    let seed = seed.expect("other samplers are not supported");
    let [pixel, sample] = samples.pixel_and_sample(0);
    record(&[
        (SEED, seed as u32),
        (SEED + 1, (seed >> 32) as u32),
        (FIRST_PIXEL, pixel),
        (FIRST_NUMBER, sample),
    ])
}

/// The depth of the place where rays are written down: that of the tree's middle, if it is before
/// the camera. There they have all digits that single precision has.
fn depth_of_tree(accel: &Accel, frame: &LocalFrame) -> f64 {
    let depth = accel.view.place(frame.centre).z;
    match depth.is_finite() {
        true => depth.max(0.0),
        false => 0.0,
    }
}

/// The direction of a ray, as long as it takes to get to depth 1, and where it is at the depth of
/// the tree, in its coordinates: each is the first of five vectors, and the others times how far the
/// film point is from the view axis, pixels, and where the point of the lens is on the unit disk.
fn camera_vectors<R: Real>(
    accel: &Accel,
    state: &SensorState<R>,
    frame: &LocalFrame,
) -> [Vec3<R>; 10] {
    let (sensor, film) = (&accel.scene.sensor, &accel.scene.film);
    let view = View::new(sensor, film, state, [0.0; 2]);
    let depth = R::constant(depth_of_tree(accel, frame));
    let (zero, one) = (R::constant(0.0), R::constant(1.0));
    let [left, up, forward] = state.axes;
    let [to_left, to_up] = [left, up].map(|axis| axis * view.pixel_size());
    let [turning, moving] = match view.is_parallel() {
        true => [zero, one],
        false => [one, depth],
    };
    // A ray through another point of the lens meets the others in the plane in focus.
    let [lens_turning, lens_moving] = match sensor.model.has_lens() {
        true => {
            let radius = state.optics[Optic::ApertureRadius as usize];
            let per_depth = radius / state.optics[Optic::FocusDistance as usize];
            [zero - per_depth, radius - per_depth * depth]
        }
        false => [zero; 2],
    };
    let scale = R::constant(frame.inverse_scale);
    let from_centre = state.origin - Vec3::constant(frame.centre);
    let start = [
        from_centre + forward * depth,
        to_left * moving,
        to_up * moving,
        left * lens_moving,
        up * lens_moving,
    ];
    let [a, b, c, d, e] = start.map(|vector| vector * scale);
    let (to_left, to_up) = (to_left * turning, to_up * turning);
    let (lens_left, lens_up) = (left * lens_turning, up * lens_turning);
    [forward, to_left, to_up, lens_left, lens_up, a, b, c, d, e]
}

/// The kind of a filter, and two numbers of it.
fn filter_words(filter: &Filter) -> (usize, [u32; 2]) {
    let (kind, numbers) = match *filter {
        Filter::Box => (BOX_FILTER, [0.0; 2]),
        Filter::Tent { radius } => (TENT_FILTER, [1.0 / radius, 0.0]),
        Filter::Gaussian { stddev } => (GAUSSIAN_FILTER, [-0.5 / (stddev * stddev), 0.0]),
        Filter::Mitchell { b, c } => (MITCHELL_FILTER, [b, c]),
        Filter::Lanczos { lobes } => (LANCZOS_FILTER, [f64::from(lobes).recip(), 0.0]),
    };
    (kind, numbers.map(float))
}

#[cfg(test)]
mod tests {
    use capwalk_render::PreparedScene;
    use capwalk_scene::{SensorModel, Tangent, builtin};

    use super::*;

    const MODELS: [SensorModel; 3] = [
        SensorModel::Perspective {
            fov_x: 0.8,
            principal_point_offset: [0.1, -0.05],
        },
        SensorModel::ThinLens {
            fov_x: 0.7,
            aperture_radius: 0.2,
            focus_distance: 4.5,
        },
        SensorModel::Orthographic,
    ];

    /// Rays are those of the view from the same point of the lens, with their derivatives.
    #[test]
    fn vectors_give_the_rays_of_views() {
        for model in MODELS {
            let mut scene = builtin::scene("ball").expect("built in");
            scene.sensor.model = model;
            let prepared = PreparedScene::new(scene);
            let accel = prepared.accel();
            let (sensor, film) = (&accel.scene.sensor, &accel.scene.film);
            let mut tangent = Tangent::zero(&accel.scene).sensor;
            tangent.translation = Vec3::new(0.3, -0.2, 0.4);
            tangent.rotation = Vec3::new(-0.2, 0.4, 0.3);
            tangent.axes[1] = Vec3::new(0.2, 0.1, -0.3);
            tangent.optics = Vec3::new(0.05, 0.04, 0.3);
            let state = sensor.moving_state(&tangent);
            let frame = accel.rays().buffers().frame;
            let vectors = camera_vectors(accel, &state, &frame);
            let depth = depth_of_tree(accel, &frame) * frame.inverse_scale;
            assert!(depth > 0.1);
            let constant = Dual::<1>::constant;
            for (point, lens) in [([3.0, 50.5], [0.3, -0.8]), ([40.0, 7.25], [-0.5, 0.1])] {
                let view = View::new(sensor, film, &state, lens);
                let ray = view.ray(view.direction(point.map(constant)));
                let [x, y] = [0, 1].map(|i| constant(accel.view.axis_point()[i] - point[i]));
                let lens = lens.map(constant);
                let sum = |at: usize| {
                    let of_film = vectors[at] + vectors[at + 1] * x + vectors[at + 2] * y;
                    of_film + vectors[at + 3] * lens[0] + vectors[at + 4] * lens[1]
                };
                let (direction, start) = (sum(0), sum(5));
                let origin = ray.origin - Vec3::constant(frame.centre);
                let origin = origin * constant(frame.inverse_scale);
                for zero in [
                    direction.normalized() - ray.direction,
                    start - (origin + direction * constant(depth)),
                ] {
                    let [value, change] = [zero.value(), zero.tangent(0)].map(Vec3::length);
                    assert!(value < 1e-12 && change < 1e-12, "{model:?}: {zero:?}");
                }
            }
        }
    }
}
