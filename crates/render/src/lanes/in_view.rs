//! What the camera may see.

use capwalk_boundary::{Accel, may_be_specular};
use capwalk_math::Vec3;
use capwalk_scene::SensorModel;

/// A plane: a point of it, and a normal of any length.
type Plane = [Vec3; 2];

/// How far the nearest face that the camera may see is from it, at least, without those of spheres.
pub fn nearest_in_view(accel: &Accel) -> f64 {
    let eye = accel.view.origin;
    let frustum = frustum(accel);
    let faces = accel.rays().single_faces().into_iter();
    let distances = faces.map(|face| face as usize).filter_map(|face| {
        let corners = accel.mesh.corners(face);
        let part = frustum.iter().fold(corners.to_vec(), clipped);
        let low = part.iter().copied().reduce(Vec3::min)?;
        let high = part.iter().copied().reduce(Vec3::max)?;
        // To the box around it, or to its plane; not a number without area.
        let to_box = (eye - eye.max(low).min(high)).length();
        let normal = accel.mesh.face_cross(face).normalized();
        Some(to_box.max(normal.dot(corners[0] - eye).abs()))
    });
    distances.fold(f64::INFINITY, f64::min)
}

/// The corners of the part of a convex polygon on the side of a plane to which its normal points
/// (Sutherland and Hodgman 1974).
fn clipped(polygon: Vec<Vec3>, &[point, normal]: &Plane) -> Vec<Vec3> {
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

/// The planes of the view frustum, normals inwards; none if the camera may see things in mirrors, or
/// looks from more than one point.
fn frustum(accel: &Accel) -> Vec<Plane> {
    let (scene, view) = (&accel.scene, &accel.view);
    let mut shapes = scene.shapes.iter();
    let sees_directly = matches!(scene.sensor.model, SensorModel::Perspective { .. })
        && !shapes.any(|shape| may_be_specular(scene, shape.bsdf));
    if !sees_directly {
        return Vec::new();
    }
    let film = &scene.film;
    let reach = film.filter.radius();
    let low = film.crop_offset.map(|start| f64::from(start) - reach);
    let high = [0, 1].map(|axis| {
        let end = film.crop_offset[axis] + film.crop_size[axis];
        f64::from(end) + reach
    });
    let sides = view.side_planes(low, high);
    let sides = sides.into_iter().map(|normal| [view.origin, normal]);
    sides.chain([view.near_plane()]).collect()
}
