//! A cone as the kernels read it: in the tree's coordinates for the bounds, in those of
//! the test's precision for edges.

use std::f64::consts::PI;

use capwalk_geometry::edge::ON_PLANE;
use capwalk_geometry::{ConeQuery, EdgeSelection, LocalFrame};
use capwalk_math::Vec3;

use crate::layout::cone::*;
use crate::layout::margin::POSITION_MARGIN;
use crate::local_ray::round_up;
use crate::precision::Precision;

/// By how much single precision moves what edges are tested with, per unit of `|x| + |y| +
/// |z| + 3`, where these are the viewpoint's coordinates in the tree's frame: about its
/// distance from the tree's farthest point. A silhouette found there is one of some
/// viewpoint as near as that, and none is missed. Angles are off by this error over the
/// silhouette's distance. About 1e-6: ten roundings of positions, and as much again for
/// those of the test. For triangles, rays start where they enter the frame, and the error
/// is 4 of these.
pub const SINGLE_ERROR: f64 = 1.0 / (1 << 20) as f64;

/// A pseudo-angle that no point has: those go up to 2.
const NO_LIMIT: f64 = 3.0;

/// Limits of pseudo-angles are larger than what is asked for by this fraction; whether
/// an angle is below the limit is decided by the angle, afterwards.
const LIMIT_GROW: f64 = 1.0 + 8.0 * f64::EPSILON;

fn sum(v: Vec3) -> f64 {
    v.x.abs() + v.y.abs() + v.z.abs()
}

/// Writes what the kernels read of a cone.
pub fn write(
    frame: &LocalFrame,
    query: &ConeQuery,
    precision: Precision,
    view: &mut [u32],
    numbers: &mut [f64],
) {
    let apex = frame.local_from_world(query.apex);
    // Everything in the tree is nearer to the apex than this.
    let range = sum(apex) + 3.0;
    let margin = POSITION_MARGIN * range;
    let on_plane = ON_PLANE * (sum(query.apex) + frame.reach) * frame.inverse_scale;
    // What the test in single precision takes for the plane of a face.
    let single = match precision {
        Precision::Single => 2.0 * SINGLE_ERROR * range,
        Precision::Double => 0.0,
    };
    let limit = pseudo_limit(query.max_angle) * LIMIT_GROW;
    let mut put = |at: usize, v: Vec3, last: f64| {
        for (word, number) in view[at..].iter_mut().zip(v.to_array()) {
            *word = (number as f32).to_bits();
        }
        view[at + 3] = round_up(last).to_bits();
    };
    put(0, apex, margin);
    put(4, query.axis, margin + 2.0 * on_plane + single);
    view[8] = round_up(limit).to_bits();
    view[9] = u32::from(query.groups);
    view[10] = u32::from(query.edges == EdgeSelection::All);

    // A plane that hides nothing has no normal.
    let plane = query.in_front_of.map(|plane| (plane.point, plane.normal));
    let (point, normal) = plane.unwrap_or((query.apex, Vec3::zero()));
    let (vectors, tail) = match precision {
        Precision::Double => (
            [query.apex, query.axis, point, normal],
            [ON_PLANE, sum(query.apex), limit, f64::MAX],
        ),
        Precision::Single => {
            let unit = match normal == Vec3::zero() {
                true => normal,
                false => normal.normalized(),
            };
            let [apex, point] = [query.apex, point].map(|p| frame.local_from_world(p));
            let size = sum(apex) + on_plane / SINGLE_ERROR;
            let largest = f64::from(f32::MAX);
            (
                [apex, query.axis, point, unit],
                [SINGLE_ERROR, size, limit, largest],
            )
        }
    };
    let places = [CONE_APEX, CONE_AXIS, CONE_PLANE_POINT, CONE_PLANE_NORMAL];
    for (at, v) in places.into_iter().zip(vectors) {
        numbers[at..at + 3].copy_from_slice(&v.to_array());
    }
    let places = [CONE_ON_PLANE, CONE_SIZE, CONE_LIMIT, CONE_LARGEST];
    for (at, number) in places.into_iter().zip(tail) {
        numbers[at] = number;
    }
}

/// The pseudo-angle that is the limit of a half-angle: `ρ / (ρ + z)` in front of the
/// viewpoint, `1 + |z| / (ρ + |z|)` behind it. Negative if nothing lies within.
pub fn pseudo_limit(max_angle: f64) -> f64 {
    let is_open = max_angle > 0.0; // false for NaN
    if !is_open {
        return -1.0;
    }
    if max_angle >= PI {
        return NO_LIMIT;
    }
    let (sin, cos) = max_angle.sin_cos();
    let total = sin + cos.abs();
    match cos >= 0.0 {
        true => sin / total,
        false => 1.0 - cos / total,
    }
}
