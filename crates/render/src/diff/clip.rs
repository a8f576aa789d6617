//! Surfaces that the camera's clip planes cut.
//!
//! Where a clip plane cuts a surface in view, the picture jumps along a curve
//! that no edge carries. Such scenes are refused.

use capwalk_math::Vec3;

use crate::accel::Accel;
use crate::options::Refusal;

/// A refusal if the near or the far plane cuts a face within the picture.
pub fn refuse_clipped(accel: &Accel) -> Result<(), Refusal> {
    let sensor = &accel.scene.sensor;
    let planes = [
        ("near_clip", sensor.near_clip),
        ("far_clip", sensor.far_clip),
    ];
    for face in 0..accel.mesh.faces.len() {
        let corners = accel.mesh.corners(face).map(|p| in_camera(accel, p));
        for (name, depth) in planes {
            let Some(cut) = cut_at_depth(corners, depth) else {
                continue;
            };
            if depth > 0.0 && is_in_view(accel, cut) {
                let shape = &accel.scene.shape(accel.shape_of_face[face]).id;
                return Err(Refusal {
                    reason: format!(
                        "the camera's {name} of {depth} cuts through the shape \"{shape}\" within \
                         the picture, and the derivative of what is cut off there is not \
                         available. Choose another {name}, or move the camera"
                    ),
                });
            }
        }
    }
    Ok(())
}

/// A point in camera space.
fn in_camera(accel: &Accel, p: Vec3) -> Vec3 {
    let camera = &accel.scene.sensor.world_from_camera;
    let offset = p - camera.translation;
    let [a, b, c] = camera.rows;
    a * offset.x + b * offset.y + c * offset.z
}

/// The segment in which a triangle meets the plane of a depth.
fn cut_at_depth(corners: [Vec3; 3], depth: f64) -> Option<[Vec3; 2]> {
    let mut points = Vec::with_capacity(2);
    for i in 0..3 {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        if (a.z < depth) != (b.z < depth) {
            points.push(a + (b - a) * ((depth - a.z) / (b.z - a.z)));
        }
    }
    match points[..] {
        [a, b] => Some([a, b]),
        _ => None,
    }
}

/// True if a segment in camera space, all at one depth, crosses the rectangle
/// of the film that pixels gather light from, and something of it is seen.
fn is_in_view(accel: &Accel, segment: [Vec3; 2]) -> bool {
    let (sensor, film) = (&accel.scene.sensor, &accel.scene.film);
    let [a, b] = segment.map(|p| sensor.film_from_camera(film, p));
    let reach = if film.sample_border {
        film.filter.radius()
    } else {
        0.0
    };
    // Liang and Barsky 1984: the part of the segment inside the rectangle.
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let low = f64::from(film.crop_offset[axis]) - reach;
        let high = f64::from(film.crop_offset[axis] + film.crop_size[axis]) + reach;
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
    // Just before the plane: at the near plane nothing can be in the way.
    let sees = |t: f64| {
        let p = segment[0] + (segment[1] - segment[0]) * t;
        let distance = p.length();
        let direction = sensor.world_from_camera.vector(p / distance);
        p.z <= sensor.near_clip * (1.0 + SHORT)
            || accel.camera_sees(direction, distance * (1.0 - SHORT))
    };
    [first, 0.5 * (first + last), last].into_iter().any(sees)
}

/// Relative distance by which a point is taken before a clip plane.
const SHORT: f64 = 1e-9;
