//! What the camera may see.

use capwalk_boundary::{Accel, may_be_specular};
use capwalk_math::Vec3;
use capwalk_scene::SensorModel;

/// A plane: a point of it, and a normal of any length.
type Plane = [Vec3; 2];

/// How far the nearest face that the camera may see is from it, at least.
pub fn nearest_in_view(accel: &Accel) -> f64 {
    let eye = accel.view.origin;
    let planes = planes_of_view(accel);
    let faces = (0..accel.mesh.faces.len()).map(|face| accel.mesh.corners(face));
    let parts = faces.map(|face| planes.iter().fold(face.to_vec(), before));
    let distances = parts.filter_map(|part| {
        let low = part.iter().copied().reduce(Vec3::min)?;
        let high = part.iter().copied().reduce(Vec3::max)?;
        // To the box around it.
        Some((eye - eye.max(low).min(high)).length())
    });
    distances.fold(f64::INFINITY, f64::min)
}

/// The corners of the part of a convex polygon that is before a plane.
fn before(polygon: Vec<Vec3>, &[point, normal]: &Plane) -> Vec<Vec3> {
    let height = |p: Vec3| normal.dot(p - point);
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (i, &start) in polygon.iter().enumerate() {
        let end = polygon[(i + 1) % polygon.len()];
        let (from, to) = (height(start), height(end));
        if from >= 0.0 {
            part.push(start);
        }
        if from * to < 0.0 {
            part.push(start + (end - start) * (from / (from - to)));
        }
    }
    part
}

/// Planes before which, in the direction of their normals, everything lies that the camera sees;
/// none if it may see things in mirrors, or looks from more than one point.
fn planes_of_view(accel: &Accel) -> Vec<Plane> {
    let (scene, view) = (&accel.scene, &accel.view);
    let mut shapes = scene.shapes.iter();
    let sees_directly = matches!(scene.sensor.model, SensorModel::Perspective { .. })
        && !shapes.any(|shape| may_be_specular(scene, shape.bsdf));
    if !sees_directly {
        return Vec::new();
    }
    let film = &scene.film;
    let reach = film.filter.radius();
    let ends = [0, 1].map(|axis| {
        let start = f64::from(film.crop_offset[axis]);
        [
            start - reach,
            start + f64::from(film.crop_size[axis]) + reach,
        ]
    });
    let [[left, right], [top, bottom]] = ends;
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
    let corners = corners.map(|corner| view.direction(corner));
    let sides = [0, 1, 2, 3].map(|i| {
        let normal = corners[i].cross(corners[(i + 1) % 4]);
        let inwards = normal.dot(corners[(i + 2) % 4]);
        [view.origin, normal * inwards.signum()]
    });
    sides.into_iter().chain([view.near_plane()]).collect()
}
