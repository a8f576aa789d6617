//! Surfaces that the camera's clip planes cut.
//!
//! Where a clip plane cuts a visible surface, the image is discontinuous along a curve that
//! is no edge of a mesh. Such scenes are refused.

use capwalk_math::Vec3;
use capwalk_scene::SensorModel;
use capwalk_scene::sensor::view::View;

use crate::accel::Accel;
use crate::refusal::Refusal;

/// A refusal if the near or the far plane cuts a face within the image.
pub fn refuse_clipped(accel: &Accel) -> Result<(), Refusal> {
    let planes = ["near_clip", "far_clip"].into_iter().zip(accel.view.clip());
    for face in 0..accel.mesh.faces.len() {
        let corners = accel.mesh.corners(face);
        for (name, depth) in planes.clone() {
            let Some(cut) = cut_at_depth(&accel.view, corners, depth) else {
                continue;
            };
            if (depth > 0.0 || accel.view.is_parallel()) && is_in_view(accel, cut, depth) {
                let shape = &accel.scene.shape(accel.shape_of_face[face]).id;
                return Err(Refusal::Clipped {
                    shape: shape.clone(),
                    plane: name,
                    depth,
                });
            }
        }
    }
    Ok(())
}

/// The segment in which a triangle meets the plane of a depth.
fn cut_at_depth(view: &View<f64>, corners: [Vec3; 3], depth: f64) -> Option<[Vec3; 2]> {
    let depths = corners.map(|p| view.depth(p));
    let mut points = Vec::with_capacity(2);
    for i in 0..3 {
        let k = (i + 1) % 3;
        if (depths[i] < depth) != (depths[k] < depth) {
            let t = (depth - depths[i]) / (depths[k] - depths[i]);
            points.push(corners[i] + (corners[k] - corners[i]) * t);
        }
    }
    match points[..] {
        [a, b] => Some([a, b]),
        _ => None,
    }
}

/// True if a segment at a depth crosses the rectangle of the film that pixels
/// gather light from, and something of it is seen.
fn is_in_view(accel: &Accel, segment: [Vec3; 2], depth: f64) -> bool {
    let (view, film) = (&accel.view, &accel.scene.film);
    let [a, b] = segment.map(|p| view.film(view.towards(p)));
    let mut margin = if film.sample_border {
        film.filter.radius()
    } else {
        0.0
    };
    let mut is_blurred = false;
    if let SensorModel::ThinLens {
        aperture_radius,
        focus_distance,
        ..
    } = accel.scene.sensor.model
    {
        let shift = (1.0 / focus_distance - 1.0 / depth).abs();
        margin += aperture_radius * shift / view.pixel_size();
        is_blurred = aperture_radius > 0.0;
    }
    // Liang and Barsky 1984: the part of the segment inside the rectangle.
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let low = f64::from(film.crop_offset[axis]) - margin;
        let high = f64::from(film.crop_offset[axis] + film.crop_size[axis]) + margin;
        let step = b[axis] - a[axis];
        let ends = [low, high].map(|side| (side - a[axis]) / step);
        if step == 0.0 {
            if a[axis] < low || a[axis] > high {
                return false;
            }
            continue;
        }
        first = first.max(ends[0].min(ends[1]));
        last = last.min(ends[0].max(ends[1]));
    }
    if first > last {
        return false;
    }
    // Before the near plane nothing can be in the way; around what hides a point
    // from the middle of a lens, other points of it may see.
    let [near, _] = view.clip();
    let sees = |t: f64| {
        let p = segment[0] + (segment[1] - segment[0]) * t;
        let direction = view.towards(p).normalized();
        let distance = (p - view.ray(direction).origin).length() * (1.0 - SHORT);
        depth <= near || is_blurred || accel.camera_sees(view.origin, direction, distance)
    };
    let place = |i: u32| first + (last - first) * (f64::from(i) / f64::from(SAMPLES));
    (0..=SAMPLES).map(place).any(sees)
}

/// At how many places along a cut it is looked for, between things before it.
const SAMPLES: u32 = 64;

/// Relative distance by which a point is taken before a clip plane.
const SHORT: f64 = 1e-9;
